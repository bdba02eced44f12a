//! STL files: triangles that each bring their own corners, as text or as bytes.

use std::io::Cursor;

use super::super::fault::MeshFault;
use super::{Surface, Vertices, stl_text};

/// The bytes of a binary file before its triangles: a free text, and how many there are.
const HEADER: usize = 80;
const COUNT: usize = 4;

/// The bytes of each triangle of a binary file.
const TRIANGLE: u64 = 50;

/// Coordinates may be as far apart as this part of the size of what they describe: edges of some
/// hundred steps still have a direction.
const COARSEST: f64 = 1e-3;

/// The name that a text file gets.
const NAMED: &str = "solid part";

/// The triangles of a file, with their corners counter-clockwise seen from outside.
pub(super) fn surface(bytes: Vec<u8>) -> Result<Surface, MeshFault> {
    let triangles = triangles(bytes)?;
    if triangles.is_empty() {
        return Err(MeshFault::Nothing { what: "facets" });
    }
    for (facet, corners) in triangles.iter().enumerate() {
        if let Some(&corner) = corners.iter().find(|corner| !corner.iter().all(|x| x.is_finite())) {
            return Err(MeshFault::NotFinite { facet, corner });
        }
    }
    let mut vertices = Vertices::default();
    let mut face = |corners: &[[f64; 3]; 3]| corners.map(|at| vertices.number(at)).to_vec();
    let faces = triangles.iter().map(&mut face).collect();
    check_precision(&vertices.places)?;
    Ok((vertices.places, faces))
}

fn triangles(bytes: Vec<u8>) -> Result<Vec<[[f64; 3]; 3]>, MeshFault> {
    let claimed = claimed(&bytes);
    // What a binary file says of itself may begin with `solid` as well: its length tells.
    let binary = claimed.is_some_and(|(_, expected)| expected == bytes.len() as u64);
    let prepared = if binary {
        without_title(bytes)
    } else if let Some(text) = text(&bytes) {
        text?.into_bytes()
    } else {
        let (triangles, expected) = claimed.ok_or(MeshFault::NotStl)?;
        return Err(MeshFault::StlLength { found: bytes.len(), triangles, expected });
    };
    let mut prepared = Cursor::new(prepared);
    let read = stl_io::create_stl_reader(&mut prepared).map_err(MeshFault::Stl)?;
    let corners =
        |triangle: stl_io::Triangle| triangle.vertices.map(|corner| corner.0.map(f64::from));
    read.map(|triangle| triangle.map(corners).map_err(MeshFault::Stl)).collect()
}

/// Checks that the part is not so far from the origin that its coordinates have lost its shape.
fn check_precision(vertices: &[[f64; 3]]) -> Result<(), MeshFault> {
    let side = |axis: usize| {
        let along = vertices.iter().map(|vertex| vertex[axis]);
        along.clone().fold(f64::MIN, f64::max) - along.fold(f64::MAX, f64::min)
    };
    let size = side(0).max(side(1)).max(side(2));
    let farthest = vertices.as_flattened().iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    #[expect(clippy::cast_possible_truncation, reason = "it is of single precision")]
    let single = farthest as f32;
    let step = f64::from(single) - f64::from(single.next_down());
    if size > 0.0 && step > COARSEST * size {
        return Err(MeshFault::Coarse { farthest, step, size });
    }
    Ok(())
}

/// How many triangles a binary file claims to have, and the bytes that these need.
fn claimed(bytes: &[u8]) -> Option<(u32, u64)> {
    let count = bytes.get(HEADER..HEADER + COUNT)?.try_into().ok()?;
    let triangles = u32::from_le_bytes(count);
    Some((triangles, (HEADER + COUNT) as u64 + TRIANGLE * u64::from(triangles)))
}

/// A binary file whose free text cannot be taken for the start of a text file.
fn without_title(mut bytes: Vec<u8>) -> Vec<u8> {
    bytes[..HEADER].fill(0);
    bytes
}

/// A text file as its reader wants it, one named solid in lower case, if it is one; or the line
/// that the reader would refuse.
///
/// The reader stops after the first of several solids, without a word.
fn text(bytes: &[u8]) -> Option<Result<String, MeshFault>> {
    let text = std::str::from_utf8(bytes).ok()?.trim_start_matches('\u{feff}');
    let mut lines = text.lines().filter(|line| !line.trim().is_empty());
    lines.next().filter(|line| stl_text::begins(line, "solid"))?;
    if let Err(fault) = stl_text::check(text) {
        return Some(Err(fault));
    }
    let mut one = format!("{NAMED}\n");
    for line in lines.filter(|line| !stl_text::is_around(line)) {
        one.push_str(&line.to_lowercase());
        one.push('\n');
    }
    one.push_str("endsolid\n");
    Some(Ok(one))
}
