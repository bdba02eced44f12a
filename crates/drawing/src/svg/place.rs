//! Lengths, transforms and viewports of SVG files.

use kurbo::{Affine, Vec2};
use roxmltree::Node;
use svgtypes::{Align, AspectRatio, Length, LengthUnit, Transform, ViewBox};

use super::{LARGEST, attribute};
use crate::error::DrawingError;
use crate::unit::Unit;

/// A pixel is a part of an inch (micrometers).
const PIXEL: f64 = Unit::INCH.micrometers() / 96.0;

/// Width and height of a viewport, in the unit of what is in it; none if nothing says them.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Size {
    width: Option<f64>,
    height: Option<f64>,
}

/// How the file's own coordinates come to those of the drawing, whose origin is the left lower
/// corner of the page and whose y counts upwards; what percentages are of; and the unit.
pub(super) fn page(
    root: Node<'_, '_>,
    line: usize,
) -> Result<(Affine, Size, Option<Unit>), DrawingError> {
    let [width, height] = [page_side(root, "width", line)?, page_side(root, "height", line)?];
    let unit_of = |side: Option<Length>| side.and_then(|length| unit(length.unit));
    let unit = unit_of(width).or_else(|| unit_of(height));
    // Lengths in the unit of the page, mere numbers as pixels; without one, numbers as they are.
    let in_unit = |length: Length| -> Result<f64, DrawingError> {
        match unit {
            Some(unit) => {
                let size = micrometers(length.unit).unwrap_or(PIXEL);
                Ok(length.number * (size / unit.micrometers()))
            }
            None => Ok(length.number),
        }
    };
    let [width, height] = [width.map(in_unit).transpose()?, height.map(in_unit).transpose()?];
    let view = view_box(root, line)?;
    let pixel = unit.map_or(1.0, |unit| PIXEL / unit.micrometers());
    let own = Size { width, height };
    let map = match view {
        None => Affine::scale(pixel),
        Some(_) => viewport(root, own, line)?,
    };
    let high = height.or_else(|| {
        let (view, wide) = (view?, width);
        Some(wide.map_or(view.h, |wide| wide * view.h / view.w))
    });
    let flip = Affine::translate((0.0, high.unwrap_or(0.0))) * Affine::FLIP_Y;
    let size = match view {
        Some(view) => Size { width: Some(view.w), height: Some(view.h) },
        None => Size { width: width.map(|w| w / pixel), height: height.map(|h| h / pixel) },
    };
    Ok((flip * map, size, unit))
}

/// The width or the height of the page, if it is said; a percentage is of what is not known.
fn page_side(
    root: Node<'_, '_>,
    name: &'static str,
    line: usize,
) -> Result<Option<Length>, DrawingError> {
    let Some(text) = root.attribute(name) else { return Ok(None) };
    let length: Option<Length> = text.trim().parse().ok();
    let fits = |length: &Length| {
        let known = !matches!(length.unit, LengthUnit::Em | LengthUnit::Ex);
        length.number > 0.0 && length.number <= LARGEST && known
    };
    let found = || DrawingError::SvgSize {
        line,
        name,
        found: text.to_owned(),
        expected: "a number above 0, as it is or in mm, cm, in, pt, pc, px or %",
    };
    let length = length.filter(fits).ok_or_else(found)?;
    Ok(Some(length).filter(|length| length.unit != LengthUnit::Percent))
}

/// The map from the view box of an element, if it has one, to its viewport of this size.
pub(super) fn viewport(
    node: Node<'_, '_>,
    size: Size,
    line: usize,
) -> Result<Affine, DrawingError> {
    let Some(view) = view_box(node, line)? else { return Ok(Affine::IDENTITY) };
    let [sx, sy] = match (size.width, size.height) {
        (Some(width), Some(height)) => [width / view.w, height / view.h],
        (Some(width), None) => [width / view.w; 2],
        (None, Some(height)) => [height / view.h; 2],
        (None, None) => [1.0; 2],
    };
    let origin = Affine::translate((-view.x, -view.y));
    let ratio = match node.attribute("preserveAspectRatio") {
        None => AspectRatio { defer: false, align: Align::XMidYMid, slice: false },
        Some(text) => text.parse().map_err(|_| DrawingError::Attribute {
            line,
            expected: "preserveAspectRatio",
            found: text.to_owned(),
        })?,
    };
    if ratio.align == Align::None {
        return Ok(Affine::scale_non_uniform(sx, sy) * origin);
    }
    let scale = if ratio.slice { sx.max(sy) } else { sx.min(sy) };
    let [across, down] = match ratio.align {
        Align::None | Align::XMinYMin => [0.0, 0.0],
        Align::XMidYMin => [0.5, 0.0],
        Align::XMaxYMin => [1.0, 0.0],
        Align::XMinYMid => [0.0, 0.5],
        Align::XMidYMid => [0.5, 0.5],
        Align::XMaxYMid => [1.0, 0.5],
        Align::XMinYMax => [0.0, 1.0],
        Align::XMidYMax => [0.5, 1.0],
        Align::XMaxYMax => [1.0, 1.0],
    };
    let left = Vec2::new((sx - scale) * view.w * across, (sy - scale) * view.h * down);
    Ok(Affine::translate(left) * Affine::scale(scale) * origin)
}

/// The transform of an element.
pub(super) fn transform(node: Node<'_, '_>, line: usize) -> Result<Affine, DrawingError> {
    let Some(text) = node.attribute("transform") else { return Ok(Affine::IDENTITY) };
    let wrong = || DrawingError::Attribute { line, expected: "transform", found: text.to_owned() };
    let Transform { a, b, c, d, e, f } = text.parse().map_err(|_| wrong())?;
    let coefficients = [a, b, c, d, e, f];
    if coefficients.iter().all(|x| x.abs() <= LARGEST) {
        return Ok(Affine::new(coefficients));
    }
    Err(wrong())
}

/// A length in user units, which are pixels; `whole` is what percentages are of.
pub(super) fn length(text: &str, whole: Option<f64>, line: usize) -> Result<f64, DrawingError> {
    let length = parsed(text, line)?;
    match (micrometers(length.unit), length.unit, whole) {
        (_, LengthUnit::None | LengthUnit::Px, _) => Ok(length.number),
        (Some(size), _, _) => Ok(length.number * (size / PIXEL)),
        (None, LengthUnit::Percent, Some(whole)) => Ok(whole * length.number / 100.0),
        _ => Err(DrawingError::Attribute { line, expected: "a length", found: text.to_owned() }),
    }
}

impl Size {
    /// The size that an element has in a viewport of this size: all of it if it does not say.
    pub(super) fn inner(self, node: Node<'_, '_>, line: usize) -> Result<Self, DrawingError> {
        let width = size(node, "width", self.width, line)?.or(self.width);
        let height = size(node, "height", self.height, line)?.or(self.height);
        Ok(Self { width, height })
    }

    /// The size that percentages are of in an element of this size.
    pub(super) fn of_view(self, node: Node<'_, '_>, line: usize) -> Result<Self, DrawingError> {
        let view = view_box(node, line)?;
        Ok(view.map_or(self, |view| Self { width: Some(view.w), height: Some(view.h) }))
    }

    /// Where an element is by its x and y.
    pub(super) fn at(node: Node<'_, '_>, around: Self, line: usize) -> Result<Vec2, DrawingError> {
        let x = attribute(node, "x", around.width, line)?.unwrap_or(0.0);
        let y = attribute(node, "y", around.height, line)?.unwrap_or(0.0);
        Ok(Vec2::new(x, y))
    }

    pub(super) const fn width(self) -> Option<f64> {
        self.width
    }

    pub(super) const fn height(self) -> Option<f64> {
        self.height
    }

    /// What percentages of neither direction are of.
    pub(super) fn mean(self) -> Option<f64> {
        let (width, height) = (self.width?, self.height?);
        Some(width.hypot(height) / std::f64::consts::SQRT_2)
    }
}

/// The size in an attribute of an element, not negative, if it has it and it is not `auto`.
pub(super) fn size(
    node: Node<'_, '_>,
    name: &'static str,
    whole: Option<f64>,
    line: usize,
) -> Result<Option<f64>, DrawingError> {
    let Some(text) = node.attribute(name).filter(|text| text.trim() != "auto") else {
        return Ok(None);
    };
    let found = || DrawingError::SvgSize {
        line,
        name,
        found: text.to_owned(),
        expected: "one that is not negative",
    };
    Some(length(text, whole, line)?).filter(|size| *size >= 0.0).ok_or_else(found).map(Some)
}

fn parsed(text: &str, line: usize) -> Result<Length, DrawingError> {
    let length: Option<Length> = text.trim().parse().ok();
    length.filter(|length| length.number.abs() <= LARGEST).ok_or_else(|| DrawingError::Attribute {
        line,
        expected: "a length",
        found: text.to_owned(),
    })
}

fn view_box(node: Node<'_, '_>, line: usize) -> Result<Option<ViewBox>, DrawingError> {
    let Some(text) = node.attribute("viewBox") else { return Ok(None) };
    let view: Option<ViewBox> = text.parse().ok();
    let fits = |view: &ViewBox| {
        let far = view.x.abs().max(view.y.abs()).max(view.w).max(view.h);
        view.w > 0.0 && view.h > 0.0 && far <= LARGEST
    };
    let wrong = || DrawingError::Attribute { line, expected: "viewBox", found: text.to_owned() };
    view.filter(fits).map(Some).ok_or_else(wrong)
}

/// The unit of a page whose size is in this unit; none if it is a mere number.
const fn unit(unit: LengthUnit) -> Option<Unit> {
    match unit {
        LengthUnit::In => Some(Unit::INCH),
        LengthUnit::Cm => Some(Unit::CENTIMETER),
        LengthUnit::Mm | LengthUnit::Px | LengthUnit::Pt | LengthUnit::Pc => Some(Unit::MILLIMETER),
        LengthUnit::None | LengthUnit::Em | LengthUnit::Ex | LengthUnit::Percent => None,
    }
}

const fn micrometers(unit: LengthUnit) -> Option<f64> {
    match unit {
        LengthUnit::Px => Some(PIXEL),
        LengthUnit::In => Some(Unit::INCH.micrometers()),
        LengthUnit::Cm => Some(Unit::CENTIMETER.micrometers()),
        LengthUnit::Mm => Some(Unit::MILLIMETER.micrometers()),
        LengthUnit::Pt => Some(Unit::INCH.micrometers() / 72.0),
        LengthUnit::Pc => Some(Unit::INCH.micrometers() / 6.0),
        LengthUnit::None | LengthUnit::Em | LengthUnit::Ex | LengthUnit::Percent => None,
    }
}
