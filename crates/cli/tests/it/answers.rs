//! The numbers of the paper, through the command.

use clench_testkit::cases::{list, number, numbers};
use clench_testkit::{assert_all_close, assert_close};

use crate::run::{Folder, QUADRILATERAL, figure_1, part};

/// A few hundred roundings of the numbers of a quadrilateral.
const ROUNDING: f64 = 1e-13;

/// The paper's numbers follow from closed forms; these have ten digits of them.
const DIGITS: f64 = 1e-9;

fn quadrilateral(name: &str) -> Folder {
    let folder = Folder::new(name);
    folder.write("part.toml", part(QUADRILATERAL, "1"));
    folder
}

#[test]
fn four_fingers_on_the_quadrilateral_are_those_of_example_5_2() {
    let report = quadrilateral("example-5-2").json("optimize part.toml --fingers 4");
    assert_close(number(&report["quality"]), 2.0 - 0.1_f64.sqrt(), ROUNDING, 1.0, "Q");
    // mu = 84.5 about the geometric center, whose squared reach is 45.3125.
    assert_close(number(&report["mu_eq"]), 84.5 / 45.3125, ROUNDING, 1.0, "mu_eq");
    let edges: Vec<f64> = list(&report["contacts"]).iter().map(|c| number(&c["edge"])).collect();
    assert_eq!(edges, [0.0, 0.0, 1.0, 3.0]);
    assert_eq!(report["limited_by"], "translation");
    assert_eq!(report["certificate"]["proved"], true);
    assert_eq!((&report["units"]["length"], &report["units"]["force"]), (&"L".into(), &"F".into()));
}

#[test]
fn three_fingers_on_the_quadrilateral_are_those_of_example_5_1() {
    let report = quadrilateral("example-5-1").json("optimize part.toml --fingers 3 --preload 1");
    assert_close(number(&report["quality"]), 0.095_458_453_485, DIGITS, 1.0, "Q");
    assert_close(number(&report["sigma_min"]), 1.276_393_202_250, DIGITS, 1.0, "sigma_min");
    let edges: Vec<f64> = list(&report["contacts"]).iter().map(|c| number(&c["edge"])).collect();
    assert_eq!(edges, [0.0, 1.0, 3.0]);
    assert_all_close(&numbers(&report["center_of_compliance"]), &[6.5, 1.75], ROUNDING, "center");
}

#[test]
fn the_grasp_of_figure_1_has_its_center_of_compliance() {
    let folder = Folder::new("figure-1");
    folder.write("grasp.toml", figure_1());
    let report = folder.json("analyze grasp.toml");
    let center = [80.0 / 13.0, 72.0 / 13.0];
    assert_all_close(&numbers(&report["center_of_compliance"]), &center, ROUNDING, "center");
    // By hand: mu = 5614 / 65, and the squared reach to B is 13105 / 169.
    let mu_eq = 5614.0 / 65.0 / (13105.0 / 169.0);
    assert_close(number(&report["quality"]), mu_eq, ROUNDING, 1.0, "Q");
    assert_close(number(&report["rotational"][0]["equivalent"]), mu_eq, ROUNDING, 1.0, "mu_eq");
    assert_eq!(report["reach"]["corner"], 1);
    assert_eq!(report["stability"], "first_order");
    assert_eq!(report["force_closure"], true);
    assert_eq!((&report["limited_by"], &report["degenerate"]), (&"rotation".into(), &false.into()));
    // The stiffness about A, from the four rows (n, p x n).
    let expected = [1.7, 0.1, -8.8, 0.1, 2.3, 13.6, -8.8, 13.6, 218.8];
    assert_all_close(&numbers(&report["stiffness"]), &expected, ROUNDING, "stiffness");
}

#[test]
fn a_frame_changes_the_coordinates_and_none_of_the_invariants() {
    let folder = Folder::new("frame");
    folder.write("grasp.toml", figure_1());
    let (here, there) = (
        folder.json("analyze grasp.toml"),
        folder.json("analyze grasp.toml --frame -1,2,1.5707963267948966"),
    );
    for name in ["quality", "sigma_min", "mu_eq", "worst_point_stiffness", "preload_margin"] {
        assert_eq!(here[name], there[name], "{name}");
    }
    // A quarter turn: (x, y) becomes (y - 2, -(x + 1)).
    let center = [72.0 / 13.0 - 2.0, -80.0 / 13.0 - 1.0];
    assert_all_close(&numbers(&there["center_of_compliance"]), &center, ROUNDING, "center");
    assert_all_close(&numbers(&there["worst_point"]), &[-2.0, -14.0], ROUNDING, "corner 1");
    let k = numbers(&there["stiffness"]);
    assert_all_close(&[k[0], k[1], k[4]], &[2.3, -0.1, 1.7], ROUNDING, "translational block");
    assert_eq!(numbers(&there["frame"]["origin"]), [-1.0, 2.0]);
}

#[test]
fn what_optimize_writes_analyze_reads_and_agrees_with() {
    let folder = quadrilateral("round-trip");
    for (question, tolerance) in [("--fingers 4", ROUNDING), ("--fingers 4 --top 3", ROUNDING)] {
        let optimum = folder.run(&format!("optimize part.toml {question} --format json"));
        folder.write("grasp.json", &optimum.out);
        let (found, analyzed) = (optimum.json(), folder.json("analyze grasp.json"));
        for name in ["quality", "sigma_min", "mu_eq", "worst_point_stiffness"] {
            let (a, b) = (number(&analyzed[name]), number(&found[name]));
            assert_close(a, b, tolerance, b, name);
        }
        let center = numbers(&found["center_of_compliance"]);
        assert_all_close(&numbers(&analyzed["center_of_compliance"]), &center, tolerance, "center");
    }
}

#[test]
fn a_preloaded_optimum_is_analyzed_to_second_order() {
    let folder = quadrilateral("round-trip-preloaded");
    for fingers in ["3", "4"] {
        let question = format!("optimize part.toml --fingers {fingers} --preload 0.5");
        let optimum = folder.run(&format!("{question} --finger-radius 0.7 --format json"));
        folder.write("grasp.json", &optimum.out);
        let (found, analyzed) = (optimum.json(), folder.json("analyze grasp.json"));
        assert_eq!(analyzed["order"], "second");
        assert_eq!(analyzed["equilibrium"]["holds"], true);
        let (a, b) = (number(&analyzed["quality"]), number(&found["quality_second_order"]));
        assert_close(a, b, ROUNDING, b, fingers);
    }
}

#[test]
fn the_overlaps_lower_the_second_order_quality_by_what_they_are() {
    let report =
        quadrilateral("second-order").json("optimize part.toml --fingers 3 --preload 0.01");
    let shares: Vec<f64> = list(&report["contacts"]).iter().map(|c| number(&c["share"])).collect();
    // delta_i = f_i with stiffness 1, so mu is less by the sum of f_i^2.
    let less: f64 = shares.iter().map(|share| (0.01 * share).powi(2)).sum();
    let expected = number(&report["quality"]) - less / 45.3125;
    let found = number(&report["quality_second_order"]);
    assert_close(found, expected, ROUNDING, expected, "Q to second order");
}

#[test]
fn text_and_json_agree() {
    let folder = quadrilateral("text");
    folder.write("grasp.toml", figure_1());
    let optimum = folder.run("optimize part.toml --fingers 4");
    assert_eq!((optimum.code, optimum.err.as_str()), (Some(0), ""));
    for piece in [
        "Q = 1.68377 F/L, limited by translation",
        "proved    no placement of four fingers on this outline does better\n",
        "search    35 combinations of edges, ",
        "mu_eq                 1.86483 F/L",
        "center of compliance  (6.5, 1.75) L",
        "(1.175, 3.525)",
        "the optimum is a limit: finger 0 is at corner ",
        "lengths in L, forces in F, angles in rad",
    ] {
        assert!(optimum.out.contains(piece), "{piece}: {}", optimum.out);
    }
    let analysis = folder.run("analyze grasp.toml");
    for piece in [
        "Q = 1.1138 F/L, limited by rotation",
        "center of compliance  (6.15385, 5.53846) L",
        "8.80593    1.1138       corner 1 at (13, 0) L",
        "that of the file",
        "              x [L]  y [L]  rot [rad]",
        "torque [F L]  -8.8   13.6   218.8",
    ] {
        assert!(analysis.out.contains(piece), "{piece}: {}", analysis.out);
    }
}

#[test]
fn the_best_combinations_come_in_order() {
    let report = quadrilateral("top").json("optimize part.toml --fingers 4 --top 5");
    let top: Vec<f64> = list(&report["top"]).iter().map(|p| number(&p["quality"])).collect();
    assert_eq!(top.len(), 5);
    assert_eq!(report["top"][0]["quality"], report["quality"]);
    assert!(top.is_sorted_by(|a, b| a >= b), "{top:?}");
    assert_eq!(list(&report["top"][0]["contacts"]), list(&report["contacts"]));
}
