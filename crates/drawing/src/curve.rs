//! The curves of a drawing, and the chains of corners that stand for them.

use std::f64::consts::{FRAC_PI_2, TAU};

use kurbo::{Affine, Point, Vec2};

/// Halvings of a Bézier curve; each makes the deviation smaller by four near the end.
const DEEPEST_HALVING: u32 = 40;

/// Samples of a curve for how large a drawing is; those of a full circle have its extremes.
const SAMPLES: u32 = 16;

/// A piece of a curve, or a straight one.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Curve {
    Line([Point; 2]),
    Arc(Arc),
    Bezier(Bezier),
}

/// The points `center + u cos t + v sin t`, for `t` from `from` on by `sweep`.
///
/// Of a circle `u` and `v` are perpendicular and of the same length; every arc of an ellipse is
/// one, and so is its picture under an affine map.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Arc {
    pub(super) center: Point,
    pub(super) u: Vec2,
    pub(super) v: Vec2,
    pub(super) from: f64,
    pub(super) sweep: f64,
    /// Where it starts and ends, if that is known more exactly than by the angles.
    pub(super) ends: Option<[Point; 2]>,
}

/// A rational Bézier curve by its control points `(w x, w y, w)`, with positive weights `w`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Bezier(pub(super) Vec<[f64; 3]>);

/// There would be more corners than are allowed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct TooManyCorners;

/// The corners of curves that follow each other, at most `room` of them.
#[derive(Debug)]
pub(super) struct Corners {
    pub(super) points: Vec<Point>,
    room: usize,
}

impl Corners {
    pub(super) const fn new(room: usize) -> Self {
        Self { points: Vec::new(), room }
    }

    fn push(&mut self, point: Point) -> Result<(), TooManyCorners> {
        if self.points.len() >= self.room {
            return Err(TooManyCorners);
        }
        if self.points.last() != Some(&point) {
            self.points.push(point);
        }
        Ok(())
    }
}

impl Curve {
    /// A whole circle, from the angle 0 on.
    pub(super) fn circle(center: Point, radius: f64) -> Self {
        Self::ellipse(center, Vec2::new(radius, 0.0), Vec2::new(0.0, radius))
    }

    /// A whole ellipse with these half axes, which are perpendicular.
    pub(super) fn ellipse(center: Point, u: Vec2, v: Vec2) -> Self {
        let ends = Some([center + u; 2]);
        Self::Arc(Arc { center, u, v, from: 0.0, sweep: TAU, ends })
    }

    /// The arc from `ends[0]` to `ends[1]` whose bulge is the tangent of a quarter of its angle,
    /// counter-clockwise if positive: a straight line for 0.
    pub(super) fn bulged(ends: [Point; 2], bulge: f64) -> Self {
        if bulge.abs() <= 0.0 {
            return Self::Line(ends);
        }
        let [start, end] = ends;
        let half = (end - start) * 0.5;
        let center = start + half + half.turn_90() * ((1.0 - bulge * bulge) / (2.0 * bulge));
        let u = start - center;
        // From the start on, so that its own coordinates need no angle.
        Self::Arc(Arc {
            center,
            u,
            v: u.turn_90(),
            from: 0.0,
            sweep: 4.0 * bulge.atan(),
            ends: Some(ends),
        })
    }

    /// Where it starts and ends.
    pub(super) fn ends(&self) -> [Point; 2] {
        match self {
            Self::Line(ends) => *ends,
            Self::Arc(arc) => arc.ends.unwrap_or_else(|| [arc.at(0.0), arc.at(1.0)]),
            Self::Bezier(Bezier(points)) => {
                let at = |i: Option<&[f64; 3]>| i.map_or(Point::ZERO, place);
                [at(points.first()), at(points.last())]
            }
        }
    }

    /// Its picture under an affine map.
    pub(super) fn mapped(&self, map: Affine) -> Self {
        let linear = |v: Vec2| {
            let [a, b, c, d, _, _] = map.as_coeffs();
            Vec2::new(a * v.x + c * v.y, b * v.x + d * v.y)
        };
        match self {
            Self::Line(ends) => Self::Line(ends.map(|end| map * end)),
            Self::Arc(arc) => Self::Arc(Arc {
                center: map * arc.center,
                u: linear(arc.u),
                v: linear(arc.v),
                from: arc.from,
                sweep: arc.sweep,
                ends: arc.ends.map(|ends| ends.map(|end| map * end)),
            }),
            Self::Bezier(Bezier(points)) => {
                let moved = points.iter().map(|&[x, y, w]| {
                    let linear = linear(Vec2::new(x, y));
                    let shift = map.translation() * w;
                    [linear.x + shift.x, linear.y + shift.y, w]
                });
                Self::Bezier(Bezier(moved.collect()))
            }
        }
    }

    /// Points all along it, for how large it is.
    pub(super) fn samples(&self) -> Vec<Point> {
        let steps = (0..=SAMPLES).map(|i| f64::from(i) / f64::from(SAMPLES));
        match self {
            Self::Line(ends) => ends.to_vec(),
            Self::Arc(arc) => steps.map(|t| arc.at(t)).collect(),
            Self::Bezier(bezier) => steps.map(|t| bezier.at(t)).collect(),
        }
    }

    /// Adds the corners of a chain that deviates from the curve by at most `chord`. All are on the
    /// curve, the first and the last at its ends.
    pub(super) fn flatten(&self, chord: f64, out: &mut Corners) -> Result<(), TooManyCorners> {
        let [start, end] = self.ends();
        out.push(start)?;
        match self {
            Self::Line(_) => {}
            Self::Arc(arc) => {
                let count = arc.chords(chord, out.room)?;
                for i in 1..count {
                    out.push(arc.at(i as f64 / count as f64))?;
                }
            }
            Self::Bezier(bezier) => bezier.halved(chord, DEEPEST_HALVING, out)?,
        }
        out.push(end)
    }
}

impl Arc {
    /// The point after the part `t` of the sweep.
    fn at(&self, t: f64) -> Point {
        let (sin, cos) = (self.from + self.sweep * t).sin_cos();
        self.center + self.u * cos + self.v * sin
    }

    /// How many chords of equal angle keep the deviation.
    ///
    /// It is greatest halfway, where it is `1 - cos(angle / 2)` of the distance from the center: of
    /// a circle exactly, of an ellipse at most that of its larger half axis. Whole ones get a
    /// multiple of four, so that their extremes are corners.
    fn chords(&self, chord: f64, most: usize) -> Result<usize, TooManyCorners> {
        let radius = larger_half_axis(self.u, self.v);
        // From 1 - cos(a / 2) = 2 sin(a / 4)^2, which does not cancel.
        let step = 4.0 * (chord / (2.0 * radius)).sqrt().min(1.0).asin();
        let whole = self.sweep.abs() >= TAU;
        let step = if whole { step.min(FRAC_PI_2) } else { step };
        let count = (self.sweep.abs() / step).ceil().max(1.0);
        // The comparison is false for what is not a number too.
        if count < most as f64 {
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "a whole number from 1 to `most`"
            )]
            let count = count as usize;
            return Ok(if whole { count.next_multiple_of(4) } else { count });
        }
        Err(TooManyCorners)
    }
}

/// The larger half axis of the ellipse with these conjugate half diameters.
fn larger_half_axis(u: Vec2, v: Vec2) -> f64 {
    // The larger singular value of the matrix with columns u and v.
    let sum = u.hypot2() + v.hypot2();
    let difference = ((u.hypot2() - v.hypot2()).powi(2) + 4.0 * u.dot(v).powi(2)).sqrt();
    f64::midpoint(sum, difference).sqrt()
}

impl Bezier {
    /// The curve with these control points, all of the same weight.
    pub(super) fn plain(points: &[Point]) -> Self {
        Self(points.iter().map(|p| [p.x, p.y, 1.0]).collect())
    }

    fn at(&self, t: f64) -> Point {
        let mut points = self.0.clone();
        for last in (1..points.len()).rev() {
            for i in 0..last {
                points[i] = between(&points[i], &points[i + 1], t);
            }
        }
        points.first().map_or(Point::ZERO, place)
    }

    /// Adds the corners after the start and before the end.
    fn halved(&self, chord: f64, depth: u32, out: &mut Corners) -> Result<(), TooManyCorners> {
        if self.deviation() <= chord {
            return Ok(());
        }
        let Some(depth) = depth.checked_sub(1) else { return Err(TooManyCorners) };
        let [first, second] = self.halves();
        first.halved(chord, depth, out)?;
        out.push(second.0.first().map_or(Point::ZERO, place))?;
        second.halved(chord, depth, out)
    }

    /// A bound of how far the curve is from its chord.
    ///
    /// The distance from the chord, a convex function, is at most the mean of that of the control
    /// points by their shares; the two at the ends have none, and the others together have at
    /// most `1 - 2^(1 - n)` if all weights are equal.
    fn deviation(&self) -> f64 {
        let [first, inner @ .., last] = &self.0[..] else { return 0.0 };
        let ends = [place(first), place(last)];
        let far = inner.iter().map(|p| distance(place(p), ends)).fold(0.0, f64::max);
        #[expect(
            clippy::float_cmp,
            reason = "equal weights are exactly those that were never \
                                              given"
        )]
        let plain = self.0.iter().all(|point| point[2] == first[2]);
        let degree = i32::try_from(inner.len() + 1).unwrap_or(i32::MAX);
        far * if plain { 1.0 - 2.0_f64.powi(1 - degree) } else { 1.0 }
    }

    /// By the algorithm of de Casteljau, at the middle.
    fn halves(&self) -> [Self; 2] {
        let mut points = self.0.clone();
        let (mut first, mut second) = (Vec::new(), Vec::new());
        for last in (0..points.len()).rev() {
            first.push(points[0]);
            second.push(points[last]);
            for i in 0..last {
                points[i] = between(&points[i], &points[i + 1], 0.5);
            }
        }
        second.reverse();
        [Self(first), Self(second)]
    }
}

/// The point of the plane that a control point stands for.
fn place(&[x, y, w]: &[f64; 3]) -> Point {
    Point::new(x / w, y / w)
}

fn between(one: &[f64; 3], other: &[f64; 3], t: f64) -> [f64; 3] {
    std::array::from_fn(|i| one[i] + (other[i] - one[i]) * t)
}

/// The distance of a point from a segment.
fn distance(point: Point, [start, end]: [Point; 2]) -> f64 {
    let (side, to) = (end - start, point - start);
    let length2 = side.hypot2();
    if length2 <= 0.0 {
        return to.hypot();
    }
    let along = (to.dot(side) / length2).clamp(0.0, 1.0);
    (to - side * along).hypot()
}
