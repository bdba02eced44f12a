//! The smallest circle around the corners.

use clench_screw::Vector;

use crate::triangulation::{Triangulation, circumcenter};

/// A circle in the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle {
    /// Its center.
    pub center: Vector<2>,
    /// Its radius (length).
    pub radius: f64,
}

/// The center of the smallest circle around the sites of a farthest triangulation.
///
/// The largest distance is a convex function of the point, and its pieces meet in the
/// circumcenters of the triangles. An obtuse angle says that the function still falls across the
/// side opposite; the walk goes there until no angle is obtuse, or until both sides of an edge
/// say "across", when its two ends span the circle. The triangles form a tree and the walk never
/// turns back, so that it ends whatever the roundings.
pub(crate) fn smallest_center(sites: &[Vector<2>], mesh: &Triangulation) -> Vector<2> {
    let mut came_from = None;
    let mut at = 0;
    loop {
        let triangle = &mesh.triangles()[at];
        let Some(i) = obtuse_angle(triangle.corners.map(|c| sites[c])) else {
            return circumcenter(triangle.corners.map(|c| sites[c]));
        };
        let next = triangle.across[i];
        match next {
            Some(there) if next != came_from => (came_from, at) = (Some(at), there),
            _ => {
                let [a, b] = triangle.side(i).map(|c| sites[c]);
                return a + (b - a) * 0.5;
            }
        }
    }
}

/// The corner with an angle above a quarter turn.
///
/// A right angle that rounds to either side gives the same circle, to rounding.
fn obtuse_angle(corners: [Vector<2>; 3]) -> Option<usize> {
    (0..3).find(|&i| {
        let at = corners[i];
        (corners[(i + 1) % 3] - at).dot(corners[(i + 2) % 3] - at) < 0.0
    })
}
