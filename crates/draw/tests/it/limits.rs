//! Degenerate and extreme input: each fault with its error, each proper picture drawn.

use std::f64::consts::PI;

use clench_draw::{
    Color, DrawError, EnergyEllipsoids, EnergySpace, Finger, GraspPicture, Input, Mark, Region,
};

use crate::paper::{CENTER, ellipsoids, grasp, stiffness};
use crate::svg::assert_well_formed;

/// The input and index of a number that is not finite.
fn not_finite<T: std::fmt::Debug>(result: Result<T, DrawError>) -> (Input, usize) {
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
    let region = Region { corners: vec![CENTER], color: Color::INK };
    assert_eq!(fault(&|p| p.regions.push(region.clone())), few(Input::Region(1), 1));
    assert_eq!(
        fault(&|p| p.fingers[2].inward_normal = [0.0, 2.0]),
        Some(DrawError::NormalNotUnit { finger: 2, length: 2.0 })
    );
    let negative = DrawError::NegativeRadius { finger: 0, radius: -1.0 };
    assert_eq!(fault(&|p| p.fingers[0].radius = -1.0), Some(negative));
    assert_eq!(fault(&|p| p.center = None), Some(DrawError::ReachWithoutCenter));
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
    assert_eq!(fault(&|p| p.notes[0].point = far), (Input::Note, 0));
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

#[test]
fn ellipsoids_refuse_matrices_that_are_no_energy() {
    let fault = |i: usize, j: usize, value: f64| {
        let mut slanted = stiffness([0.0, 0.0]);
        slanted[i][j] = value;
        EnergyEllipsoids::new(EnergySpace::Twist, stiffness(CENTER), slanted).figure().err()
    };
    let input = Input::Slanted;
    assert!(matches!(
        fault(1, 2, f64::NAN),
        Some(DrawError::NotFinite { input: Input::Slanted, index: 5, .. })
    ));
    // K12 about the origin is (K11 J^T d): its first entry is about -9.8, never 100.
    assert!(matches!(
        fault(0, 2, 100.0),
        Some(DrawError::NotSymmetric { input: Input::Slanted, row: 0, column: 2, .. })
    ));
    let pivot = |pivot, value| Some(DrawError::NotPositiveDefinite { input, pivot, value });
    assert_eq!(fault(0, 0, -1.0), pivot(0, -1.0));
    assert!(matches!(fault(1, 1, 0.001), Some(DrawError::NotPositiveDefinite { pivot: 1, .. })));
    assert!(matches!(fault(2, 2, 1.0), Some(DrawError::NotPositiveDefinite { pivot: 2, .. })));
}

#[test]
fn a_wrench_matrix_is_eliminated_from_its_torque() {
    let fault = |diagonal: [f64; 3]| {
        let matrix = [0, 1, 2].map(|i| [0, 1, 2].map(|j| if i == j { diagonal[i] } else { 0.0 }));
        EnergyEllipsoids::new(EnergySpace::Wrench, matrix, matrix).figure().err()
    };
    let pivot =
        |pivot| Some(DrawError::NotPositiveDefinite { input: Input::Upright, pivot, value: -1.0 });
    assert_eq!(fault([1.0, 1.0, -1.0]), pivot(0));
    assert_eq!(fault([-1.0, 1.0, 1.0]), pivot(1));
    assert_eq!(fault([1.0, -1.0, 1.0]), pivot(2));
    assert_eq!(fault([1.0, 1.0, 1.0]), None);
}

#[test]
fn ellipsoids_refuse_frames_that_do_not_match() {
    let (upright, slanted) = (stiffness(CENTER), stiffness([0.0, 0.0]));
    let swapped = EnergyEllipsoids::new(EnergySpace::Twist, slanted, upright);
    assert!(matches!(swapped.figure(), Err(DrawError::NotUpright { coupling }) if coupling > 0.1));
    let mut stiffer = slanted;
    stiffer[2][2] += 1.0;
    let different = EnergyEllipsoids::new(EnergySpace::Twist, upright, stiffer);
    assert!(matches!(
        different.figure(),
        Err(DrawError::DifferentGrasps { upright, slanted }) if slanted < upright
    ));
}

#[test]
fn ellipsoids_of_one_frame_and_of_far_frames_are_drawn() -> Result<(), DrawError> {
    let upright = stiffness(CENTER);
    for origin in [CENTER, [CENTER[0], 0.0], [CENTER[0] + 1e-7, CENTER[1]], [300.0, -200.0]] {
        let picture = EnergyEllipsoids::new(EnergySpace::Twist, upright, stiffness(origin));
        assert_well_formed(&picture.figure()?.to_svg());
    }
    for unit in [1e-9, 1e9] {
        let mut picture = ellipsoids(EnergySpace::Wrench);
        for matrix in [&mut picture.upright, &mut picture.slanted] {
            *matrix = matrix.map(|row| row.map(|value| value * unit));
        }
        assert_well_formed(&picture.figure()?.to_svg());
    }
    Ok(())
}
