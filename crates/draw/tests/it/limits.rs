//! Degenerate and extreme input: each fault with its error, each proper picture drawn.

use std::f64::consts::PI;

use clench_draw::{
    Color, DrawError, EnergyEllipsoids, EnergySpace, Finger, GraspPicture, Input, Mark, Region,
};

use crate::paper::{CENTER, ellipsoids, grasp, points};
use crate::svg::assert_well_formed;

/// The input and index of a number that is not finite.
pub(crate) fn not_finite<T: std::fmt::Debug>(result: Result<T, DrawError>) -> (Input, usize) {
    match result {
        Err(DrawError::NotFinite { input, index, value }) if !value.is_finite() => (input, index),
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_grasp_picture_says_which_field_is_not_finite() {
    let bad = [0.0, f64::NEG_INFINITY];
    let fault = |change: &dyn Fn(&mut GraspPicture)| {
        let mut picture = grasp(1.0);
        change(&mut picture);
        not_finite(picture.figure())
    };
    assert_eq!(fault(&|p| p.outline[2] = bad), (Input::Outline, 2));
    assert_eq!(fault(&|p| p.fingers[3].point = bad), (Input::FingerPoint, 3));
    assert_eq!(fault(&|p| p.fingers[1].inward_normal = bad), (Input::FingerNormal, 1));
    assert_eq!(fault(&|p| p.fingers[1].radius = f64::NAN), (Input::FingerRadius, 1));
    assert_eq!(fault(&|p| p.farthest_corner = Some(bad)), (Input::FarthestCorner, 0));
    assert_eq!(fault(&|p| p.regions[0].corners[1] = bad), (Input::Region(0), 1));
    assert_eq!(fault(&|p| p.ways[0].points[2] = bad), (Input::Way(0), 2));
    assert_eq!(fault(&|p| p.notes[0].point = bad), (Input::Note, 0));
    let center = Mark { point: bad, label: String::new() };
    assert_eq!(fault(&|p| p.center = Some(center.clone())), (Input::Center, 0));
}

#[test]
fn a_grasp_picture_refuses_what_is_not_a_grasp() {
    let fault = |change: &dyn Fn(&mut GraspPicture)| {
        let mut picture = grasp(1.0);
        change(&mut picture);
        picture.figure().err()
    };
    let few = |input, found| Some(DrawError::TooFewPoints { input, found, needed: 3 });
    assert_eq!(fault(&|p| p.outline.truncate(2)), few(Input::Outline, 2));
    let short = DrawError::TooFewPoints { input: Input::Way(0), found: 1, needed: 2 };
    assert_eq!(fault(&|p| p.ways[0].points.truncate(1)), Some(short));
    let region = Region { corners: vec![CENTER], color: Color::INK };
    assert_eq!(fault(&|p| p.regions.push(region.clone())), few(Input::Region(1), 1));
    assert_eq!(
        fault(&|p| p.fingers[2].inward_normal = [0.0, 2.0]),
        Some(DrawError::NormalNotUnit { finger: 2, length: 2.0 })
    );
    let negative = DrawError::NegativeRadius { finger: 0, radius: -1.0 };
    assert_eq!(fault(&|p| p.fingers[0].radius = -1.0), Some(negative));
    assert_eq!(fault(&|p| p.center = None), Some(DrawError::ReachWithoutCenter));
    let none = |input| Some(DrawError::NoDirection { input, index: 0 });
    assert_eq!(fault(&|p| p.directions[0].along = [0.0, 2.0]), none(Input::Direction));
    assert_eq!(fault(&|p| p.loads[0].along = [0.0; 2]), none(Input::LoadDirection));
}

#[test]
fn a_grasp_picture_refuses_what_no_page_can_show() {
    let far = [1e9, 0.0];
    let fault = |change: &dyn Fn(&mut GraspPicture)| {
        let mut picture = grasp(1.0);
        change(&mut picture);
        match picture.figure() {
            Err(DrawError::OffPage { input, index, distance }) if distance > 1e6 => (input, index),
            other => panic!("{other:?}"),
        }
    };
    assert_eq!(fault(&|p| p.farthest_corner = Some(far)), (Input::FarthestCorner, 0));
    assert_eq!(fault(&|p| p.ways[0].points[1] = far), (Input::Way(0), 1));
    assert_eq!(fault(&|p| p.notes[0].point = far), (Input::Note, 0));
    assert_eq!(fault(&|p| p.loads[0].point = far), (Input::LoadPoint, 0));
    let throw = |p: &mut GraspPicture| p.displaced.iter_mut().for_each(|d| d.shifts[2] = far);
    assert_eq!(fault(&throw), (Input::Displaced, 2));
    assert_eq!(fault(&|p| p.regions[0].corners[2] = far), (Input::Region(0), 2));
    let mut wide = grasp(1.0);
    (wide.outline[0][1], wide.outline[2][1]) = (-1.7e308, 1.7e308);
    assert_eq!(not_finite(wide.figure()), (Input::Extent, 1));
}

#[test]
fn a_part_of_one_point_may_be_held_by_a_disc_of_any_size() -> Result<(), DrawError> {
    for radius in [1e-300, 1.0, 1e300] {
        let finger = Finger { inward_normal: [0.0, 1.0], radius, ..Finger::default() };
        let picture = GraspPicture {
            outline: vec![[0.0, 0.0]; 3],
            fingers: vec![finger],
            ..GraspPicture::default()
        };
        assert_well_formed(&picture.figure()?.to_svg());
    }
    Ok(())
}

#[test]
fn a_part_of_any_size_is_drawn() -> Result<(), DrawError> {
    for unit in [1e-300, 1e300, 1e306] {
        assert_well_formed(&grasp(unit).figure()?.to_svg());
    }
    Ok(())
}

#[test]
fn an_outline_of_one_point_or_of_many_corners_is_drawn() -> Result<(), DrawError> {
    let point = GraspPicture {
        outline: vec![[2.0, 2.0]; 3],
        corner_labels: vec!["A".into()],
        ..GraspPicture::default()
    };
    assert_well_formed(&point.figure()?.to_svg());
    let smooth = GraspPicture {
        outline: (0..500).map(|i| (f64::from(i) * PI / 250.0).sin_cos().into()).collect(),
        ..GraspPicture::default()
    };
    assert_well_formed(&smooth.figure()?.to_svg());
    Ok(())
}

/// What is wrong with an ellipsoid of the paper's grasp after a change to its points.
fn energy_fault(space: EnergySpace, change: impl FnOnce(&mut [[f64; 3]; 3])) -> Option<DrawError> {
    let mut picture = ellipsoids(space);
    change(&mut picture.slanted);
    picture.figure().err()
}

#[test]
fn ellipsoids_refuse_points_that_are_not_finite() {
    for point in 0..3 {
        assert!(matches!(
            energy_fault(EnergySpace::Twist, |points| points[point][1] = f64::NAN),
            Some(DrawError::NotFinite { input: Input::Slanted, index, .. }) if index == point
        ));
    }
    let mut picture = ellipsoids(EnergySpace::Wrench);
    picture.upright[2][2] = f64::INFINITY;
    let value = f64::INFINITY;
    let fault = DrawError::NotFinite { input: Input::Upright, index: 2, value };
    assert_eq!(picture.figure().err(), Some(fault));
}

#[test]
fn ellipsoids_refuse_points_of_another_form() {
    let input = Input::Slanted;
    let triangular = |point, coordinate, value| {
        Some(DrawError::NotTriangular { input, point, coordinate, value })
    };
    // Sections of twists are level, and the pole of wrenches has no force.
    let twist = |i: usize, j: usize| energy_fault(EnergySpace::Twist, |points| points[i][j] = 0.5);
    assert_eq!(twist(0, 2), triangular(0, 2, 0.5));
    assert_eq!(twist(1, 2), triangular(1, 2, 0.5));
    let wrench =
        |i: usize, j: usize| energy_fault(EnergySpace::Wrench, |points| points[i][j] = 0.5);
    assert_eq!(wrench(2, 0), triangular(2, 0, 0.5));
    assert_eq!(wrench(2, 1), triangular(2, 1, 0.5));
    for space in [EnergySpace::Twist, EnergySpace::Wrench] {
        // Conjugate half-diameters of the same ellipse, which are not its axes.
        let sheared = energy_fault(space, |points| {
            let half = 0.5_f64.sqrt();
            let [a, b, _] = *points;
            points[0] = [0, 1, 2].map(|i| half * (a[i] + b[i]));
            points[1] = [0, 1, 2].map(|i| half * (a[i] - b[i]));
        });
        assert!(matches!(
            sheared,
            Some(DrawError::NotSemiAxes { input: Input::Slanted, cosine }) if cosine.abs() > 0.1
        ));
    }
}

#[test]
fn ellipsoids_refuse_to_be_flat() {
    for space in [EnergySpace::Twist, EnergySpace::Wrench] {
        let flat = |point| Some(DrawError::Flat { input: Input::Slanted, point });
        for point in 0..2 {
            let thin = |factor: f64| {
                energy_fault(space, |points| points[point] = points[point].map(|x| factor * x))
            };
            assert_eq!(thin(0.0), flat(point));
            assert_eq!(thin(1e-4), flat(point));
        }
        assert_eq!(energy_fault(space, |points| points[2] = [0.0; 3]), flat(2));
    }
}

#[test]
fn ellipsoids_refuse_frames_that_do_not_match() {
    for space in [EnergySpace::Twist, EnergySpace::Wrench] {
        let (upright, slanted) = (points(space, CENTER), points(space, [0.0, 0.0]));
        let swapped = EnergyEllipsoids::new(space, slanted, upright).figure();
        assert!(matches!(swapped, Err(DrawError::NotUpright { lean }) if lean > 0.1));
        let larger = energy_fault(space, |points| points[2] = points[2].map(|x| 1.1 * x));
        assert!(matches!(
            larger,
            Some(DrawError::DifferentGrasps { upright, slanted }) if slanted > 1.05 * upright
        ));
        // The lengths of the semi-axes agree, their directions do not.
        let turned = energy_fault(space, |points| {
            for [x, y, _] in points {
                (*x, *y) = (*y, -*x);
            }
        });
        assert!(matches!(turned, Some(DrawError::DifferentGrasps { .. })), "{turned:?}");
    }
}

#[test]
fn ellipsoids_of_one_frame_and_of_far_frames_are_drawn() -> Result<(), DrawError> {
    for space in [EnergySpace::Twist, EnergySpace::Wrench] {
        for origin in [CENTER, [CENTER[0], 0.0], [CENTER[0] + 1e-7, CENTER[1]], [300.0, -200.0]] {
            let picture =
                EnergyEllipsoids::new(space, points(space, CENTER), points(space, origin));
            assert_well_formed(&picture.figure()?.to_svg());
        }
    }
    Ok(())
}

#[test]
fn ellipsoids_of_any_size_are_drawn_or_refused() -> Result<(), DrawError> {
    let scaled = |unit: f64| {
        let mut picture = ellipsoids(EnergySpace::Wrench);
        for points in [&mut picture.upright, &mut picture.slanted] {
            *points = points.map(|point| point.map(|value| value * unit));
        }
        picture.figure()
    };
    for unit in [1e-300, 1e-9, 1e9, 1e300] {
        assert_well_formed(&scaled(unit)?.to_svg());
    }
    assert_eq!(not_finite(scaled(1e-310)), (Input::Extent, 0));
    // The torques are 17.8 units at most, and the whole is 20.9 units high to either side.
    assert_eq!(not_finite(scaled(9e306)), (Input::Extent, 1));
    Ok(())
}
