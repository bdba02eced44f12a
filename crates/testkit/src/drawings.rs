//! DXF text from a few words.

use std::fmt::Write as _;

/// A DXF file in this unit with these entities, one on each line: the kind, the layer, and then
/// codes with their values, `LINE OUTLINE 10 0 20 0 11 8 21 0`.
#[must_use]
pub fn dxf(unit: Option<u8>, entities: &str) -> String {
    with_tables(unit, "", "", entities)
}

/// The same with records of tables, and with blocks; a record without a layer has `-` there.
#[must_use]
pub fn with_tables(unit: Option<u8>, tables: &str, blocks: &str, entities: &str) -> String {
    let unit = unit.map_or(String::new(), |unit| format!("9\n$INSUNITS\n70\n{unit}\n"));
    let section =
        |name: &str, records: &str| format!("0\nSECTION\n2\n{name}\n{}0\nENDSEC\n", lines(records));
    let head = format!("0\nSECTION\n2\nHEADER\n{unit}0\nENDSEC\n");
    let tables = section("TABLES", tables);
    format!("{head}{tables}{}{}0\nEOF\n", section("BLOCKS", blocks), section("ENTITIES", entities))
}

fn lines(records: &str) -> String {
    let mut text = String::new();
    for record in records.lines().map(str::trim).filter(|line| !line.is_empty()) {
        let mut words = record.split_whitespace();
        let (kind, layer) = (words.next().unwrap(), words.next().unwrap());
        write!(text, "0\n{kind}\n").unwrap();
        if layer != "-" {
            write!(text, "8\n{layer}\n").unwrap();
        }
        let words: Vec<&str> = words.collect();
        for pair in words.chunks_exact(2) {
            write!(text, "{}\n{}\n", pair[0], pair[1]).unwrap();
        }
    }
    text
}

/// The lines between these points and back, as entities on this layer.
#[must_use]
pub fn loop_of(layer: &str, points: &[[f64; 2]]) -> String {
    let next = points.iter().cycle().skip(1);
    let line = |([x, y], [u, v]): (&[f64; 2], &[f64; 2])| {
        format!("LINE {layer} 10 {x} 20 {y} 11 {u} 21 {v}\n")
    };
    points.iter().zip(next).map(line).collect()
}

/// The area within corners, positive if they run counter-clockwise.
#[must_use]
pub fn area(corners: &[[f64; 2]]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(p, q)| 0.5 * (p[0] * q[1] - p[1] * q[0])).sum()
}
