//! Functions with equal bodies in two files: a helper that wants one home.

use std::collections::BTreeMap;

use super::Finding;
use super::code::Function;

/// Shorter bodies may be equal by chance.
const BODY_LINES: usize = 4;

/// Takes every function with the path of its file, sorted by path.
pub(super) fn check(functions: &[(&str, Function)]) -> Vec<Finding> {
    let mut first: BTreeMap<&str, (&str, &Function)> = BTreeMap::new();
    let mut findings = Vec::new();
    for (path, function) in functions.iter().filter(|(_, f)| f.body_lines >= BODY_LINES) {
        let (home, original) = *first.entry(&function.body).or_insert((path, function));
        if home != *path {
            let what = format!(
                "`{}` repeats the body of `{}` ({home}:{})",
                function.name, original.name, original.line
            );
            let mend = "keep one: in the lower layer, or for tests in the testkit";
            findings.push(Finding::new(path, function.line, what, mend));
        }
    }
    findings
}

#[cfg(test)]
mod tests {
    use super::super::code::Facts;
    use super::{Function, check};

    const LONG: &str = "fn long(x: f64) {\n    a(x);\n    b(x);\n    c(x);\n    d(x);\n}\n";

    fn whats(files: &[(&'static str, String)]) -> Vec<String> {
        let functions: Vec<(&str, Function)> = files
            .iter()
            .flat_map(|(path, text)| {
                Facts::read(text).unwrap().functions.into_iter().map(move |body| (*path, body))
            })
            .collect();
        check(&functions).into_iter().map(|finding| finding.what).collect()
    }

    #[test]
    fn an_equal_body_in_another_file_is_found_under_another_name_and_other_spaces() {
        let other = LONG.replace("long", "other").replace("(x)", "( x )");
        assert_eq!(
            whats(&[("a.rs", LONG.to_owned()), ("b.rs", other)]),
            ["`other` repeats the body of `long` (a.rs:1)"]
        );
    }

    #[test]
    fn an_equal_body_in_the_same_file_is_not_found() {
        assert_eq!(whats(&[("a.rs", format!("{LONG}{LONG}"))]), [""; 0]);
    }

    #[test]
    fn a_short_body_and_a_different_one_are_not_found() {
        let short = LONG.replace("    d(x);\n", "");
        assert_eq!(whats(&[("a.rs", short.clone()), ("b.rs", short)]), [""; 0]);
        assert_eq!(whats(&[("a.rs", LONG.to_owned()), ("b.rs", LONG.replace('d', "e"))]), [""; 0]);
    }
}
