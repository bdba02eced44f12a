//! Solids for the tests of this crate.

use clench_screw::spatial;
use clench_shape::Polyhedron;

pub(crate) use clench_testkit::solids::{Mesh, bracket, cuboid, globe, prism, ring, rough_ball};

/// The same faces over turned and shifted vertices.
pub(crate) fn turned((vertices, faces): &Mesh, pose: &spatial::Frame) -> Mesh {
    let moved = vertices.iter().map(|&v| pose.point_to_parent(v.into()).to_array());
    (moved.collect(), faces.clone())
}

pub(crate) fn solid((vertices, faces): &Mesh) -> Polyhedron {
    Polyhedron::new(vertices, faces).unwrap()
}
