//! Pictures of grasps, from what the reports say.

mod outline;
mod solid;

use clench_draw::{DrawError, Figure, GraspPicture, SolidPicture};

pub(crate) use outline::{of_analysis, of_optimum, of_outline};
pub(crate) use solid::{of_analysis_in_space, of_optimum_on_solid, of_solid};

/// A picture of the plane or of space.
#[derive(Debug)]
pub(crate) enum Picture {
    Outline(GraspPicture),
    Solid(SolidPicture),
}

impl Picture {
    /// The pictures of a page.
    pub(crate) fn figures(&self) -> Result<Figures, DrawError> {
        // The page has the numbers in tables.
        let grasp = match self {
            Self::Outline(p) => GraspPicture { caption: Vec::new(), ..p.clone() }.figure(),
            Self::Solid(p) => SolidPicture { caption: Vec::new(), ..p.clone() }.figure(),
        };
        Ok(Figures { grasp: grasp?.to_svg() })
    }

    /// Draws it.
    pub(crate) fn figure(&self) -> Result<Figure, DrawError> {
        match self {
            Self::Outline(picture) => picture.figure(),
            Self::Solid(picture) => picture.figure(),
        }
    }
}

/// The pictures of a page, as SVG.
#[derive(Debug)]
pub(crate) struct Figures {
    /// The part with its fingers.
    pub(crate) grasp: String,
}

/// Fingers have letters, so that their numbers are not taken for those of corners.
fn finger_name(finger: usize) -> String {
    format!("F{finger}")
}

/// As many components as a picture of this dimension needs.
fn array<const N: usize>(components: &[f64]) -> [f64; N] {
    std::array::from_fn(|i| components.get(i).copied().unwrap_or(0.0))
}
