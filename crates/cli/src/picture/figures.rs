//! The pictures of a page: more than what `--svg` draws, since the numbers are beside them.

use clench::metrics::{Principal, REPEATED};
use clench::optimize::Solution;
use clench::screw::Vector;
use clench_draw::{
    Direction, Displaced, DrawError, Finger, GraspPicture, Load, Mark, SolidDisplaced, SolidFinger,
    SolidLoad, SolidPicture, exaggeration,
};

use super::scene::{Frame, Scene, Tip};
use super::{array, finger_name};
use crate::analyze::Analysis;
use crate::input::{NamedPoint, PointForce};
use crate::report::{OptimumReport, PlacementReport, UnitNames};
use crate::response::Response;

/// The pictures of a page, as SVG.
#[derive(Debug)]
pub(crate) struct Figures {
    /// The part with its fingers.
    pub(crate) grasp: String,
    /// The same in space, to be turned.
    pub(crate) scene: Option<Scene>,
    /// The part under each load case.
    pub(crate) cases: Vec<CaseFigure>,
    /// The best placements, small.
    pub(crate) places: Vec<String>,
}

/// The part under a load case.
#[derive(Debug)]
pub(crate) struct CaseFigure {
    pub(crate) svg: String,
    /// How many times as far the displacement is drawn; none if there is none.
    pub(crate) exaggeration: Option<f64>,
}

impl Figures {
    /// Those of a grasp of a planar part, of which `picture` is the one with all numbers.
    pub(crate) fn of_analysis(
        analysis: &Analysis<'_, 2, 1>,
        picture: &GraspPicture,
    ) -> Result<Self, DrawError> {
        let mut grasp = bare(picture);
        let contacts = analysis.grasp.contacts().iter();
        for (finger, contact) in grasp.fingers.iter_mut().zip(contacts) {
            finger.force = contact.preload();
        }
        if let Ok(metrics) = &analysis.metrics {
            grasp = with_marks(grasp, &metrics.principal, metrics.worst.point);
        }
        let cases = analysis.responses.iter().map(|response| {
            let exaggeration = drawn_times(analysis, response);
            let figure = under_load(analysis, response, picture).figure()?;
            Ok(CaseFigure { svg: figure.to_svg(), exaggeration })
        });
        let cases = cases.collect::<Result<_, DrawError>>()?;
        Ok(Self { grasp: grasp.figure()?.to_svg(), scene: None, cases, places: Vec::new() })
    }

    /// Those of placements on an outline.
    pub(crate) fn of_optimum(
        report: &OptimumReport<'_>,
        best: &Solution<2, 1>,
        picture: &GraspPicture,
    ) -> Result<Self, DrawError> {
        let mut grasp = bare(picture);
        for (finger, contact) in grasp.fingers.iter_mut().zip(&report.best.contacts) {
            finger.force = contact.share;
        }
        let worst = Vector::new(array(&report.best.worst_point));
        let grasp = with_marks(grasp, &best.principal, worst).figure()?.to_svg();
        let places = report.top.iter().map(|placement| {
            let fingers = placed(placement, report.question.finger_radius);
            let small = GraspPicture {
                outline: picture.outline.clone(),
                holes: picture.holes.clone(),
                fingers,
                ..GraspPicture::default()
            };
            Ok(small.figure()?.to_svg())
        });
        let places = places.collect::<Result<_, DrawError>>()?;
        Ok(Self { grasp, scene: None, cases: Vec::new(), places })
    }

    /// Those of a grasp of a solid.
    pub(crate) fn of_analysis_in_space(
        analysis: &Analysis<'_, 3, 3>,
        picture: &SolidPicture,
    ) -> Result<Self, DrawError> {
        let grasp = SolidPicture { caption: Vec::new(), ..picture.clone() };
        let units = UnitNames(analysis.units);
        let view = grasp.seen_from()?;
        let frame = Frame::around(&picture.faces);
        let tips = analysis.grasp.contacts().iter().map(|contact| {
            let radius = contact.overlap().geometry().finger.radius();
            Tip { radius: radius.unwrap_or(0.0), force: contact.preload(), shown: None }
        });
        let tips = tips.map(|tip| tip.with_value(units)).collect::<Vec<_>>();
        let mut scene = Scene::new(&grasp, &tips, frame, view);
        let mut cases = Vec::new();
        for response in &analysis.responses {
            let drawn = solid_under_load(analysis, response, &grasp, view);
            let svg = drawn.figure()?.to_svg();
            scene.add_case(&drawn, frame);
            cases.push(CaseFigure { svg, exaggeration: drawn_times(analysis, response) });
        }
        let grasp = grasp.figure()?.to_svg();
        Ok(Self { grasp, scene: Some(scene), cases, places: Vec::new() })
    }

    /// Those of placements on a solid.
    pub(crate) fn of_optimum_on_solid(
        report: &OptimumReport<'_>,
        picture: &SolidPicture,
    ) -> Result<Self, DrawError> {
        let grasp = SolidPicture { caption: Vec::new(), ..picture.clone() };
        let units = UnitNames(report.question.units);
        let view = grasp.seen_from()?;
        let tips = report.best.contacts.iter().map(|contact| {
            let radius = contact.finger.radius.map_or(0.0, |radius| radius.0);
            let tip = Tip { radius, force: contact.share, shown: None };
            match report.question.total_preload {
                Some(_) => Tip { shown: Some(units.force(contact.preload)), ..tip },
                None => tip,
            }
        });
        let tips = tips.collect::<Vec<_>>();
        let scene = Scene::new(&grasp, &tips, Frame::around(&picture.faces), view);
        let places = report.top.iter().map(|placement| {
            let fingers = placement.contacts.iter().map(|contact| SolidFinger {
                point: array(&contact.point),
                inward_normal: array(&contact.inward_normal),
                label: String::new(),
                fixed: contact.fixed,
            });
            let small = SolidPicture {
                faces: picture.faces.clone(),
                fingers: fingers.collect(),
                view: Some(view),
                ..SolidPicture::default()
            };
            Ok(small.figure()?.to_svg())
        });
        let places = places.collect::<Result<_, DrawError>>()?;
        let grasp = grasp.figure()?.to_svg();
        Ok(Self { grasp, scene: Some(scene), cases: Vec::new(), places })
    }
}

/// The picture without the numbers beside it, which the page has in tables.
fn bare(picture: &GraspPicture) -> GraspPicture {
    GraspPicture { caption: Vec::new(), ..picture.clone() }
}

/// The picture with the principal directions and the worst point.
fn with_marks(
    picture: GraspPicture,
    principal: &Principal<2, 1>,
    worst: Vector<2>,
) -> GraspPicture {
    let sigma = principal.translational();
    let [least, most] = sigma.values;
    let directions =
        ["min", "max"].iter().zip(sigma.vectors).map(|(name, along)| Direction {
            along: along.to_array(),
            label: format!("σ_{{{name}}}"),
        });
    let distinct = most - least > REPEATED * most;
    let mut notes = picture.notes;
    notes.push(Mark { point: worst.to_array(), label: "w".to_owned() });
    let directions = if distinct { directions.collect() } else { Vec::new() };
    GraspPicture { directions, notes, ..picture }
}

fn placed(placement: &PlacementReport, radius: f64) -> Vec<Finger> {
    let fingers = placement.contacts.iter().map(|contact| Finger {
        point: array(&contact.point),
        inward_normal: array(&contact.inward_normal),
        radius,
        force: contact.share,
        ..Finger::default()
    });
    fingers.collect()
}

/// How many times as far a displacement is drawn.
fn drawn_times<const N: usize, const M: usize>(
    analysis: &Analysis<'_, N, M>,
    response: &Response<'_, N, M>,
) -> Option<f64> {
    exaggeration(response.displacement.largest.value, 2.0 * analysis.size)
}

/// The part and the forces of its contacts under a load.
fn under_load(
    analysis: &Analysis<'_, 2, 1>,
    response: &Response<'_, 2, 1>,
    picture: &GraspPicture,
) -> GraspPicture {
    let units = UnitNames(analysis.units);
    let contacts = analysis.grasp.contacts().iter().zip(&response.force_changes);
    let fingers = picture.fingers.iter().zip(contacts).enumerate();
    let fingers = fingers.map(|(i, (finger, (contact, change)))| {
        let force = contact.preload() + change;
        Finger {
            force: force.max(0.0),
            label: finger_name(i),
            preload: if force > 0.0 { units.force(force) } else { "off".to_owned() },
            ..finger.clone()
        }
    });
    let corners = picture.outline.iter().chain(picture.holes.iter().flatten());
    let shifts = corners.map(|&corner| response.displacement.at(corner.into()).to_array());
    let load = |PointForce { force, point }: &PointForce<2>| {
        let (point, along) = (point.to_array(), force.direction()?.to_array());
        Some(Load { point, along, label: units.force(force.norm()) })
    };
    let point =
        |named: &NamedPoint<2>| Mark { point: named.point.to_array(), label: named.name.clone() };
    GraspPicture {
        outline: picture.outline.clone(),
        holes: picture.holes.clone(),
        fingers: fingers.collect(),
        displaced: drawn_times(analysis, response)
            .map(|exaggeration| Displaced { shifts: shifts.collect(), exaggeration }),
        loads: response.case.forces.iter().filter_map(load).collect(),
        notes: analysis.points.iter().map(point).collect(),
        ..GraspPicture::default()
    }
}

fn solid_under_load(
    analysis: &Analysis<'_, 3, 3>,
    response: &Response<'_, 3, 3>,
    picture: &SolidPicture,
    view: [f64; 3],
) -> SolidPicture {
    let units = UnitNames(analysis.units);
    let displacement = &response.displacement;
    let load = |PointForce { force, point }: &PointForce<3>| {
        let (point, along) = (point.to_array(), force.direction()?.to_array());
        Some(SolidLoad { point, along, label: units.force(force.norm()) })
    };
    SolidPicture {
        faces: picture.faces.clone(),
        fingers: picture.fingers.clone(),
        displaced: drawn_times(analysis, response).map(|exaggeration| SolidDisplaced {
            about: displacement.origin.to_array(),
            translation: displacement.twist.linear.to_array(),
            rotation: displacement.twist.angular.to_array(),
            exaggeration,
        }),
        loads: response.case.forces.iter().filter_map(load).collect(),
        view: Some(view),
        ..SolidPicture::default()
    }
}
