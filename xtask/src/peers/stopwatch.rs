//! Times: how long a call takes, and how that is printed.

use std::time::Instant;

/// The answer of a call and the median of the seconds it took, over an odd number of `runs`.
pub(super) fn median_of<T, E>(
    runs: usize,
    mut call: impl FnMut() -> Result<T, E>,
) -> Result<(T, f64), E> {
    let mut seconds = Vec::with_capacity(runs);
    loop {
        let start = Instant::now();
        let answer = call()?;
        seconds.push(start.elapsed().as_secs_f64());
        if seconds.len() >= runs {
            return Ok((answer, median(&mut seconds)));
        }
    }
}

/// The middle one of the numbers, the upper one of two; 0 of none.
pub(super) fn median(numbers: &mut [f64]) -> f64 {
    numbers.sort_by(f64::total_cmp);
    numbers.get(numbers.len() / 2).copied().unwrap_or_default()
}

/// A time with three digits or so, in the unit that suits it.
pub(super) fn shown(seconds: f64) -> String {
    let (value, unit) = match seconds {
        s if s < 1e-3 => (s * 1e6, "µs"),
        s if s < 1.0 => (s * 1e3, "ms"),
        s => (s, "s"),
    };
    let decimals = match value {
        v if v < 10.0 => 2,
        v if v < 100.0 => 1,
        _ => 0,
    };
    format!("{value:.decimals$} {unit}")
}

#[cfg(test)]
mod tests {
    use super::{median, median_of, shown};

    #[test]
    fn a_time_is_shown_in_the_unit_that_suits_it() {
        let times = [4.321e-6, 5.06e-5, 0.0123, 0.4, 2.5, 130.0];
        let texts = ["4.32 µs", "50.6 µs", "12.3 ms", "400 ms", "2.50 s", "130 s"];
        assert_eq!(times.map(shown), texts);
    }

    #[test]
    fn the_median_is_the_middle_one_in_order_of_size() {
        assert!((median(&mut [3.0, 1.0, 2.0]) - 2.0).abs() < f64::EPSILON);
        assert!(median(&mut []).abs() < f64::EPSILON);
    }

    #[test]
    fn a_call_is_made_as_often_as_asked_and_its_error_ends_it() {
        let mut calls = 0;
        let mut call = |limit: usize| {
            calls += 1;
            if calls <= limit { Ok(calls) } else { Err(calls) }
        };
        assert_eq!(median_of(3, || call(5)).map(|(answer, _)| answer), Ok(3));
        assert_eq!(median_of(3, || call(5)).map(|(answer, _)| answer), Err(6));
    }
}
