//! What the SVG specification says of sizes, radii and what is not drawn.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that cannot go on fails")]

use std::f64::consts::PI;

use clench_drawing::{DrawingError, Reason, Sheet, Unit};
use clench_testkit::assert_close;
use clench_testkit::drawings::area;

use crate::sketch::{aside, contours, of_svg};

const NAMESPACE: &str = "xmlns=\"http://www.w3.org/2000/svg\"";
const PAGE: &str = "width=\"120mm\" height=\"80mm\" viewBox=\"0 0 120 80\"";

fn svg(page: &str, content: &str) -> String {
    format!("<svg {NAMESPACE} {page}>\n{content}\n</svg>\n")
}

/// Section 9.2 of SVG 1.1: a radius that is missing is the other one as it is given, then each
/// reaches to the middle of its side at most.
#[test]
fn rounded_corners_are_those_of_the_specification() {
    for (radii, [rx, ry]) in [
        ("rx=\"20\"", [5.0, 20.0]),
        ("ry=\"20\"", [5.0, 20.0]),
        ("rx=\"20\" ry=\"auto\"", [5.0, 20.0]),
        ("rx=\"auto\" ry=\"3\"", [3.0, 3.0]),
        ("rx=\"3\" ry=\"60\"", [3.0, 40.0]),
        ("rx=\"2\" ry=\"3\"", [2.0, 3.0]),
    ] {
        let rect = format!("<rect x=\"4\" width=\"10\" height=\"80\" {radii}/>");
        let part = contours(&of_svg(&svg(PAGE, &rect), Some(1e-4)));
        // Four quarters of an ellipse are missing but for the ellipse itself.
        let expected = 800.0 - (4.0 - PI) * rx * ry;
        // Chords take less than a ring as wide as they may deviate; it is no longer than 2 (w + h).
        assert_close(area(&part[0]).abs(), expected, 180.0 * 1e-4, 1.0, radii);
    }
    for square in ["", "rx=\"0\"", "rx=\"0\" ry=\"8\"", "rx=\"8\" ry=\"0\"", "rx=\"auto\""] {
        let rect = format!("<rect x=\"4\" width=\"10\" height=\"80\" {square}/>");
        assert_eq!(contours(&of_svg(&svg(PAGE, &rect), None))[0].len(), 4, "{square}");
    }
}

/// A mere number beside a length is in pixels, 96 to an inch.
#[test]
fn a_page_with_one_unit_has_its_other_side_in_pixels() {
    let square = "<path d=\"M0 0 H48 V96 H0 Z\"/>";
    for page in [
        "width=\"48\" height=\"25.4mm\" viewBox=\"0 0 48 96\"",
        "width=\"12.7mm\" height=\"96\" viewBox=\"0 0 48 96\"",
        "width=\"12.7mm\" height=\"96px\" viewBox=\"0 0 48 96\"",
    ] {
        let sheet = Sheet::from_svg(svg(page, square).as_bytes(), &[]).unwrap();
        assert_eq!(sheet.unit().map(Unit::name), Some("mm"), "{page}");
        let part = contours(&sheet.part(1.0, None).unwrap());
        assert_close(area(&part[0]).abs(), 12.7 * 25.4, 1e-12, 400.0, page);
    }
}

#[test]
fn sizes_that_are_none_are_told() {
    for (page, says) in [
        (
            "width=\"-5mm\" height=\"5mm\"",
            "line 1: found the width `-5mm`, expected a number above",
        ),
        (
            "width=\"0\"",
            "line 1: found the width `0`, expected a number above 0, as it is or in mm",
        ),
        ("width=\"20em\"", "line 1: found the width `20em`, expected a number above 0, as it is"),
        ("width=\"5mm\" height=\"1e999\"", "line 1: found the height `1e999`, expected a number"),
        ("width=\"-3%\"", "line 1: found the width `-3%`, expected a number above 0"),
    ] {
        let Err(error) = Sheet::from_svg(svg(page, "").as_bytes(), &[]) else { panic!("{page}") };
        assert!(matches!(error, DrawingError::SvgSize { line: 1, .. }), "{error:?}");
        assert!(error.to_string().starts_with(says), "{error}");
    }
    for (shape, says) in [
        ("<circle r=\"-4\"/>", "line 2: found the r `-4`, expected one that is not negative"),
        ("<rect width=\"-4\" height=\"3\"/>", "line 2: found the width `-4`, expected one"),
        ("<rect width=\"4\" height=\"3\" ry=\"-1\"/>", "line 2: found the ry `-1`, expected one"),
        ("<svg height=\"-9\"/>", "line 2: found the height `-9`, expected one"),
    ] {
        let Err(error) = Sheet::from_svg(svg(PAGE, shape).as_bytes(), &[]) else {
            panic!("{shape}")
        };
        assert!(error.to_string().starts_with(says), "{error}");
    }
}

#[test]
fn what_svg_does_not_draw_is_left_aside() {
    let content = "<g id=\"a\"><rect width=\"60\" height=\"40\"/></g>\n<path d=\"\"/>\
        <path d=\"M4 4\"/><path/><circle r=\"0\" cx=\"5\"/><circle/><ellipse rx=\"3\" ry=\"0\"/>\
        <rect width=\"0\" height=\"9\"/><polygon points=\"\"/><line x1=\"3\" x2=\"3\"/>";
    let part = of_svg(&svg(PAGE, content), None);
    assert_eq!(contours(&part).len(), 1);
    let expected = [
        "2 circle on no layer (without a size)",
        "1 ellipse on no layer (without a size)",
        "1 line on no layer (without a size)",
        "3 path on no layer (without a size)",
        "1 polygon on no layer (without a size)",
        "1 rect on no layer (without a size)",
    ];
    assert_eq!(aside(&part), expected);
}

/// Section 11.4 of SVG 1.1: the line is solid if all dashes are 0, and if one is negative, which is
/// an error.
#[test]
fn lines_are_broken_if_a_dash_has_a_length() {
    let outline = "<rect width=\"60\" height=\"40\"/>";
    let count = |dashes: &str| {
        let bore = "<circle cx=\"20\" cy=\"20\" r=\"5\"";
        let text = svg(PAGE, &format!("{outline}{bore} {dashes}/>"));
        let part = of_svg(&text, None);
        assert!(part.left_aside().iter().all(|aside| aside.reason == Reason::Broken), "{dashes}");
        contours(&part).len()
    };
    for solid in ["none", "0", "0,0", "0.0 0", "0px", "0 0mm", " 0\n,\t0 ", "", "inherit", "4,-2"] {
        assert_eq!(count(&format!("stroke-dasharray=\"{solid}\"")), 2, "`{solid}`");
    }
    for broken in ["4", "0 3", ".5,.5", "0.0,1e-1", "+4", "2mm 1mm", "5%", "4\n2", "1rem"] {
        assert_eq!(count(&format!("stroke-dasharray=\"{broken}\"")), 1, "`{broken}`");
    }
    assert_eq!(count("style=\"stroke-dasharray: 0\""), 2);
    assert_eq!(count("style=\"stroke-dasharray: 8, 4\""), 1);
}

/// What a style sheet hides is read all the same: it is named.
#[test]
fn style_sheets_are_named() {
    let shapes = "<rect class=\"edge\" width=\"60\" height=\"40\"/>\
        <g id=\"bores\" class=\"gone\"><circle cx=\"20\" cy=\"20\" r=\"5\"/></g>";
    let of = |style: &str| of_svg(&svg(PAGE, &format!("{style}{shapes}")), None);
    let classes = [
        "1 class on no layer (classes are not read)",
        "1 class on layer `bores` (classes are not read)",
    ];
    let styled = of("<defs><style>.gone { display: none }</style></defs>");
    assert_eq!(contours(&styled).len(), 2);
    let own = "1 style on no layer (style sheets are not read)";
    assert_eq!(aside(&styled), [classes[0], classes[1], own]);
    let reasons: Vec<Reason> = styled.left_aside().iter().map(|aside| aside.reason).collect();
    assert_eq!(reasons, [Reason::Class, Reason::Class, Reason::StyleSheet]);
    assert_eq!(aside(&of("<style><![CDATA[ circle { display: none } ]]></style>")).len(), 3);
    let linked = "<?xml-stylesheet href=\"looks.css\"?>\n";
    let linked = of_svg(&format!("{linked}{}", svg(PAGE, shapes)), None);
    let own = "1 xml-stylesheet on no layer (style sheets are not read)";
    assert_eq!(aside(&linked), [classes[0], classes[1], own]);
    // Without one, classes mean nothing.
    assert_eq!(aside(&of("")), Vec::<String>::new());
    assert_eq!(aside(&of("<style>  </style>")), Vec::<String>::new());
}
