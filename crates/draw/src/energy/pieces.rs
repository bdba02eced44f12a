//! Two interpenetrating ellipsoids, cut into pieces that can be painted back to front.
//!
//! The ellipsoids of one energy in two frames meet in two plane curves: the difference of the
//! two quadratic forms is a product of two linear ones. The planes cut space into four wedges,
//! in each of which one ellipsoid is the outer; a wedge never hides one nearer to the eye.

use std::f64::consts::TAU;

use clench_screw::Vector;
use clench_screw::spatial::cross;

use crate::energy::hiding::ON_SURFACE;
use crate::energy::surface::{EnergySpace, EnergySurface, SpaceEllipse};
use crate::view::View;

/// Points on each curve that bounds a piece.
const SAMPLES: u32 = 240;

/// Below this share of the form itself, the difference of the two is rounding: the forms are
/// rebuilt from the maps that also carry points onto the surfaces.
const SAME_FORM: f64 = ON_SURFACE;

/// The normals of the two planes in which the surfaces meet, on whose common positive side the
/// first surface is the outer one; `None` where the surfaces coincide.
pub(crate) fn meeting_planes(
    [first, second]: &[EnergySurface; 2],
    space: EnergySpace,
) -> Option<[Vector<3>; 2]> {
    let (a, b) = (first.half_matrix(), second.half_matrix());
    // Outer is where the form is smaller, so first is outer where second - first > 0.
    let coupling = [b[0][2] - a[0][2], b[1][2] - a[1][2]];
    if coupling[0].hypot(coupling[1]) <= SAME_FORM * b[2][2] {
        return None;
    }
    Some(match space {
        // z (2 d . x + e z)
        EnergySpace::Twist => {
            let tilted = [2.0 * coupling[0], 2.0 * coupling[1], b[2][2] - a[2][2]];
            [[0.0, 0.0, 1.0], tilted].map(Vector::new)
        }
        // k (g . f) (g . f - 2 z), with d = -k g
        EnergySpace::Wrench => {
            let slope = coupling.map(|value| -value / b[2][2]);
            [[slope[0], slope[1], 0.0], [slope[0], slope[1], -2.0]].map(Vector::new)
        }
    })
}

/// The curve in which a plane through the origin cuts a surface.
pub(crate) fn section(surface: &EnergySurface, normal: Vector<3>) -> SpaceEllipse {
    // Planes map to planes: n . (C y) = (C^T n) . y, and a silhouette is where u . y = 0.
    let pulled = surface.columns().map(|column| column.dot(normal));
    surface.silhouette(surface.point(pulled.into()))
}

/// The projections of the four pieces, farthest first, each with the index of its surface.
pub(crate) fn pieces(
    surfaces: &[EnergySurface; 2],
    planes: [Vector<3>; 2],
    view: &View,
) -> Vec<(usize, Vec<[f64; 2]>)> {
    let toward = planes.map(|normal| normal.dot(view.eye) >= 0.0);
    [[false, false], [false, true], [true, false], [true, true]]
        .into_iter()
        .map(|near| {
            let positive = [near[0] == toward[0], near[1] == toward[1]];
            let surface = usize::from(positive[0] != positive[1]);
            let hull = hull(piece(&surfaces[surface], planes, positive, view));
            (surface, hull)
        })
        .collect()
}

/// Points whose hull is the projection of one ellipsoid's part in one wedge: the wedge's edge,
/// and what lies in the wedge of the silhouette and of the two meeting curves.
fn piece(
    surface: &EnergySurface,
    planes: [Vector<3>; 2],
    positive: [bool; 2],
    view: &View,
) -> Vec<[f64; 2]> {
    let inside = |point: Vector<3>, skip: Option<usize>| {
        (0..2).all(|i| Some(i) == skip || (planes[i].dot(point) >= 0.0) == positive[i])
    };
    let mut points = Vec::new();
    let curves = [
        (surface.silhouette(view.eye), None),
        (section(surface, planes[0]), Some(0)),
        (section(surface, planes[1]), Some(1)),
    ];
    for (curve, own) in curves {
        let samples = (0..SAMPLES).map(|i| curve.point(f64::from(i) * TAU / f64::from(SAMPLES)));
        points.extend(samples.filter(|&at| inside(at, own)).map(|at| view.project(at)));
    }
    let edge = surface.sphere_point(cross(planes[0], planes[1]));
    for side in [-1.0, 1.0] {
        points.push(view.project(surface.point(edge * (side / edge.norm()))));
    }
    points
}

/// The convex hull, by monotone chains.
fn hull(mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let mut ring: Vec<[f64; 2]> = Vec::new();
    for _ in 0..2 {
        let base = ring.len();
        for &point in &points {
            while ring.len() >= base + 2 && !turns_left(&ring, point) {
                ring.pop();
            }
            ring.push(point);
        }
        ring.pop();
        points.reverse();
    }
    ring
}

fn turns_left(ring: &[[f64; 2]], c: [f64; 2]) -> bool {
    let [.., a, b] = ring else { return true };
    (b[0] - a[0]) * (c[1] - a[1]) > (b[1] - a[1]) * (c[0] - a[0])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::energy::surface::EnergySpace::{Twist, Wrench};
    use crate::error::Input;

    /// Hundreds of operations on numbers from 0.1 to 10, some of which cancel a digit or two.
    const ROUNDING: f64 = 4096.0 * f64::EPSILON;

    /// One energy in two frames: the second is sheared by what a shift of the origin does.
    ///
    /// About the first, the form is `2 x^2 + 3 y^2 + 4 z^2 = 2` in both spaces.
    fn pair(space: EnergySpace) -> [EnergySurface; 2] {
        let (y, z) = ((2.0_f64 / 3.0).sqrt(), 0.5_f64.sqrt());
        let upright = [[1.0, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]];
        let slanted = match space {
            Twist => [[1.0, 0.0, 0.0], [0.0, y, 0.0], [-0.5 * z, 0.5 * z, z]],
            Wrench => [[1.0, 0.0, -0.5], [0.0, y, y], [0.0, 0.0, z]],
        };
        [upright, slanted].map(|points| {
            EnergySurface::new(points, space, Input::Upright).expect("three points of an ellipsoid")
        })
    }

    #[test]
    fn the_difference_of_the_forms_is_the_product_of_the_planes() {
        for space in [Twist, Wrench] {
            let [first, second] = pair(space);
            let [p, q] = meeting_planes(&[first, second], space).expect("two frames");
            let scale = |x: Vector<3>| {
                let (a, b) = (first.sphere_point(x), second.sphere_point(x));
                (b.dot(b) - a.dot(a)) / (p.dot(x) * q.dot(x))
            };
            let reference = scale([1.0, 0.3, -0.6].into());
            assert!(reference > 0.0);
            for x in [[0.2, -1.0, 0.4], [-0.5, -0.7, 1.1], [2.0, 0.1, 0.3]] {
                assert!((scale(x.into()) / reference - 1.0).abs() < ROUNDING, "{space:?} {x:?}");
            }
        }
    }

    #[test]
    fn the_last_piece_over_a_page_point_belongs_to_the_nearer_surface() {
        let view = View::from_angles(38.0, 20.0);
        for space in [Twist, Wrench] {
            let surfaces = pair(space);
            let planes = meeting_planes(&surfaces, space).expect("two frames");
            let pieces = pieces(&surfaces, planes, &view);
            let mut compared = 0;
            for (i, j) in (-20..=20).flat_map(|i| (-20..=20).map(move |j| (i, j))) {
                let page = [f64::from(i) * 0.061, f64::from(j) * 0.061];
                let depths = surfaces.map(|surface| depth(&surface, page, &view));
                // Hulls are polygons: within their sagitta of an edge either may show.
                if (depths[0] - depths[1]).abs() < 0.02 || depths.iter().any(|d| d.is_nan()) {
                    continue;
                }
                let shown = pieces.iter().rev().find(|(_, ring)| contains(ring, page));
                let nearer = usize::from(depths[1] > depths[0]);
                assert_eq!(shown.map(|(surface, _)| *surface), Some(nearer), "{space:?} {page:?}");
                compared += 1;
            }
            assert!(compared > 200, "{compared}");
        }
    }

    /// How near to the eye the line of sight first meets a surface; NaN if it misses.
    fn depth(surface: &EnergySurface, page: [f64; 2], view: &View) -> f64 {
        let foot = view.right * page[0] + view.up * page[1];
        let (y, u) = (surface.sphere_point(foot), surface.sphere_point(view.eye));
        let (a, b, c) = (u.dot(u), y.dot(u), y.dot(y) - 1.0);
        (-b + (b * b - a * c).sqrt()) / a
    }

    fn contains(ring: &[[f64; 2]], p: [f64; 2]) -> bool {
        (0..ring.len()).all(|i| {
            let (a, b) = (ring[i], ring[(i + 1) % ring.len()]);
            (b[0] - a[0]) * (p[1] - a[1]) >= (b[1] - a[1]) * (p[0] - a[0])
        })
    }
}
