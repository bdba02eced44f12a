//! What can be seen of a Rust file without reading its code: first line and lengths.

use super::Finding;
use super::tree::Source;

/// The longest file, in lines. Above it a file holds more than one idea.
const FILE_LINES: usize = 600;
/// The longest line, in characters: the `max_width` of rustfmt, which leaves long text alone.
const LINE_CHARACTERS: usize = 100;

/// First line, length of the file, length of each line.
pub(super) fn check(source: &Source) -> Vec<Finding> {
    let Source { path, text } = source;
    let mut findings = Vec::new();
    if !text.starts_with("//! ") {
        let what = "the file does not start with a `//!` line";
        findings.push(Finding::new(path, 1, what, "say in one line what the file is for"));
    }
    let lines = text.lines().count();
    if lines > FILE_LINES {
        let what = format!("{lines} lines: more than {FILE_LINES}");
        findings.push(Finding::new(path, FILE_LINES + 1, what, "split it by idea"));
    }
    for (index, line) in text.lines().enumerate() {
        let characters = line.chars().count();
        if characters > LINE_CHARACTERS {
            let what = format!("{characters} characters: more than {LINE_CHARACTERS}");
            findings.push(Finding::new(path, index + 1, what, "break the line"));
        }
    }
    findings
}

#[cfg(test)]
mod tests {
    use super::{Source, check};

    fn whats(text: String) -> Vec<(usize, String)> {
        let findings = check(&Source { path: "src/lib.rs".to_owned(), text });
        findings.into_iter().map(|finding| (finding.line, finding.what)).collect()
    }

    #[test]
    fn a_file_at_every_limit_has_no_finding() {
        let wide = format!("//{}\n", "-".repeat(98));
        assert_eq!(whats(format!("//! Says.\n{}", wide.repeat(599))), []);
    }

    #[test]
    fn a_file_that_does_not_say_what_it_is_for_is_found() {
        let what = "the file does not start with a `//!` line".to_owned();
        assert_eq!(whats("use std::fmt;\n//! Late.\n".to_owned()), [(1, what)]);
    }

    #[test]
    fn a_file_one_line_too_long_is_found() {
        let found = whats(format!("//! Says.\n{}", "\n".repeat(600)));
        assert_eq!(found, [(601, "601 lines: more than 600".to_owned())]);
    }

    #[test]
    fn a_line_one_character_too_long_is_found_and_letters_count_not_bytes() {
        let (wide, too_wide) = ("µ".repeat(98), "µ".repeat(99));
        let found = whats(format!("//! Says.\n//{wide}\n//{too_wide}\n"));
        assert_eq!(found, [(3, "101 characters: more than 100".to_owned())]);
    }
}
