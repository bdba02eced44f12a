//! The report on a load case, in the frame of the report.

use clench::screw::Vector;
use clench::stiffness::LiftOff;
use serde::Serialize;

use super::case_verdict::{CaseVerdict, PointCheck, lifted};
use super::number::{UnitNames, in_plane_a_number};
use crate::analyze::Analysis;
use crate::input::{NamedPoint, PointForce, PointTolerance};
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
    /// The sum of all forces.
    pub(crate) force: Vec<f64>,
    /// Where the force acts, if it is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) point: Option<Vec<f64>>,
    /// If they are several.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(crate) forces: Vec<ForceReport>,
    /// Besides the forces, if the file has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) couple: Option<Turning>,
    /// Of forces and couple about the frame's origin.
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
    /// What is left of the tolerance, negative where it is exceeded.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) room: Option<f64>,
    pub(crate) verdict: CaseVerdict,
}

/// A force and where it acts.
#[derive(Debug, Serialize)]
pub(crate) struct ForceReport {
    pub(crate) force: Vec<f64>,
    pub(crate) point: Vec<f64>,
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
    /// Of its tolerance, if it has one.
    #[serde(flatten)]
    pub(crate) check: Option<PointCheck>,
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
        let margin = case.tolerance.map(|tolerance| displacement.margin(tolerance));
        let first_to_lift_off = response.lift_off.and_then(LiftOffReport::new);
        let mut report = Self {
            name: case.name.clone(),
            force: view.direction(load.force),
            point: match &case.forces[..] {
                [one] => Some(view.point(one.point)),
                _ => None,
            },
            forces: forces(analysis, &case.forces),
            couple: case.couple.map(turning),
            torque: turning(load.torque),
            displacement: DisplacementReport { translation: moved(origin), rotation },
            points: named_points(analysis, response),
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
            room: case.tolerance.map(|tolerance| tolerance - largest.value),
            verdict: CaseVerdict::default(),
        };
        report.verdict = CaseVerdict::on(&mut report, analysis.size, UnitNames(analysis.units));
        report
    }

    /// Whether turn and displacement are small beside a part of the given `size`.
    pub(super) fn is_small(&self, size: f64) -> bool {
        self.turn() <= SMALL_TURN && self.largest.distance <= SMALL_TURN * size
    }

    fn turn(&self) -> f64 {
        self.displacement.rotation.0.iter().map(|x| x * x).sum::<f64>().sqrt()
    }

    /// What a reader has to know before trusting the numbers of load case `number` of a part of
    /// the given `size`.
    pub(super) fn warnings(&self, number: usize, size: f64, units: UnitNames<'_>) -> Vec<String> {
        let case = self.title(number);
        let large = (!self.is_small(size)).then(|| {
            let distance = units.length(self.largest.distance);
            format!(
                "under {case} the part would move by {distance} and turn by {} rad: that is not \
                 small, and the numbers of this load case do not hold",
                digits(self.turn())
            )
        });
        let lifted = lifted(self).map(|first| {
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
        let of_points = self.points.iter().filter_map(|point| point.exceeded(units));
        let of_points = of_points.map(|exceeded| format!("under {case} {exceeded}"));
        large.into_iter().chain(lifted).chain(exceeded).chain(of_points).collect()
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

/// The forces of a load case, if they are several.
fn forces<const N: usize, const M: usize>(
    analysis: &Analysis<'_, N, M>,
    forces: &[PointForce<N>],
) -> Vec<ForceReport> {
    let view = &analysis.view;
    let several = if forces.len() > 1 { forces } else { &[] };
    let report = |at: &PointForce<N>| ForceReport {
        force: view.direction(at.force),
        point: view.point(at.point),
    };
    several.iter().map(report).collect()
}

fn named_points<const N: usize, const M: usize>(
    analysis: &Analysis<'_, N, M>,
    response: &Response<'_, N, M>,
) -> Vec<PointReport> {
    let (view, displacement) = (&analysis.view, &response.displacement);
    let named = |NamedPoint { name, point, tolerance }: &NamedPoint<N>| {
        let moved = displacement.at(*point);
        let check = |PointTolerance { allowed, direction }: PointTolerance<N>| {
            let along = direction.map(|direction| moved.dot(direction));
            let found = along.map_or(moved.norm(), f64::abs);
            let margin = allowed / found;
            PointCheck {
                tolerance: allowed,
                direction: direction.map(|direction| view.direction(direction)),
                along: along.map(plain),
                margin: margin.is_finite().then_some(margin),
                room: allowed - found,
                passes: false,
            }
        };
        PointReport {
            name: name.clone(),
            point: view.point(*point),
            displacement: view.direction(moved),
            distance: moved.norm(),
            check: tolerance.map(check),
        }
    };
    analysis.points.iter().map(named).collect()
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
