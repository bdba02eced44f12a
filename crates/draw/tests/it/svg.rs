//! The text of pictures: well-formed, finite, repeatable, with nothing cut off.

use clench_draw::{DrawError, EnergySpace, Figure, Finger, GraspPicture};

use crate::chart::chart;
use crate::contact::contacts;
use crate::paper::{ellipsoids, grasp};
use crate::solids::{held_bracket, held_cube, held_sphere, held_torus};

/// Panics unless the tags nest, attributes are quoted and every number is finite.
pub(crate) fn assert_well_formed(svg: &str) {
    let mut open = Vec::new();
    let mut rest = svg;
    while let Some(start) = rest.find('<') {
        let text = &rest[..start];
        assert!(!text.contains('>'), "stray > in {text:?}");
        let end = start + rest[start..].find('>').expect("a tag ends");
        let tag = &rest[start + 1..end];
        assert!(tag.matches('"').count().is_multiple_of(2), "quotes in {tag:?}");
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop(), Some(name), "closing tag");
        } else if !tag.ends_with('/') {
            open.push(tag.split(' ').next().expect("split gives one piece"));
        }
        for value in tag.split('"').skip(1).step_by(2) {
            assert!(!value.contains("NaN") && !value.contains("inf"), "number in {tag:?}");
        }
        rest = &rest[end + 1..];
    }
    assert!(open.is_empty(), "unclosed {open:?}");
}

/// Every point of every path, and the page.
fn path_points(svg: &str) -> (Vec<[f64; 2]>, [f64; 4]) {
    let numbers = |text: &str| -> Vec<f64> {
        text.split(|c: char| !(c.is_ascii_digit() || c == '.' || c == '-'))
            .filter(|piece| !piece.is_empty())
            .map(|piece| piece.parse().expect("a number"))
            .collect()
    };
    let after = |mark: &'static str| {
        svg.split(mark).skip(1).map(|rest| rest.split('"').next().expect("split gives one"))
    };
    let page = numbers(after("viewBox=\"").next().expect("a page"));
    let points =
        after(" d=\"").flat_map(|d| numbers(d).chunks(2).map(|p| [p[0], p[1]]).collect::<Vec<_>>());
    (points.collect(), [page[0], page[1], page[0] + page[2], page[1] + page[3]])
}

fn all_pictures() -> Result<Vec<Figure>, DrawError> {
    let mut figures = vec![grasp(1.0).figure()?];
    for space in [EnergySpace::Twist, EnergySpace::Wrench] {
        let mut picture = ellipsoids(space);
        picture.title = Some("Title <&>".into());
        figures.push(picture.figure()?);
    }
    for picture in contacts() {
        figures.push(picture.figure()?);
    }
    figures.push(chart([1.0, 1.0])?.figure());
    for picture in [held_cube(), held_bracket(), held_sphere(2), held_torus()] {
        figures.push(picture.figure()?);
    }
    Ok(figures)
}

#[test]
fn every_picture_is_well_formed_and_the_same_each_time() -> Result<(), DrawError> {
    for (once, again) in all_pictures()?.into_iter().zip(all_pictures()?) {
        assert_well_formed(&once.to_svg());
        assert_eq!(once.to_svg(), again.to_svg());
    }
    Ok(())
}

#[test]
fn nothing_drawn_lies_beyond_the_page() -> Result<(), DrawError> {
    for figure in all_pictures()? {
        let (points, page) = path_points(&figure.to_svg());
        assert!(points.len() > 50);
        for [x, y] in points {
            let inside = (page[0]..=page[2]).contains(&x) && (page[1]..=page[3]).contains(&y);
            assert!(inside, "({x}, {y}) off {page:?}");
        }
    }
    Ok(())
}

#[test]
fn a_unit_of_length_changes_no_byte() -> Result<(), DrawError> {
    // Powers of two scale without rounding; 1e-9 and 1e9 are the extremes worth drawing.
    let reference = grasp(1.0).figure()?.to_svg();
    for unit in [2.0_f64.powi(-30), 2.0_f64.powi(30)] {
        assert_eq!(grasp(unit).figure()?.to_svg(), reference, "unit {unit}");
        for mut picture in contacts() {
            let reference = picture.figure()?.to_svg();
            picture.finger_radius *= unit;
            picture.part_radius *= unit;
            picture.overlap *= unit;
            picture.half_width = picture.half_width.map(|half_width| half_width * unit);
            assert_eq!(picture.figure()?.to_svg(), reference, "unit {unit}");
        }
    }
    Ok(())
}

#[test]
fn the_caption_stands_beside_a_square_part_and_below_a_wide_one() -> Result<(), DrawError> {
    let picture = |height: f64| GraspPicture {
        outline: vec![[0.0, 0.0], [10.0, 0.0], [10.0, height], [0.0, height]],
        caption: vec!["here".into()],
        ..GraspPicture::default()
    };
    let at = |svg: &str| -> [f64; 2] {
        let line = svg.lines().find(|line| line.contains(">here<")).expect("the caption");
        [field(line, "x"), field(line, "y")]
    };
    // Ten wide into 440 by 380: the square is 380 wide from 30 on, the bar 440 by 44.
    let [x, _] = at(&picture(10.0).figure()?.to_svg());
    assert!(x > 410.0, "{x}");
    let [x, y] = at(&picture(1.0).figure()?.to_svg());
    assert!(x < 1.0 && y > 190.0 + 22.0, "({x}, {y})");
    Ok(())
}

/// An attribute of an element that has the line to itself.
pub(crate) fn field(line: &str, name: &str) -> f64 {
    let rest = line.split(&format!(" {name}=\"")).nth(1).expect("an attribute");
    rest.split('"').next().and_then(|value| value.parse().ok()).expect("a number")
}

/// The names in a picture with the boxes of their letters, taking 0.6 of the size for each.
pub(crate) fn labels(svg: &str) -> Vec<(String, [f64; 4])> {
    let lines = svg.lines().filter(|line| line.contains("text-anchor=\"middle\""));
    let label = |line: &str| {
        // Text and tags take turns, from an empty text on.
        let content: String = line.split(['>', '<']).step_by(2).collect();
        let content = content.replace("&lt;", "<");
        let size = field(line, "font-size");
        let half =
            0.3 * size * f64::from(u32::try_from(content.chars().count()).expect("a short name"));
        let (x, base) = (field(line, "x"), field(line, "y"));
        (content, [x - half, base - 0.73 * size, x + half, base])
    };
    lines.map(label).collect()
}

pub(crate) fn apart(p: [f64; 4], q: [f64; 4]) -> bool {
    p[2] <= q[0] || q[2] <= p[0] || p[3] <= q[1] || q[3] <= p[1]
}

#[test]
fn labels_of_fingers_at_corners_do_not_cover_one_another() -> Result<(), DrawError> {
    let boxes = labels(&grasp(1.0).figure()?.to_svg());
    assert_eq!(boxes.len(), 12, "{boxes:?}");
    for (i, (a, p)) in boxes.iter().enumerate() {
        for (b, q) in &boxes[..i] {
            assert!(apart(*p, *q), "{a} {p:?} and {b} {q:?}");
        }
    }
    Ok(())
}

#[test]
fn the_number_of_a_corner_is_not_printed_on_the_disc_that_holds_it() -> Result<(), DrawError> {
    // Ten wide into 440 by 380: 38 a unit, the square's left side at 30.
    let square = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]];
    for (radius, label) in [(0.5, ""), (1.0, "F0"), (2.0, "F0")] {
        let picture = GraspPicture {
            outline: square.to_vec(),
            corner_labels: ["0", "1", "2", "3"].map(String::from).to_vec(),
            fingers: vec![Finger {
                point: square[0],
                inward_normal: [0.0, 1.0],
                radius,
                label: label.into(),
                ..Finger::default()
            }],
            ..GraspPicture::default()
        };
        let r = 38.0 * radius;
        let disc = [30.0 - r, 380.0, 30.0 + r, 380.0 + 2.0 * r];
        let boxes = labels(&picture.figure()?.to_svg());
        let corner = boxes.iter().find(|(name, _)| name == "0").expect("the corner's number");
        assert!(apart(corner.1, disc), "{corner:?} on {disc:?}");
    }
    Ok(())
}
