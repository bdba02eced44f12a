//! Round values to write along an axis.

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
}
