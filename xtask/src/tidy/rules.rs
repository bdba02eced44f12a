//! The rules about what stands in a Rust file.

use super::Finding;
use super::code::Facts;
use super::tree::Source;

/// The longest function, from `fn` to the closing brace.
const FUNCTION_LINES: usize = 80;

/// Long functions, nameless tolerances, hopes in library code, open re-exports.
///
/// `libraries` are the folders of library code, each with a `/` at its end.
pub(super) fn check(source: &Source, facts: &Facts, libraries: &[String]) -> Vec<Finding> {
    let path = source.path.as_str();
    let mut findings = Vec::new();
    for function in facts.functions.iter().filter(|function| function.lines > FUNCTION_LINES) {
        let what =
            format!("`{}` has {} lines: more than {FUNCTION_LINES}", function.name, function.lines);
        let mend = "give the steps of the function names of their own";
        findings.push(Finding::new(path, function.line, what, mend));
    }
    if !is_for_measuring(path) {
        for (line, text) in &facts.small_numbers {
            let what = format!("`{text}` is a tolerance without a name");
            let mend = "make it a `const` whose documentation derives it and names its unit";
            findings.push(Finding::new(path, *line, what, mend));
        }
    }
    if libraries.iter().any(|folder| path.starts_with(folder.as_str())) && !is_for_measuring(path) {
        for (line, text) in &facts.hopes {
            let what = format!("`{text}` in library code");
            let mend = "return an error; where an invariant holds, `expect` says which";
            findings.push(Finding::new(path, *line, what, mend));
        }
    }
    for line in &facts.open_reexports {
        let what = "`pub use ...::*` hides what is public";
        findings.push(Finding::new(path, *line, what, "name what is exported"));
    }
    findings
}

/// Whether the file is a test, a measurement or a chore, where a number stands for itself.
fn is_for_measuring(path: &str) -> bool {
    path.starts_with("xtask/")
        || path.split('/').any(|part| matches!(part, "tests" | "benches" | "tests.rs"))
}

#[cfg(test)]
mod tests {
    use super::{Facts, Source, check};

    const TROUBLE: &str = "pub use a::*;\nfn f() {\n    g(1e-9).unwrap()\n}\n";

    fn whats(path: &str, text: &str) -> Vec<(usize, String)> {
        let source = Source { path: path.to_owned(), text: text.to_owned() };
        let facts = Facts::read(text).unwrap();
        let findings = check(&source, &facts, &["crates/low/src/".to_owned()]);
        findings.into_iter().map(|finding| (finding.line, finding.what)).collect()
    }

    fn tolerance() -> (usize, String) {
        (3, "`1e-9` is a tolerance without a name".to_owned())
    }

    fn reexport() -> (usize, String) {
        (1, "`pub use ...::*` hides what is public".to_owned())
    }

    #[test]
    fn library_code_keeps_every_rule() {
        let hope = (3, "`.unwrap()` in library code".to_owned());
        assert_eq!(whats("crates/low/src/a.rs", TROUBLE), [tolerance(), hope, reexport()]);
    }

    #[test]
    fn a_tool_may_unwrap_and_may_not_hide_its_tolerances() {
        assert_eq!(whats("crates/kit/src/lib.rs", TROUBLE), [tolerance(), reexport()]);
    }

    #[test]
    fn tests_benches_and_chores_may_state_numbers() {
        let files = ["crates/low/tests/laws.rs", "crates/low/src/a/tests.rs", "benches/src/lib.rs"];
        for path in files.into_iter().chain(["xtask/src/main.rs"]) {
            assert_eq!(whats(path, TROUBLE), [reexport()], "{path}");
        }
    }

    #[test]
    fn a_function_of_81_lines_is_found_and_one_of_80_is_not() {
        let function = |lines: usize| format!("fn f() {{\n{}}}\n", "    g();\n".repeat(lines - 2));
        assert_eq!(whats("xtask/src/a.rs", &function(80)), []);
        let what = "`f` has 81 lines: more than 80".to_owned();
        assert_eq!(whats("xtask/src/a.rs", &function(81)), [(1, what)]);
    }
}
