//! What the frame, the unit and the order of things must not change, and what the parameters are
//! defined by.

use clench_metrics::{LimitedBy, Principal, Quality, WorstPoint};
use clench_screw::{Frame, Stiffness, Twist, Vector, Wrench, planar, spatial};
use clench_shape::Polygon;
use clench_testkit::{Random, assert_all_close, assert_close};

/// A sum of springs at random places near the origin; seven of them leave nothing free.
fn springs<const N: usize, const M: usize>(r: &mut Random) -> Vec<(Vector<N>, Vector<N>, f64)> {
    (0..7).map(|_| (r.array(1.0).into(), r.array(1.0).into(), r.between(0.5, 2.0))).collect()
}

fn assembled<const N: usize, const M: usize>(
    springs: &[(Vector<N>, Vector<N>, f64)],
    origin: Vector<N>,
) -> Stiffness<N, M> {
    springs.iter().fold(Stiffness::ZERO, |sum, &(point, normal, k)| {
        sum + Stiffness::outer(&Wrench::of_force_at(normal, point - origin)) * k
    })
}

/// The same springs in another frame, coordinates and all.
fn moved<const N: usize, const M: usize>(
    springs: &[(Vector<N>, Vector<N>, f64)],
    frame: &Frame<N, M>,
) -> Vec<(Vector<N>, Vector<N>, f64)> {
    let place = |p| frame.point_to_parent(p);
    springs.iter().map(|&(p, n, k)| (place(p), frame.direction_to_parent(n), k)).collect()
}

fn invariance<const N: usize, const M: usize>(
    frame: impl Fn(&mut Random, f64) -> Frame<N, M>,
    seed: u64,
) {
    let r = &mut Random::new(seed);
    for distance in [1.0, 1e3] {
        for _ in 0..50 {
            let springs = springs::<N, M>(r);
            let frame = frame(r, distance);
            let far = moved(&springs, &frame);
            let near = |s: &[_]| {
                let share = 1.0 / s.len() as f64;
                let start = s.iter().fold(Vector::ZERO, |sum, x: &(_, _, _)| sum + x.0 * share);
                Principal::near(start, |origin| assembled::<N, M>(s, origin)).unwrap()
            };
            let (here, there) = (near(&springs), near(&far));
            assert_all_close(
                &there.translational().values,
                &here.translational().values,
                1e-12,
                "sigma",
            );
            // 1e3 body lengths away, coordinates are rounded to 1e-13 body lengths.
            assert_all_close(&there.rotational().values, &here.rotational().values, 1e-11, "mu");
            let center = frame.point_to_parent(here.center()) - there.center();
            assert!(center.norm() <= 1e-11 * distance, "center moved by {}", center.norm());
            let point: Vector<N> = r.array(1.0).into();
            let compliance = there.compliance_at(frame.point_to_parent(point));
            let (found, wanted) = (compliance.trace(), here.compliance_at(point).trace());
            assert_close(found, wanted, 1e-10, wanted, "point compliance");
        }
    }
}

#[test]
fn principal_stiffnesses_do_not_depend_on_the_frame() {
    invariance(|r, d| planar::Frame::new(r.array(d), r.between(-3.0, 3.0)), 31);
    invariance(|r, d| spatial::Frame::new(r.array(d), r.array(2.0)), 32);
}

/// `mu` and `sigma` are what they are named for: the torque per rotation without force, and the
/// force per translation without rotation.
fn definitions<const N: usize, const M: usize>(seed: u64) {
    let r = &mut Random::new(seed);
    for _ in 0..50 {
        let stiffness = assembled::<N, M>(&springs::<N, M>(r), Vector::ZERO);
        let principal = Principal::of(Vector::ZERO, &stiffness).unwrap();
        for (mu, axis) in principal.rotational().values.iter().zip(principal.rotational().vectors) {
            let wrench = stiffness.apply(&principal.forceless_twist(axis));
            let wanted = axis * *mu;
            assert!(wrench.force.norm() <= 1e-12 * wanted.norm().max(1.0));
            assert_all_close(&wrench.torque.to_array(), &wanted.to_array(), 1e-11, "torque");
        }
        let sigma = principal.translational();
        for (value, direction) in sigma.values.iter().zip(sigma.vectors) {
            let push = Twist { linear: direction, angular: Vector::ZERO };
            let wrench = stiffness.apply(&push);
            let wanted = direction * *value;
            assert_all_close(&wrench.force.to_array(), &wanted.to_array(), 1e-12, "force");
        }
        // A force at a point moves it by the point's compliance: solve K q = w in another way.
        let (point, force): (Vector<N>, Vector<N>) = (r.array(1.0).into(), r.array(1.0).into());
        let load = Wrench::<N, M>::of_force_at(force, point);
        let twist = solve(&stiffness, &load);
        let found = principal.compliance_at(point) * force;
        let wanted = twist.velocity_at(point).to_array();
        assert_all_close(&found.to_array(), &wanted, 1e-10, "point");
    }
}

/// Gaussian elimination on the full matrix.
fn solve<const N: usize, const M: usize>(
    stiffness: &Stiffness<N, M>,
    load: &Wrench<N, M>,
) -> Twist<N, M> {
    let size = N + M;
    let mut a: Vec<Vec<f64>> = (0..size)
        .map(|i| {
            let right = if i < N { load.force[i] } else { load.torque[i - N] };
            (0..size).map(|j| stiffness.entry(i, j)).chain([right]).collect()
        })
        .collect();
    for p in 0..size {
        for i in (0..size).filter(|&i| i != p) {
            let factor = a[i][p] / a[p][p];
            for j in p..=size {
                a[i][j] -= factor * a[p][j];
            }
        }
    }
    let x = |i: usize| a[i][size] / a[i][i];
    Twist { linear: Vector::from_fn(x), angular: Vector::from_fn(|i| x(N + i)) }
}

#[test]
fn principal_parameters_fulfil_their_definitions() {
    definitions::<2, 1>(33);
    definitions::<3, 3>(34);
}

#[test]
fn a_far_stiffness_loses_digits_that_a_near_origin_keeps() {
    let r = &mut Random::new(35);
    let springs = springs::<2, 1>(r);
    let far = moved(&springs, &planar::Frame::at([1e5, 0.0].into()));
    let wanted = Principal::of(Vector::ZERO, &assembled::<2, 1>(&springs, Vector::ZERO)).unwrap();
    let mu = wanted.rotational().values[0];
    let of_matrix = Principal::of(Vector::ZERO, &assembled::<2, 1>(&far, Vector::ZERO)).unwrap();
    let near = Principal::near(far[0].0, |origin| assembled::<2, 1>(&far, origin)).unwrap();
    let error = |p: &Principal<2, 1>| ((p.rotational().values[0] - mu) / mu).abs();
    // d^2 eps = 2e-6, and d eps = 2e-11.
    assert!(error(&of_matrix) > 1e-8, "{:e}", error(&of_matrix));
    assert!(error(&near) < 1e-10, "{:e}", error(&near));
}

#[test]
fn a_change_of_units_by_powers_of_four_is_exact() {
    let r = &mut Random::new(36);
    for (length, force) in [(4.0, 1.0), (4.0_f64.powi(-12), 4.0_f64.powi(8))] {
        let springs = springs::<2, 1>(r);
        let corners = r.star(7);
        let evaluate = |l: f64, f: f64| {
            let scaled: Vec<_> = springs.iter().map(|&(p, n, k)| (p * l, n, k * f / l)).collect();
            let body: Vec<_> = corners.iter().map(|[x, y]| [x * l, y * l]).collect();
            let body = Polygon::new(&body).unwrap();
            let principal =
                Principal::near(Vector::ZERO, |o| assembled::<2, 1>(&scaled, o)).unwrap();
            (Quality::of(&principal, &body), WorstPoint::of(&principal, &body).unwrap())
        };
        let ((one, point), (other, far_point)) = (evaluate(1.0, 1.0), evaluate(length, force));
        assert_eq!(other.value, one.value * force / length);
        assert_eq!(other.equivalent, one.equivalent * force / length);
        assert_eq!(other.limited_by, one.limited_by);
        assert_eq!(far_point.stiffness, point.stiffness * force / length);
        assert_eq!(far_point.corner, point.corner);
    }
}

/// `Q / 2 <= Q_pt <= Q`, and `Q_pt` is what forces at the corners find by trial.
#[test]
fn the_worst_point_is_the_worst_and_bounds_the_quality() {
    let r = &mut Random::new(37);
    for _ in 0..100 {
        let stiffness = assembled::<2, 1>(&springs::<2, 1>(r), Vector::ZERO);
        let principal = Principal::of(Vector::ZERO, &stiffness).unwrap();
        let body = Polygon::new(&r.star(6)).unwrap();
        let quality = Quality::of(&principal, &body);
        let worst = WorstPoint::of(&principal, &body).unwrap();
        let slack = 1.0 + 1e-12;
        assert!(worst.stiffness <= quality.value * slack);
        assert!(worst.stiffness * slack >= 0.5 * quality.value);

        let mut softest = f64::INFINITY;
        for &corner in body.corners() {
            for step in 0..360 {
                let angle = f64::from(step).to_radians();
                let force = Vector::new([angle.cos(), angle.sin()]);
                let twist = solve(&stiffness, &Wrench::of_force_at(force, corner));
                softest = softest.min(1.0 / twist.velocity_at(corner).dot(force));
            }
        }
        // Half a degree off the worst direction costs at most the square of that angle times the
        // ratio of the two compliances, below 1e-2.
        assert!(worst.stiffness <= softest * slack && worst.stiffness >= softest * 0.99);
    }
}

#[test]
fn quality_is_the_smaller_of_its_two_stiffnesses() {
    let square = Polygon::new(&[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]).unwrap();
    let quality = |mu: f64| {
        let mut stiffness = Stiffness::<2, 1>::ZERO;
        stiffness.translational = [[3.0, 0.0], [0.0, 4.0]].into();
        stiffness.rotational = [[mu]].into();
        Quality::of(&Principal::of(Vector::ZERO, &stiffness).unwrap(), &square)
    };
    // The corners are at a squared distance of 2.
    let (soft, stiff) = (quality(4.0), quality(40.0));
    assert_eq!(soft.limited_by, LimitedBy::Rotation);
    assert_close(soft.value, 2.0, 1e-15, 2.0, "mu_eq");
    assert_eq!(stiff.limited_by, LimitedBy::Translation);
    assert_close(stiff.value, 3.0, 1e-15, 3.0, "sigma_min");
}

/// Turned about its axis with its pitch, the body answers with a pure couple, `mu_i` times the
/// turn; far from the origin too.
fn a_pure_couple_turns_about_each_axis<const N: usize, const M: usize>(seed: u64) {
    let r = &mut Random::new(seed);
    for distance in [1.0, 1e3] {
        for _ in 0..50 {
            let springs = springs::<N, M>(r);
            let shift: Vector<N> = r.array(distance).into();
            let far = moved(&springs, &Frame::<N, M>::at(shift));
            let about = |origin| assembled::<N, M>(&far, origin);
            let principal = Principal::near(shift, about).unwrap();
            for (i, axis) in principal.twist_axes().into_iter().enumerate() {
                // The velocity of the body near the springs, when it turns about the axis.
                let arm = Vector::<3>::from_fn(|k| if k < N { shift[k] } else { 0.0 }) - axis.point;
                let velocity = spatial::cross(axis.direction, arm) + axis.direction * axis.pitch;
                let twist = Twist::<N, M> {
                    linear: Vector::from_fn(|k| velocity[k]),
                    angular: principal.rotational().vectors[i],
                };
                let wrench = about(shift).apply(&twist);
                let (mu, size) = (principal.rotational().values[i], distance * 1e-13);
                assert!(wrench.force.norm() <= 100.0 * size, "{:?}", wrench.force);
                let off = wrench.torque - twist.angular * mu;
                assert!(off.norm() <= 100.0 * size, "{off:?}");
            }
        }
    }
}

#[test]
fn a_pure_couple_turns_about_each_axis_in_the_plane_and_in_space() {
    a_pure_couple_turns_about_each_axis::<2, 1>(61);
    a_pure_couple_turns_about_each_axis::<3, 3>(62);
}
