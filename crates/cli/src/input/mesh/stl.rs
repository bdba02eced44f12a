//! STL files: triangles that each bring their own corners, as text or as bytes.

use std::io::Cursor;

use super::super::fault::MeshFault;

/// The bytes of a binary file before its triangles: a free text, and how many there are.
const HEADER: usize = 80;
const COUNT: usize = 4;

/// The bytes of each triangle of a binary file.
const TRIANGLE: u64 = 50;

/// The name that a text file gets.
const NAMED: &str = "solid part";

/// The triangles of a file, with their corners counter-clockwise seen from outside.
pub(super) fn triangles(bytes: Vec<u8>) -> Result<Vec<[[f64; 3]; 3]>, MeshFault> {
    let claimed = claimed(&bytes);
    // What a binary file says of itself may begin with `solid` as well: its length tells.
    let binary = claimed.is_some_and(|(_, expected)| expected == bytes.len() as u64);
    let prepared = if binary {
        without_title(bytes)
    } else if let Some(text) = text(&bytes) {
        text.into_bytes()
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

/// A text file as its reader wants it: one named solid, in lower case.
///
/// The reader stops after the first of several solids, without a word. A file that does not end
/// with `endsolid` is cut off, and is left so.
fn text(bytes: &[u8]) -> Option<String> {
    let text = std::str::from_utf8(bytes).ok()?.trim_start_matches('\u{feff}').to_lowercase();
    let first = |line: &str| line.split_whitespace().next().map(str::to_owned);
    let word = |line: &str, word: &str| first(line).is_some_and(|found| found == word);
    let mut lines = text.lines().filter(|line| !line.trim().is_empty());
    lines.next().filter(|line| word(line, "solid"))?;
    let ended = text.lines().rfind(|line| !line.trim().is_empty());
    let mut one = String::from(NAMED);
    one.push('\n');
    for line in lines.filter(|line| !word(line, "solid") && !word(line, "endsolid")) {
        one.push_str(line);
        one.push('\n');
    }
    if ended.is_some_and(|line| word(line, "endsolid")) {
        one.push_str("endsolid\n");
    }
    Some(one)
}
