//! A planar part with the fingers that hold it.

use crate::error::{DrawError, Place};
use crate::figure::Figure;
use crate::finger::Finger;
use crate::paint::Color;
use crate::world_map::finite;

/// A named point.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mark {
    /// Where it is.
    pub point: [f64; 2],
    /// What it is called; see [`Text`](crate::Text) for scripts. Empty for none.
    pub label: String,
}

/// A circle in world units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Circle {
    /// Its center.
    pub center: [f64; 2],
    /// Its radius.
    pub radius: f64,
}

/// A lightly filled polygon, such as a strip of concurrency points.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    /// Its corners in order.
    pub corners: Vec<[f64; 2]>,
    /// Its color; drawn translucent.
    pub color: Color,
}

/// A planar grasp as plain numbers, drawn by [`GraspPicture::figure`].
///
/// Every field may be left empty but the outline. Nothing is computed from the fields: the
/// center, the farthest vertex and all numbers of the caption come from the caller. Lengths
/// are in one world unit, of any size.
///
/// ```
/// use clench_draw::{Finger, GraspPicture};
///
/// let picture = GraspPicture {
///     outline: vec![[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]],
///     fingers: vec![Finger {
///         point: [2.0, 0.0],
///         inward_normal: [0.0, 1.0],
///         label: "1".into(),
///         ..Finger::default()
///     }],
///     caption: vec!["Q = 1.684".into()],
///     ..GraspPicture::default()
/// };
/// assert!(picture.figure()?.to_svg().contains(">Q = 1.684</text>"));
/// # Ok::<(), clench_draw::DrawError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct GraspPicture {
    /// The heading.
    pub title: Option<String>,
    /// The part's corners in order, three or more.
    pub outline: Vec<[f64; 2]>,
    /// The part's holes.
    pub holes: Vec<Vec<[f64; 2]>>,
    /// Names of the outline's corners, from the first on; may be fewer.
    pub corner_labels: Vec<String>,
    /// The fingers.
    pub fingers: Vec<Finger>,
    /// The center of compliance, or of concurrency.
    pub center: Option<Mark>,
    /// The vertex farthest from the center: a dashed line leads there, with an arc.
    pub farthest_vertex: Option<[f64; 2]>,
    /// The smallest enclosing circle: a thin circle with a cross.
    pub enclosing_circle: Option<Circle>,
    /// Shaded polygons over the part and under everything else.
    pub regions: Vec<Region>,
    /// Dashed lines.
    pub auxiliary_lines: Vec<[[f64; 2]; 2]>,
    /// Further dots with names.
    pub notes: Vec<Mark>,
    /// Lines of text beside the part, or below one that is wide.
    pub caption: Vec<String>,
}

impl GraspPicture {
    /// Draws the picture.
    ///
    /// # Errors
    /// [`DrawError::NotFinite`], [`DrawError::TooFewPoints`], [`DrawError::NotASize`],
    /// [`DrawError::NormalNotUnit`] or [`DrawError::ReachWithoutCenter`] for what the fields
    /// hold, [`DrawError::OffPage`] for marks absurdly far from the part.
    pub fn figure(&self) -> Result<Figure, DrawError> {
        self.check()?;
        crate::grasp_drawing::draw(self)
    }

    /// The corners of the box around the outline and everything that touches it.
    pub(crate) fn bounds(&self) -> [[f64; 2]; 2] {
        let mut bounds = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        let mut include = |point: [f64; 2]| {
            for i in 0..2 {
                bounds[0][i] = bounds[0][i].min(point[i]);
                bounds[1][i] = bounds[1][i].max(point[i]);
            }
        };
        self.outline.iter().copied().for_each(&mut include);
        self.fingers.iter().map(|finger| finger.point).for_each(&mut include);
        self.center.iter().map(|mark| mark.point).for_each(&mut include);
        if let Some(circle) = &self.enclosing_circle {
            include(circle.center.map(|value| value - circle.radius));
            include(circle.center.map(|value| value + circle.radius));
        }
        bounds
    }

    fn check(&self) -> Result<(), DrawError> {
        ring(&self.outline, Place::Outline)?;
        for (index, hole) in self.holes.iter().enumerate() {
            ring(hole, Place::Hole(index))?;
        }
        for (index, region) in self.regions.iter().enumerate() {
            ring(&region.corners, Place::Region(index))?;
        }
        for (index, finger) in self.fingers.iter().enumerate() {
            finger.check(index)?;
        }
        for (index, line) in self.auxiliary_lines.iter().enumerate() {
            points(line, Place::AuxiliaryLine(index))?;
        }
        for (index, note) in self.notes.iter().enumerate() {
            point(note.point, Place::Note, index)?;
        }
        if let Some(center) = &self.center {
            point(center.point, Place::Center, 0)?;
        }
        if let Some(vertex) = self.farthest_vertex {
            point(vertex, Place::FarthestVertex, 0)?;
            if self.center.is_none() {
                return Err(DrawError::ReachWithoutCenter);
            }
        }
        if let Some(circle) = &self.enclosing_circle {
            point(circle.center, Place::EnclosingCircle, 0)?;
            let value = finite(circle.radius, Place::EnclosingCircle, 1)?;
            if value <= 0.0 {
                let place = Place::EnclosingCircle;
                return Err(DrawError::NotASize { place, index: 1, value });
            }
        }
        Ok(())
    }
}

fn ring(corners: &[[f64; 2]], place: Place) -> Result<(), DrawError> {
    if corners.len() < 3 {
        return Err(DrawError::TooFewPoints { place, found: corners.len(), needed: 3 });
    }
    points(corners, place)
}

fn points(points: &[[f64; 2]], place: Place) -> Result<(), DrawError> {
    points.iter().enumerate().try_for_each(|(index, &at)| point(at, place, index))
}

fn point(at: [f64; 2], place: Place, index: usize) -> Result<(), DrawError> {
    at.into_iter().try_for_each(|value| finite(value, place, index).map(|_| ()))
}
