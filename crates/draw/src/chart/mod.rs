//! Curves over one variable.

mod axis;
mod drawing;

use crate::error::{DrawError, Input};
use crate::figure::Figure;
use crate::grasp::GraspPicture;
use crate::paint::Color;

pub use axis::{ChartAxis, Tick};

/// How a curve is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum LineStyle {
    /// A line.
    #[default]
    Plain,
    /// A broad, light line under all plain ones: it still shows where one runs along it.
    Broad,
}

/// A quantity along the horizontal axis of a [`Chart`].
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// What the key says; `_{…}` lowers and `^{…}` raises.
    pub label: String,
    /// Its color.
    pub color: Color,
    /// How it is drawn.
    pub line: LineStyle,
    /// The points of each piece, two or more; between pieces the curve jumps.
    pub pieces: Vec<Vec<[f64; 2]>>,
}

/// What lies between two curves of a [`Chart`], lightly filled.
#[derive(Debug, Clone, PartialEq)]
pub struct Band {
    /// What the key says.
    pub label: String,
    /// Its color; drawn translucent.
    pub color: Color,
    /// Of each piece, two or more places: horizontal value, lower and upper end.
    pub pieces: Vec<Vec<[f64; 3]>>,
}

/// Stretches of the horizontal axis on which the curves do not count: shaded, and the curves
/// there fade.
#[derive(Debug, Clone, PartialEq)]
pub struct Veil {
    /// What the key says.
    pub label: String,
    /// From where to where, as many as there are.
    pub spans: Vec<[f64; 2]>,
}

/// A named point in a [`Chart`], with a dotted line down to the axis.
#[derive(Debug, Clone, PartialEq)]
pub struct ChartMark {
    /// Where it is.
    pub point: [f64; 2],
    /// What stands beside it.
    pub label: String,
    /// What the key says. Empty for nothing.
    pub meaning: String,
    /// Its color: that of the curve it is on.
    pub color: Color,
}

/// Curves over one variable, with a key and on request a small picture of the part beside them.
///
/// Every number is the caller's. What is added is checked against the axes, so a chart that
/// exists is drawn.
///
/// ```
/// use clench_draw::{Chart, ChartAxis, Color, Curve, LineStyle};
///
/// let curve = Curve {
///     label: "Q".into(),
///     color: Color::BLUE,
///     line: LineStyle::Plain,
///     pieces: vec![vec![[0.0, 0.5], [2.0, 1.0]], vec![[2.0, 0.25], [4.0, 0.25]]],
/// };
/// let axes = [ChartAxis::new("place", [0.0, 4.0])?, ChartAxis::new("stiffness", [0.0, 1.0])?];
/// let figure = Chart::new(axes).with_curve(curve)?.figure();
/// // 580 by 340 page units: the jump is in the middle, from 340 to 85.
/// assert!(figure.to_svg().contains("M0 -170L290 -340"));
/// # Ok::<(), clench_draw::DrawError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Chart {
    pub(crate) title: Option<String>,
    pub(crate) axes: [ChartAxis; 2],
    pub(crate) bands: Vec<Band>,
    pub(crate) curves: Vec<Curve>,
    pub(crate) veils: Vec<Veil>,
    pub(crate) marks: Vec<ChartMark>,
    /// The part at its place.
    pub(crate) part: Option<Figure>,
}

impl Chart {
    /// A chart without curves, over a horizontal and a vertical axis.
    #[must_use]
    pub const fn new(axes: [ChartAxis; 2]) -> Self {
        Self {
            title: None,
            axes,
            bands: Vec::new(),
            curves: Vec::new(),
            veils: Vec::new(),
            marks: Vec::new(),
            part: None,
        }
    }

    /// The chart under a heading.
    #[must_use]
    pub fn titled(self, title: impl Into<String>) -> Self {
        Self { title: Some(title.into()), ..self }
    }

    /// The chart with another curve, over those of its kind before.
    ///
    /// # Errors
    /// [`DrawError::TooFewPoints`] for a piece of fewer than two, [`DrawError::NotFinite`] or
    /// [`DrawError::OutOfRange`] for a point; points count through all pieces.
    pub fn with_curve(mut self, curve: Curve) -> Result<Self, DrawError> {
        let input = Input::Curve(self.curves.len());
        check_pieces(&curve.pieces, input)?;
        for (index, &point) in curve.pieces.iter().flatten().enumerate() {
            self.check(point, input, index)?;
        }
        self.curves.push(curve);
        Ok(self)
    }

    /// The chart with another band, under all curves.
    ///
    /// # Errors
    /// As for a curve, and [`DrawError::NotAscending`] where a lower end is above the upper one.
    pub fn with_band(mut self, band: Band) -> Result<Self, DrawError> {
        let input = Input::Band(self.bands.len());
        check_pieces(&band.pieces, input)?;
        for (index, &[at, low, high]) in band.pieces.iter().flatten().enumerate() {
            self.check([at, low], input, index)?;
            self.check([at, high], input, index)?;
            if low > high {
                return Err(DrawError::NotAscending { input, index, low, high });
            }
        }
        self.bands.push(band);
        Ok(self)
    }

    /// The chart with a veil over some stretches.
    ///
    /// # Errors
    /// [`DrawError::NotFinite`], [`DrawError::OutOfRange`] or [`DrawError::NotAscending`] for a
    /// span.
    pub fn with_veil(mut self, veil: Veil) -> Result<Self, DrawError> {
        let input = Input::Veil(self.veils.len());
        for (index, &[low, high]) in veil.spans.iter().enumerate() {
            self.axes[0].check(low, input, index)?;
            self.axes[0].check(high, input, index)?;
            if low >= high {
                return Err(DrawError::NotAscending { input, index, low, high });
            }
        }
        self.veils.push(veil);
        Ok(self)
    }

    /// The chart with another named point.
    ///
    /// # Errors
    /// [`DrawError::NotFinite`] or [`DrawError::OutOfRange`] for the point.
    pub fn with_mark(mut self, mark: ChartMark) -> Result<Self, DrawError> {
        self.check(mark.point, Input::ChartMark, self.marks.len())?;
        self.marks.push(mark);
        Ok(self)
    }

    /// The chart with a small picture of a part beside it.
    ///
    /// # Errors
    /// Those of [`GraspPicture::figure`].
    pub fn with_part(self, picture: &GraspPicture) -> Result<Self, DrawError> {
        let part = Some(crate::chart::drawing::part(picture)?);
        Ok(Self { part, ..self })
    }

    /// Draws the chart.
    #[must_use]
    pub fn figure(&self) -> Figure {
        drawing::draw(self)
    }

    fn check(&self, point: [f64; 2], input: Input, index: usize) -> Result<(), DrawError> {
        let axes = self.axes.iter().zip(point);
        axes.into_iter().try_for_each(|(axis, value)| axis.check(value, input, index))
    }
}

fn check_pieces<T>(pieces: &[Vec<T>], input: Input) -> Result<(), DrawError> {
    match pieces.iter().map(Vec::len).find(|&found| found < 2) {
        Some(found) => Err(DrawError::TooFewPoints { input, found, needed: 2 }),
        None => Ok(()),
    }
}
