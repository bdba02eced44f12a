//! How many times as far a displacement is drawn.

/// The largest part of the drawn extent that a displacement takes.
const SHARE: f64 = 0.1;

/// A round factor that makes a small displacement seen: 1, 2 or 5 times a power of ten, the largest
/// with which `largest` takes at most a tenth of `extent`, both of one unit.
///
/// `None` for a displacement of zero, and for what has no such factor.
///
/// ```
/// // Under 0.0075 of 100, a thousand times as much.
/// assert_eq!(clench_draw::exaggeration(0.0075, 100.0), Some(1000.0));
/// assert_eq!(clench_draw::exaggeration(0.03, 100.0), Some(200.0));
/// assert_eq!(clench_draw::exaggeration(0.0, 100.0), None);
/// ```
#[must_use]
pub fn exaggeration(largest: f64, extent: f64) -> Option<f64> {
    let room = SHARE * extent / largest;
    if !(room.is_normal() && room > 0.0) {
        return None;
    }
    // The number as it is written has its power of ten, without the rounding of a logarithm.
    let text = format!("{room:.15e}");
    let (mantissa, power) = text.split_once('e')?;
    let mantissa: f64 = mantissa.parse().ok()?;
    let round = [5, 2, 1].into_iter().find(|&round| mantissa >= f64::from(round))?;
    format!("{round}e{power}").parse().ok().filter(|factor: &f64| factor.is_normal())
}

#[cfg(test)]
mod tests {
    use super::exaggeration;

    #[test]
    fn the_factor_is_round_and_leaves_the_displacement_within_its_share() {
        for (largest, factor) in [(0.1, 100.0), (0.2, 50.0), (0.21, 20.0), (0.9, 10.0), (25.0, 0.2)]
        {
            assert_eq!(exaggeration(largest, 100.0), Some(factor), "{largest}");
        }
        for nothing in [0.0, f64::NAN, f64::INFINITY, -1.0] {
            assert_eq!(exaggeration(nothing, 100.0), None);
        }
        assert_eq!(exaggeration(1e-320, 100.0), None);
    }
}
