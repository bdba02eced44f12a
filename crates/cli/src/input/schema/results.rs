//! What only the reports of `optimize` have: `analyze` reads the rest as a grasp file.

use super::super::node::Node;

/// The results of `optimize` at the top of its report: `analyze` reads the rest as a grasp file.
const RESULT_FIELDS: [&str; 34] = [
    "dimension",
    "drawing",
    "fingers",
    "objective",
    "least_translation",
    "total_preload",
    "finger_radius",
    "least_share",
    "most_on_face",
    "roundness",
    "flatness",
    "clearance",
    "accessible",
    "warnings",
    "effort",
    "quality",
    "sigma_min",
    "mu_eq",
    "limited_by",
    "center_of_compliance",
    "reach",
    "quality_rotational",
    "center",
    "true_center_exists",
    "worst_direction",
    "worst_point_stiffness",
    "worst_point",
    "worst_corner",
    "preload_margin",
    "quality_second_order",
    "quality_second_order_missing",
    "certificate",
    "combinations",
    "top",
];

/// The results at each contact of such a report.
const CONTACT_RESULT_FIELDS: [&str; 3] = ["fixed", "candidate", "share"];

/// Only reports of `optimize` have all of these.
const MARKS_OF_A_REPORT: [&str; 2] = ["certificate", "combinations"];

/// The file without its results, if it is a report of `optimize`; any other file as it is, so
/// that none of its fields is overlooked.
pub(in super::super) fn without_results(mut root: Node) -> Node {
    if is_report(&root) {
        root.remove(&RESULT_FIELDS);
        for contact in root.items_of_field("contacts") {
            contact.remove(&CONTACT_RESULT_FIELDS);
        }
    }
    root
}

/// Whether the file is a report of `optimize`.
pub(in super::super) fn is_report(root: &Node) -> bool {
    MARKS_OF_A_REPORT.iter().all(|name| root.field(name).is_some())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic, reason = "a test that cannot go on fails")]

    use std::collections::BTreeSet;

    use clap::Parser;

    use super::{CONTACT_RESULT_FIELDS, RESULT_FIELDS};
    use crate::arguments::{Arguments, Command};

    const PARTS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../parts");

    /// The report on a question whose files are in the folder of the example parts.
    fn report(question: &str) -> serde_json::Value {
        let words = question.split(' ').map(|word| word.replace("PARTS", PARTS));
        let arguments = ["clench", "optimize"].map(str::to_owned).into_iter().chain(words);
        let arguments = arguments.chain(["--format", "json", "--top", "2"].map(str::to_owned));
        let Command::Optimize(arguments) = Arguments::parse_from(arguments).command else {
            panic!("another command than `optimize`")
        };
        serde_json::from_str(&crate::optimize::optimize(&arguments).unwrap().report).unwrap()
    }

    fn keys(table: &serde_json::Value) -> BTreeSet<String> {
        table.as_object().unwrap().keys().cloned().collect()
    }

    /// A preload so large that its overlaps push the part away leaves no quality to second order.
    #[test]
    fn the_result_fields_are_those_of_a_report() {
        let planar = "PARTS/quadrilateral.toml --fingers 4 --preload";
        let drawing = "PARTS/plate.dxf --stiffness 5e4 --fingers 4 --preload 10 --nodes 1";
        let solid = "PARTS/bearing-block.toml --fix PARTS/locators-321.toml --fingers 2";
        let reports = [
            report(&format!("{planar} 0.1")),
            report(&format!("{planar} 1000")),
            report("PARTS/quadrilateral-grasp.toml --fingers 4"),
            report(drawing),
            report(&format!("{solid} --nodes 1")),
            report(&format!("{solid} --margin 1 --clearance 1 --nodes 1")),
            report(&format!("{solid} --candidates PARTS/clamp-places.toml --nodes 1")),
        ];
        let mut found: BTreeSet<String> = reports.iter().flat_map(keys).collect();
        for read in ["version", "units", "part", "contacts"] {
            assert!(found.remove(read), "{read}");
        }
        assert_eq!(found, RESULT_FIELDS.map(str::to_owned).into());
        let contacts = reports.iter().flat_map(|report| report["contacts"].as_array().unwrap());
        let mut found: BTreeSet<String> = contacts.flat_map(keys).collect();
        for read in ["point", "inward_normal", "edge", "face", "law", "preload", "finger"] {
            assert!(found.remove(read), "{read}");
        }
        assert_eq!(found, CONTACT_RESULT_FIELDS.map(str::to_owned).into());
    }
}
