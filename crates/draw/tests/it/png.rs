//! Rasters: their size, their letters, and how far the width estimate may be trusted.

use std::sync::Arc;

use clench_draw::{Anchor, DrawError, EnergySpace, Figure, RASTER_LIMIT, Text};
use resvg::tiny_skia::Pixmap;
use resvg::usvg::{Node, Options, Tree, fontdb};

use crate::paper::{ellipsoids, grasp};

fn with_text(content: &str) -> Result<Figure, DrawError> {
    let mut figure = Figure::new([[0.0, 0.0], [1.0, 1.0]], [100.0, 100.0])?;
    figure.caption([0.0, 0.0], &Text::new(content, 20.0).anchored(Anchor::Start))?;
    Ok(figure)
}

fn decode(png: &[u8]) -> Pixmap {
    Pixmap::decode_png(png).expect("a PNG file")
}

#[test]
#[expect(clippy::float_cmp, reason = "whole numbers of pixels")]
fn a_raster_has_the_pages_size_times_the_scale() -> Result<(), DrawError> {
    for figure in [grasp(1.0).figure()?, ellipsoids(EnergySpace::Twist).figure()?] {
        let svg = figure.to_svg();
        let side = |name: &str| -> f64 {
            let rest = svg.split(&format!(" {name}=\"")).nth(1).expect("a side");
            rest.split('"').next().and_then(|value| value.parse().ok()).expect("a number")
        };
        for scale in [0.5, 2.0] {
            let pixels = decode(&figure.to_png(scale)?);
            let expected = [side("width") * scale, side("height") * scale].map(f64::round);
            let found = [pixels.width(), pixels.height()].map(f64::from);
            assert_eq!(found, expected);
        }
    }
    Ok(())
}

#[test]
fn rasters_are_repeatable() -> Result<(), DrawError> {
    let figure = grasp(1.0).figure()?;
    assert_eq!(figure.to_png(1.0)?, figure.to_png(1.0)?);
    Ok(())
}

#[test]
fn letters_leave_ink() -> Result<(), DrawError> {
    // A renderer without the font would leave the page white.
    let ink = |content: &str| -> Result<usize, DrawError> {
        let pixels = decode(&with_text(content)?.to_png(1.0)?);
        Ok(pixels.pixels().iter().filter(|pixel| pixel.red() < 200).count())
    };
    assert!(ink("\u{a0}")? == 0);
    for letter in ["A", "σ", "μ", "ω", "τ", "ρ", "√", "±", "\u{2212}", "·", "²", "≤"] {
        assert!(ink(letter)? > 4, "{letter}");
    }
    Ok(())
}

#[test]
fn texts_are_no_wider_than_estimated() -> Result<(), DrawError> {
    let mut fonts = fontdb::Database::new();
    fonts.load_font_data(include_bytes!("../../fonts/DejaVuSans.ttf").to_vec());
    let options = Options { fontdb: Arc::new(fonts), ..Options::default() };
    let alphabet: String = ('!'..='~').filter(|letter| !"<>&".contains(*letter)).collect();
    for content in [
        "MMMMwwww",
        "0123456789",
        "ill-fitted jigs",
        "ω = −√(2/μ) = −0.152",
        "σ_{min} = 1.684",
        "frame at the centre of compliance",
        alphabet.as_str(),
    ] {
        let tree = Tree::from_str(&with_text(content)?.to_svg(), &options).expect("an SVG");
        let mut width = 0.0;
        let mut nodes: Vec<&Node> = tree.root().children().iter().collect();
        while let Some(node) = nodes.pop() {
            match node {
                Node::Group(group) => nodes.extend(group.children()),
                Node::Text(text) => width = f64::from(text.bounding_box().width()),
                _ => {}
            }
        }
        let [estimate, _] = Text::new(content, 20.0).page_size();
        assert!(width > 0.7 * estimate && width <= estimate, "{content}: {width} {estimate}");
    }
    Ok(())
}

#[test]
fn rasters_without_a_pixel_or_beyond_the_limit_are_refused() -> Result<(), DrawError> {
    let figure = with_text("a")?;
    for scale in [0.0, -1.0, 1e-6, 1e6, f64::INFINITY] {
        let expected = DrawError::RasterSize { scale, limit: RASTER_LIMIT };
        assert_eq!(figure.to_png(scale).err(), Some(expected));
    }
    assert!(matches!(figure.to_png(f64::NAN), Err(DrawError::RasterSize { .. })));
    Ok(())
}
