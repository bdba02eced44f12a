//! Parts from SVG drawings.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use std::f64::consts::PI;

use clench_testkit::assert_close;
use clench_testkit::cases::{list, number};

use crate::run::{Folder, assert_says};
use crate::sketch::{area, contours};

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
    let folder = Folder::new("svg-shapes");
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
        folder.write("part.svg", svg(PAGE, content));
        let (part, report) = contours(&folder, "part.svg --chord 0.0005");
        assert_eq!(part.len(), 1, "{name}");
        assert_extent(name, &part[0], [[10.0, 50.0], [60.0, 70.0]]);
        // What chords take of two half circles is less than a ring as wide as they may deviate.
        assert_close(area(&part[0]).abs(), stadium, 62.9 * 0.0005, 1.0, name);
        assert_eq!(report["units"]["length"].as_str(), Some("mm"), "{name}");
    }
}

/// Corners are on the true curves: a cubic and a quadratic one by their equations.
#[test]
fn bezier_curves_are_flattened_on_themselves() {
    let folder = Folder::new("svg-bezier");
    // y = x (40 - x) / 20 by a quadratic; closed from below.
    folder.write(
        "arch.svg",
        svg(PAGE, "<path d=\"M0 80 Q20 40 40 80 T80 80 M0 80 L0 110 L80 110 L80 80\"/>"),
    );
    let (arch, _) = contours(&folder, "arch.svg --chord 0.01");
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
    folder.write("bow.svg", svg(PAGE, "<path d=\"M10 70 C10 30 70 30 70 70 Z\"/>"));
    let (bow, _) = contours(&folder, "bow.svg --chord 0.001");
    assert_extent("bow", &bow[0], [[10.0, 10.0], [70.0, 40.0]]);
    // The area under the arch: 3/20 (a + b) h + .. = 0.6 * 60 * 40 for a width of 60, height of 40.
    assert_close(area(&bow[0]).abs(), 0.6 * 60.0 * 40.0, 0.15, 1.0, "area");
}

#[test]
fn units_are_those_of_the_page() {
    let folder = Folder::new("svg-units");
    let square = "<path d=\"M0 0 H40 V20 H0 Z\"/>";
    for (page, option, unit, [width, height]) in [
        ("width=\"120mm\" height=\"60mm\" viewBox=\"0 0 40 20\"", "", "mm", [120.0, 60.0]),
        ("width=\"4in\" viewBox=\"0 0 40 20\"", "", "in", [4.0, 2.0]),
        ("width=\"4in\" viewBox=\"0 0 40 20\"", " --units mm", "mm", [101.6, 50.8]),
        ("width=\"96px\" height=\"48px\" viewBox=\"0 0 40 20\"", "", "mm", [25.4, 12.7]),
        ("width=\"96px\" height=\"48px\"", "", "mm", [40.0 * 25.4 / 96.0, 20.0 * 25.4 / 96.0]),
        ("height=\"2cm\" viewBox=\"0 0 40 20\"", "", "cm", [4.0, 2.0]),
        ("width=\"80\" height=\"40\" viewBox=\"0 0 40 20\"", " --units mm", "mm", [80.0, 40.0]),
        ("width=\"100%\" height=\"100%\" viewBox=\"0 0 40 20\"", " --units mm", "mm", [40.0, 20.0]),
        ("viewBox=\"0 0 40 20\"", " --units cm", "cm", [40.0, 20.0]),
        (
            "width=\"120mm\" height=\"120mm\" viewBox=\"0 0 40 20\" preserveAspectRatio=\"none\"",
            "",
            "mm",
            [120.0, 120.0],
        ),
        // In the middle of a page that is too high.
        ("width=\"120mm\" height=\"120mm\" viewBox=\"0 0 40 20\"", "", "mm", [120.0, 60.0]),
    ] {
        folder.write("part.svg", svg(page, square));
        let (part, report) = contours(&folder, &format!("part.svg{option}"));
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
        assert_eq!(report["units"]["length"].as_str(), Some(unit), "{page}");
    }
    folder.write("part.svg", svg("viewBox=\"0 0 40 20\"", square));
    let ran = folder.run("optimize part.svg --stiffness 1 --fingers 4");
    assert_eq!(ran.code, Some(1));
    assert_says(&ran.err, &["part.svg: does not name its unit of length", "--units mm"]);
}

#[test]
fn layers_are_groups_and_what_is_not_seen_is_left_aside() {
    let folder = Folder::new("svg-layers");
    let page = format!("{PAGE} xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"");
    let content = "<g inkscape:groupmode=\"layer\" inkscape:label=\"Part\" id=\"layer1\">\
        <g id=\"g12\"><rect id=\"plate\" width=\"60\" height=\"40\"/></g></g>\n\
        <g id=\"bores\"><circle cx=\"10\" cy=\"10\" r=\"4\"/>\
        <ellipse cx=\"40\" cy=\"10\" rx=\"4\" ry=\"3\"/></g>\n\
        <g id=\"old\" style=\"display:none\"><circle cx=\"10\" cy=\"10\" r=\"5\"/></g>\n\
        <g visibility=\"hidden\"><circle cx=\"10\" cy=\"10\" r=\"5\"/></g>\n\
        <path d=\"M0 0 L60 40\" style=\"stroke:red; stroke-dasharray:4,2\"/>\n\
        <text x=\"3\" y=\"3\">60 x 40</text><image/>";
    folder.write("part.svg", svg(&page, content));
    let (part, report) = contours(&folder, "part.svg");
    assert_eq!(part.len(), 3);
    let drawing = &report["drawing"];
    let words = |key: &str| -> Vec<String> {
        list(&drawing[key]).iter().map(|word| word.as_str().unwrap().to_owned()).collect()
    };
    assert_eq!(words("layers"), ["Part", "bores"]);
    let aside = list(&drawing["left_aside"]);
    let reasons: Vec<&str> = aside.iter().map(|aside| aside["reason"].as_str().unwrap()).collect();
    assert_eq!(reasons, ["hidden", "hidden", "no curve", "a broken line", "no curve"]);
    let (plate, report) = contours(&folder, "part.svg --layer part");
    assert_eq!(plate.len(), 1);
    let others: f64 = list(&report["drawing"]["left_aside"])
        .iter()
        .filter(|aside| aside["reason"].as_str() == Some("another layer"))
        .map(|aside| number(&aside["count"]))
        .sum();
    assert_close(others, 5.0, 0.0, 1.0, "on other layers");
}

#[test]
fn faults_of_svg_files_are_told_with_their_line() {
    let deep = format!("{}<rect width=\"4\" height=\"4\"/>{}", "<g>".repeat(80), "</g>".repeat(80));
    for (name, content, piece) in [
        ("path", "<path d=\"M0 0 L4 x\"/>", "line 2: the data of the path is not valid"),
        ("path-1e999", "<path d=\"M0 0 L1e999 4 L4 4 Z\"/>", "line 2: "),
        ("path-empty", "<path d=\"M0 0\"/>", "line 2: the path has no length"),
        ("unit", "<circle r=\"4em\"/>", "line 2: found `4em`, expected a length"),
        ("nan", "<circle r=\"nan\"/>", "line 2: found `nan`, expected a length"),
        ("radius", "\n<circle r=\"-4\"/>", "line 3: the circle has no length"),
        ("transform", "<g transform=\"turn(5)\"/>", "line 2: found `turn(5)`, expected transform"),
        ("use", "<use href=\"#none\"/>", "line 2: there is no element `#none`"),
        ("link", "<use href=\"other.svg#a\"/>", "there is no element `other.svg#a`"),
        (
            "loop",
            "<g id=\"a\"><use href=\"#a\"/></g>",
            "nested more than 64 deep, or in themselves",
        ),
        ("deep", deep.as_str(), "nested more than 64 deep"),
        (
            "open",
            "<path id=\"edge\" d=\"M0 0 L40 0 L40 20\"/>",
            "the path `edge` at line 2, on no layer ends at (0, 80)",
        ),
    ] {
        let folder = Folder::new(&format!("svg-refused-{name}"));
        folder.write("part.svg", svg(PAGE, content));
        let ran = folder.run("optimize part.svg --stiffness 1 --fingers 4 --svg out.svg");
        assert_eq!(folder.names(), ["part.svg"], "{name}");
        assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""), "{name}: {}", ran.err);
        assert_says(&ran.err, &["part.svg: ", piece]);
    }
}
