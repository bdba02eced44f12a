//! Layers: the tables of the root manifest against what the packages depend on.

use std::collections::BTreeSet;

use super::Finding;
use super::tree::Source;
use crate::workspace::{Dependency, Package, Workspace};

/// The path of the root manifest, which holds the tables.
const ROOT_MANIFEST: &str = "Cargo.toml";
/// What follows the name of an entry in a manifest.
const ENTRY: &[&str] = &[" =", "="];
/// What follows the name of a dependency.
const DEPENDENCY: &[&str] = &[" =", "=", "."];
/// What follows the name of a package in the table of third parties.
const LIST: &[&str] = &[" = [", "=["];

/// The source folder of each layered package, where the rules for library code hold.
pub(super) fn folders(workspace: &Workspace) -> Vec<String> {
    workspace
        .packages
        .iter()
        .filter(|package| workspace.tables.layers.contains_key(&package.name))
        .map(|package| workspace.manifest_path(package).replace("Cargo.toml", "src/"))
        .collect()
}

/// Every package has one place, arrows point down, third parties are those of the table.
pub(super) fn check(workspace: &Workspace, manifests: &[Source]) -> Vec<Finding> {
    let mut findings = Vec::new();
    check_tables(workspace, manifests, &mut findings);
    for package in &workspace.packages {
        let path = workspace.manifest_path(package);
        check_place(workspace, package, path, &mut findings);
        let Some(layer) = workspace.tables.layers.get(&package.name) else {
            continue;
        };
        for dependency in package.dependencies.iter().filter(|dependency| dependency.ships()) {
            let line = line_of(manifests, path, &dependency.name, DEPENDENCY);
            if let Some((what, mend)) = wrong_arrow(workspace, package, *layer, dependency) {
                findings.push(Finding::new(path, line, what, mend));
            }
        }
    }
    findings
}

/// A package stands in exactly one table.
fn check_place(workspace: &Workspace, package: &Package, path: &str, out: &mut Vec<Finding>) {
    let (name, tables) = (&package.name, &workspace.tables);
    let what = match (tables.layers.contains_key(name), tables.tools.contains_key(name)) {
        (true, false) | (false, true) => return,
        (false, false) => format!("package `{name}` has no layer"),
        (true, true) => format!("package `{name}` is a layer and a tool"),
    };
    let mend = "name it in one of [workspace.metadata.layers] and .tools of the root manifest";
    out.push(Finding::new(path, 1, what, mend));
}

/// What is wrong with a dependency that ships, and how to mend it.
fn wrong_arrow(
    workspace: &Workspace,
    package: &Package,
    layer: u32,
    dependency: &Dependency,
) -> Option<(String, &'static str)> {
    let (from, to, tables) = (&package.name, &dependency.name, &workspace.tables);
    if tables.tools.contains_key(to) {
        return Some((
            format!("`{from}` depends on the tool `{to}`"),
            "make it a dev-dependency, or move what is needed into a layer below",
        ));
    }
    if let Some(below) = tables.layers.get(to) {
        return (*below >= layer).then(|| {
            (
                format!("`{from}` (layer {layer}) depends on `{to}` (layer {below})"),
                "move what is needed to a layer below both: arrows point to smaller numbers only",
            )
        });
    }
    let allowed = tables.third_parties.get(from);
    let listed = allowed.is_some_and(|names| names.contains(to) || names.contains("*"));
    (!listed && !workspace.has(to)).then(|| {
        (
            format!("`{from}` depends on `{to}`, which its list of third parties does not name"),
            "do without, or add it to [workspace.metadata.third-parties] and say why in \
             docs/design.md",
        )
    })
}

/// The tables name only what exists: packages of the workspace, third parties in use.
fn check_tables(workspace: &Workspace, manifests: &[Source], out: &mut Vec<Finding>) {
    let tables = &workspace.tables;
    let named: BTreeSet<&String> = tables
        .layers
        .keys()
        .chain(tables.tools.keys())
        .chain(tables.third_parties.keys())
        .collect();
    let mut report = |name: &str, endings: &[&str], what: String| {
        let line = line_of(manifests, ROOT_MANIFEST, name, endings);
        out.push(Finding::new(ROOT_MANIFEST, line, what, "take it out of the table"));
    };
    for name in named {
        if !workspace.has(name) {
            let what = format!("[workspace.metadata] names `{name}`, which does not exist");
            report(name, ENTRY, what);
        }
    }
    for package in &workspace.packages {
        let used = |name: &String| {
            package.dependencies.iter().any(|other| other.ships() && other.name == *name)
        };
        for party in tables.third_parties.get(&package.name).into_iter().flatten() {
            if party != "*" && !used(party) {
                let what = format!("`{}` may use `{party}` and does not", package.name);
                report(&package.name, LIST, what);
            }
        }
    }
}

/// The first line of a manifest that starts with a name and one of the endings; 1 without one.
fn line_of(manifests: &[Source], path: &str, name: &str, endings: &[&str]) -> usize {
    let text = manifests.iter().find(|source| source.path == path).map_or("", |s| &*s.text);
    let starts = |line: &str| {
        let rest = line.strip_prefix(name);
        rest.is_some_and(|rest| endings.iter().any(|ending| rest.starts_with(ending)))
    };
    text.lines().position(starts).map_or(1, |index| index + 1)
}

#[cfg(test)]
mod tests {
    use super::{Source, check, folders};
    use crate::workspace::Workspace;
    use crate::workspace::tests::SOUND;

    /// What the check says of the sound workspace after a replacement that must apply.
    fn whats(from: &str, to: &str) -> Vec<String> {
        assert!(SOUND.contains(from), "nothing to replace: {from}");
        let workspace = Workspace::parse(&SOUND.replacen(from, to, 1)).unwrap();
        check(&workspace, &[]).into_iter().map(|finding| finding.what).collect()
    }

    #[test]
    fn a_workspace_that_keeps_the_rules_has_no_finding() {
        assert_eq!(whats("low", "low"), [""; 0]);
    }

    #[test]
    fn an_arrow_up_is_found() {
        let up = r#"{ "name": "high", "kind": null }, { "name": "robust", "kind": null }"#;
        assert_eq!(
            whats(r#"{ "name": "robust", "kind": null }"#, up),
            ["`low` (layer 0) depends on `high` (layer 1)"]
        );
    }

    #[test]
    fn an_arrow_sideways_is_found() {
        assert_eq!(
            whats(r#""high": 1"#, r#""high": 0"#),
            ["`high` (layer 0) depends on `low` (layer 0)"]
        );
    }

    #[test]
    fn a_tool_may_not_ship_with_a_layer_not_even_in_its_build() {
        let expected = ["`low` depends on the tool `kit`"];
        assert_eq!(whats(r#""kit", "kind": "dev""#, r#""kit", "kind": null"#), expected);
        assert_eq!(whats(r#""kit", "kind": "dev""#, r#""kit", "kind": "build""#), expected);
    }

    #[test]
    fn a_third_party_off_the_list_is_found_and_one_for_tests_is_not() {
        assert_eq!(
            whats(r#""proptest", "kind": "dev""#, r#""proptest", "kind": null"#),
            ["`high` depends on `proptest`, which its list of third parties does not name"]
        );
    }

    #[test]
    fn a_listed_third_party_that_is_not_used_is_found() {
        assert_eq!(
            whats(r#"["robust"]"#, r#"["robust", "rayon"]"#),
            ["`low` may use `rayon` and does not"]
        );
    }

    #[test]
    fn a_package_without_a_place_is_found() {
        assert_eq!(whats(r#", "program": 2"#, ""), ["package `program` has no layer"]);
    }

    #[test]
    fn a_package_in_both_tables_is_found() {
        let both = r#""tools": { "program": "no", "#;
        assert_eq!(whats(r#""tools": { "#, both), ["package `program` is a layer and a tool"]);
    }

    #[test]
    fn a_table_that_names_a_package_long_gone_is_found() {
        assert_eq!(
            whats(r#""low": 0"#, r#""low": 0, "ghost": 0"#),
            ["[workspace.metadata] names `ghost`, which does not exist"]
        );
    }

    #[test]
    fn a_finding_stands_at_the_line_of_the_dependency() {
        let json = SOUND.replace(r#""high": 1"#, r#""high": 0"#);
        let manifest = Source {
            path: "crates/high/Cargo.toml".to_owned(),
            text: "[dependencies]\nlower = \"1\"\nlow.workspace = true\n".to_owned(),
        };
        assert_eq!(check(&Workspace::parse(&json).unwrap(), &[manifest])[0].line, 3);
    }

    #[test]
    fn a_finding_about_third_parties_stands_at_their_line() {
        let json = SOUND.replace(r#"["robust"]"#, r#"["robust", "rayon"]"#);
        let manifest = Source {
            path: "Cargo.toml".to_owned(),
            text: "[x.layers]\nlow = 0\n[x.third-parties]\nlow = [\"robust\", \"rayon\"]\n"
                .to_owned(),
        };
        assert_eq!(check(&Workspace::parse(&json).unwrap(), &[manifest])[0].line, 4);
    }

    #[test]
    fn the_folders_of_library_code_are_those_of_the_layers() {
        let workspace = Workspace::parse(SOUND).unwrap();
        assert_eq!(
            folders(&workspace),
            ["crates/low/src/", "crates/high/src/", "crates/program/src/"]
        );
    }
}
