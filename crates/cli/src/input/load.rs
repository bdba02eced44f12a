//! From the loads, named points and load cases of a file to what the libraries take.

use std::collections::HashMap;

use clench::screw::{Vector, Wrench};
use clench::stiffness::DeadLoad;

use super::document::Document;
use super::fault::LoadFault;
use super::grasp::vector;
use super::number::{Finite, Torque};
use super::place::Place;
use super::schema;
use crate::failure::Failure;

/// A point of the part with a name.
#[derive(Clone, Debug)]
pub(crate) struct NamedPoint<const N: usize> {
    pub(crate) name: String,
    pub(crate) point: Vector<N>,
    pub(crate) tolerance: Option<PointTolerance<N>>,
}

/// How far a point may move under each load case.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PointTolerance<const N: usize> {
    /// The largest displacement that is allowed [length].
    pub(crate) allowed: f64,
    /// A unit vector: only the displacement along it is bounded.
    pub(crate) direction: Option<Vector<N>>,
}

/// A load on top of the state at rest.
#[derive(Clone, Debug)]
pub(crate) struct LoadCase<const N: usize, const M: usize> {
    pub(crate) name: Option<String>,
    /// None if the file has a couple only.
    pub(crate) forces: Vec<PointForce<N>>,
    /// Besides the forces.
    pub(crate) couple: Option<Vector<M>>,
    /// The largest displacement that is allowed of any point of the part [length].
    pub(crate) tolerance: Option<f64>,
}

/// A force and where it acts.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PointForce<const N: usize> {
    pub(crate) force: Vector<N>,
    pub(crate) point: Vector<N>,
}

impl<const N: usize, const M: usize> LoadCase<N, M> {
    /// The load about `origin`.
    pub(crate) fn about(&self, origin: Vector<N>) -> Wrench<N, M> {
        let couple = self.couple.unwrap_or(Vector::ZERO);
        let wrench = |at: &PointForce<N>| Wrench::of_force_at(at.force, at.point - origin);
        let forces = self.forces.iter().map(wrench);
        forces.fold(Wrench { force: Vector::ZERO, torque: couple }, |sum, of_one| sum + of_one)
    }
}

/// The forces that act on the part at rest.
pub(super) fn dead_loads<const N: usize>(
    document: &Document,
    given: &[schema::Load],
) -> Result<Vec<DeadLoad<N>>, Failure> {
    let loads = point_forces(document, given, Place::load)?.into_iter();
    Ok(loads.map(|PointForce { force, point }| DeadLoad { point, force }).collect())
}

/// Forces at points, each at a place of the file by its number.
fn point_forces<const N: usize>(
    document: &Document,
    given: &[schema::Load],
    place: impl Fn(usize) -> Place,
) -> Result<Vec<PointForce<N>>, Failure> {
    let load = |(i, load): (usize, &schema::Load)| {
        let vector = |name, numbers| vector(document, &place(i).field(name), numbers);
        let point = vector("point", &load.point)?;
        Ok(PointForce { force: vector("force", &load.force)?, point })
    };
    given.iter().enumerate().map(load).collect()
}

/// The named points of the part, no two of one name.
pub(super) fn named_points<const N: usize>(
    document: &Document,
    given: &[schema::NamedPoint],
) -> Result<Vec<NamedPoint<N>>, Failure> {
    let mut places: HashMap<&str, usize> = HashMap::new();
    let mut points = Vec::new();
    for (i, named) in given.iter().enumerate() {
        let field = |name| Place::named_point(i).field(name);
        let name = &named.name.0;
        if let Some(first) = places.insert(name, i) {
            let fault = LoadFault::RepeatedName { first: Place::named_point(first) };
            return Err(document.error(&field("name"), fault));
        }
        let point = vector(document, &field("point"), &named.point)?;
        let tolerance = point_tolerance(document, &Place::named_point(i), named)?;
        points.push(NamedPoint { name: name.clone(), point, tolerance });
    }
    Ok(points)
}

/// How far a point may move, if the file says so.
fn point_tolerance<const N: usize>(
    document: &Document,
    place: &Place,
    given: &schema::NamedPoint,
) -> Result<Option<PointTolerance<N>>, Failure> {
    let field = |name| place.clone().field(name);
    let tolerance = tolerance(document, place, given.tolerance)?;
    let Some(numbers) = &given.direction else {
        return Ok(tolerance.map(|allowed| PointTolerance { allowed, direction: None }));
    };
    let Some(allowed) = tolerance else {
        return Err(document.error(&field("direction"), LoadFault::DirectionWithoutTolerance));
    };
    let direction: Vector<N> = vector(document, &field("direction"), numbers)?;
    let unit = direction.direction();
    let unit = unit.ok_or_else(|| document.error(&field("direction"), LoadFault::NoDirection))?;
    Ok(Some(PointTolerance { allowed, direction: Some(unit) }))
}

/// The tolerance of the table at `place`, if it has one.
fn tolerance(
    document: &Document,
    place: &Place,
    given: Option<Finite>,
) -> Result<Option<f64>, Failure> {
    match given.map(|tolerance| tolerance.0) {
        Some(value) if value <= 0.0 => {
            let place = place.clone().field("tolerance");
            Err(document.error(&place, LoadFault::Tolerance { value }))
        }
        tolerance => Ok(tolerance),
    }
}

/// The load cases.
pub(super) fn load_cases<const N: usize, const M: usize>(
    document: &Document,
    given: &[schema::LoadCase],
) -> Result<Vec<LoadCase<N, M>>, Failure> {
    let case = |(i, case)| load_case(document, &Place::load_case(i), case);
    given.iter().enumerate().map(case).collect()
}

fn load_case<const N: usize, const M: usize>(
    document: &Document,
    place: &Place,
    given: &schema::LoadCase,
) -> Result<LoadCase<N, M>, Failure> {
    let field = |name| place.clone().field(name);
    if given.force.is_none() && given.forces.is_empty() && given.torque.is_none() {
        return Err(document.error(place, LoadFault::NoLoad));
    }
    let [force, point] =
        [("force", &given.force), ("point", &given.point)].map(|(name, numbers)| {
            numbers.as_ref().map(|numbers| vector(document, &field(name), numbers)).transpose()
        });
    let (force, point): (Option<Vector<N>>, Option<Vector<N>>) = (force?, point?);
    if point.is_some() && force.is_none() && !given.forces.is_empty() {
        return Err(document.error(&field("point"), LoadFault::PointWithoutForce));
    }
    let first = force.map(|force| PointForce { force, point: point.unwrap_or(Vector::ZERO) });
    let more = point_forces(document, &given.forces, |i| field("forces").item(i))?;
    let couple = given.torque.as_ref().map(torque).transpose();
    let couple = couple.map_err(|fault| document.error(&field("torque"), fault))?;
    Ok(LoadCase {
        name: given.name.as_ref().map(|name| name.0.clone()),
        forces: first.into_iter().chain(more).collect(),
        couple,
        tolerance: tolerance(document, place, given.tolerance)?,
    })
}

/// The torque, if it has as many numbers as the part has rotations.
fn torque<const M: usize>(given: &Torque) -> Result<Vector<M>, LoadFault> {
    let wrong = if M == 1 { LoadFault::SpatialTorque } else { LoadFault::PlanarTorque };
    <[f64; M]>::try_from(&given.0[..]).map(Vector::new).map_err(|_| wrong)
}
