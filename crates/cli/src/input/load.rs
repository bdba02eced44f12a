//! From the loads, named points and load cases of a file to what the libraries take.

use std::collections::HashMap;

use clench::screw::{Vector, Wrench};
use clench::stiffness::DeadLoad;

use super::document::Document;
use super::fault::LoadFault;
use super::grasp::vector;
use super::number::Torque;
use super::place::Place;
use super::schema;
use crate::failure::Failure;

/// A point of the part with a name.
#[derive(Clone, Debug)]
pub(crate) struct NamedPoint<const N: usize> {
    pub(crate) name: String,
    pub(crate) point: Vector<N>,
}

/// A load on top of the state at rest.
#[derive(Clone, Debug)]
pub(crate) struct LoadCase<const N: usize, const M: usize> {
    pub(crate) name: Option<String>,
    /// None if the file has a couple only.
    pub(crate) force: Option<Vector<N>>,
    /// Where the force acts.
    pub(crate) point: Vector<N>,
    /// Besides the force.
    pub(crate) couple: Option<Vector<M>>,
    /// The largest displacement that is allowed of any point of the part [length].
    pub(crate) tolerance: Option<f64>,
}

impl<const N: usize, const M: usize> LoadCase<N, M> {
    /// The load about `origin`.
    pub(crate) fn about(&self, origin: Vector<N>) -> Wrench<N, M> {
        let force = self.force.unwrap_or(Vector::ZERO);
        let of_force = Wrench::of_force_at(force, self.point - origin);
        Wrench { torque: of_force.torque + self.couple.unwrap_or(Vector::ZERO), ..of_force }
    }
}

/// The forces that act on the part at rest.
pub(super) fn dead_loads<const N: usize>(
    document: &Document,
    given: &[schema::Load],
) -> Result<Vec<DeadLoad<N>>, Failure> {
    let load = |(i, load): (usize, &schema::Load)| {
        let vector = |name, numbers| vector(document, &Place::load(i).field(name), numbers);
        Ok(DeadLoad { point: vector("point", &load.point)?, force: vector("force", &load.force)? })
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
        points.push(NamedPoint { name: name.clone(), point });
    }
    Ok(points)
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
    if given.force.is_none() && given.torque.is_none() {
        return Err(document.error(place, LoadFault::NoLoad));
    }
    let [force, point] =
        [("force", &given.force), ("point", &given.point)].map(|(name, numbers)| {
            numbers.as_ref().map(|numbers| vector(document, &field(name), numbers)).transpose()
        });
    let couple = given.torque.as_ref().map(torque).transpose();
    let couple = couple.map_err(|fault| document.error(&field("torque"), fault))?;
    if let Some(tolerance) = given.tolerance.filter(|tolerance| tolerance.0 <= 0.0) {
        let fault = LoadFault::Tolerance { value: tolerance.0 };
        return Err(document.error(&field("tolerance"), fault));
    }
    Ok(LoadCase {
        name: given.name.as_ref().map(|name| name.0.clone()),
        force: force?,
        point: point?.unwrap_or(Vector::ZERO),
        couple,
        tolerance: given.tolerance.map(|tolerance| tolerance.0),
    })
}

/// The torque, if it has as many numbers as the part has rotations.
fn torque<const M: usize>(given: &Torque) -> Result<Vector<M>, LoadFault> {
    let wrong = if M == 1 { LoadFault::SpatialTorque } else { LoadFault::PlanarTorque };
    <[f64; M]>::try_from(&given.0[..]).map(Vector::new).map_err(|_| wrong)
}
