//! The report on a load case, in the frame of the report.

use clench::screw::Vector;
use clench::stiffness::LiftOff;
use serde::Serialize;

use super::number::{UnitNames, in_plane_a_number};
use crate::analyze::Analysis;
use crate::input::NamedPoint;
use crate::response::Response;
use crate::view::plain;
use crate::wording::digits;

/// Turns up to this angle [rad] are small: what is left out is half of their square, half a
/// percent. So are displacements up to this part of the size of the part.
const SMALL_TURN: f64 = 0.1;

/// What a load on top of the state at rest does.
#[derive(Debug, Serialize)]
pub(crate) struct LoadCaseReport {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) name: Option<String>,
    pub(crate) force: Vec<f64>,
    /// Where the force acts; none if there is a couple only.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) point: Option<Vec<f64>>,
    /// Besides the force, if the file has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) couple: Option<Turning>,
    /// Of force and couple about the frame's origin.
    pub(crate) torque: Turning,
    pub(crate) displacement: DisplacementReport,
    pub(crate) points: Vec<PointReport>,
    pub(crate) largest: LargestReport,
    /// In the order of the contacts.
    pub(crate) contact_forces: Vec<ContactForce>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) first_to_lift_off: Option<LiftOffReport>,
    /// How many times the load can grow until the numbers no longer hold, if ever.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) valid_to: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) tolerance: Option<f64>,
    /// How many times the load can grow until a point moves by the tolerance, if nothing lifts off.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) margin: Option<f64>,
}

/// A torque or a rotation.
#[derive(Debug, Serialize)]
pub(crate) struct Turning(#[serde(serialize_with = "in_plane_a_number")] pub(crate) Vec<f64>);

/// How the part moves.
#[derive(Debug, Serialize)]
pub(crate) struct DisplacementReport {
    /// Of its point at the frame's origin.
    pub(crate) translation: Vec<f64>,
    pub(crate) rotation: Turning,
}

/// How a named point moves.
#[derive(Debug, Serialize)]
pub(crate) struct PointReport {
    pub(crate) name: String,
    pub(crate) point: Vec<f64>,
    pub(crate) displacement: Vec<f64>,
    pub(crate) distance: f64,
}

/// How the point of the part that moves most does.
#[derive(Debug, Serialize)]
pub(crate) struct LargestReport {
    pub(crate) point: Vec<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) corner: Option<usize>,
    pub(crate) displacement: Vec<f64>,
    pub(crate) distance: f64,
}

/// The force of a contact under the load.
#[derive(Debug, Serialize)]
pub(crate) struct ContactForce {
    /// From the preload.
    pub(crate) change: f64,
    pub(crate) force: f64,
}

/// The contact that comes off the part first when the load grows.
#[derive(Debug, Serialize)]
pub(crate) struct LiftOffReport {
    pub(crate) contact: usize,
    /// How many times the load it is then.
    pub(crate) load_factor: f64,
}

impl LoadCaseReport {
    /// The reports on the load cases of `analysis`.
    pub(super) fn all<const N: usize, const M: usize>(analysis: &Analysis<'_, N, M>) -> Vec<Self> {
        analysis.responses.iter().map(|response| Self::new(analysis, response)).collect()
    }

    fn new<const N: usize, const M: usize>(
        analysis: &Analysis<'_, N, M>,
        response: &Response<'_, N, M>,
    ) -> Self {
        let Response { case, displacement, .. } = response;
        let (view, largest) = (&analysis.view, &displacement.largest);
        let origin = view.frame().origin();
        let load = case.about(origin);
        let moved = |point: Vector<N>| view.direction(displacement.at(point));
        let turning = |turning: Vector<M>| Turning(view.turning(turning));
        let rotation = turning(displacement.twist.angular);
        let named = |NamedPoint { name, point }: &NamedPoint<N>| PointReport {
            name: name.clone(),
            point: view.point(*point),
            displacement: moved(*point),
            distance: displacement.at(*point).norm(),
        };
        let margin = case.tolerance.map(|tolerance| displacement.margin(tolerance));
        let first_to_lift_off = response.lift_off.and_then(LiftOffReport::new);
        Self {
            name: case.name.clone(),
            force: view.direction(load.force),
            point: case.force.map(|_| view.point(case.point)),
            couple: case.couple.map(turning),
            torque: turning(load.torque),
            displacement: DisplacementReport { translation: moved(origin), rotation },
            points: analysis.points.iter().map(named).collect(),
            largest: LargestReport {
                point: view.point(largest.point),
                corner: largest.corner,
                displacement: moved(largest.point),
                distance: largest.value,
            },
            contact_forces: contact_forces(analysis, response),
            valid_to: first_to_lift_off.as_ref().map(|first| first.load_factor),
            first_to_lift_off,
            tolerance: case.tolerance,
            margin: margin.filter(|margin| margin.is_finite()),
        }
    }

    /// What a reader has to know before trusting the numbers of load case `number` of a part of
    /// the given `size`.
    pub(super) fn warnings(&self, number: usize, size: f64, units: UnitNames<'_>) -> Vec<String> {
        let case = self.title(number);
        let turn = self.displacement.rotation.0.iter().map(|x| x * x).sum::<f64>().sqrt();
        let is_small = turn <= SMALL_TURN && self.largest.distance <= SMALL_TURN * size;
        let large = (!is_small).then(|| {
            let distance = units.length(self.largest.distance);
            format!(
                "under {case} the part would move by {distance} and turn by {} rad: that is not \
                 small, and the numbers of this load case do not hold",
                digits(turn)
            )
        });
        let lifted = self.first_to_lift_off.as_ref().filter(|first| first.load_factor < 1.0);
        let lifted = lifted.map(|first| {
            let (contact, factor) = (first.contact, digits(first.load_factor));
            format!(
                "under {case} contact {contact} lifts off at {factor} times the load: a finger can \
                 only push, and beyond that the numbers of this load case do not hold"
            )
        });
        let tolerance = self.tolerance.filter(|&tolerance| self.largest.distance > tolerance);
        let exceeded = tolerance.map(|tolerance| {
            let [distance, tolerance] = [self.largest.distance, tolerance].map(|v| units.length(v));
            format!(
                "under {case} the part moves by {distance}, beyond the tolerance of {tolerance}"
            )
        });
        large.into_iter().chain(lifted).chain(exceeded).collect()
    }

    /// The load case by its number, and its name if it has one.
    pub(super) fn title(&self, number: usize) -> String {
        match &self.name {
            Some(name) => format!("load case {number} ({name})"),
            None => format!("load case {number}"),
        }
    }
}

impl LiftOffReport {
    /// What lifts off only under a load that is no number does not.
    fn new(LiftOff { contact, load_factor }: LiftOff) -> Option<Self> {
        load_factor.is_finite().then_some(Self { contact, load_factor: plain(load_factor) })
    }
}

fn contact_forces<const N: usize, const M: usize>(
    analysis: &Analysis<'_, N, M>,
    response: &Response<'_, N, M>,
) -> Vec<ContactForce> {
    let contacts = analysis.grasp.contacts().iter().zip(&response.force_changes);
    contacts
        .map(|(contact, &change)| ContactForce {
            change: plain(change),
            force: plain(contact.preload() + change),
        })
        .collect()
}
