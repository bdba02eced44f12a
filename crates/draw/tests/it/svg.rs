//! The text of pictures: well-formed, finite, repeatable, with nothing cut off.

use clench_draw::{
    Anchor, Color, DrawError, EllipseArc, EnergySpace, Figure, GraspPicture, Layout, Paint, Stroke,
    Text,
};

use crate::paper::{ellipsoids, grasp};

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
        for layout in [Layout::Overlaid, Layout::SideBySide] {
            let mut picture = ellipsoids(space);
            picture.layout = layout;
            picture.title = Some("Title <&>".into());
            figures.push(picture.figure()?);
        }
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
        assert!(points.len() > 100);
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
    }
    Ok(())
}

#[test]
fn markup_in_texts_is_escaped_and_scripts_are_not_markup() -> Result<(), DrawError> {
    let mut figure = Figure::new([[0.0, 0.0], [1.0, 1.0]], [100.0, 100.0])?;
    let text = Text::new("<a> & \"b\" \u{1} x_{<i>} y^{2} z_{open", 10.0);
    figure.caption([0.0, 0.0], &text.with_halo().anchored(Anchor::End))?;
    let svg = figure.to_svg();
    assert_well_formed(&svg);
    assert!(svg.contains("&lt;a&gt; &amp; \"b\" \u{fffd} x<tspan"));
    assert!(svg.contains(">&lt;i&gt;</tspan>"));
    assert!(svg.contains(" z_{open"));
    Ok(())
}

#[test]
fn a_script_moves_the_baseline_and_the_next_run_moves_it_back() -> Result<(), DrawError> {
    let mut figure = Figure::new([[0.0, 0.0], [1.0, 1.0]], [100.0, 100.0])?;
    figure.caption([0.0, 0.0], &Text::new("σ_{min}^{2} = 1", 10.0))?;
    // Down by 0.24 of the size, from there up to 0.36 above, and back.
    let expected = "σ<tspan dy=\"2.4\" font-size=\"7.2\">min</tspan>\
                    <tspan dy=\"-6\" font-size=\"7.2\">2</tspan><tspan dy=\"3.6\"> = 1</tspan>";
    assert!(figure.to_svg().contains(expected), "{}", figure.to_svg());
    Ok(())
}

#[test]
#[expect(clippy::float_cmp, reason = "every number here is exact in binary")]
fn both_axes_have_one_scale_and_y_points_up() -> Result<(), DrawError> {
    // Eight by two into 400 by 400: 50 a unit, so 100 high and 150 free above and below.
    let figure = Figure::new([[-4.0, 1.0], [4.0, 3.0]], [400.0, 400.0])?;
    assert_eq!(figure.to_page([-4.0, 1.0])?, [0.0, 250.0]);
    assert_eq!(figure.to_page([4.0, 3.0])?, [400.0, 150.0]);
    assert_eq!(figure.to_world([0.0, 250.0]), [-4.0, 1.0]);
    assert_eq!(format!("{}", figure.world_length(25.0)), "0.5");
    Ok(())
}

#[test]
fn an_arrow_ends_at_its_tip_and_a_short_one_keeps_a_shaft() -> Result<(), DrawError> {
    let mut figure = Figure::new([[0.0, 0.0], [10.0, 10.0]], [100.0, 100.0])?;
    figure.arrow([0.0, 5.0], [10.0, 5.0], Stroke::solid(Color::INK, 1.0))?;
    // The head of 9 by 6.4 has its notch at 0.8 of its length, where the shaft ends.
    let svg = figure.to_svg();
    assert!(svg.contains("M0 50L92.8 50"));
    assert!(svg.contains("M100 50L91 53.2L92.8 50L91 46.8Z"));
    let mut short = Figure::new([[0.0, 0.0], [10.0, 10.0]], [100.0, 100.0])?;
    short.arrow([0.0, 5.0], [0.5, 5.0], Stroke::solid(Color::INK, 1.0))?;
    assert!(short.to_svg().contains("M5 50L2 "), "{}", short.to_svg());
    Ok(())
}

#[test]
fn a_full_turn_is_closed_and_passes_the_quarter_points() -> Result<(), DrawError> {
    let mut figure = Figure::new([[-1.0, -1.0], [1.0, 1.0]], [200.0, 200.0])?;
    figure.arc(&EllipseArc::circle([0.0, 0.0], 1.0), &Paint::fill(Color::PART))?;
    let svg = figure.to_svg();
    for quarter in ["M200 100", " 100 0C", " 0 100C", " 100 200C", " 200 100Z"] {
        assert!(svg.contains(quarter), "{quarter} in {svg}");
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
        let number = |name: &str| {
            let rest = line.split(&format!(" {name}=\"")).nth(1).expect("an attribute");
            rest.split('"').next().and_then(|value| value.parse().ok()).expect("a number")
        };
        [number("x"), number("y")]
    };
    // Ten wide into 440 by 380: the square is 380 wide from 30 on, the bar 440 by 44.
    let [x, _] = at(&picture(10.0).figure()?.to_svg());
    assert!(x > 410.0, "{x}");
    let [x, y] = at(&picture(1.0).figure()?.to_svg());
    assert!(x < 1.0 && y > 190.0 + 22.0, "({x}, {y})");
    Ok(())
}

#[test]
fn labels_of_fingers_at_corners_do_not_cover_one_another() -> Result<(), DrawError> {
    let svg = grasp(1.0).figure()?.to_svg();
    let mut boxes: Vec<(String, [f64; 4])> = Vec::new();
    for line in svg.lines().filter(|line| line.contains("text-anchor=\"middle\"")) {
        let field = |name: &str| -> f64 {
            let rest = line.split(&format!(" {name}=\"")).nth(1).expect("an attribute");
            rest.split('"').next().and_then(|value| value.parse().ok()).expect("a number")
        };
        let content = line.split(['>', '<']).nth(2).expect("a content").to_owned();
        let [w, _] = Text::new(content.as_str(), field("font-size")).page_size();
        let (x, base, height) = (field("x"), field("y"), 0.73 * field("font-size"));
        boxes.push((content, [x - w / 2.0, base - height, x + w / 2.0, base]));
    }
    assert_eq!(boxes.len(), 10, "{boxes:?}");
    for (i, (a, p)) in boxes.iter().enumerate() {
        for (b, q) in &boxes[..i] {
            let apart = p[2] <= q[0] || q[2] <= p[0] || p[3] <= q[1] || q[3] <= p[1];
            assert!(apart, "{a} {p:?} and {b} {q:?}");
        }
    }
    Ok(())
}
