//! OBJ files: vertices, and faces with any number of corners.

use std::collections::HashMap;
use std::io::Cursor;

use tobj::{LoadOptions, Mesh};

use super::super::fault::MeshFault;

/// Vertices, and the faces by the numbers of their vertices.
pub(super) type Surface = (Vec<[f64; 3]>, Vec<Vec<usize>>);

/// The surface of all objects of a file together, its faces in their order.
pub(super) fn surface(bytes: Vec<u8>) -> Result<Surface, MeshFault> {
    let text = String::from_utf8(bytes)
        .map_err(|e| MeshFault::NotText { offset: e.utf8_error().valid_up_to() })?;
    let mut prepared = Cursor::new(without_looks(&text));
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
/// without a check, colors, lines and free curves. A backslash joins a line to the next one.
fn without_looks(text: &str) -> String {
    let text = text.replace("\r\n", "\n").replace("\\\n", " ");
    let mut shape = String::with_capacity(text.len());
    for line in text.lines() {
        let mut words = line.split('#').next().unwrap_or("").split_whitespace();
        match words.next() {
            Some("v") => {
                let numbers: Vec<&str> = words.collect();
                // With more than four numbers those after the third are a color.
                let kept = if numbers.len() > 4 { 3 } else { numbers.len() };
                shape.push_str("v ");
                shape.push_str(&numbers[..kept].join(" "));
            }
            Some("f") => {
                let corners: Vec<&str> =
                    words.map(|corner| corner.split('/').next().unwrap_or("")).collect();
                shape.push_str("f ");
                shape.push_str(&corners.join(" "));
            }
            _ => continue,
        }
        shape.push('\n');
    }
    shape
}

/// The numbers of corners of the faces; the reader gives none if all are triangles.
fn arities(mesh: &Mesh) -> Vec<usize> {
    if mesh.face_arities.is_empty() {
        return vec![3; mesh.indices.len() / 3];
    }
    mesh.face_arities.iter().map(|&arity| arity as usize).collect()
}

/// Vertices without repetition: objects bring those that they share each for themselves.
#[derive(Default)]
struct Vertices {
    places: Vec<[f64; 3]>,
    numbers: HashMap<[u64; 3], usize>,
}

impl Vertices {
    fn number(&mut self, place: [f64; 3]) -> usize {
        // Adding zero makes the two zeros equal.
        *self.numbers.entry(place.map(|x| (x + 0.0).to_bits())).or_insert_with(|| {
            self.places.push(place);
            self.places.len() - 1
        })
    }
}
