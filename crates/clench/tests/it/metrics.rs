//! Principal parameters, quality, loads and changes of frame of the reference cases.

use clench::metrics::{Displacement, EquivalentStiffness, Principal, Quality, WorstPoint};
use clench::screw::{Axis, Frame, Vector, Wrench, planar, spatial};
use clench::shape::Extent;
use clench_testkit::cases::{Value, array, list, number, numbers};
use clench_testkit::{Random, assert_all_close, assert_close};

use crate::case::{Case, planar_cases, spatial_cases};

/// Quantities from the blocks of K, formed about the center of compliance.
const PRINCIPAL_DIGITS: f64 = 1e-11;

/// `Q_V` and `Q_pt` of ellipses and ellipsoids were searched for in doubles.
const SEARCH_DIGITS: f64 = 1e-9;

/// The upper end of the range of (16) was searched for over all bases.
const RANGE_DIGITS: f64 = 1e-6;

/// The parameters of a case: formed near the part, but where the contacts are out of balance, and
/// the stiffness depends on the origin, about that of the case.
fn principal<const N: usize, const M: usize>(case: &Case<N, M>) -> Principal<N, M> {
    let about = |origin| case.grasp.stiffness(origin, case.order);
    if case.grasp.equilibrium().holds {
        Principal::near(case.grasp.centroid(), about).unwrap()
    } else {
        Principal::of(Vector::ZERO, &about(Vector::ZERO)).unwrap()
    }
}

/// A direction or a whole screw, up to its sign.
fn check_up_to_sign(found: &[f64], wanted: &[f64], digits: f64, what: &str) {
    let dot: f64 = found.iter().zip(wanted).map(|(a, b)| a * b).sum();
    let turned: Vec<f64> = wanted.iter().map(|x| x * dot.signum()).collect();
    assert_all_close(found, &turned, digits, what);
}

fn both<const N: usize, const M: usize>(one: Vector<N>, other: Vector<M>) -> Vec<f64> {
    one.to_array().into_iter().chain(other.to_array()).collect()
}

/// How well the direction of each value is determined: schema.md's `1e-10 + 1e-13 / gap`, or not at
/// all if it is repeated.
fn digits_of_directions(values: &[f64]) -> Vec<Option<f64>> {
    let largest = values[values.len() - 1];
    let gap = |i: usize| {
        let others = (0..values.len()).filter(|&j| j != i);
        others.map(|j| (values[i] - values[j]).abs() / largest).fold(1.0, f64::min)
    };
    (0..values.len()).map(|i| (gap(i) > 1e-9).then(|| 1e-10 + 1e-13 / gap(i))).collect()
}

fn check_principal<const N: usize, const M: usize>(case: &Case<N, M>, length: f64) {
    let principal = principal(case);
    let check = |found: &[f64], key| case.check(found, &["principal", key], PRINCIPAL_DIGITS);
    let (sigma, mu) = (principal.translational(), principal.rotational());
    check(&sigma.values, "sigma");
    check(&mu.values, "mu");
    check(principal.restricted_stiffness().rows().as_flattened(), "K_V");
    check(principal.translational_compliance().rows().as_flattened(), "C_W");

    // C, column by column, from unit wrenches.
    let wanted = list(case.wanted(&["principal", "C"]));
    let unit = |j: usize| Wrench::<N, M> {
        force: Vector::from_fn(|i| if i == j { 1.0 } else { 0.0 }),
        torque: Vector::from_fn(|i| if N + i == j { 1.0 } else { 0.0 }),
    };
    for j in 0..N + M {
        let column = principal.displacement(Vector::ZERO, &unit(j));
        let wanted: Vec<f64> = wanted.iter().map(|row| number(&list(row)[j])).collect();
        let found = both(column.linear, column.angular);
        let scale = wanted.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        for (found, wanted) in found.iter().zip(&wanted) {
            assert_close(
                *found,
                *wanted,
                10.0 * PRINCIPAL_DIGITS,
                scale,
                format!("{} C", case.name),
            );
        }
    }

    // Lengths: zero in the symmetric cases, where only rounding is left.
    let lengths = |found: &[f64], wanted: &[f64], key: &str| {
        for (found, wanted) in found.iter().zip(wanted) {
            let what = format!("{} {key}", case.name);
            assert_close(*found, *wanted, 10.0 * PRINCIPAL_DIGITS, length.max(wanted.abs()), what);
        }
    };
    let wanted = |key| numbers(case.wanted(&["principal", key]));
    lengths(&principal.center().to_array(), &wanted("centre"), "centre");
    let in_body = case.frame.direction_in_frame(principal.center());
    lengths(&in_body.to_array(), &wanted("d_b"), "d_b");
    lengths(principal.twist_map().rows().as_flattened(), &wanted("P1"), "P1");

    let directions = list(case.wanted(&["principal", "sigma_dirs"]));
    for (i, digits) in digits_of_directions(&sigma.values).into_iter().enumerate() {
        let Some(digits) = digits else { continue };
        let what = format!("{} sigma_dirs", case.name);
        check_up_to_sign(&sigma.vectors[i].to_array(), &numbers(&directions[i]), digits, &what);
    }
}

/// The axes and centers that only space has.
fn check_axes(case: &Case<3, 3>, length: f64) {
    let principal = principal(case);
    let wanted = |key| case.wanted(&["principal", key]);
    let lengths = |found: &[f64], wanted: &[f64], digits: f64, key: &str| {
        for (found, wanted) in found.iter().zip(wanted) {
            let what = format!("{} {key}", case.name);
            assert_close(*found, *wanted, digits, length.max(wanted.abs()), what);
        }
    };
    let tensor = principal.pitch_tensor();
    let digits = 10.0 * PRINCIPAL_DIGITS;
    lengths(tensor.rows().as_flattened(), &numbers(wanted("S")), digits, "S");
    for (found, key) in [
        (principal.loncaric_center_of_stiffness(), "centre_of_stiffness"),
        (principal.loncaric_center_of_compliance(), "centre_of_compliance_loncaric"),
    ] {
        lengths(&found.to_array(), &numbers(wanted(key)), digits, key);
    }
    let exists = numbers(wanted("S")).iter().all(|x| x.abs() < 1e-14 * length);
    assert_eq!(principal.center_of_compliance().is_some(), exists, "{}", case.name);

    let screw = |axis: &Axis, wanted: &Value, names: [&str; 2], digits: f64| {
        let found = both(axis.direction, axis.moment());
        let given = [numbers(&wanted[names[0]]), numbers(&wanted[names[1]])].concat();
        let dot: f64 = found.iter().zip(&given).map(|(a, b)| a * b).sum();
        let turned: Vec<f64> = given.iter().map(|x| x * dot.signum()).collect();
        lengths(&found, &turned, digits, names[0]);
        lengths(&axis.point.to_array(), &numbers(&wanted["point"]), digits, "point");
        lengths(&[axis.pitch], &[number(&wanted["pitch"])], digits, "pitch");
    };
    let axes = principal.twist_axes();
    for (i, digits) in digits_of_directions(&principal.rotational().values).into_iter().enumerate()
    {
        if let Some(digits) = digits {
            screw(&axes[i], &list(wanted("twist_axes"))[i], ["omega", "v"], digits);
        }
    }
    let axes = principal.wrench_axes();
    let digits = digits_of_directions(&principal.translational().values);
    for (i, digits) in digits.into_iter().enumerate() {
        if let Some(digits) = digits {
            screw(&axes[i], &list(wanted("wrench_axes"))[i], ["f", "tau"], digits);
        }
    }
}

fn check_quality<const N: usize, const M: usize>(case: &Case<N, M>) {
    let principal = principal(case);
    let body = case.body();
    let quality = Quality::of(&principal, body).unwrap();
    let wanted = |key: &str| case.wanted(&["quality", key]);
    let check = |found: f64, key, digits| case.check(&[found], &["quality", key], digits);
    check(quality.translational, "sigma_min", PRINCIPAL_DIGITS);
    let clusters: Vec<Vec<f64>> = list(wanted("clusters")).iter().map(numbers).collect();
    assert_eq!(quality.degenerate, clusters.len() < M, "{}", case.name);

    let rotations = &quality.rotations;
    let mu = principal.rotational().values;
    let mut of_directions = PRINCIPAL_DIGITS;
    for (i, digits) in digits_of_directions(&mu).into_iter().enumerate() {
        let Some(digits) = digits.filter(|_| !quality.degenerate) else { continue };
        of_directions = digits.max(of_directions);
        let close = |found: f64, key: &str, scale: f64| {
            let wanted = number(&list(wanted(key))[i]);
            let what = format!("{} {key}[{i}]", case.name);
            assert_close(found, wanted, digits, scale.max(wanted.abs()), what);
        };
        close(rotations[i].value, "mu_eq", 0.0);
        close(rotations[i].farthest.value, "deflection", 0.0);
        close(rotations[i].reach, "rho_max", 0.0);
        if N == 3 {
            close(rotations[i].pitch, "pitch", rotations[i].reach);
        }
    }
    if !wanted("mu_eq_cluster").is_null() {
        for (cluster, wanted) in clusters.iter().zip(numbers(wanted("mu_eq_cluster"))) {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "an index")]
            let first = cluster[0] as usize;
            let what = format!("{} mu_eq_cluster", case.name);
            assert_close(rotations[first].value, wanted, of_directions, wanted, what);
        }
    }
    if !wanted("Q_paper").is_null() {
        check(quality.value, "Q_paper", of_directions);
    }
    check(quality.value, "Q", of_directions);
    let digits = match body {
        Extent::Points(_) => 10.0 * PRINCIPAL_DIGITS,
        Extent::Ellipsoid(_) => SEARCH_DIGITS,
    };
    let least = EquivalentStiffness::least(&principal, body).unwrap();
    check(least.value, "Q_V", digits);
    let worst = WorstPoint::of(&principal, body).unwrap();
    check(worst.stiffness, "Q_pt", digits);
    // What was found is proved.
    assert_close(least.at_least, least.value, SEARCH_DIGITS, least.value, "Q_V proved");
    assert_close(worst.at_least, worst.stiffness, SEARCH_DIGITS, worst.stiffness, "Q_pt proved");
}

fn check_load<const N: usize, const M: usize>(case: &Case<N, M>) {
    let given = numbers(case.wanted(&["load", "wrench"]));
    let load = Wrench::<N, M> {
        force: Vector::from_fn(|i| given[i]),
        torque: Vector::from_fn(|i| given[N + i]),
    };
    let principal = principal(case);
    let displacement = Displacement::of(&principal, Vector::ZERO, &load, case.body()).unwrap();
    let twist = displacement.twist;
    case.check(&both(twist.linear, twist.angular), &["load", "twist"], 10.0 * PRINCIPAL_DIGITS);
    // Of smooth parts the files have none.
    if !case.wanted(&["load", "deflection"]).is_null() {
        let largest = displacement.largest.value;
        case.check(&[largest], &["load", "deflection"], 10.0 * PRINCIPAL_DIGITS);
    }
    // The springs answer with the load; what preload and curvature add is not in the changes.
    if case.order == clench::contact::Order::First {
        let changes = case.grasp.force_changes(Vector::ZERO, &twist);
        let answer =
            case.grasp.contacts().iter().zip(changes).fold(load, |sum, (contact, change)| {
                sum + contact.unit_wrench(Vector::ZERO) * change
            });
        let left = both(answer.force, answer.torque);
        let scale = given.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        for left in left {
            assert_close(left, 0.0, 1e-9, scale, format!("{} contact forces", case.name));
        }
    }
}

fn check_change<const N: usize, const M: usize>(
    case: &Case<N, M>,
    world: &Frame<N, M>,
    body: &Frame<N, M>,
) {
    let change = Frame::of_change(&case.frame, world, body);
    let wanted = |key: &str| case.wanted(&["frame_change", key]);
    let pose = world.inverse() * case.frame * *body;
    let check = |found: &[f64], key: &str| {
        let what = format!("{} {key}", case.name);
        assert_all_close(found, &numbers(wanted(key)), 1e-12, what);
    };
    check(&pose.origin().to_array(), "d_bar");
    check(pose.axes().rows().as_flattened(), "R_bar");
    let columns: Vec<Vec<f64>> = (0..N + M)
        .map(|j| {
            let twist = clench::screw::Twist::<N, M> {
                linear: Vector::from_fn(|i| if i == j { 1.0 } else { 0.0 }),
                angular: Vector::from_fn(|i| if N + i == j { 1.0 } else { 0.0 }),
            };
            let moved = twist.to_parent(&change);
            both(moved.linear, moved.angular)
        })
        .collect();
    let rows: Vec<f64> = (0..N + M).flat_map(|i| columns.iter().map(move |c| c[i])).collect();
    check(&rows, "T");

    // Everything is the same there, from K alone.
    if !case.grasp.equilibrium().holds || case.wanted(&["principal"]).is_null() {
        return;
    }
    let here = principal(case);
    let stiffness = case.grasp.stiffness(Vector::ZERO, case.order).in_frame(&change);
    let there = Principal::of(Vector::ZERO, &stiffness).unwrap();
    let (found, wanted) = (there.translational().values, here.translational().values);
    assert_all_close(&found, &wanted, 1e-12, "sigma");
    // K_22 and what is taken from it cancel: schema.md's 1e-10 + eps cond(K).
    let rotational = stiffness.rotational.trace();
    let (found, wanted) = (there.rotational().values, here.rotational().values);
    for (found, wanted) in found.into_iter().zip(wanted) {
        assert_close(found, wanted, 1e-10, wanted + 1e-4 * rotational, "mu");
    }
}

/// Half the largest size of the part.
fn length<const N: usize, const M: usize>(case: &Case<N, M>) -> f64 {
    number(case.wanted(&["length"]))
}

#[test]
fn principal_parameters_are_those_of_the_cases() {
    let mut checked = 0;
    for case in planar_cases() {
        check_principal(&case, length(&case));
        checked += 1;
    }
    for case in spatial_cases() {
        if !case.wanted(&["principal"]).is_null() {
            check_principal(&case, length(&case));
            check_axes(&case, length(&case));
            checked += 1;
        }
    }
    assert!(checked >= 38, "{checked}");
}

#[test]
fn qualities_are_those_of_the_cases() {
    planar_cases().iter().for_each(check_quality);
    let spatial = spatial_cases();
    let held = spatial.iter().filter(|case| !case.wanted(&["quality"]).is_null());
    held.for_each(check_quality);
}

#[test]
fn displacements_by_loads_are_those_of_the_cases() {
    planar_cases().iter().for_each(check_load);
    let spatial = spatial_cases();
    let held = spatial.iter().filter(|case| !case.wanted(&["load", "wrench"]).is_null());
    held.for_each(check_load);
}

#[test]
fn changes_of_frame_are_those_of_the_cases() {
    for case in planar_cases() {
        let given = |key| case.wanted(&["frame_change", key]);
        let world = planar::Frame::new(array(given("d_w")), number(given("theta_w")));
        let body = planar::Frame::new(array(given("d_b")), number(given("theta_b")));
        check_change(&case, &world, &body);
    }
    for case in spatial_cases() {
        let given = |key| array(case.wanted(&["frame_change", key]));
        let world = spatial::Frame::new(given("d_w"), given("theta_w"));
        let body = spatial::Frame::new(given("d_b"), given("theta_b"));
        check_change(&case, &world, &body);
    }
}

/// The largest Q that [LBR, eq. 16] gives for any choice of axes among repeated stiffnesses: the
/// basis of the cluster whose worst deflection is least, by descent from many of them.
fn best_over_bases(case: &Case<3, 3>) -> f64 {
    let principal = principal(case);
    let mu = principal.rotational();
    let members: Vec<usize> = (0..3)
        .filter(|&i| {
            (0..3).any(|j| j != i && (mu.values[i] - mu.values[j]).abs() <= 1e-9 * mu.values[2])
        })
        .collect();
    let body = case.body();
    let equivalent = |rotation: Vector<3>| {
        let deflection = body.fastest(Vector::ZERO, &principal.force_free_twist(rotation)).value;
        rotation.dot(*principal.restricted_stiffness() * rotation) / (deflection * deflection)
    };
    // A pair turns about the third axis only.
    let turned = |turn: [f64; 3]| {
        let turn = match members[..] {
            [_, _] => {
                let alone = (0..3).find(|i| !members.contains(i)).unwrap();
                spatial::rotation(mu.vectors[alone] * turn[0])
            }
            _ => spatial::rotation(turn.into()),
        };
        members.iter().map(|&i| equivalent(turn * mu.vectors[i])).fold(f64::INFINITY, f64::min)
    };
    let r = &mut Random::new(81);
    let mut best = 0.0_f64;
    for _ in 0..60 {
        let mut at = r.array::<3>(2.0);
        let (mut value, mut step) = (turned(at), 0.3);
        while step > 1e-9 {
            let tried: [f64; 3] = r.array(step);
            let next = std::array::from_fn(|i| at[i] + tried[i]);
            let found = turned(next);
            if found > value {
                (at, value) = (next, found);
                step *= 1.5;
            } else {
                step *= 0.97;
            }
        }
        best = best.max(value);
    }
    let alone = (0..3).filter(|i| !members.contains(i)).map(|i| equivalent(mu.vectors[i]));
    alone.fold(best.min(principal.translational().values[0]), f64::min)
}

#[test]
fn the_range_of_the_printed_measure_is_that_of_the_cases() {
    let mut checked = 0;
    for case in spatial_cases() {
        let range = case.wanted(&["quality", "Q_range"]);
        if range.is_null() {
            continue;
        }
        let [least, most] = array(range);
        let quality = Quality::of(&principal(&case), case.body()).unwrap();
        assert_close(quality.value, least, 1e-10, least, "the worst axes");
        assert_close(best_over_bases(&case), most, RANGE_DIGITS, most, "the best axes");
        checked += 1;
    }
    assert!(checked >= 3, "{checked}");
}
