//! What a report was made from, so that it can be made again.

use std::path::PathBuf;

use maud::{Markup, html};

/// A file as it was read.
#[derive(Clone, Debug)]
pub(crate) struct Source {
    /// How reports call it.
    pub(crate) name: String,
    pub(crate) text: String,
}

/// What a command was given.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Inputs<'a> {
    pub(crate) texts: &'a [Source],
    /// Files that were read besides, such as meshes.
    pub(crate) others: &'a [PathBuf],
}

impl Inputs<'_> {
    /// The command line and the files, word for word.
    pub(super) fn section(self) -> Markup {
        let arguments = std::env::args_os().skip(1).map(|word| word.to_string_lossy().into_owned());
        html! {
            p { "Made by clench " (env!("CARGO_PKG_VERSION")) ". To make it again:" }
            pre { (command_line(arguments)) }
            @for Source { name, text } in self.texts {
                details open {
                    summary { (name) }
                    pre { (text) }
                }
            }
            @if !self.others.is_empty() {
                p { "Read besides, and needed again:" }
                ul { @for other in self.others { li { code { (other.display()) } } } }
            }
        }
    }
}

/// The command as one would type it.
fn command_line(arguments: impl Iterator<Item = String>) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_./:,=+@".contains(c);
    let quoted = |argument: String| {
        if !argument.is_empty() && argument.chars().all(plain) {
            return argument;
        }
        format!("'{}'", argument.replace('\'', r"'\''"))
    };
    let words = arguments.map(quoted);
    std::iter::once("clench".to_owned()).chain(words).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::command_line;

    #[test]
    fn a_command_line_can_be_typed_again() {
        let words = ["analyze", "my part.toml", "--frame", "1,2,0.5", "it's", ""];
        let line = command_line(words.into_iter().map(str::to_owned));
        assert_eq!(line, r"clench analyze 'my part.toml' --frame 1,2,0.5 'it'\''s' ''");
    }
}
