//! A polygonal part: its outline, the stiffness of its edges, and where they may be touched.

use clench_shape::{DiscTip, Polygon};

use crate::OptimizeError;

/// The largest edge stiffness has to be below this many times the smallest.
///
/// `sigma_min` of a combination is a difference of sums of stiffnesses, so it loses as many digits
/// as their ratio has; with this one, a third of the digits of a double remain.
pub const LARGEST_SPREAD: f64 = 1e10;

/// Corners at which the boundary turns by less than this (rad) are those of flattened curves: it is
/// smooth there, as far as a margin is concerned.
pub const SMOOTH_TURN: f64 = 0.5;

/// A part of an edge that fingers may touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// The edge, numbered as in the outline.
    pub edge: usize,
    /// Where it begins, from the edge's start (length).
    pub from: f64,
    /// Where it ends (length).
    pub to: f64,
}

/// An outline with the contact stiffness of each of its edges, and the stretches of them that
/// fingers may touch: all, unless some are taken away.
///
/// ```
/// use clench_optimize::polygon::{Part, Stretch};
/// use clench_shape::Polygon;
///
/// let square = Polygon::new(&[[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]])?;
/// let part = Part::uniform(square, 1.0)?
///     .with_margin(1.0)?
///     .without(Stretch { edge: 2, from: 3.0, to: 5.0 })?
///     .without_edge(3)?;
/// let left: Vec<_> = part.stretches().iter().map(|s| (s.edge, s.from, s.to)).collect();
/// assert_eq!(left, [(0, 1.0, 7.0), (1, 1.0, 7.0), (2, 1.0, 3.0), (2, 5.0, 7.0)]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Part {
    outline: Polygon,
    edge_stiffness: Vec<f64>,
    /// By edge, then from its start on.
    stretches: Vec<Stretch>,
}

impl Part {
    /// The part with one stiffness (force / length) per edge, in the order of the outline.
    ///
    /// # Errors
    ///
    /// [`OptimizeError::StiffnessCount`], [`OptimizeError::Stiffness`],
    /// [`OptimizeError::StiffnessSpread`].
    pub fn new(outline: Polygon, edge_stiffness: Vec<f64>) -> Result<Self, OptimizeError> {
        let (found, sides) = (edge_stiffness.len(), outline.edges().len());
        if found != sides {
            return Err(OptimizeError::StiffnessCount { found, sides });
        }
        let fault = |k: &f64| !(*k > 0.0 && k.is_finite());
        if let Some(side) = edge_stiffness.iter().position(fault) {
            return Err(OptimizeError::Stiffness { side, value: edge_stiffness[side] });
        }
        let smallest = edge_stiffness.iter().copied().fold(f64::INFINITY, f64::min);
        let largest = edge_stiffness.iter().copied().fold(0.0, f64::max);
        if largest / LARGEST_SPREAD >= smallest {
            let limit = LARGEST_SPREAD;
            return Err(OptimizeError::StiffnessSpread { smallest, largest, limit });
        }
        let edges = outline.edges().iter().enumerate();
        let stretches =
            edges.map(|(edge, e)| Stretch { edge, from: 0.0, to: e.length() }).collect();
        Ok(Self { outline, edge_stiffness, stretches })
    }

    /// The part with the same stiffness (force / length) on each edge.
    ///
    /// # Errors
    ///
    /// [`OptimizeError::Stiffness`].
    pub fn uniform(outline: Polygon, stiffness: f64) -> Result<Self, OptimizeError> {
        let edge_stiffness = vec![stiffness; outline.edges().len()];
        Self::new(outline, edge_stiffness)
    }

    /// The part that may not be touched nearer than `margin` (length, along the boundary) to its
    /// corners, except those that turn by less than [`SMOOTH_TURN`].
    ///
    /// Edges between two corners that are shorter than twice the margin are not touched at all.
    ///
    /// # Errors
    ///
    /// [`OptimizeError::Margin`] when it is negative or not finite.
    pub fn with_margin(mut self, margin: f64) -> Result<Self, OptimizeError> {
        if !(margin >= 0.0 && margin.is_finite()) {
            return Err(OptimizeError::Margin { value: margin });
        }
        let distances = self.distances_to_corners();
        for stretch in &mut self.stretches {
            let length = self.outline.edges()[stretch.edge].length();
            let [before, after] = distances[stretch.edge];
            stretch.from = stretch.from.max(margin - before);
            stretch.to = stretch.to.min(length - (margin - after));
        }
        self.stretches.retain(|s| s.from < s.to);
        Ok(self)
    }

    /// How far it is along the boundary from the last corner that is not smooth to the start of
    /// each edge, and from its end to the next one; infinite on a loop without such corners.
    fn distances_to_corners(&self) -> Vec<[f64; 2]> {
        let edges = self.outline.edges();
        let mut distances = vec![[f64::INFINITY; 2]; edges.len()];
        for run in self.outline.loops() {
            let next = |edge: usize| if edge + 1 == run.end { run.start } else { edge + 1 };
            let is_smooth = |edge: usize| {
                edges[edge].direction().dot(edges[next(edge)].direction()) > SMOOTH_TURN.cos()
            };
            // Twice around, since the last corner may be behind the first edge.
            for edge in run.clone().chain(run.clone()) {
                let walked = distances[edge][0] + edges[edge].length();
                distances[next(edge)][0] = if is_smooth(edge) { walked } else { 0.0 };
            }
            for edge in run.clone().rev().chain(run.clone().rev()) {
                let walked = distances[next(edge)][1] + edges[next(edge)].length();
                distances[edge][1] = if is_smooth(edge) { walked } else { 0.0 };
            }
        }
        distances
    }

    /// The part that may not be touched on `forbidden`; what sticks out of its edge does not count.
    ///
    /// # Errors
    ///
    /// [`OptimizeError::NoSuchEdge`]; [`OptimizeError::Stretch`] when it does not go forward.
    pub fn without(mut self, forbidden: Stretch) -> Result<Self, OptimizeError> {
        let Stretch { edge, from, to } = forbidden;
        self.checked([edge])?;
        if from.is_nan() || to.is_nan() || from >= to {
            return Err(OptimizeError::Stretch { edge, from, to });
        }
        let cut = |s: Stretch| {
            let before = Stretch { to: s.to.min(from), ..s };
            let after = Stretch { from: s.from.max(to), ..s };
            let pieces = if s.edge == edge { [Some(before), Some(after)] } else { [Some(s), None] };
            pieces.into_iter().flatten().filter(|piece| piece.from < piece.to)
        };
        self.stretches = self.stretches.into_iter().flat_map(cut).collect();
        Ok(self)
    }

    /// The part whose edge `edge` may not be touched.
    ///
    /// # Errors
    ///
    /// [`OptimizeError::NoSuchEdge`].
    pub fn without_edge(self, edge: usize) -> Result<Self, OptimizeError> {
        self.without(Stretch { edge, from: f64::NEG_INFINITY, to: f64::INFINITY })
    }

    /// The part that may only be touched where the tip of a finger can.
    ///
    /// # Errors
    ///
    /// [`OptimizeError::Access`].
    ///
    /// ```
    /// use clench_optimize::polygon::Part;
    /// use clench_shape::{DiscTip, Polygon};
    ///
    /// let corner = [[0.0, 0.0], [6.0, 0.0], [6.0, 2.0], [2.0, 2.0], [2.0, 6.0], [0.0, 6.0]];
    /// let part = Part::uniform(Polygon::new(&corner)?, 1.0)?.accessible_to(&DiscTip::new(1.0)?)?;
    /// // In the corner of the L a finger of radius 1 stays off the other side.
    /// assert!((part.stretches()[2].to - 3.0).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn accessible_to(mut self, tip: &DiscTip) -> Result<Self, OptimizeError> {
        let all = self.outline.accessible(tip)?;
        let cut = |s: Stretch| {
            let narrowed = move |&[from, to]: &[f64; 2]| Stretch {
                from: s.from.max(from),
                to: s.to.min(to),
                ..s
            };
            all[s.edge].iter().map(narrowed).filter(|piece| piece.from < piece.to)
        };
        self.stretches = self.stretches.into_iter().flat_map(cut).collect();
        Ok(self)
    }

    /// The outline.
    #[must_use]
    pub const fn outline(&self) -> &Polygon {
        &self.outline
    }

    /// The stiffness of each edge (force / length).
    #[must_use]
    pub fn edge_stiffness(&self) -> &[f64] {
        &self.edge_stiffness
    }

    /// Where fingers may touch, by edge and along each edge from its start on.
    #[must_use]
    pub fn stretches(&self) -> &[Stretch] {
        &self.stretches
    }

    /// Whether some of the boundary may not be touched.
    pub(super) fn is_restricted(&self) -> bool {
        let whole = |s: &Stretch, length: f64| s.from <= 0.0 && s.to >= length;
        let edges = self.outline.edges();
        let whole = self.stretches.iter().filter(|s| whole(s, edges[s.edge].length())).count();
        whole < edges.len()
    }

    /// `edges` in ascending order, if they all exist.
    pub(super) fn checked<const K: usize>(
        &self,
        mut edges: [usize; K],
    ) -> Result<[usize; K], OptimizeError> {
        edges.sort_unstable();
        let last = self.edge_stiffness.len() - 1;
        match edges.iter().find(|&&edge| edge > last) {
            Some(&edge) => Err(OptimizeError::NoSuchEdge { edge, last }),
            None => Ok(edges),
        }
    }
}
