//! Pictures of grasps, from what the reports say.

use clench::optimize::polygon::Part;
use clench_draw::{Finger, GraspPicture, Mark};

use crate::analyze::Analysis;
use crate::report::{LimitWord, OptimumReport, UnitNames, spot};

/// Outlines with more corners, such as flattened arcs, are drawn without their numbers.
const NUMBERED_CORNERS: usize = 40;

/// The part, without fingers.
pub(crate) fn of_part(part: &Part) -> GraspPicture {
    let outline = part.outline();
    let count = outline.corners().len();
    let numbered = if count <= NUMBERED_CORNERS { count } else { 0 };
    GraspPicture {
        outline: outline.corners().iter().map(|corner| corner.to_array()).collect(),
        corner_labels: (0..numbered).map(|corner| corner.to_string()).collect(),
        ..GraspPicture::default()
    }
}

/// The best placement.
pub(crate) fn of_optimum(report: &OptimumReport<'_>, part: &Part) -> GraspPicture {
    let (best, question) = (&report.best, report.question);
    let units = UnitNames(question.units);
    let fingers = best.contacts.iter().enumerate().map(|(i, contact)| Finger {
        point: contact.point,
        inward_normal: contact.inward_normal,
        radius: question.finger_radius,
        label: finger_name(i),
        preload: question.total_preload.map_or(String::new(), |_| units.force(contact.preload)),
    });
    let numbers = Numbers {
        quality: best.quality,
        limited_by: best.limited_by,
        sigma_min: best.sigma_min,
        mu_eq: best.mu_eq,
        center: best.center_of_compliance,
        reach: best.reach.distance,
        corner: best.reach.corner,
        worst_point_stiffness: best.worst_point_stiffness,
    };
    let mut picture = numbers.drawn_on(of_part(part), part, units);
    picture.fingers = fingers.collect();
    let contacts = best.contacts.iter().map(|contact| (contact.edge, contact.point));
    picture.caption.push(String::new());
    picture.caption.extend(placed(contacts, part, units));
    picture
}

/// The grasp that was analyzed, in the frame of the file.
pub(crate) fn of_analysis(analysis: &Analysis<'_>) -> GraspPicture {
    let (part, units) = (analysis.part, UnitNames(analysis.units));
    let contacts = analysis.grasp.contacts();
    let fingers = contacts.iter().enumerate().map(|(i, contact)| Finger {
        point: contact.overlap().point().to_array(),
        inward_normal: contact.overlap().inward_normal().to_array(),
        radius: contact.overlap().geometry().finger.radius().unwrap_or(0.0),
        label: finger_name(i),
        preload: if contact.preload() > 0.0 {
            units.force(contact.preload())
        } else {
            String::new()
        },
    });
    let mut picture = of_part(part);
    if let Ok(metrics) = &analysis.metrics {
        let quality = metrics.quality;
        let numbers = Numbers {
            quality: quality.value,
            limited_by: quality.limited_by.into(),
            sigma_min: quality.translational,
            mu_eq: quality.equivalent,
            center: metrics.principal.center().to_array(),
            reach: quality.reach.distance,
            corner: quality.reach.corner,
            worst_point_stiffness: metrics.worst.stiffness,
        };
        picture = numbers.drawn_on(picture, part, units);
        picture.caption.push(String::new());
    } else {
        picture.caption.push("not held".to_owned());
    }
    picture.fingers = fingers.collect();
    let points = contacts.iter().map(|contact| contact.overlap().point().to_array());
    let contacts = analysis.edges.iter().copied().zip(points);
    picture.caption.extend(placed(contacts, part, units));
    picture
}

/// The numbers beside a picture.
struct Numbers {
    quality: f64,
    limited_by: LimitWord,
    sigma_min: f64,
    mu_eq: f64,
    center: [f64; 2],
    reach: f64,
    corner: usize,
    worst_point_stiffness: f64,
}

impl Numbers {
    fn drawn_on(&self, picture: GraspPicture, part: &Part, units: UnitNames<'_>) -> GraspPicture {
        let stiffness = |value: f64| units.stiffness(value);
        let caption = vec![
            format!("Q = {}", stiffness(self.quality)),
            format!("limited by {}", self.limited_by),
            String::new(),
            format!("σ_{{min}} = {}", stiffness(self.sigma_min)),
            format!("μ_{{eq}} = {}", stiffness(self.mu_eq)),
            format!("ρ_{{max}} = {}, to corner {}", units.length(self.reach), self.corner),
            format!("Q_{{pt}} = {}", stiffness(self.worst_point_stiffness)),
        ];
        GraspPicture {
            center: Some(Mark { point: self.center, label: "c".to_owned() }),
            farthest_corner: Some(part.outline().corners()[self.corner].to_array()),
            caption,
            ..picture
        }
    }
}

/// Where the fingers are, a line for each.
fn placed(
    contacts: impl Iterator<Item = (usize, [f64; 2])>,
    part: &Part,
    units: UnitNames<'_>,
) -> Vec<String> {
    let size = part.outline().enclosing_circle().radius;
    let length = &units.0.length;
    let line = |(i, (edge, point)): (usize, (usize, [f64; 2]))| {
        let at = spot(point, size);
        format!("{} at {at} {length}, edge {edge}", finger_name(i))
    };
    contacts.enumerate().map(line).collect()
}

/// Fingers have letters, so that their numbers are not taken for those of corners.
fn finger_name(finger: usize) -> String {
    format!("F{finger}")
}
