//! Parts from SVG files.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use std::f64::consts::PI;

use clench_drawing::{Reason, Sheet, Unit};
use clench_testkit::assert_close;
use clench_testkit::drawings::area;

use crate::sketch::{aside, contours, layers, of_svg};

const PAGE: &str = "xmlns=\"http://www.w3.org/2000/svg\" width=\"120mm\" height=\"80mm\" \
                    viewBox=\"0 0 120 80\"";

fn svg(page: &str, content: &str) -> String {
    format!("<svg {page}>\n{content}\n</svg>\n")
}

/// The least and the largest coordinates of corners.
fn extent(corners: &[[f64; 2]]) -> [[f64; 2]; 2] {
    let at = |pick: fn(f64, f64) -> f64, i: usize| {
        corners.iter().map(|corner| corner[i]).reduce(pick).unwrap()
    };
    [[at(f64::min, 0), at(f64::min, 1)], [at(f64::max, 0), at(f64::max, 1)]]
}

fn assert_extent(name: &str, corners: &[[f64; 2]], expected: [[f64; 2]; 2]) {
    let found = extent(corners);
    for (found, expected) in found.into_iter().flatten().zip(expected.into_iter().flatten()) {
        assert_close(found, expected, 1e-12, 100.0, name);
    }
}

/// The same stadium by each kind of path and shape; y counts upwards from the page's lower end.
#[test]
fn shapes_and_paths_are_read_with_y_upwards() {
    let stadium = 30.0 * 20.0 + PI * 100.0;
    for (name, content) in [
        ("arcs", "<path d=\"M20 10 h30 A10 10 0 0 1 50 30 H20 A10 10 0 0 1 20 10 Z\"/>"),
        ("relative", "<path d=\"m20 10 30 0 a10 10 0 0 1 0 20 l-30 0 a10 10 0 0 1 0-20z\"/>"),
        ("long", "<path d=\"M50 10 A10 10 0 1 1 50 30 L20 30 A10 10 0 1 1 20 10 Z\"/>"),
        ("small radii", "<path d=\"M50 10 A1 1 0 0 1 50 30 L20 30 A1 1 45 0 1 20 10 Z\"/>"),
        ("rect", "<rect x=\"10\" y=\"10\" width=\"50\" height=\"20\" rx=\"10\"/>"),
        (
            "lines and arcs",
            "<line x1=\"20\" y1=\"10\" x2=\"50\" y2=\"10\"/>\
            <path d=\"M20 30 A10 10 0 0 1 20 10\"/><path d=\"M50 30 A10 10 0 0 0 50 10\"/>\
            <polyline points=\"20,30 35,30 50,30\"/>",
        ),
        (
            "moved",
            "<g transform=\"translate(60 0) scale(-1 1)\"><path transform=\"translate(-10, 0)\" \
            d=\"M20 10 h30 A10 10 0 0 1 50 30 H20 A10 10 0 0 1 20 10 Z\"/></g>",
        ),
        (
            "used",
            "<defs><path id=\"p\" d=\"M10 0 h30 a10 10 0 0 1 0 20 H10 A10 10 0 0 1 10 0 Z\"/>\
            </defs><use href=\"#p\" x=\"10\" y=\"10\"/>",
        ),
        (
            "symbol",
            "<symbol id=\"s\" viewBox=\"0 0 5 2\"><rect width=\"5\" height=\"2\" ry=\"1\"/>\
            </symbol><use href=\"#s\" x=\"10\" y=\"10\" width=\"50\" height=\"20\"/>",
        ),
        (
            "nested",
            "<svg x=\"10\" y=\"10\" width=\"50\" height=\"60\" viewBox=\"0 0 5 2\" \
            preserveAspectRatio=\"xMinYMin\"><rect width=\"100%\" height=\"100%\" rx=\"1\"/></svg>",
        ),
        (
            "millimeters",
            "<g transform=\"scale(0.26458333333333333)\"><rect x=\"10mm\" y=\"10mm\" \
            width=\"5cm\" height=\"20mm\" rx=\"10mm\"/></g>",
        ),
    ] {
        let part = contours(&of_svg(&svg(PAGE, content), Some(0.0005)));
        assert_eq!(part.len(), 1, "{name}");
        assert_extent(name, &part[0], [[10.0, 50.0], [60.0, 70.0]]);
        // What chords take of two half circles is less than a ring as wide as they may deviate.
        assert_close(area(&part[0]).abs(), stadium, 62.9 * 0.0005, 1.0, name);
    }
}

/// Corners are on the true curves: a cubic and a quadratic one by their equations.
#[test]
fn bezier_curves_are_flattened_on_themselves() {
    // y = x (40 - x) / 20 by a quadratic; closed from below.
    let arch = "<path d=\"M0 80 Q20 40 40 80 T80 80 M0 80 L0 110 L80 110 L80 80\"/>";
    let arch = contours(&of_svg(&svg(PAGE, arch), Some(0.01)));
    let curve: Vec<[f64; 2]> = arch[0].iter().copied().filter(|c| c[1] > -29.0).collect();
    assert!(curve.len() > 30, "{}", curve.len());
    for &[x, y] in &curve {
        let half = |x: f64| x * (40.0 - x) / 20.0;
        let expected = if x <= 40.0 { half(x) } else { -half(x - 40.0) };
        assert_close(y, expected, 1e-12, 40.0, "height");
    }
    for pair in curve.windows(2).filter(|pair| pair[0][0] > 1e-9 || pair[1][0] > 1e-9) {
        // The chord of a parabola with y'' = 1/10 is h^2 / 80 above it at most.
        let step = pair[1][0] - pair[0][0];
        assert!(step * step / 80.0 <= 0.01 * 2.3, "{step}");
    }
    // x = 3 t (1 - t)^2 30 + .., by a cubic that is its own mirror image.
    let bow = svg(PAGE, "<path d=\"M10 70 C10 30 70 30 70 70 Z\"/>");
    let bow = contours(&of_svg(&bow, Some(0.001)));
    assert_extent("bow", &bow[0], [[10.0, 10.0], [70.0, 40.0]]);
    // The area under the arch: 3/20 (a + b) h + .. = 0.6 * 60 * 40 for a width of 60, height of 40.
    assert_close(area(&bow[0]).abs(), 0.6 * 60.0 * 40.0, 0.15, 1.0, "area");
}

#[test]
fn units_are_those_of_the_page() {
    let square = "<path d=\"M0 0 H40 V20 H0 Z\"/>";
    for (page, unit, [width, height]) in [
        ("width=\"120mm\" height=\"60mm\" viewBox=\"0 0 40 20\"", Some("mm"), [120.0, 60.0]),
        ("width=\"4in\" viewBox=\"0 0 40 20\"", Some("in"), [4.0, 2.0]),
        ("width=\"96px\" height=\"48px\" viewBox=\"0 0 40 20\"", Some("mm"), [25.4, 12.7]),
        ("width=\"96px\" height=\"48px\"", Some("mm"), [40.0 * 25.4 / 96.0, 20.0 * 25.4 / 96.0]),
        ("height=\"2cm\" viewBox=\"0 0 40 20\"", Some("cm"), [4.0, 2.0]),
        ("width=\"80\" height=\"40\" viewBox=\"0 0 40 20\"", None, [80.0, 40.0]),
        ("width=\"100%\" height=\"100%\" viewBox=\"0 0 40 20\"", None, [40.0, 20.0]),
        ("viewBox=\"0 0 40 20\"", None, [40.0, 20.0]),
        (
            "width=\"120mm\" height=\"120mm\" viewBox=\"0 0 40 20\" preserveAspectRatio=\"none\"",
            Some("mm"),
            [120.0, 120.0],
        ),
        // In the middle of a page that is too high.
        ("width=\"120mm\" height=\"120mm\" viewBox=\"0 0 40 20\"", Some("mm"), [120.0, 60.0]),
    ] {
        let sheet = Sheet::from_svg(svg(page, square).as_bytes(), &[]).unwrap();
        assert_eq!(sheet.unit().map(Unit::name), unit, "{page}");
        let part = contours(&sheet.part(1.0, None).unwrap());
        let [low, high] = extent(&part[0]);
        assert_close(high[0] - low[0], width, 1e-12, width, page);
        assert_close(high[1] - low[1], height, 1e-12, height, page);
        // The page is higher than the square in two cases: below it, and in its middle.
        let expected = match page {
            "width=\"96px\" height=\"48px\"" => 28.0 * 25.4 / 96.0,
            "width=\"120mm\" height=\"120mm\" viewBox=\"0 0 40 20\"" => 30.0,
            _ => 0.0,
        };
        assert_close(low[1], expected, 1e-12, 120.0, page);
    }
}

#[test]
fn layers_are_groups_and_what_is_not_seen_is_left_aside() {
    let page = format!("{PAGE} xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"");
    let content = "<g inkscape:groupmode=\"layer\" inkscape:label=\"Part\" id=\"layer1\">\
        <g id=\"g12\"><rect id=\"plate\" width=\"60\" height=\"40\"/></g></g>\n\
        <g id=\"bores\"><circle cx=\"10\" cy=\"10\" r=\"4\"/>\
        <ellipse cx=\"40\" cy=\"10\" rx=\"4\" ry=\"3\"/></g>\n\
        <g id=\"old\" style=\"display:none\"><circle cx=\"10\" cy=\"10\" r=\"5\"/></g>\n\
        <g visibility=\"hidden\"><circle cx=\"10\" cy=\"10\" r=\"5\"/></g>\n\
        <path d=\"M0 0 L60 40\" style=\"stroke:red; stroke-dasharray:4,2\"/>\n\
        <text x=\"3\" y=\"3\">60 x 40</text><image/>";
    let text = svg(&page, content);
    let part = of_svg(&text, None);
    assert_eq!((contours(&part).len(), layers(&part)), (3, vec!["Part", "bores"]));
    let expected = [
        "1 circle on no layer (hidden)",
        "1 circle on layer `old` (hidden)",
        "1 image on no layer (no curve)",
        "1 path on no layer (a broken line)",
        "1 text on no layer (no curve)",
    ];
    assert_eq!(aside(&part), expected);
    let plate = Sheet::from_svg(text.as_bytes(), &["part"]).unwrap().part(1.0, None).unwrap();
    assert_eq!((contours(&plate).len(), layers(&plate)), (1, vec!["Part"]));
    let others = plate.left_aside().iter().filter(|aside| aside.reason == Reason::OtherLayer);
    assert_eq!(others.map(|aside| aside.count).sum::<usize>(), 5);
}
