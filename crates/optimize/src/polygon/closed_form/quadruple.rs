//! The best placement of four fingers on four given edges, by finite enumeration.

use std::ops::Deref;

use clench_screw::planar::{cross, quarter_turn};
use clench_screw::{Cholesky, Mat, Vector};

use super::convex::Convex;
use super::ratio::stationary;
use crate::polygon::Fingers;
use crate::polygon::rating::PUSHING;
use crate::polygon::scene::{Scene, Support};

/// Rows of `Z` are rounded by a few units of 1, whatever their own size, so a product of two of
/// them is known to this much of the larger one only.
const ROW_ROUNDING: f64 = 64.0 * f64::EPSILON;

/// What placements and the cone have in common has an inside when its area exceeds this part of
/// the placements' extent times the size of their moments; touching from outside, it has some
/// roundings.
const TOUCHING: f64 = 256.0 * f64::EPSILON;

/// The window of possible centers of compliance is drawn wider by this factor, so that its own
/// sides never touch what is feasible.
const WINDOW_MARGIN: f64 = 1.25;

/// A placement: center of compliance `d` about the part's center, and `z` with `mu = |z|^2`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Peak {
    pub(crate) equivalent: f64,
    pub(crate) d: Vector<2>,
    pub(crate) z: Vector<2>,
}

/// `low <= a . d + z . z_coordinates <= high`.
#[derive(Clone, Copy, Debug)]
struct Row {
    a: Vector<2>,
    z: Vector<2>,
    low: f64,
    high: f64,
}

impl Row {
    /// A row that limits nothing, with a lower limit of 0 and none above.
    const IDLE: Self = Self { a: Vector::ZERO, z: Vector::ZERO, low: 0.0, high: f64::INFINITY };

    fn finite_limits(&self) -> impl Iterator<Item = f64> {
        [self.low, self.high].into_iter().filter(|limit| limit.is_finite())
    }
}

/// Four limits, two sides of the cone, one distance.
const MOST_ROWS: usize = 7;

/// The rows of a cone.
#[derive(Clone, Copy, Debug)]
struct Rows {
    rows: [Row; MOST_ROWS],
    count: usize,
}

impl Rows {
    fn push(&mut self, row: Row) {
        self.rows[self.count] = row;
        self.count += 1;
    }
}

impl Deref for Rows {
    type Target = [Row];

    fn deref(&self) -> &[Row] {
        &self.rows[..self.count]
    }
}

/// `s_j - s_i`, which is `z . difference`, has to be at least `least` in the cone of `sign` 1, and
/// at most `-least` in the opposite cone: the signs of the forces tell the order of the fingers.
#[derive(Clone, Copy, Debug)]
struct Neighbors {
    fingers: (usize, usize),
    difference: Vector<2>,
    least: f64,
}

/// Four stretches in the coordinates `(d, z)` of [`super`].
#[derive(Clone, Debug)]
pub(crate) struct Quadruple<'a> {
    scene: &'a Scene<'a>,
    supports: [&'a Support; 4],
    /// Rows of `Z`.
    null: [Vector<2>; 4],
    /// How the center of compliance moves with each scaled moment: `J (N N^T)^-1 N`.
    per_moment: [Vector<2>; 4],
    /// Normals of the two sides of the cone in which all contact forces push, and have their least
    /// share.
    cone: [Vector<2>; 2],
    /// The same for the cone in which all push by more than rounding.
    inner: [Vector<2>; 2],
    /// Whether two fingers share a stretch; their exchange turns one cone into the other.
    exchangeable: bool,
    /// Two fingers on one edge that have to keep a distance.
    neighbors: Option<Neighbors>,
    window_center: Vector<2>,
    window_half: Vector<2>,
}

impl<'a> Quadruple<'a> {
    /// `None` when no four forces along these normals can all push and balance.
    pub(crate) fn new(
        scene: &'a Scene<'a>,
        stretches: [usize; 4],
        fingers: &Fingers,
    ) -> Option<Self> {
        Self::over(scene, stretches.map(|e| &scene.supports[e]), fingers)
    }

    /// The same for any four stretches, ascending by their edges.
    pub(crate) fn over(
        scene: &'a Scene<'a>,
        supports: [&'a Support; 4],
        fingers: &Fingers,
    ) -> Option<Self> {
        let scaled = supports.map(|s| s.normal * s.weight);
        let null = null_space(&scaled);
        let weights = supports.map(|s| s.weight);
        let inner = pushing_cone(&null, weights, fingers.least_share.max(PUSHING))?;
        let cone = pushing_cone(&null, weights, fingers.least_share)?;
        let gram = scaled.iter().fold(Mat::<2, 2>::ZERO, |sum, &n| sum + Mat::outer(n, n));
        let gram = Cholesky::new(&gram).ok()?;
        // d = J (N N^T)^-1 N s is linear in s, so its range is a box about its middle.
        let (mut window_center, mut window_half) = (Vector::ZERO, Vector::ZERO);
        let per_moment = scaled.map(|n| -quarter_turn(gram.solve(n)));
        for (support, per_moment) in supports.iter().zip(per_moment) {
            window_center += per_moment * (0.5 * (support.low + support.high));
            let half = 0.5 * (support.high - support.low) * WINDOW_MARGIN;
            window_half += Vector::from_fn(|i| per_moment[i].abs() * half);
        }
        let exchangeable = supports.windows(2).any(|pair| pair[0].is_like(pair[1]));
        Some(Self {
            scene,
            supports,
            null,
            per_moment,
            cone,
            inner,
            exchangeable,
            neighbors: neighbors(&supports, &null, cone, fingers.least_distance()),
            window_center,
            window_half,
        })
    }

    /// An upper bound of `mu_eq` over all placements on these edges.
    ///
    /// `mu = min over c of sum (s_i - a_i . c)^2`, so any `c` bounds it from above, here the
    /// middle of the window. And `rho_max(d)^2 >= r_0^2 + |d|^2`: the center of the smallest
    /// circle lies among the corners on it, so one of these, `v`, has `v . d <= 0`.
    pub(crate) fn bound(&self) -> f64 {
        let c = self.window_center;
        let mu: f64 = self
            .supports
            .iter()
            .map(|s| {
                let at = s.arm.dot(c);
                (s.low - at).abs().max((s.high - at).abs()).powi(2)
            })
            .sum();
        let nearest = Vector::<2>::from_fn(|i| (c[i].abs() - self.window_half[i]).max(0.0));
        mu / (self.scene.radius_squared + nearest.norm_squared())
    }

    /// The placement of largest `mu_eq`, if that exceeds `floor`.
    pub(crate) fn peak(&self, floor: f64) -> Option<Peak> {
        let mut best = Peak { equivalent: floor, d: Vector::ZERO, z: Vector::ZERO };
        let cones: &[f64] = if self.exchangeable { &[1.0] } else { &[1.0, -1.0] };
        for &sign in cones.iter().filter(|&&sign| self.enters_cone(sign)) {
            let rows = self.rows(sign);
            for p in 0..rows.len() - 1 {
                for q in p + 1..rows.len() {
                    self.climb_faces(&rows, (p, q), &mut best);
                }
            }
        }
        (best.equivalent > floor).then_some(best)
    }

    /// Whether some placement has all contact forces positive, or negative for the `sign` -1.
    ///
    /// A placement with a force of 0 is a limit of such placements only if there are any: the
    /// values of `z = Z^T s`, a zonogon, must share more than its boundary with the cone.
    fn enters_cone(&self, sign: f64) -> bool {
        let mut middle = Vector::ZERO;
        for (z, s) in self.null.iter().zip(self.supports) {
            middle += *z * (0.5 * (s.low + s.high));
        }
        let half = |i: usize| 0.5 * (self.supports[i].high - self.supports[i].low);
        let generators = std::array::from_fn(|i| self.null[i] * half(i));
        let extent: f64 = generators.iter().map(|g: &Vector<2>| g.norm()).sum();
        let mut common = Convex::zonogon(middle, generators)
            .cut(self.inner[0] * -sign, 0.0)
            .cut(self.inner[1] * -sign, 0.0);
        if let Some(Neighbors { difference, least, .. }) = self.neighbors {
            common = common.cut(difference * -sign, -least);
        }
        // Short edges far out: the moments are rounded to their own size.
        let size = self.supports.iter().map(|s| largest(&[s.low, s.high])).fold(extent, f64::max);
        common.area() > TOUCHING * extent * size
    }

    /// The same for parts of stretches on which fingers can push: however little they push there,
    /// what they have in common with the cone is a limit of placements.
    pub(crate) fn on_part(self) -> Self {
        Self { inner: self.cone, ..self }
    }

    fn largest_arm(&self) -> f64 {
        self.supports.iter().map(|s| s.weight).fold(0.0, f64::max)
    }

    /// Raises `best` to the placement at `(d, z)`, if that is larger once it is within its limits.
    ///
    /// What a face promises is rounded, and much so where rows are nearly parallel; only what a
    /// placement keeps counts.
    fn accept(&self, d: Vector<2>, z: Vector<2>, best: &mut Peak) {
        let s = self.moments(d, z);
        let mut placed = Peak { equivalent: 0.0, d: Vector::ZERO, z: Vector::ZERO };
        for i in 0..4 {
            placed.z += self.null[i] * s[i];
            placed.d += self.per_moment[i] * s[i];
        }
        // The moments are sums in which a far center cancels, so z is known to this much only.
        let size = self.largest_arm() * placed.d.norm() + placed.z.norm() + largest(&s);
        let slack = -ROW_ROUNDING * size;
        let pushes = |sign: f64| {
            let apart =
                self.neighbors.is_none_or(|Neighbors { fingers: (i, j), least, .. }| {
                    sign * (s[j] - s[i]) >= least + slack
                });
            apart && self.cone.iter().all(|c| sign * c.dot(placed.z) >= slack)
        };
        let reach = (placed.d - self.scene.farthest(placed.d)).norm_squared();
        placed.equivalent = placed.z.norm_squared() / reach;
        if placed.equivalent > best.equivalent && (pushes(1.0) || pushes(-1.0)) {
            *best = placed;
        }
    }

    /// The scaled moments at `(d, z)`, within their limits.
    pub(crate) fn moments(&self, d: Vector<2>, z: Vector<2>) -> [f64; 4] {
        std::array::from_fn(|i| {
            let s = self.supports[i].arm.dot(d) + self.null[i].dot(z);
            s.clamp(self.supports[i].low, self.supports[i].high)
        })
    }

    /// The four limits, the two sides of the cone (`sign` 1) or of its opposite, and the distance
    /// of neighbors.
    fn rows(&self, sign: f64) -> Rows {
        let mut rows = Rows { rows: [Row::IDLE; MOST_ROWS], count: 0 };
        for (s, z) in self.supports.iter().zip(self.null) {
            rows.push(Row { a: s.arm, z, low: s.low, high: s.high });
        }
        for side in self.cone {
            rows.push(Row { z: side * sign, ..Row::IDLE });
        }
        if let Some(Neighbors { difference, least, .. }) = self.neighbors {
            rows.push(Row { z: difference * sign, low: least, ..Row::IDLE });
        }
        rows
    }

    /// Climbs all faces on which rows `p` and `q` are active, at either of their limits.
    fn climb_faces(&self, rows: &[Row], (p, q): (usize, usize), best: &mut Peak) {
        let (first, second) = (&rows[p], &rows[q]);
        let determinant = cross(first.z, second.z);
        let size = first.z.norm_squared().max(second.z.norm_squared()).sqrt();
        // Two sides of the cone meet in z = 0 only; parallel rows have other partners.
        if (p, q) == (4, 5) || determinant.abs() <= ROW_ROUNDING * size {
            return;
        }
        // z = solve (c - A d)
        let solve = Mat::new([
            [second.z[1] / determinant, -first.z[1] / determinant],
            [-second.z[0] / determinant, first.z[0] / determinant],
        ]);
        let arms = Mat::new([first.a.to_array(), second.a.to_array()]);
        let slope = solve * arms * -1.0;
        for c in first.finite_limits() {
            for e in second.finite_limits() {
                let face = Face { base: solve * Vector::new([c, e]), slope };
                self.climb(&face, rows, (p, q), best);
            }
        }
    }

    /// Raises `best` to the largest ratio on one face, if that is larger.
    fn climb(&self, face: &Face, rows: &[Row], active: (usize, usize), best: &mut Peak) {
        let farthest_z = face.at(self.window_center).norm()
            + face.slope.column(0).norm() * self.window_half[0]
            + face.slope.column(1).norm() * self.window_half[1];
        if farthest_z * farthest_z <= best.equivalent * self.scene.radius_squared {
            return;
        }
        let Some(region) = self.region(face, rows, active) else { return };
        let mut farthest_z = 0.0_f64;
        for (a, b) in region.edges() {
            farthest_z = farthest_z.max(face.at(a).norm_squared());
            let near = distance_squared_to_origin(a, b);
            let far_z = face.at(a).norm_squared().max(face.at(b).norm_squared());
            if far_z > best.equivalent * (self.scene.radius_squared + near) {
                self.climb_edge(face, a, b, best);
            }
        }
        if farthest_z > best.equivalent * self.scene.radius_squared {
            self.climb_borders(face, &region, best);
        }
    }

    /// Where on the plane of `d` the face fulfills all other rows.
    fn region(&self, face: &Face, rows: &[Row], active: (usize, usize)) -> Option<Convex> {
        let [half_x, half_y] = self.window_half.to_array();
        let mut region = Convex::parallelogram(
            self.window_center,
            Vector::new([half_x, 0.0]),
            Vector::new([0.0, half_y]),
        );
        for (i, row) in rows.iter().enumerate() {
            if i == active.0 || i == active.1 {
                continue;
            }
            let g = row.a + face.slope.transpose() * row.z;
            let offset = row.z.dot(face.base);
            let (low, high) = (row.low - offset, row.high - offset);
            let middle = g.dot(self.window_center);
            let spread = g[0].abs() * half_x + g[1].abs() * half_y;
            if middle + spread < low || middle - spread > high {
                return None;
            }
            if middle - spread < low {
                region = region.cut(-g, -low);
            }
            if middle + spread > high {
                region = region.cut(g, high);
            }
            if region.vertices().is_empty() {
                return None;
            }
        }
        Some(region)
    }

    fn climb_edge(&self, face: &Face, a: Vector<2>, b: Vector<2>, best: &mut Peak) {
        let outline = self.scene.part.outline();
        let center = self.scene.center;
        for stretch in outline.farthest_along(a + center, b + center) {
            let corner = outline.corners()[stretch.corner] - center;
            self.climb_line(face, (a, b - a), (stretch.from, stretch.to), corner, best);
        }
    }

    fn climb_borders(&self, face: &Face, region: &Convex, best: &mut Peak) {
        self.scene.borders_across(region, |border, (from, to)| {
            let (start, direction) = border.line;
            let clipped = (start + direction * from, direction * (to - from));
            self.climb_line(face, clipped, (0.0, 1.0), border.corner, best);
        });
    }

    /// Raises `best` to the largest ratio on the stretch `[from, to]` of the line
    /// `start + t step`, all of whose points have `corner` as their farthest.
    fn climb_line(
        &self,
        face: &Face,
        (start, step): (Vector<2>, Vector<2>),
        (from, to): (f64, f64),
        corner: Vector<2>,
        best: &mut Peak,
    ) {
        let top = (face.at(start), face.slope * step);
        let bottom = (start - corner, step);
        let [t0, t1] = stationary(top, bottom);
        for t in [from, to, t0, t1] {
            if t >= from && t <= to {
                let z = top.0 + top.1 * t;
                let reach = bottom.0 + bottom.1 * t;
                let equivalent = z.norm_squared() / reach.norm_squared();
                if equivalent > best.equivalent {
                    self.accept(start + step * t, z, best);
                }
            }
        }
    }
}

/// A face of the feasible set: `z = base + slope d`.
#[derive(Clone, Copy, Debug)]
struct Face {
    base: Vector<2>,
    slope: Mat<2, 2>,
}

impl Face {
    fn at(&self, d: Vector<2>) -> Vector<2> {
        self.base + self.slope * d
    }
}

/// The rows of an orthonormal basis of the null space of the 2 x 4 matrix with these columns.
///
/// Gram-Schmidt on the rows, then on the two unit vectors that are farthest from them.
fn null_space(columns: &[Vector<2>; 4]) -> [Vector<2>; 4] {
    let row = |i: usize| Vector::<4>::from_fn(|j| columns[j][i]);
    let mut basis = [Vector::<4>::ZERO; 4];
    let mut used = [false; 4];
    // Rows of normals that span the plane: the longer one first.
    let (x, y) = (row(0), row(1));
    let rows = if x.norm_squared() >= y.norm_squared() { [x, y] } else { [y, x] };
    basis[0] = orthogonal_unit(rows[0], &[]);
    basis[1] = orthogonal_unit(rows[1], &basis[..1]);
    for count in 2..4 {
        let (known, rest) = basis.split_at_mut(count);
        let height = |j: usize| 1.0 - known.iter().map(|b| b[j] * b[j]).sum::<f64>();
        let free = (0..4).filter(|&j| !used[j]);
        let Some(axis) = free.max_by(|&i, &j| height(i).total_cmp(&height(j))) else { break };
        used[axis] = true;
        let unit = Vector::from_fn(|j| if j == axis { 1.0 } else { 0.0 });
        rest[0] = orthogonal_unit(unit, known);
    }
    std::array::from_fn(|i| Vector::new([basis[2][i], basis[3][i]]))
}

/// The unit vector along what of `v` is orthogonal to the orthonormal `basis`; subtracted twice,
/// so that it is orthogonal to working precision.
fn orthogonal_unit(v: Vector<4>, basis: &[Vector<4>]) -> Vector<4> {
    let mut v = v;
    for _ in 0..2 {
        for &b in basis {
            v = v - b * b.dot(v);
        }
    }
    let length = v.norm();
    if length > 0.0 { v * length.recip() } else { v }
}

/// The normals of the two sides of the cone of `z` in which each force `w_i Z_i . (J z)` is at
/// least its `least_share` of their sum.
fn pushing_cone(
    null: &[Vector<2>; 4],
    weights: [f64; 4],
    least_share: f64,
) -> Option<[Vector<2>; 2]> {
    if null.iter().any(|z| z.norm_squared() <= ROW_ROUNDING * ROW_ROUNDING) {
        return None;
    }
    let sum = (0..4).fold(Vector::ZERO, |sum, i| sum + null[i] * (weights[i] * least_share));
    let rows: [Vector<2>; 4] = std::array::from_fn(|i| null[i] - sum * weights[i].recip());
    // All rows lie between the extreme two, which are less than half a turn apart.
    let extreme =
        |turn: f64| rows.iter().copied().find(|&e| rows.iter().all(|&z| turn * cross(e, z) >= 0.0));
    let (right, left) = (extreme(1.0)?, extreme(-1.0)?);
    if cross(right, left) <= ROW_ROUNDING * right.norm().max(left.norm()) {
        return None;
    }
    // Z . (J z) = (J^T Z) . z, and J^T is the quarter turn.
    Some([quarter_turn(right), quarter_turn(left)])
}

/// The two fingers on one edge, at most one pair, if they have to keep a distance.
fn neighbors(
    supports: &[&Support; 4],
    null: &[Vector<2>; 4],
    cone: [Vector<2>; 2],
    least_distance: f64,
) -> Option<Neighbors> {
    let i = (0..3).find(|&i| supports[i].edge == supports[i + 1].edge)?;
    let difference = null[i + 1] - null[i];
    // Inside the cone the difference has one sign.
    let inside = cone[0] * cone[1].norm() + cone[1] * cone[0].norm();
    let (fingers, difference) = if difference.dot(inside) >= 0.0 {
        ((i, i + 1), difference)
    } else {
        ((i + 1, i), -difference)
    };
    let least = supports[i].weight * least_distance;
    (least > 0.0).then_some(Neighbors { fingers, difference, least })
}

/// The largest magnitude.
fn largest(numbers: &[f64]) -> f64 {
    numbers.iter().fold(0.0, |largest, x| largest.max(x.abs()))
}

fn distance_squared_to_origin(a: Vector<2>, b: Vector<2>) -> f64 {
    let step = b - a;
    let t = (-a.dot(step) / step.norm_squared()).clamp(0.0, 1.0);
    // Two equal ends make t NaN, and the distance that of the end.
    if t.is_nan() { a.norm_squared() } else { (a + step * t).norm_squared() }
}
