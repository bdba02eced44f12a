//! The energy ellipsoids of one planar grasp in two frames.

mod drawing;
mod hiding;
mod pieces;
mod scene;
mod surface;
mod surroundings;

use crate::error::{DrawError, Input};
use crate::figure::Figure;
use crate::world_map::UNSEEN;

pub use surface::EnergySpace;
use surface::EnergySurface;

/// The paper's Figures 1 and 2: the surface of unit energy of one grasp, once in the frame at the
/// center of compliance and once in another, shifted one.
///
/// Each ellipsoid is given by three of its points, see [`EnergySpace`]. The drawing shows what the
/// shift leaves alone: for twists the horizontal sections and the bounding planes, for wrenches
/// the cylinder over the projection and the points on the vertical axis. The vertical axis has
/// its own scale. The view is parallel, so that equal sections look equal.
///
/// ```
/// use clench_draw::{EnergyEllipsoids, EnergySpace};
///
/// // 2 against translations, 8 against rotation, about the center and one length below it.
/// let picture = EnergyEllipsoids::new(
///     EnergySpace::Twist,
///     [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.5]],
///     [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.5, 0.0, 0.5]],
/// );
/// // Both are sqrt(2 / 8) high.
/// assert!(picture.figure()?.to_svg().contains("ω = √(2/μ) = 0.5<"));
/// # Ok::<(), clench_draw::DrawError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct EnergyEllipsoids {
    /// Twists or wrenches.
    pub space: EnergySpace,
    /// Three points in the frame at the center of compliance, where translation and rotation
    /// decouple.
    pub upright: [[f64; 3]; 3],
    /// The same points in the other frame.
    pub slanted: [[f64; 3]; 3],
    /// How the key names the first frame.
    pub upright_label: String,
    /// How the key names the other frame.
    pub slanted_label: String,
    /// The heading.
    pub title: Option<String>,
}

impl EnergyEllipsoids {
    /// The picture with the key of the paper's figures and no title.
    #[must_use]
    pub fn new(space: EnergySpace, upright: [[f64; 3]; 3], slanted: [[f64; 3]; 3]) -> Self {
        Self {
            space,
            upright,
            slanted,
            upright_label: "frame at the center of compliance".to_owned(),
            slanted_label: "frame at the origin".to_owned(),
            title: None,
        }
    }

    /// Draws the picture.
    ///
    /// # Errors
    /// [`DrawError::NotFinite`], [`DrawError::NotTriangular`], [`DrawError::Flat`] or
    /// [`DrawError::NotSemiAxes`] for either ellipsoid; [`DrawError::NotUpright`] if the first
    /// leans; [`DrawError::DifferentGrasps`] if the two are not one energy.
    pub fn figure(&self) -> Result<Figure, DrawError> {
        drawing::draw(self)
    }

    /// The two surfaces, upright first.
    pub(crate) fn surfaces(&self) -> Result<[EnergySurface; 2], DrawError> {
        let upright = EnergySurface::new(self.upright, self.space, Input::Upright)?;
        let slanted = EnergySurface::new(self.slanted, self.space, Input::Slanted)?;
        let [a, b, pole] = upright.columns();
        let lean = match self.space {
            EnergySpace::Twist => pole[0].hypot(pole[1]) / upright.semi_axes()[1],
            EnergySpace::Wrench => a[2].hypot(b[2]) / pole[2],
        };
        if lean > UNSEEN {
            return Err(DrawError::NotUpright { lean });
        }
        for (upright, slanted) in upright.invariants().into_iter().zip(slanted.invariants()) {
            if (upright - slanted).abs() > UNSEEN * upright {
                return Err(DrawError::DifferentGrasps { upright, slanted });
            }
        }
        Ok([upright, slanted])
    }
}
