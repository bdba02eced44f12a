//! Colors, strokes and fills, and the palette all pictures share.

use std::fmt::Write;

use crate::number::number;

/// An sRGB color with an opacity from 0 (invisible) to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Color {
    rgb: [u8; 3],
    opacity: f64,
}

impl Color {
    /// Text and outlines: nearly black.
    pub const INK: Self = Self::new([0x1e, 0x22, 0x28]);
    /// Secondary lines and text.
    pub const GREY: Self = Self::new([0x6b, 0x72, 0x7c]);
    /// Lines behind something.
    pub(crate) const PALE: Self = Self::new([0x90, 0x95, 0x9d]);
    /// The inside of a part.
    pub const PART: Self = Self::new([0xe9, 0xed, 0xf2]);
    /// Paper.
    pub const WHITE: Self = Self::new([0xff, 0xff, 0xff]);
    /// First accent; dark in grey print.
    pub const BLUE: Self = Self::new([0x0b, 0x4f, 0x8a]);
    /// Second accent; a middle tone in grey print, and told from blue by every kind of eye.
    pub const ORANGE: Self = Self::new([0xd5, 0x65, 0x0a]);
    /// Third accent.
    pub const GREEN: Self = Self::new([0x00, 0x80, 0x60]);

    /// Fourth accent; as dark as blue in grey print.
    pub(crate) const PURPLE: Self = Self::new([0x8a, 0x1f, 0x75]);

    /// An opaque color from its red, green and blue bytes.
    #[must_use]
    pub const fn new(rgb: [u8; 3]) -> Self {
        Self { rgb, opacity: 1.0 }
    }

    /// The same color with this opacity; values outside 0 to 1, and NaN, go to the nearer end.
    #[expect(clippy::manual_clamp, reason = "clamp would let NaN through")]
    pub(crate) fn with_opacity(self, opacity: f64) -> Self {
        Self { opacity: opacity.max(0.0).min(1.0), ..self }
    }

    /// The color moved towards white: 0 leaves it, 1 is white. The opacity stays.
    #[expect(clippy::manual_clamp, reason = "clamp would let NaN through")]
    pub(crate) fn lightened(self, share: f64) -> Self {
        let share = share.max(0.0).min(1.0);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a mean of two bytes is a byte"
        )]
        let mix = |byte: u8| (f64::from(byte) + (255.0 - f64::from(byte)) * share).round() as u8;
        Self { rgb: self.rgb.map(mix), ..self }
    }

    /// Writes ` name="#rrggbb"` and, unless opaque, ` name-opacity="o"`.
    pub(crate) fn write(self, svg: &mut String, name: &str) {
        let [r, g, b] = self.rgb;
        let _ = write!(svg, " {name}=\"#{r:02x}{g:02x}{b:02x}\"");
        if self.opacity < 1.0 {
            let name = if name == "stop-color" { "stop" } else { name };
            let _ = write!(svg, " {name}-opacity=\"{}\"", number(self.opacity));
        }
    }
}

/// Whether a line is drawn through.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum Dash {
    /// A solid line.
    #[default]
    Solid,
    /// Dashes some five units long.
    Dashed,
    /// Short dashes for what is hidden behind something else.
    Dotted,
    /// A chain line, of long dashes and dots in turn: for axes.
    Chain,
}

/// How a line is drawn; widths are in page units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stroke {
    /// Its color.
    pub(crate) color: Color,
    /// Its width, in page units.
    pub(crate) width: f64,
    /// Whether it is drawn through.
    pub(crate) dash: Dash,
}

impl Stroke {
    /// A solid line.
    pub(crate) const fn solid(color: Color, width: f64) -> Self {
        Self { color, width, dash: Dash::Solid }
    }

    /// A dashed line.
    pub(crate) const fn dashed(color: Color, width: f64) -> Self {
        Self { color, width, dash: Dash::Dashed }
    }

    /// A dotted line.
    pub(crate) const fn dotted(color: Color, width: f64) -> Self {
        Self { color, width, dash: Dash::Dotted }
    }

    /// A chain line.
    pub(crate) const fn chain(color: Color, width: f64) -> Self {
        Self { color, width, dash: Dash::Chain }
    }

    fn write(self, svg: &mut String) {
        self.color.write(svg, "stroke");
        let _ = write!(svg, " stroke-width=\"{}\"", number(self.width));
        match self.dash {
            Dash::Solid => {}
            Dash::Dashed => svg.push_str(" stroke-dasharray=\"5 3.5\""),
            Dash::Dotted => svg.push_str(" stroke-dasharray=\"2 2.5\""),
            Dash::Chain => svg.push_str(" stroke-dasharray=\"10 3 2 3\""),
        }
    }
}

/// Fill and outline of a shape; either may be missing.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Paint {
    /// The color inside.
    pub(crate) fill: Option<Color>,
    /// The line around.
    pub(crate) stroke: Option<Stroke>,
}

impl Paint {
    /// A shape without an outline.
    pub(crate) const fn fill(color: Color) -> Self {
        Self { fill: Some(color), stroke: None }
    }

    /// An outline only.
    pub(crate) const fn stroke(stroke: Stroke) -> Self {
        Self { fill: None, stroke: Some(stroke) }
    }

    /// A filled shape with an outline.
    pub(crate) const fn both(color: Color, stroke: Stroke) -> Self {
        Self { fill: Some(color), stroke: Some(stroke) }
    }

    pub(crate) fn write(&self, svg: &mut String) {
        match self.fill {
            Some(color) => color.write(svg, "fill"),
            None => svg.push_str(" fill=\"none\""),
        }
        if let Some(stroke) = self.stroke {
            stroke.write(svg);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn opacity_and_lightening_stay_in_range() {
        let blue = Color::BLUE;
        let clear = blue.with_opacity(0.0);
        assert_eq!([-1.0, f64::NAN].map(|share| blue.with_opacity(share)), [clear; 2]);
        assert_eq!(blue.with_opacity(2.0), blue);
        assert_eq!([-1.0, f64::NAN].map(|share| blue.lightened(share)), [blue; 2]);
        assert_eq!(blue.lightened(2.0), Color::WHITE);
    }
}
