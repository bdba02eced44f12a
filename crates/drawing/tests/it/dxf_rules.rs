//! What the DXF reference says of units, and what is said of blocks, straight lines and text.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that cannot go on fails")]

use clench_drawing::{DrawingError, DrawnPart, Sheet, Unit};
use clench_testkit::assert_close;
use clench_testkit::drawings::{dxf, loop_of, with_tables};

use crate::sketch::{aside, layers, of_dxf};

const MM: Option<u8> = Some(4);
const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]];

fn with_unit(unit: &str) -> Result<Sheet, DrawingError> {
    let text = dxf(MM, &loop_of("A", &SQUARE));
    Sheet::from_dxf(text.replace("70\n4\n", &format!("70\n{unit}\n")).as_bytes(), &[])
}

/// By the table of the reference, and the sizes of the units in meters as the NIST has them.
#[test]
fn every_number_of_a_unit_is_known() {
    for (number, name, meters) in [
        (1, "in", 0.0254),
        (2, "ft", 0.3048),
        (3, "mi", 1609.344),
        (4, "mm", 1e-3),
        (5, "cm", 1e-2),
        (6, "m", 1.0),
        (7, "km", 1e3),
        (8, "uin", 25.4e-9),
        (9, "mil", 25.4e-6),
        (10, "yd", 0.9144),
        (11, "angstrom", 1e-10),
        (12, "nm", 1e-9),
        (13, "um", 1e-6),
        (14, "dm", 0.1),
        (15, "dam", 10.0),
        (16, "hm", 100.0),
        (21, "us-ft", 0.304_800_609_601_219),
        (22, "us-in", 0.025_400_050_800_101_6),
        (23, "us-yd", 0.914_401_828_803_658),
        (24, "us-mi", 1_609.347_218_694_44),
    ] {
        let unit = with_unit(&number.to_string()).unwrap().unit().unwrap();
        assert_eq!(unit.name(), name);
        // To the digits of the table.
        assert_close(unit.micrometers() * 1e-6, meters, 1e-14, meters, name);
        assert_eq!(Unit::named(name), Some(unit));
    }
    assert_eq!(Unit::all().count(), 20);
    for name in ["parsec", "MM", ""] {
        assert_eq!(Unit::named(name), None);
    }
    assert_eq!(with_unit("0").unwrap().unit(), None);
    for (number, says) in [
        ("99", "line 8: $INSUNITS is `99`, expected the number of a unit of length, 1 to 16 or 21"),
        ("18", "line 8: $INSUNITS is `18` (astronomical units), expected"),
        ("-4", "line 8: $INSUNITS is `-4`, expected"),
        ("mm", "line 8: $INSUNITS is `mm`, expected"),
    ] {
        let Err(error) = with_unit(number) else { panic!("{number}") };
        assert!(matches!(error, DrawingError::UnitNumber { line: 8, .. }), "{error:?}");
        assert!(error.to_string().starts_with(says), "{error}");
    }
}

/// Blocks `B1` to `B{count}`, each in the next one, the square in the last.
fn nested(count: usize) -> String {
    let block = |i: usize| {
        let inside = if i == count {
            loop_of("0", &SQUARE)
        } else {
            format!("INSERT 0 2 B{} 10 0 20 0\n", i + 1)
        };
        format!("BLOCK - 2 B{i} 10 0 20 0\n{inside}ENDBLK -\n")
    };
    let blocks: String = (1..=count).map(block).collect();
    with_tables(MM, "", &blocks, "INSERT A 2 B1 10 0 20 0")
}

#[test]
fn blocks_are_nested_up_to_a_limit_that_is_told() {
    assert_eq!(of_dxf(&nested(16), None).polygon().area().to_bits(), 100.0_f64.to_bits());
    let Err(error) = Sheet::from_dxf(nested(17).as_bytes(), &[]) else { panic!("17 deep") };
    assert!(matches!(error, DrawingError::BlockTooDeep { deepest: 16, .. }), "{error:?}");
    let says = "the block `B17` is within 16 others, one in the other, expected blocks nested at \
                most 16 deep";
    assert!(error.to_string().ends_with(says), "{error}");
}

/// A block of a square of lines on `layer`, each with `more` codes, put in by `place`.
fn of_block(tables: &str, layer: &str, more: &str, place: &str) -> Result<DrawnPart, DrawingError> {
    let tables = format!("LTYPE - 2 CENTER 73 2 49 1 49 -1\n{tables}");
    let lines = loop_of(layer, &SQUARE).replace('\n', &format!(" {more}\n"));
    let block = format!("BLOCK - 2 B 10 0 20 0\n{lines}ENDBLK -");
    let text = with_tables(MM, &tables, &block, place);
    Sheet::from_dxf(text.as_bytes(), &[])?.part(1.0, None)
}

/// Asserts that a square is drawn on this layer, and nothing left aside.
fn assert_drawn(part: Result<DrawnPart, DrawingError>, layer: &str) {
    let part = part.unwrap();
    assert_eq!(part.polygon().area().to_bits(), 100.0_f64.to_bits());
    assert_eq!((layers(&part), aside(&part)), (vec![layer], Vec::new()));
}

/// Asserts that nothing is drawn, and what is left aside instead.
fn assert_aside(part: Result<DrawnPart, DrawingError>, expected: &str) {
    let Err(DrawingError::NothingDrawn { left_aside }) = part else { panic!("{part:?}") };
    let found: Vec<String> = left_aside.iter().map(ToString::to_string).collect();
    assert_eq!(found, [expected]);
}

/// What is on layer 0 of a block is seen if the layer of its place is, whatever layer 0 is.
#[test]
fn layer_0_of_a_block_is_as_visible_as_the_layer_of_its_place() {
    let place = "INSERT PART 2 B 10 0 20 0";
    for zero in ["70 0 62 -7", "70 1 62 7", "70 0 62 7 290 0"] {
        let tables = format!("LAYER - 2 0 {zero}\nLAYER - 2 PART 70 0 62 7");
        assert_drawn(of_block(&tables, "0", "", place), "PART");
    }
    let off = "LAYER - 2 0 70 0 62 7\nLAYER - 2 PART 70 0 62 -7";
    assert_aside(of_block(off, "0", "", place), "4 LINE on layer `PART` (hidden)");
}

/// So are lines by layer and by block as broken as those of their place, and no others.
#[test]
fn layer_0_of_a_block_is_as_broken_as_the_layer_of_its_place() {
    let place = "INSERT PART 2 B 10 0 20 0";
    let zero = "LAYER - 2 0 70 0 6 CENTER\nLAYER - 2 PART 70 0 6 CONTINUOUS";
    for line_type in ["", "6 BYLAYER", "6 ByBlock"] {
        assert_drawn(of_block(zero, "0", line_type, place), "PART");
    }
    let part = "LAYER - 2 PART 70 0 6 CENTER";
    let broken = "4 LINE on layer `PART` (a broken line)";
    for line_type in ["", "6 BYLAYER", "6 BYBLOCK", "6 CENTER"] {
        assert_aside(of_block(part, "0", line_type, place), broken);
    }
    // Lines by block take the type of the place itself, lines by layer do not.
    let own = "INSERT PART 2 B 6 CENTER 10 0 20 0";
    assert_aside(of_block("", "0", "6 BYBLOCK", own), broken);
    assert_drawn(of_block("", "0", "", own), "PART");
}

/// A place on a layer of a broken line, or on one that is off, leaves what is on other layers; one
/// on a frozen layer, or hidden itself, leaves nothing.
#[test]
fn a_block_is_as_visible_as_its_own_layers_are() {
    let place = "INSERT AXES 2 B 10 0 20 0";
    for axes in ["70 0 62 7 6 CENTER", "70 0 62 -7", "70 0 62 7 290 0"] {
        assert_drawn(of_block(&format!("LAYER - 2 AXES {axes}"), "EDGE", "", place), "EDGE");
    }
    let insert = "1 INSERT on layer `AXES` (hidden)";
    assert_aside(of_block("LAYER - 2 AXES 70 1 62 7", "EDGE", "", place), insert);
    assert_aside(of_block("", "EDGE", "", "INSERT AXES 60 1 2 B 10 0 20 0"), insert);
    let paper = of_block("", "EDGE", "", "INSERT AXES 67 1 2 B 10 0 20 0");
    assert_aside(paper, "1 INSERT on layer `AXES` (on paper)");
}

/// Edges of straight lines are the lines, whatever the chord and whatever is hidden.
#[test]
fn nothing_is_off_straight_lines() {
    let hidden =
        "CIRCLE A 60 1 10 5 20 5 40 2\nLWPOLYLINE A 90 3 70 1 10 2 20 2 10 4 20 2 10 3 20 4";
    for chord in [None, Some(0.5)] {
        let part = of_dxf(&dxf(MM, &(loop_of("A", &SQUARE) + hidden)), chord);
        assert_eq!(part.chord().to_bits(), 0.0_f64.to_bits());
    }
    let bent = of_dxf(&dxf(MM, &(loop_of("A", &SQUARE) + "CIRCLE A 10 5 20 5 40 2")), Some(0.5));
    assert_eq!(bent.chord().to_bits(), 0.5_f64.to_bits());
}
