//! The contours of drawings as the command reads them.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use clench_testkit::cases::{Value, array, list};

use crate::run::Folder;

/// The corners of the outline and of each hole, and the report.
pub(crate) fn contours(folder: &Folder, arguments: &str) -> (Vec<Vec<[f64; 2]>>, Value) {
    let report = read(folder, &format!("{arguments} --stiffness 1"));
    let planar = &report["part"]["planar"];
    let corners = |contour: &Value| list(contour).iter().map(array).collect();
    let mut contours = vec![corners(&planar["outline"])];
    if let Some(holes) = planar.as_object().unwrap().get("holes") {
        contours.extend(list(holes).iter().map(corners));
    }
    (contours, report)
}

/// The report, with or without an answer, after hardly any search.
pub(crate) fn read(folder: &Folder, arguments: &str) -> Value {
    let ran = folder.run(&format!("optimize {arguments} --fingers 4 --nodes 1 --format json"));
    assert!(matches!(ran.code, Some(0 | 3)), "{arguments}: {}", ran.err);
    ran.json()
}
