//! Drawings by the names of their files.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use std::path::Path;

use clench_drawing::{DrawingError, Sheet};
use clench_testkit::drawings::{dxf, loop_of};

#[test]
fn the_ending_says_what_a_file_is() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let triangle = [[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]];
    let path = folder.join("triangle.DXF");
    std::fs::write(&path, dxf(Some(5), &loop_of("A", &triangle))).unwrap();
    let sheet = Sheet::read(&path, &["a"]).unwrap();
    assert_eq!(sheet.unit().map(|unit| (unit.name(), unit.micrometers())), Some(("cm", 1e4)));
    let part = sheet.part(10.0, None).unwrap();
    assert_eq!(part.polygon().area().to_bits(), 600.0_f64.to_bits());

    let path = folder.join("triangle.svg");
    std::fs::write(&path, "<svg><polygon points='0,0 4,0 0,3'/></svg>").unwrap();
    assert_eq!(Sheet::read(&path, &[]).unwrap().unit(), None);

    let missing = Sheet::read(folder.join("none.svg"), &[]).unwrap_err();
    assert!(matches!(missing, DrawingError::Unreadable(_)), "{missing}");
    for name in ["triangle.step", "triangle"] {
        let unknown = Sheet::read(folder.join(name), &[]).unwrap_err();
        assert!(matches!(unknown, DrawingError::UnknownEnding), "{unknown}");
    }
}
