//! Rasters: their size, their letters and their limits.

use clench_draw::{DrawError, EnergySpace, Figure, GraspPicture, Mark, RASTER_LIMIT};
use resvg::tiny_skia::Pixmap;

use crate::paper::{ellipsoids, grasp};

/// A triangle with a heading.
fn titled(title: &str) -> Result<Figure, DrawError> {
    GraspPicture {
        title: Some(title.into()),
        outline: vec![[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]],
        ..GraspPicture::default()
    }
    .figure()
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
        let pixels = decode(&titled(content)?.to_png(1.0)?);
        Ok(pixels.pixels().iter().filter(|pixel| pixel.red() < 200).count())
    };
    let without = ink("\u{a0}")?;
    for letter in ["A", "σ", "μ", "ω", "τ", "ρ", "√", "±", "\u{2212}", "·", "²", "≤"] {
        assert!(ink(letter)? > without + 4, "{letter}");
    }
    Ok(())
}

#[test]
fn rasters_without_a_pixel_or_beyond_the_limit_are_refused() -> Result<(), DrawError> {
    let figure = titled("a")?;
    for scale in [0.0, -1.0, 1e-6, 1e6, f64::INFINITY] {
        let expected = DrawError::RasterSize { scale, limit: RASTER_LIMIT };
        assert_eq!(figure.to_png(scale).err(), Some(expected));
    }
    assert!(matches!(figure.to_png(f64::NAN), Err(DrawError::RasterSize { .. })));
    Ok(())
}

#[test]
fn a_picture_of_a_million_shapes_has_no_raster() -> Result<(), DrawError> {
    let mark = Mark { point: [1.0, 1.0], label: String::new() };
    let picture = GraspPicture {
        outline: vec![[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]],
        notes: vec![mark; 1_000_000],
        ..GraspPicture::default()
    };
    assert_eq!(picture.figure()?.to_png(1.0).err(), Some(DrawError::TooManyElements));
    Ok(())
}
