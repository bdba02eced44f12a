//! Mesh files: the surface of a solid, drawn elsewhere.

mod obj;
mod stl;
mod stl_text;

use std::collections::HashMap;
use std::fs;
use std::path::Path;

use clench::shape::Polyhedron;

use super::fault::MeshFault;
use super::shield::shielded;

/// Whether the file at `path` is one whose coordinates have single precision.
pub(super) fn is_of_single_precision(path: &Path) -> bool {
    ends(path, "stl")
}

fn ends(path: &Path, ending: &str) -> bool {
    path.extension().is_some_and(|e| e.eq_ignore_ascii_case(ending))
}

/// The solid in the mesh file at `path`, an STL or OBJ file by its ending.
///
/// The readers check little: what they would overlook is checked before, and that the faces
/// enclose a solid after.
pub(super) fn read(path: &Path) -> Result<Polyhedron, MeshFault> {
    let (stl, obj) = (ends(path, "stl"), ends(path, "obj"));
    if !stl && !obj {
        return Err(MeshFault::UnknownEnding);
    }
    let bytes = fs::read(path).map_err(MeshFault::Unreadable)?;
    if bytes.iter().all(u8::is_ascii_whitespace) {
        return Err(MeshFault::Empty);
    }
    let read = if stl { stl::surface } else { obj::surface };
    let (vertices, faces) = shielded(|| read(bytes)).ok_or(MeshFault::Panicked)??;
    Polyhedron::new(&vertices, &faces).map_err(|fault| MeshFault::of_surface(fault, &vertices))
}

/// Vertices, and the faces by the numbers of their vertices.
type Surface = (Vec<[f64; 3]>, Vec<Vec<usize>>);

/// Vertices without repetition, numbered as they first occur: triangles of STL files and objects of
/// OBJ files bring those that they share each for themselves.
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
