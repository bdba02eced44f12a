//! Three fingers: the search over all edge triplets.

use std::num::NonZeroUsize;

use clench_screw::Vector;
use clench_screw::planar::cross;
use clench_shape::Edge;

use super::Part;
use super::convex::Convex;
use super::edge_sets::{choose, triplet};
use super::leaders::Candidate;
use super::scene::Scene;
use super::search::{Verdict, search};
use crate::{OptimizeError, Outcome, Placement, Progress, Solution};

/// Two normals are parallel, and so cannot be two of three that balance, when the sine of their
/// angle is below this many units of rounding.
const PARALLEL: f64 = 8.0 * f64::EPSILON;

/// What to search for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThreeFingers {
    /// `f_T`, the sum of the contact forces (force).
    pub total_preload: f64,
    /// The radius of the fingers' tips (length); 0 for pointed fingers.
    pub finger_radius: f64,
    /// How many of the best edge triplets to return.
    pub top: NonZeroUsize,
}

impl ThreeFingers {
    /// Pointed fingers with the given total preload, and the one best triplet.
    #[must_use]
    pub const fn with_preload(total_preload: f64) -> Self {
        Self { total_preload, finger_radius: 0.0, top: NonZeroUsize::MIN }
    }

    fn checked(&self) -> Result<(), OptimizeError> {
        let (force, radius) = (self.total_preload, self.finger_radius);
        if !(force > 0.0 && force.is_finite()) {
            return Err(OptimizeError::TotalPreload { value: force });
        }
        if !(radius >= 0.0 && radius.is_finite()) {
            return Err(OptimizeError::FingerRadius { value: radius });
        }
        Ok(())
    }
}

/// The best placements of three frictionless fingers on the edges of `part`.
///
/// Maximizes `Q = min(sigma_min, mu_eq)` [LBR, eq. 14] over all triplets of edges and all
/// placements whose normals meet in a point. On a triplet, `sigma_min` and
///
/// `mu = f_T (sum of share_i dist_i + r)`
///
/// are constant (`dist_i`: distance of the meeting point from edge `i`, the sum being the radius
/// of the triangle's inscribed circle), so the best meeting point is the feasible one with the
/// least reach. This is LBR's proposition 5.1 with the radius `r` of the fingers; the overlaps,
/// which lower `mu` by the sum of `f_i delta_i`, are neglected as there. `watch` is called after
/// each round; threads and determinism are as for [`four_fingers`](super::four_fingers).
///
/// # Errors
///
/// [`OptimizeError::TotalPreload`], [`OptimizeError::FingerRadius`];
/// [`OptimizeError::NormalsNeverBalance`] or [`OptimizeError::TorquesNeverBalance`] when three
/// frictionless fingers cannot hold the part; [`OptimizeError::TooManyEdges`];
/// [`OptimizeError::OutOfRange`] when the numbers of the best placement overflow.
pub fn three_fingers(
    part: &Part,
    options: &ThreeFingers,
    watch: impl FnMut(&Progress),
) -> Result<Outcome, OptimizeError> {
    options.checked()?;
    let scene = Scene::new(part);
    let edges = scene.supports.len();
    let total = choose(edges as u64, 3).ok_or(OptimizeError::TooManyEdges { edges })?;
    search(
        total,
        options.top,
        |number, floor| examine(&scene, triplet(number), options, floor),
        |candidate| solution(&scene, candidate),
        watch,
    )
}

/// The best placement on the given edges, in any order.
///
/// `None` when three fingers on these edges cannot hold the part.
///
/// # Errors
///
/// [`OptimizeError::NoSuchEdge`], and those of the options.
pub fn three_fingers_on(
    part: &Part,
    edges: [usize; 3],
    options: &ThreeFingers,
) -> Result<Option<Solution>, OptimizeError> {
    options.checked()?;
    let edges = part.checked(edges)?;
    let scene = Scene::new(part);
    match examine(&scene, edges, options, 0.0) {
        Verdict::Examined(Some(candidate)) => solution(&scene, &candidate).map(Some),
        _ => Ok(None),
    }
}

/// The best placement on `edges`, if its quality can exceed `floor`.
fn examine(
    scene: &Scene,
    edges: [usize; 3],
    options: &ThreeFingers,
    floor: f64,
) -> Verdict<3, Meeting> {
    let sigma_min = scene.sigma_min(&edges) * scene.stiffness_unit;
    if sigma_min <= floor {
        return Verdict::Skipped;
    }
    let Some(triplet) = Triplet::new(scene, edges) else { return Verdict::Skipped };
    let mu = triplet.rotational_stiffness(options);
    // No point has a smaller reach than the geometric center.
    if mu <= floor * scene.radius_squared {
        return Verdict::Excluded;
    }
    Verdict::Examined(triplet.nearest_meeting_point().map(|(center, reach_squared)| {
        let place = Meeting { center, mu, shares: triplet.shares };
        Candidate { edges, sigma_min, equivalent: mu / reach_squared, place }
    }))
}

/// Where three normals meet.
#[derive(Clone, Copy, Debug)]
struct Meeting {
    center: Vector<2>,
    /// `mu` about it.
    mu: f64,
    /// The balancing contact forces, with sum 1.
    shares: [f64; 3],
}

/// Three edges whose inward normals positively span the plane.
#[derive(Clone, Copy, Debug)]
struct Triplet<'a> {
    scene: &'a Scene<'a>,
    edges: [usize; 3],
    /// The balancing contact forces, with sum 1.
    shares: [f64; 3],
}

impl<'a> Triplet<'a> {
    fn new(scene: &'a Scene<'a>, edges: [usize; 3]) -> Option<Self> {
        let [a, b, c] = edges.map(|e| scene.supports[e].normal);
        let sines = [cross(b, c), cross(c, a), cross(a, b)];
        let total: f64 = sines.iter().sum();
        let spans = sines.iter().all(|s| s * total.signum() > PARALLEL);
        spans.then(|| Self { scene, edges, shares: sines.map(|s| s / total) })
    }

    fn edge(&self, i: usize) -> &Edge {
        &self.scene.part.outline().edges()[self.edges[i]]
    }

    /// `mu` of every placement on these edges.
    fn rotational_stiffness(&self, options: &ThreeFingers) -> f64 {
        let distance = |i: usize| {
            let edge = self.edge(i);
            edge.inward_normal().dot(self.scene.center - edge.start())
        };
        let inscribed: f64 = (0..3).map(|i| self.shares[i] * distance(i)).sum();
        options.total_preload * (inscribed + options.finger_radius)
    }

    /// The point of least reach in which the normals on these edges can meet, and the square of
    /// that reach: the geometric center if it is one, else on the boundary of those points, since
    /// the reach is convex.
    fn nearest_meeting_point(&self) -> Option<(Vector<2>, f64)> {
        let region = self.meeting_points();
        if region.vertices().is_empty() {
            return None;
        }
        let center = self.scene.center;
        if (0..3).all(|i| self.faces(i, center)) {
            return Some((center, self.scene.radius_squared));
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
        Some(best)
    }

    /// Whether the normal on edge `i` through `point` starts on the edge.
    fn faces(&self, i: usize, point: Vector<2>) -> bool {
        let edge = self.edge(i);
        let along = edge.direction().dot(point - edge.start());
        (0.0..=edge.length()).contains(&along)
    }

    /// The intersection of the three strips of points that the edges face [LBR, figure 3].
    fn meeting_points(&self) -> Convex {
        // The two strips that cross most squarely, cut by the third.
        let sine = |i: usize| cross(self.direction(i), self.direction((i + 1) % 3));
        let mut third = 2;
        for i in 0..3 {
            if sine(i).abs() > sine((third + 1) % 3).abs() {
                third = (i + 2) % 3;
            }
        }
        let (p, q) = ((third + 1) % 3, (third + 2) % 3);
        let (u, v, sine) = (self.direction(p), self.direction(q), sine(p));
        let (middle_p, middle_q) = (self.middle(p), self.middle(q));
        // The point with u . x = u . middle_p and v . x = v . middle_q, from middle_p on.
        let across = Vector::new([-u[1], u[0]]);
        let center = middle_p + across * (v.dot(middle_q - middle_p) / sine);
        let half = |i: usize| 0.5 * self.edge(i).length() / sine;
        // A step along u alone lies across v, and the other way round.
        let (along_u, along_v) =
            (Vector::new([v[1], -v[0]]) * half(p), Vector::new([-u[1], u[0]]) * half(q));
        let strips = if cross(along_u, along_v) > 0.0 {
            Convex::parallelogram(center, along_u, along_v)
        } else {
            Convex::parallelogram(center, along_v, along_u)
        };
        let (w, start) = (self.direction(third), self.edge(third).start());
        let low = w.dot(start);
        strips.cut(w, low + self.edge(third).length()).cut(-w, -low)
    }

    fn direction(&self, i: usize) -> Vector<2> {
        self.edge(i).direction()
    }

    fn middle(&self, i: usize) -> Vector<2> {
        (self.edge(i).start() + self.edge(i).end()) * 0.5
    }
}

fn solution(scene: &Scene, candidate: &Candidate<3, Meeting>) -> Result<Solution, OptimizeError> {
    let Meeting { center, mu, shares } = candidate.place;
    let placements = candidate.edges.iter().zip(shares).map(|(&number, share)| {
        let edge = &scene.part.outline().edges()[number];
        let along = edge.direction().dot(center - edge.start()).clamp(0.0, edge.length());
        let (point, inward_normal) = (edge.point_at(along), edge.inward_normal());
        Placement { edge: number, point, inward_normal, share }
    });
    Solution::of_concurrent(scene.part, placements.collect(), center, mu)
}
