//! Beyond the paper: the measures of Example 5.2's grasp while its last finger goes round.

use clench::contact::{Contact, ContactError};
use clench::metrics::{EquivalentStiffness, Quality, WorstPoint};
use clench::shape::{Edge, Polygon};
use clench::stiffness::Grasp;

use super::grasps::{Paper, PaperError, finger, principal};

/// How many fingers stay.
pub(super) const FIXED: usize = 3;

/// Intervals on each edge: one shows as less than two page units.
const INTERVALS: u32 = 120;

/// Steps of a search on an edge: its length to less than a millionth.
const STEPS: u32 = 40;

/// The grasp with the moving finger at one place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample {
    /// How far the finger has come along the outline (length).
    pub(super) way: f64,
    /// `Q` (force / length, as are all measures).
    pub(super) quality: f64,
    pub(super) sigma_min: f64,
    /// `Q_V`.
    pub(super) rotational: f64,
    /// `Q_pt`.
    pub(super) worst: f64,
    /// Whether pushing fingers can hold the part.
    pub(super) closes: bool,
}

impl Sample {
    /// What `Q_pt` does not exceed, and half of which it is at least.
    pub(super) fn bound(&self) -> f64 {
        self.sigma_min.min(self.rotational)
    }
}

/// The grasps with the moving finger anywhere on the outline.
#[derive(Debug)]
pub(crate) struct Travel {
    /// Places along each edge, both ends among them.
    pub(super) edges: Vec<Vec<Sample>>,
    /// The place of the paper.
    pub(super) paper: Sample,
    /// The edge that it is on, and from where to where on it `Q` is `sigma_min` (length).
    pub(super) paper_edge: usize,
    pub(super) plateau: [f64; 2],
    /// Where `Q_pt` is largest of all grasps that close.
    pub(super) best: Sample,
}

impl Travel {
    pub(crate) fn compute(paper: &Paper) -> Result<Self, PaperError> {
        let mover = Mover::new(paper)?;
        let outline = mover.outline;
        let edges: Vec<Vec<Sample>> =
            (0..outline.edges().len()).map(|edge| mover.edge(edge)).collect::<Result<_, _>>()?;
        let place = &paper.four.best.placements[FIXED];
        let edge = &outline.edges()[place.on];
        let along = (place.point - edge.start()).norm();
        let flat = |end| mover.border(place.on, along, end, |at| at.rotational >= at.sigma_min);
        Ok(Self {
            paper: mover.at(place.on, along)?,
            paper_edge: place.on,
            plateau: [flat(0.0)?, flat(edge.length())?],
            best: mover.largest_worst(&edges)?,
            edges,
        })
    }

    /// Where each corner is on the way, the first one at both ends.
    pub(super) fn corners(&self) -> Vec<f64> {
        let ends = self.edges.iter().filter_map(|samples| samples.last());
        std::iter::once(0.0).chain(ends.map(|end| end.way)).collect()
    }
}

/// The fixed fingers, and the outline on which the other moves.
#[derive(Debug)]
struct Mover<'a> {
    outline: &'a Polygon,
    fixed: Vec<Contact<2, 1>>,
}

impl<'a> Mover<'a> {
    fn new(paper: &'a Paper) -> Result<Self, ContactError> {
        let outline = paper.part.outline();
        let placements = paper.four.best.placements.iter().take(FIXED);
        let fixed = placements.map(|p| finger(p.point, &outline.edges()[p.on]));
        Ok(Self { outline, fixed: fixed.collect::<Result<_, _>>()? })
    }

    /// The grasp with the moving finger on an edge, this far from its start.
    fn at(&self, edge: usize, along: f64) -> Result<Sample, PaperError> {
        let edges = self.outline.edges();
        let before: f64 = edges[..edge].iter().map(Edge::length).sum();
        let edge = &edges[edge];
        let mut fingers = self.fixed.clone();
        fingers.push(finger(edge.point_at(along), edge)?);
        let grasp = Grasp::new(fingers)?;
        let principal = principal(&grasp)?;
        let quality = Quality::of(&principal, self.outline)?;
        Ok(Sample {
            way: before + along,
            quality: quality.value,
            sigma_min: quality.translational,
            rotational: EquivalentStiffness::least(&principal, self.outline)?.value,
            worst: WorstPoint::of(&principal, self.outline)?.stiffness,
            closes: grasp.preloads()?.force_closure,
        })
    }

    fn edge(&self, edge: usize) -> Result<Vec<Sample>, PaperError> {
        let step = self.outline.edges()[edge].length() / f64::from(INTERVALS);
        (0..=INTERVALS).map(|i| self.at(edge, step * f64::from(i))).collect()
    }

    /// How far on an edge from a place towards an end something holds that holds at the place.
    fn border(
        &self,
        edge: usize,
        place: f64,
        end: f64,
        holds: impl Fn(&Sample) -> bool,
    ) -> Result<f64, PaperError> {
        if holds(&self.at(edge, end)?) {
            return Ok(end);
        }
        let (mut inside, mut outside) = (place, end);
        for _ in 0..STEPS {
            let middle = f64::midpoint(inside, outside);
            if holds(&self.at(edge, middle)?) { inside = middle } else { outside = middle }
        }
        Ok(inside)
    }

    /// The grasp that closes with the largest `Q_pt`: about the best of all samples, between its
    /// neighbors, where `Q_pt` rises and then falls.
    fn largest_worst(&self, edges: &[Vec<Sample>]) -> Result<Sample, PaperError> {
        let closing = |at: &Sample| if at.closes { at.worst } else { f64::NEG_INFINITY };
        let mut best = (0, 0);
        for (edge, samples) in edges.iter().enumerate() {
            for (i, sample) in samples.iter().enumerate() {
                if closing(sample) > closing(&edges[best.0][best.1]) {
                    best = (edge, i);
                }
            }
        }
        let (edge, i) = best;
        let samples = &edges[edge];
        let start = samples[0].way;
        let neighbors = [i.saturating_sub(1), (i + 1).min(samples.len() - 1)];
        let [mut low, mut high] = neighbors.map(|i| samples[i].way - start);
        for _ in 0..STEPS {
            let third = (high - low) / 3.0;
            let [a, b] = [self.at(edge, low + third)?, self.at(edge, high - third)?];
            if closing(&a) < closing(&b) { low += third } else { high -= third }
        }
        self.at(edge, f64::midpoint(low, high))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn travel() -> Travel {
        Travel::compute(&Paper::compute().unwrap()).unwrap()
    }

    #[test]
    fn the_worst_point_is_as_stiff_as_the_theorem_says() {
        // Both sides of the bound are computed with a few hundred roundings.
        let rounding = 1e-12;
        for sample in travel().edges.iter().flatten() {
            let share = sample.worst / sample.bound();
            assert!((0.5 - rounding..=1.0 + rounding).contains(&share), "{sample:?}");
            // In the plane there is one rotation.
            assert!((sample.quality / sample.bound() - 1.0).abs() < rounding, "{sample:?}");
        }
    }

    #[test]
    fn the_place_of_the_paper_is_on_a_plateau_of_the_quality() {
        let travel = travel();
        let start = travel.corners()[travel.paper_edge];
        let [from, to] = travel.plateau;
        assert!((from..=to).contains(&(travel.paper.way - start)));
        let samples = &travel.edges[travel.paper_edge];
        let highest = samples.iter().map(|sample| sample.quality).fold(0.0, f64::max);
        // K11 does not change along an edge: sigma_min = 2 - sqrt(0.1).
        for sample in samples {
            assert!((sample.sigma_min - (2.0 - 0.1_f64.sqrt())).abs() < 1e-12);
            let along = sample.way - start;
            let flat = (from..=to).contains(&along);
            assert_eq!(flat, (sample.quality - highest).abs() < 1e-12, "{along}");
        }
    }

    #[test]
    fn no_sample_that_closes_has_a_stiffer_worst_point_than_the_best() {
        let travel = travel();
        assert!(travel.best.closes);
        let closing = travel.edges.iter().flatten().filter(|sample| sample.closes);
        let largest = closing.map(|sample| sample.worst).fold(0.0, f64::max);
        assert!(travel.best.worst >= largest && travel.best.worst < 1.01 * largest);
    }
}
