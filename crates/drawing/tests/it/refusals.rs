//! Drawings that are none of a part: what is wrong, and where.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that cannot go on fails")]

use clench_drawing::{DrawingError, PathFault, Sheet, SplineError};
use clench_shape::PolygonError;
use clench_testkit::drawings::{dxf, loop_of, with_tables};

const PAGE: &str = "xmlns=\"http://www.w3.org/2000/svg\" width=\"120mm\" height=\"80mm\" \
                    viewBox=\"0 0 120 80\"";
const MM: Option<u8> = Some(4);
const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]];

/// Whether an error is of a variant of [`DrawingError`], with these fields.
macro_rules! is {
    ($variant:ident $($fields:tt)*) => {
        (|error| matches!(error, DrawingError::$variant $($fields)*)) as fn(&DrawingError) -> bool
    };
}

/// The error of a sheet, or else of the part on it.
fn error(sheet: Result<Sheet, DrawingError>, chord: Option<f64>) -> DrawingError {
    match sheet.and_then(|sheet| sheet.part(1.0, chord)) {
        Err(error) => error,
        Ok(part) => panic!("expected an error, found {part:?}"),
    }
}

fn assert_is(error: &DrawingError, is: fn(&DrawingError) -> bool, pieces: &[&str]) {
    assert!(is(error), "another error: {error:?}");
    let message = error.to_string();
    for piece in pieces {
        assert!(message.contains(piece), "`{piece}` is missing in: {message}");
    }
}

#[test]
fn contours_that_are_none() {
    let square = || loop_of("A", &SQUARE);
    let at = |d: f64| loop_of("B", &SQUARE.map(|[x, y]| [x / 4.0 + d, y / 4.0 + d]));
    let open = "LINE A 5 1F 10 0 20 0 11 9 21 0\nLINE A 10 9 20 0 11 9 21 9\n\
                ARC B 10 0 20 0 40 9 50 91 51 180\nTEXT N 1 X";
    for (entities, is, pieces) in [
        (
            open.to_owned(),
            is!(OpenEnd { .. }),
            &[
                "the LINE `1F` at line 28, on layer `A` ends at (0, 0), where nothing goes on",
                "the nearest other end is 9 away, that of the ARC at line 54, on layer `B`",
                "left aside: 1 TEXT on layer `N` (no curve)",
            ][..],
        ),
        (
            square() + "LINE C 10 0 20 0 11 5 21 5",
            is!(Branch { .. }),
            &["three ends meet at (0, 0)", "the LINE at line 28, on layer `A`", "on layer `C`"],
        ),
        (
            square() + "LINE C 10 5 20 5 11 5 21 5",
            is!(TooShort { .. }),
            &["layer `C` is not longer than 0.00141"],
        ),
        (
            square() + &at(20.0),
            is!(SecondPart { .. }),
            &["two parts, expected one", "layer `B` is not inside"],
        ),
        (
            square() + &at(2.0) + &loop_of("C", &[[3.0, 3.0], [4.0, 3.0], [3.0, 4.0]]),
            is!(Island { .. }),
            &["layer `C` is inside the hole with the LINE", "on layer `B`"],
        ),
        (
            square() + &at(9.0),
            is!(Crossing { .. }),
            &["on layer `A` and the LINE", "on layer `B` cross or touch near"],
        ),
        (
            square() + "CIRCLE B 10 10 20 5 40 2",
            is!(Crossing { .. }),
            &["on layer `A` and the CIRCLE", "on layer `B` cross or touch near (1"],
        ),
        (
            loop_of("A", &[[0.0, 0.0], [9.0, 9.0], [9.0, 0.0], [0.0, 8.0]]),
            is!(Crossing { .. }),
            &["cross or touch near"],
        ),
    ] {
        let sheet = Sheet::from_dxf(dxf(MM, &entities).as_bytes(), &[]);
        assert_is(&error(sheet, None), is, pieces);
    }
}

#[test]
fn drawings_without_a_contour() {
    for (name, entities, is, pieces) in [
        (
            "text",
            "TEXT N 1 X".to_owned(),
            is!(NothingDrawn { .. }),
            &["no curves that could be the outline, only 1 TEXT on layer `N` (no curve)"][..],
        ),
        (
            "point",
            "LINE A 10 3 20 4 11 3 21 4".to_owned(),
            is!(Size { .. }),
            &["has the size 0e0, expected a"],
        ),
        (
            "nothing",
            String::new(),
            is!(NothingDrawn { .. }),
            &["no curves that could be the outline"],
        ),
        (
            "flat",
            "LINE A 10 0 20 0 11 9 21 0\nLINE A 10 9 20 0 11 5 21 0\nLINE A 10 5 20 0 11 0 21 0"
                .to_owned(),
            is!(Outline(PolygonError::ZeroArea { .. })),
            &["lie on one line"],
        ),
        (
            "layer",
            loop_of("A", &SQUARE),
            is!(NoSuchLayer { .. }),
            &["nothing on layer `WALL`, expected one of its layers: `A`"],
        ),
        (
            "tiny-chord",
            "CIRCLE A 10 0 20 0 40 5".to_owned(),
            is!(TooManyCorners { .. }),
            &["the CIRCLE at line 28", "beyond 100000", "chord of 1e-13"],
        ),
    ] {
        let layers: &[&str] = if name == "layer" { &["WALL"] } else { &[] };
        let chord = (name == "tiny-chord").then_some(1e-13);
        let found = error(Sheet::from_dxf(dxf(MM, &entities).as_bytes(), layers), chord);
        assert_is(&found, is, pieces);
    }
}

#[test]
fn entities_that_are_none() {
    for (name, entities, is, piece) in [
        (
            "nan",
            "CIRCLE A 10 nan 20 0 40 5",
            is!(NotANumber { .. }),
            "line 32: found `nan`, expected a number up to 1e100",
        ),
        (
            "huge",
            "CIRCLE A 10 0 20 0 40 1e300",
            is!(NotANumber { .. }),
            "line 36: found `1e300`, expected a number",
        ),
        (
            "missing",
            "CIRCLE A 10 0 20 0",
            is!(MissingValue { code: 40, .. }),
            "line 28: the CIRCLE has no value with the group code 40",
        ),
        (
            "radius",
            "CIRCLE A 10 0 20 0 40 -5",
            is!(Radius { .. }),
            "line 28: the CIRCLE has the radius -5",
        ),
        (
            "ratio",
            "ELLIPSE A 10 0 20 0 11 4 21 0 40 0",
            is!(AxisRatio { .. }),
            "line 28: the ELLIPSE has the ratio of axes 0",
        ),
        (
            "length",
            "LWPOLYLINE A 90 2 70 1 10 4 20 4 10 4 20 4",
            is!(NoLength { .. }),
            "the LWPOLYLINE has no length",
        ),
        (
            "block",
            "INSERT A 2 NUT 10 0 20 0",
            is!(NoSuchBlock { .. }),
            "line 28: there is no block `NUT`",
        ),
        (
            "rows",
            "INSERT A 2 A 10 0 20 0 70 30000 71 30000",
            is!(TooManyEntities { .. }),
            "more than 100000 entities",
        ),
        (
            "within",
            "INSERT A 2 B 10 0 20 0",
            is!(RecursiveBlock { .. }),
            "line 26: the block `B` is within itself",
        ),
    ] {
        let blocks = "BLOCK - 2 A\nINSERT 0 2 B\nENDBLK -\nBLOCK - 2 B\nINSERT 0 2 A\nENDBLK -";
        let blocks = if matches!(name, "rows" | "within") { blocks } else { "" };
        let text = with_tables(MM, "", blocks, entities);
        assert_is(&error(Sheet::from_dxf(text.as_bytes(), &[]), None), is, &[piece]);
    }
}

#[test]
fn splines_that_are_none() {
    for (entities, is, piece) in [
        (
            "SPLINE A 71 0 10 0 20 0",
            is!(Spline { error: SplineError::Degree { .. }, .. }),
            "the SPLINE has the degree 0, expected one from 1",
        ),
        (
            "SPLINE A 71 3 10 0 20 0 10 1 20 1",
            is!(Spline { error: SplineError::TooFewPoints { .. }, .. }),
            "has 2 control points, expected at least 4",
        ),
        (
            "SPLINE A 71 1 40 0 40 1 10 0 20 0 10 1 20 1",
            is!(Spline { error: SplineError::Counts { .. }, .. }),
            "2 knots, expected 4 knots",
        ),
        (
            "SPLINE A 71 1 40 0 40 0 40 1 40 0 10 0 20 0 10 1 20 1",
            is!(Spline { error: SplineError::Knots { .. }, .. }),
            "do not ascend, at number 3",
        ),
        (
            "SPLINE A 71 1 40 0 40 0 40 1 40 1 41 1 41 0 10 0 20 0 10 1 20 1",
            is!(Spline { error: SplineError::Weight { .. }, .. }),
            "has the weight 0",
        ),
        (
            "SPLINE A 71 1 40 0 40 0 40 1 40 1 41 1 10 0 20 0 10 1 20 1",
            is!(Spline { error: SplineError::WeightCount { .. }, .. }),
            "1 weights for 2",
        ),
        (
            "SPLINE A 71 1 40 0 40 0 40 1 40 1 40 2 40 2 10 0 20 0 10 1 20 1 10 2 20 2 10 3 20 0",
            is!(Spline { error: SplineError::Torn { .. }, .. }),
            "is torn at knot 3",
        ),
        (
            "SPLINE A 71 3 11 5 21 5 11 5 21 5",
            is!(Spline { error: SplineError::FitPoints { .. }, .. }),
            "has 2 points to go through, expected at least 2",
        ),
    ] {
        let text = dxf(MM, entities);
        assert_is(&error(Sheet::from_dxf(text.as_bytes(), &[]), None), is, &[piece]);
    }
}

#[test]
fn files_that_are_no_drawings() {
    let square = dxf(MM, &loop_of("A", &SQUARE));
    let cut = square.replace("0\nEOF\n", "");
    for (content, is, piece) in [
        (cut.as_str(), is!(CutOff { .. }), "the file ends here without `EOF`: is it cut off?"),
        (
            "a drawing\n",
            is!(GroupCode { line: 1, .. }),
            "line 1: found `a drawing`, expected a group code",
        ),
        (" \n", is!(Empty), "the file is empty, expected a drawing"),
        ("AC1015\0\0", is!(Dwg), "is a DWG file, expected DXF in text form"),
        ("0\0\n\0S\0E\0", is!(Utf16), "looks like text in UTF-16, expected it in UTF-8"),
        ("AutoCAD Binary DXF\r\n\x1a\0", is!(BinaryDxf), "is a binary DXF file"),
    ] {
        assert_is(&error(Sheet::from_dxf(content.as_bytes(), &[]), None), is, &[piece]);
    }
    for (content, is, piece) in [
        (
            &b"<svg><g></svg>"[..],
            is!(Xml(_)),
            "is not valid XML: expected 'g' tag, not 'svg' at 1:9",
        ),
        (b"<html/>", is!(NotSvg { .. }), "has the root element `html`, expected svg"),
        (b"\xff\xfe<\0s\0", is!(Utf16), "looks like text in UTF-16, expected it in UTF-8"),
        (
            b"<svg>\xff</svg>",
            is!(NotText { offset: 5 }),
            "byte 5 is not UTF-8, expected an SVG file in UTF-8",
        ),
    ] {
        assert_is(&error(Sheet::from_svg(content, &[]), None), is, &[piece]);
    }
    let most = 1 << 25;
    for size in [most, most + 1] {
        let found = error(Sheet::from_dxf(&vec![b' '; size], &[]), None);
        let most = most as u64;
        match found {
            DrawingError::Empty => assert_eq!(size as u64, most),
            DrawingError::TooLarge { size: said, most: allowed } => {
                assert_eq!((said, allowed), (most + 1, most));
            }
            other => panic!("{other:?}"),
        }
    }
}

/// What is shown of a long text of the file is one short line.
#[test]
fn texts_of_the_file_are_cut_and_escaped_in_messages() {
    let text = dxf(MM, &loop_of("A", &SQUARE)).replace("LINE\n8\nA\n", "BOX\n8\nA\u{1b}[31m\n");
    let found = error(Sheet::from_dxf(text.as_bytes(), &[]), None).to_string();
    assert_eq!(
        found,
        "the drawing has no curves that could be the outline, only 4 BOX on layer `A\\u{1b}[31m` \
         (no curve)"
    );
    let long = "x".repeat(1000);
    let found = error(Sheet::from_dxf(long.as_bytes(), &[]), None).to_string();
    let short = format!("line 1: found `{}…`, expected a group code", &long[..40]);
    assert!(found.starts_with(&short), "{found}");
}

#[test]
fn scales_and_chords_are_positive() {
    let sheet = Sheet::from_dxf(dxf(MM, &loop_of("A", &SQUARE)).as_bytes(), &[]).unwrap();
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let found = sheet.part(bad, None).unwrap_err();
        assert!(matches!(found, DrawingError::Scale { .. }), "{bad}: {found}");
        let found = sheet.part(1.0, Some(bad)).unwrap_err();
        assert!(matches!(found, DrawingError::Chord { .. }), "{bad}: {found}");
    }
    let found = sheet.part(1e308, None).unwrap_err().to_string();
    assert_eq!(found, "the drawing has the size inf, expected a finite one above 0");
    let found = sheet.part(1e200, None).unwrap_err();
    assert!(matches!(found, DrawingError::Outline(PolygonError::TooLarge { .. })), "{found}");
}

/// Asserts that a page with this content is refused.
fn assert_refused(content: &str, is: fn(&DrawingError) -> bool, piece: &str) {
    let text = format!("<svg {PAGE}>\n{content}\n</svg>\n");
    assert_is(&error(Sheet::from_svg(text.as_bytes(), &[]), None), is, &[piece]);
}

#[test]
fn faults_of_paths_are_told_with_their_line() {
    for (content, is, piece) in [
        (
            "<path d=\"M0 0 L4 x,7\"/>",
            is!(Path { fault: PathFault::At { character: 9, .. }, line: 2 }),
            "line 2: the data of the path has `x` at its character 9, expected commands and",
        ),
        (
            "<path d=\"M0 0 L1e999 4 L4 4 Z\"/>",
            is!(Path { fault: PathFault::At { character: 7, .. }, line: 2 }),
            "line 2: the data of the path has `1e999` at its character 7",
        ),
        (
            "<path d=\"L4 4\"/>",
            is!(Path { fault: PathFault::At { .. }, line: 2 }),
            "line 2: the data of the path has `L4` at its char",
        ),
        (
            "<path d=\"M0 0 L4\"/>",
            is!(Path { fault: PathFault::Ends, line: 2 }),
            "line 2: the data of the path ends too early",
        ),
        (
            "<g transform=\"scale(1e90)\"><path d=\"M0 0 L1e20 4 L4 4 Z\"/></g>",
            is!(OutOfRange { .. }),
            "line 2: the path has coordinates beyond 1e100",
        ),
        (
            "<path d=\"M0 0\"/>",
            is!(NothingDrawn { .. }),
            "no curves that could be the outline, only 1 path on no layer (without a size)",
        ),
    ] {
        assert_refused(content, is, piece);
    }
}

#[test]
fn faults_of_svg_files_are_told_with_their_line() {
    let deep = format!("{}<rect width=\"4\" height=\"4\"/>{}", "<g>".repeat(80), "</g>".repeat(80));
    for (content, is, piece) in [
        (
            "<circle r=\"4em\"/>",
            is!(Attribute { expected: "a length", .. }),
            "line 2: found `4em`, expected a length",
        ),
        (
            "<circle r=\"nan\"/>",
            is!(Attribute { expected: "a length", .. }),
            "line 2: found `nan`, expected a length",
        ),
        (
            "<g transform=\"turn(5)\"/>",
            is!(Attribute { expected: "transform", .. }),
            "line 2: found `turn(5)`, expected transform",
        ),
        ("<use href=\"#none\"/>", is!(NoSuchElement { .. }), "line 2: there is no element `#none`"),
        (
            "<use href=\"other.svg#a\"/>",
            is!(NoSuchElement { .. }),
            "there is no element `other.svg#a`",
        ),
        (
            "<g id=\"a\"><use href=\"#a\"/></g>",
            is!(TooDeep { .. }),
            "nested more than 64 deep, or in themselves",
        ),
        (deep.as_str(), is!(TooDeep { .. }), "nested more than 64 deep"),
        (
            "<path id=\"edge\" d=\"M0 0 L40 0 L40 20\"/>",
            is!(OpenEnd { .. }),
            "the path `edge` at line 2, on no layer ends at (0, 80)",
        ),
    ] {
        assert_refused(content, is, piece);
    }
}
