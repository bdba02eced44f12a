//! What keeps a ball from touching a plane at some points.
//!
//! A ball of radius `r` that touches the plane from above at `p` meets a point at the height `h` if
//! that is within `s(h) = sqrt(h (2 r - h))` of `p`, seen along the normal. The points `p` where it
//! meets a convex body are therefore the union of the discs of radius `s(h)` around the body's
//! points: a convex set, since `s` is concave. Its support in the direction `u` is the largest
//! `u . x + s(h)` over the body; at each height the first term is largest on an edge.

use clench_screw::{Vector, spatial};

use super::tip::KeepOut;

/// The points of a plane at which a finger would come too near to something convex.
#[derive(Clone, Debug)]
pub(super) struct Obstacle {
    /// The edges of the body, with their heights above the plane.
    edges: Vec<[Vector<3>; 2]>,
    /// Directions across which the set may have straight borders.
    pub(super) straight: Vec<Vector<2>>,
    around: Around,
}

/// How far a point of a body keeps the finger off.
#[derive(Clone, Copy, Debug)]
enum Around {
    /// By a ball of this radius.
    Ball(f64),
    /// By this distance in the plane.
    Distance(f64),
}

impl Obstacle {
    /// A triangle beside a ball; `None` if nothing of it is above the plane and below the ball's
    /// top.
    pub(super) fn triangle(corners: [Vector<3>; 3], radius: f64) -> Option<Self> {
        let [a, b, c] = corners;
        let edges = vec![[a, b], [b, c], [c, a]];
        let is_above = corners.iter().any(|corner| corner[2] > 0.0);
        let is_below = corners.iter().any(|corner| corner[2] < 2.0 * radius);
        (is_above && is_below).then(|| {
            let normal = spatial::cross(b - a, c - a);
            let straight = straight(edges.iter().map(|[from, to]| *to - *from), [normal]);
            Self { edges, straight, around: Around::Ball(radius) }
        })
    }

    /// A box beside a ball, which may be a point; `None` as for triangles.
    pub(super) fn keep_out(
        keep_out: &KeepOut,
        local: impl Fn(Vector<3>) -> Vector<3>,
        radius: f64,
    ) -> Option<Self> {
        let corners = keep_out.corners().map(local);
        let is_above = corners.iter().any(|corner| corner[2] > 0.0);
        let is_below = corners.iter().any(|corner| corner[2] <= 2.0 * radius);
        (is_above && is_below).then(|| {
            let ends = (0..8).flat_map(|n| (0..3).map(move |i| [n, n | 1 << i]));
            let edges: Vec<_> =
                ends.filter(|[from, to]| from != to).map(|ends| ends.map(|n| corners[n])).collect();
            let axes = [1, 2, 4].map(|n| corners[n] - corners[0]);
            let straight = straight(axes.into_iter(), axes);
            Self { edges, straight, around: Around::Ball(radius) }
        })
    }

    /// A piece of the border, to be kept away from.
    pub(super) fn border(ends: [Vector<3>; 2], margin: f64) -> Self {
        let straight = straight([ends[1] - ends[0]].into_iter(), []);
        Self { edges: vec![ends], straight, around: Around::Distance(margin) }
    }

    /// Whether no point of `others` is on the near side of a line across the way from the body to
    /// the origin, which the set does not cross.
    pub(super) fn is_beside(&self, others: &[Vector<2>]) -> bool {
        let sum = self.edges.iter().fold(Vector::ZERO, |sum, [from, _]| sum + *from);
        let Some(u) = Vector::new([-sum[0], -sum[1]]).direction() else { return false };
        let support = self.support(u);
        others.iter().all(|&x| u.dot(x) >= support)
    }

    /// The largest `u . p` over the set, minus infinity if it is empty.
    pub(super) fn support(&self, u: Vector<2>) -> f64 {
        let of_edge = |[a, b]: &[Vector<3>; 2]| match self.around {
            Around::Ball(radius) => beside_ball([*a, *b], u, radius),
            Around::Distance(distance) => along(*a, u).max(along(*b, u)) + distance,
        };
        self.edges.iter().map(of_edge).fold(f64::NEG_INFINITY, f64::max)
    }
}

/// Both directions across each of these, seen along the normal, and along the normals of planes.
fn straight<const K: usize>(
    edges: impl Iterator<Item = Vector<3>>,
    normals: [Vector<3>; K],
) -> Vec<Vector<2>> {
    let across = edges.map(|edge| Vector::new([-edge[1], edge[0]]));
    let along = normals.into_iter().map(|normal| Vector::new([normal[0], normal[1]]));
    let all = across.chain(along).filter_map(Vector::direction);
    all.flat_map(|direction| [direction, -direction]).collect()
}

fn along(x: Vector<3>, u: Vector<2>) -> f64 {
    x[0] * u[0] + x[1] * u[1]
}

/// The largest `u . x + s(h)` over an edge, where it is beside the ball.
fn beside_ball([a, b]: [Vector<3>; 2], u: Vector<2>, radius: f64) -> f64 {
    let (low, high) = (a[2].min(b[2]).max(0.0), a[2].max(b[2]).min(2.0 * radius));
    if low > high {
        return f64::NEG_INFINITY;
    }
    let (at_a, at_b) = (along(a, u), along(b, u));
    let rise = b[2] - a[2];
    let spread = |h: f64| (h * (2.0 * radius - h)).max(0.0).sqrt();
    if rise.abs() <= 0.0 {
        return at_a.max(at_b) + spread(low);
    }
    let at = |h: f64| {
        let part = ((h - a[2]) / rise).clamp(0.0, 1.0);
        at_a + (at_b - at_a) * part + spread(h)
    };
    // Where s' = -slope.
    let slope = (at_b - at_a) / rise;
    let root = slope.hypot(1.0);
    let steepest =
        if slope < 0.0 { radius / (root * (root - slope)) } else { radius * (1.0 + slope / root) };
    at(low).max(at(high)).max(at(steepest.clamp(low, high)))
}
