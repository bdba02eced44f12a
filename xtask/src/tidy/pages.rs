//! Pages of the repository: their links lead somewhere, the changelog has its open section.

use super::Finding;
use super::tree::Source;

/// The section of the changelog that takes what is not released yet.
const OPEN_SECTION: &str = "## Unreleased";

/// The changelog has its open section.
pub(super) fn check_changelog((path, text): (&str, &str)) -> Vec<Finding> {
    if text.lines().any(|line| line == OPEN_SECTION) {
        return Vec::new();
    }
    let what = format!("no section `{OPEN_SECTION}`");
    vec![Finding::new(path, 1, what, "add the section and say there what changed for the user")]
}

/// Every link to a file of the repository leads to one; `exists` takes a path from the root.
pub(super) fn check_links(page: &Source, exists: impl Fn(&str) -> bool) -> Vec<Finding> {
    let mut findings = Vec::new();
    for (line, target) in links(&page.text) {
        let path = resolve(&page.path, target);
        if !path.as_deref().is_some_and(&exists) {
            let what = format!("the link to `{target}` leads nowhere");
            let mend = "name a file of the repository, from the folder of the page";
            findings.push(Finding::new(&page.path, line, what, mend));
        }
    }
    findings
}

/// Line and target of each link to a file, outside code; without the part after `#`.
fn links(text: &str) -> Vec<(usize, &str)> {
    let mut found = Vec::new();
    let mut in_code = false;
    for (index, line) in text.lines().enumerate() {
        if line.trim_start().starts_with("```") {
            in_code = !in_code;
        } else if !in_code {
            found.extend(targets(line).filter_map(to_file).map(|target| (index + 1, target)));
        }
    }
    found
}

/// What `[text](target)` and `[name]: target` point to, outside quoted code.
fn targets(line: &str) -> impl Iterator<Item = &str> {
    let prose = line.split('`').step_by(2);
    let inline = prose
        .flat_map(|part| part.split("](").skip(1))
        .map(|rest| rest.split(')').next().unwrap_or_default());
    let named = line.strip_prefix('[').and_then(|rest| rest.split_once("]: "));
    inline.chain(named.map(|(_, target)| target))
}

/// The file of a target; nothing for an address on the web or a place in the same page.
fn to_file(target: &str) -> Option<&str> {
    let target = target.split_whitespace().next()?.split('#').next()?;
    (!target.is_empty() && !target.contains(':')).then_some(target)
}

/// The path from the root of a target in a page; nothing when it leaves the repository.
fn resolve(page: &str, target: &str) -> Option<String> {
    let mut parts: Vec<&str> = page.split('/').collect();
    parts.pop();
    if target.starts_with('/') {
        parts.clear();
    }
    for part in target.split('/') {
        match part {
            "" | "." => {}
            ".." => {
                parts.pop()?;
            }
            name => parts.push(name),
        }
    }
    Some(parts.join("/"))
}

#[cfg(test)]
mod tests {
    use super::{Source, check_changelog, check_links};

    /// What is said of a page in `docs/` of a repository with two files.
    fn whats(text: &str) -> Vec<(usize, String)> {
        let page = Source { path: "docs/page.md".to_owned(), text: text.to_owned() };
        let findings = check_links(&page, |path| ["README.md", "docs/a.md"].contains(&path));
        findings.into_iter().map(|finding| (finding.line, finding.what)).collect()
    }

    #[test]
    fn links_to_files_that_exist_are_not_found() {
        let text = "[a](a.md), (not [a link]) [`up`](../README.md) and [root](/docs/a.md#part)\n\
            [b][b]\n\n[b]: ./a.md \"title\"\n";
        assert_eq!(whats(text), []);
    }

    #[test]
    fn links_to_other_places_are_not_followed() {
        assert_eq!(whats("[web](https://example.org/x.md) [here](#part) [m](mailto:a@b)"), []);
    }

    #[test]
    fn links_in_code_are_not_followed() {
        assert_eq!(whats("`[x](gone.md)`\n```\n[y](gone.md)\n```\n"), []);
    }

    #[test]
    fn a_link_that_leads_nowhere_is_found() {
        let found = |line, target| (line, format!("the link to `{target}` leads nowhere"));
        assert_eq!(whats("see\n[a](a.md) [b](gone.md)\n"), [found(2, "gone.md")]);
        assert_eq!(whats("```\n```\n[b]: ../gone.md\n"), [found(3, "../gone.md")]);
        assert_eq!(whats("[out](../../README.md)"), [found(1, "../../README.md")]);
        assert_eq!(whats("[`code`](README.md)"), [found(1, "README.md")]);
    }

    #[test]
    fn a_changelog_without_its_open_section_is_found() {
        assert_eq!(check_changelog(("CHANGELOG.md", "# Changelog\n\n## Unreleased\n")), []);
        for text in ["", "# Changelog\n\n## 0.1.0\n", "the section `## Unreleased`\n"] {
            assert_eq!(check_changelog(("CHANGELOG.md", text)).len(), 1, "{text}");
        }
    }
}
