//! Bodies of space, and how deep two of them overlap.

use std::sync::Arc;

use clench_screw::spatial::Frame;

use crate::deepest::{
    Convex, Surface, ball_at, deepest_of_ellipsoids, ellipsoid_and_points, in_own_units, on_ball,
    points_in_space,
};
use crate::{Ball, DeepestPair, Ellipsoid, OverlapError, PointHull, Polyhedron, Side};

/// A body of space, in a frame that all bodies of a pair share.
#[derive(Clone, Debug, PartialEq)]
pub enum Body {
    /// A ball, or a point.
    Ball(Ball<3>),
    /// An ellipsoid.
    Ellipsoid(Ellipsoid<3>),
    /// A convex polytope.
    Hull(PointHull<3>),
    /// Any solid with flat faces, shared by all places where it stands.
    Polyhedron {
        /// The solid, in its own frame.
        solid: Arc<Polyhedron>,
        /// Its own frame, seen from the common one.
        pose: Frame,
    },
}

impl Body {
    /// The body given in the frame `pose`, written in the parent of `pose`.
    #[must_use]
    pub fn placed(&self, pose: &Frame) -> Self {
        match self {
            Self::Ball(ball) => Self::Ball(ball.placed(pose)),
            Self::Ellipsoid(ellipsoid) => Self::Ellipsoid(ellipsoid.placed(pose)),
            Self::Hull(hull) => Self::Hull(hull.placed(pose)),
            Self::Polyhedron { solid, pose: own } => {
                Self::Polyhedron { solid: Arc::clone(solid), pose: *pose * *own }
            }
        }
    }

    /// The body as all points within a radius of a convex core, unless it is not convex.
    fn core(&self) -> Option<(Convex<3>, f64)> {
        match self {
            Self::Ball(ball) => Some((Convex::Points(vec![ball.center()]), ball.radius())),
            Self::Ellipsoid(ellipsoid) => Some((Convex::Ellipsoid(*ellipsoid), 0.0)),
            Self::Hull(hull) => Some((Convex::Points(hull.points().to_vec()), 0.0)),
            Self::Polyhedron { solid, pose } => solid.is_convex().then(|| {
                let vertices = solid.used_vertices().map(|vertex| pose.point_to_parent(vertex));
                (Convex::Points(vertices.collect()), 0.0)
            }),
        }
    }
}

impl From<Polyhedron> for Body {
    fn from(solid: Polyhedron) -> Self {
        Self::Polyhedron { solid: Arc::new(solid), pose: Frame::IDENTITY }
    }
}

/// How deep `finger` and `part` overlap, and where [LBR, section 2].
///
/// For convex bodies `depth` is the least translation that separates them; for a ball at a solid
/// that is not convex, the least one to the side of the nearest face. Where several are equal the
/// pair is one of them. Exact to rounding for bodies apart or barely overlapping, and for a ball;
/// where others overlap beyond their middles, the least of the local minima that are found.
///
/// # Errors
///
/// [`OverlapError::NotConvex`] when neither is a ball.
///
/// ```
/// use clench_shape::spatial::{Body, deepest_pair};
/// use clench_shape::{Ball, Ellipsoid};
/// let finger = Body::Ball(Ball::new([0.0, 0.0, 3.0].into(), 2.5).unwrap());
/// let part = Body::Ellipsoid(Ellipsoid::new([0.0; 3].into(), [3.0, 2.0, 1.0]).unwrap());
/// let pair = deepest_pair(&finger, &part)?;
/// assert_eq!((pair.depth, pair.inward_normal.to_array()), (0.5, [0.0, 0.0, -1.0]));
/// # Ok::<(), clench_shape::OverlapError>(())
/// ```
pub fn deepest_pair(finger: &Body, part: &Body) -> Result<DeepestPair<3>, OverlapError> {
    if let Some(pair) = at_ball(finger, part) {
        return Ok(pair);
    }
    if let Some(pair) = at_ball(part, finger) {
        return Ok(pair.exchanged());
    }
    let not_convex = |side| OverlapError::NotConvex { side };
    let (finger, radius) = finger.core().ok_or(not_convex(Side::Finger))?;
    let (part, other_radius) = part.core().ok_or(not_convex(Side::Part))?;
    let pair = in_own_units(&finger, &part, of_convex);
    Ok(pair.with_radius(radius).exchanged().with_radius(other_radius).exchanged())
}

/// The pair of a ball, the finger, and a part that knows its nearest point.
fn at_ball(finger: &Body, part: &Body) -> Option<DeepestPair<3>> {
    let Body::Ball(ball) = finger else {
        return None;
    };
    let center = ball.center();
    match part {
        Body::Ball(other) => Some(ball_at(ball, on_ball(other, center))),
        Body::Ellipsoid(ellipsoid) => Some(ball_at(ball, ellipsoid.nearest(center).into())),
        Body::Polyhedron { solid, pose } => {
            let near = solid.surface_at(pose.point_in_frame(center));
            let foot = pose.point_to_parent(near.foot);
            let inward_normal = pose.direction_to_parent(near.inward_normal);
            Some(ball_at(ball, Surface { foot, inward_normal, ..near }))
        }
        Body::Hull(_) => None,
    }
}

fn of_convex(finger: Convex<3>, part: Convex<3>) -> DeepestPair<3> {
    match (finger, part) {
        (Convex::Ellipsoid(a), Convex::Ellipsoid(b)) => deepest_of_ellipsoids(&a, &b),
        (Convex::Ellipsoid(a), Convex::Points(b)) => ellipsoid_and_points(&a, &b),
        (Convex::Points(a), Convex::Ellipsoid(b)) => ellipsoid_and_points(&b, &a).exchanged(),
        (Convex::Points(a), Convex::Points(b)) => points_in_space(&a, &b),
    }
}
