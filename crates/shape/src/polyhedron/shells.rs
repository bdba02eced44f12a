//! The shells of a solid: pieces of its surface, one inside the other or beside each other.

use std::collections::{BTreeMap, BTreeSet};

use clench_screw::Vector;

use super::face::FLAT_ROUNDING;
use super::surface::{FaceTree, foot_on};
use super::validity::SolidEdge;
use super::{Face, PolyhedronError};
use crate::predicates::turn;

/// The volume that rounded coordinates may add to a flat solid, over the area of its faces: a
/// shift of each face by two roundings of a coordinate and two of the arithmetic.
const VOLUME_ROUNDING: f64 = 4.0 * f64::EPSILON;

/// For each face the lowest one of its shell, to which one can walk from it over edges.
pub(super) fn first_faces(count: usize, edges: &[SolidEdge]) -> Vec<usize> {
    let mut leaders: Vec<usize> = (0..count).collect();
    for edge in edges {
        let [one, other] = edge.faces.map(|face| leader(&mut leaders, face));
        leaders[one.max(other)] = one.min(other);
    }
    (0..count).map(|face| leader(&mut leaders, face)).collect()
}

/// The face that stands for the piece of `face`; the way there is halved for the next time.
fn leader(leaders: &mut [usize], mut face: usize) -> usize {
    while leaders[face] != face {
        leaders[face] = leaders[leaders[face]];
        face = leaders[face];
    }
    face
}

/// A closed surface whose edges each join two faces, in pieces that are called by their lowest
/// faces.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shells<'a> {
    pub(super) vertices: &'a [Vector<3>],
    pub(super) faces: &'a [Face],
    pub(super) first_faces: &'a [usize],
    pub(super) tree: &'a FaceTree,
}

/// What a shell encloses, negative if it is wound clockwise seen from outside of it.
#[derive(Clone, Copy, Debug, Default)]
struct Measure {
    volume: f64,
    area: f64,
}

impl Shells<'_> {
    /// The volume, and in how many pieces it is, where each shell has a volume and is wound as its
    /// place needs; `center` is near the solid, whose coordinates are up to `largest`.
    pub(super) fn checked_volume(
        &self,
        center: Vector<3>,
        largest: f64,
    ) -> Result<(f64, usize), PolyhedronError> {
        let measures = self.measures(center);
        for (&face, &Measure { volume, area }) in &measures {
            let allowed = VOLUME_ROUNDING * area * largest;
            if volume.abs() <= allowed {
                return Err(PolyhedronError::ZeroVolume { face, volume, allowed });
            }
        }
        if measures.len() > 1 {
            self.check_nesting(&measures, FLAT_ROUNDING * largest)?;
        }
        let volume = measures.values().map(|shell| shell.volume).sum();
        match measures.iter().find(|(_, shell)| shell.volume < 0.0) {
            // The only shell, or one that touches or crosses another.
            Some((&face, &Measure { volume: own, .. })) if volume <= 0.0 => {
                Err(PolyhedronError::InsideOut { face, volume: own })
            }
            // The other shells are those of cavities.
            _ => Ok((volume, measures.values().filter(|shell| shell.volume > 0.0).count())),
        }
    }

    /// Of each shell a third of the areas of its faces times their heights over the center.
    fn measures(&self, center: Vector<3>) -> BTreeMap<usize, Measure> {
        let mut measures = BTreeMap::<usize, Measure>::new();
        for (face, first) in self.faces.iter().zip(self.first_faces) {
            let shell = measures.entry(*first).or_default();
            shell.volume -= face.inward_normal().dot(face.point() - center) * face.area() / 3.0;
            shell.area += face.area();
        }
        measures
    }

    /// A shell inside an even number of others has to be wound outward, one inside an odd number
    /// inward: it is that of a cavity.
    ///
    /// The fault of the outermost shell is named, since it makes those inside of it look wrong.
    fn check_nesting(
        &self,
        measures: &BTreeMap<usize, Measure>,
        margin: f64,
    ) -> Result<(), PolyhedronError> {
        let mut members = BTreeMap::<usize, Vec<usize>>::new();
        for (face, &first) in self.first_faces.iter().enumerate() {
            members.entry(first).or_default().push(face);
        }
        let volume = |shell: usize| measures.get(&shell).map_or(0.0, |measure| measure.volume);
        let misplaced = members.iter().filter_map(|(&own, faces)| {
            let around = self.around_if_misplaced(faces, volume(own) > 0.0, margin)?;
            Some((own, around))
        });
        let Some((face, around)) = misplaced.min_by_key(|(_, around)| around.len()) else {
            return Ok(());
        };
        let smaller =
            |one: &usize, other: &usize| volume(*one).abs().total_cmp(&volume(*other).abs());
        Err(match around.into_iter().min_by(smaller) {
            None => PolyhedronError::InsideOut { face, volume: volume(face) },
            Some(around) => PolyhedronError::NestedAlike { face, around },
        })
    }

    /// The shells around the one with these faces, unless it is wound as their number needs.
    ///
    /// One vertex tells, if it is not on another shell. If a vertex that fits is found after one
    /// that does not, then the shell passes through another by what only rounding explains.
    fn around_if_misplaced(
        &self,
        faces: &[usize],
        is_outward: bool,
        margin: f64,
    ) -> Option<BTreeSet<usize>> {
        let own = self.first_faces[faces[0]];
        let mut misplaced = None;
        for &corner in faces.iter().flat_map(|&face| self.faces[face].vertices()) {
            let Some(around) = self.around(self.vertices[corner], own, margin) else {
                continue;
            };
            if is_outward == around.len().is_multiple_of(2) {
                return None;
            }
            misplaced = misplaced.or(Some(around));
        }
        misplaced
    }

    /// The shells other than `own` that are around `point`: those that the ray from there along
    /// the x axis meets an odd number of times. None if one is within `margin`.
    fn around(&self, point: Vector<3>, own: usize, margin: f64) -> Option<BTreeSet<usize>> {
        let mut around = BTreeSet::new();
        for face in self.tree.along_x(point, margin) {
            let (shell, face) = (self.first_faces[face], &self.faces[face]);
            if shell == own {
                continue;
            }
            let corners = face.vertices().iter().map(|&corner| self.vertices[corner][0]);
            let is_ahead = corners.fold(f64::INFINITY, f64::min) > point[0] + margin;
            if !is_ahead && foot_on(self.vertices, face, point).distance <= margin {
                return None;
            }
            let rise = face.inward_normal().dot(face.point() - point);
            let is_met = is_ahead || (rise > 0.0) == (face.inward_normal()[0] > 0.0);
            if is_met && covers_along_x(self.vertices, face, point) && !around.remove(&shell) {
                around.insert(shell);
            }
        }
        Some(around)
    }
}

/// Whether the line along the x axis through `point` meets a face: decided exactly, and at an
/// edge for just one of its faces if they go on from there to both sides, so that the line meets
/// a closed surface an even number of times.
fn covers_along_x(vertices: &[Vector<3>], face: &Face, point: Vector<3>) -> bool {
    let flat = |v: Vector<3>| Vector::new([v[1], v[2]]);
    let mut inside = false;
    for [from, to] in face.edges() {
        let [a, b, at] = [vertices[from], vertices[to], point].map(flat);
        if (a[1] > at[1]) != (b[1] > at[1]) {
            // The same from both faces of the edge.
            let [low, high] = if a[1] < b[1] { [a, b] } else { [b, a] };
            inside ^= turn(low, high, at) > 0.0;
        }
    }
    inside
}
