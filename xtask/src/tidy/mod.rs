//! `cargo xtask tidy`: the rules of the repository that no compiler checks. Also a test.

mod code;
mod layers;
mod map;
mod pages;
mod repeats;
mod rules;
mod text;
mod tree;

use std::fmt;

use crate::failure::Failure;
use crate::workspace::Workspace;
use tree::Tree;

/// One place that breaks a rule.
#[derive(Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Finding {
    path: String,
    line: usize,
    what: String,
    mend: &'static str,
}

impl Finding {
    fn new(path: &str, line: usize, what: impl Into<String>, mend: &'static str) -> Self {
        Self { path: path.to_owned(), line, what: what.into(), mend }
    }
}

impl fmt::Display for Finding {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{}:{}: {}\n  mend: {}", self.path, self.line, self.what, self.mend)
    }
}

/// Prints every finding; fails when there is one.
pub(crate) fn run() -> Result<(), Failure> {
    let workspace = Workspace::load()?;
    let tree = Tree::read()?;
    let findings = findings(&workspace, &tree);
    for finding in &findings {
        println!("{finding}");
    }
    if findings.is_empty() {
        println!("tidy: {} Rust files, {} pages: no findings", tree.rust.len(), tree.pages.len());
        return Ok(());
    }
    Err(Failure::Untidy { count: findings.len() })
}

fn findings(workspace: &Workspace, tree: &Tree) -> Vec<Finding> {
    let mut findings = layers::check(workspace, &tree.manifests);
    findings.extend(map::check(workspace, tree.page("docs/architecture.md")));
    findings.extend(pages::check_changelog(tree.page("CHANGELOG.md")));
    for page in &tree.pages {
        findings.extend(pages::check_links(page, tree::exists));
    }
    let libraries = layers::folders(workspace);
    let mut functions = Vec::new();
    for source in &tree.rust {
        findings.extend(text::check(source));
        match code::Facts::read(&source.text) {
            Ok(facts) => {
                findings.extend(rules::check(source, &facts, &libraries));
                functions.extend(facts.functions.into_iter().map(|body| (&*source.path, body)));
            }
            Err(line) => findings.push(Finding::new(
                &source.path,
                line,
                "this is not Rust: a bracket or a quote is left open",
                "make the file compile",
            )),
        }
    }
    findings.extend(repeats::check(&functions));
    findings.sort();
    findings
}

#[cfg(test)]
mod tests {
    use super::{Finding, Tree, Workspace, findings};

    #[test]
    fn this_repository_is_tidy() {
        let workspace = Workspace::load().unwrap();
        let tree = Tree::read().unwrap();
        assert!(tree.rust.len() > workspace.packages.len(), "too few files: was the tree found?");
        let findings: Vec<_> = findings(&workspace, &tree).iter().map(Finding::to_string).collect();
        assert!(findings.is_empty(), "{}", findings.join("\n"));
    }

    #[test]
    fn a_finding_is_printed_with_its_place_and_its_mend() {
        let finding = Finding::new("docs/a.md", 7, "a link leads nowhere", "name a file");
        assert_eq!(finding.to_string(), "docs/a.md:7: a link leads nowhere\n  mend: name a file");
    }
}
