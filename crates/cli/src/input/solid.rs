//! From the numbers of a file, or from a mesh, to a spatial part.

use std::path::PathBuf;

use clench::optimize::{OptimizeError, polyhedron};
use clench::screw::Vector;
use clench::shape::{Ellipsoid, Extent, Polyhedron, PolyhedronError};

use super::boundary::PieceKind;
use super::document::Document;
use super::fault::{PartFault, listed};
use super::mesh;
use super::number::{FileName, PerPiece, Point, Whole};
use super::part::{Body, checked_stiffness, ellipsoid, one_stiffness};
use super::place::Place;
use super::schema;
use crate::failure::Failure;

/// The vertices of an STL file, which are of single precision, are off their plane by up to this
/// part of the largest coordinate.
const STL_FLATNESS: f64 = 1e-6;

/// A solid, and how far the vertices of one plane may be off it.
#[derive(Debug)]
pub(crate) struct Solid {
    pub(crate) polyhedron: Polyhedron,
    /// By the precision of the file's coordinates (length).
    pub(crate) flatness: f64,
    /// The unit normal into the solid of each face: that of its plane, the same for all in one.
    pub(super) inward_normals: Vec<Vector<3>>,
}

impl Solid {
    fn new(polyhedron: Polyhedron, flatness: f64) -> Self {
        let mut inward_normals = vec![Vector::ZERO; polyhedron.faces().len()];
        for facet in polyhedron.facets(flatness) {
            for &face in facet.faces() {
                inward_normals[face] = facet.inward_normal();
            }
        }
        Self { polyhedron, flatness, inward_normals }
    }
}

/// A spatial part.
#[derive(Debug)]
pub(crate) enum SpatialShape {
    Polyhedron(Box<Solid>),
    Ellipsoid(Ellipsoid<3>),
}

impl SpatialShape {
    /// What decides how far it reaches.
    pub(crate) fn extent(&self) -> Extent<'_, 3> {
        match self {
            Self::Polyhedron(solid) => Extent::from(&solid.polyhedron),
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
    super::tip::tip(document, spatial)?;
    match (&spatial.vertices, &spatial.faces, &spatial.mesh, &spatial.ellipsoid) {
        (Some(vertices), Some(faces), None, None) => {
            let polyhedron = polyhedron(document, vertices, faces)?;
            let stiffness = face_stiffness(document, spatial.stiffness.as_ref(), faces.len())?;
            let solid = Solid::new(polyhedron, 0.0);
            Ok(Body { shape: SpatialShape::Polyhedron(Box::new(solid)), stiffness })
        }
        (None, None, Some(FileName(name)), None) => {
            let path = document.folder().join(name);
            let polyhedron = mesh::read(&path).map_err(|fault| {
                let fault = PartFault::Mesh { name: name.clone(), fault };
                document.error(&Place::spatial().field("mesh"), fault)
            })?;
            let reason = "the faces of a mesh have none of their own";
            let stiffness = one_stiffness(document, &here, spatial.stiffness.as_ref(), reason)?;
            let reach = polyhedron.vertices().iter().map(|v| v.max_abs()).fold(0.0, f64::max);
            let single = mesh::is_of_single_precision(&path);
            let solid = Solid::new(polyhedron, if single { STL_FLATNESS * reach } else { 0.0 });
            Ok(Body { shape: SpatialShape::Polyhedron(Box::new(solid)), stiffness })
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

/// The solid for the placement of fingers on its faces.
pub(crate) fn touchable(
    document: &Document,
    part: &schema::Part,
    body: &Body<Solid>,
) -> Result<polyhedron::Part, Failure> {
    let place = Place::spatial().field("stiffness");
    let Solid { polyhedron, flatness, .. } = &body.shape;
    let stiffness = match body.stiffness.as_deref() {
        None => {
            let fault = PartFault::NoStiffness { piece: PieceKind::Face };
            return Err(document.error(&Place::spatial(), fault));
        }
        Some([one]) => vec![*one; polyhedron.faces().len()],
        Some(each) => each.to_vec(),
    };
    polyhedron::Part::new(polyhedron.clone(), stiffness, *flatness).map_err(|e| {
        let given = part.spatial.as_ref().and_then(|spatial| spatial.stiffness.as_ref());
        let each = matches!(given, Some(PerPiece::Each(_)));
        let place = match e {
            OptimizeError::UnlikeStiffness { faces: [_, face] } if each => place.item(face),
            _ => place,
        };
        document.error(&place, PartFault::PieceStiffness(Box::new(e)))
    })
}

/// The mesh file of a part, if it has one.
pub(crate) fn mesh_file(document: &Document, part: &schema::Part) -> Option<PathBuf> {
    let FileName(name) = part.spatial.as_ref()?.mesh.as_ref()?;
    Some(document.folder().join(name))
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
        PerPiece::All(_) | PerPiece::ByLayer(_) => here.clone(),
        PerPiece::Each(_) => here.clone().item(face),
    };
    let checked = each.into_iter().enumerate();
    checked
        .map(|(face, value)| checked_stiffness(document, &place(face), value))
        .collect::<Result<_, _>>()
        .map(Some)
}
