//! The drawing of energy ellipsoids, layer by layer.

use crate::energy::EnergyEllipsoids;
use crate::energy::scene::Scene;
use crate::energy::surface::{EnergySpace, EnergySurface};
use crate::error::{DrawError, Input};
use crate::figure::Figure;
use crate::number::readable;
use crate::paint::{Color, Stroke};
use crate::text::{Anchor, SMALL_SIZE, TITLE_SIZE, Text};
use crate::view::View;
use crate::world_map::finite;

/// Page units per unit of the scene, in which the larger ellipsoid is two wide.
const SCENE_UNIT: f64 = 75.0;

/// The view's elevation and the azimuths it may have, in degrees: none looks along an axis.
const ELEVATION: f64 = 20.0;
const AZIMUTHS: [f64; 4] = [38.0, 52.0, -52.0, -38.0];

/// The floor, and the height of a wrench scene, against the ellipsoids' half-extents.
const FLOOR: f64 = 1.16;
const WRENCH_HEIGHT: f64 = 1.06;

/// The least ratio of the floor's sides: on a narrower one the values would collide.
const NARROWEST: f64 = 0.75;

/// Colors of the upright and the slanted ellipsoid.
const COLORS: [Color; 2] = [Color::BLUE, Color::ORANGE];

pub(crate) fn draw(picture: &EnergyEllipsoids) -> Result<Figure, DrawError> {
    let surfaces = picture.surfaces()?;
    let factors = factors(&surfaces)?;
    let solids = surfaces.map(|surface| surface.scaled(factors));
    let extents = solids.map(|solid| solid.half_extents());
    let widest = |i: usize| extents[0][i].max(extents[1][i]);
    let view = View::from_angles(azimuth(&solids[1]), ELEVATION);
    let mut figure = Figure::new([[-1.0, -1.0], [1.0, 1.0]], [2.0 * SCENE_UNIT; 2])?;
    let mut scene = Scene {
        space: picture.space,
        view,
        factors,
        floor: [0, 1].map(|i| FLOOR * widest(i).max(NARROWEST * widest(1 - i))),
        height: match picture.space {
            EnergySpace::Twist => widest(2),
            EnergySpace::Wrench => WRENCH_HEIGHT * widest(2),
        },
        solids: &solids,
        colors: COLORS,
        figure: &mut figure,
    };
    scene.draw();
    key(picture, &surfaces, &mut figure);
    Ok(figure)
}

/// One scale for both horizontal coordinates, so that sections keep their shape, and one for
/// the height, so that the scene is about as high as wide.
fn factors(surfaces: &[EnergySurface; 2]) -> Result<[f64; 3], DrawError> {
    let extents = surfaces.map(|surface| surface.half_extents());
    let widest = |i: usize| extents[0][i].max(extents[1][i]);
    let factor = |extent: f64, index: usize| {
        finite(extent, Input::Extent, index)?;
        finite(1.0 / extent, Input::Extent, index)
    };
    let horizontal = factor(widest(0).max(widest(1)), 0)?;
    Ok([horizontal, horizontal, factor(widest(2), 1)?])
}

/// The azimuth from which the slanted ellipsoid leans most across the line of sight.
fn azimuth(slanted: &EnergySurface) -> f64 {
    let [a, b, pole] = slanted.columns();
    // The lean of the vertical axis for twists; for wrenches, the direction of steepest rise.
    let lean = [0, 1].map(|i| pole[i] * pole[2] + a[i] * a[2] + b[i] * b[2]);
    let across = |degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        (lean[1] * cos - lean[0] * sin).abs()
    };
    let mut best = AZIMUTHS[0];
    for azimuth in AZIMUTHS {
        if across(azimuth) > across(best) {
            best = azimuth;
        }
    }
    best
}

/// What the colors mean and what both ellipsoids share, below the scene.
fn key(picture: &EnergyEllipsoids, surfaces: &[EnergySurface; 2], figure: &mut Figure) {
    let ink = figure.ink();
    let left = ink.min[0];
    let mut y = ink.max[1] + 2.0 * SMALL_SIZE;
    for (label, color) in [&picture.upright_label, &picture.slanted_label].into_iter().zip(COLORS) {
        let line = [[left, y], [left + 22.0, y]].map(|page| figure.to_world(page));
        figure.polyline(&line, Stroke::solid(color, 3.0));
        let text = Text::new(label.as_str(), SMALL_SIZE).anchored(Anchor::Start);
        figure.caption([left + 30.0, y], &text);
        y += 1.6 * SMALL_SIZE;
    }
    let [short, long] = surfaces[0].semi_axes().map(readable);
    let shared = match picture.space {
        EnergySpace::Twist => {
            format!("both: section ω = 0 (thick) with semi-axes √(2/σ_{{i}}) = {short} and {long}")
        }
        EnergySpace::Wrench => {
            format!(
                "both: touch one cylinder (along the thick curves) with semi-axes \
                 √(2σ_{{i}}) = {short} and {long}"
            )
        }
    };
    let text = Text::new(shared, SMALL_SIZE).anchored(Anchor::Start);
    figure.caption([left, y], &text);
    if let Some(title) = &picture.title {
        let text = Text::new(title.as_str(), TITLE_SIZE).anchored(Anchor::Start);
        figure.caption([left, ink.min[1] - 1.4 * TITLE_SIZE], &text);
    }
}
