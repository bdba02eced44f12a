//! A planar part with the fingers that hold it.

mod drawing;
mod finger;
mod labels;
mod overlay;

use crate::error::{DrawError, Input};
use crate::figure::Figure;
use crate::page_box::PageBox;
use crate::paint::Color;
use crate::world_map::{UNSEEN, WorldMap, finite};

pub use finger::Finger;
pub use overlay::{Direction, Displaced, Load};

/// A named point.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mark {
    /// Where it is.
    pub point: [f64; 2],
    /// What it is called; `_{…}` lowers and `^{…}` raises. Empty for none.
    pub label: String,
}

/// A lightly filled polygon, such as a strip of concurrency points.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    /// Its corners in order.
    pub corners: Vec<[f64; 2]>,
    /// Its color; drawn translucent.
    pub color: Color,
}

/// A line along which something moves, with an arrow at its end.
#[derive(Debug, Clone, PartialEq)]
pub struct Way {
    /// Its points in order, two or more.
    pub points: Vec<[f64; 2]>,
    /// Its color.
    pub color: Color,
}

/// A planar grasp as plain numbers, drawn by [`GraspPicture::figure`].
///
/// Every field may be left empty but the outline. Nothing is computed from the fields: the
/// center, the farthest corner and all numbers of the caption come from the caller. Lengths
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
    /// The corners of each of its holes in order, three or more.
    pub holes: Vec<Vec<[f64; 2]>>,
    /// Names of the corners, from the outline's first on, then those of the holes; may be fewer.
    pub corner_labels: Vec<String>,
    /// The fingers.
    pub fingers: Vec<Finger>,
    /// The center of compliance, or of concurrency.
    pub center: Option<Mark>,
    /// The corner farthest from the center: a dashed line leads there, with an arc.
    pub farthest_corner: Option<[f64; 2]>,
    /// Shaded polygons over the part and under everything else.
    pub regions: Vec<Region>,
    /// Lines with an arrow, under fingers and marks.
    pub ways: Vec<Way>,
    /// Double arrows through the center, such as the principal directions.
    pub directions: Vec<Direction>,
    /// The part as a load has moved it.
    pub displaced: Option<Displaced>,
    /// Forces from outside.
    pub loads: Vec<Load>,
    /// Further dots with names.
    pub notes: Vec<Mark>,
    /// Lines of text beside the part, or below one that is wide.
    pub caption: Vec<String>,
}

impl GraspPicture {
    /// Draws the picture.
    ///
    /// # Errors
    /// [`DrawError::NotFinite`], [`DrawError::TooFewPoints`], [`DrawError::NegativeRadius`],
    /// [`DrawError::NormalNotUnit`] or [`DrawError::ReachWithoutCenter`] for what the fields
    /// hold, [`DrawError::OffPage`] for marks absurdly far from the part.
    pub fn figure(&self) -> Result<Figure, DrawError> {
        drawing::draw(self, drawing::PLOT)
    }

    /// Draws the picture into a part of a page.
    pub(crate) fn figure_in(&self, plot: PageBox) -> Result<Figure, DrawError> {
        drawing::draw(self, plot)
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
        bounds
    }

    /// The outline, then the holes.
    pub(crate) fn loops(&self) -> impl Iterator<Item = &[[f64; 2]]> {
        [self.outline.as_slice()].into_iter().chain(self.holes.iter().map(Vec::as_slice))
    }

    pub(crate) fn check(&self) -> Result<(), DrawError> {
        points(&self.outline, 3, Input::Outline)?;
        for (index, hole) in self.holes.iter().enumerate() {
            points(hole, 3, Input::Hole(index))?;
        }
        for (index, region) in self.regions.iter().enumerate() {
            points(&region.corners, 3, Input::Region(index))?;
        }
        for (index, way) in self.ways.iter().enumerate() {
            points(&way.points, 2, Input::Way(index))?;
        }
        for (index, finger) in self.fingers.iter().enumerate() {
            finger.check(index)?;
        }
        for (index, note) in self.notes.iter().enumerate() {
            point(note.point, Input::Note, index)?;
        }
        for (index, Direction { along, .. }) in self.directions.iter().enumerate() {
            unit(*along, Input::Direction, index)?;
        }
        for (index, Load { point: at, along, .. }) in self.loads.iter().enumerate() {
            point(*at, Input::LoadPoint, index)?;
            unit(*along, Input::LoadDirection, index)?;
        }
        if let Some(center) = &self.center {
            point(center.point, Input::Center, 0)?;
        }
        if let Some(corner) = self.farthest_corner {
            point(corner, Input::FarthestCorner, 0)?;
            if self.center.is_none() {
                return Err(DrawError::ReachWithoutCenter);
            }
        }
        Ok(())
    }

    /// Refuses what lies absurdly far from the box that the page was fitted to.
    pub(crate) fn check_on_page(&self, map: &WorldMap) -> Result<(), DrawError> {
        for (number, hole) in self.holes.iter().enumerate() {
            for (index, &corner) in hole.iter().enumerate() {
                map.check(corner, Input::Hole(number), index)?;
            }
        }
        for (number, region) in self.regions.iter().enumerate() {
            for (index, &corner) in region.corners.iter().enumerate() {
                map.check(corner, Input::Region(number), index)?;
            }
        }
        for (number, way) in self.ways.iter().enumerate() {
            for (index, &at) in way.points.iter().enumerate() {
                map.check(at, Input::Way(number), index)?;
            }
        }
        for (index, note) in self.notes.iter().enumerate() {
            map.check(note.point, Input::Note, index)?;
        }
        for (index, load) in self.loads.iter().enumerate() {
            map.check(load.point, Input::LoadPoint, index)?;
        }
        if let Some(displaced) = &self.displaced {
            displaced.check(&self.loops().collect::<Vec<_>>().concat(), map)?;
        }
        self.farthest_corner.map_or(Ok(()), |at| map.check(at, Input::FarthestCorner, 0))
    }
}

fn points(all: &[[f64; 2]], needed: usize, input: Input) -> Result<(), DrawError> {
    if all.len() < needed {
        return Err(DrawError::TooFewPoints { input, found: all.len(), needed });
    }
    all.iter().enumerate().try_for_each(|(index, &at)| point(at, input, index))
}

fn point(at: [f64; 2], input: Input, index: usize) -> Result<(), DrawError> {
    at.into_iter().try_for_each(|value| finite(value, input, index).map(|_| ()))
}

/// Refuses a direction that is not of length 1.
fn unit(along: [f64; 2], input: Input, index: usize) -> Result<(), DrawError> {
    point(along, input, index)?;
    if (along[0].hypot(along[1]) - 1.0).abs() > UNSEEN {
        return Err(DrawError::NoDirection { input, index });
    }
    Ok(())
}
