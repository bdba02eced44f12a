//! Symbols as they are printed: with Greek letters, indices and powers.

use maud::{Markup, PreEscaped, Render, html};

/// Symbols of text reports, their letter and their index.
const SYMBOLS: [(&str, &str, &str); 10] = [
    ("sigma", "σ", ""),
    ("sigma_min", "σ", "min"),
    ("sigma_max", "σ", "max"),
    ("mu", "μ", ""),
    ("mu_min", "μ", "min"),
    ("mu_max", "μ", "max"),
    ("mu_eq", "μ", "eq"),
    ("Q_pt", "Q", "pt"),
    ("Q_V", "Q", "V"),
    ("Q", "Q", ""),
];

/// The text, escaped, with its symbols and powers as they are printed.
pub(super) fn typeset(text: &str) -> Markup {
    let mut set = String::new();
    let mut rest = text;
    while !rest.is_empty() {
        let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let word = rest.find(|c| !is_word(c)).unwrap_or(rest.len());
        if word == 0 {
            let between = rest.find(is_word).unwrap_or(rest.len());
            let power = raised(&rest[between..]).filter(|_| rest[..between].ends_with('^'));
            let shown = if power.is_some() { between - 1 } else { between };
            rest[..shown].render_to(&mut set);
            rest = &rest[between..];
            if let Some(digits) = power {
                html!(sup { (digits) }).render_to(&mut set);
                rest = &rest[digits.len()..];
            }
            continue;
        }
        symbol(&rest[..word]).render_to(&mut set);
        rest = &rest[word..];
    }
    PreEscaped(set)
}

/// The digits that a text starts with.
fn raised(text: &str) -> Option<&str> {
    let end = text.find(|c: char| !c.is_ascii_digit()).unwrap_or(text.len());
    (end > 0).then(|| &text[..end])
}

fn symbol(word: &str) -> Markup {
    let Some((_, letter, index)) = SYMBOLS.iter().find(|(name, ..)| *name == word) else {
        return html!((word));
    };
    html!(i { (letter) } @if !index.is_empty() { sub { (index) } })
}

#[cfg(test)]
mod tests {
    use super::typeset;

    #[test]
    fn symbols_get_their_letters_and_indices_and_powers_are_raised() {
        let set = typeset("sigma_min / reach^2 in N/mm^2, not sigma_minor or ^a: Q").into_string();
        assert_eq!(
            set,
            "<i>σ</i><sub>min</sub> / reach<sup>2</sup> in N/mm<sup>2</sup>, not sigma_minor or \
             ^a: <i>Q</i>"
        );
    }

    #[test]
    fn what_a_browser_would_take_for_markup_is_text() {
        let set = typeset("<b>mu^2</b> & \"x\"").into_string();
        assert_eq!(set, "&lt;b&gt;<i>μ</i><sup>2</sup>&lt;/b&gt; &amp; &quot;x&quot;");
    }
}
