//! The energy ellipsoids of one planar grasp in two frames.

use crate::energy_surface::{EnergySpace, EnergySurface};
use crate::error::{DrawError, Input};
use crate::figure::Figure;
use crate::world_map::UNSEEN;

/// The paper's Figures 1 and 2: the level set `x^T A x = 2` of one grasp's energy, once in
/// the frame at the center of compliance and once in another.
///
/// Coordinates are `(v_x, v_y, ω)` for twists, `A = K`, and `(f_x, f_y, τ)` for wrenches,
/// `A = K^{-1}`. The drawing shows what the change of frame leaves alone: for twists the
/// horizontal sections and the bounding planes, for wrenches the cylinder over the
/// projection and the points on the vertical axis. The vertical axis has its own scale.
/// The view is parallel, so that equal sections look equal.
///
/// ```
/// use clench_draw::{EnergyEllipsoids, EnergySpace};
///
/// let picture = EnergyEllipsoids::new(
///     EnergySpace::Twist,
///     [[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 8.0]],
///     [[2.0, 0.0, -2.0], [0.0, 2.0, 0.0], [-2.0, 0.0, 10.0]],
/// );
/// // Both are sqrt(2 / 8) high.
/// assert!(picture.figure()?.to_svg().contains("ω = √(2/μ) = 0.5<"));
/// # Ok::<(), clench_draw::DrawError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct EnergyEllipsoids {
    /// Twists or wrenches.
    pub space: EnergySpace,
    /// The matrix in the frame at the center of compliance: block-diagonal.
    pub upright: [[f64; 3]; 3],
    /// The matrix in the other frame.
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
    /// [`DrawError::NotFinite`], [`DrawError::NotSymmetric`] or
    /// [`DrawError::NotPositiveDefinite`] for either matrix; [`DrawError::NotUpright`] for
    /// coupling in the first; [`DrawError::DifferentGrasps`] if the two are not one energy.
    pub fn figure(&self) -> Result<Figure, DrawError> {
        crate::energy_drawing::draw(self)
    }

    /// The two surfaces, upright first.
    pub(crate) fn surfaces(&self) -> Result<[EnergySurface; 2], DrawError> {
        let upright = EnergySurface::new(self.upright, self.space, Input::Upright)?;
        let slanted = EnergySurface::new(self.slanted, self.space, Input::Slanted)?;
        let [[xx, _, xz], [_, yy, yz], [.., zz]] = self.upright;
        let coupling = xz.hypot(yz) / (xx.max(yy) * zz).sqrt();
        if coupling > UNSEEN {
            return Err(DrawError::NotUpright { coupling });
        }
        let lengths = |surface: &EnergySurface| {
            let [a, b, pole] = surface.columns();
            let (a, b) = (a[0].hypot(a[1]), b[0].hypot(b[1]));
            [a.min(b), a.max(b), pole[2]]
        };
        for (upright, slanted) in lengths(&upright).into_iter().zip(lengths(&slanted)) {
            if (upright - slanted).abs() > UNSEEN * upright {
                return Err(DrawError::DifferentGrasps { upright, slanted });
            }
        }
        Ok([upright, slanted])
    }
}
