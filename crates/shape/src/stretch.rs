//! The farthest corner along a segment.

use clench_screw::Vector;

/// A piece of a segment with one farthest corner.
///
/// Points of the segment are `start + t (end - start)`, with `t` between 0 and 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// The number of the corner.
    pub corner: usize,
    /// Where the piece begins, as a share of the segment.
    pub from: f64,
    /// Where it ends; more than `from`.
    pub to: f64,
}

/// Walks the upper envelope of the squared distances along a segment.
///
/// On the segment `s + t d` the squared distance of each site is `t^2 |d|^2` plus a function
/// linear in `t`, whose slope grows with `-d . site`. So the farthest site changes only to one of
/// greater slope, and the walk ends whatever the roundings.
#[derive(Clone, Debug)]
pub(crate) struct Stretches<'a> {
    sites: &'a [Vector<2>],
    corners: &'a [usize],
    start: Vector<2>,
    along: Vector<2>,
    at: f64,
    /// The farthest site at `at`; none when the end has been reached.
    current: Option<usize>,
}

impl<'a> Stretches<'a> {
    /// The walk from `start`, where site `first` is farthest, by the vector `along`.
    pub(crate) fn new(
        (sites, corners): (&'a [Vector<2>], &'a [usize]),
        first: usize,
        start: Vector<2>,
        along: Vector<2>,
    ) -> Self {
        Self { sites, corners, start, along, at: 0.0, current: Some(first) }
    }

    /// The site that first becomes farther than `current`, and where; of several at the same
    /// place, the one that is farther afterwards.
    fn overtaking(&self, current: usize) -> Option<(f64, usize)> {
        let slope = |site: usize| -self.along.dot(self.sites[site] - self.sites[0]);
        let present = slope(current);
        let mut first: Option<(f64, f64, usize)> = None;
        for site in (0..self.sites.len()).filter(|&site| slope(site) > present) {
            let Some(t) = self.crossing(current, site) else {
                continue;
            };
            let sooner = first.is_none_or(|(best, steepest, _)| {
                t < best || (t <= best && slope(site) > steepest)
            });
            if sooner {
                first = Some((t, slope(site), site));
            }
        }
        first.map(|(t, _, site)| (t, site))
    }

    /// Where the segment's line crosses the bisector of sites `a` and `b`, with `b` farther after.
    fn crossing(&self, a: usize, b: usize) -> Option<f64> {
        let (to_a, to_b) = (self.sites[a] - self.start, self.sites[b] - self.start);
        let apart = self.sites[a] - self.sites[b];
        let gain = self.along.dot(apart);
        (gain > 0.0).then(|| apart.dot(to_a + to_b) * 0.5 / gain)
    }
}

impl Iterator for Stretches<'_> {
    type Item = Stretch;

    fn next(&mut self) -> Option<Stretch> {
        let mut current = self.current?;
        let from = self.at;
        while let Some((t, site)) = self.overtaking(current).filter(|&(t, _)| t < 1.0) {
            if t > from {
                (self.at, self.current) = (t, Some(site));
                return Some(Stretch { corner: self.corners[current], from, to: t });
            }
            // The stretch of `current` is a single point.
            current = site;
        }
        self.current = None;
        Some(Stretch { corner: self.corners[current], from, to: 1.0 })
    }
}
