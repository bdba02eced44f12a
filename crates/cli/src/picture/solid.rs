//! Pictures of grasps of solids, from what the reports say.

use clench::metrics::{Principal, WorstPoint};
use clench::optimize::Solution;
use clench::screw::Vector;
use clench::screw::spatial::cross;
use clench::shape::Ellipsoid;
use clench_draw::{SolidAxis, SolidFace, SolidFinger, SolidMark, SolidPicture, SolidWorst};

use super::{array, finger_name};
use crate::analyze::Analysis;
use crate::input::{Solid, SpatialShape};
use crate::metrics::Metrics;
use crate::report::{LimitWord, ObjectiveWord, OptimumReport, UnitNames};
use crate::wording::rough_digits;

/// An ellipsoid is drawn with this many faces around its axis, and half as many along it: the
/// normals of neighbors differ by less than what the picture takes for an edge.
const AROUND: usize = 48;

/// The best placement.
pub(crate) fn of_optimum_on_solid(
    report: &OptimumReport<'_>,
    best: &Solution<3, 3>,
    solid: &Solid,
) -> SolidPicture {
    let (found, units) = (&report.best, UnitNames(report.question.units));
    let fingers = found.contacts.iter().enumerate().map(|(i, contact)| SolidFinger {
        point: array(&contact.point),
        inward_normal: array(&contact.inward_normal),
        label: finger_name(i),
        fixed: contact.fixed,
    });
    let mut picture = SolidPicture { faces: faces(solid), ..SolidPicture::default() };
    picture.fingers = fingers.collect();
    let Some(space) = &found.in_space else { return picture };
    picture.worst_point = Some(SolidWorst {
        point: array(&found.worst_point),
        direction: array(&space.worst_direction),
        label: "w".to_owned(),
    });
    let numbers = Numbers {
        quality: found.quality,
        limited_by: found.limited_by,
        sigma_min: found.sigma_min,
        mu_eq: found.mu_eq,
        rotational: space.quality_rotational,
        worst_point: found.worst_point_stiffness,
    };
    picture.caption = numbers.caption(units);
    let certificate = report.certificate;
    picture.caption.extend([
        String::new(),
        format!(
            "{} at most {}",
            symbol(report.question.objective),
            units.stiffness(certificate.upper_bound)
        ),
        if certificate.proved {
            "proved".to_owned()
        } else {
            format!("gap {}", rough_digits(certificate.gap))
        },
    ]);
    with_axes(picture, &best.principal)
}

/// The grasp that was analyzed, in the frame of the file.
pub(crate) fn of_analysis_in_space(
    analysis: &Analysis<'_, 3, 3>,
    shape: &SpatialShape,
) -> SolidPicture {
    let faces = match shape {
        SpatialShape::Polyhedron(solid) => faces(solid),
        SpatialShape::Ellipsoid(ellipsoid) => smooth_faces(ellipsoid),
    };
    let contacts = analysis.grasp.contacts().iter().enumerate();
    let fingers = contacts.map(|(i, contact)| SolidFinger {
        point: contact.overlap().point().to_array(),
        inward_normal: contact.overlap().inward_normal().to_array(),
        label: finger_name(i),
        fixed: false,
    });
    let mut picture = SolidPicture { faces, fingers: fingers.collect(), ..SolidPicture::default() };
    let Ok(metrics) = &analysis.metrics else {
        picture.caption = vec!["not held".to_owned()];
        return picture;
    };
    let Metrics { principal, quality, softest, worst } = metrics;
    let WorstPoint { point, direction, .. } = worst;
    picture.worst_point = Some(SolidWorst {
        point: point.to_array(),
        direction: direction.to_array(),
        label: "w".to_owned(),
    });
    let numbers = Numbers {
        quality: quality.value,
        limited_by: quality.limited_by.into(),
        sigma_min: quality.translational,
        mu_eq: quality.equivalent(),
        rotational: softest.value,
        worst_point: worst.stiffness,
    };
    picture.caption = numbers.caption(UnitNames(analysis.units));
    with_axes(picture, principal)
}

/// The numbers beside a picture.
struct Numbers {
    quality: f64,
    limited_by: LimitWord,
    sigma_min: f64,
    mu_eq: f64,
    rotational: f64,
    worst_point: f64,
}

impl Numbers {
    fn caption(&self, units: UnitNames<'_>) -> Vec<String> {
        let stiffness = |value: f64| units.stiffness(value);
        vec![
            format!("Q = {}", stiffness(self.quality)),
            format!("limited by {}", self.limited_by),
            String::new(),
            format!("σ_{{min}} = {}", stiffness(self.sigma_min)),
            format!("μ_{{eq}} = {}", stiffness(self.mu_eq)),
            format!("Q_{{V}} = {}", stiffness(self.rotational)),
            format!("Q_{{pt}} = {}, at w", stiffness(self.worst_point)),
        ]
    }
}

/// The symbol of what is maximized, with its index lowered.
const fn symbol(objective: ObjectiveWord) -> &'static str {
    match objective {
        ObjectiveWord::Quality => "Q",
        ObjectiveWord::WorstPoint => "Q_{pt}",
        ObjectiveWord::Rotation => "μ_{eq}",
        ObjectiveWord::AnyRotation => "Q_{V}",
    }
}

/// The picture with the center and the axes of the principal rotations, the softest emphasized.
fn with_axes(picture: SolidPicture, principal: &Principal<3, 3>) -> SolidPicture {
    let center = principal.center();
    let axes = principal.twist_axes().into_iter().enumerate().map(|(i, axis)| {
        // The point nearest to the center, which is near the part.
        let along = axis.direction * axis.direction.dot(center - axis.point);
        SolidAxis {
            point: (axis.point + along).to_array(),
            direction: axis.direction.to_array(),
            label: format!("μ_{{{}}}", i + 1),
            emphasized: i == 0,
        }
    });
    let mark = SolidMark { point: center.to_array(), label: "c".to_owned() };
    SolidPicture { axes: axes.collect(), center: Some(mark), ..picture }
}

/// The faces of a solid, those in one plane together.
fn faces(solid: &Solid) -> Vec<SolidFace> {
    let vertices = solid.polyhedron.vertices();
    let facets = solid.polyhedron.facets(solid.flatness);
    let facets = facets.iter().map(|facet| {
        let chain = |chain: &Vec<usize>| chain.iter().map(|&v| vertices[v].to_array()).collect();
        let triangle = |corners: &[Vector<3>; 3]| corners.map(Vector::to_array);
        SolidFace {
            outward_normal: (-facet.inward_normal()).to_array(),
            loops: facet.loops().iter().map(chain).collect(),
            triangles: facet.triangles().iter().map(triangle).collect(),
        }
    });
    facets.collect()
}

/// Small plane faces between circles of latitude and meridians.
fn smooth_faces(ellipsoid: &Ellipsoid<3>) -> Vec<SolidFace> {
    let (semi_axes, bands) = (ellipsoid.semi_axes(), AROUND / 2);
    let at = |band: usize, step: usize| {
        let down = std::f64::consts::PI * band as f64 / bands as f64;
        let around = std::f64::consts::TAU * (step % AROUND) as f64 / AROUND as f64;
        // The poles are one point each, from wherever they are reached.
        let wide = if band == 0 || band == bands { 0.0 } else { down.sin() };
        let unit = [wide * around.cos(), wide * around.sin(), down.cos()];
        let from_center = Vector::from_fn(|i| semi_axes[i] * unit[i]);
        ellipsoid.center() + *ellipsoid.axes() * from_center
    };
    let cells = (0..bands).flat_map(|band| (0..AROUND).map(move |step| (band, step)));
    let face = |(band, step): (usize, usize)| {
        let corners = match band {
            0 => vec![at(0, 0), at(1, step), at(1, step + 1)],
            _ if band + 1 == bands => vec![at(band, step), at(bands, 0), at(band, step + 1)],
            _ => {
                vec![at(band, step), at(band + 1, step), at(band + 1, step + 1), at(band, step + 1)]
            }
        };
        let across = cross(corners[1] - corners[0], corners[2] - corners[0]);
        let ring: Vec<[f64; 3]> = corners.iter().map(|corner| corner.to_array()).collect();
        let triangles = (2..ring.len()).map(|i| [ring[0], ring[i - 1], ring[i]]).collect();
        let outward_normal = across.direction()?.to_array();
        Some(SolidFace { outward_normal, loops: vec![ring], triangles })
    };
    cells.filter_map(face).collect()
}
