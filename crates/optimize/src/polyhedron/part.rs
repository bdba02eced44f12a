//! A polyhedral part: a solid, and the stiffness of its faces.

use clench_screw::Vector;
use clench_shape::{AccessibleFacet, BallTip, Facet, Polyhedron};

use crate::OptimizeError;
use crate::polygon::LARGEST_SPREAD;

/// A solid with the contact stiffness of each of its faces, and its facets: its faces taken
/// together where they are in one plane.
///
/// ```
/// use clench_optimize::polyhedron::Part;
/// use clench_shape::Polyhedron;
///
/// // The corner of a cube.
/// let vertices = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 3.0]];
/// let faces = [vec![0, 2, 1], vec![0, 1, 3], vec![0, 3, 2], vec![1, 2, 3]];
/// let part = Part::uniform(Polyhedron::new(&vertices, &faces)?, 1.0, 0.0)?;
/// assert_eq!(part.facets().len(), 4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Part {
    solid: Polyhedron,
    facets: Vec<Facet>,
    face_stiffness: Vec<f64>,
    flatness: f64,
    /// What is accessible of each facet, if that is not all.
    accessible: Option<Vec<AccessibleFacet>>,
}

impl Part {
    /// The part with one stiffness (force / length) per face, in the order of the solid. Neighbors
    /// whose vertices are in one plane, up to `flatness` (length), are one facet: see
    /// [`Polyhedron::facets`].
    ///
    /// # Errors
    ///
    /// [`OptimizeError::StiffnessCount`], [`OptimizeError::Stiffness`],
    /// [`OptimizeError::StiffnessSpread`]; [`OptimizeError::UnlikeStiffness`] when faces of one
    /// facet have different stiffnesses.
    pub fn new(
        solid: Polyhedron,
        face_stiffness: Vec<f64>,
        flatness: f64,
    ) -> Result<Self, OptimizeError> {
        let (found, sides) = (face_stiffness.len(), solid.faces().len());
        if found != sides {
            return Err(OptimizeError::StiffnessCount { found, sides });
        }
        let fault = |k: &f64| !(*k > 0.0 && k.is_finite());
        if let Some(side) = face_stiffness.iter().position(fault) {
            return Err(OptimizeError::Stiffness { side, value: face_stiffness[side] });
        }
        check_spread(face_stiffness.iter().copied())?;
        let facets = solid.facets(flatness);
        for facet in &facets {
            let first = facet.faces()[0];
            let of = |face: usize| face_stiffness[face].to_bits();
            if let Some(&other) = facet.faces().iter().find(|&&face| of(face) != of(first)) {
                return Err(OptimizeError::UnlikeStiffness { faces: [first, other] });
            }
        }
        Ok(Self { solid, facets, face_stiffness, flatness, accessible: None })
    }

    /// The part with the same stiffness (force / length) on each face.
    ///
    /// # Errors
    ///
    /// [`OptimizeError::Stiffness`].
    pub fn uniform(
        solid: Polyhedron,
        stiffness: f64,
        flatness: f64,
    ) -> Result<Self, OptimizeError> {
        let face_stiffness = vec![stiffness; solid.faces().len()];
        Self::new(solid, face_stiffness, flatness)
    }

    /// The same part with the places only that the tip of a finger can touch, whatever was asked
    /// before.
    ///
    /// # Errors
    ///
    /// [`OptimizeError::Access`]; [`OptimizeError::NothingAccessible`].
    pub fn accessible_to(self, tip: &BallTip) -> Result<Self, OptimizeError> {
        let accessible = self.solid.accessible(&self.facets, self.flatness, tip)?;
        if accessible.iter().all(|facet| facet.triangles().is_empty()) {
            return Err(OptimizeError::NothingAccessible {
                radius: tip.radius(),
                margin: tip.margin(),
                keep_outs: tip.keep_out().len(),
                on_plate: tip.plate().is_some(),
            });
        }
        Ok(Self { accessible: Some(accessible), ..self })
    }

    /// The solid.
    #[must_use]
    pub const fn solid(&self) -> &Polyhedron {
        &self.solid
    }

    /// The faces taken together where they are in one plane: what fingers are placed on.
    #[must_use]
    pub fn facets(&self) -> &[Facet] {
        &self.facets
    }

    /// The part of each facet that is accessible, if [`Part::accessible_to`] was asked.
    #[must_use]
    pub fn accessible(&self) -> Option<&[AccessibleFacet]> {
        self.accessible.as_deref()
    }

    /// The triangles of a facet on which fingers may be.
    pub(super) fn triangles(&self, facet: usize) -> &[[Vector<3>; 3]] {
        match &self.accessible {
            Some(accessible) => accessible[facet].triangles(),
            None => self.facets[facet].triangles(),
        }
    }

    /// The stiffness of each face (force / length).
    #[must_use]
    pub fn face_stiffness(&self) -> &[f64] {
        &self.face_stiffness
    }
}

/// Checks that no stiffness is lost beside another one.
pub(super) fn check_spread(all: impl Iterator<Item = f64> + Clone) -> Result<(), OptimizeError> {
    let smallest = all.clone().fold(f64::INFINITY, f64::min);
    let largest = all.fold(0.0, f64::max);
    if largest / LARGEST_SPREAD >= smallest {
        let limit = LARGEST_SPREAD;
        return Err(OptimizeError::StiffnessSpread { smallest, largest, limit });
    }
    Ok(())
}
