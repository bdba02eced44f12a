//! Splines of a drawing as Bézier curves.

use kurbo::{Point, Vec2};

use crate::curve::{Bezier, Curve};
use crate::spline_error::{HIGHEST_DEGREE, SplineError};

/// A spline by its control points `(w x, w y, w)` and its knots.
#[derive(Clone, Debug)]
pub(super) struct Spline {
    pub(super) degree: usize,
    pub(super) knots: Vec<f64>,
    pub(super) points: Vec<[f64; 3]>,
}

impl Spline {
    /// The curve, as one Bézier curve for each span between knots.
    pub(super) fn curves(&self) -> Result<Vec<Curve>, SplineError> {
        self.check()?;
        let (degree, count) = (self.degree, self.points.len());
        let mut curves: Vec<Curve> = Vec::new();
        let mut last: Option<[f64; 3]> = None;
        for span in (degree..count).filter(|&k| self.knots[k] < self.knots[k + 1]) {
            let mut points: Vec<[f64; 3]> =
                (0..=degree).map(|ends| self.blossom(span, ends)).collect();
            // The same point by two spans, up to rounding.
            if let Some(last) = last {
                points[0] = last;
            }
            last = points.last().copied();
            curves.push(Curve::Bezier(Bezier(points)));
        }
        Ok(curves)
    }

    fn check(&self) -> Result<(), SplineError> {
        let (degree, points, knots) = (self.degree, self.points.len(), self.knots.len());
        if !(1..=HIGHEST_DEGREE).contains(&degree) {
            return Err(SplineError::Degree { degree });
        }
        if points <= degree {
            return Err(SplineError::TooFewPoints { points, needed: degree + 1 });
        }
        let needed = points + degree + 1;
        if knots != needed {
            return Err(SplineError::Counts { points, knots, needed });
        }
        if let Some(knot) = (1..knots).find(|&i| self.knots[i] < self.knots[i - 1]) {
            return Err(SplineError::Knots { knot });
        }
        if self.knots[degree] >= self.knots[points] {
            return Err(SplineError::Knots { knot: degree });
        }
        let inside = |knot: f64| knot > self.knots[degree] && knot < self.knots[points];
        let torn = (degree..knots)
            .find(|&i| inside(self.knots[i]) && self.knots[i] <= self.knots[i - degree]);
        match torn {
            Some(knot) => Err(SplineError::Torn { knot }),
            None => Ok(()),
        }
    }

    /// The control point of the Bézier curve of a span: the polar form of the spline there, with
    /// `ends` of its arguments at the end of the span and the others at its start.
    fn blossom(&self, span: usize, ends: usize) -> [f64; 3] {
        let (degree, knots) = (self.degree, &self.knots);
        let mut points: Vec<[f64; 3]> = self.points[span - degree..=span].to_vec();
        for step in 1..=degree {
            let argument = knots[if step <= ends { span + 1 } else { span }];
            for j in (step..=degree).rev() {
                let i = span - degree + j;
                let (low, high) = (knots[i], knots[i + degree + 1 - step]);
                let share = (argument - low) / (high - low);
                let (one, other) = (points[j - 1], points[j]);
                points[j] = std::array::from_fn(|k| one[k] + (other[k] - one[k]) * share);
            }
        }
        points[degree]
    }
}

/// The cubic spline through `points`, whose parameter grows by the distances between them, as
/// drawing programs have it: with these directions at its ends, and straight there without; closed
/// ones go on smoothly.
pub(super) fn through(
    points: &[Point],
    [start, end]: [Option<Vec2>; 2],
    closed: bool,
) -> Result<Vec<Curve>, SplineError> {
    let mut knots: Vec<Point> = points.to_vec();
    knots.dedup();
    if closed && knots.len() > 1 && knots.first() != knots.last() {
        knots.push(knots[0]);
    }
    let spans = knots.len().saturating_sub(1);
    if spans == 0 || (closed && spans < 2) {
        return Err(SplineError::FitPoints { points: points.len() });
    }
    let steps: Vec<f64> = knots.windows(2).map(|pair| (pair[1] - pair[0]).hypot()).collect();
    let rises: Vec<Vec2> =
        knots.windows(2).zip(&steps).map(|(pair, h)| (pair[1] - pair[0]) / *h).collect();
    let slopes = if closed {
        closed_slopes(&steps, &rises)
    } else {
        let unit = |v: Option<Vec2>| v.filter(|v| v.hypot() > 0.0).map(Vec2::normalize);
        open_slopes(&steps, &rises, [unit(start), unit(end)])
    };
    let curve = |i: usize| {
        let (h, [p, q]) = (steps[i] / 3.0, [knots[i], knots[i + 1]]);
        Curve::Bezier(Bezier::plain(&[p, p + slopes[i] * h, q - slopes[i + 1] * h, q]))
    };
    Ok((0..spans).map(curve).collect())
}

/// A row `before x[i-1] + here x[i] + after x[i+1] = right` of a linear system.
#[derive(Clone, Copy, Debug)]
struct Row {
    before: f64,
    here: f64,
    after: f64,
    right: Vec2,
}

/// The row that makes the second derivative continuous between two spans.
fn smooth([h0, h1]: [f64; 2], [rise0, rise1]: [Vec2; 2]) -> Row {
    let right = (rise0 * h1 + rise1 * h0) * 3.0;
    Row { before: h1, here: 2.0 * (h0 + h1), after: h0, right }
}

/// The first derivatives at the points of an open spline.
fn open_slopes(steps: &[f64], rises: &[Vec2], ends: [Option<Vec2>; 2]) -> Vec<Vec2> {
    let last = steps.len() - 1;
    let end = |given: Option<Vec2>, rise: Vec2| match given {
        Some(right) => (1.0, 0.0, right),
        // The second derivative is zero.
        None => (2.0, 1.0, rise * 3.0),
    };
    let (here, after, right) = end(ends[0], rises[0]);
    let mut rows = vec![Row { before: 0.0, here, after, right }];
    rows.extend((0..last).map(|i| smooth([steps[i], steps[i + 1]], [rises[i], rises[i + 1]])));
    let (here, before, right) = end(ends[1], rises[last]);
    rows.push(Row { before, here, after: 0.0, right });
    tridiagonal(&rows)
}

/// The same of a closed one, whose first and last point are the same.
///
/// The two corners of its matrix are taken out as one dyad, and put back by the formula of
/// Sherman and Morrison.
fn closed_slopes(steps: &[f64], rises: &[Vec2]) -> Vec<Vec2> {
    let n = steps.len();
    let row = |i: usize| {
        let before = (i + n - 1) % n;
        smooth([steps[before], steps[i]], [rises[before], rises[i]])
    };
    let mut rows: Vec<Row> = (0..n).map(row).collect();
    let (first, last) = (rows[0], rows[n - 1]);
    // A = B + g h^T, with g = (-here, 0, .., after of the last), h = (1, 0, .., -before / here).
    let (gamma, ratio) = (-first.here, first.before / -first.here);
    rows[0].here -= gamma;
    rows[n - 1].here -= last.after * ratio;
    let mut dyad: Vec<Row> = rows.iter().map(|row| Row { right: Vec2::ZERO, ..*row }).collect();
    dyad[0].right.x = gamma;
    dyad[n - 1].right.x = last.after;
    let (plain, dyad) = (tridiagonal(&rows), tridiagonal(&dyad));
    let along = |x: &[Vec2]| x[0] + x[n - 1] * ratio;
    let factor = along(&plain) / (1.0 + along(&dyad).x);
    let mut slopes: Vec<Vec2> =
        plain.iter().zip(&dyad).map(|(slope, dyad)| *slope - factor * dyad.x).collect();
    slopes.push(slopes[0]);
    slopes
}

/// The solution of rows whose diagonal outweighs the rest.
fn tridiagonal(rows: &[Row]) -> Vec<Vec2> {
    let mut done: Vec<(f64, Vec2)> = Vec::with_capacity(rows.len());
    for row in rows {
        let (after, right) = done.last().copied().unwrap_or((0.0, Vec2::ZERO));
        let pivot = row.here - row.before * after;
        done.push((row.after / pivot, (row.right - right * row.before) / pivot));
    }
    let mut slopes: Vec<Vec2> = Vec::with_capacity(rows.len());
    for (after, right) in done.into_iter().rev() {
        let next = slopes.last().copied().unwrap_or(Vec2::ZERO);
        slopes.push(right - next * after);
    }
    slopes.reverse();
    slopes
}
