//! OBJ files: vertices, and faces with any number of corners.

use std::borrow::Cow;
use std::io::Cursor;

use tobj::{LoadOptions, Mesh};

use super::super::fault::MeshFault;
use super::{Surface, Vertices};

/// The surface of all objects of a file together, its faces in their order.
pub(super) fn surface(bytes: Vec<u8>) -> Result<Surface, MeshFault> {
    let text = String::from_utf8(bytes)
        .map_err(|e| MeshFault::NotText { offset: e.utf8_error().valid_up_to() })?;
    let mut prepared = Cursor::new(without_looks(&text)?);
    let no_materials = |_: &std::path::Path| Ok(Default::default());
    let (models, _) = tobj::load_obj_buf(&mut prepared, &LoadOptions::default(), no_materials)
        .map_err(MeshFault::Obj)?;
    let (mut vertices, mut faces) = (Vertices::default(), Vec::new());
    for model in &models {
        let numbers: Vec<usize> = model
            .mesh
            .positions
            .chunks_exact(3)
            .map(|position| vertices.number([position[0], position[1], position[2]]))
            .collect();
        let mut corners = model.mesh.indices.iter().map(|&i| numbers[i as usize]);
        for arity in arities(&model.mesh) {
            faces.push(corners.by_ref().take(arity).collect());
        }
    }
    Ok((vertices.places, faces))
}

/// The file without what is not shape: texture and shading, whose numbers the reader multiplies
/// without a check, colors, lines and free curves. What is left is checked, since the reader does
/// not say which line it refuses.
fn without_looks(text: &str) -> Result<String, MeshFault> {
    let lines = whole_lines(text);
    let count = |word: &str| {
        let begins = |line: &str| line.split_whitespace().next() == Some(word);
        lines.iter().filter(|(_, line)| begins(line)).count()
    };
    let vertices = count("v");
    if vertices == 0 {
        return Err(MeshFault::Nothing { what: "vertices, lines that begin with `v`" });
    }
    if count("f") == 0 {
        return Err(MeshFault::Nothing { what: "faces, lines that begin with `f`" });
    }
    let mut shape = String::with_capacity(text.len());
    let mut before = 0;
    for (line, whole) in &lines {
        let mut words = whole.split_whitespace();
        let kept = match words.next() {
            Some("v") => {
                before += 1;
                vertex(words.collect())
            }
            Some("f") => face(words, before, vertices),
            _ => continue,
        };
        let (found, expected) = match kept {
            Ok(kept) => {
                shape.push_str(&kept);
                shape.push('\n');
                continue;
            }
            Err(fault) => fault,
        };
        let found = found.unwrap_or_else(|| whole.trim().to_owned());
        return Err(MeshFault::Line { line: *line, found, expected });
    }
    Ok(shape)
}

/// The lines without comments, each with the number of the first one that it is of: a backslash
/// joins a line to the next one.
fn whole_lines(text: &str) -> Vec<(usize, String)> {
    let mut lines: Vec<(usize, String)> = Vec::new();
    let mut goes_on = false;
    for (number, line) in (1..).zip(text.lines()) {
        let without = line.strip_suffix('\\');
        let piece = without.unwrap_or(line);
        match lines.last_mut().filter(|_| goes_on) {
            Some((_, whole)) => {
                whole.push(' ');
                whole.push_str(piece);
            }
            None => lines.push((number, piece.to_owned())),
        }
        goes_on = without.is_some();
    }
    for (_, line) in &mut lines {
        line.truncate(line.find('#').unwrap_or(line.len()));
    }
    lines
}

/// A word of a line, or all of it, and what it should be.
type Unexpected = (Option<String>, Cow<'static, str>);

/// The line of a vertex, without its color: what follows the third of more than four numbers.
fn vertex(mut numbers: Vec<&str>) -> Result<String, Unexpected> {
    if numbers.len() > 4 {
        numbers.truncate(3);
    }
    let is_finite = |word: &&str| word.parse().is_ok_and(f64::is_finite);
    let is_scaled = || numbers.get(3).is_none_or(|scale| scale.parse() != Ok(0.0));
    if numbers.len() < 3 || !numbers.iter().all(is_finite) {
        return Err((None, "`v` and three finite numbers".into()));
    }
    if !is_scaled() {
        let expected = "`v` and three finite numbers, the fourth, which divides them, other than 0";
        return Err((None, expected.into()));
    }
    Ok(format!("v {}", numbers.join(" ")))
}

/// The line of a face, by the numbers of its corners alone; there are so many vertices `before`
/// it, and so many in all.
fn face<'a>(
    words: impl Iterator<Item = &'a str>,
    before: i64,
    vertices: usize,
) -> Result<String, Unexpected> {
    let corners: Vec<&str> = words.map(|word| word.split('/').next().unwrap_or("")).collect();
    if corners.len() < 3 {
        return Err((None, "`f` and at least three vertices".into()));
    }
    let is_vertex = |corner: &&str| {
        corner.parse().is_ok_and(|number: i64| match usize::try_from(number) {
            Ok(number) => (1..=vertices).contains(&number),
            Err(_) => number >= -before,
        })
    };
    if let Some(other) = corners.iter().find(|corner| !is_vertex(corner)) {
        let back = match before {
            0 => String::new(),
            _ => format!(", or -1 to -{before} back from the last one before the face"),
        };
        let expected = format!("the number of a vertex, 1 to {vertices}{back}");
        return Err((Some((*other).to_owned()), expected.into()));
    }
    Ok(format!("f {}", corners.join(" ")))
}

/// The numbers of corners of the faces; the reader gives none if all are triangles.
fn arities(mesh: &Mesh) -> Vec<usize> {
    if mesh.face_arities.is_empty() {
        return vec![3; mesh.indices.len() / 3];
    }
    mesh.face_arities.iter().map(|&arity| arity as usize).collect()
}
