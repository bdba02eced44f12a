//! Asserts that two numbers, or two lists of them, agree to a relative tolerance.

use std::fmt::Display;

/// Asserts `|actual - expected| <= tolerance * scale`.
///
/// # Panics
///
/// When they differ by more, with both numbers and `what`.
#[track_caller]
pub fn assert_close(actual: f64, expected: f64, tolerance: f64, scale: f64, what: impl Display) {
    let error = (actual - expected).abs();
    assert!(
        error <= tolerance * scale,
        "{what}: {actual:?} is not {expected:?}; they differ by {:.1e} of {scale:e}, \
         allowed {tolerance:.1e}",
        error / scale
    );
}

/// Asserts that two lists agree entry by entry to `tolerance` times the largest expected entry.
///
/// # Panics
///
/// When the lengths differ, or an entry does.
#[track_caller]
pub fn assert_all_close(actual: &[f64], expected: &[f64], tolerance: f64, what: impl Display) {
    assert_eq!(actual.len(), expected.len(), "{what}: number of entries");
    let scale = expected.iter().fold(f64::MIN_POSITIVE, |m, x| m.max(x.abs()));
    for (i, (a, e)) in actual.iter().zip(expected).enumerate() {
        assert_close(*a, *e, tolerance, scale, format_args!("{what}[{i}]"));
    }
}
