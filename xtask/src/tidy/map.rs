//! The map in `docs/architecture.md`: it names exactly the packages that exist.

use std::collections::BTreeMap;

use super::Finding;
use crate::workspace::Workspace;

/// Checks the rows of the page's tables that start with a package's name and a layer (`-` for a
/// tool), and every other `clench-...` that the page names.
pub(super) fn check(workspace: &Workspace, (path, text): (&str, &str)) -> Vec<Finding> {
    let mut findings = Vec::new();
    let mut seen = BTreeMap::new();
    for (line, name, layer) in rows(text) {
        let expected = layer_of(workspace, name);
        if let Some(first) = seen.insert(name, line) {
            let what = format!("`{name}` has a row in line {first} already");
            findings.push(Finding::new(path, line, what, "keep one of the two"));
        } else if expected.as_deref() != Some(layer) {
            let what = match expected {
                Some(expected) => format!("`{name}` is in layer {expected}, not in {layer}"),
                None => format!("there is no package `{name}`"),
            };
            let mend = "correct the row after [workspace.metadata] of the root manifest";
            findings.push(Finding::new(path, line, what, mend));
        }
    }
    for package in &workspace.packages {
        if !seen.contains_key(&*package.name) {
            let what = format!("package `{}` has no row", package.name);
            findings.push(Finding::new(path, 1, what, "add it to the table of crates"));
        }
    }
    for (line, name) in names_in_text(text) {
        if !workspace.has(name) && !seen.contains_key(name) {
            let what = format!("there is no package `{name}`");
            findings.push(Finding::new(path, line, what, "name one that exists"));
        }
    }
    findings
}

/// The layer as the page writes it, if the package exists.
fn layer_of(workspace: &Workspace, name: &str) -> Option<String> {
    let tool = workspace.tables.tools.get(name).map(|_| "-".to_owned());
    workspace.tables.layers.get(name).map(ToString::to_string).or(tool)
}

/// Line, name and layer of each table row whose first cell is one quoted name and whose second
/// is a number or `-`.
fn rows(text: &str) -> impl Iterator<Item = (usize, &str, &str)> {
    text.lines().enumerate().filter_map(|(index, line)| {
        let mut cells = line.strip_prefix('|')?.split('|').map(str::trim);
        let name = cells.next()?.strip_prefix('`')?.strip_suffix('`')?;
        let layer = cells.next()?;
        let is_layer = layer == "-" || layer.parse::<u32>().is_ok();
        is_layer.then_some((index + 1, name, layer))
    })
}

/// Line and name of each quoted `clench-...`.
fn names_in_text(text: &str) -> impl Iterator<Item = (usize, &str)> {
    text.lines().enumerate().flat_map(|(index, line)| {
        let quoted = line.split('`').skip(1).step_by(2);
        quoted.filter(|name| name.starts_with("clench-")).map(move |name| (index + 1, name))
    })
}

#[cfg(test)]
mod tests {
    use super::check;
    use crate::workspace::Workspace;
    use crate::workspace::tests::SOUND;

    const PAGE: &str = "\
# Map

| crate | layer | holds |
| --- | --- | --- |
| `low` | 0 | this |
| `high` | 1 | that |
| `program` | 2 | both |
| `kit` | - | tests |

| `sigma` | F/L | another table |
";

    fn whats(page: &str) -> Vec<(usize, String)> {
        let workspace = Workspace::parse(SOUND).unwrap();
        let findings = check(&workspace, ("docs/architecture.md", page));
        findings.into_iter().map(|finding| (finding.line, finding.what)).collect()
    }

    #[test]
    fn a_page_with_every_package_in_its_layer_has_no_finding() {
        assert_eq!(whats(PAGE), []);
    }

    #[test]
    fn a_package_without_a_row_is_found() {
        let page = PAGE.replace("| `kit` | - | tests |\n", "");
        assert_eq!(whats(&page), [(1, "package `kit` has no row".to_owned())]);
    }

    #[test]
    fn a_row_of_a_package_long_gone_is_found() {
        let page = PAGE.replace("| `kit` |", "| `ghost` | 1 | gone |\n| `kit` |");
        assert_eq!(whats(&page), [(8, "there is no package `ghost`".to_owned())]);
    }

    #[test]
    fn a_wrong_layer_is_found() {
        let page = PAGE.replace("| `high` | 1 |", "| `high` | 2 |");
        assert_eq!(whats(&page), [(6, "`high` is in layer 1, not in 2".to_owned())]);
    }

    #[test]
    fn a_second_row_of_a_package_is_found() {
        let page = PAGE.replace("| `kit` |", "| `low` | 0 | again |\n| `kit` |");
        assert_eq!(whats(&page), [(8, "`low` has a row in line 5 already".to_owned())]);
    }

    #[test]
    fn a_package_named_in_the_text_must_exist() {
        let page = format!("{PAGE}\nSee `clench-ghost` and `ghost`.\n");
        assert_eq!(whats(&page), [(12, "there is no package `clench-ghost`".to_owned())]);
    }
}
