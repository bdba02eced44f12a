//! The view of a solid that turns, with a still picture for print and where it cannot be had.

use maud::{Markup, PreEscaped, html};

use crate::picture::Figures;

/// What draws the scene: see `assets/README.md`.
const LIBRARY: &str = include_str!("../../../assets/three.min.js");

/// What makes the scene.
const VIEWER: &str = include_str!("viewer.js");

/// The directions to look from that have buttons.
const VIEWS: [(&str, &str); 4] =
    [("first", "As at first"), ("front", "Front"), ("right", "Right"), ("top", "Top")];

/// What a page with a view may run: these scripts and no others, by their SHA-256.
pub(super) const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'; script-src \
    'sha256-lKfWBFBwm4qZ6ENoqOOvFZhEcstx33ozVcUjs3tyDGQ=' \
    'sha256-rODxVVSOoCHWDBpSCnmz56fDCzj3vsfKFPYboAF1iGU='";

/// The part with its fingers: a picture, and a view that takes its place if there is a scene.
/// `cases` are the names of the load cases that the view can show.
pub(super) fn figure(figures: &Figures, cases: &[String], caption: &Markup) -> Markup {
    if figures.scene.is_none() {
        return html!(figure { (PreEscaped(&figures.grasp)) figcaption { (caption) } });
    }
    html! {
        figure #solid {
            div.still { (PreEscaped(&figures.grasp)) }
            div.turning {
                div.stage {
                    canvas tabindex="0" role="img"
                        aria-label="The part with its fingers; arrow keys turn it" {}
                    div.names aria-hidden="true" {}
                }
                div.controls {
                    @for (view, name) in VIEWS {
                        button type="button" data-view=(view) { (name) }
                    }
                    @if !cases.is_empty() { (choices(cases)) }
                }
                p.hint {
                    "Drag to turn, scroll or pinch to zoom, drag with the right button or two \
                     fingers to move. Keys: arrows, + and -, 0."
                }
            }
            figcaption { (caption) }
        }
    }
}

/// Which load case is shown.
fn choices(cases: &[String]) -> Markup {
    html! {
        fieldset {
            legend { "Show" }
            label { input type="radio" name="shown" value="rest" checked; " at rest" }
            @for (i, case) in cases.iter().enumerate() {
                label { input type="radio" name="shown" value=(i); " " (case) }
            }
        }
    }
}

/// What the view needs at the end of the page.
pub(super) fn scripts(scene: &str) -> Markup {
    html! {
        script #scene type="application/json" { (PreEscaped(scene)) }
        script { (PreEscaped(LIBRARY)) }
        script { (PreEscaped(VIEWER)) }
    }
}

#[cfg(test)]
mod tests {
    use super::{LIBRARY, POLICY, VIEWER};
    use sha2::{Digest, Sha256};

    fn base64(bytes: &[u8]) -> String {
        let digits = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        let mut text = String::new();
        for chunk in bytes.chunks(3) {
            let whole = chunk.iter().fold(0, |whole, &byte| whole << 8 | u32::from(byte));
            let whole = whole << (8 * (3 - chunk.len()));
            for i in 0..4 {
                let digit = digits[(whole >> (18 - 6 * i) & 63) as usize];
                text.push(if i > chunk.len() { '=' } else { char::from(digit) });
            }
        }
        text
    }

    #[test]
    fn the_policy_names_the_hashes_of_the_scripts() {
        for (name, script) in [("three.min.js", LIBRARY), ("viewer.js", VIEWER)] {
            let hash = format!("'sha256-{}'", base64(&Sha256::digest(script)));
            assert!(POLICY.contains(&hash), "{name} has the hash {hash}");
        }
    }

    #[test]
    fn no_script_ends_early_or_asks_a_host() {
        for script in [LIBRARY, VIEWER] {
            let script = script.to_ascii_lowercase();
            assert!(!script.contains("</script") && !script.contains("<!--"));
            let rest = script.replace("http://www.w3.org/1999/xhtml", "");
            assert!(!rest.contains("http:") && !rest.contains("https:"));
        }
    }
}
