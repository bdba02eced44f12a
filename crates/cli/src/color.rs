//! Colors of words that say good or bad, for terminals alone.

use std::env;
use std::io::IsTerminal;

use clap::ValueEnum;

const GREEN: &str = "\u{1b}[32m";
const RED: &str = "\u{1b}[1;31m";
const PLAIN: &str = "\u{1b}[0m";

/// When to write in color.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ColorArgument {
    /// On terminals, unless the environment has `NO_COLOR`.
    Auto,
    /// Always, in files and pipes too.
    Always,
    /// Never.
    Never,
}

/// What words are written with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Paint {
    /// As they are.
    Plain,
    /// With the codes that a terminal takes for colors.
    Colored,
}

impl ColorArgument {
    /// What `stream` is written with.
    pub(crate) fn paint(self, stream: &impl IsTerminal) -> Paint {
        // By the convention of that name, an empty value is none.
        let wanted = || env::var_os("NO_COLOR").is_none_or(|value| value.is_empty());
        let colored = match self {
            Self::Always => true,
            Self::Never => false,
            Self::Auto => stream.is_terminal() && wanted(),
        };
        if colored { Paint::Colored } else { Paint::Plain }
    }
}

impl Paint {
    /// What is as it should be.
    pub(crate) fn good(self, text: &str) -> String {
        self.with(GREEN, text)
    }

    /// What is not.
    pub(crate) fn bad(self, text: &str) -> String {
        self.with(RED, text)
    }

    fn with(self, color: &str, text: &str) -> String {
        match self {
            Self::Plain => text.to_owned(),
            Self::Colored => format!("{color}{text}{PLAIN}"),
        }
    }
}
