//! Printed results of texts and of other programs; each source is in `docs/sources.md`.

use clench_contact::{Elastic, ForceLaw, Hertz, Line, LineContact, effective_modulus};
use clench_testkit::assert_close;

/// Harris and Kotzalas, table 6.1: `F(rho) = (B - A) / (B + A)`, and the semi-axes and the
/// approach relative to `a* (3 f / (4 E* (A + B)))^(1/3)` and
/// `delta* (9 f^2 (A + B) / (16 E*^2))^(1/3)`. One entry, `delta*` at 0.4795, is misprinted
/// (0.9429 for 0.9432) and left out.
const HARRIS: [(f64, f64, f64, Option<f64>); 22] = [
    (0.0, 1.0, 1.0, Some(1.0)),
    (0.1075, 1.0760, 0.9318, Some(0.9974)),
    (0.3204, 1.2623, 0.8114, Some(0.9761)),
    (0.4795, 1.4556, 0.7278, None),
    (0.5916, 1.6440, 0.6687, Some(0.9077)),
    (0.6716, 1.8258, 0.6245, Some(0.8733)),
    (0.7332, 2.011, 0.5881, Some(0.8394)),
    (0.7948, 2.265, 0.5480, Some(0.7961)),
    (0.834_95, 2.494, 0.5186, Some(0.7602)),
    (0.873_66, 2.800, 0.4863, Some(0.7169)),
    (0.909_99, 3.233, 0.4499, Some(0.6636)),
    (0.936_57, 3.738, 0.4166, Some(0.6112)),
    (0.957_38, 4.395, 0.3830, Some(0.5551)),
    (0.972_90, 5.267, 0.3490, Some(0.4960)),
    (0.983_797, 6.448, 0.3150, Some(0.4352)),
    (0.990_902, 8.062, 0.2814, Some(0.3745)),
    (0.995_112, 10.222, 0.2497, Some(0.3176)),
    (0.997_300, 12.789, 0.2232, Some(0.2705)),
    (0.998_184_7, 14.839, 0.2072, Some(0.2427)),
    (0.998_915_6, 17.974, 0.188_22, Some(0.2106)),
    (0.999_478_5, 23.55, 0.164_42, Some(0.171_67)),
    (0.999_852_7, 37.38, 0.130_50, Some(0.119_95)),
];

#[test]
fn ellipses_are_those_of_the_bearing_tables() {
    for (difference, a, b, delta) in HARRIS {
        // A + B = 1, E* = 1 and a force that makes the scale of the semi-axes 1.
        let gap = [0.5 * (1.0 - difference), 0.5 * (1.0 + difference)];
        let law = Hertz::elliptic(1.0, gap).unwrap();
        let overlap = law.overlap(4.0 / 3.0);
        let found = law.semi_axes(overlap);
        // The table has four digits, the last one within one unit, and the difference from 1 of
        // its first column fewer.
        assert_close(found[0], a, 2.5e-4, a, format!("a* at {difference}"));
        assert_close(found[1], b, 2.5e-4, b, format!("b* at {difference}"));
        if let Some(delta) = delta {
            assert_close(overlap, delta, 2.5e-4, delta, format!("delta* at {difference}"));
        }
    }
}

/// Reference outputs of CONTACT, which solves the half space by boundary elements: Poisson's ratio
/// and shear modulus of both bodies, force, gap curvatures; printed semi-axes (analytical),
/// approach and peak pressure (discretized, to 1e-3 or so).
#[test]
fn ellipses_are_those_of_a_boundary_element_program() {
    let cases: [([f64; 3], [f64; 2], [f64; 4]); 4] = [
        ([0.28, 82e3, 106_700.0], [0.000_281_417_31, 0.0008], [12.61, 6.304, 0.076_51, 640.7]),
        ([0.28, 82e3, 82e3], [0.000_846_419_5, 0.002_406_162], [8.0, 4.0, 0.092_66, 1223.0]),
        ([0.28, 1.0, 0.7563], [0.002_963, 0.002_963], [4.1, 4.1, 0.099_59, 0.021_48]),
        ([0.42, 200.0, 9.1954], [0.01, 0.01], [1.0, 1.0, 0.019_98, 4.393]),
    ];
    for ([nu, shear, force], gap, [a, b, approach, pressure]) in cases {
        let body = Elastic::new(2.0 * shear * (1.0 + nu), nu).unwrap();
        let law = Hertz::elliptic(effective_modulus(body, body), gap).unwrap();
        let overlap = law.overlap(force);
        let found = law.semi_axes(overlap);
        assert_close(found[0], a, 2.5e-4, a, "a");
        assert_close(found[1], b, 2.5e-4, b, "b");
        assert_close(overlap, approach, 1.2e-3, approach, "approach");
        assert_close(law.peak_pressure(overlap), pressure, 1e-3, pressure, "peak pressure");
    }
}

/// The benchmarks of two finite-element programs: MOOSE prints a = 0.1 and d = 0.01, `Code_Aster`
/// (SSNV104) a pressure of 2798.3 `MPa`.
#[test]
fn two_spheres_are_those_of_finite_element_benchmarks() {
    let body = Elastic::new(1.406_25e7, 0.25).unwrap();
    let law = Hertz::circular(effective_modulus(body, body), 1.0).unwrap();
    let overlap = law.overlap(10_000.0);
    assert_close(overlap, 0.01, 1e-14, 0.01, "approach");
    assert_close(law.semi_axes(overlap)[0], 0.1, 1e-14, 0.1, "radius of the contact");

    let body = Elastic::new(20_000.0, 0.3).unwrap();
    let law = Hertz::circular(effective_modulus(body, body), 25.0).unwrap();
    assert_close(law.peak_pressure(4.0), 2798.3, 2e-5, 2798.3, "peak pressure");
}

/// NAFEMS: a steel cylinder of radius 50 mm on an aluminum block, 35 kN per millimeter, half
/// width 6.21 mm, pressure 3585. ANSYS VM191: two cylinders of 10 and 13 mm, 3200 N per millimeter,
/// 1.20 mm; their relative radius is that of a disc on a straight edge.
#[test]
fn half_widths_are_those_of_finite_element_benchmarks() {
    let cases = [
        (50.0, [(210e3, 0.3), (70e3, 0.3)], 35e3, 6.21, Some(3585.0)),
        (130.0 / 23.0, [(30_000.0, 0.25), (29_120.0, 0.3)], 3200.0, 1.20, None),
    ];
    for (radius, [(young, nu), (part_young, part_nu)], force, half_width, pressure) in cases {
        let finger = Elastic::new(young, nu).unwrap();
        let part = Elastic::new(part_young, part_nu).unwrap();
        let (thickness, reference_depth) = (1.0, 10.0 * radius);
        let contact = LineContact { radius, thickness, reference_depth, finger, part };
        let law = Line::new(&contact).unwrap();
        assert_close(law.half_width(force), half_width, 1e-3, half_width, "half width");
        if let Some(pressure) = pressure {
            assert_close(law.peak_pressure(force), pressure, 1.5e-4, pressure, "peak pressure");
        }
    }
}
