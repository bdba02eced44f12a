//! From the numbers of a file, or from a mesh, to a spatial part.

use clench::shape::{Ellipsoid, Extent, Polyhedron, PolyhedronError};

use super::document::Document;
use super::fault::{PartFault, listed};
use super::mesh;
use super::number::{FileName, PerPiece, Point, Whole};
use super::part::{Body, checked_stiffness, ellipsoid, one_stiffness};
use super::place::Place;
use super::schema;
use crate::failure::Failure;

/// A spatial part.
#[derive(Debug)]
pub(crate) enum SpatialShape {
    Polyhedron(Box<Polyhedron>),
    Ellipsoid(Ellipsoid<3>),
}

impl SpatialShape {
    /// What decides how far it reaches.
    pub(crate) fn extent(&self) -> Extent<'_, 3> {
        match self {
            Self::Polyhedron(polyhedron) => Extent::from(&**polyhedron),
            Self::Ellipsoid(ellipsoid) => Extent::from(ellipsoid),
        }
    }
}

/// The part that `spatial` describes.
pub(super) fn body(
    document: &Document,
    spatial: &schema::Spatial,
) -> Result<Body<SpatialShape>, Failure> {
    let here = Place::spatial();
    if spatial.center.is_some() && spatial.ellipsoid.is_none() {
        let fault = PartFault::Center { smooth: "ellipsoid" };
        return Err(document.error(&here.field("center"), fault));
    }
    match (&spatial.vertices, &spatial.faces, &spatial.mesh, &spatial.ellipsoid) {
        (Some(vertices), Some(faces), None, None) => {
            let polyhedron = polyhedron(document, vertices, faces)?;
            let stiffness = face_stiffness(document, spatial.stiffness.as_ref(), faces.len())?;
            Ok(Body { shape: SpatialShape::Polyhedron(Box::new(polyhedron)), stiffness })
        }
        (None, None, Some(FileName(name)), None) => {
            let mesh = mesh::read(&document.folder().join(name)).map_err(|fault| {
                let fault = PartFault::Mesh { name: name.clone(), fault };
                document.error(&Place::spatial().field("mesh"), fault)
            })?;
            let reason = "the faces of a mesh have none of their own";
            let stiffness = one_stiffness(document, &here, spatial.stiffness.as_ref(), reason)?;
            Ok(Body { shape: SpatialShape::Polyhedron(Box::new(mesh)), stiffness })
        }
        (None, None, None, Some(semi_axes)) => {
            let shape = ellipsoid(document, &here, "ellipsoid", *semi_axes, spatial.center)?;
            let reason = "an ellipsoid has no faces";
            let stiffness = one_stiffness(document, &here, spatial.stiffness.as_ref(), reason)?;
            Ok(Body { shape: SpatialShape::Ellipsoid(shape), stiffness })
        }
        _ => Err(document.error(&here, PartFault::SpatialShape { found: found(spatial) })),
    }
}

/// The fields that describe a shape, as they were found.
fn found(spatial: &schema::Spatial) -> String {
    let fields = [
        ("`vertices`", spatial.vertices.is_some()),
        ("`faces`", spatial.faces.is_some()),
        ("`mesh`", spatial.mesh.is_some()),
        ("`ellipsoid`", spatial.ellipsoid.is_some()),
    ];
    listed(&fields).unwrap_or_else(|| "no shape".to_owned())
}

fn polyhedron(
    document: &Document,
    vertices: &[Point<3>],
    faces: &[Vec<Whole>],
) -> Result<Polyhedron, Failure> {
    let vertices: Vec<[f64; 3]> = vertices.iter().map(|vertex| vertex.0).collect();
    // A number that is too large for a vertex stays too large.
    let number = |corner: &Whole| usize::try_from(corner.0).unwrap_or(usize::MAX);
    let faces: Vec<Vec<usize>> =
        faces.iter().map(|corners| corners.iter().map(number).collect()).collect();
    Polyhedron::new(&vertices, &faces)
        .map_err(|e| document.error(&place_of_fault(&e), PartFault::Polyhedron(e)))
}

/// The vertex or face of the file that a surface's fault is about.
fn place_of_fault(fault: &PolyhedronError) -> Place {
    let [vertices, faces] = ["vertices", "faces"].map(|name| Place::spatial().field(name));
    match *fault {
        PolyhedronError::TooFewVertices { .. } => vertices,
        PolyhedronError::NotFinite { vertex, .. }
        | PolyhedronError::TooLarge { vertex, .. }
        | PolyhedronError::TooSmall { vertex, .. }
        | PolyhedronError::EqualVertices { second: vertex, .. } => vertices.item(vertex),
        PolyhedronError::TooFewCorners { face, .. }
        | PolyhedronError::NoSuchVertex { face, .. }
        | PolyhedronError::RepeatedCorner { face, .. }
        | PolyhedronError::ZeroAreaFace { face, .. }
        | PolyhedronError::NotPlanar { face, .. }
        | PolyhedronError::FaultyFace { face, .. }
        | PolyhedronError::OpenEdge { face, .. }
        | PolyhedronError::ZeroVolume { face, .. }
        | PolyhedronError::InsideOut { face, .. }
        | PolyhedronError::NestedAlike { face, .. }
        | PolyhedronError::NonManifoldEdge { faces: [_, _, face], .. }
        | PolyhedronError::FlippedNeighbor { faces: [_, face], .. }
        | PolyhedronError::FacesCross { faces: [_, face], .. } => faces.item(face),
        _ => faces,
    }
}

fn face_stiffness(
    document: &Document,
    stiffness: Option<&PerPiece>,
    faces: usize,
) -> Result<Option<Vec<f64>>, Failure> {
    let Some(stiffness) = stiffness else { return Ok(None) };
    let (here, each) = (Place::spatial().field("stiffness"), stiffness.each(faces));
    if each.len() != faces {
        let fault = PartFault::FaceStiffnesses { found: each.len(), faces };
        return Err(document.error(&here, fault));
    }
    let place = |face: usize| match stiffness {
        PerPiece::All(_) => here.clone(),
        PerPiece::Each(_) => here.clone().item(face),
    };
    let checked = each.into_iter().enumerate();
    checked
        .map(|(face, value)| checked_stiffness(document, &place(face), value))
        .collect::<Result<_, _>>()
        .map(Some)
}
