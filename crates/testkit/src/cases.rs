//! Reference cases: JSON files in `cases/`, made by an independent program (see `cases/README.md`).

use std::fs;
use std::path::PathBuf;

pub use serde_json::Value;

/// The cases whose file name starts with `prefix`, with their names, in order of name.
///
/// # Panics
///
/// When there are none, or one cannot be read: a runner that runs nothing has failed.
#[must_use]
pub fn matching(prefix: &str) -> Vec<(String, Value)> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("cases");
    let mut names: Vec<String> = fs::read_dir(&folder)
        .unwrap_or_else(|e| panic!("{}: {e}", folder.display()))
        .map(|entry| entry.expect("folder entry").file_name().to_string_lossy().into_owned())
        .filter(|name| name.starts_with(prefix))
        .collect();
    names.sort();
    assert!(!names.is_empty(), "no case file starts with {prefix}");
    names
        .into_iter()
        .map(|name| {
            let text = fs::read_to_string(folder.join(&name)).expect("case file is readable");
            let value = serde_json::from_str(&text).unwrap_or_else(|e| panic!("{name}: {e}"));
            (name, value)
        })
        .collect()
}

/// A list of objects, such as the contacts of a case.
///
/// # Panics
///
/// When `value` is not a list.
#[must_use]
pub fn list(value: &Value) -> &[Value] {
    value.as_array().unwrap_or_else(|| panic!("expected a list, found {value}"))
}

/// A number; infinities are written as the strings "inf" and "-inf".
///
/// # Panics
///
/// When `value` is no number.
#[must_use]
pub fn number(value: &Value) -> f64 {
    match value.as_str() {
        Some("inf") => f64::INFINITY,
        Some("-inf") => f64::NEG_INFINITY,
        _ => value.as_f64().unwrap_or_else(|| panic!("expected a number, found {value}")),
    }
}

/// All numbers in `value`, a number or a list of lists of any depth, in order.
#[must_use]
pub fn numbers(value: &Value) -> Vec<f64> {
    match value.as_array() {
        Some(items) => items.iter().flat_map(numbers).collect(),
        None => vec![number(value)],
    }
}

/// `N` numbers.
///
/// # Panics
///
/// When there are more or fewer.
#[must_use]
pub fn array<const N: usize>(value: &Value) -> [f64; N] {
    let found = numbers(value);
    found.try_into().unwrap_or_else(|f: Vec<f64>| panic!("expected {N} numbers, found {f:?}"))
}

/// `R` rows of `C` numbers.
#[must_use]
pub fn rows<const R: usize, const C: usize>(value: &Value) -> [[f64; C]; R] {
    std::array::from_fn(|i| array(&value[i]))
}
