//! Parts from DXF files.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that cannot go on fails")]

use std::f64::consts::{FRAC_1_SQRT_2, PI, TAU};
use std::fmt::Write as _;

use clench_drawing::{DrawingError, Sheet};
use clench_testkit::assert_close;
use clench_testkit::drawings::{area, dxf, loop_of, with_tables};

use crate::sketch::{aside, contours, layers, of_dxf};

const MM: Option<u8> = Some(4);
const RECTANGLE: [[f64; 2]; 4] = [[0.0, 0.0], [80.0, 0.0], [80.0, 60.0], [0.0, 60.0]];

/// Asserts that the corners are on a curve, `off` it by nothing, and that the middles of edges are
/// off it by no more than `chord`, and some by at least a third of it.
fn assert_flattened(corners: &[[f64; 2]], chord: f64, off: impl Fn([f64; 2]) -> f64) {
    let mut worst = 0.0_f64;
    for (i, &[x, y]) in corners.iter().enumerate() {
        assert_close(off([x, y]), 0.0, 1e-12, 100.0, "corner");
        let [u, v] = corners[(i + 1) % corners.len()];
        worst = worst.max(off([f64::midpoint(x, u), f64::midpoint(y, v)]).abs());
    }
    assert!(worst <= chord * (1.0 + 1e-9), "{worst} is more than {chord}");
    assert!(worst >= chord / 3.0, "{worst} is far below {chord}: too many corners");
}

#[test]
fn circles_become_corners_on_them_within_the_chord() {
    let disc = dxf(MM, "CIRCLE 0 10 30 20 40 40 25\nCIRCLE 0 10 30 20 40 40 8");
    for (asked, chord) in [(None, 1e-4 * 50.0 * 2.0_f64.sqrt()), (Some(0.25), 0.25)] {
        let part = of_dxf(&disc, asked);
        let contours = contours(&part);
        assert_close(part.chord(), chord, 1e-14, chord, "chord");
        let off = |radius: f64| move |[x, y]: [f64; 2]| (x - 30.0).hypot(y - 40.0) - radius;
        assert_flattened(&contours[0], chord, off(25.0));
        assert_flattened(&contours[1], chord, off(8.0));
        // The extremes are corners, so that the size is that of the drawing.
        let right = contours[0].iter().map(|corner| corner[0]).fold(0.0, f64::max);
        assert_close(right, 55.0, 1e-15, 55.0, "right end");
    }
}

#[test]
fn ellipses_and_bulges_are_flattened_like_circles() {
    // Half axes 30 and 12, turned by 90 degrees.
    let oval = dxf(MM, "ELLIPSE 0 10 5 20 6 11 0 21 30 40 0.4 41 0 42 6.283185307179586");
    let ellipse = contours(&of_dxf(&oval, Some(0.05)));
    let off = |[x, y]: [f64; 2]| {
        // The distance to first order: value of the equation over its gradient.
        let (x, y) = ((x - 5.0) / 12.0, (y - 6.0) / 30.0);
        (x * x + y * y - 1.0) / (2.0 * (x / 12.0).hypot(y / 30.0))
    };
    assert_flattened(&ellipse[0], 0.05, off);

    // A slot: two half circles of radius 5, one by a bulge on each straight side's end.
    let slot = "LWPOLYLINE 0 90 4 70 1 10 0 20 0 10 40 20 0 42 1 10 40 20 10 10 0 20 10 42 1";
    let slot = contours(&of_dxf(&dxf(MM, slot), Some(0.001)));
    assert_close(area(&slot[0]), 400.0 + PI * 25.0, 1e-3, 480.0, "area");
    for &[x, y] in &slot[0] {
        let off = (x - x.clamp(0.0, 40.0)).hypot(y - 5.0) - 5.0;
        assert_close(off, 0.0, 1e-14, 45.0, "off the slot");
    }
    // The same as an old polyline, the other way round and bulging inwards on the left.
    let old = "POLYLINE 0 66 1 70 1\nVERTEX 0 10 0 20 10\nVERTEX 0 10 40 20 10 42 -1\n\
               VERTEX 0 10 40 20 0\nVERTEX 0 10 0 20 0 42 1\nSEQEND 0";
    let moon = contours(&of_dxf(&dxf(MM, old), Some(0.001)));
    assert_close(area(&moon[0]), -400.0, 1e-3, 400.0, "area");
}

/// A circle as a rational spline of degree two, by nine control points.
#[test]
fn rational_splines_are_exact() {
    let around = [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1], [1, 0]];
    let mut spline = "SPLINE 0 70 12 71 2 72 12 73 9".to_owned();
    for knot in [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4] {
        write!(spline, " 40 {knot}").unwrap();
    }
    for (i, [x, y]) in around.iter().enumerate() {
        let weight = if i % 2 == 0 { 1.0 } else { FRAC_1_SQRT_2 };
        write!(spline, " 41 {weight} 10 {} 20 {} 30 0", 20 * x, 20 * y).unwrap();
    }
    let contours = contours(&of_dxf(&dxf(MM, &spline), Some(0.02)));
    let mut worst = 0.0_f64;
    for (i, &[x, y]) in contours[0].iter().enumerate() {
        assert_close(x.hypot(y), 20.0, 1e-14, 20.0, "radius");
        let [u, v] = contours[0][(i + 1) % contours[0].len()];
        worst = worst.max(20.0 - f64::midpoint(x, u).hypot(f64::midpoint(y, v)));
    }
    assert!(worst > 0.0 && worst <= 0.02, "{worst}");
}

/// Splines by the points that they go through only: smooth there, and closed if they say so.
#[test]
fn splines_through_points_go_through_them() {
    let on_circle = |i: u32| (TAU * f64::from(i) / 12.0).sin_cos();
    let mut closed = "SPLINE 0 70 11 71 3 74 12".to_owned();
    for (sin, cos) in (0..12).map(on_circle) {
        write!(closed, " 11 {} 21 {} 31 0", 30.0 * cos, 30.0 * sin).unwrap();
    }
    let smooth = contours(&of_dxf(&dxf(MM, &closed), None));
    for (sin, cos) in (0..12).map(on_circle) {
        let at = |[x, y]: &[f64; 2]| (x - 30.0 * cos).hypot(y - 30.0 * sin);
        let nearest = smooth[0].iter().map(at).fold(f64::INFINITY, f64::min);
        assert_close(nearest, 0.0, 1e-13, 30.0, "nearest corner");
    }
    // Between them a cubic is off the circle by h^4 r / 384 = 1.96e-4 r and more of higher order,
    // h = 2 pi / 12; one that bends at its end by as much as 17 times that.
    for &[x, y] in &smooth[0] {
        assert_close(x.hypot(y), 30.0, 2.1e-4, 30.0, "radius");
    }

    // With level ends, through the top of an arch: x = t, y = 4 t (1 - t) at the ends' slopes.
    let arch = "SPLINE 0 70 8 71 3 74 3 11 0 21 0 11 10 21 10 11 20 21 0 12 1 22 1 13 1 23 -1\n\
                LINE 0 10 0 20 0 11 20 21 0";
    let arch = contours(&of_dxf(&dxf(MM, arch), Some(0.001)));
    let top = arch[0].iter().map(|corner| corner[1]).fold(0.0, f64::max);
    assert_close(top, 10.0, 1e-12, 10.0, "top");
    // It is its own mirror image.
    for &[x, y] in &arch[0] {
        let at = |[u, v]: &[f64; 2]| (u - (20.0 - x)).hypot(v - y);
        let nearest = arch[0].iter().map(at).fold(f64::INFINITY, f64::min);
        assert_close(nearest, 0.0, 1e-12, 20.0, "mirror image");
    }
}

/// Lines and arcs in any order and direction, whose ends meet with a gap.
#[test]
fn ends_that_meet_are_joined_and_the_gap_is_told() {
    let plate = "LINE A 10 70 20 0 11 0 21 0\nARC A 10 70 20 10 40 10 50 270 51 360\n\
                 LINE A 10 0 20 60 11 80.002 21 60\nLINE A 10 80 20 10.001 11 80 21 60\n\
                 LINE A 10 0 20 60 11 0 21 0";
    let part = of_dxf(&dxf(MM, plate), None);
    let plate = contours(&part);
    assert_close(area(&plate[0]).abs(), 4800.0 - (100.0 - 25.0 * PI), 0.1, 4800.0, "area");
    assert_close(part.largest_gap(), 0.002, 1e-11, 1.0, "largest gap");
    assert_eq!((part.sources().len(), layers(&part)), (5, vec!["A"]));
}

#[test]
fn what_is_no_outline_is_left_aside_by_name() {
    let tables = "LTYPE - 2 CENTER 73 4 49 1 49 -1\nLTYPE - 2 THIN 73 0\n\
                  LAYER - 2 AXES 70 0 62 1 6 CENTER\nLAYER - 2 OLD 70 1 62 7 6 CONTINUOUS\n\
                  LAYER - 2 OFF 70 0 62 -7 6 CONTINUOUS\nLAYER - 2 GHOST 70 0 290 0";
    let mut entities = loop_of("PART", &RECTANGLE);
    entities += "LINE AXES 10 0 20 0 11 9 21 9\nLINE PART 6 HIDDEN 10 1 20 1 11 9 21 9\n\
                 LINE OLD 10 0 20 0 11 9 21 9\nLINE OFF 10 0 20 0 11 9 21 9\n\
                 LINE GHOST 10 0 20 0 11 9 21 9\nLINE DEFPOINTS 10 0 20 0 11 9 21 9\n\
                 LINE PART 60 1 10 0 20 0 11 9 21 9\nCIRCLE PART 67 1 10 0 20 0 40 1\n\
                 TEXT NOTES 10 5 20 5 40 3 1 BRACKET\nTEXT NOTES 10 5 20 5 40 3 1 7\n\
                 HATCH PART 10 0 20 0\nPOINT PART 10 5 20 5\nDIMENSION NOTES 10 1 20 1\n\
                 LINE PART 10 0 20 0 30 0 11 9 21 9 31 4\n\
                 ARC PART 10 0 20 0 40 1 50 0 51 9 210 1 230 0\n\
                 CIRCLE PART 6 THIN 10 40 20 30 40 5";
    let text = with_tables(MM, tables, "", &entities);
    let part = of_dxf(&text, Some(1.0));
    assert_eq!(contours(&part).len(), 2);
    let expected = [
        "1 ARC on layer `PART` (not in the plane)",
        "1 CIRCLE on layer `PART` (on paper)",
        "1 DIMENSION on layer `NOTES` (no curve)",
        "1 HATCH on layer `PART` (no curve)",
        "1 LINE on layer `AXES` (a broken line)",
        "1 LINE on layer `DEFPOINTS` (hidden)",
        "1 LINE on layer `GHOST` (hidden)",
        "1 LINE on layer `OFF` (hidden)",
        "1 LINE on layer `OLD` (hidden)",
        "1 LINE on layer `PART` (hidden)",
        "1 LINE on layer `PART` (a broken line)",
        "1 LINE on layer `PART` (not in the plane)",
        "1 POINT on layer `PART` (no curve)",
        "2 TEXT on layer `NOTES` (no curve)",
    ];
    assert_eq!(aside(&part), expected);
    // Layers that are asked for are taken even if they are hidden, and no others.
    let sheet = Sheet::from_dxf(text.as_bytes(), &["part"]).unwrap();
    let asked = sheet.part(1.0, Some(1.0)).unwrap();
    assert_eq!(contours(&asked), contours(&part));
    assert_eq!(layers(&asked), ["PART"]);
    let hidden = Sheet::from_dxf(text.as_bytes(), &["OLD"]).unwrap().part(1.0, None);
    assert!(matches!(hidden, Err(DrawingError::OpenEnd { .. })), "{hidden:?}");
}

/// Blocks are put in turned, scaled, mirrored and in rows, and within each other.
#[test]
fn blocks_are_drawn_where_they_are_put() {
    let blocks = "BLOCK - 2 BORE 10 1 20 2\nCIRCLE 0 10 1 20 2 40 2\nENDBLK -\n\
                  BLOCK - 2 ROW 10 0 20 0\nINSERT 0 2 BORE 10 0 20 0 70 3 44 10\nENDBLK -\n\
                  BLOCK - 2 HALF 10 0 20 0\nLINE X 10 0 20 0 11 30 21 0\n\
                  ARC X 10 30 20 30 40 30 50 270 51 360\nLINE X 10 60 20 30 11 60 21 60\n\
                  LINE X 10 60 20 60 11 0 21 60\nENDBLK -";
    // A half, and its mirror image by a negative scale; a row of bores, half as large and upright.
    let entities = "INSERT A 2 HALF 10 0 20 0\nINSERT B 2 HALF 10 0 20 0 41 -1\n\
                    INSERT BORES 2 ROW 10 5 20 20 41 0.5 42 0.5 50 90";
    let drawn = of_dxf(&with_tables(MM, "", blocks, entities), Some(0.01));
    let part = contours(&drawn);
    let corner = 900.0 * (1.0 - PI / 4.0);
    assert_close(area(&part[0]).abs(), 7200.0 - 2.0 * corner, 1e-3, 7200.0, "area");
    let mut centers: Vec<[f64; 2]> = part[1..]
        .iter()
        .map(|bore| {
            let count = bore.len() as f64;
            [0, 1].map(|i| bore.iter().map(|corner| corner[i]).sum::<f64>() / count)
        })
        .collect();
    centers.sort_by(|one, other| one[1].total_cmp(&other[1]));
    assert_eq!(centers.len(), 3);
    for ([x, y], expected) in centers.into_iter().zip([20.0, 25.0, 30.0]) {
        assert_close(x, 5.0, 1e-13, 10.0, "x");
        assert_close(y, expected, 1e-13, 30.0, "y");
        // A chord takes no more than a ring as wide as it.
        assert_close(area(&part[1]).abs(), PI, TAU * 0.01, 1.0, "bore");
    }
    // What is on layer 0 of a block is on the layer of its place.
    assert_eq!(layers(&drawn), ["X", "BORES"]);
}

/// An arc that is drawn from below runs clockwise, and counts x the other way.
#[test]
fn what_is_drawn_from_below_is_mirrored() {
    let above = "ARC 0 10 0 20 0 40 10 50 0 51 180\nLINE 0 10 -10 20 0 11 10 21 0";
    let below = "ARC 0 10 -20 20 0 40 10 50 0 51 180 210 0 220 0 230 -1\n\
                 LINE 0 10 10 20 0 11 30 21 0 230 -1";
    let [above, below] = [above, below].map(|text| contours(&of_dxf(&dxf(MM, text), None)));
    assert_eq!(above[0].len(), below[0].len());
    for [x, y] in &below[0] {
        let at = |[u, v]: &[f64; 2]| (u - (20.0 - x)).hypot(v - y);
        let nearest = above[0].iter().map(at).fold(f64::INFINITY, f64::min);
        assert_close(nearest, 0.0, 1e-14, 30.0, "mirror image");
    }
}

/// Each edge knows its curve, and a curve that is there twice is left out.
#[test]
fn edges_know_the_curves_that_they_are_from() {
    let square = [[30.0, 20.0], [50.0, 20.0], [50.0, 40.0], [30.0, 40.0]];
    let again = "LINE COPY 10 80 20 0 11 0 21 0";
    let text = dxf(MM, &(loop_of("OUTLINE", &RECTANGLE) + &loop_of("Pocket", &square) + again));
    let part = of_dxf(&text, None);
    let lines: Vec<usize> = part.edge_sources().map(|source| source.line).collect();
    // The head has 26 lines, and each LINE twelve of its own.
    assert_eq!(lines, [0, 1, 2, 3, 4, 5, 6, 7].map(|i| 28 + 12 * i));
    assert_eq!(part.edges_on("POCKET").collect::<Vec<_>>(), [4, 5, 6, 7]);
    assert_eq!(part.edges_on("COPY").count(), 0);
    let [repeat] = part.repeats() else { panic!("{:?}", part.repeats()) };
    assert_eq!(repeat.left_out.to_string(), "the LINE at line 124, on layer `COPY`");
    assert_eq!(repeat.kept.to_string(), "the LINE at line 28, on layer `OUTLINE`");
}
