//! The points the ellipsoids are drawn through lie where they should.

use std::f64::consts::TAU;

use clench_screw::{Cholesky, Frame, Stiffness};

use super::*;
use crate::energy::EnergyEllipsoids;

const CENTER: [f64; 2] = [80.0 / 13.0, 72.0 / 13.0];

/// The stiffness of the paper's Figures 1 and 2 about an origin.
fn stiffness(origin: [f64; 2]) -> Mat<3, 3> {
    let about_corner = Stiffness::<2, 1> {
        translational: [[1.7, 0.1], [0.1, 2.3]].into(),
        coupling: [[-8.8], [13.6]].into(),
        rotational: [[218.8]].into(),
    };
    let k = about_corner.in_frame(&Frame::at(origin.into()));
    Mat::from_fn(|i, j| k.entry(i, j))
}

/// Its surfaces about the center of compliance and about the origin.
fn surfaces(space: EnergySpace) -> Result<[EnergySurface; 2], DrawError> {
    let [upright, slanted] = [CENTER, [0.0, 0.0]].map(|origin| points(space, origin));
    EnergyEllipsoids::new(space, upright, slanted).surfaces()
}

/// By hand: the blocks of K about the corner give `mu = 5614 / 65`, and K11 is twice the identity
/// and a tenth of `[[-3, 1], [1, 3]]`, whose eigenvectors are `(1, 3 +- sqrt(10))`.
fn points(space: EnergySpace, origin: [f64; 2]) -> [[f64; 3]; 3] {
    let mu = 5614.0_f64 / 65.0;
    let sigma = [2.0 - 0.1_f64.sqrt(), 2.0 + 0.1_f64.sqrt()];
    let stiff = Vector::new([1.0, 3.0 + 10.0_f64.sqrt()]);
    let stiff = stiff * (1.0 / stiff.norm());
    let axes = [[-stiff[1], stiff[0]], [stiff[0], stiff[1]]];
    // The velocity of the origin when the part turns about the center.
    let carried = [CENTER[1] - origin[1], origin[0] - CENTER[0]];
    let at = |i: usize| match space {
        EnergySpace::Twist => {
            let length = (2.0 / sigma[i]).sqrt();
            [length * axes[i][0], length * axes[i][1], 0.0]
        }
        EnergySpace::Wrench => {
            let [x, y] = axes[i].map(|value| (2.0 * sigma[i]).sqrt() * value);
            [x, y, -carried[0] * x - carried[1] * y]
        }
    };
    let height = (2.0 / mu).sqrt();
    let pole = match space {
        EnergySpace::Twist => [height * carried[0], height * carried[1], height],
        EnergySpace::Wrench => [0.0, 0.0, (2.0 * mu).sqrt()],
    };
    [at(0), at(1), pole]
}

/// The value and half the gradient of the form that is 2 on the surface: of K, or of its inverse.
fn form(space: EnergySpace, origin: [f64; 2], x: Vector<3>) -> (f64, Vector<3>) {
    let k = stiffness(origin);
    let gradient = match space {
        EnergySpace::Twist => k * x,
        EnergySpace::Wrench => Cholesky::new(&k).expect("four springs hold the part").solve(x),
    };
    (x.dot(gradient), gradient)
}

/// Entries of K are at most 250 and points at most 2: a quadratic form sums nine products of
/// at most 500 that cancel to 2, each right to a few units of 1e-16 times the condition of K.
const TOLERANCE: f64 = 65536.0 * f64::EPSILON;

fn along(curve: SpaceEllipse) -> impl Iterator<Item = Vector<3>> {
    (0..36).map(move |i| curve.point(f64::from(i) * TAU / 36.0))
}

#[test]
fn every_curve_lies_on_its_quadric() -> Result<(), DrawError> {
    for space in [EnergySpace::Twist, EnergySpace::Wrench] {
        for (surface, origin) in surfaces(space)?.iter().zip([CENTER, [0.0, 0.0]]) {
            let curves = [-1.0, -0.5, 0.0, 0.3, 1.0].map(|height| surface.latitude(height));
            let more = [0.0, 0.7, 2.0].map(|longitude| surface.meridian(longitude));
            let sights = [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.4, -0.7, 0.5]].map(Vector::new);
            let outlines = sights.map(|sight| surface.silhouette(sight));
            for point in curves.into_iter().chain(more).chain(outlines).flat_map(along) {
                let (value, _) = form(space, origin, point);
                assert!((value - 2.0).abs() < TOLERANCE, "{value} in {space:?}");
                let rebuilt = point.dot(surface.half_matrix() * point);
                assert!((rebuilt - 1.0).abs() < TOLERANCE, "{rebuilt} in {space:?}");
            }
            for (sight, outline) in sights.into_iter().zip(outlines) {
                for point in along(outline) {
                    // The line of sight is tangent: it is perpendicular to the gradient.
                    let slope = sight.dot(form(space, origin, point).1);
                    let scale = form(space, origin, sight).0.sqrt();
                    assert!(slope.abs() < TOLERANCE * scale, "{slope} in {space:?}");
                }
            }
        }
    }
    Ok(())
}

#[test]
fn twist_sections_are_congruent_and_the_planes_bound_both() -> Result<(), DrawError> {
    let [upright, slanted] = surfaces(EnergySpace::Twist)?;
    for height in [-0.8, 0.0, 0.45] {
        let (a, b) = (upright.latitude(height), slanted.latitude(height));
        let shift = b.center - a.center;
        assert!(shift[2].abs() < TOLERANCE);
        for (p, q) in along(a).zip(along(b)) {
            assert!((p + shift - q).max_abs() < TOLERANCE);
        }
    }
    // About the center of compliance, mu is the last entry of K.
    let top = (2.0 / stiffness(CENTER)[2][2]).sqrt();
    for (surface, origin) in [(upright, CENTER), (slanted, [0.0, 0.0])] {
        assert!((surface.half_extents()[2] - top).abs() < TOLERANCE);
        let pole = surface.columns()[2];
        assert!((pole[2] - top).abs() < TOLERANCE);
        let (_, gradient) = form(EnergySpace::Twist, origin, pole);
        assert!(gradient[0].hypot(gradient[1]) < TOLERANCE * gradient[2]);
    }
    Ok(())
}

#[test]
fn wrench_ellipsoids_share_a_cylinder_and_their_points_on_the_axis() -> Result<(), DrawError> {
    let [upright, slanted] = surfaces(EnergySpace::Wrench)?;
    for (p, q) in along(upright.latitude(0.0)).zip(along(slanted.latitude(0.0))) {
        assert!((p[0] - q[0]).abs() < TOLERANCE && (p[1] - q[1]).abs() < TOLERANCE);
        // The vertical is tangent where the cylinder touches.
        let (_, gradient) = form(EnergySpace::Wrench, [0.0, 0.0], q);
        assert!(gradient[2].abs() < TOLERANCE);
    }
    let top = (2.0 * stiffness(CENTER)[2][2]).sqrt();
    let on_axis = |surface: &EnergySurface| {
        let [x, y, z] = surface.point(Vector::new([0.0, 0.0, 1.0])).to_array();
        x.hypot(y) < TOLERANCE && (z - top).abs() < TOLERANCE * top
    };
    assert!(on_axis(&upright) && on_axis(&slanted));
    Ok(())
}

#[test]
fn the_opposite_points_give_the_same_surface() -> Result<(), DrawError> {
    for space in [EnergySpace::Twist, EnergySpace::Wrench] {
        let given = points(space, [0.0, 0.0]);
        let surface = EnergySurface::new(given, space, Input::Slanted)?;
        let [a, b, pole] = given;
        let turned = EnergySurface::new([a, b, pole.map(|x| -x)], space, Input::Slanted)?;
        assert_eq!(turned, surface);
        assert!(surface.columns()[2][2] > 0.0);
    }
    Ok(())
}
