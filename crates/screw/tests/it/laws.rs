//! Properties that hold for every frame, twist, wrench and stiffness, in the plane and in space.

use clench_screw::{
    Axis, Cholesky, Frame, Mat, Stiffness, SymmetricEigen, Twist, Vector, Wrench, lever,
    lever_center, planar, spatial,
};
use clench_testkit::{Random, assert_all_close, assert_close};

/// A handful of products of a few terms each: errors of tens of units of rounding.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

fn twist<const N: usize, const M: usize>(r: &mut Random) -> Twist<N, M> {
    Twist { linear: r.array(1.0).into(), angular: r.array(1.0).into() }
}

fn wrench<const N: usize, const M: usize>(r: &mut Random) -> Wrench<N, M> {
    Wrench { force: r.array(1.0).into(), torque: r.array(1.0).into() }
}

fn stiffness<const N: usize, const M: usize>(r: &mut Random) -> Stiffness<N, M> {
    (0..7).fold(Stiffness::ZERO, |k, _| k + Stiffness::outer(&wrench(r)))
}

fn numbers_of_twist<const N: usize, const M: usize>(q: &Twist<N, M>) -> Vec<f64> {
    [q.linear.to_array().as_slice(), &q.angular.to_array()].concat()
}

fn numbers_of_wrench<const N: usize, const M: usize>(w: &Wrench<N, M>) -> Vec<f64> {
    [w.force.to_array().as_slice(), &w.torque.to_array()].concat()
}

fn numbers_of_stiffness<const N: usize, const M: usize>(k: &Stiffness<N, M>) -> Vec<f64> {
    (0..N + M).flat_map(|i| (0..N + M).map(move |j| k.entry(i, j))).collect()
}

fn numbers_of_frame<const N: usize, const M: usize>(f: &Frame<N, M>) -> Vec<f64> {
    [
        f.origin().to_array().as_slice(),
        f.axes().rows().as_flattened(),
        f.spin().rows().as_flattened(),
    ]
    .concat()
}

/// `T` column by column, from the change of unit twists alone.
fn matrix<const N: usize, const M: usize>(f: &Frame<N, M>) -> Vec<Vec<f64>> {
    (0..N + M)
        .map(|i| {
            let unit = Twist {
                linear: Vector::from_fn(|j| f64::from(u8::from(i == j))),
                angular: Vector::from_fn(|j| f64::from(u8::from(i == j + N))),
            };
            numbers_of_twist::<N, M>(&unit.to_parent(f))
        })
        .collect()
}

fn laws<const N: usize, const M: usize>(
    mut frame: impl FnMut(&mut Random) -> Frame<N, M>,
    seed: u64,
) {
    let r = &mut Random::new(seed);
    for _ in 0..200 {
        let (a, b) = (frame(r), frame(r));
        let (q, w, k) = (twist::<N, M>(r), wrench::<N, M>(r), stiffness::<N, M>(r));
        let point: Vector<N> = r.array(2.0).into();

        // Composition and inversion.
        let ab = a * b;
        assert_all_close(
            &numbers_of_twist(&q.to_parent(&ab)),
            &numbers_of_twist(&q.to_parent(&b).to_parent(&a)),
            ROUNDING,
            "composition of twists",
        );
        assert_all_close(
            &numbers_of_wrench(&w.in_frame(&ab)),
            &numbers_of_wrench(&w.in_frame(&a).in_frame(&b)),
            ROUNDING,
            "composition of wrenches",
        );
        assert_all_close(
            &numbers_of_frame(&(a * a.inverse())),
            &numbers_of_frame(&Frame::<N, M>::IDENTITY),
            ROUNDING,
            "inverse",
        );
        assert_all_close(
            &numbers_of_twist(&q.to_parent(&a).in_frame(&a)),
            &numbers_of_twist(&q),
            ROUNDING,
            "twist there and back",
        );
        assert_all_close(
            &numbers_of_wrench(&w.to_parent(&a).in_frame(&a)),
            &numbers_of_wrench(&w),
            ROUNDING,
            "wrench there and back",
        );
        assert_all_close(
            &a.point_in_frame(a.point_to_parent(point)).to_array(),
            &point.to_array(),
            ROUNDING,
            "point there and back",
        );

        // Power is the same in every frame, and so is the energy of a displacement.
        let power = q.in_frame(&a).power(&w.in_frame(&a));
        assert_close(power, q.power(&w), ROUNDING, 10.0, "power");
        let (near, far) = (k.quadratic(&q), k.in_frame(&a).quadratic(&q.in_frame(&a)));
        assert_close(far, near, ROUNDING, 100.0, "energy");

        // A material point moves the same way whoever looks.
        let moved = a.direction_to_parent(q.velocity_at(point));
        let seen = q.to_parent(&a).velocity_at(a.point_to_parent(point));
        assert_all_close(&seen.to_array(), &moved.to_array(), ROUNDING, "velocity of a point");

        // Congruence (7) with the explicit matrix T.
        let t = matrix(&a);
        let size = N + M;
        let mut expected = Vec::new();
        for i in 0..size {
            for j in 0..size {
                let terms = (0..size).flat_map(|p| (0..size).map(move |q| (p, q)));
                expected.push(terms.map(|(p, q)| t[i][p] * k.entry(p, q) * t[j][q]).sum());
            }
        }
        assert_all_close(&numbers_of_stiffness(&k.in_frame(&a)), &expected, ROUNDING, "T^T K T");
        let back = k.in_frame(&a).to_parent(&a);
        assert_all_close(&numbers_of_stiffness(&back), &numbers_of_stiffness(&k), 1e-12, "K back");

        // The lever map is linear and has its center back.
        assert_eq!(lever_center::<N, M>(&lever(point)), point);
    }
}

/// Lengths by 4^p and forces by 4^q are exact in binary: so is every result.
fn exact_units<const N: usize, const M: usize>(
    frame: impl Fn(&[f64; 6], f64) -> Frame<N, M>,
    seed: u64,
) {
    let r = &mut Random::new(seed);
    for power in [-40, -7, 9, 40] {
        let (length, force) = (4.0_f64.powi(power), 4.0_f64.powi(-power / 2));
        let place: [f64; 6] = r.array(2.0);
        let k = stiffness::<N, M>(r);
        let scaled = Stiffness {
            translational: k.translational * (force / length),
            coupling: k.coupling * force,
            rotational: k.rotational * (force * length),
        };
        let (one, other) =
            (k.in_frame(&frame(&place, 1.0)), scaled.in_frame(&frame(&place, length)));
        assert_eq!(other.translational, one.translational * (force / length));
        assert_eq!(other.coupling, one.coupling * force);
        assert_eq!(other.rotational, one.rotational * (force * length));
        let (one, other) = (
            SymmetricEigen::new(&k.translational).unwrap(),
            SymmetricEigen::new(&scaled.translational).unwrap(),
        );
        assert_eq!(other.values.map(|x| x * length / force), one.values);
        assert_eq!(other.vectors, one.vectors);
        let (one, other) =
            (Cholesky::new(&k.rotational).unwrap(), Cholesky::new(&scaled.rotational).unwrap());
        assert_eq!(other.inverse() * (force * length), one.inverse());
    }
}

fn planar_frame(p: &[f64; 6], length: f64) -> planar::Frame {
    planar::Frame::new([p[0] * length, p[1] * length], p[2])
}

fn spatial_frame(p: &[f64; 6], length: f64) -> spatial::Frame {
    spatial::Frame::new([p[0] * length, p[1] * length, p[2] * length], [p[3], p[4], p[5]])
}

#[test]
fn frames_obey_the_laws_of_rigid_motions() {
    laws(|r| planar_frame(&r.array(3.0), 1.0), 1);
    laws(|r| spatial_frame(&r.array(3.0), 1.0), 2);
}

#[test]
fn a_change_of_units_by_powers_of_four_is_exact() {
    exact_units(planar_frame, 3);
    exact_units(spatial_frame, 4);
}

/// Twists survive a detour over a frame `d` away with `d` units of rounding, a stiffness with
/// `d^2`: the bounds that its documentation states.
#[test]
fn far_frames_lose_no_more_than_their_distance_explains() {
    fn check<const N: usize, const M: usize>(frame: &Frame<N, M>, d: f64, r: &mut Random) {
        let (q, k) = (twist::<N, M>(r), stiffness::<N, M>(r));
        let back = q.to_parent(frame).in_frame(frame);
        assert_all_close(&numbers_of_twist(&back), &numbers_of_twist(&q), ROUNDING * d, "twist");
        let back = k.in_frame(frame).to_parent(frame);
        let (found, expected) = (numbers_of_stiffness(&back), numbers_of_stiffness(&k));
        assert_all_close(&found, &expected, ROUNDING * d * d, "stiffness");
    }
    let r = &mut Random::new(5);
    for d in [1e2, 1e4, 1e6] {
        for _ in 0..50 {
            let mut p: [f64; 6] = r.array(1.0);
            p[0] += 2.0;
            check(&planar::Frame::new([p[0] * d, p[1] * d], p[2]), 3.0 * d, r);
            let origin = [p[0] * d, p[1] * d, p[2] * d];
            check(&spatial::Frame::new(origin, [p[3], p[4], p[5]]), 3.0 * d, r);
        }
    }
}

/// Rebuilds `Q diag(values) Q^T` and compares, for matrices with chosen eigenvalues.
fn eigen_of_chosen_values<const N: usize>(rotation: &Mat<N, N>, values: [f64; N]) {
    let diagonal = Mat::from_fn(|i, j| if i == j { values[i] } else { 0.0 });
    let a = (*rotation * diagonal * rotation.transpose()).symmetric_part();
    let eigen = SymmetricEigen::new(&a).unwrap();
    let mut sorted = values;
    sorted.sort_by(f64::total_cmp);
    let limit = 8.0 * N as f64 * f64::EPSILON;
    assert_all_close(&eigen.values, &sorted, limit, "eigenvalues");
    let beside = SymmetricEigen::beside_largest(&a).unwrap();
    assert_all_close(&beside.values, &sorted, limit, "eigenvalues beside the largest");
    if sorted[0] >= 0.0 {
        let largest = SymmetricEigen::largest_value(&a).unwrap();
        assert_all_close(&[largest], &sorted[N - 1..], 32.0 * limit, "largest");
    }
    let q = Mat::<N, N>::from_fn(|i, j| eigen.vectors[j][i]);
    let rebuilt =
        q * Mat::from_fn(|i, j| if i == j { eigen.values[i] } else { 0.0 }) * q.transpose();
    assert_all_close(rebuilt.rows().as_flattened(), a.rows().as_flattened(), limit, "rebuilt");
    let product = q.transpose() * q;
    let identity = Mat::<N, N>::IDENTITY;
    assert_all_close(product.rows().as_flattened(), identity.rows().as_flattened(), limit, "basis");
}

#[test]
fn eigenvectors_rebuild_the_matrix_for_repeated_values_and_at_any_scale() {
    let r = &mut Random::new(6);
    for _ in 0..300 {
        let turn = spatial::rotation(r.array(3.0).into());
        let frame = planar::Frame::new([0.0, 0.0], r.between(-3.0, 3.0));
        for scale in [1e-300, 1e-6, 1.0, 1e9, 1e300] {
            for v in [[1.0, 1.0, 2.0], [2.0, 2.0, 2.0], [-1.0, 0.0, 5.0], [1.0, 1.0 + 1e-15, 3.0]] {
                eigen_of_chosen_values(&turn, v.map(|x| x * scale));
                eigen_of_chosen_values(frame.axes(), [v[0] * scale, v[2] * scale]);
            }
        }
    }
}

#[test]
fn cholesky_solves_what_it_factorised() {
    let r = &mut Random::new(7);
    for _ in 0..200 {
        let k = stiffness::<3, 3>(r).translational;
        let x: Vector<3> = r.array(1.0).into();
        let solved = Cholesky::new(&k).unwrap().solve(k * x);
        // Seven random springs: the condition number stays below 1e4.
        assert_all_close(&solved.to_array(), &x.to_array(), 1e-11, "solution");
        let product = k * Cholesky::new(&k).unwrap().inverse();
        let identity = Mat::<3, 3>::IDENTITY;
        assert_all_close(
            product.rows().as_flattened(),
            identity.rows().as_flattened(),
            1e-11,
            "A A^-1",
        );
    }
}

#[test]
fn the_left_jacobian_is_the_derivative_of_the_exponential_map() {
    let r = &mut Random::new(8);
    for size in [1e-9, 1e-3, 0.2, 0.3, 2.5] {
        let theta: Vector<3> = r.array(size).into();
        let rate: Vector<3> = r.array(1.0).into();
        // Central differences of step h err by h^2 / 6 and by eps / h.
        let h = 1e-5;
        let ahead = spatial::rotation(theta + rate * h);
        let behind = spatial::rotation(theta + rate * (-h));
        let spin = (ahead + behind * -1.0) * (0.5 / h) * spatial::rotation(theta).transpose();
        let omega = spatial::left_jacobian(theta) * rate;
        assert_all_close(&lever_center::<3, 3>(&spin).to_array(), &omega.to_array(), 1e-9, "omega");
    }
}

/// The power of a unit wrench on one axis along a unit twist on another, from pitches, angle and
/// distance, whatever the order and the frame.
#[test]
fn the_reciprocal_product_is_that_of_pitches_angle_and_distance() {
    let r = &mut Random::new(9);
    for distance in [1.0, 1e3] {
        for _ in 0..100 {
            let shift: Vector<3> = r.array(distance).into();
            let mut axis = || {
                let direction = Vector::<3>::from(r.array(1.0)).direction().unwrap();
                let about_shift = Axis::new(direction, r.array(1.0).into());
                let moment = about_shift.moment() + spatial::cross(shift, direction);
                Axis::new(direction, moment)
            };
            let (one, other) = (axis(), axis());
            let product = one.reciprocal_product(&other);
            let size = distance * distance.max(1.0) * 1e-14;
            assert_close(other.reciprocal_product(&one), product, 1.0, size, "other order");
            // Far from the origin the power itself loses the square of the distance.
            let power = one.twist().power(&other.wrench());
            assert_close(power, product, 1.0, 10.0 * size, "power");
            let normal = spatial::cross(one.direction, other.direction);
            let (sine, cosine) = (normal.norm(), one.direction.dot(other.direction));
            let apart = (other.point - one.point).dot(normal) / sine;
            let wanted = (one.pitch + other.pitch) * cosine - apart * sine;
            assert_close(product, wanted, 1.0, 10.0 * size, "formula");
        }
    }
}
