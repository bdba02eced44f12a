//! Numbers as text: fixed decimals for pages, few digits for readers.

/// A page coordinate with at most two decimals, never `-0`.
pub(crate) fn number(value: f64) -> String {
    trimmed(format!("{value:.2}"))
}

/// A value as a reader wants it: three significant digits, powers of ten beyond 1e-3 and 1e4.
pub(crate) fn readable(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 {
        return "0".to_owned();
    }
    let text = if (1e-3..1e4).contains(&size) {
        // The leading digit stands at this power of ten; three digits end two places below it.
        let lead = size.log10().floor();
        let decimals = (0..6).rev().find(|&d| f64::from(d) + lead <= 2.0).unwrap_or(0);
        trimmed(format!("{value:.*}", usize::try_from(decimals).unwrap_or(0)))
    } else {
        let text = format!("{value:.2e}");
        match text.split_once('e') {
            Some((mantissa, power)) => {
                format!("{}·10^{{{}}}", trimmed(mantissa.to_owned()), with_minus(power))
            }
            None => text,
        }
    };
    with_minus(&text)
}

/// The typographic minus sign, as wide as a plus.
fn with_minus(text: &str) -> String {
    text.replace('-', "\u{2212}")
}

fn trimmed(text: String) -> String {
    if !text.contains('.') {
        return text;
    }
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn page_numbers_have_two_decimals_and_no_negative_zero() {
        let shown = [1.0, -0.001, 0.005, 12.345, -7.5, 100.0].map(number);
        assert_eq!(shown, ["1", "0", "0.01", "12.35", "-7.5", "100"]);
    }

    #[test]
    fn readers_get_three_digits_at_any_size() {
        let shown = [0.0, 1.0, 13.146, 0.15214, -1.093, 1234.6, 2.5e-7, -31_400.0].map(readable);
        let expected = ["0", "1", "13.1", "0.152", "−1.09", "1235", "2.5·10^{−7}", "−3.14·10^{4}"];
        assert_eq!(shown, expected);
    }
}
