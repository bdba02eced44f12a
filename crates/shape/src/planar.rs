//! Bodies of the plane, and how deep two of them overlap.

use std::sync::Arc;

use clench_screw::{Vector, planar::Frame};

use crate::deepest::{
    Convex, Surface, ball_at, deepest_of_ellipsoids, ellipse_and_points, in_own_units, on_ball,
    points_in_plane,
};
use crate::{Ball, DeepestPair, Ellipsoid, OverlapError, PointHull, Polygon, Side};

/// A body of the plane, in a frame that all bodies of a pair share.
#[derive(Clone, Debug, PartialEq)]
pub enum Body {
    /// A disc, or a point.
    Disc(Ball<2>),
    /// An ellipse.
    Ellipse(Ellipsoid<2>),
    /// A convex polygon.
    Hull(PointHull<2>),
    /// Any outline, shared by all places where it stands.
    Polygon {
        /// The outline, in its own frame.
        outline: Arc<Polygon>,
        /// Its own frame, seen from the common one.
        pose: Frame,
    },
}

impl Body {
    /// The body given in the frame `pose`, written in the parent of `pose`.
    #[must_use]
    pub fn placed(&self, pose: &Frame) -> Self {
        match self {
            Self::Disc(disc) => Self::Disc(disc.placed(pose)),
            Self::Ellipse(ellipse) => Self::Ellipse(ellipse.placed(pose)),
            Self::Hull(hull) => Self::Hull(hull.placed(pose)),
            Self::Polygon { outline, pose: own } => {
                Self::Polygon { outline: Arc::clone(outline), pose: *pose * *own }
            }
        }
    }

    /// The body as all points within a radius of a convex core, unless it is not convex.
    fn core(&self) -> Option<(Convex<2>, f64)> {
        match self {
            Self::Disc(disc) => Some((Convex::Points(vec![disc.center()]), disc.radius())),
            Self::Ellipse(ellipse) => Some((Convex::Ellipsoid(*ellipse), 0.0)),
            Self::Hull(hull) => Some((Convex::Points(hull.points().to_vec()), 0.0)),
            Self::Polygon { outline, pose } => outline.is_convex().then(|| {
                let corners = outline.hull().iter().map(|&corner| outline.corners()[corner]);
                let corners = corners.map(|corner| pose.point_to_parent(corner));
                (Convex::Points(corners.collect()), 0.0)
            }),
        }
    }
}

impl From<Polygon> for Body {
    fn from(outline: Polygon) -> Self {
        Self::Polygon { outline: Arc::new(outline), pose: Frame::IDENTITY }
    }
}

/// How deep `finger` and `part` overlap, and where [LBR, section 2].
///
/// For convex bodies `depth` is the least translation that separates them; for a disc at an
/// outline that is not convex, the least one to the side of the nearest edge. Where several are
/// equal the pair is one of them. Exact to rounding; with an ellipse beyond the middle of another
/// body, the least of the local minima that are found from all axes, corners and sides.
///
/// # Errors
///
/// [`OverlapError::NotConvex`] when neither is a disc.
///
/// ```
/// use clench_shape::planar::{Body, deepest_pair};
/// use clench_shape::{Ball, Polygon};
/// let finger = Body::Disc(Ball::new([2.0, -0.75].into(), 1.0).unwrap());
/// let part = Polygon::new(&[[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]]).unwrap();
/// let pair = deepest_pair(&finger, &part.into())?;
/// assert_eq!((pair.depth, pair.inward_normal.to_array()), (0.25, [0.0, 1.0]));
/// assert_eq!((pair.on_finger.to_array(), pair.on_part.to_array()), ([2.0, 0.25], [2.0, 0.0]));
/// # Ok::<(), clench_shape::OverlapError>(())
/// ```
pub fn deepest_pair(finger: &Body, part: &Body) -> Result<DeepestPair<2>, OverlapError> {
    if let Some(pair) = at_disc(finger, part) {
        return Ok(pair);
    }
    if let Some(pair) = at_disc(part, finger) {
        return Ok(pair.exchanged());
    }
    let not_convex = |side| OverlapError::NotConvex { side };
    let (finger, radius) = finger.core().ok_or(not_convex(Side::Finger))?;
    let (part, other_radius) = part.core().ok_or(not_convex(Side::Part))?;
    let pair = in_own_units(&finger, &part, of_convex);
    Ok(pair.with_radius(radius).exchanged().with_radius(other_radius).exchanged())
}

/// The pair of a disc, the finger, and a part that knows its nearest point.
fn at_disc(finger: &Body, part: &Body) -> Option<DeepestPair<2>> {
    let Body::Disc(disc) = finger else {
        return None;
    };
    let center = disc.center();
    match part {
        Body::Disc(other) => Some(ball_at(disc, on_ball(other, center))),
        Body::Ellipse(ellipse) => Some(ball_at(disc, ellipse.nearest(center).into())),
        Body::Polygon { outline, pose } => {
            let near = on_outline(outline, pose.point_in_frame(center));
            let foot = pose.point_to_parent(near.foot);
            let inward_normal = pose.direction_to_parent(near.inward_normal);
            Some(ball_at(disc, Surface { foot, inward_normal, ..near }))
        }
        Body::Hull(_) => None,
    }
}

fn of_convex(finger: Convex<2>, part: Convex<2>) -> DeepestPair<2> {
    match (finger, part) {
        (Convex::Ellipsoid(a), Convex::Ellipsoid(b)) => deepest_of_ellipsoids(&a, &b),
        (Convex::Ellipsoid(a), Convex::Points(b)) => ellipse_and_points(&a, &b),
        (Convex::Points(a), Convex::Ellipsoid(b)) => ellipse_and_points(&b, &a).exchanged(),
        (Convex::Points(a), Convex::Points(b)) => points_in_plane(&a, &b),
    }
}

/// The point of an outline nearest to `point`.
fn on_outline(outline: &Polygon, point: Vector<2>) -> Surface<2> {
    let place = outline.place(point);
    if let Some(corner) = place.corner {
        return Surface::at(outline.corners()[corner], point, outline.inward_at(&place));
    }
    let edge = &outline.edges()[place.edge];
    let foot = edge.point_at(place.along);
    let signed_distance = outline.signed_distance(point);
    Surface { foot, signed_distance, inward_normal: edge.inward_normal() }
}
