//! Round values to write along an axis.

use crate::world_map::UNSEEN;

/// Zero and one or two round values on either side of it, within this distance, ascending.
pub(crate) fn ticks(reach: f64) -> Vec<f64> {
    let power = 10.0_f64.powf(reach.log10().floor());
    let step = match reach / power {
        // The logarithm of a power of ten may be rounded up.
        lead if lead < 1.0 => 0.5 * power,
        lead if lead < 2.0 => power,
        lead if lead < 5.0 => 2.0 * power,
        _ => 5.0 * power,
    };
    (-2..=2).map(|i| f64::from(i) * step).filter(|tick| tick.abs() <= reach).collect()
}

/// The steps of round values: each is a few times the one before.
const STEPS: [f64; 5] = [1.0, 2.0, 5.0, 10.0, 20.0];

/// The most steps that a range is divided into.
const MOST_STEPS: f64 = 5.0;

/// A few round values between two others, ascending; a round end is one of them.
pub(crate) fn round_values(low: f64, high: f64) -> Vec<f64> {
    let least = (high - low) / MOST_STEPS;
    let power = 10.0_f64.powf(least.log10().floor());
    let lead = STEPS.into_iter().find(|&step| step * power >= (1.0 - UNSEEN) * least);
    let Some(step) = lead.map(|lead| lead * power).filter(|step| step.is_normal()) else {
        // Too small to be divided.
        return vec![low, high];
    };
    // Quotients of round numbers may be rounded to either side of whole ones.
    let (first, last) = ((low / step - UNSEEN).ceil(), (high / step + UNSEEN).floor());
    let mut values = Vec::new();
    for i in 0..=STEPS.len() {
        let value = (first + i as f64) * step;
        if first + i as f64 <= last && values.last().is_none_or(|&before| value > before) {
            values.push(value.clamp(low, high));
        }
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::readable;

    #[test]
    fn ticks_are_round_few_and_within_reach() {
        let shown = |reach: f64| ticks(reach).into_iter().map(readable).collect::<Vec<_>>();
        assert_eq!(shown(0.147), ["−0.1", "0", "0.1"]);
        assert_eq!(shown(4.7), ["−4", "−2", "0", "2", "4"]);
        assert_eq!(shown(9e6), ["−5·10^{6}", "0", "5·10^{6}"]);
    }

    #[test]
    fn round_values_fill_a_range_and_take_its_round_ends() {
        let shown =
            |low, high| -> Vec<_> { round_values(low, high).into_iter().map(readable).collect() };
        assert_eq!(shown(0.0, 2.0), ["0", "0.5", "1", "1.5", "2"]);
        assert_eq!(shown(0.0, 0.3), ["0", "0.1", "0.2", "0.3"]);
        assert_eq!(shown(-0.31, 0.69), ["−0.2", "0", "0.2", "0.4", "0.6"]);
        assert_eq!(
            shown(1e-300, 6e-300),
            [
                "1·10^{−300}",
                "2·10^{−300}",
                "3·10^{−300}",
                "4·10^{−300}",
                "5·10^{−300}",
                "6·10^{−300}"
            ]
        );
    }

    #[test]
    fn a_range_of_any_size_and_place_has_ascending_values_within_it() {
        for (low, high) in [
            (0.0, 5e-324),
            (0.0, f64::MIN_POSITIVE),
            (1e9, 1e9 + 1e-6),
            (1e9, 1e9 + 2e-7),
            (-1e9 - 1.0, -1e9),
            (0.0, 1e308),
            (-8e307, 8e307),
        ] {
            let values = round_values(low, high);
            assert!((1..=6).contains(&values.len()), "{low} {high} {values:?}");
            assert!(values.windows(2).all(|pair| pair[0] < pair[1]), "{low} {high} {values:?}");
            assert!(values.iter().all(|v| (low..=high).contains(v)), "{low} {high} {values:?}");
        }
    }
}
