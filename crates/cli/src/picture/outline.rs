//! Pictures of planar grasps, from what the reports say.

use std::ops::Range;

use clench::optimize::polygon::{Part, Stretch};
use clench::screw::Vector;
use clench::shape::{Ellipsoid, Farthest, Polygon};
use clench_draw::{Color, Finger, GraspPicture, Mark, Region};

use super::{array, finger_name};
use crate::analyze::Analysis;
use crate::input::{Piece, PlanarShape};
use crate::metrics::Metrics;
use crate::report::{LimitWord, OptimumInPlane, OptimumReport, UnitNames, spot};

/// Outlines with more corners are drawn without their numbers.
const NUMBERED_CORNERS: usize = 40;

/// A corner between edges that are both shorter than this, beside the part's radius, such as those
/// of a flattened arc, has no room for its number.
const NUMBER_ROOM: f64 = 0.12;

/// An ellipse is drawn with this many corners: on a page of a thousand points they are less than
/// a hundredth of a point off.
const SMOOTH_CORNERS: usize = 360;

/// Regions are drawn up to so many radii from the part's center.
const SHOWN: f64 = 1.5;

/// How wide strips without fingers are drawn, beside the part's radius; in a hole no wider than
/// this part of it.
const STRIP: f64 = 0.03;
const STRIP_IN_HOLE: f64 = 0.15;

/// A plate is drawn with so many holes at most.
const SHOWN_HOLES: f64 = 1e3;

/// The part, without fingers.
fn of_outline(outline: &Polygon) -> GraspPicture {
    let count = outline.corners().len();
    let labels = if count <= NUMBERED_CORNERS { numbers(outline) } else { Vec::new() };
    let corners = |run: &Range<usize>| {
        outline.corners()[run.clone()].iter().map(|corner| corner.to_array()).collect()
    };
    let mut loops = outline.loops().iter().map(corners);
    GraspPicture {
        outline: loops.next().unwrap_or_default(),
        holes: loops.collect(),
        corner_labels: labels,
        ..GraspPicture::default()
    }
}

/// The numbers of corners, of those that have room for them.
fn numbers(outline: &Polygon) -> Vec<String> {
    let room = NUMBER_ROOM * outline.enclosing_circle().radius;
    let is_short = |edge: usize| outline.edges()[edge].length() < room;
    let number = |run: &Range<usize>, corner: usize| {
        let before = if corner == run.start { run.end - 1 } else { corner - 1 };
        let is_dense = is_short(corner) && is_short(before);
        if is_dense { String::new() } else { corner.to_string() }
    };
    let of = |run: &Range<usize>| run.clone().map(|corner| number(run, corner)).collect::<Vec<_>>();
    outline.loops().iter().flat_map(of).collect()
}

fn of_ellipse(ellipse: &Ellipsoid<2>) -> GraspPicture {
    let [a, b] = ellipse.semi_axes();
    let corner = |i: usize| {
        let (sine, cosine) = (std::f64::consts::TAU * i as f64 / SMOOTH_CORNERS as f64).sin_cos();
        let from_center = *ellipse.axes() * Vector::new([a * cosine, b * sine]);
        (ellipse.center() + from_center).to_array()
    };
    GraspPicture { outline: (0..SMOOTH_CORNERS).map(corner).collect(), ..GraspPicture::default() }
}

/// The best placement.
pub(crate) fn of_optimum(report: &OptimumReport<'_>, part: &Part) -> GraspPicture {
    let (best, question) = (&report.best, report.question);
    let units = UnitNames(question.units);
    let fingers = best.contacts.iter().enumerate().map(|(i, contact)| Finger {
        point: array(&contact.point),
        inward_normal: array(&contact.inward_normal),
        radius: question.finger_radius,
        label: finger_name(i),
        preload: question.total_preload.map_or(String::new(), |_| units.force(contact.preload)),
        ..Finger::default()
    });
    let mut picture = of_outline(part.outline());
    if let Some(OptimumInPlane { center_of_compliance, reach }) = &best.in_plane {
        let numbers = Numbers {
            quality: best.quality,
            limited_by: best.limited_by,
            sigma_min: best.sigma_min,
            mu_eq: best.mu_eq,
            center: array(center_of_compliance),
            farthest: Farthest {
                point: Vector::new(array(&reach.point)),
                corner: reach.corner,
                value: reach.distance,
            },
            worst_point_stiffness: best.worst_point_stiffness,
        };
        picture = numbers.drawn_on(picture, units);
    }
    picture.fingers = fingers.collect();
    let contacts = best.contacts.iter().map(|contact| (contact.edge, array(&contact.point)));
    picture.caption.push(String::new());
    let size = part.outline().enclosing_circle().radius;
    picture.caption.extend(placed(contacts, size, units));
    picture.regions = kept_out(report, part);
    if !picture.regions.is_empty() {
        picture.caption.extend([String::new(), "grey: kept out of".to_owned()]);
    }
    let gaps = untouchable(part);
    if !gaps.is_empty() {
        picture.caption.extend([String::new(), "shaded: no finger".to_owned()]);
        picture.regions.extend(gaps.into_iter().map(|gap| shaded(part, gap)));
    }
    picture.notes = plate_holes(report, part);
    if !picture.notes.is_empty() {
        picture.caption.extend([String::new(), "dots: holes of the plate".to_owned()]);
    }
    picture
}

/// The holes of the plate around the part, unless they are too many.
fn plate_holes(report: &OptimumReport<'_>, part: &Part) -> Vec<Mark> {
    let planar = report.question.part.planar.as_ref();
    let Some(plate) = planar.and_then(|planar| planar.plate.as_ref()) else { return Vec::new() };
    let circle = part.outline().enclosing_circle();
    let offset = plate.offset.map_or([0.0; 2], |offset| offset.0);
    let around = circle.radius + report.question.finger_radius;
    let axis = |i: usize| {
        let index = |at: f64| (at - offset[i]) / plate.pitch.0[i];
        (index(circle.center[i] - around).ceil(), index(circle.center[i] + around).floor())
    };
    let [(left, right), (low, high)] = [axis(0), axis(1)];
    if (right - left + 1.0) * (high - low + 1.0) > SHOWN_HOLES {
        return Vec::new();
    }
    let steps = |from: f64, to: f64| {
        std::iter::successors(Some(from), |at| Some(at + 1.0)).take_while(move |at| *at <= to)
    };
    let hole = |x: f64, y: f64| Mark {
        point: [offset[0] + x * plate.pitch.0[0], offset[1] + y * plate.pitch.0[1]],
        label: String::new(),
    };
    steps(left, right).flat_map(|x| steps(low, high).map(move |y| hole(x, y))).collect()
}

/// The regions that fingers keep out of, as far as they are near the part.
fn kept_out(report: &OptimumReport<'_>, part: &Part) -> Vec<Region> {
    let circle = part.outline().enclosing_circle();
    let near = |corner: [f64; 2]| -> [f64; 2] {
        std::array::from_fn(|i| {
            let far = SHOWN * circle.radius;
            corner[i].clamp(circle.center[i] - far, circle.center[i] + far)
        })
    };
    let planar = report.question.part.planar.as_ref();
    let regions = planar.map_or(&[][..], |planar| &planar.keep_out);
    let shown = regions.iter().map(|corners| Region {
        corners: corners.iter().map(|corner| near(corner.0)).collect(),
        color: Color::GREY,
    });
    shown.collect()
}

/// The stretches of edges that fingers may not touch.
fn untouchable(part: &Part) -> Vec<Stretch> {
    let mut gaps = Vec::new();
    for (edge, side) in part.outline().edges().iter().enumerate() {
        let mut reached = 0.0;
        for stretch in part.stretches().iter().filter(|stretch| stretch.edge == edge) {
            gaps.push(Stretch { edge, from: reached, to: stretch.from });
            reached = stretch.to;
        }
        gaps.push(Stretch { edge, from: reached, to: side.length() });
    }
    gaps.retain(|gap| gap.from < gap.to);
    gaps
}

/// A strip along a stretch, on the outer side of its edge.
fn shaded(part: &Part, gap: Stretch) -> Region {
    let edge = &part.outline().edges()[gap.edge];
    let out = edge.inward_normal() * -width(part.outline(), gap.edge);
    let [from, to] = [gap.from, gap.to].map(|along| edge.point_at(along));
    let corners = [from, to, to + out, from + out].map(Vector::to_array);
    Region { corners: corners.to_vec(), color: Color::ORANGE }
}

/// How wide strips are along the loop of an edge.
fn width(outline: &Polygon, edge: usize) -> f64 {
    let most = STRIP * outline.enclosing_circle().radius;
    let hole = outline.loops().iter().skip(1).find(|run| run.contains(&edge));
    hole.map_or(most, |run| {
        let extent = |i: usize| {
            let values = outline.corners()[run.clone()].iter().map(|corner| corner[i]);
            let (low, high) = (values.clone().fold(f64::INFINITY, f64::min), values);
            high.fold(f64::NEG_INFINITY, f64::max) - low
        };
        most.min(STRIP_IN_HOLE * extent(0).min(extent(1)))
    })
}

/// The grasp that was analyzed, in the frame of the file.
pub(crate) fn of_analysis(analysis: &Analysis<'_, 2, 1>, shape: &PlanarShape) -> GraspPicture {
    let units = UnitNames(analysis.units);
    let picture = match shape {
        PlanarShape::Outline(outline) => of_outline(outline),
        PlanarShape::Ellipse(ellipse) => of_ellipse(ellipse),
    };
    let mut picture = held(analysis, picture);
    let contacts = analysis.grasp.contacts();
    let fingers = contacts.iter().enumerate().map(|(i, contact)| Finger {
        point: contact.overlap().point().to_array(),
        inward_normal: contact.overlap().inward_normal().to_array(),
        radius: drawn_radius(contact.overlap().geometry().finger.radius()),
        label: finger_name(i),
        preload: if contact.preload() > 0.0 {
            units.force(contact.preload())
        } else {
            String::new()
        },
        ..Finger::default()
    });
    picture.fingers = fingers.collect();
    let points = contacts.iter().map(|contact| contact.overlap().point().to_array());
    let edges = analysis.pieces.iter().map(|piece| piece.map(|Piece { number, .. }| number));
    picture.caption.extend(placed(edges.zip(points), analysis.size, units));
    picture
}

/// The picture with what is known of the grasp as a whole.
fn held(analysis: &Analysis<'_, 2, 1>, picture: GraspPicture) -> GraspPicture {
    let units = UnitNames(analysis.units);
    let Ok(metrics) = &analysis.metrics else {
        return GraspPicture { caption: vec!["not held".to_owned()], ..picture };
    };
    let Metrics { principal, quality, worst, .. } = metrics;
    let numbers = Numbers {
        quality: quality.value,
        limited_by: quality.limited_by.into(),
        sigma_min: quality.translational,
        mu_eq: quality.equivalent(),
        center: principal.center().to_array(),
        farthest: quality.softest_rotation().farthest,
        worst_point_stiffness: worst.stiffness,
    };
    let mut picture = numbers.drawn_on(picture, units);
    picture.caption.push(String::new());
    picture
}

/// Hollow and straight fingers are larger than the part: only their place is shown.
fn drawn_radius(radius: Option<f64>) -> f64 {
    radius.filter(|radius| *radius > 0.0 && radius.is_finite()).unwrap_or(0.0)
}

/// The numbers beside a picture.
struct Numbers {
    quality: f64,
    limited_by: LimitWord,
    sigma_min: f64,
    mu_eq: f64,
    center: [f64; 2],
    farthest: Farthest<2>,
    worst_point_stiffness: f64,
}

impl Numbers {
    fn drawn_on(&self, picture: GraspPicture, units: UnitNames<'_>) -> GraspPicture {
        let stiffness = |value: f64| units.stiffness(value);
        let Farthest { point, corner, value: reach } = self.farthest;
        let to = corner.map_or_else(String::new, |corner| format!(", to corner {corner}"));
        let caption = vec![
            format!("Q = {}", stiffness(self.quality)),
            format!("limited by {}", self.limited_by),
            String::new(),
            format!("σ_{{min}} = {}", stiffness(self.sigma_min)),
            format!("μ_{{eq}} = {}", stiffness(self.mu_eq)),
            format!("ρ_{{max}} = {}{to}", units.length(reach)),
            format!("Q_{{pt}} = {}", stiffness(self.worst_point_stiffness)),
        ];
        GraspPicture {
            center: Some(Mark { point: self.center, label: "c".to_owned() }),
            farthest_corner: Some(point.to_array()),
            caption,
            ..picture
        }
    }
}

/// Where the fingers are, a line for each.
fn placed(
    contacts: impl Iterator<Item = (Option<usize>, [f64; 2])>,
    size: f64,
    units: UnitNames<'_>,
) -> Vec<String> {
    let length = &units.0.length;
    let line = |(i, (edge, point)): (usize, (Option<usize>, [f64; 2]))| {
        let at = spot(&point, size);
        let edge = edge.map_or_else(String::new, |edge| format!(", edge {edge}"));
        format!("{} at {at} {length}{edge}", finger_name(i))
    };
    contacts.enumerate().map(line).collect()
}
