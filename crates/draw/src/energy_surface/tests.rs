//! The points the ellipsoids are drawn through lie where they should.

use std::f64::consts::TAU;

use clench_screw::{Frame, Stiffness};

use super::*;
use crate::energy_ellipsoids::EnergyEllipsoids;

const CENTER: [f64; 2] = [80.0 / 13.0, 72.0 / 13.0];

/// The stiffness of the paper's Figures 1 and 2, about an origin.
fn stiffness(origin: [f64; 2]) -> [[f64; 3]; 3] {
    let about_corner = Stiffness::<2, 1> {
        translational: [[1.7, 0.1], [0.1, 2.3]].into(),
        coupling: [[-8.8], [13.6]].into(),
        rotational: [[218.8]].into(),
    };
    let k = about_corner.in_frame(&Frame::at(origin.into()));
    *Mat::<3, 3>::from_fn(|i, j| k.entry(i, j)).rows()
}

fn ellipsoids(space: EnergySpace) -> EnergyEllipsoids {
    let (upright, slanted) = (stiffness(CENTER), stiffness([0.0, 0.0]));
    let compliance = |k: [[f64; 3]; 3]| {
        *Cholesky::new(&k.into()).expect("four springs hold the part").inverse().rows()
    };
    match space {
        EnergySpace::Twist => EnergyEllipsoids::new(space, upright, slanted),
        EnergySpace::Wrench => {
            EnergyEllipsoids::new(space, compliance(upright), compliance(slanted))
        }
    }
}

/// Entries of K are at most 250 and points at most 2: a quadratic form sums nine products of
/// at most 500 that cancel to 2, each right to a few units of 1e-16 times the condition of K.
const TOLERANCE: f64 = 65536.0 * f64::EPSILON;

fn times(matrix: [[f64; 3]; 3], x: Vector<3>) -> Vector<3> {
    Mat::new(matrix) * x
}

fn points(curve: SpaceEllipse) -> impl Iterator<Item = Vector<3>> {
    (0..36).map(move |i| curve.point(f64::from(i) * TAU / 36.0))
}

#[test]
fn every_curve_lies_on_its_quadric() -> Result<(), DrawError> {
    for space in [EnergySpace::Twist, EnergySpace::Wrench] {
        let picture = ellipsoids(space);
        for (surface, matrix) in picture.surfaces()?.iter().zip([picture.upright, picture.slanted])
        {
            let curves = [-1.0, -0.5, 0.0, 0.3, 1.0].map(|height| surface.latitude(height));
            let more = [0.0, 0.7, 2.0].map(|longitude| surface.meridian(longitude));
            let sights = [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.4, -0.7, 0.5]].map(Vector::new);
            let outlines = sights.map(|sight| surface.silhouette(sight));
            for point in curves.into_iter().chain(more).chain(outlines).flat_map(points) {
                let form = point.dot(times(matrix, point));
                assert!((form - 2.0).abs() < TOLERANCE, "{form} in {space:?}");
            }
            for (sight, outline) in sights.into_iter().zip(outlines) {
                for point in points(outline) {
                    // The line of sight is tangent: it is perpendicular to the gradient.
                    let slope = sight.dot(times(matrix, point));
                    let scale = sight.dot(times(matrix, sight)).sqrt();
                    assert!(slope.abs() < TOLERANCE * scale, "{slope} in {space:?}");
                }
            }
        }
    }
    Ok(())
}

#[test]
fn twist_sections_are_congruent_and_the_planes_bound_both() -> Result<(), DrawError> {
    let picture = ellipsoids(EnergySpace::Twist);
    let [upright, slanted] = picture.surfaces()?;
    for height in [-0.8, 0.0, 0.45] {
        let (a, b) = (upright.latitude(height), slanted.latitude(height));
        let shift = b.center - a.center;
        assert!(shift[2].abs() < TOLERANCE);
        for (p, q) in points(a).zip(points(b)) {
            assert!((p + shift - q).max_abs() < TOLERANCE);
        }
    }
    // About the center of compliance, mu is the last entry of K.
    let top = (2.0 / stiffness(CENTER)[2][2]).sqrt();
    for (surface, matrix) in [(upright, picture.upright), (slanted, picture.slanted)] {
        assert!((surface.half_extents()[2] - top).abs() < TOLERANCE);
        let pole = surface.columns()[2];
        assert!((pole[2] - top).abs() < TOLERANCE);
        let gradient = times(matrix, pole);
        assert!(gradient[0].hypot(gradient[1]) < TOLERANCE * gradient[2]);
    }
    Ok(())
}

#[test]
fn the_sections_have_the_papers_semi_axes() -> Result<(), DrawError> {
    // sigma_min = 1.683772, and the trace of K11 for four unit springs is 4.
    let [upright, _] = ellipsoids(EnergySpace::Twist).surfaces()?;
    let [short, long, _] = upright.columns().map(|axis| axis[0].hypot(axis[1]));
    assert!((long - (2.0_f64 / 1.683_772).sqrt()).abs() < 5e-7);
    assert!((short - (2.0_f64 / (4.0 - 1.683_772)).sqrt()).abs() < 5e-7);
    Ok(())
}

#[test]
fn wrench_ellipsoids_share_a_cylinder_and_their_points_on_the_axis() -> Result<(), DrawError> {
    let picture = ellipsoids(EnergySpace::Wrench);
    let [upright, slanted] = picture.surfaces()?;
    for (p, q) in points(upright.latitude(0.0)).zip(points(slanted.latitude(0.0))) {
        assert!((p[0] - q[0]).abs() < TOLERANCE && (p[1] - q[1]).abs() < TOLERANCE);
        // The vertical is tangent where the cylinder touches.
        assert!(times(picture.slanted, q)[2].abs() < TOLERANCE);
    }
    let top = (2.0 * stiffness(CENTER)[2][2]).sqrt();
    let on_axis = |surface: &EnergySurface| {
        let [x, y, z] = surface.point(Vector::new([0.0, 0.0, 1.0])).to_array();
        x.hypot(y) < TOLERANCE && (z - top).abs() < TOLERANCE * top
    };
    assert!(on_axis(&upright) && on_axis(&slanted));
    Ok(())
}
