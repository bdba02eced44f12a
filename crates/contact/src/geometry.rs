//! Where finger and part touch, and how both are curved there.

use clench_screw::{Mat, SymmetricEigen, Vector};

use crate::curvature::Radii;
use crate::tangent::Tangent;
use crate::{ContactError, Curvature};

/// A sum of two curvatures below this part of their sizes is nothing but their rounding, a few
/// units each.
pub(crate) const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// The place of a contact: the deepest point of the part, the normal into the part, and the
/// curvatures of both boundaries.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Geometry<const N: usize> {
    /// `b`, the deepest point of the part's boundary (length).
    pub point: Vector<N>,
    /// `n`, the normal into the part, of any length.
    pub inward_normal: Vector<N>,
    /// The boundary of the finger at its own deepest point.
    pub finger: Curvature<N>,
    /// The boundary of the part at `b`.
    pub part: Curvature<N>,
}

impl<const N: usize> Geometry<N> {
    /// A disc or sphere of radius `radius`, 0 for a pointed finger, on a straight edge or a plane
    /// face.
    #[must_use]
    pub const fn on_face(point: Vector<N>, inward_normal: Vector<N>, radius: f64) -> Self {
        let (finger, part) = (Curvature::round(radius), Curvature::FLAT);
        Self { point, inward_normal, finger, part }
    }

    /// The same with a normal of unit length.
    pub(crate) fn checked(self) -> Result<Self, ContactError> {
        let point = finite("contact point", self.point)?;
        let normal = finite("inward normal", self.inward_normal)?;
        let inward_normal = normal.direction().ok_or(ContactError::NoNormal)?;
        Ok(Self { point, inward_normal, ..self })
    }

    /// The radii of curvature of finger and part, of a checked geometry.
    pub(crate) fn radii(&self, tangent: &Tangent<N>) -> Result<[Radii<N>; 2], ContactError> {
        let finger = Radii::new("finger", &self.finger, tangent)?;
        let part = Radii::new("part", &self.part, tangent)?;
        Ok([finger, part])
    }
}

/// The principal curvatures of the gap between finger and part: the eigenvalues of the sum of
/// both shape operators, `2 A` and `2 B` of Hertz' theory.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RelativeCurvature {
    /// `2 A` (1 / length); 0 where it is nothing but rounding, along a line of contact.
    pub smaller: f64,
    /// `2 B` (1 / length).
    pub larger: f64,
    /// The unit direction of the smaller one, along which the area of contact is longest; some
    /// tangent direction when both are equal.
    pub along: Vector<3>,
}

impl Geometry<3> {
    /// The curvatures of the gap between finger and part.
    ///
    /// # Errors
    ///
    /// What [`Contact::new`](crate::Contact::new) finds wrong with a geometry;
    /// [`ContactError::Pointed`] for a pointed boundary, whose curvature is infinite.
    ///
    /// ```
    /// use clench_contact::{Curvature, Geometry};
    /// use clench_screw::Vector;
    /// // A roller of radius 2 along y on a barrel of radius 4 along x.
    /// let (x, y) = (Vector::new([1.0, 0.0, 0.0]), Vector::new([0.0, 1.0, 0.0]));
    /// let crossed = Geometry {
    ///     point: Vector::ZERO,
    ///     inward_normal: Vector::new([0.0, 0.0, -1.0]),
    ///     finger: Curvature::principal_radii([2.0, f64::INFINITY], x),
    ///     part: Curvature::principal_radii([4.0, f64::INFINITY], y),
    /// };
    /// let relative = crossed.relative_curvature()?;
    /// assert_eq!((relative.smaller, relative.larger), (0.25, 0.5));
    /// assert_eq!(relative.along.dot(y).abs(), 1.0);
    /// # Ok::<(), clench_contact::ContactError>(())
    /// ```
    pub fn relative_curvature(&self) -> Result<RelativeCurvature, ContactError> {
        let checked = self.checked()?;
        let tangent = Tangent::of(checked.inward_normal);
        let [finger, part] = checked.radii(&tangent)?;
        for (body, radii) in [("finger", finger), ("part", part)] {
            if radii.x <= 0.0 {
                return Err(ContactError::Pointed { body });
            }
        }
        let [finger, part] = [finger, part].map(|radii| radii.y * radii.x.recip());
        let eigen = SymmetricEigen::new(&Mat::new(tangent.entries(&(finger + part))))?;
        let [smaller, larger] = eigen.values;
        let rounding = ROUNDING * (finger.max_abs() + part.max_abs());
        Ok(RelativeCurvature {
            smaller: if smaller.abs() > rounding { smaller } else { 0.0 },
            larger,
            along: tangent.direction(eigen.vectors[0].to_array()),
        })
    }
}

fn finite<const N: usize>(
    parameter: &'static str,
    vector: Vector<N>,
) -> Result<Vector<N>, ContactError> {
    match (0..N).find(|&axis| !vector[axis].is_finite()) {
        Some(axis) => Err(ContactError::NotFinite { parameter, axis, value: vector[axis] }),
        None => Ok(vector),
    }
}
