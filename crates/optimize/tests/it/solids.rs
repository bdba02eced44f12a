//! Placements on solids: against grids, other frames, other meshes of the same body, other threads,
//! and the grasp that they make.

use clench_contact::{Contact, Geometry, Law};
use clench_metrics::{EquivalentStiffness, Principal, Quality, WorstPoint};
use clench_optimize::polyhedron::{Fingers, Part, Touch, fingers, fingers_among};
use clench_optimize::{Effort, Ended, Objective, Outcome, Solution, unwatched};
use clench_screw::{Vector, spatial};
use clench_shape::Polyhedron;
use clench_stiffness::Grasp;
use clench_testkit::solids::{self, Mesh};
use clench_testkit::{Random, assert_close};

/// How far the searches of these tests close in.
const GAP: f64 = 0.06;

fn solid((vertices, faces): &Mesh) -> Polyhedron {
    Polyhedron::new(vertices, faces).unwrap()
}

fn touch(point: [f64; 3], inward_normal: [f64; 3]) -> Touch {
    Touch { point: point.into(), inward_normal: inward_normal.into(), stiffness: 1.0 }
}

/// Three locators under an L, two behind it, one beside it.
pub(crate) fn locators() -> Vec<Touch> {
    vec![
        touch([0.3, 0.3, -1.0], [0.0, 0.0, 1.0]),
        touch([3.7, 0.5, -1.0], [0.0, 0.0, 1.0]),
        touch([0.5, 2.7, -1.0], [0.0, 0.0, 1.0]),
        touch([0.5, 0.0, 0.0], [0.0, 1.0, 0.0]),
        touch([3.5, 0.0, 0.2], [0.0, 1.0, 0.0]),
        touch([0.0, 2.5, 0.1], [1.0, 0.0, 0.0]),
    ]
}

fn clamped(part: &Part, fixed: Vec<Touch>, objective: Objective) -> Outcome<3, 3> {
    let question = Fingers { fixed, objective, ..Fingers::new(3) };
    let effort = Effort { gap: GAP, ..Effort::default() };
    let outcome = fingers(part, &question, &effort, unwatched).unwrap();
    assert!(matches!(outcome.certificate.ended, Ended::Gap | Ended::Proved), "{outcome:?}");
    assert!(outcome.gap() <= GAP, "{}", outcome.gap());
    outcome
}

/// Two outcomes for one question: neither is better than the other's bound.
fn assert_same(a: &Outcome<3, 3>, b: &Outcome<3, 3>, factor: f64) {
    let digits = 1.0 + 1e-9;
    assert!(b.best.objective <= factor * a.certificate.upper_bound * digits);
    assert!(factor * a.best.objective <= b.certificate.upper_bound * digits);
}

#[test]
fn the_optimum_does_not_depend_on_the_frame() {
    let part = Part::uniform(solid(&solids::angle()), 1.0, 0.0).unwrap();
    let first = clamped(&part, locators(), Objective::WorstPoint);
    for pose in [
        spatial::Frame::new([1.0, -2.0, 0.5], [0.3, -0.2, 0.9]),
        spatial::Frame::new([300.0, 100.0, -200.0], [1.0, 2.0, -0.5]),
    ] {
        let (vertices, faces) = solids::angle();
        let moved: Vec<[f64; 3]> =
            vertices.iter().map(|&v| pose.point_to_parent(v.into()).to_array()).collect();
        // Turned corners are in one plane to rounding: faces are cut into triangles.
        let cut = (moved, triangulated(&faces));
        let turned = Part::uniform(solid(&cut), 1.0, 1e-11).unwrap();
        assert_eq!(turned.facets().len(), part.facets().len());
        let fixed = locators().into_iter().map(|t| Touch {
            point: pose.point_to_parent(t.point),
            inward_normal: *pose.axes() * t.inward_normal,
            ..t
        });
        let second = clamped(&turned, fixed.collect(), Objective::WorstPoint);
        assert_same(&first, &second, 1.0);
    }
}

/// Fans from the lowest vertex of each face, from which all of an L can be seen.
fn triangulated(faces: &[Vec<usize>]) -> Vec<Vec<usize>> {
    let fan = |face: &Vec<usize>| {
        let lowest = (0..face.len()).min_by_key(|&i| face[i]).unwrap();
        let at = |i: usize| face[(lowest + i) % face.len()];
        (1..face.len() - 1).map(|i| vec![at(0), at(i), at(i + 1)]).collect::<Vec<_>>()
    };
    faces.iter().flat_map(fan).collect()
}

#[test]
fn units_change_nothing_but_the_units() {
    let part = Part::uniform(solid(&solids::angle()), 1.0, 0.0).unwrap();
    let question = Fingers { fixed: locators(), ..Fingers::new(3) };
    let effort = Effort { nodes: Some(3000), ..Effort::default() };
    let first = fingers(&part, &question, &effort, unwatched).unwrap();
    // Powers of four: not a digit may change.
    for (length, stiffness) in [(2.0_f64.powi(-30), 1.0), (2.0_f64.powi(30), 4.0_f64.powi(20))] {
        let (vertices, faces) = solids::angle();
        let scaled: Vec<[f64; 3]> = vertices.iter().map(|v| v.map(|x| x * length)).collect();
        let part = Part::uniform(solid(&(scaled, faces)), stiffness, 0.0).unwrap();
        let fixed = locators().into_iter().map(|t| Touch {
            point: t.point * length,
            stiffness: t.stiffness * stiffness,
            ..t
        });
        let question = Fingers { fixed: fixed.collect(), ..question.clone() };
        let second = fingers(&part, &question, &effort, unwatched).unwrap();
        assert_eq!(second.combinations, first.combinations);
        assert_eq!(second.certificate.upper_bound, first.certificate.upper_bound * stiffness);
        assert_close(
            second.best.objective,
            first.best.objective * stiffness,
            1e-12,
            stiffness,
            length,
        );
    }
}

#[test]
fn neither_numbers_nor_cuts_of_faces_matter() {
    let part = Part::uniform(solid(&solids::angle()), 1.0, 0.0).unwrap();
    let objective = Objective::Rotation { least_translation: 1.5 };
    let first = clamped(&part, locators(), objective);
    let (mut vertices, faces) = solids::angle();
    // Each triangle is cut into three at its middle.
    let mut fine = Vec::new();
    for triangle in triangulated(&faces) {
        let middle = |i: usize| triangle.iter().map(|&v| vertices[v][i]).sum::<f64>() / 3.0;
        let new = [middle(0), middle(1), middle(2)];
        let number = vertices.len();
        vertices.push(new);
        fine.extend((0..3).map(|i| vec![triangle[i], triangle[(i + 1) % 3], number]));
    }
    fine.reverse();
    let part = Part::uniform(solid(&(vertices, fine)), 1.0, 1e-9).unwrap();
    assert_eq!(part.facets().len(), faces.len());
    let second = clamped(&part, locators(), objective);
    assert_same(&first, &second, 1.0);
}

#[test]
fn the_outcome_does_not_depend_on_the_threads() {
    let part = Part::uniform(solid(&solids::wedge()), 1.0, 0.0).unwrap();
    let effort = Effort { nodes: Some(5000), ..Effort::default() };
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| fingers(&part, &Fingers::new(7), &effort, unwatched).unwrap())
    };
    assert_eq!(run(1), run(3));
}

/// The grasp of a solution, with linear laws.
fn grasp(part: &Part, fixed: &[Touch], solution: &Solution<3, 3>) -> Grasp<3, 3> {
    let placed = solution.placements.iter().map(|p| {
        let facet = part.facets().iter().find(|facet| facet.faces().contains(&p.on)).unwrap();
        assert_eq!(facet.inward_normal(), p.inward_normal);
        (p.point, p.inward_normal, part.face_stiffness()[p.on])
    });
    let given = fixed.iter().map(|t| (t.point, t.inward_normal, t.stiffness));
    let contacts = placed.chain(given).map(|(point, normal, k)| {
        Contact::new(Geometry::on_face(point, normal, 0.0), Law::linear(k).unwrap(), 0.0).unwrap()
    });
    Grasp::new(contacts.collect()).unwrap()
}

#[test]
fn a_solution_is_the_grasp_that_it_says() {
    let mut r = Random::new(66);
    for mesh in [solids::angle(), solids::bracket(), solids::between_planes(&mut r, 12)] {
        let count = mesh.1.len();
        let stiffness: Vec<f64> = (0..count).map(|_| 1.0).collect();
        let part = Part::new(solid(&mesh), stiffness, 1e-9).unwrap();
        let body = part.solid().extreme_points();
        for objective in [
            Objective::WorstPoint,
            Objective::Quality,
            Objective::Rotation { least_translation: 0.5 },
        ] {
            let question = Fingers { objective, ..Fingers::new(8) };
            let effort = Effort { nodes: Some(200), ..Effort::default() };
            let outcome = fingers(&part, &question, &effort, unwatched).unwrap();
            let best = &outcome.best;
            let grasp = grasp(&part, &[], best);
            for p in &best.placements {
                assert!(part.solid().place(p.point).distance < 1e-12, "{p:?}");
            }
            let about = |origin| grasp.stiffness(origin, clench_contact::Order::First);
            let principal = Principal::near(grasp.centroid(), about).unwrap();
            let value = match objective {
                Objective::WorstPoint => WorstPoint::of(&principal, body).unwrap().stiffness,
                Objective::Quality => Quality::of(&principal, body).unwrap().value,
                Objective::Rotation { .. } => {
                    EquivalentStiffness::least(&principal, body).unwrap().value
                }
            };
            assert_close(best.objective, value, 1e-9, value, "objective");
            assert!(outcome.certificate.upper_bound >= value);
            // The shares are a preload that balances, and say that it holds.
            assert!(grasp.preloads().unwrap().force_closure);
            let shares: f64 = best.placements.iter().map(|p| p.share).sum();
            assert_close(shares, 1.0, 1e-9, 1.0, "shares");
            let force =
                best.placements.iter().fold(Vector::ZERO, |f, p| f + p.inward_normal * p.share);
            assert!(force.norm() < 1e-9 && best.placements.iter().all(|p| p.share > 0.0));
        }
    }
}

/// One clamp on a wedge that stands on three locators and leans against three: the best place is
/// that of a grid, up to its width.
#[test]
fn one_clamp_is_where_a_grid_finds_it() {
    let part = Part::uniform(solid(&solids::wedge()), 1.0, 0.0).unwrap();
    let fixed = vec![
        touch([0.4, 0.4, 0.0], [0.0, 0.0, 1.0]),
        touch([3.6, 1.4, 0.0], [0.0, 0.0, 1.0]),
        touch([0.5, 2.7, 0.0], [0.0, 0.0, 1.0]),
        touch([0.0, 0.4, 0.6], [1.0, 0.0, 0.0]),
        touch([0.0, 2.6, 0.7], [1.0, 0.0, 0.0]),
        touch([1.5, 0.0, 0.4], [0.0, 1.0, 0.0]),
        touch([1.2, 3.0, 0.5], [0.0, -1.0, 0.0]),
    ];
    let question = Fingers { fixed: fixed.clone(), ..Fingers::new(1) };
    let effort = Effort { gap: 1e-6, ..Effort::default() };
    let outcome = fingers(&part, &question, &effort, unwatched).unwrap();
    assert!(outcome.gap() <= 1e-6);
    let mut grid = Vec::new();
    for facet in part.facets() {
        for [a, b, c] in facet.triangles() {
            let steps = 40;
            for i in 0..=steps {
                for j in 0..=steps - i {
                    let [u, v] = [i, j].map(|k| f64::from(k) / f64::from(steps));
                    let point = *a + (*b - *a) * u + (*c - *a) * v;
                    let inward_normal = facet.inward_normal();
                    grid.push(Touch { point, inward_normal, stiffness: 1.0 });
                }
            }
        }
    }
    let body = part.solid().extreme_points();
    let best = fingers_among(body, &grid, &question, &Effort::default(), unwatched).unwrap();
    assert_eq!(best.certificate.ended, Ended::Proved);
    assert!(best.best.objective <= outcome.certificate.upper_bound);
    assert!(best.best.objective >= 0.97 * outcome.best.objective, "{}", best.best.objective);
}
