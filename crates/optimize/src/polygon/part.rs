//! A polygonal part and the stiffness of its edges.

use clench_shape::Polygon;

use crate::OptimizeError;

/// The largest edge stiffness has to be below this many times the smallest.
///
/// `sigma_min` of a combination is a difference of sums of stiffnesses, so it loses as many digits
/// as their ratio has; with this one, a third of the digits of a double remain.
pub const LARGEST_SPREAD: f64 = 1e10;

/// An outline with the contact stiffness of each of its edges.
#[derive(Clone, Debug)]
pub struct Part {
    outline: Polygon,
    edge_stiffness: Vec<f64>,
}

impl Part {
    /// The part with one stiffness (force / length) per edge, in the order of the outline.
    ///
    /// # Errors
    ///
    /// [`OptimizeError::StiffnessCount`], [`OptimizeError::Stiffness`],
    /// [`OptimizeError::StiffnessSpread`].
    pub fn new(outline: Polygon, edge_stiffness: Vec<f64>) -> Result<Self, OptimizeError> {
        let (found, edges) = (edge_stiffness.len(), outline.edges().len());
        if found != edges {
            return Err(OptimizeError::StiffnessCount { found, edges });
        }
        let fault = |k: &f64| !(*k > 0.0 && k.is_finite());
        if let Some(edge) = edge_stiffness.iter().position(fault) {
            return Err(OptimizeError::Stiffness { edge, value: edge_stiffness[edge] });
        }
        let smallest = edge_stiffness.iter().copied().fold(f64::INFINITY, f64::min);
        let largest = edge_stiffness.iter().copied().fold(0.0, f64::max);
        if largest / LARGEST_SPREAD >= smallest {
            let limit = LARGEST_SPREAD;
            return Err(OptimizeError::StiffnessSpread { smallest, largest, limit });
        }
        Ok(Self { outline, edge_stiffness })
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
