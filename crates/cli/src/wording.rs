//! Numbers in words, for messages and reports alike.

/// Numbers with these powers of ten are written without a power.
const PLAIN_POWERS: std::ops::Range<i32> = -4..7;

/// The squares of larger numbers are infinite.
const FARTHEST: f64 = 1e154;

/// More characters of a text than this are not quoted.
const LONGEST_TEXT: usize = 40;

/// `value` with six significant digits; JSON has all of them.
pub(crate) fn digits(value: f64) -> String {
    significant(value, 6)
}

/// `value` with nine significant digits: preloads that are typed from a report with these still
/// balance.
pub(crate) fn precise_digits(value: f64) -> String {
    significant(value, 9)
}

/// A number of things, such as `1 corner` or `2 corners`.
pub(crate) fn counted(count: usize, thing: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {thing}{plural}")
}

/// `value` with two significant digits, for shares that only have to be small.
pub(crate) fn rough_digits(value: f64) -> String {
    significant(value, 2)
}

/// A distance with its unit. One whose square is out of range is known to be larger than this.
pub(crate) fn distance(value: f64, unit: &str) -> String {
    let (more, value) = if value.is_finite() { ("", value) } else { ("more than ", FARTHEST) };
    format!("{more}{} {unit}", digits(value))
}

/// As much of a text of a file as a message quotes.
pub(crate) fn quoted(text: &str) -> String {
    match text.char_indices().nth(LONGEST_TEXT) {
        Some((end, _)) => format!("`{}…`", text[..end].escape_debug()),
        None => format!("`{}`", text.escape_debug()),
    }
}

/// A layer of a drawing by its name, if it has one.
pub(crate) fn layer_name(layer: &str) -> String {
    if layer.is_empty() { "no layer".to_owned() } else { format!("layer {}", quoted(layer)) }
}

fn significant(value: f64, count: u8) -> String {
    if value.abs() <= 0.0 {
        return "0".to_owned();
    }
    let further = i32::from(count) - 1;
    let scientific = format!("{value:.0$e}", usize::from(count) - 1);
    let Some((mantissa, power)) = scientific.split_once('e') else { return scientific };
    let power: i32 = power.parse().unwrap_or(0);
    if PLAIN_POWERS.contains(&power) {
        let decimals = usize::try_from(further - power).unwrap_or(0);
        return trimmed(&format!("{value:.decimals$}")).to_owned();
    }
    format!("{}e{power}", trimmed(mantissa))
}

fn trimmed(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}
