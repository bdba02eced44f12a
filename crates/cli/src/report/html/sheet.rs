//! The page as a whole: what all reports have.

use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::inputs::Inputs;
use super::typeset::typeset;
use super::viewer;
use crate::report::page::Page;

const STYLE: &str = include_str!("style.css");

/// Nothing is asked of any host, whatever a file has slipped into the page.
const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'";

/// How good the news is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Tone {
    Good,
    Fair,
    Bad,
}

/// What is said first.
#[derive(Debug)]
pub(super) struct Headline {
    /// Such as the quality.
    pub(super) text: String,
    /// What that is worth, in a word or a few.
    pub(super) badges: Vec<(Tone, String)>,
}

/// A part of the page under a heading.
#[derive(Debug)]
pub(super) struct Section {
    pub(super) heading: &'static str,
    pub(super) content: Markup,
}

/// A page.
#[derive(Debug)]
pub(super) struct Sheet<'a> {
    /// The name of the file.
    pub(super) title: &'a str,
    pub(super) units: String,
    pub(super) headline: Option<Headline>,
    pub(super) warnings: Vec<String>,
    pub(super) facts: Page,
    pub(super) sections: Vec<Section>,
    /// What the view of a solid shows, as JSON.
    pub(super) scene: Option<String>,
    pub(super) inputs: Inputs<'a>,
}

impl Tone {
    const fn class(self) -> &'static str {
        match self {
            Self::Good => "good",
            Self::Fair => "fair",
            Self::Bad => "bad",
        }
    }
}

impl Section {
    /// The section, if there is anything in it.
    pub(super) fn filled(heading: &'static str, content: Markup) -> Option<Self> {
        (!content.0.is_empty()).then_some(Self { heading, content })
    }
}

impl Sheet<'_> {
    /// The whole page.
    pub(super) fn document(&self) -> String {
        let policy = if self.scene.is_some() { viewer::POLICY } else { POLICY };
        let markup = html! {
            (DOCTYPE)
            html lang="en" {
                head {
                    meta charset="utf-8";
                    meta http-equiv="Content-Security-Policy" content=(policy);
                    meta name="viewport" content="width=device-width, initial-scale=1";
                    meta name="generator" content=(concat!("clench ", env!("CARGO_PKG_VERSION")));
                    title { (self.title) " - clench" }
                    style { (PreEscaped(STYLE)) }
                }
                body {
                    (self.head())
                    @for Section { heading, content } in &self.sections {
                        section { h2 { (heading) } (content) }
                    }
                    section { h2 { "Inputs" } (self.inputs.section()) }
                    @if let Some(scene) = &self.scene { (viewer::scripts(scene)) }
                }
            }
        };
        markup.into_string()
    }

    fn head(&self) -> Markup {
        html! {
            header {
                h1 { (self.title) }
                p.units { (self.units) }
            }
            @if let Some(Headline { text, badges }) = &self.headline {
                p.headline {
                    (typeset(text))
                    @for (tone, badge) in badges {
                        " " span.badge.(tone.class()) { (typeset(badge)) }
                    }
                }
            }
            @if !self.warnings.is_empty() {
                div.warnings { @for warning in &self.warnings { p { (typeset(warning)) } } }
            }
            (self.facts)
        }
    }
}
