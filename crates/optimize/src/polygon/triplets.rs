//! Three fingers whose normals meet: what is searched, bounded and solved.

use clench_screw::Vector;
use clench_screw::planar::{cross, quarter_turn};

use super::ThreeFingers;
use super::apart::Apart;
use super::bound::{Demand, Middle, Pieces, Range, Verdict, is_excluded};
use super::closed_form::Convex;
use super::rating::PUSHING;
use super::scene::{PARALLEL, Scene, Support};
use crate::search::{Bounded, Candidate, Floor, Piece, Problem, Settled, below};
use crate::{OptimizeError, Placement, Solution};

/// Distances are rounded by this many units of the part's radius.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Steps in which the best test point is narrowed down.
const NARROWINGS: usize = 8;

/// The slopes of test functions along moments that are tried.
const STEEPEST: f64 = 4.0;

/// Meeting points are tried on a grid of twice as many steps, over this part of the radius.
const GRID: u8 = 3;
const GRID_PART: f64 = 0.3;

/// No more stretches that face a point are combined.
const MOST_FACING: usize = 16;

/// Three fingers on a part: which placement is best on three stretches.
#[derive(Clone, Copy, Debug)]
pub(super) struct Triplets<'a> {
    scene: &'a Scene<'a>,
    fingers: &'a ThreeFingers,
    /// `f_T` in the scene's unit of stiffness (length).
    preload: f64,
}

impl<'a> Triplets<'a> {
    pub(super) fn new(scene: &'a Scene<'a>, fingers: &'a ThreeFingers) -> Self {
        Self { scene, fingers, preload: fingers.total_preload / scene.stiffness_unit }
    }

    /// Placements to begin with: for points of a grid about the center, the triplets of stretches
    /// that face them.
    pub(super) fn first(&self) -> Vec<Candidate<3, Meeting>> {
        let half = i32::from(GRID);
        let mut found: Vec<Candidate<3, Meeting>> = Vec::new();
        for i in -half..=half {
            for j in -half..=half {
                let step = self.scene.radius * GRID_PART / f64::from(half);
                let point = self.scene.center + Vector::new([f64::from(i), f64::from(j)]) * step;
                let facing: Vec<usize> = (0..self.scene.supports.len())
                    .filter(|&s| self.scene.supports[s].faces(point))
                    .collect();
                let best = found.iter().map(|c| c.quality).fold(0.0, f64::max);
                let floor = Floor { quality: best, second: best };
                // Neighbors on a fine outline are alike.
                let every = facing.len().div_ceil(MOST_FACING).max(1);
                let facing: Vec<usize> = facing.into_iter().step_by(every).collect();
                for (k, &c) in facing.iter().enumerate() {
                    for (l, &b) in facing[..k].iter().enumerate() {
                        found.extend(
                            facing[..l].iter().filter_map(|&a| self.solve([a, b, c], &floor)),
                        );
                    }
                }
            }
        }
        found
    }

    /// The best placement on three stretches, ascending, if it exceeds `floor`.
    pub(super) fn solve(
        &self,
        stretches: [usize; 3],
        floor: &Floor,
    ) -> Option<Candidate<3, Meeting>> {
        let sigma_min = self.scene.sigma_min(&stretches);
        if sigma_min <= below(floor.quality) {
            return None;
        }
        let triplet = Triplet::new(self.scene, stretches, self.fingers.least_share)?;
        let mu = triplet.rotational_stiffness(self.preload, self.fingers.finger_radius);
        // No point has a smaller reach than the geometric center.
        if mu <= below(floor.quality) * self.scene.radius_squared {
            return None;
        }
        let keep = (self.fingers.finger_radius, self.fingers.least_distance());
        let (center, reach_squared) = triplet.nearest_meeting_point(keep)?;
        let second = mu / reach_squared;
        let quality = sigma_min.min(second);
        let place = Meeting { center, mu, shares: triplet.shares };
        let candidate = Candidate { stretches, quality, second, place };
        floor.is_exceeded_by(quality, second).then_some(candidate)
    }

    /// The fingers of a candidate.
    pub(super) fn solution(
        &self,
        candidate: &Candidate<3, Meeting>,
    ) -> Result<Solution<2, 1>, OptimizeError> {
        let Meeting { center, mu, shares } = candidate.place;
        let placements = candidate.stretches.iter().zip(shares).map(|(&number, share)| {
            let support = &self.scene.supports[number];
            let (point, inward_normal) = (support.foot(center), support.normal);
            Placement { on: support.edge, point, inward_normal, share }
        });
        let mu = mu * self.scene.stiffness_unit;
        Solution::of_concurrent(self.scene.part, placements.collect(), center, mu)
    }
}

/// The search for the best placement of three fingers.
#[derive(Debug)]
pub(super) struct TripletSearch<'a> {
    triplets: Triplets<'a>,
    /// The pieces with their stiffness.
    pub(super) springs: Pieces<3>,
    /// The pieces as unit wrenches, and as unit wrenches with the offset of each edge,
    /// `(J n, gamma, -n . x)`.
    wrenches: Pieces<3>,
    lines: Pieces<4>,
}

impl<'a> TripletSearch<'a> {
    pub(super) fn new(triplets: Triplets<'a>) -> Self {
        let scene = triplets.scene;
        let unit: Vec<Support> = scene.supports.iter().map(Support::of_unit_stiffness).collect();
        let radius = scene.radius;
        let line = |s: &Support, moment: f64| {
            let offset = -s.normal.dot(s.ends[0] - scene.center);
            Vector::new([s.arm[0], s.arm[1], moment, offset])
        };
        let wrenches = Pieces::new(&unit, Vector::new([1.0, 1.0, radius]), Support::wrench);
        let lines = Pieces::like(&wrenches, &unit, Vector::new([1.0, 1.0, radius, radius]), line);
        let units = Vector::new([1.0, 1.0, radius]);
        let springs = Pieces::like(&wrenches, &scene.supports, units, Support::wrench);
        Self { triplets, springs, wrenches, lines }
    }

    /// How far the placements on a node can surpass `demand`.
    fn verdict(&self, node: &[Piece; 3], demand: &Demand) -> Option<Verdict> {
        let single = |piece| self.springs.stretches(piece).len() == 1;
        if node.windows(2).any(|pair| pair[0] == pair[1] && single(pair[0])) {
            // Two of three fingers with one normal never balance.
            return None;
        }
        let springs = Middle::new(node.map(|piece| self.springs.range(piece)), demand.translation);
        let translation = springs.largest_translation();
        // Parallel normals hold no translation, up to rounding.
        if translation <= demand.translation.max(springs.no_translation()) {
            return None;
        }
        let middle = Middle::new(node.map(|piece| self.wrenches.range(piece)), 0.0);
        if is_excluded(&middle, self.triplets.scene.radius, self.triplets.fingers.least_share) {
            return None;
        }
        let lines = node.map(|piece| self.lines.range(piece));
        let mu = self.triplets.preload
            * (self.largest_distance(&lines) + self.triplets.fingers.finger_radius);
        let reach = self.least_reach(&middle, &springs, translation, demand);
        let rotation = mu / (reach * reach);
        if rotation <= demand.rotation {
            return None;
        }
        let surplus = (rotation - demand.rotation).min(translation - demand.translation);
        // The piece of most different wrenches.
        let extent = |i: usize| {
            let [x, y, z] = [0, 1, 2]
                .map(|c| middle.ranges[i].axes.iter().map(|axis| axis[c].abs()).sum::<f64>());
            x + y + z / self.triplets.scene.radius
        };
        let divisible = (0..3).filter(|&i| !middle.ranges[i].is_single());
        let split = divisible.max_by(|&i, &j| extent(i).total_cmp(&extent(j)).then(j.cmp(&i)));
        Some(Verdict { surplus, split: split.unwrap_or(0) })
    }

    /// An upper bound of `sum of share_i dist_i`.
    ///
    /// The wrenches, `w = (n, gamma)`, balance with these shares, and the sum of `share_i n_i` is
    /// zero; so for any point `c` and number `b` it is also the sum of
    /// `share_i (n_i . (c - x_i) + b gamma_i)`, and at most the largest of these.
    fn largest_distance(&self, lines: &[Range<4>; 3]) -> f64 {
        let [p, q, r] = lines.map(|line| line.center);
        // Test functions that are equal in the middle: c = c_0 + b c_1.
        let arms = [p, q, r].map(|l| Vector::new([l[0], l[1]]));
        let (first, second) = (arms[0] - arms[2], arms[1] - arms[2]);
        let determinant = cross(first, second);
        // The offset of a line seen from c is n . c + h = (J n) . (J c) + h.
        let solve = |a: f64, b: f64| {
            (quarter_turn(second) * -a + quarter_turn(first) * b) * determinant.recip()
        };
        let radius = self.triplets.scene.radius;
        let constant = solve(r[3] - p[3], r[3] - q[3]);
        let slope = solve(r[2] - p[2], r[2] - q[2]);
        let most = |b: f64| {
            let turned = constant + slope * b;
            let test = Vector::new([turned[0], turned[1], b, 1.0]);
            let values = lines.map(|line| self.lines.largest_linear(&line, test));
            let rounding = ROUNDING * (turned.norm() + (b.abs() + 1.0) * radius);
            values.into_iter().fold(f64::NEG_INFINITY, f64::max) + rounding
        };
        if !(constant.is_finite() && slope.is_finite()) {
            return radius;
        }
        // Convex in b: narrowed from both sides.
        let (mut low, mut high) = (-STEEPEST, STEEPEST);
        let mut least = most(0.0);
        for _ in 0..NARROWINGS {
            let third = (high - low) / 3.0;
            let (left, right) = (most(low + third), most(high - third));
            least = least.min(left).min(right);
            if left < right {
                high -= third;
            } else {
                low += third;
            }
        }
        least.min(radius)
    }

    /// No meeting point has a smaller reach.
    ///
    /// At a meeting point `d`, all `l_i = gamma_i - J n_i . d` vanish, so about the middle
    /// `sigma_min |d - d_0|^2` is at most the sum of `k_i l_i(d_0)^2`.
    fn least_reach(
        &self,
        middle: &Middle<3>,
        springs: &Middle<3>,
        translation: f64,
        demand: &Demand,
    ) -> f64 {
        let about = middle.about;
        let at = Vector::new([-about[0], -about[1], 1.0]);
        let mut sum = 0.0;
        for (wrench, spring) in middle.ranges.iter().zip(&springs.ranges) {
            let most = wrench.center.dot(at).abs() + wrench.spread(at);
            sum += (spring.stiffness + spring.stiffness_spread) * most * most;
        }
        let least = demand.translation.max(springs.least_translation()).min(translation);
        let away = if least > 0.0 { (sum / least).sqrt() } else { f64::INFINITY };
        let reach = (about - self.triplets.scene.farthest(about)).norm();
        (reach - away).max(self.triplets.scene.radius)
    }
}

impl Problem<3> for TripletSearch<'_> {
    type Place = Meeting;
    type Hint = ();

    const MOST_OPEN: usize = 1 << 20;
    const NODES_PER_PROBE: u64 = 0;

    fn halves(&self, piece: Piece) -> Option<[Piece; 2]> {
        self.springs.halves(piece)
    }

    fn unit(&self) -> f64 {
        self.triplets.scene.stiffness_unit
    }

    fn combination(&self, node: &[Piece; 3]) -> Option<[usize; 3]> {
        self.springs.combination(node)
    }

    fn bound(&self, node: &[Piece; 3], floor: &Floor, _: Option<&()>) -> Option<Bounded<()>> {
        let (bound, split) = floor.bound(|demand| self.verdict(node, demand))?;
        Some(Bounded { bound, split, hint: () })
    }

    fn probe(&self, _: &[Piece; 3], _: u64) -> Option<Candidate<3, Meeting>> {
        None
    }

    fn settle(&self, node: &[Piece; 3], floor: &Floor) -> Settled<3, Meeting> {
        let Some(stretches) = self.springs.combination(node) else { return Settled::Open(None) };
        Settled::Solved { best: self.triplets.solve(stretches, floor), left: 0.0 }
    }
}

/// Where three normals meet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Meeting {
    center: Vector<2>,
    /// `mu` about it, in the scene's unit.
    mu: f64,
    /// The balancing contact forces, with sum 1.
    shares: [f64; 3],
}

#[cfg(test)]
impl Meeting {
    pub(super) fn center(&self) -> Vector<2> {
        self.center
    }
}

/// Three stretches whose inward normals positively span the plane.
#[derive(Clone, Copy, Debug)]
struct Triplet<'a> {
    scene: &'a Scene<'a>,
    supports: [&'a Support; 3],
    /// The balancing contact forces, with sum 1.
    shares: [f64; 3],
}

impl<'a> Triplet<'a> {
    fn new(scene: &'a Scene<'a>, stretches: [usize; 3], least_share: f64) -> Option<Self> {
        let supports = stretches.map(|s| &scene.supports[s]);
        let [a, b, c] = supports.map(|s| s.normal);
        let sines = [cross(b, c), cross(c, a), cross(a, b)];
        let total: f64 = sines.iter().sum();
        let spans = sines.iter().all(|s| s * total.signum() > PARALLEL);
        let shares = sines.map(|s| s / total);
        // Normals of short edges are known to some digits only: what hardly balances does not.
        let shared = shares.iter().all(|share| *share >= least_share.max(PUSHING));
        (spans && shared).then_some(Self { scene, supports, shares })
    }

    /// `mu` of every placement on these stretches.
    fn rotational_stiffness(&self, preload: f64, finger_radius: f64) -> f64 {
        let distance = |i: usize| {
            let support = self.supports[i];
            support.normal.dot(self.scene.center - support.ends[0])
        };
        let inscribed: f64 = (0..3).map(|i| self.shares[i] * distance(i)).sum();
        preload * (inscribed + finger_radius)
    }

    /// The point of least reach in which the normals on these stretches can meet, and the square of
    /// that reach, with tips of a radius that keep a distance.
    fn nearest_meeting_point(&self, keep: (f64, f64)) -> Option<(Vector<2>, f64)> {
        let region = self.meeting_points();
        if region.vertices().is_empty() {
            return None;
        }
        let nearest = self.nearest_of(&region);
        if keep.1 <= 0.0 {
            return Some(nearest);
        }
        let apart = Apart::new(self.scene, &region, self.supports, keep)?;
        if apart.is_crowded(nearest.0) { apart.nearest() } else { Some(nearest) }
    }

    /// The point of the region with the least reach: the geometric center if it is one, else on the
    /// boundary, since the reach is convex.
    fn nearest_of(&self, region: &Convex) -> (Vector<2>, f64) {
        let center = self.scene.center;
        if self.supports.iter().all(|support| support.faces(center)) {
            return (center, self.scene.radius_squared);
        }
        let outline = self.scene.part.outline();
        let mut best = (center, f64::INFINITY);
        for (a, b) in region.edges() {
            for stretch in outline.farthest_along(a, b) {
                let (step, away) = (b - a, outline.corners()[stretch.corner] - a);
                let foot = away.dot(step) / step.norm_squared();
                // Equal ends make the foot NaN, and max then takes the stretch's start.
                let point = a + step * foot.max(stretch.from).min(stretch.to);
                let reach = (outline.corners()[stretch.corner] - point).norm_squared();
                if reach < best.1 {
                    best = (point, reach);
                }
            }
        }
        best
    }

    /// The intersection of the three strips of points that the stretches face [LBR, figure 3].
    fn meeting_points(&self) -> Convex {
        // The two strips that cross most squarely, cut by the third.
        let directions = self.supports.map(Support::direction);
        let sine = |i: usize| cross(directions[i], directions[(i + 1) % 3]);
        let mut third = 2;
        for i in 0..3 {
            if sine(i).abs() > sine((third + 1) % 3).abs() {
                third = (i + 2) % 3;
            }
        }
        let (p, q) = ((third + 1) % 3, (third + 2) % 3);
        let (u, v, sine) = (directions[p], directions[q], sine(p));
        let middle = |i: usize| (self.supports[i].ends[0] + self.supports[i].ends[1]) * 0.5;
        // The point with u . x = u . middle_p and v . x = v . middle_q, from middle_p on.
        let across = Vector::new([-u[1], u[0]]);
        let center = middle(p) + across * (v.dot(middle(q) - middle(p)) / sine);
        let half = |i: usize| 0.5 * self.supports[i].length() / sine;
        // A step along u alone lies across v, and the other way round.
        let (along_u, along_v) =
            (Vector::new([v[1], -v[0]]) * half(p), Vector::new([-u[1], u[0]]) * half(q));
        let strips = if cross(along_u, along_v) > 0.0 {
            Convex::parallelogram(center, along_u, along_v)
        } else {
            Convex::parallelogram(center, along_v, along_u)
        };
        let (w, start) = (directions[third], self.supports[third].ends[0]);
        let low = w.dot(start);
        strips.cut(w, low + self.supports[third].length()).cut(-w, -low)
    }
}
