//! Parts under loads: displacements to a stated scale, forces in proportion.

use clench_draw::{
    Displaced, DrawError, Finger, GraspPicture, Load, SolidDisplaced, SolidLoad, SolidPicture,
};

use crate::solids::held_cube;
use crate::svg::assert_well_formed;

/// The points of the first path with this attribute.
fn path(svg: &str, attribute: &str) -> Vec<[f64; 2]> {
    let line = svg.lines().find(|line| line.contains(attribute)).expect("a path");
    let data = line.split(" d=\"").nth(1).expect("data").split('"').next().expect("an end");
    let numbers: Vec<f64> = data
        .split(['M', 'L', 'Z', ' '])
        .filter(|piece| !piece.is_empty())
        .map(|piece| piece.parse().expect("a number"))
        .collect();
    numbers.chunks(2).map(|pair| [pair[0], pair[1]]).collect()
}

fn square() -> GraspPicture {
    GraspPicture {
        outline: vec![[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]],
        ..GraspPicture::default()
    }
}

#[test]
fn a_displaced_outline_is_drawn_as_many_times_as_far() -> Result<(), DrawError> {
    let shifts = vec![[0.01, 0.0], [0.01, 0.02], [0.0, 0.02], [0.0, 0.0]];
    let displaced = Some(Displaced { shifts, exaggeration: 20.0 });
    let svg = GraspPicture { displaced, ..square() }.figure()?.to_svg();
    // The part is fitted into 380 page units, in the middle of 440: 95 a unit, y down.
    let at = |[x, y]: [f64; 2]| [30.0 + 95.0 * x, 380.0 - 95.0 * y];
    let expected = [[0.2, 0.0], [4.2, 0.4], [4.0, 4.4], [0.0, 4.0]].map(at);
    let found = path(&svg, "fill=\"#d5650a\"");
    assert_eq!(found.len(), 4);
    for (found, expected) in found.iter().zip(expected) {
        let apart = (found[0] - expected[0]).hypot(found[1] - expected[1]);
        // Pages have two decimals.
        assert!(apart < 0.01, "{found:?} {expected:?}");
    }
    Ok(())
}

#[test]
fn arrows_of_fingers_are_in_proportion_to_their_forces() -> Result<(), DrawError> {
    let finger = |x: f64, force| Finger {
        point: [x, 0.0],
        inward_normal: [0.0, 1.0],
        force,
        ..Finger::default()
    };
    let length = |forces: [f64; 2]| {
        let fingers = vec![finger(1.0, forces[0]), finger(3.0, forces[1])];
        let svg = GraspPicture { fingers, ..square() }.figure()?.to_svg();
        // The tips of arrow heads are corners of filled blue polygons.
        let heads = svg.lines().filter(|line| line.contains("fill=\"#0b4f8a\""));
        let tips = heads.map(|line| {
            let points = path(line, "fill");
            points.iter().map(|point| 380.0 - point[1]).fold(0.0, f64::max)
        });
        Ok::<Vec<f64>, DrawError>(tips.collect())
    };
    let [short, long] = length([5.0, 10.0])?[..] else { panic!("two arrows") };
    assert!((long / short - 2.0).abs() < 1e-3, "{short} {long}");
    let [one, other] = length([0.0, 0.0])?[..] else { panic!("two arrows") };
    assert!((one - other).abs() < 1e-9, "no force is given");
    Ok(())
}

#[test]
fn a_load_ends_where_it_acts() -> Result<(), DrawError> {
    let load = Load { point: [4.0, 2.0], along: [-1.0, 0.0], label: "30 N <x>".into() };
    let svg = GraspPicture { loads: vec![load], ..square() }.figure()?.to_svg();
    assert_well_formed(&svg);
    assert!(svg.contains(">30 N &lt;x&gt;</text>"), "{svg}");
    let tip = path(&svg, "fill=\"#8a1f75\"").iter().map(|at| at[0]).fold(f64::INFINITY, f64::min);
    assert!((tip - 410.0).abs() < 0.01, "{tip}");
    Ok(())
}

#[test]
fn a_solid_that_turns_moves_its_points_across_the_axis() {
    let turn = SolidDisplaced {
        about: [1.0, 0.0, 0.0],
        translation: [0.0, 0.0, 0.5],
        rotation: [0.0, 0.0, 0.1],
        exaggeration: 7.0,
    };
    // 2 from the axis along x, and 3 along y.
    let moved = turn.displacement_at([3.0, 3.0, 9.0]);
    let expected = [-0.3, 0.2, 0.5];
    for i in 0..3 {
        assert!((moved[i] - expected[i]).abs() < 1e-15, "{moved:?}");
    }
}

#[test]
fn a_displaced_solid_is_drawn_over_the_solid_at_rest() -> Result<(), DrawError> {
    let orange = |displaced, loads| {
        let picture = SolidPicture { axes: Vec::new(), displaced, loads, ..held_cube() };
        let svg = picture.figure()?.to_svg();
        assert_well_formed(&svg);
        Ok::<usize, DrawError>(svg.matches("stroke=\"#d5650a\" stroke-width=\"1.3\"").count())
    };
    let moved = SolidDisplaced {
        translation: [0.01, 0.0, 0.0],
        exaggeration: 10.0,
        ..SolidDisplaced::default()
    };
    let load = SolidLoad { point: [1.0; 3], along: [0.0, 0.0, -2.0], label: "9 N".into() };
    // Of a cube nine edges are in sight.
    assert!(orange(None, Vec::new())? == 0 && orange(Some(moved), vec![load])? > 0);
    Ok(())
}

#[test]
fn a_picture_says_from_where_it_is_seen() -> Result<(), DrawError> {
    let picture = held_cube();
    let seen = SolidPicture { view: Some(picture.seen_from()?), ..picture.clone() };
    let apart = (0..3).map(|i| {
        (seen.seen_from().map_or(f64::NAN, |eye| eye[i])
            - picture.seen_from().map_or(f64::NAN, |eye| eye[i]))
        .abs()
    });
    assert!(apart.fold(0.0, f64::max) < 1e-15);
    Ok(())
}
