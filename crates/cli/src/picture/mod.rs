//! Pictures of grasps, from what the reports say.

mod figures;
mod outline;
mod scene;
mod solid;

use clench_draw::{DrawError, Figure, GraspPicture, SolidPicture};

pub(crate) use figures::Figures;
pub(crate) use outline::{of_analysis, of_optimum};
pub(crate) use scene::Scene;
pub(crate) use solid::{of_analysis_in_space, of_optimum_on_solid};

/// A picture of the plane or of space.
#[derive(Debug)]
pub(crate) enum Picture {
    Outline(GraspPicture),
    Solid(SolidPicture),
}

impl Picture {
    /// Draws it.
    pub(crate) fn figure(&self) -> Result<Figure, DrawError> {
        match self {
            Self::Outline(picture) => picture.figure(),
            Self::Solid(picture) => picture.figure(),
        }
    }
}

/// Fingers have letters, so that their numbers are not taken for those of corners.
fn finger_name(finger: usize) -> String {
    format!("F{finger}")
}

/// As many components as a picture of this dimension needs.
fn array<const N: usize>(components: &[f64]) -> [f64; N] {
    std::array::from_fn(|i| components.get(i).copied().unwrap_or(0.0))
}
