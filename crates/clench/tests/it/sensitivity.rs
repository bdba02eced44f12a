//! Derivatives of the measures against grasps that were made anew on the boundary of the part.

use clench::contact::{Change, Contact, Curvature, Geometry, Hertz, Law, Order};
use clench::metrics::{EquivalentStiffness, Principal, Quality, Sensitivity, WorstPoint};
use clench::screw::Vector;
use clench::shape::{Ellipsoid, Extent, ExtremePoints};
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
        let part = match r.below(2) {
            0 => {
                let corners: Vec<[f64; N]> = (0..9).map(|_| r.array(1.5)).collect();
                Part::Flat(ExtremePoints::new(&corners).unwrap())
            }
            _ => {
                let semi_axes = r.array::<N>(0.5).map(|a| 1.0 + a);
                Part::Smooth(Ellipsoid::new(r.array(0.3).into(), semi_axes).unwrap())
            }
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
    ) -> clench::screw::Stiffness<N, M> {
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
    println!("{checked} derivatives to four digits");
    assert!(checked > 300, "{checked}");
}

#[test]
fn derivatives_are_those_of_grasps_made_anew_in_the_plane_and_in_space() {
    derivatives_are_those_of_grasps_made_anew::<2, 1>(91);
    derivatives_are_those_of_grasps_made_anew::<3, 3>(92);
}
