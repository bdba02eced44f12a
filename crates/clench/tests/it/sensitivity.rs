//! Derivatives of the measures against grasps that were made anew on the boundary of the part.

use clench::contact::{Change, Contact, Curvature, Geometry, Hertz, Law, Order};
use clench::metrics::{
    EquivalentStiffness, Freedom, Principal, Quality, Sensitivity, Variation, WorstPoint,
};
use clench::optimize::polygon::{Fingers, Part as Searched, fingers};
use clench::optimize::{Effort, unwatched};
use clench::screw::{Stiffness, Vector};
use clench::shape::{Ellipsoid, Extent, ExtremePoints, Polygon};
use clench::stiffness::{DeadLoad, Grasp};
use clench_testkit::Random;

/// Step of the central differences, of lengths of size 1: they are off by the square times a third
/// derivative, which the difference over twice the step shows three times; and by the rounding of
/// the measure, of which conditions of up to a thousand make 1e-13, divided by the step.
const STEP: f64 = 1e-5;

/// What that rounding leaves, relative to the measure.
const ROUNDING: f64 = 1e-8;

/// What a part is, and how a finger moves along it.
enum Part<const N: usize> {
    /// Corners; each finger has a flat place of its own.
    Flat(ExtremePoints<N>),
    Smooth(Ellipsoid<N>),
}

/// A finger as a file would have it.
#[derive(Clone)]
struct Finger<const N: usize> {
    place: Geometry<N>,
    law: Law,
    preload: f64,
}

/// A grasp in balance: each finger has a load that it holds, somewhere along its line.
struct Scene<const N: usize> {
    part: Part<N>,
    fingers: Vec<Finger<N>>,
    loads: Vec<DeadLoad<N>>,
    order: Order,
}

impl<const N: usize> Part<N> {
    fn extent(&self) -> Extent<'_, N> {
        match self {
            Self::Flat(points) => points.into(),
            Self::Smooth(body) => body.into(),
        }
    }

    /// The place after a step along the boundary.
    fn moved(&self, place: &Geometry<N>, step: Vector<N>) -> Geometry<N> {
        let point = place.point + step;
        match self {
            Self::Flat(_) => Geometry { point, ..*place },
            Self::Smooth(body) => {
                let at = body.nearest(point).boundary;
                let part = Curvature::of_shape_operator(at.shape_operator);
                let (point, inward_normal) = (at.point, at.inward_normal);
                Geometry { point, inward_normal, part, ..*place }
            }
        }
    }

    fn change(&self, place: &Geometry<N>, along: Vector<N>) -> Change<N> {
        match self {
            Self::Flat(_) => Change::along(along),
            Self::Smooth(body) => {
                let at = body.at_normal(-place.inward_normal).unwrap();
                let curvature_rate = body.shape_operator_rate(&at, along);
                Change::Place { along, curvature_rate }
            }
        }
    }
}

impl<const N: usize> Finger<N> {
    fn contact<const M: usize>(&self) -> Contact<N, M> {
        Contact::new(self.place, self.law.clone(), self.preload).unwrap()
    }

    /// Unit directions along the boundary: one in the plane, two in space.
    fn directions(&self) -> Vec<Vector<N>> {
        let n = self.place.inward_normal;
        let mut found: Vec<Vector<N>> = Vec::new();
        for axis in 0..N {
            let axis = Vector::from_fn(|i| if i == axis { 1.0 } else { 0.0 });
            let across = found.iter().fold(axis - n * n.dot(axis), |v, &u| v - u * u.dot(v));
            if across.norm() > 0.1 && found.len() + 1 < N {
                found.push(across.direction().unwrap());
            }
        }
        found
    }
}

fn law<const N: usize>(place: &Geometry<N>, r: &mut Random) -> Law {
    match r.below(3) {
        0 => Law::linear(r.between(0.5, 2.0)).unwrap(),
        1 => Law::power(r.between(0.5, 2.0), r.between(1.0, 2.5)).unwrap(),
        _ => {
            let finger = place.finger.radius().unwrap();
            Law::Hertz(Hertz::circular(r.between(0.5, 2.0), finger + 0.1).unwrap())
        }
    }
}

impl<const N: usize> Scene<N> {
    fn random(r: &mut Random, count: usize) -> Self {
        let part = if r.below(2) == 0 {
            let corners: Vec<[f64; N]> = (0..9).map(|_| r.array(1.5)).collect();
            Part::Flat(ExtremePoints::new(&corners).unwrap())
        } else {
            let semi_axes = r.array::<N>(0.5).map(|a| 1.0 + a);
            Part::Smooth(Ellipsoid::new(r.array(0.3).into(), semi_axes).unwrap())
        };
        let finger = |r: &mut Random| {
            let finger = Curvature::round(r.between(0.1, 0.8));
            let inward_normal = Vector::<N>::from(r.array(1.0)).direction().unwrap();
            let flat = Geometry {
                point: r.array(1.0).into(),
                inward_normal,
                finger,
                part: Curvature::FLAT,
            };
            let place = match &part {
                Part::Flat(_) => flat,
                Part::Smooth(body) => {
                    part.moved(&flat, body.at_normal(-inward_normal).unwrap().point - flat.point)
                }
            };
            Finger { place, law: law(&place, r), preload: r.between(0.01, 0.03) }
        };
        let fingers: Vec<Finger<N>> = (0..count).map(|_| finger(r)).collect();
        let load = |finger: &Finger<N>, along: f64| DeadLoad {
            point: finger.place.point + finger.place.inward_normal * along,
            force: finger.place.inward_normal * -finger.preload,
        };
        let loads = fingers.iter().map(|finger| load(finger, r.between(0.0, 0.5))).collect();
        let order = [Order::First, Order::Second][r.below(2)];
        Self { part, fingers, loads, order }
    }

    fn grasp<const M: usize>(&self, fingers: &[Finger<N>]) -> Grasp<N, M> {
        let contacts = fingers.iter().map(Finger::contact).collect();
        Grasp::new(contacts).unwrap().with_loads(self.loads.clone()).unwrap()
    }

    /// `None` where the part is not held.
    fn principal<const M: usize>(&self, fingers: &[Finger<N>]) -> Option<Principal<N, M>> {
        let grasp = self.grasp::<M>(fingers);
        Principal::near(grasp.centroid(), |origin| grasp.stiffness(origin, self.order)).ok()
    }

    /// `sigma_min`, `Q`, `Q_V`, `Q_pt` and all `mu_eq`.
    fn measures<const M: usize>(&self, fingers: &[Finger<N>]) -> Option<Vec<f64>> {
        let principal = self.principal::<M>(fingers)?;
        let body = self.part.extent();
        let quality = Quality::of(&principal, body).unwrap();
        let least = EquivalentStiffness::least(&principal, body).unwrap();
        let worst = WorstPoint::of(&principal, body).unwrap();
        let measures = [quality.translational, quality.value, least.value, worst.stiffness];
        Some(measures.into_iter().chain(quality.rotations.map(|rotation| rotation.value)).collect())
    }

    fn sensitivities<const M: usize>(&self, principal: &Principal<N, M>) -> Vec<Sensitivity<N, M>> {
        let body = self.part.extent();
        let quality = Quality::of(principal, body).unwrap();
        let least = EquivalentStiffness::least(principal, body).unwrap();
        let worst = WorstPoint::of(principal, body).unwrap();
        let rotation = |i| Sensitivity::of_rotation(principal, &quality, i, body).unwrap();
        [
            Sensitivity::of_translation(principal),
            Sensitivity::of_quality(principal, &quality, body).unwrap(),
            Sensitivity::of_least(principal, &least, body).unwrap(),
            Sensitivity::of_worst_point(principal, &worst, body).unwrap(),
        ]
        .into_iter()
        .chain((0..M).map(rotation))
        .collect()
    }

    /// The fingers after finger `which` has changed by `amount` of its freedom: a direction along
    /// the boundary, the scale of its law, or its preload.
    fn changed(&self, which: usize, freedom: usize, amount: f64) -> Vec<Finger<N>> {
        let mut fingers = self.fingers.clone();
        let finger = &mut fingers[which];
        if let Some(&along) = finger.directions().get(freedom) {
            finger.place = self.part.moved(&finger.place, along * amount);
        } else if freedom + 1 == N {
            finger.law = finger.law.scaled(1.0 + amount).unwrap();
        } else {
            // Relative.
            finger.preload *= 1.0 + amount;
        }
        fingers
    }

    fn rate<const M: usize>(
        &self,
        which: usize,
        freedom: usize,
        origin: Vector<N>,
    ) -> Stiffness<N, M> {
        let finger = &self.fingers[which];
        let (change, unit) = match finger.directions().get(freedom) {
            Some(&along) => (self.part.change(&finger.place, along), 1.0),
            None if freedom + 1 == N => (Change::Stiffness, 1.0),
            None => (Change::Preload, finger.preload),
        };
        finger.contact::<M>().stiffness_rate(&change, origin, self.order).unwrap() * unit
    }
}

fn derivatives_are_those_of_grasps_made_anew<const N: usize, const M: usize>(seed: u64) {
    let r = &mut Random::new(seed);
    let mut checked = 0;
    for _ in 0..150 {
        let scene = Scene::<N>::random(r, 3 + 2 * M);
        let Some(principal) = scene.principal::<M>(&scene.fingers) else { continue };
        let values = scene.measures::<M>(&scene.fingers).unwrap();
        let sensitivities = scene.sensitivities(&principal);
        assert!(sensitivities.iter().all(Sensitivity::is_smooth));
        let (which, freedom) = (r.below(scene.fingers.len()), r.below(N + 1));
        let rate = scene.rate::<M>(which, freedom, sensitivities[0].origin());
        let at = |amount: f64| scene.measures::<M>(&scene.changed(which, freedom, amount));
        let steps = [STEP, -STEP, 2.0 * STEP, -2.0 * STEP].map(|step| at(step).unwrap());
        for (i, sensitivity) in sensitivities.iter().enumerate() {
            let near = (steps[0][i] - steps[1][i]) / (2.0 * STEP);
            let far = (steps[2][i] - steps[3][i]) / (4.0 * STEP);
            let found = sensitivity.along(&rate);
            let allowed = (near - far).abs() + ROUNDING * values[i];
            assert!((found - near).abs() <= allowed, "{i} {freedom}: {found} {near} {allowed:e}");
            // The difference itself says something.
            checked += usize::from(allowed < 1e-4 * near.abs());
        }
    }
    assert!(checked > 300, "{checked}");
}

#[test]
fn derivatives_are_those_of_grasps_made_anew_in_the_plane_and_in_space() {
    derivatives_are_those_of_grasps_made_anew::<2, 1>(91);
    derivatives_are_those_of_grasps_made_anew::<3, 3>(92);
}

/// The worst corner of a box of tolerances, by trying all, against the linear estimate: what they
/// differ by is of second order, a quarter for a box half as large.
fn the_worst_case_is_the_worst_corner_of_a_small_box<const N: usize, const M: usize>(seed: u64) {
    let r = &mut Random::new(seed);
    let mut checked = 0;
    for _ in 0..12 {
        let scene = Scene::<N>::random(r, 3 + 2 * M);
        let Some(principal) = scene.principal::<M>(&scene.fingers) else { continue };
        // One number of five fingers each: a place, the stiffness or the preload.
        let chosen: Vec<(usize, usize)> = (0..5).map(|which| (which, r.below(N + 1))).collect();
        let values = scene.measures::<M>(&scene.fingers).unwrap();
        let corner = |corner: u32, tolerance: f64| {
            let mut fingers = scene.fingers.clone();
            for (bit, &(which, freedom)) in chosen.iter().enumerate() {
                let sign = if corner >> bit & 1 == 1 { 1.0 } else { -1.0 };
                fingers[which] = scene.changed(which, freedom, sign * tolerance)[which].clone();
            }
            scene.measures::<M>(&fingers).unwrap()
        };
        let boxes = [2e-4, 1e-4].map(|tolerance| {
            let all: Vec<_> = (0..32).map(|bits| corner(bits, tolerance)).collect();
            (tolerance, all)
        });
        for (i, sensitivity) in scene.sensitivities(&principal).iter().enumerate() {
            let [whole, half] = boxes.each_ref().map(|(tolerance, corners)| {
                let variation = |&(which, freedom): &(usize, usize)| Variation {
                    freedom: Freedom::Line(scene.rate(which, freedom, sensitivity.origin())),
                    tolerance: *tolerance,
                };
                let variations: Vec<_> = chosen.iter().map(variation).collect();
                let worst = sensitivity.worst_case(&variations);
                let least = corners.iter().map(|found| found[i]).fold(f64::INFINITY, f64::min);
                least - (values[i] + worst.change)
            });
            // The third order of the smaller box, and rounding.
            let allowed = 0.1 * whole.abs() + 1e-12 * values[i];
            assert!((half - 0.25 * whole).abs() <= allowed, "{i}: {whole:e} {half:e}");
            checked += usize::from(whole.abs() > 1e-10 * values[i]);
        }
    }
    assert!(checked > 20, "{checked}");
}

#[test]
fn the_worst_case_is_the_worst_corner_of_a_small_box_in_the_plane_and_in_space() {
    the_worst_case_is_the_worst_corner_of_a_small_box::<2, 1>(93);
    the_worst_case_is_the_worst_corner_of_a_small_box::<3, 3>(94);
}

/// At a placement that was proved to be the best, no finger gains by a step along its edge, nor do
/// several together, wherever there is room: to the rounding of the closed forms.
#[test]
fn no_step_gains_at_a_proved_optimum() {
    let r = &mut Random::new(95);
    let mut steps = 0;
    for round in 0..12 {
        let corners = if round % 2 == 0 { r.convex(5 + round) } else { r.star(5 + round) };
        let outline = Polygon::new(&corners).unwrap();
        let part = Searched::uniform(outline.clone(), 1.0).unwrap();
        let best = fingers(&part, &Fingers::new(4), &Effort::default(), unwatched).unwrap().best;
        // Where a share is zero the step may lose what holds the part, which the quality does not
        // see.
        if best.placements.iter().any(|placement| placement.share < 1e-6) {
            continue;
        }
        let quality = Sensitivity::of_quality(&best.principal, &best.quality, &outline).unwrap();
        let rates: Vec<_> = best
            .placements
            .iter()
            .map(|placement| {
                let edge = &outline.edges()[placement.on];
                let along = (edge.end() - edge.start()).direction().unwrap();
                let room =
                    [edge.start(), edge.end()].map(|end| (placement.point - end).norm() > 1e-6);
                let place = Geometry::on_face(placement.point, placement.inward_normal, 0.0);
                let finger = Contact::<2, 1>::new(place, Law::linear(1.0).unwrap(), 0.0).unwrap();
                let change = Change::along(along);
                (finger.stiffness_rate(&change, quality.origin(), Order::First).unwrap(), room)
            })
            .collect();
        for _ in 0..200 {
            let step = |room: [bool; 2], r: &mut Random| {
                let any = r.between(-1.0, 1.0);
                if room[usize::from(any > 0.0)] { any } else { 0.0 }
            };
            let sum = rates
                .iter()
                .fold(Stiffness::ZERO, |sum, (rate, room)| sum + *rate * step(*room, r));
            let gain = quality.along(&sum);
            assert!(gain <= 1e-9 * best.quality.value, "{round}: {gain}");
            steps += usize::from(gain < -1e-6);
        }
    }
    assert!(steps > 300, "{steps}");
}
