//! Mesh files: the surface of a solid, drawn elsewhere.

mod obj;
mod stl;

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
    let failed = MeshFault::Panicked;
    if stl {
        let triangles = shielded(|| stl::triangles(bytes)).ok_or(failed)??;
        Polyhedron::from_triangles(&triangles)
    } else {
        let (vertices, faces) = shielded(|| obj::surface(bytes)).ok_or(failed)??;
        Polyhedron::new(&vertices, &faces)
    }
    .map_err(MeshFault::Surface)
}
