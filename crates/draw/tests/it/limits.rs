//! Degenerate and extreme input: each fault with its error, each proper picture drawn.

use std::f64::consts::PI;

use clench_draw::{
    Circle, Color, DrawError, EllipseArc, EnergyEllipsoids, EnergySpace, Figure, GraspPicture,
    Mark, Paint, Place, Region, Stroke, Text,
};

use crate::paper::{CENTER, OUTLINE, ellipsoids, grasp, stiffness};
use crate::svg::assert_well_formed;

const INK: Stroke = Stroke::solid(Color::INK, 1.0);

fn canvas() -> Figure {
    Figure::new([[0.0, 0.0], [1.0, 1.0]], [100.0, 100.0]).expect("proper bounds")
}

/// The place and index of a number that is not finite.
fn not_finite<T: std::fmt::Debug>(result: Result<T, DrawError>) -> (Place, usize) {
    match result {
        Err(DrawError::NotFinite { place, index, value }) if !value.is_finite() => (place, index),
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_figure_refuses_what_is_not_finite_and_says_where() {
    let bad = [f64::NAN, 0.0];
    let mut figure = canvas();
    let bounds = [[0.0, 0.0], [1.0, f64::INFINITY]];
    assert_eq!(not_finite(Figure::new(bounds, [9.0, 9.0])), (Place::Bounds, 3));
    let polygon = figure.polygon(&[[0.0, 0.0], [1.0, 0.0], bad], &Paint::stroke(INK));
    assert_eq!(not_finite(polygon), (Place::Polygon, 2));
    assert_eq!(not_finite(figure.polyline(&[[0.0, 0.0], bad], INK)), (Place::Polyline, 1));
    assert_eq!(not_finite(figure.disc(bad, 1.0, &Paint::default())), (Place::Disc, 0));
    assert_eq!(not_finite(figure.arrow([0.0, 0.0], bad, INK)), (Place::Arrow, 1));
    assert_eq!(not_finite(figure.text(bad, [0.0, 0.0], &Text::new("a", 9.0))), (Place::Text, 0));
    assert_eq!(not_finite(figure.caption(bad, &Text::new("a", 9.0))), (Place::Text, 0));
    let circle = EllipseArc::circle([0.0, 0.0], 1.0);
    let arc = figure.arc(&circle.between(0.0, f64::NAN), &Paint::stroke(INK));
    assert_eq!(not_finite(arc), (Place::Arc, 3));
    let shaded = figure.shaded_polygon(&OUTLINE, &EllipseArc::circle(bad, 1.0), Color::INK);
    assert_eq!(not_finite(shaded), (Place::Arc, 0));
    assert_well_formed(&figure.to_svg());
}

#[test]
fn a_figure_refuses_sizes_that_are_none() {
    let size = |place, index, value| DrawError::NotASize { place, index, value };
    let page = Figure::new([[0.0, 0.0], [1.0, 1.0]], [9.0, 0.0]);
    assert_eq!(page.err(), Some(size(Place::Bounds, 1, 0.0)));
    let disc = canvas().disc([0.0, 0.0], -1.0, &Paint::default());
    assert_eq!(disc.err(), Some(size(Place::PageLength, 0, -1.0)));
    let line = canvas().polyline(&OUTLINE, Stroke::dashed(Color::INK, 0.0));
    assert_eq!(line.err(), Some(size(Place::PageLength, 0, 0.0)));
    let flat = EllipseArc::ellipse([0.0, 0.0], [[1.0, 0.0], [-2.0, 0.0]]);
    let shaded = canvas().shaded_polygon(&OUTLINE, &flat, Color::INK);
    assert_eq!(shaded.err(), Some(size(Place::Arc, 1, 0.0)));
    let huge = canvas().caption([0.0, 0.0], &Text::new("a", 1e300));
    assert_eq!(huge.err(), Some(size(Place::PageLength, 0, 1e300)));
    let text = canvas().caption([0.0, 0.0], &Text::new("a", 0.0));
    assert_eq!(text.err(), Some(size(Place::PageLength, 0, 0.0)));
}

#[test]
fn a_figure_refuses_too_few_points_and_points_off_every_page() {
    let few = canvas().polygon(&OUTLINE[..2], &Paint::stroke(INK));
    let expected = DrawError::TooFewPoints { place: Place::Polygon, found: 2, needed: 3 };
    assert_eq!(few.err(), Some(expected));
    let far = canvas().polyline(&[[0.0, 0.0], [1e6, 0.0]], INK);
    let distance = 1e8;
    let expected = DrawError::OffPage { place: Place::Polyline, index: 1, distance };
    assert_eq!(far.err(), Some(expected));
    let caption = canvas().caption([0.0, -2e6], &Text::new("a", 9.0));
    let expected = DrawError::OffPage { place: Place::Text, index: 0, distance: 2e6 };
    assert_eq!(caption.err(), Some(expected));
}

#[test]
fn bounds_without_extent_and_of_any_size_give_a_picture() -> Result<(), DrawError> {
    let boxes = [
        [[0.0, 0.0], [0.0, 0.0]],
        [[3.0, 5.0], [3.0, 5.0]],
        [[0.0, 0.0], [0.0, 1.0]],
        [[-1e-9, 0.0], [1e-9, 1e-9]],
        [[-1e9, 0.0], [1e9, 1e9]],
        // Seven roundings wide, far off; then less than one rounding.
        [[1e9, 1e9], [1e9 + 1e-6, 1e9]],
        [[1e9, 0.0], [1e9 + 1e-8, 0.0]],
        [[0.0, 0.0], [5e-324, 5e-324]],
        [[0.0, 0.0], [1e300, 1e300]],
    ];
    for bounds in boxes {
        let mut figure = Figure::new(bounds, [100.0, 100.0])?;
        figure.polyline(&bounds, INK)?;
        figure.disc(bounds[0], 3.0, &Paint::fill(Color::INK))?;
        assert_well_formed(&figure.to_svg());
        let [x, y] = figure.to_page(bounds[1])?;
        assert!((-1.0..=101.0).contains(&x) && (-1.0..=101.0).contains(&y), "{bounds:?}");
    }
    let overflow = Figure::new([[-1.7e308, 0.0], [1.7e308, 1.0]], [100.0, 100.0]);
    assert_eq!(not_finite(overflow), (Place::Bounds, 0));
    Ok(())
}

#[test]
fn an_empty_figure_is_a_page() {
    assert_well_formed(&canvas().to_svg());
}

#[test]
fn a_grasp_picture_says_which_field_is_not_finite() {
    let bad = [0.0, f64::NEG_INFINITY];
    let fault = |change: &dyn Fn(&mut GraspPicture)| {
        let mut picture = grasp(1.0);
        change(&mut picture);
        not_finite(picture.figure())
    };
    assert_eq!(fault(&|p| p.outline[2] = bad), (Place::Outline, 2));
    assert_eq!(fault(&|p| p.holes[0][1] = bad), (Place::Hole(0), 1));
    assert_eq!(fault(&|p| p.fingers[3].point = bad), (Place::FingerPoint, 3));
    assert_eq!(fault(&|p| p.fingers[1].inward_normal = bad), (Place::FingerNormal, 1));
    assert_eq!(fault(&|p| p.fingers[1].radius = f64::NAN), (Place::FingerRadius, 1));
    assert_eq!(fault(&|p| p.farthest_vertex = Some(bad)), (Place::FarthestVertex, 0));
    assert_eq!(fault(&|p| p.regions[0].corners[1] = bad), (Place::Region(0), 1));
    assert_eq!(fault(&|p| p.auxiliary_lines[0][1] = bad), (Place::AuxiliaryLine(0), 1));
    assert_eq!(fault(&|p| p.notes[0].point = bad), (Place::Note, 0));
    let center = Mark { point: bad, label: String::new() };
    assert_eq!(fault(&|p| p.center = Some(center.clone())), (Place::Center, 0));
    let circle = Circle { center: CENTER, radius: f64::NAN };
    assert_eq!(fault(&|p| p.enclosing_circle = Some(circle)), (Place::EnclosingCircle, 1));
}

#[test]
fn a_grasp_picture_refuses_what_is_not_a_grasp() {
    let fault = |change: &dyn Fn(&mut GraspPicture)| {
        let mut picture = grasp(1.0);
        change(&mut picture);
        picture.figure().err()
    };
    let few = |place, found| Some(DrawError::TooFewPoints { place, found, needed: 3 });
    assert_eq!(fault(&|p| p.outline.truncate(2)), few(Place::Outline, 2));
    assert_eq!(fault(&|p| p.holes[0].clear()), few(Place::Hole(0), 0));
    let region = Region { corners: vec![CENTER], color: Color::INK };
    assert_eq!(fault(&|p| p.regions.push(region.clone())), few(Place::Region(1), 1));
    assert_eq!(
        fault(&|p| p.fingers[2].inward_normal = [0.0, 2.0]),
        Some(DrawError::NormalNotUnit { finger: 2, length: 2.0 })
    );
    let size = |place, index, value| Some(DrawError::NotASize { place, index, value });
    assert_eq!(fault(&|p| p.fingers[0].radius = -1.0), size(Place::FingerRadius, 0, -1.0));
    let point = Circle { center: CENTER, radius: 0.0 };
    let expected = size(Place::EnclosingCircle, 1, 0.0);
    assert_eq!(fault(&|p| p.enclosing_circle = Some(point)), expected);
    assert_eq!(fault(&|p| p.center = None), Some(DrawError::ReachWithoutCenter));
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
    let place = Place::Slanted;
    assert!(matches!(
        fault(1, 2, f64::NAN),
        Some(DrawError::NotFinite { place: Place::Slanted, index: 5, .. })
    ));
    // K12 about the origin is (K11 J^T d): its first entry is about -9.8, never 100.
    assert!(matches!(
        fault(0, 2, 100.0),
        Some(DrawError::NotSymmetric { place: Place::Slanted, row: 0, column: 2, .. })
    ));
    let pivot = |pivot, value| Some(DrawError::NotPositiveDefinite { place, pivot, value });
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
        |pivot| Some(DrawError::NotPositiveDefinite { place: Place::Upright, pivot, value: -1.0 });
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

#[test]
fn opacity_and_lightening_stay_in_range() -> Result<(), DrawError> {
    let mut figure = canvas();
    for share in [-1.0, 2.0, f64::NAN] {
        let color = Color::BLUE.with_opacity(share).lightened(share);
        figure.polygon(&OUTLINE, &Paint::fill(color))?;
    }
    assert_well_formed(&figure.to_svg());
    Ok(())
}
