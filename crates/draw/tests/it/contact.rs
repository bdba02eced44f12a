//! The cross-section of one contact: where its points stand, what it refuses, what it names.

use clench_draw::{ContactPicture, DrawError, Input};

use crate::svg::{apart, assert_well_formed, field, labels};

fn contact(finger_radius: f64, part_radius: f64, overlap: f64) -> ContactPicture {
    let caption = vec!["f = 200 N".into(), "k = f'".into()];
    ContactPicture { finger_radius, part_radius, overlap, half_width: None, caption }
}

/// A convex, a flat and a hollow part under a whole finger; a finger that is cut off.
pub(crate) fn contacts() -> [ContactPicture; 4] {
    [
        ContactPicture { half_width: Some(2.0), ..contact(5.0, 12.0, 1.2) },
        ContactPicture { half_width: Some(2.0), ..contact(5.0, f64::INFINITY, 1.0) },
        contact(5.0, -9.0, 1.2),
        ContactPicture { half_width: Some(1.5), ..contact(50.0, 2.5, 0.8) },
    ]
}

fn svg(picture: &ContactPicture) -> String {
    picture.figure().expect("a contact that is drawn").to_svg()
}

#[test]
fn a_whole_finger_on_a_flat_part_stands_where_a_ruler_puts_it() {
    // 25 a unit, b at (190, 237). A chord of the finger 1 above its lowest point is 3 to either
    // side, as 3^2 + 4^2 = 5^2.
    let svg = svg(&contacts()[1]);
    // The finger goes round from its top, 2 * 125 above a.
    assert!(svg.contains("<path d=\"M190 12C"));
    assert!(svg.contains("<path d=\"M0 237L380 237\""), "the boundary");
    assert!(svg.contains("L265 237L115 237Z\""), "the lens");
    assert!(svg.contains("<path d=\"M140 237L240 237\" fill=\"none\" stroke=\"#d5650a\""));
    for y in [237, 262] {
        assert!(svg.contains(&format!("<circle cx=\"190\" cy=\"{y}\"")), "b, then a");
        // The overlap is measured 22 beside the lens.
        assert!(svg.contains(&format!("<path d=\"M196 {y}L292 {y}\"")), "extension lines");
    }
    // The center, marked by a cross.
    assert!(svg.contains("M183 137L197 137") && svg.contains("M190 144L190 130"));
}

#[test]
fn two_equal_discs_overlap_in_a_lens_as_high_as_the_overlap() {
    // Each is 1 of the overlap of 2 deep, so the lens is 3 to either side: 75 at 25 a unit. With
    // c 75 above b, b is 75 + 125 + 12 below the top of the view.
    let svg = svg(&contact(5.0, 5.0, 2.0));
    assert!(svg.contains("<circle cx=\"190\" cy=\"212\"") && svg.contains("cy=\"262\""));
    assert!(svg.contains("<path d=\"M115 237C") && svg.contains(" 265 237L265 237C"), "{svg}");
}

#[test]
fn the_lens_in_a_hollow_is_a_crescent() {
    // 12^2 = 13^2 - 5^2 = 15^2 - 9^2, so at 12 beside the axis the finger has risen by 8 from a
    // and the hollow by 6 from b: an overlap of 2. The widest lens is 176 to either side, which
    // makes 44 / 3 a unit; the center is 11 above b, and the view ends 26 page units above it.
    let svg = svg(&contact(13.0, -15.0, 2.0));
    assert!(svg.contains("<path d=\"M44 99.33C") && svg.contains(" 396 99.33L396 99.33C"), "{svg}");
}

#[test]
fn a_finger_larger_than_the_view_is_a_cap_without_a_center() {
    let names = |picture: &ContactPicture| -> Vec<String> {
        labels(&svg(picture)).into_iter().map(|(name, _)| name).collect()
    };
    let [whole, _, _, cut] = contacts();
    assert_eq!(names(&whole), ["finger A", "part B", "δ", "aH", "b", "a", "n", "c", "rA", "rB"]);
    assert_eq!(names(&cut), ["finger A", "part B", "δ", "aH", "b", "a", "n", "rA", "rB"]);
}

#[test]
fn the_sign_of_the_parts_radius_is_told() {
    let radius = |part| labels(&svg(&contact(5.0, part, 1.0))).pop().expect("labels").0;
    assert_eq!(radius(12.0), "rB");
    assert_eq!(radius(-12.0), "rB < 0");
    assert_eq!(radius(f64::INFINITY), "rB = ∞");
}

#[test]
fn a_contact_says_which_number_is_not_one() {
    let fault = |change: &dyn Fn(&mut ContactPicture)| {
        let mut picture = contacts()[0].clone();
        change(&mut picture);
        picture.figure().err()
    };
    for (input, set) in [
        (Input::FingerRadius, (|p, v| p.finger_radius = v) as fn(&mut ContactPicture, f64)),
        (Input::Overlap, |p, v| p.overlap = v),
        (Input::HalfWidth, |p, v| p.half_width = Some(v)),
    ] {
        let not_finite = DrawError::NotFinite { input, index: 0, value: f64::INFINITY };
        assert_eq!(fault(&|p| set(p, f64::INFINITY)), Some(not_finite));
        for value in [0.0, -1.0] {
            assert_eq!(fault(&|p| set(p, value)), Some(DrawError::NotPositive { input, value }));
        }
    }
    let input = Input::PartRadius;
    let not_finite = DrawError::NotFinite { input, index: 0, value: f64::NEG_INFINITY };
    assert_eq!(fault(&|p| p.part_radius = f64::NEG_INFINITY), Some(not_finite));
    assert!(matches!(
        fault(&|p| p.part_radius = f64::NAN),
        Some(DrawError::NotFinite { input: Input::PartRadius, index: 0, value }) if value.is_nan()
    ));
}

#[test]
#[expect(clippy::float_cmp, reason = "all these numbers are exact in binary")]
fn a_contact_that_no_picture_shows_is_refused() {
    let fault = |finger, part, overlap| contact(finger, part, overlap).figure().err();
    let deep = |overlap, limit| Some(DrawError::OverlapTooDeep { overlap, limit });
    assert_eq!(fault(5.0, 12.0, 2.75), deep(2.75, 2.5));
    assert_eq!(fault(5.0, -6.0, 2.75), deep(2.75, 2.5));
    assert_eq!(fault(5.0, 1.0, 0.75), deep(0.75, 0.5));
    assert_eq!(fault(5.0, 0.0, 0.75), deep(0.75, 0.0));
    let tight = DrawError::TightHollow { finger: 5.0, hollow: 5.0 };
    assert_eq!(fault(5.0, -5.0, 1.0), Some(tight));
    // A chord of 13^2 = 12^2 + 5^2 is 5 beside the middle of its arc of height 1; one of
    // 221^2 = 220^2 + 21^2 is 21 beside it. The tolerances are for a few roundings of a ratio.
    assert_eq!(fault(13.0, f64::INFINITY, 1.0), None);
    let Some(DrawError::LensTooFlat { ratio, limit }) = fault(221.0, f64::INFINITY, 1.0) else {
        panic!("a lens that is drawn");
    };
    assert!((ratio - 21.0).abs() < 1e-9 && limit == 11.0, "{ratio} {limit}");
    assert!(matches!(
        fault(1e300, f64::INFINITY, 1e-300),
        Some(DrawError::LensTooFlat { ratio: f64::INFINITY, .. })
    ));
    let wide = ContactPicture { half_width: Some(3.5), ..contact(5.0, f64::INFINITY, 1.0) };
    assert!(matches!(
        wide.figure(),
        Err(DrawError::ContactBeyondLens { half_width: 3.5, limit }) if (limit - 3.0).abs() < 1e-9
    ));
}

#[test]
fn contacts_of_any_size_and_of_almost_flat_parts_are_drawn() {
    for unit in [1e-300, 1e300] {
        assert_well_formed(&svg(&contact(5.0 * unit, -9.0 * unit, unit)));
    }
    let flat = svg(&contact(5.0, f64::INFINITY, 1.0));
    assert_eq!(svg(&contact(5.0, 1e300, 1.0)), flat);
    assert_well_formed(&svg(&contact(1e300, 5.0, 1.0)));
    assert_well_formed(&svg(&contact(5.0, -1e300, 1.0)));
    assert_well_formed(&svg(&contact(5.0, -5.000_000_1, 1.0)));
}

#[test]
fn no_name_stands_on_a_line_or_on_another_name() {
    let parts = [2.0, 2.5, 3.5, 5.0, 8.0, 12.0, 30.0, 100.0, 1e9, -5.2, -6.0, -9.0, -30.0, -1e3];
    let mut drawn = 0;
    for part in parts {
        for overlap in [0.1, 0.2, 0.35, 0.5, 0.8, 1.0, 1.2, 1.7, 2.5] {
            let mut picture = contact(5.0, part, overlap);
            // Johnson, equation 4.24.
            let half_width = (overlap / (0.2 + 1.0 / part)).sqrt();
            picture.half_width = Some(half_width);
            if picture.figure().is_err() {
                picture.half_width = None;
            }
            let Ok(figure) = picture.figure() else {
                continue;
            };
            drawn += 1;
            assert_names_are_clear(&figure.to_svg(), &format!("r_B = {part}, δ = {overlap}"));
        }
    }
    assert!(drawn > 70, "{drawn}");
}

fn assert_names_are_clear(svg: &str, what: &str) {
    let names = labels(svg);
    for (i, (name, area)) in names.iter().enumerate() {
        for (other, taken) in &names[..i] {
            assert!(apart(*area, *taken), "{what}: {name} {area:?} on {other} {taken:?}");
        }
        for [x, y] in line_points(svg) {
            let inside = (area[0]..area[2]).contains(&x) && (area[1]..area[3]).contains(&y);
            assert!(!inside, "{what}: {name} {area:?} on a line at ({x}, {y})");
        }
    }
}

/// Points on all lines, arrow heads and dots, a page unit or so apart.
fn line_points(svg: &str) -> Vec<[f64; 2]> {
    let mut points = Vec::new();
    for line in svg.lines() {
        if line.starts_with("<circle") {
            points.push([field(line, "cx"), field(line, "cy")]);
        }
        let fill = line.split(" fill=\"").nth(1).unwrap_or_default();
        let dark = ["#1e2228", "#0b4f8a"].iter().any(|ink| fill.starts_with(ink));
        if line.starts_with("<path") && (dark || line.contains(" stroke=")) {
            let path = line.split('"').nth(1).expect("a path");
            points.extend(path_points(path));
        }
    }
    points
}

fn path_points(path: &str) -> Vec<[f64; 2]> {
    const STEPS: u32 = 300;
    let mut points: Vec<[f64; 2]> = Vec::new();
    for command in path.trim_end_matches('Z').split_inclusive(['M', 'L', 'C']) {
        let numbers: Vec<f64> = command
            .trim_end_matches(['M', 'L', 'C'])
            .split(' ')
            .filter(|piece| !piece.is_empty())
            .map(|piece| piece.parse().expect("a number"))
            .collect();
        let mut handles: Vec<[f64; 2]> = points.last().copied().into_iter().collect();
        handles.extend(numbers.chunks(2).map(|pair| [pair[0], pair[1]]));
        if numbers.is_empty() {
            continue;
        }
        points.extend((0..=STEPS).map(|step| bezier(&handles, f64::from(step) / f64::from(STEPS))));
    }
    points
}

/// De Casteljau's point of a curve of any degree.
fn bezier(handles: &[[f64; 2]], t: f64) -> [f64; 2] {
    let mut points = handles.to_vec();
    while points.len() > 1 {
        let pairs = points.windows(2);
        points = pairs.map(|p| [0, 1].map(|i| (1.0 - t) * p[0][i] + t * p[1][i])).collect();
    }
    points[0]
}
