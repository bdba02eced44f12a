//! What a file has on it: curves, not yet joined.

use std::fs;
use std::path::Path;

use kurbo::Affine;

use crate::curve::Curve;
use crate::error::DrawingError;
use crate::part::DrawnPart;
use crate::source::{Aside, Source};
use crate::unit::Unit;
use crate::{dxf, svg};

/// Larger files are no drawings of a part (bytes).
const LARGEST_FILE: u64 = 1 << 25;

/// The curves of a drawing, by layer, in its own unit; y counts upwards.
///
/// Layers are asked for by name, without regard to the case of ASCII letters; if none are named,
/// all that are seen count. A layer of SVG is a group that Inkscape calls so, or else one with an
/// `id`. The origin of SVG is the left lower corner of the page.
///
/// Of DXF are taken LINE, ARC, CIRCLE, ELLIPSE, LWPOLYLINE, POLYLINE, SPLINE, and INSERT with what
/// is in its block; of SVG paths, shapes, groups, `use` and nested `svg`, with their transforms.
#[derive(Clone, Debug)]
pub struct Sheet {
    pub(crate) unit: Option<Unit>,
    pub(crate) sources: Vec<Source>,
    pub(crate) strands: Vec<Strand>,
    pub(crate) aside: Aside,
    /// The names of all layers with something on them, in the order of the file.
    pub(crate) layers: Vec<String>,
}

/// Curves that follow each other.
#[derive(Clone, Debug)]
pub(crate) struct Strand {
    /// The number of its source.
    pub(crate) source: usize,
    pub(crate) curves: Vec<Curve>,
}

type Read = fn(&[u8], &[&str]) -> Result<Sheet, DrawingError>;

impl Sheet {
    /// The curves in the file at `path` on these layers; its ending says what it is, `.dxf` or
    /// `.svg` in either case.
    ///
    /// # Errors
    ///
    /// [`DrawingError::UnknownEnding`], [`DrawingError::Unreadable`], and as [`Sheet::from_dxf`]
    /// and [`Sheet::from_svg`].
    pub fn read(path: impl AsRef<Path>, layers: &[&str]) -> Result<Self, DrawingError> {
        let path = path.as_ref();
        let is = |ending: &str| path.extension().is_some_and(|e| e.eq_ignore_ascii_case(ending));
        let read: Read = match (is("dxf"), is("svg")) {
            (true, _) => dxf::read,
            (_, true) => svg::read,
            _ => return Err(DrawingError::UnknownEnding),
        };
        check_size(fs::metadata(path).map_err(DrawingError::Unreadable)?.len())?;
        let bytes = fs::read(path).map_err(DrawingError::Unreadable)?;
        Self::checked(read, &bytes, layers)
    }

    /// The curves of a DXF file in text form on these layers.
    ///
    /// # Errors
    ///
    /// [`DrawingError::TooLarge`] above 32 MiB, [`DrawingError::Empty`], a variant that names the
    /// first line that is not valid, [`DrawingError::TooManyEntities`], or
    /// [`DrawingError::NoSuchLayer`].
    pub fn from_dxf(bytes: &[u8], layers: &[&str]) -> Result<Self, DrawingError> {
        Self::checked(dxf::read, bytes, layers)
    }

    /// The curves of an SVG file on these layers. Style sheets are not read.
    ///
    /// # Errors
    ///
    /// As [`Sheet::from_dxf`].
    ///
    /// ```
    /// use clench_drawing::{DrawingError, Sheet};
    /// let bad = b"<svg viewBox='0 0 9 9'>\n<circle r='4' cx='nan'/>\n</svg>";
    /// let Err(error) = Sheet::from_svg(bad, &[]) else { panic!("a circle nowhere") };
    /// assert!(matches!(error, DrawingError::Attribute { line: 2, .. }));
    /// ```
    pub fn from_svg(bytes: &[u8], layers: &[&str]) -> Result<Self, DrawingError> {
        Self::checked(svg::read, bytes, layers)
    }

    /// The unit of the drawing's numbers, if it names one.
    ///
    /// Of DXF it is that of `$INSUNITS`; of SVG that of `width` or `height`, in the scale of the
    /// `viewBox`, and mm if these are in `px`, `pt` or `pc`.
    #[must_use]
    pub const fn unit(&self) -> Option<Unit> {
        self.unit
    }

    /// The part, all lengths times `scale`; no edge is farther than `chord` from its curve (length,
    /// after scaling; 1e-4 of the drawing's diagonal for `None`).
    ///
    /// Ends that are nearer to each other than 1e-4 of the diagonal are joined. A curve that is
    /// there twice is left out once.
    ///
    /// # Errors
    ///
    /// [`DrawingError::Scale`] and [`DrawingError::Chord`] for what is not positive and finite;
    /// [`DrawingError::NothingDrawn`]; a variant that names the curves where they are not one
    /// outline with holes, or [`DrawingError::Outline`].
    pub fn part(&self, scale: f64, chord: Option<f64>) -> Result<DrawnPart, DrawingError> {
        DrawnPart::of(self, scale, chord)
    }

    fn checked(read: Read, bytes: &[u8], layers: &[&str]) -> Result<Self, DrawingError> {
        check_size(bytes.len() as u64)?;
        if bytes.iter().all(u8::is_ascii_whitespace) {
            return Err(DrawingError::Empty);
        }
        if is_utf16(bytes) {
            return Err(DrawingError::Utf16);
        }
        let sheet = read(bytes, layers)?;
        match layers.iter().find(|layer| !is_one_of(layer, &sheet.layers)) {
            Some(&layer) => {
                Err(DrawingError::NoSuchLayer { layer: layer.to_owned(), known: sheet.layers })
            }
            None => Ok(sheet),
        }
    }

    /// An empty one.
    pub(crate) fn new(unit: Option<Unit>) -> Self {
        let aside = Aside::default();
        Self { unit, sources: Vec::new(), strands: Vec::new(), aside, layers: Vec::new() }
    }

    /// Takes note of a layer with something on it.
    pub(crate) fn know(&mut self, layer: &str) {
        if !is_one_of(layer, &self.layers) {
            self.layers.push(layer.to_owned());
        }
    }
}

impl Strand {
    /// The same, all lengths times `scale`.
    pub(crate) fn scaled(&self, scale: f64) -> Self {
        let map = Affine::scale(scale);
        let curves = self.curves.iter().map(|curve| curve.mapped(map)).collect();
        Self { source: self.source, curves }
    }
}

/// Whether a layer is among others, without regard to case.
pub(crate) fn is_one_of(layer: &str, layers: &[impl AsRef<str>]) -> bool {
    layers.iter().any(|other| other.as_ref().eq_ignore_ascii_case(layer))
}

/// Whether text begins with the mark of UTF-16, or with two letters whose other bytes are 0.
fn is_utf16(bytes: &[u8]) -> bool {
    let is_letter = |byte: u8| byte != 0 && byte.is_ascii();
    match *bytes {
        [0xFF, 0xFE, ..] | [0xFE, 0xFF, ..] => true,
        [one, 0, other, 0, ..] | [0, one, 0, other, ..] => is_letter(one) && is_letter(other),
        _ => false,
    }
}

fn check_size(size: u64) -> Result<(), DrawingError> {
    if size > LARGEST_FILE {
        return Err(DrawingError::TooLarge { size, most: LARGEST_FILE });
    }
    Ok(())
}
