//! Derivatives of a contact's share against the difference of contacts that were made anew.

use clench_contact::{Change, Contact, ContactError, Curvature, ForceLaw, Geometry, Law, Order};
use clench_screw::{Mat, Stiffness, Vector};
use clench_testkit::{Random, assert_close};

use crate::laws::law;

/// The step of central differences: the shares are of size 10 with third derivatives of size 1e3,
/// so that the difference is off by 1e3 h^2 / 6 + 10 eps / h, both about 1e-9.
const STEP: f64 = 3e-6;

/// What that leaves, relative to the largest entry of shares and rates.
const TOLERANCE: f64 = 1e-7;

fn check<const N: usize, const M: usize>(
    contact: &Contact<N, M>,
    change: &Change<N>,
    changed: impl Fn(f64) -> Contact<N, M>,
    origin: Vector<N>,
) {
    for order in [Order::First, Order::Second] {
        let rate = contact.stiffness_rate(change, origin, order).unwrap();
        let [above, below] = [STEP, -STEP].map(|step| changed(step).stiffness(origin, order));
        let difference = (above + below * -1.0) * (0.5 / STEP);
        let size = |k: &Stiffness<N, M>| {
            k.translational.max_abs().max(k.coupling.max_abs()).max(k.rotational.max_abs())
        };
        let scale = size(&rate).max(size(&contact.stiffness(origin, order)));
        for (i, j) in (0..N + M).flat_map(|i| (0..N + M).map(move |j| (i, j))) {
            let (found, wanted) = (rate.entry(i, j), difference.entry(i, j));
            assert_close(found, wanted, TOLERANCE, scale, format_args!("{change:?} {i} {j}"));
        }
    }
}

/// A finger of any shape on a disc or ball, or in a bore, of center `middle`; and on a face.
fn place<const N: usize>(r: &mut Random, normal: Vector<N>, middle: Vector<N>) -> Geometry<N> {
    let operator = |r: &mut Random| {
        let axis: Vector<N> = r.array(0.7).into();
        Curvature::of_shape_operator(Mat::outer(axis, axis) + Mat::IDENTITY * 0.5)
    };
    let radius = [2.5, -2.5, f64::INFINITY][r.below(3)];
    let finger = match r.below(3) {
        0 => Curvature::round(0.0),
        1 => operator(r),
        _ => Curvature::round(r.between(0.2, 1.0)),
    };
    // From the center to the boundary against the inward normal.
    let away = if radius.is_finite() { radius } else { 2.0 };
    let point = middle - normal * away;
    Geometry { point, inward_normal: normal, finger, part: Curvature::round(radius) }
}

/// The same finger after it has gone `step` along the boundary.
fn moved<const N: usize>(from: &Geometry<N>, along: Vector<N>, step: f64) -> Geometry<N> {
    let Some(radius) = from.part.radius().filter(|radius| radius.is_finite()) else {
        return Geometry { point: from.point + along * step, ..*from };
    };
    // Around the center: the outward normal turns towards `along` by step / radius.
    let (sin, cos) = (step / radius).sin_cos();
    let inward_normal = from.inward_normal * cos - along * sin;
    let center = from.point + from.inward_normal * radius;
    Geometry { point: center - inward_normal * radius, inward_normal, ..*from }
}

fn shares_change_at_their_rates<const N: usize, const M: usize>(seed: u64) {
    let r = &mut Random::new(seed);
    for _ in 0..200 {
        let normal = Vector::<N>::from(r.array(1.0)).direction().unwrap();
        let middle = r_array(r);
        let geometry = place(r, normal, middle);
        let other: Vector<N> = r_array(r);
        let along = (other - normal * normal.dot(other)).direction().unwrap();
        let (law, preload) = (law(r), r.between(0.1, 0.3));
        // Line laws may be so soft that the overlap exceeds the radii.
        let Ok(contact) = Contact::<N, M>::new(geometry, law.clone(), preload) else { continue };
        let origin = r_array(r);
        check(
            &contact,
            &Change::along(along),
            |step| Contact::new(moved(&geometry, along, step), law.clone(), preload).unwrap(),
            origin,
        );
        check(
            &contact,
            &Change::Stiffness,
            |step| Contact::new(geometry, law.scaled(1.0 + step).unwrap(), preload).unwrap(),
            origin,
        );
        check(
            &contact,
            &Change::Preload,
            |step| Contact::new(geometry, law.clone(), preload + step).unwrap(),
            origin,
        );
    }
}

fn r_array<const N: usize>(r: &mut Random) -> Vector<N> {
    r.array(1.0).into()
}

#[test]
fn shares_change_at_their_rates_in_the_plane_and_in_space() {
    shares_change_at_their_rates::<2, 1>(71);
    shares_change_at_their_rates::<3, 3>(72);
}

/// A roller whose axis has a direction of its own, on a ball: its curvatures turn with the normal.
#[test]
fn a_finger_keeps_its_principal_direction_on_the_way() {
    let r = &mut Random::new(73);
    for _ in 0..50 {
        let normal = Vector::<3>::from(r.array(1.0)).direction().unwrap();
        let axis = r_array(r);
        let finger = Curvature::principal_curvatures([r.between(0.0, 3.0), 0.5], axis);
        let geometry = Geometry {
            point: r_array(r),
            inward_normal: normal,
            finger,
            part: Curvature::round(2.0),
        };
        let contact = Contact::<3, 3>::new(geometry, law(r), 0.05).unwrap();
        let other: Vector<3> = r_array(r);
        let along = (other - normal * normal.dot(other)).direction().unwrap();
        check(
            &contact,
            &Change::along(along),
            |step| {
                Contact::new(moved(&geometry, along, step), contact.law().clone(), 0.05).unwrap()
            },
            r_array(r),
        );
        // What is along the normal does not count.
        let skew = Change::along(along + normal * 3.0);
        let rate = |change: &Change<3>| {
            contact.stiffness_rate(change, Vector::ZERO, Order::First).unwrap()
        };
        let (one, other) = (rate(&skew), rate(&Change::along(along)));
        assert!((one.rotational - other.rotational).max_abs() < 1e-12);
    }
}

/// A part that is given by its shape operator, which changes on the way.
#[test]
fn the_curvature_of_the_part_may_change_on_the_way() {
    let r = &mut Random::new(74);
    for _ in 0..50 {
        let normal = Vector::new([0.0, 0.0, 1.0]);
        let (along, axis) = (Vector::new([1.0, 0.0, 0.0]), Vector::<3>::from(r.array(0.5)));
        let start = Mat::new([[0.4, 0.1, 0.0], [0.1, 0.8, 0.0], [0.0, 0.0, 0.0]]);
        let grown = |step: f64| start + Mat::outer(axis, axis) * step;
        // The normal n - L t s, and the operator in its tangent plane, which the contact takes.
        let at = |step: f64| Geometry {
            point: along * step,
            inward_normal: normal - start * along * step,
            finger: Curvature::round(0.7),
            part: Curvature::of_shape_operator(grown(step)),
        };
        let law = law(r);
        let contact = Contact::<3, 3>::new(at(0.0), law.clone(), 0.05).unwrap();
        let change = Change::Place { along, curvature_rate: Mat::outer(axis, axis) };
        check(
            &contact,
            &change,
            |step| Contact::new(at(step), law.clone(), 0.05).unwrap(),
            r_array(r),
        );
    }
}

#[test]
fn slopes_grow_with_the_force_at_their_rates() {
    /// The same law, of which nothing is known but values.
    #[derive(Debug)]
    struct Plain(Law);

    impl ForceLaw for Plain {
        fn force(&self, overlap: f64) -> f64 {
            self.0.force(overlap)
        }
        fn slope(&self, overlap: f64) -> f64 {
            self.0.slope(overlap)
        }
        fn energy(&self, overlap: f64) -> f64 {
            self.0.energy(overlap)
        }
        fn overlap(&self, force: f64) -> f64 {
            self.0.overlap(force)
        }
    }

    let r = &mut Random::new(75);
    for _ in 0..100 {
        let (law, force) = (law(r), r.between(0.1, 0.5));
        let plain = Law::custom(Plain(law.clone()));
        // A rounding of the slope over twice the step of the difference, 6e-6 of the force.
        let scale = law.slope_at_force(force) / force;
        assert_close(plain.slope_rate(force), law.slope_rate(force), 1e-9, scale, "by difference");
        let factor = r.between(0.5, 2.0);
        for law in [law, plain] {
            let scaled = law.scaled(factor).unwrap();
            let overlap = law.overlap(force);
            let size = force * factor;
            assert_close(scaled.force(overlap), size, 1e-12, size, "force");
            assert_close(scaled.overlap(size), overlap, 1e-12, overlap, "overlap");
            let slope = law.slope(overlap) * factor;
            assert_close(scaled.slope_at_force(size), slope, 1e-12, slope, "slope");
            let rate = law.slope_rate(force);
            assert_close(scaled.slope_rate(size), rate, 1e-9, scale, "rate");
            let energy = law.energy(overlap) * factor;
            assert_close(scaled.energy(overlap), energy, 1e-12, energy, "energy");
            let largest = law.largest_force() * factor;
            assert!(scaled.largest_force() >= largest * (1.0 - 1e-12));
            assert!(scaled.largest_force() <= largest * (1.0 + 1e-12));
        }
    }
}

#[test]
fn a_finger_cannot_move_along_a_pointed_part() {
    let place = Geometry {
        point: Vector::ZERO,
        inward_normal: Vector::new([0.0, 1.0]),
        finger: Curvature::round(1.0),
        part: Curvature::POINTED,
    };
    let contact = Contact::<2, 1>::new(place, Law::linear(1.0).unwrap(), 0.0).unwrap();
    let rate = |along: [f64; 2]| {
        contact.stiffness_rate(&Change::along(along.into()), Vector::ZERO, Order::First)
    };
    assert_eq!(rate([1.0, 0.0]), Err(ContactError::NoTangent));
    let Err(ContactError::NotFinite { axis: 1, .. }) = rate([1.0, f64::NAN]) else {
        panic!("a move that is not a number was taken")
    };
    // Its law and its preload may change all the same.
    let softer = contact.stiffness_rate(&Change::Stiffness, Vector::ZERO, Order::First).unwrap();
    assert_eq!(softer.translational[1][1], 1.0);
    assert!(matches!(
        Law::linear(1.0).unwrap().scaled(0.0),
        Err(ContactError::NotPositive { parameter: "factor", .. })
    ));
}
