//! Solids that are refused, each fault with its error, and extreme ones that are drawn.

use clench_draw::{DrawError, Input, SolidDisplaced, SolidLoad, SolidPicture};

use crate::limits::not_finite;
use crate::solids::{held_bracket, scaled};
use crate::svg::assert_well_formed;

fn changed(change: impl FnOnce(&mut SolidPicture)) -> SolidPicture {
    let mut picture = held_bracket();
    change(&mut picture);
    picture
}

fn fault(change: impl FnOnce(&mut SolidPicture)) -> Option<DrawError> {
    changed(change).figure().err()
}

#[test]
fn a_solid_says_which_field_is_not_finite() {
    let bad = [0.0, f64::NAN, 0.0];
    let at = |change: &dyn Fn(&mut SolidPicture)| not_finite(changed(change).figure());
    assert_eq!(at(&|p| p.faces[2].loops[0][1] = bad), (Input::Face(2), 1));
    // After the four corners of the loop.
    assert_eq!(at(&|p| p.faces[3].triangles[1][2] = bad), (Input::Face(3), 9));
    assert_eq!(at(&|p| p.faces[1].outward_normal = bad), (Input::FaceNormal, 1));
    assert_eq!(at(&|p| p.fingers[4].point = bad), (Input::FingerPoint, 4));
    assert_eq!(at(&|p| p.fingers[3].inward_normal = bad), (Input::FingerNormal, 3));
    assert_eq!(at(&|p| p.axes[1].point = bad), (Input::AxisPoint, 1));
    assert_eq!(at(&|p| p.axes[2].direction = bad), (Input::AxisDirection, 2));
    assert_eq!(at(&|p| p.center.iter_mut().for_each(|c| c.point = bad)), (Input::Center, 0));
    let worst = |p: &mut SolidPicture| p.worst_point.iter_mut().for_each(|w| w.point = bad);
    assert_eq!(at(&worst), (Input::WorstPoint, 0));
    let sway = |p: &mut SolidPicture| p.worst_point.iter_mut().for_each(|w| w.direction = bad);
    assert_eq!(at(&sway), (Input::WorstDirection, 0));
    assert_eq!(at(&|p| p.view = Some(bad)), (Input::View, 0));
    let push = |point, along| vec![SolidLoad { point, along, label: String::new() }];
    assert_eq!(at(&|p| p.loads = push(bad, [1.0; 3])), (Input::LoadPoint, 0));
    assert_eq!(at(&|p| p.loads = push([1.0; 3], bad)), (Input::LoadDirection, 0));
    let moved = |translation| Some(SolidDisplaced { translation, ..SolidDisplaced::default() });
    assert_eq!(at(&|p| p.displaced = moved(bad)), (Input::Displaced, 0));
}

#[test]
fn a_solid_refuses_what_is_not_one() {
    let few = |found| Some(DrawError::TooFewPoints { input: Input::Face(1), found, needed: 3 });
    assert_eq!(fault(|p| p.faces.clear()), Some(DrawError::NoFaces));
    assert_eq!(fault(|p| p.faces[1].loops.clear()), few(0));
    assert_eq!(fault(|p| p.faces[1].loops[0].truncate(2)), few(2));
    assert_eq!(fault(|p| p.faces[1].triangles.clear()), few(0));
    let normal = DrawError::FaceNormalNotUnit { face: 4, length: 2.0 };
    assert_eq!(fault(|p| p.faces[4].outward_normal = [0.0, 2.0, 0.0]), Some(normal));
    let normal = DrawError::NormalNotUnit { finger: 6, length: 0.0 };
    assert_eq!(fault(|p| p.fingers[6].inward_normal = [0.0; 3]), Some(normal));
    let none = |input, index| Some(DrawError::NoDirection { input, index });
    assert_eq!(fault(|p| p.axes[2].direction = [0.0; 3]), none(Input::AxisDirection, 2));
    let sway = |p: &mut SolidPicture| p.worst_point.iter_mut().for_each(|w| w.direction = [0.0; 3]);
    assert_eq!(fault(sway), none(Input::WorstDirection, 0));
    assert_eq!(fault(|p| p.view = Some([0.0; 3])), none(Input::View, 0));
    let point = |p: &mut SolidPicture| {
        for face in &mut p.faces {
            face.loops.iter_mut().flatten().for_each(|at| *at = [1.0; 3]);
            face.triangles.as_flattened_mut().fill([1.0; 3]);
        }
    };
    let flat = DrawError::NotPositive { input: Input::Extent, value: 0.0 };
    assert_eq!(fault(point), Some(flat));
}

#[test]
fn a_solid_refuses_what_no_page_can_show() {
    let far = fault(|p| p.axes[0].point = [0.0, 0.0, 1e9]);
    assert!(
        matches!(far, Some(DrawError::OffPage { input: Input::AxisPoint, index: 0, distance })
            if distance > 1e6),
        "{far:?}"
    );
    let wide = |p: &mut SolidPicture| {
        (p.faces[0].loops[0][0][1], p.faces[0].loops[0][1][1]) = (-1.7e308, 1.7e308);
    };
    assert_eq!(not_finite(changed(wide).figure()), (Input::Extent, 1));
    // The part is small against the distance, which overflows.
    let apart = |p: &mut SolidPicture| p.fingers[0].point = [1e300, 0.0, 0.0];
    let tiny = scaled(&held_bracket(), 1e-30);
    let mut picture = tiny;
    apart(&mut picture);
    assert!(matches!(not_finite(picture.figure()), (Input::Extent, _)));
}

#[test]
fn extreme_solids_are_drawn() -> Result<(), DrawError> {
    for unit in [1e-290, 1e-30, 1e30, 1e300] {
        assert_well_formed(&scaled(&held_bracket(), unit).figure()?.to_svg());
    }
    // A contact and a center far off, and an axis along the line of sight.
    let far = changed(|p| {
        p.fingers[0].point = [1e7, 0.0, 0.0];
        p.center.iter_mut().for_each(|center| center.point = [0.0, -1e8, 0.0]);
        p.view = Some([1.0, 2.0, 3.0]);
        p.axes[0].direction = [1.0, 2.0, 3.0];
        p.worst_point.iter_mut().for_each(|worst| worst.direction = [1.0, 2.0, 3.0]);
    });
    assert_well_formed(&far.figure()?.to_svg());
    // A plate without thickness, and triangles without area.
    let flat = changed(|p| {
        for face in &mut p.faces {
            face.loops.iter_mut().flatten().for_each(|at| at[2] = 0.0);
            face.triangles.as_flattened_mut().iter_mut().for_each(|at| at[2] = 0.0);
        }
    });
    assert_well_formed(&flat.figure()?.to_svg());
    Ok(())
}
