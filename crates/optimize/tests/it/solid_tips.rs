//! Fingers with round tips on solids that are not convex: judged by distances that another library
//! finds, and against places by chance.

use clench_optimize::polyhedron::{Fingers, Part, Spacing, Touch, fingers, fingers_among};
use clench_optimize::{Effort, OptimizeError, Outcome, unwatched};
use clench_screw::Vector;
use clench_shape::{BallTip, KeepOut, Polyhedron};
use clench_testkit::{Random, solids};
use parry3d_f64::math::Vector as ParryVector;
use parry3d_f64::query::PointQuery;
use parry3d_f64::shape::TriMesh;

use crate::solids::locators;

/// Distances of up to 10 are found in tens of operations.
const ROUNDING: f64 = 1e-12;

fn touch(point: [f64; 3], inward_normal: [f64; 3]) -> Touch {
    Touch { point: point.into(), inward_normal: inward_normal.into(), stiffness: 1.0 }
}

fn angle() -> Part {
    let (vertices, faces) = solids::angle();
    Part::uniform(Polyhedron::new(&vertices, &faces).unwrap(), 1.0, 0.0).unwrap()
}

fn bracket() -> Part {
    let (vertices, faces) = solids::bracket();
    Part::uniform(Polyhedron::new(&vertices, &faces).unwrap(), 1.0, 0.0).unwrap()
}

fn mesh(solid: &Polyhedron) -> TriMesh {
    let corners: Vec<[Vector<3>; 3]> =
        solid.facets(0.0).iter().flat_map(|f| f.triangles().to_vec()).collect();
    let points = corners.as_flattened().iter();
    let points = points.map(|x| ParryVector::from_array(x.to_array())).collect();
    let count = u32::try_from(corners.len()).unwrap();
    TriMesh::new(points, (0..count).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect()).unwrap()
}

/// How deep balls at the ends of fingers sink into a part, or into each other, at most; below 0
/// that is the least gap.
fn overlap(outcome: &Outcome<3, 3>, mesh: &TriMesh, asked: &Fingers) -> f64 {
    let Spacing { radius, clearance, given, .. } = &asked.spacing;
    let placed =
        outcome.best.placements.iter().map(|p| (p.point - p.inward_normal * *radius, *radius));
    let placed: Vec<(Vector<3>, f64)> = placed.collect();
    let given = asked.fixed.iter().zip(given);
    let given: Vec<(Vector<3>, f64)> =
        given.map(|(t, &radius)| (t.point - t.inward_normal * radius, radius)).collect();
    let mut deepest = f64::NEG_INFINITY;
    for (i, &(center, radius)) in placed.iter().enumerate() {
        let at = ParryVector::from_array(center.to_array());
        deepest = deepest.max(radius - mesh.distance_to_local_point(at, false));
        for &(other, other_radius) in placed[..i].iter().chain(&given) {
            deepest = deepest.max(radius + other_radius + clearance - (center - other).norm());
        }
    }
    deepest
}

#[test]
fn nothing_overlaps_in_what_is_found() {
    let effort = Effort { gap: 0.1, nodes: Some(4000), ..Effort::default() };
    for (part, name) in [(angle(), "angle"), (bracket(), "bracket")] {
        let mesh = mesh(part.solid());
        for (radius, clearance) in [(0.05, 0.0), (0.3, 0.2), (0.6, 0.0), (1.5, 0.5)] {
            for count in [2, 3] {
                let tip = BallTip::new(radius).unwrap();
                let part = part.clone().accessible_to(&tip).unwrap();
                let given = vec![0.1; 7];
                let spacing = Spacing { radius, clearance, given, ..Spacing::default() };
                let mut fixed = locators();
                fixed.push(touch([2.0, 0.5, 1.0], [0.0, 0.0, -1.0]));
                let asked = Fingers { fixed, spacing, ..Fingers::new(count) };
                let Ok(found) = fingers(&part, &asked, &effort, unwatched) else {
                    assert!(radius > 1.0, "{name} {radius} {count}");
                    continue;
                };
                let deepest = overlap(&found, &mesh, &asked);
                assert!(deepest <= ROUNDING, "{name} {radius} {count}: {deepest}");
                for p in &found.best.placements {
                    let of_facet = |f: &clench_shape::Facet| f.faces().contains(&p.on);
                    let facet = part.facets().iter().find(|f| of_facet(f)).unwrap();
                    let height = facet.inward_normal().dot(p.point - facet.triangles()[0][0]);
                    assert!(height.abs() < ROUNDING, "{name}: off the plane by {height}");
                }
            }
        }
    }
}

/// Places by chance that have room, judged by the other library.
fn places(part: &Part, radius: f64, count: usize, r: &mut Random) -> Vec<Touch> {
    let mesh = mesh(part.solid());
    let mut found = Vec::new();
    while found.len() < count {
        let facet = &part.facets()[r.below(part.facets().len())];
        let [a, b, c] = facet.triangles()[r.below(facet.triangles().len())];
        let weights = r.array::<3>(0.5).map(|x| (x + 0.5).powi(3));
        let sum: f64 = weights.iter().sum();
        let point = a + (b - a) * (weights[1] / sum) + (c - a) * (weights[2] / sum);
        let center = point - facet.inward_normal() * radius;
        let center = ParryVector::from_array(center.to_array());
        // Well inside of what is accessible: nothing that the approximation may leave out.
        if mesh.distance_to_local_point(center, false) >= radius * (1.0 - 1e-9) {
            found.push(Touch { point, inward_normal: facet.inward_normal(), stiffness: 1.0 });
        }
    }
    found
}

#[test]
fn no_places_by_chance_are_better_than_the_bound_nor_than_what_is_found() {
    let r = &mut Random::new(71);
    for (round, (part, radius, clearance, count)) in [
        (angle(), 0.4, 0.0, 1),
        (angle(), 0.4, 0.3, 2),
        (bracket(), 0.25, 0.0, 1),
        (bracket(), 0.35, 0.4, 2),
        (angle(), 0.0, 0.6, 2),
    ]
    .into_iter()
    .enumerate()
    {
        let given = vec![0.2; 6];
        let spacing = Spacing { radius, clearance, given, ..Spacing::default() };
        // One clamp does not hold against six locators about a corner: one more is given.
        let mut fixed = locators();
        if count == 1 {
            fixed.push(touch([2.0, 1.0, 0.9], [0.0, -1.0, 0.0]));
            fixed.push(touch([1.0, 2.5, 0.0], [-1.0, 0.0, 0.0]));
        } else {
            fixed.push(touch([2.0, 0.5, 1.0], [0.0, 0.0, -1.0]));
        }
        let asked = Fingers { fixed, spacing, ..Fingers::new(count) };
        let samples = places(&part, radius, if count == 1 { 4000 } else { 250 }, r);
        let body = part.solid().extreme_points();
        let sampled = fingers_among(body, &samples, &asked, &Effort::default(), unwatched).unwrap();
        let restricted = part.accessible_to(&BallTip::new(radius).unwrap()).unwrap();
        let effort = Effort { gap: 1e-3, nodes: Some(200_000), ..Effort::default() };
        let found = fingers(&restricted, &asked, &effort, unwatched).unwrap();
        let (best, sample) = (found.best.objective, sampled.best.objective);
        assert!(sample <= found.certificate.upper_bound * (1.0 + 1e-6), "round {round}");
        assert!(sample <= best * (1.0 + 2e-3), "round {round}: {sample} is more than {best}");
        assert!(found.gap() <= 1e-3, "round {round}: gap {}", found.gap());
    }
}

#[test]
fn what_is_everywhere_accessible_is_searched_as_before() {
    let (vertices, faces) = solids::wedge();
    let part = Part::uniform(Polyhedron::new(&vertices, &faces).unwrap(), 1.0, 0.0).unwrap();
    let asked = Fingers::new(7);
    let effort = Effort { nodes: Some(500), ..Effort::default() };
    let before = fingers(&part, &asked, &effort, unwatched).unwrap();
    let part = part.accessible_to(&BallTip::new(3.0).unwrap()).unwrap();
    let after = fingers(&part, &asked, &effort, unwatched).unwrap();
    assert_eq!(before.best.placements, after.best.placements);
    assert_eq!(before.certificate.upper_bound, after.certificate.upper_bound);
}

#[test]
fn what_cannot_be_touched_or_kept_apart_is_told() {
    let around = KeepOut::new([-9.0; 3], [9.0; 3]).unwrap();
    let tip = BallTip::new(0.5).unwrap().keeping_out(vec![around]);
    let fault = angle().accessible_to(&tip).unwrap_err();
    assert_eq!(
        fault,
        OptimizeError::NothingAccessible {
            radius: 0.5,
            margin: 0.0,
            keep_outs: 1,
            on_plate: false
        }
    );
    let refused = |spacing: Spacing| {
        let asked = Fingers { fixed: locators(), spacing, ..Fingers::new(2) };
        fingers(&angle(), &asked, &Effort::default(), unwatched).unwrap_err()
    };
    let spacing = Spacing { clearance: -1.0, ..Spacing::default() };
    assert_eq!(refused(spacing), OptimizeError::Clearance { value: -1.0 });
    for spacing in [
        Spacing { radius: f64::NAN, ..Spacing::default() },
        Spacing { given: vec![0.0, f64::INFINITY], ..Spacing::default() },
    ] {
        assert!(matches!(refused(spacing), OptimizeError::FingerRadius { .. }));
    }
    // Balls as large as the part have no room beside each other.
    let spacing = Spacing { clearance: 100.0, ..Spacing::default() };
    assert!(matches!(refused(spacing), OptimizeError::ConditionsNeverMet { fingers: 2, .. }));
}
