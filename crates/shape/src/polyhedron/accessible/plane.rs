//! The plane of a facet: coordinates in it, and the height above it.

use clench_screw::{Vector, spatial};

use crate::Facet;

/// The plane of a facet, with coordinates of the size of the solid.
#[derive(Clone, Copy, Debug)]
pub(super) struct FacetPlane {
    origin: Vector<3>,
    /// Two in the plane and the outward normal, right-handed.
    axes: [Vector<3>; 3],
    scale: f64,
    /// Half the extent of the facet in the plane.
    pub(super) half: Vector<2>,
    /// How far its corners are above or below.
    pub(super) rise: f64,
}

impl FacetPlane {
    /// With its origin in the middle of the facet's box, the first axis along its longest border.
    pub(super) fn new(facet: &Facet, vertices: &[Vector<3>], scale: f64) -> Self {
        let outward = -facet.inward_normal();
        let mut longest = Vector::ZERO;
        for chain in facet.loops() {
            let next = chain.iter().cycle().skip(1);
            for (&from, &to) in chain.iter().zip(next) {
                let side = vertices[to] - vertices[from];
                if side.norm_squared() > longest.norm_squared() {
                    longest = side;
                }
            }
        }
        let across = spatial::cross(outward, longest * scale);
        let across = across.direction().unwrap_or(Vector::ZERO);
        let axes = [spatial::cross(across, outward), across, outward];
        let origin = facet.triangles()[0][0];
        let mut plane = Self { origin, axes, scale, half: Vector::ZERO, rise: 0.0 };
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for &corner in facet.triangles().as_flattened() {
            let at = plane.local(corner);
            for i in 0..3 {
                low[i] = low[i].min(at[i]);
                high[i] = high[i].max(at[i]);
            }
        }
        let middle = Vector::from_fn(|i| 0.5 * (low[i] + high[i]));
        plane.origin = plane.world(middle);
        plane.half = Vector::from_fn(|i| 0.5 * (high[i] - low[i]));
        plane.rise = 0.5 * (high[2] - low[2]);
        plane
    }

    /// Coordinates in the plane and the height above it, in the scale of the solid.
    pub(super) fn local(&self, point: Vector<3>) -> Vector<3> {
        let offset = (point - self.origin) * self.scale;
        Vector::from_fn(|i| self.axes[i].dot(offset))
    }

    /// The point with these coordinates.
    pub(super) fn world(&self, local: Vector<3>) -> Vector<3> {
        let [u, v, up] = self.axes;
        self.origin + (u * local[0] + v * local[1] + up * local[2]) * self.scale.recip()
    }

    /// The outward normal.
    pub(super) const fn up(&self) -> Vector<3> {
        self.axes[2]
    }

    /// What an axis of the world has along the two axes of the plane.
    pub(super) fn along_axis(&self, axis: usize) -> Vector<2> {
        Vector::new([self.axes[0][axis], self.axes[1][axis]])
    }
}
