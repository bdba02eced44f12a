//! Where a ball can touch a solid from outside.

mod cover;
mod cut;
mod obstacle;
mod plane;
mod tip;

use clench_screw::Vector;

pub use tip::{BallTip, KeepOut};

use super::surface::{foot_on, nearest};
use super::{Facet, Polyhedron};
use crate::{AccessError, Plate};
use cover::Cover;
use cut::{Area, Rest, doubled_area};
use obstacle::Obstacle;
use plane::FacetPlane;

/// What is accessible but left out is nearer than this part of the solid's radius to what is not:
/// curved borders of the accessible regions are made of straight pieces.
pub const ACCESS_TOLERANCE: f64 = 1e-4;

/// Holes of a plate beside one facet at most: each is an area to be cut.
pub const MOST_HOLES: usize = 10_000;

/// Balls this many times as large as the largest coordinate have no center that could be told from
/// others; they are half spaces nearly.
const LARGEST_BALL: f64 = 1e6;

/// Nothing depends on the radius of a ball above this, in units of the largest coordinate, and its
/// square is a double.
const HALF_SPACE: f64 = 1e100;

/// Coordinates in a plane are off by this many units of rounding, of the largest coordinate of the
/// solid: three products and sums each way, a crossing of two lines, and as much for the library.
const PLANE_ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Obstacles are looked at in a window so much wider than the facet.
const WIDER: f64 = 1.0625;

/// The part of a facet that a finger can touch.
#[derive(Clone, Debug, PartialEq)]
pub struct AccessibleFacet {
    triangles: Vec<[Vector<3>; 3]>,
    area: f64,
}

impl AccessibleFacet {
    /// Triangles that cover it exactly once (length), counter-clockwise seen from outside; none if
    /// the finger cannot touch the facet at all. Those of the facet itself if it can everywhere.
    #[must_use]
    pub fn triangles(&self) -> &[[Vector<3>; 3]] {
        &self.triangles
    }

    /// The area (length squared).
    #[must_use]
    pub const fn area(&self) -> f64 {
        self.area
    }
}

/// What a finger that touches at a given point would meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Obstruction {
    /// The part itself.
    Part,
    /// The box with this number.
    KeepOut(usize),
    /// No hole of the plate is near enough.
    Plate,
}

impl std::fmt::Display for Obstruction {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Part => f.write_str("the part"),
            Self::KeepOut(number) => write!(f, "keep_out {number}"),
            Self::Plate => f.write_str("no hole of the plate in travel"),
        }
    }
}

impl Polyhedron {
    /// The part of each facet that the ball of `tip` can touch from outside, for `facets` that
    /// [`Polyhedron::facets`] made with this `flatness`.
    ///
    /// It is approximated from inside: with its center at `p - r n`, a ball that touches at a point
    /// `p` of the region does not sink into any face, nor into a box, by more than twice the
    /// flatness and the rounding of coordinates. What is accessible and not in the region is within
    /// [`ACCESS_TOLERANCE`], times the radius of the solid, of what is not accessible; where the
    /// limits are straight, as along a hollow edge between long faces, the region ends there.
    /// A ball of radius 0 counts as one that is smaller than anything else.
    ///
    /// Cost: O(n log n) for `n` faces if few of them are near each place that the ball may have;
    /// a convex solid without anything around it costs nothing.
    ///
    /// # Errors
    ///
    /// [`AccessError::TooManyHoles`].
    ///
    /// ```
    /// use clench_shape::{BallTip, Polyhedron};
    /// // A block of 3 by 2 with a step of 1 by 1 at its end, 1 long.
    /// let profile = [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [2.0, 1.0], [2.0, 2.0], [0.0, 2.0]];
    /// let vertices: Vec<[f64; 3]> =
    ///     [0.0, 1.0].iter().flat_map(|&z| profile.map(|[x, y]| [x, y, z])).collect();
    /// let mut faces: Vec<Vec<usize>> =
    ///     (0..6).map(|i| vec![i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6]).collect();
    /// faces.extend([vec![5, 4, 3, 2, 1, 0], vec![6, 7, 8, 9, 10, 11]]);
    /// let solid = Polyhedron::new(&vertices, &faces)?;
    /// let facets = solid.facets(0.0);
    /// // A ball of radius 1/4 stays so far from the wall beside the step.
    /// let found = solid.accessible(&facets, 0.0, &BallTip::new(0.25)?)?;
    /// assert!((found[2].area() - 0.75).abs() < 1e-12);
    /// assert_eq!(found[0].area(), facets[0].area());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn accessible(
        &self,
        facets: &[Facet],
        flatness: f64,
        tip: &BallTip,
    ) -> Result<Vec<AccessibleFacet>, AccessError> {
        let whole = |facet: &Facet| AccessibleFacet {
            triangles: facet.triangles().to_vec(),
            area: facet.area(),
        };
        let is_in_no_way = self.is_convex || tip.radius() <= 0.0;
        if is_in_no_way && tip.is_free() {
            return Ok(facets.iter().map(whole).collect());
        }
        let walls = if is_in_no_way {
            Vec::new()
        } else {
            self.faces.iter().map(|face| face.triangles(&self.vertices)).collect()
        };
        let scale = self.tree.scale();
        let search = Search { solid: self, tip, walls, scale, flatness: flatness.max(0.0) };
        let found = facets.iter().enumerate().map(|(number, facet)| {
            let plane = FacetPlane::new(facet, &self.vertices, scale);
            Ok(search.region(number, facet, &plane)?.unwrap_or_else(|| whole(facet)))
        });
        found.collect()
    }

    /// What keeps a ball from touching at `point` along a normal, if anything does by more than
    /// `allowed` (length). The margin of `tip` is none of it.
    ///
    /// Cost: as [`Polyhedron::place`].
    #[must_use]
    pub fn obstruction(
        &self,
        point: Vector<3>,
        inward_normal: Vector<3>,
        allowed: f64,
        tip: &BallTip,
    ) -> Option<Obstruction> {
        let radius = (tip.radius() - allowed).max(0.0);
        // What is smaller than the tolerance is looked at a little outside.
        let center = point - inward_normal * tip.radius().max(allowed);
        if radius > 0.0 && self.signed_distance(center) < radius {
            return Some(Obstruction::Part);
        }
        let meets = |keep_out: &KeepOut| {
            let distance = keep_out.distance(center);
            distance < radius || distance <= 0.0
        };
        if let Some(number) = tip.keep_out().iter().position(meets) {
            return Some(Obstruction::KeepOut(number));
        }
        let center = point - inward_normal * tip.radius();
        let is_far =
            |plate: &&Plate| plate.distance([center[0], center[1]]) > plate.travel() + allowed;
        tip.plate().filter(is_far).map(|_| Obstruction::Plate)
    }
}

/// What the regions of one solid have in common.
struct Search<'a> {
    solid: &'a Polyhedron,
    tip: &'a BallTip,
    /// The triangles of each face; none if they are in no way.
    walls: Vec<Vec<[usize; 3]>>,
    scale: f64,
    flatness: f64,
}

impl Search<'_> {
    /// The region of a facet; `None` if that is all of it.
    fn region(
        &self,
        number: usize,
        facet: &Facet,
        plane: &FacetPlane,
    ) -> Result<Option<AccessibleFacet>, AccessError> {
        let vertices = &self.solid.vertices;
        let flat = |corner: Vector<3>| {
            let [x, y, _] = plane.local(corner).to_array();
            Vector::new([x, y])
        };
        let own = facet.triangles().iter().map(|corners| corners.map(flat)).collect();
        let chain = |chain: &Vec<usize>| chain.iter().map(|&n| flat(vertices[n])).collect();
        let mut rest = Rest::new(Area::new(facet.loops().iter().map(chain)), own);
        if let Some(plate) = self.tip.plate() {
            rest.keep_within(&self.holes(number, plate, plane)?);
        }
        let is_left = self.cut(facet, plane, &mut rest) && rest.settled();
        let nothing = AccessibleFacet { triangles: Vec::new(), area: 0.0 };
        if !is_left {
            return Ok(Some(nothing));
        }
        let corners = || facet.loops().iter().flatten().map(|&corner| vertices[corner]);
        let lifted = |x: Vector<2>| {
            let point = plane.world(Vector::new([x[0], x[1], 0.0]));
            let near =
                |corner: &Vector<3>| (*corner - point).max_abs() * self.scale <= PLANE_ROUNDING;
            corners().find(near).unwrap_or(point)
        };
        let square = self.scale * self.scale;
        Ok(rest.triangles().map(|kept| AccessibleFacet {
            area: kept.iter().map(doubled_area).sum::<f64>() * 0.5 / square,
            triangles: kept.into_iter().map(|triangle| triangle.map(lifted)).collect(),
        }))
    }

    /// Takes all that is not accessible off; whether anything may be left.
    fn cut(&self, facet: &Facet, plane: &FacetPlane, rest: &mut Rest) -> bool {
        let tolerance = ACCESS_TOLERANCE * self.solid.enclosing_radius * self.scale;
        let level = plane.rise + self.flatness * self.scale + PLANE_ROUNDING;
        let radius = (self.tip.radius() * self.scale).min(HALF_SPACE) - level;
        let raised = |x: Vector<3>| plane.local(x) - Vector::new([0.0, 0.0, level]);
        let mut add = |obstacle: &Obstacle| rest.remove(obstacle, window(plane), tolerance);
        let boxes = self.tip.keep_out().iter();
        let mut boxes =
            boxes.filter_map(|keep_out| Obstacle::keep_out(keep_out, raised, radius.max(0.0)));
        if !boxes.all(|obstacle| add(&obstacle)) {
            return false;
        }
        if radius > 0.0 && !self.walls.is_empty() {
            if self.is_deep(plane, radius) {
                return false;
            }
            for face in self.near(plane, level, radius) {
                let walls = self.walls[face].iter();
                let mut walls = walls.filter_map(|corners| {
                    let corners = corners.map(|corner| raised(self.solid.vertices[corner]));
                    Obstacle::triangle(corners, radius)
                });
                if !walls.all(|obstacle| add(&obstacle)) {
                    return false;
                }
            }
        }
        let margin = (self.tip.margin() * self.scale).min(HALF_SPACE);
        if margin <= 0.0 {
            return true;
        }
        let mut borders = facet.loops().iter().flat_map(|chain| {
            let next = chain.iter().cycle().skip(1);
            chain.iter().zip(next).map(|(&from, &to)| {
                let ends = [from, to].map(|end| plane.local(self.solid.vertices[end]));
                Obstacle::border(ends, margin)
            })
        });
        borders.all(|obstacle| add(&obstacle))
    }

    /// Whether a ball in the middle of the facet sinks in by more than the facet's size, so that it
    /// does anywhere on it.
    fn is_deep(&self, plane: &FacetPlane, radius: f64) -> bool {
        let center = plane.world(Vector::ZERO) + plane.up() * self.tip.radius();
        let distance = || nearest(self.solid, center).1.distance * self.scale;
        let least = radius - plane.half.norm() - PLANE_ROUNDING * (1.0 + radius);
        least > 0.0 && radius <= LARGEST_BALL && distance() < least
    }

    /// The faces whose boxes are above a level of the plane and beside a ball that rests on that
    /// level over the facet, those first into which one in its middle sinks most.
    fn near(&self, plane: &FacetPlane, level: f64, radius: f64) -> Vec<usize> {
        let (up, at) = (plane.up(), plane.world(Vector::ZERO) * self.scale);
        let center = at + up * (level + radius);
        let reached = (radius + plane.half.norm()) * (1.0 + PLANE_ROUNDING) + PLANE_ROUNDING;
        let is_told = radius <= LARGEST_BALL;
        let faces = self.solid.tree.in_boxes(|low, high| {
            let top = Vector::from_fn(|i| if up[i] > 0.0 { high[i] } else { low[i] });
            let beside = |i: usize| (low[i] - center[i]).max(center[i] - high[i]).max(0.0);
            up.dot(top - at) > level - PLANE_ROUNDING
                && !(is_told && Vector::<3>::from_fn(beside).norm() > reached)
        });
        // From a center nearby, which is told from others for balls of any size.
        let center = (at + up * (level + radius.min(1.0))) * self.scale.recip();
        let Polyhedron { vertices, faces: all, .. } = self.solid;
        let distance = |face: usize| foot_on(vertices, &all[face], center).distance;
        let mut near: Vec<_> = faces.map(|face| (distance(face), face)).collect();
        near.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        near.into_iter().map(|(_, face)| face).collect()
    }

    /// Where the center is within the travel of a hole, in the coordinates of the plane: polygons
    /// inside of the ellipses, or strips, over the holes.
    fn holes(
        &self,
        number: usize,
        plate: &Plate,
        plane: &FacetPlane,
    ) -> Result<Vec<Cover>, AccessError> {
        let center = plane.world(Vector::ZERO) + plane.up() * self.tip.radius();
        let axes = [0, 1].map(|axis| plane.along_axis(axis));
        let range = |i: usize| {
            let spread = axes[i][0].abs() * plane.half[0] + axes[i][1].abs() * plane.half[1];
            let spread = spread / self.scale + plate.travel();
            let at = |x: f64| (x - plate.offset()[i]) / plate.pitch()[i];
            (at(center[i] - spread).ceil(), at(center[i] + spread).floor())
        };
        let ranges = [range(0), range(1)];
        let counts = ranges.map(|(low, high)| (high - low + 1.0).max(0.0));
        let found = counts[0] * counts[1];
        if found.is_nan() || found > MOST_HOLES as f64 {
            return Err(AccessError::TooManyHoles { facet: number, found, most: MOST_HOLES });
        }
        let sides = self.sides(plate.travel());
        let mut covers = Vec::new();
        let steps = |(low, high): (f64, f64)| {
            std::iter::successors(Some(low), |x| Some(x + 1.0)).take_while(move |&x| x <= high)
        };
        for i in steps(ranges[0]) {
            for j in steps(ranges[1]) {
                let hole = Vector::<2>::from_fn(|k| {
                    let steps = if k == 0 { i } else { j };
                    (plate.offset()[k] + steps * plate.pitch()[k] - center[k]) * self.scale
                });
                let mut cover = Cover::window(window(plane));
                let inside = plate.travel() * self.scale * (std::f64::consts::PI / sides).cos();
                let is_there = steps((0.0, sides - 1.0)).all(|side| {
                    let (sin, cos) = (std::f64::consts::TAU * side / sides).sin_cos();
                    let limit = inside + cos * hole[0] + sin * hole[1];
                    cover.limit(axes[0] * cos + axes[1] * sin, limit).is_some()
                });
                covers.extend(is_there.then_some(cover));
            }
        }
        Ok(covers)
    }

    /// How many sides a polygon in a circle has: its corners are on the circle, its sides nearer to
    /// the middle by the tolerance at most.
    fn sides(&self, radius: f64) -> f64 {
        let tolerance = ACCESS_TOLERANCE * self.solid.enclosing_radius;
        let half = (1.0 - tolerance / radius).max(0.0).acos();
        4.0 * (std::f64::consts::PI / half / 4.0).ceil().clamp(2.0, 256.0)
    }
}

/// A little more than half the extent of a facet, so that nothing ends along with it by chance.
fn window(plane: &FacetPlane) -> Vector<2> {
    plane.half * WIDER + Vector::from_fn(|_| PLANE_ROUNDING)
}
