//! What is refused on solids, and what can never be held.

use clench_optimize::polyhedron::{Fingers, Part, Touch, TouchKind, fingers, fingers_among};
use clench_optimize::{Effort, Ended, Objective, OptimizeError, unwatched};
use clench_screw::{Screw, Vector};
use clench_shape::Polyhedron;
use clench_testkit::solids::{self, Mesh};

fn solid((vertices, faces): &Mesh) -> Polyhedron {
    Polyhedron::new(vertices, faces).unwrap()
}

fn cube() -> Part {
    Part::uniform(solid(&solids::cuboid([1.0, 1.0, 1.0])), 1.0, 0.0).unwrap()
}

fn refused(part: &Part, question: &Fingers) -> OptimizeError {
    fingers(part, question, &Effort::default(), unwatched).unwrap_err()
}

fn touch(point: [f64; 3], inward_normal: [f64; 3]) -> Touch {
    Touch { point: point.into(), inward_normal: inward_normal.into(), stiffness: 1.0 }
}

#[test]
fn faults_of_a_part_are_named() {
    let of = |stiffness: Vec<f64>| {
        Part::new(solid(&solids::cuboid([1.0, 1.0, 1.0])), stiffness, 0.0).unwrap_err()
    };
    assert_eq!(of(vec![1.0; 5]), OptimizeError::StiffnessCount { found: 5, sides: 6 });
    for value in [0.0, -1.0, f64::INFINITY] {
        let mut stiffness = vec![1.0; 6];
        stiffness[4] = value;
        assert_eq!(of(stiffness), OptimizeError::Stiffness { side: 4, value });
    }
    let mut spread = vec![1.0; 6];
    spread[0] = 1e11;
    assert!(matches!(of(spread), OptimizeError::StiffnessSpread { .. }));
    // The sides with the hole are two faces each.
    let (vertices, faces) = solids::bracket();
    let mut stiffness = vec![1.0; faces.len()];
    stiffness[2] = 2.0;
    let fault = Part::new(solid(&(vertices, faces)), stiffness, 0.0).unwrap_err();
    assert_eq!(fault, OptimizeError::UnlikeStiffness { faces: [2, 8] });
}

#[test]
fn faults_of_a_question_are_named() {
    let part = cube();
    let none = Fingers::new(7);
    for found in [0, 13] {
        let fault = refused(&part, &Fingers::new(found));
        assert_eq!(fault, OptimizeError::FingerCount { found, fewest: 1, most: 12 });
    }
    let fault = refused(&part, &Fingers::new(6));
    assert_eq!(fault, OptimizeError::TooFewContacts { placed: 6, given: 0 });
    let fixed = vec![touch([0.0, 0.0, -1.0], [0.0, 0.0, 1.0]); 8];
    let fault = refused(&part, &Fingers { fixed: fixed.clone(), ..Fingers::new(9) });
    assert_eq!(fault, OptimizeError::TooManyContacts { found: 17, most: 16 });
    for value in [-0.1, 1.0 / 7.0, f64::NAN] {
        let fault = refused(&part, &Fingers { least_share: value, ..none.clone() });
        assert!(matches!(fault, OptimizeError::LeastShare { .. }), "{fault}");
        let fault = refused(&part, &Fingers { roundness: value - 1.0, ..none.clone() });
        assert!(matches!(fault, OptimizeError::Roundness { .. }), "{fault}");
    }
    let objective = Objective::Rotation { least_translation: -1.0 };
    let fault = refused(&part, &Fingers { objective, ..none.clone() });
    assert_eq!(fault, OptimizeError::LeastTranslation { value: -1.0 });
    let gap = fingers(&part, &none, &Effort { gap: -1.0, ..Effort::default() }, unwatched);
    assert_eq!(gap.unwrap_err(), OptimizeError::Gap { value: -1.0 });

    let with = |bad: Touch| {
        let mut fixed = fixed.clone();
        fixed[3] = bad;
        refused(&part, &Fingers { fixed, ..Fingers::new(2) })
    };
    let nan = with(touch([0.0, f64::NAN, 0.0], [0.0, 0.0, 1.0]));
    assert!(
        matches!(nan, OptimizeError::TouchPoint { kind: TouchKind::Given, number: 3, .. }),
        "{nan}"
    );
    let long = with(touch([0.0, 0.0, 0.0], [0.0, 0.0, 2.0]));
    assert_eq!(long, OptimizeError::TouchNormal { kind: TouchKind::Given, number: 3, length: 2.0 });
    let soft = with(Touch { stiffness: 0.0, ..fixed[0] });
    assert_eq!(
        soft,
        OptimizeError::TouchStiffness { kind: TouchKind::Given, number: 3, value: 0.0 }
    );

    let body = part.solid().extreme_points();
    let few = fingers_among(body, &fixed[..6], &none, &Effort::default(), unwatched);
    assert_eq!(few.unwrap_err(), OptimizeError::TooFewCandidates { found: 6, fingers: 7 });
}

/// Round bodies, and the motions that stay free on them.
#[test]
fn round_bodies_are_told_with_the_motion_that_stays_free() {
    let ball = solids::globe(32, [1.0, 1.0, 1.0]);
    let part = Part::uniform(Polyhedron::from_triangles(&ball).unwrap(), 1.0, 0.0).unwrap();
    let fault = refused(&part, &Fingers::new(7));
    assert!(matches!(fault, OptimizeError::MotionStaysFree { count: 3, .. }), "{fault}");

    // A spindle about z, which is shifted and is no sphere.
    let shift = [5.0, -3.0, 2.0];
    let spindle: Vec<[[f64; 3]; 3]> = solids::globe(40, [1.0, 1.0, 3.0])
        .into_iter()
        .map(|triangle| triangle.map(|p| [p[0] + shift[0], p[1] + shift[1], p[2] + shift[2]]))
        .collect();
    let part = Part::uniform(Polyhedron::from_triangles(&spindle).unwrap(), 1.0, 0.0).unwrap();
    let fault = refused(&part, &Fingers::new(9));
    let OptimizeError::MotionStaysFree { motion: Screw::Axis { axis, .. }, count, lever, .. } =
        fault
    else {
        panic!("{fault}")
    };
    assert_eq!(count, 1);
    assert!(lever < 0.1 && axis.direction[2].abs() > 1.0 - 1e-9, "{axis:?}");
    let foot = axis.point - Vector::new([5.0, -3.0, 0.0]);
    assert!(foot.norm() < 1e-6 && axis.pitch.abs() < 1e-6, "{axis:?}");

    let cylinder = Part::uniform(solid(&solids::regular_prism(64)), 1.0, 0.0).unwrap();
    let fault = refused(&cylinder, &Fingers::new(7));
    assert!(matches!(fault, OptimizeError::MotionStaysFree { count: 1, .. }), "{fault}");
    // Six sides are not round, nor are 64 if one says so.
    let hexagon = Part::uniform(solid(&solids::regular_prism(6)), 1.0, 0.0).unwrap();
    let effort = Effort { nodes: Some(1), ..Effort::default() };
    assert!(fingers(&hexagon, &Fingers::new(7), &effort, unwatched).is_ok());
    let asked = Fingers { roundness: 0.0, ..Fingers::new(7) };
    let found = fingers(&cylinder, &asked, &effort, unwatched).unwrap();
    assert!(found.best.objective < 0.02, "{}", found.best.objective);
}

#[test]
fn candidates_that_leave_a_motion_free_are_told_so() {
    // On five sides of a cube: it can always be lifted out.
    let sides = [
        ([0.0, 0.0, -1.0], [0.0, 0.0, 1.0]),
        ([-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]),
        ([1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]),
        ([0.0, -1.0, 0.0], [0.0, 1.0, 0.0]),
        ([0.0, 1.0, 0.0], [0.0, -1.0, 0.0]),
    ];
    let mut candidates = Vec::new();
    for (point, normal) in sides {
        for (u, v) in [(0.7, 0.2), (-0.3, 0.6), (-0.5, -0.8), (0.4, -0.6)] {
            let [a, b, c]: [f64; 3] = normal;
            let offset = if c != 0.0 {
                [u, v, 0.0]
            } else if a != 0.0 {
                [0.0, u, v]
            } else {
                [u, b * 0.0, v]
            };
            let at = [0, 1, 2].map(|i| point[i] + offset[i]);
            candidates.push(touch(at, normal));
        }
    }
    let part = cube();
    let body = part.solid().extreme_points();
    let found = fingers_among(body, &candidates, &Fingers::new(8), &Effort::default(), unwatched);
    assert!(matches!(found, Err(OptimizeError::NeverHeld { .. })), "{found:?}");
    // On three sides that meet in a corner everything helps one motion.
    let corner: Vec<Touch> = candidates
        .iter()
        .copied()
        .filter(|t| t.inward_normal.to_array().iter().sum::<f64>() > 0.0)
        .collect();
    let found = fingers_among(body, &corner, &Fingers::new(8), &Effort::default(), unwatched);
    let Err(OptimizeError::AlwaysEscapes { motion, .. }) = found else { panic!("{found:?}") };
    assert!(!matches!(motion, Screw::Zero));
}

#[test]
fn given_contacts_that_let_the_part_escape_are_told_so() {
    // Flat locators and one clamp: three sides have nothing opposite.
    let fixed = vec![
        touch([0.5, 0.5, -1.0], [0.0, 0.0, 1.0]),
        touch([-0.5, 0.5, -1.0], [0.0, 0.0, 1.0]),
        touch([0.0, -0.5, -1.0], [0.0, 0.0, 1.0]),
        touch([-1.0, 0.5, 0.0], [1.0, 0.0, 0.0]),
        touch([-1.0, -0.5, 0.0], [1.0, 0.0, 0.0]),
        touch([0.0, -1.0, 0.0], [0.0, 1.0, 0.0]),
    ];
    let fault = refused(&cube(), &Fingers { fixed, ..Fingers::new(1) });
    assert!(matches!(fault, OptimizeError::NeverHeld { fingers: 1, .. }), "{fault}");
}

#[test]
fn a_search_that_is_stopped_at_once_says_so() {
    let part = cube();
    let stop = |_: &clench_optimize::Progress| std::ops::ControlFlow::Break(());
    let found = fingers(&part, &Fingers::new(7), &Effort::default(), stop).unwrap();
    assert_eq!(found.certificate.ended, Ended::Cancelled);
    assert!(found.certificate.upper_bound >= found.best.objective);
}

/// Sizes far from 1, thin plates and needles, and many contacts in one place.
#[test]
fn odd_bodies_are_answered() {
    let effort = Effort { nodes: Some(50), ..Effort::default() };
    for size in [[1e-9; 3], [1e9; 3], [1.0, 1.0, 1e-4], [1.0, 1e-3, 1e-3], [1e60; 3], [1e-60; 3]] {
        let part = Part::uniform(solid(&solids::cuboid(size)), 1e-9, 0.0).unwrap();
        let asked = Fingers { roundness: 0.0, ..Fingers::new(7) };
        let found = fingers(&part, &asked, &effort, unwatched);
        let found = found.unwrap_or_else(|e| panic!("{size:?}: {e}"));
        assert!(found.best.objective > 0.0 && found.gap().is_finite(), "{size:?}");
    }
    let fixed = vec![touch([0.0, 0.0, -1.0], [0.0, 0.0, 1.0]); 4];
    let asked = Fingers { fixed, ..Fingers::new(6) };
    let found = fingers(&cube(), &asked, &effort, unwatched).unwrap();
    assert!(found.best.given_shares.iter().all(|share| *share > 0.0));
}
