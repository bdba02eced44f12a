//! Files that are hostile on purpose, each with how the command has to end on it.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use std::fmt::Write as _;

use clench_testkit::drawings::{dxf, loop_of, with_tables};

const MM: Option<u8> = Some(4);

/// A file by hand.
pub(crate) struct HandMade {
    pub(crate) name: &'static str,
    pub(crate) content: Vec<u8>,
    pub(crate) ending: Ending,
}

/// The exit code, and a phrase of the message or the report.
#[derive(Clone, Copy)]
pub(crate) struct Ending {
    pub(crate) code: i32,
    pub(crate) says: &'static str,
}

pub(crate) fn hand_made() -> Vec<HandMade> {
    [empty(), noise(), squares(), many_curves(), blocks(), odd_entities(), pages(), others()]
        .into_iter()
        .flatten()
        .collect()
}

fn file(
    name: &'static str,
    content: impl Into<Vec<u8>>,
    code: i32,
    says: &'static str,
) -> HandMade {
    HandMade { name, content: content.into(), ending: Ending { code, says } }
}

fn empty() -> Vec<HandMade> {
    vec![
        file("empty.dxf", "", 1, "the file is empty, expected a drawing"),
        file("empty.svg", "", 1, "the file is empty, expected a drawing"),
        file("empty.stl", "", 1, "is empty, expected a mesh"),
        file("empty.obj", "", 1, "is empty, expected a mesh"),
        file("empty.toml", "", 1, "the file is empty, expected a part"),
    ]
}

fn noise() -> Vec<HandMade> {
    let noise: Vec<u8> =
        (0..9000_u32).map(|i| i.wrapping_mul(2_654_435_761).to_le_bytes()[2]).collect();
    vec![
        file("noise.dxf", noise.clone(), 1, "expected a group code: is it a DXF file?"),
        file("noise.svg", noise.clone(), 1, "byte 3 is not UTF-8"),
        file("noise.stl", noise.clone(), 1, "has 9000 bytes, but a binary STL file"),
        file("noise.obj", noise.clone(), 1, "byte 3 is not UTF-8"),
        file("noise.toml", noise, 1, "byte 3 is not UTF-8"),
    ]
}

/// The quality does not depend on the size, nor on the place.
fn squares() -> Vec<HandMade> {
    let square = |size: f64, at: f64| {
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 0.6]];
        dxf(MM, &loop_of("A", &corners.map(|p| p.map(|x| x * size + at))))
    };
    let quality = "Q = 15 N/mm, limited by translation";
    vec![
        file("tiny.dxf", square(1e-9, 0.0), 0, quality),
        file("large.dxf", square(1e9, 0.0), 0, quality),
        file("away.dxf", square(1e-3, 1e9), 0, quality),
        file("vast.dxf", square(1e99, 0.0), 0, quality),
        file("subnormal.dxf", square(1e-310, 0.0), 1, "is not longer than 1.41421e-314"),
    ]
}

fn many_curves() -> Vec<HandMade> {
    let bomb = numbered(0..30_000, |i| format!("CIRCLE A 10 {i} 20 0 40 0.1\n"));
    let nest = numbered(1..2000, |i| format!("CIRCLE A 10 0 20 0 40 {i}\n"));
    let star = numbered(0..9000, |i| format!("LINE A 10 0 20 0 11 {i} 21 9\n"));
    let spots = "LINE A 10 0 20 0 11 1 21 0\n".repeat(40_000);
    vec![
        file("bomb.dxf", dxf(MM, &bomb), 1, "would bring the edges beyond 100000"),
        file("nest.dxf", dxf(MM, &nest), 1, "would bring the edges beyond 100000"),
        file("star.dxf", dxf(MM, &star), 1, "three ends meet at (0, 0)"),
        file("spots.dxf", dxf(MM, &spots), 1, "ends at (0, 0), where nothing goes on"),
    ]
}

/// Blocks of ten blocks of ten blocks.
fn blocks() -> Vec<HandMade> {
    let mut blocks = "BLOCK - 2 B0\nCIRCLE 0 10 0 20 0 40 1\nENDBLK -\n".to_owned();
    for i in 1..14 {
        let inserts = format!("INSERT 0 2 B{} 10 1 20 1\n", i - 1).repeat(10);
        write!(blocks, "BLOCK - 2 B{i}\n{inserts}ENDBLK -\n").unwrap();
    }
    let insert = |insert: &str| with_tables(MM, "", &blocks, insert);
    let rows = insert("INSERT A 2 B1 10 0 20 0 70 9999999999 71 3");
    vec![
        file("blocks.dxf", insert("INSERT A 2 B13 10 0 20 0"), 1, "more than 100000 entities"),
        file("rows.dxf", rows, 1, "more than 100000 entities"),
    ]
}

fn odd_entities() -> Vec<HandMade> {
    let knots = format!("SPLINE A 71 3 {}", "40 0 10 1 20 2 ".repeat(9000));
    let degree = "SPLINE A 71 99999999999 10 0 20 0";
    let thin = "ELLIPSE A 10 0 20 0 11 1e9 21 0 40 1e-12";
    let codes = "0\nLINE\n".repeat(50_000);
    vec![
        file("knots.dxf", dxf(MM, &knots), 1, "9000 knots, expected 9004 knots"),
        file("degree.dxf", dxf(MM, degree), 1, "line 28: the SPLINE has the degree 99999999999"),
        file("thin.dxf", dxf(MM, thin), 3, "was stopped before it found a placement"),
        file("codes.dxf", codes, 1, "line 100000: the file ends here without `EOF`"),
    ]
}

fn pages() -> Vec<HandMade> {
    let svg = |content: &str| {
        format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 9 9\">{content}</svg>")
    };
    let mut laughs = "<g id=\"l0\"><circle r=\"1\"/></g>".to_owned();
    for i in 1..20 {
        let below = format!("<use href=\"#l{}\"/>", i - 1).repeat(10);
        write!(laughs, "<g id=\"l{i}\">{below}</g>").unwrap();
    }
    let mut entities = "<!DOCTYPE svg [<!ENTITY a \"lol\">".to_owned();
    for i in 1..14 {
        let (letter, before) = (char::from(b'a' + i), char::from(b'a' + i - 1));
        let below = format!("&{before};").repeat(10);
        write!(entities, "<!ENTITY {letter} \"{below}\">").unwrap();
    }
    let entities = format!("{entities}]><svg><text>&j;</text></svg>");
    let laughs = svg(&format!("{laughs}<use href=\"#l19\"/>"));
    let deep = svg(&format!("{}{}", "<g>".repeat(100_000), "</g>".repeat(100_000)));
    let zigzag = numbered(0..3000, |i| format!("L{} {} ", i, i % 2));
    let zigzag = svg(&format!("<path d=\"M0 0 {zigzag} L3000 90 L0 90 Z\"/>"));
    vec![
        file("laughs.svg", laughs, 1, "more than 100000 entities"),
        file("entities.svg", entities, 1, "a possible entity reference loop"),
        file("deep.svg", deep, 1, "line 1: groups are nested more than 64 deep"),
        file("unclosed.svg", "<g>".repeat(100_000), 1, "the root node was opened but never closed"),
        file("zigzag.svg", zigzag, 3, "was stopped before it found a placement"),
        file("latin.svg", b"<svg><text>\xe9\xff</text></svg>", 1, "byte 11 is not UTF-8"),
    ]
}

fn others() -> Vec<HandMade> {
    let claims = [vec![0; 80], u32::MAX.to_le_bytes().to_vec(), vec![0; 50]].concat();
    let numbers = "v 1e999 nan 0\nv 0 0 0\nv 1 0 0\nf 1 2 99999999999999999999\n";
    let deep = format!("[part]\nplanar = {}", "[".repeat(64 * 400));
    vec![
        file("claims.stl", claims, 1, "the 4294967295 triangles that this one claims"),
        file("numbers.obj", numbers, 1, "line 1: found `v 1e999 nan 0`, expected `v`"),
        file("deep.toml", deep, 1, "deep.toml:2:90: not valid TOML"),
    ]
}

/// A text for each number, one after the other.
fn numbered(range: std::ops::Range<u32>, text: impl Fn(u32) -> String) -> String {
    range.map(text).collect::<Vec<_>>().concat()
}
