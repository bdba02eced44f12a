//! Solids as they are seen: what is hidden, what is left out, where one looks from.

use clench_draw::{DrawError, SolidFace, SolidFinger, SolidPicture};

use crate::solids::{
    bracket, cube, finger, held_bracket, held_cube, held_sphere, held_torus, hexagon, plate, prism,
    ring, scaled, sphere, torus,
};
use crate::svg::assert_well_formed;

/// How edges in sight, hidden edges, the name of a finger in sight and hidden lines of a finger are
/// told from all other.
const EDGE: &str = "stroke=\"#1e2228\" stroke-width=\"1.5\"";
const HIDDEN: &str = "stroke-width=\"0.8\" stroke-dasharray";
const NAME: &str = "text-anchor=\"middle\" fill=\"#0b4f8a\"";
const HIDDEN_FINGER: &str = "stroke-width=\"1.1\" stroke-dasharray";

fn svg(picture: &SolidPicture) -> String {
    let svg = picture.figure().expect("a solid that is drawn").to_svg();
    assert_well_formed(&svg);
    svg
}

fn count(svg: &str, mark: &str) -> usize {
    svg.lines().filter(|line| line.contains(mark)).count()
}

/// The corners of the paths with a mark.
fn paths(svg: &str, mark: &str) -> Vec<Vec<[f64; 2]>> {
    let lines = svg.lines().filter(|line| line.contains(mark));
    let path = |line: &str| -> Vec<[f64; 2]> {
        let path = line.split('"').nth(1).expect("a path");
        let points = path.trim_start_matches('M').trim_end_matches('Z').split('L');
        let number = |text: &str| text.parse::<f64>().expect("a number");
        let point = |text: &str| text.split_once(' ').map(|(x, y)| [number(x), number(y)]);
        points.map(|text| point(text).expect("two numbers")).collect()
    };
    lines.map(path).collect()
}

/// The part alone, from a direction.
fn alone(faces: Vec<SolidFace>, view: [f64; 3]) -> SolidPicture {
    SolidPicture { faces, view: Some(view), ..SolidPicture::default() }
}

#[test]
fn of_a_cube_nine_edges_are_in_sight_and_three_hidden() {
    for view in [[3.0, -5.0, 2.5], [-1.0, 1.0, -1.0], [0.3, 1.0, 4.0]] {
        let svg = svg(&alone(cube(), view));
        assert_eq!((count(&svg, EDGE), count(&svg, HIDDEN)), (9, 3), "from {view:?}");
    }
}

#[test]
fn a_cube_along_an_axis_is_a_square() {
    let svg = svg(&alone(cube(), [0.0, 0.0, 2.0]));
    for path in paths(&svg, EDGE).into_iter().chain(paths(&svg, HIDDEN)) {
        // 360 of 420 wide.
        for [x, y] in path {
            assert!([30.0, 390.0].contains(&x) && [0.0, 360.0].contains(&y), "({x}, {y})");
        }
    }
}

#[test]
fn a_finger_behind_the_part_is_dashed_and_one_before_it_is_not() {
    let held = |point: [f64; 3], inward: [f64; 3]| SolidPicture {
        fingers: vec![finger("1", point, inward)],
        ..alone(cube(), [3.0, -5.0, 2.5])
    };
    let front = svg(&held([0.5, 0.0, 0.5], [0.0, 1.0, 0.0]));
    assert_eq!(count(&front, HIDDEN_FINGER), 0);
    assert_eq!(count(&front, NAME), 1, "the name in full color");
    let behind = svg(&held([0.5, 1.0, 0.3], [0.0, -1.0, 0.0]));
    // Its sides, and the rim of its base.
    assert_eq!(count(&behind, HIDDEN_FINGER), 2);
    assert_eq!(count(&behind, NAME), 0, "the name is paler");
    // From the other side it is the other way round.
    let turned =
        SolidPicture { view: Some([-3.0, 5.0, 2.5]), ..held([0.5, 1.0, 0.3], [0.0, -1.0, 0.0]) };
    assert_eq!(count(&svg(&turned), HIDDEN_FINGER), 0);
}

#[test]
fn a_locator_has_another_color_and_a_foot() {
    let shown = |fixed: bool| {
        let held = finger("1", [0.5, 0.0, 0.5], [0.0, 1.0, 0.0]);
        let fingers = vec![SolidFinger { fixed, ..held }];
        svg(&SolidPicture { fingers, ..alone(cube(), [3.0, -5.0, 2.5]) })
    };
    let (locator, clamp) = (shown(true), shown(false));
    let green = "stroke=\"#008060\"";
    // The cone and the sides of its foot that are in sight: outer, upper or lower, left or right.
    assert_eq!((count(&locator, green), count(&clamp, green)), (4, 0));
    assert_eq!((count(&locator, NAME), count(&clamp, NAME)), (0, 1));
}

#[test]
fn an_edge_of_a_bracket_is_hidden_as_far_as_the_upright_reaches() {
    // A line of sight from (x, 0, 1) on the leg, along (-3, -1, 4), is at x = 1 and so under the
    // upright's top, z = 4, if 1 + 4 (x - 1) / 3 < 4: from x = 1 to 3.25 of 4.
    let svg = svg(&alone(bracket(), [-3.0, -1.0, 4.0]));
    let length = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
    let mut found = 0;
    for hidden in paths(&svg, HIDDEN) {
        for seen in paths(&svg, EDGE) {
            let ([a, b], [c, d]) = (&hidden[..], &seen[..]) else { continue };
            let straight = length(*a, *b) + length(*c, *d) - length(*a, *d);
            if length(*b, *c) < 0.02 && straight.abs() < 0.01 {
                let share = length(*a, *b) / length(*a, *d);
                // The drawing takes what is an eighth of a thousandth behind for seen.
                assert!((share - 0.75).abs() < 0.002, "{share}");
                found += 1;
            }
        }
    }
    assert_eq!(found, 1);
}

#[test]
fn edges_inside_a_smooth_surface_are_left_out() {
    // The rim in front, that behind, and the two sides; the rest of the lower rim is hidden.
    let cylinder = |sides| svg(&alone(prism(&ring(sides), 2.0), [3.0, -5.0, 2.5]));
    assert_eq!((count(&cylinder(48), EDGE), count(&cylinder(48), HIDDEN)), (4, 1));
    // Between faces at 30 degrees each edge is one.
    assert_eq!(count(&cylinder(12), EDGE) + count(&cylinder(12), HIDDEN), 36);
    // Of a ball only the outline, closed, remains.
    let ball = svg(&alone(sphere(3), [3.0, -5.0, 2.5]));
    assert_eq!((count(&ball, EDGE), count(&ball, HIDDEN)), (1, 0));
}

#[test]
fn a_mesh_of_more_than_5000_triangles_shows_no_hidden_edges() {
    let hidden = |faces| count(&svg(&alone(faces, [3.0, -1.0, 0.6])), HIDDEN);
    assert!(hidden(torus(100, 24)) > 0);
    assert_eq!(hidden(torus(100, 26)), 0);
}

#[test]
fn through_a_hole_one_sees_its_far_wall() {
    let svg = svg(&alone(plate(48), [3.0, -5.0, 4.0]));
    // Nine of the edges of the block, the upper rim, and the far part of the lower one.
    assert_eq!(count(&svg, EDGE), 11);
    // The other three edges, the near part of the rim, and the two sides of the hole.
    assert_eq!(count(&svg, HIDDEN), 6);
}

#[test]
fn the_view_shows_the_fingers() {
    // From wherever they press: each of the four pairs of upright faces.
    for (x, y) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
        let on_x = finger("x", [0.5 + 0.5 * x, 0.4, 0.6], [-x, 0.0, 0.0]);
        let on_y = finger("y", [0.4, 0.5 + 0.5 * y, 0.6], [0.0, -y, 0.0]);
        let picture =
            SolidPicture { faces: cube(), fingers: vec![on_x, on_y], ..SolidPicture::default() };
        let svg = svg(&picture);
        assert_eq!(count(&svg, HIDDEN_FINGER), 0, "({x}, {y})");
    }
}

#[test]
fn the_same_solid_of_any_size_is_the_same_picture() -> Result<(), DrawError> {
    for picture in [held_cube(), held_bracket(), held_torus(), alone(plate(24), [3.0, 4.0, 5.0])] {
        let reference = picture.figure()?.to_svg();
        for unit in [2.0_f64.powi(-30), 2.0_f64.powi(30), 1e-9, 1e9] {
            assert_eq!(scaled(&picture, unit).figure()?.to_svg(), reference, "unit {unit}");
        }
    }
    Ok(())
}

#[test]
fn solids_are_drawn_from_everywhere() -> Result<(), DrawError> {
    for z in -2..=2 {
        for (x, y) in [(0, 0), (1, 0), (0, -1), (-1, 1), (2, 1)] {
            if (x, y, z) == (0, 0, 0) {
                continue;
            }
            let view = Some([x, y, z].map(f64::from));
            for picture in [held_cube(), held_bracket(), held_sphere(1), held_torus()] {
                assert_well_formed(&SolidPicture { view, ..picture }.figure()?.to_svg());
            }
        }
    }
    Ok(())
}

#[test]
fn marks_axes_and_texts_are_all_there() {
    let svg = svg(&held_bracket());
    for text in ["An L-bracket", "Q = 1.114 N/mm", "worst", ">c<", ">x<", ">y<", ">z<"] {
        assert!(svg.contains(text), "{text}");
    }
    for label in 1..=7 {
        assert!(svg.contains(&format!(">{label}</text>")), "{label}");
    }
    for axis in 1..=3 {
        assert!(svg.contains(&format!(">{axis}</tspan>")), "{axis}");
    }
    let hexagon = SolidPicture { faces: hexagon(), ..SolidPicture::default() };
    assert_well_formed(&hexagon.figure().expect("a prism").to_svg());
}
