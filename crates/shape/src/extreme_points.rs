//! The points of a body that can be farthest, in a tree.

use clench_screw::Vector;

use crate::BodyError;
use crate::hull::{hull, sorted};
use crate::predicates::unit_scale;
use crate::solid_hull::extreme_points;

/// Up to this many points are looked at one after the other; so many are in a leaf of the tree.
/// With a hundred points the tree takes as long as looking at all.
const LEAF: usize = 16;

/// The points of a body that decide how far it reaches: for a body with flat faces those of its
/// convex hull.
///
/// Whatever grows convexly from point to point, such as a distance, a speed or a compliance, is
/// largest over the body at one of them. They stand in a tree of balls, so that a search need not
/// look at all.
///
/// ```
/// use clench_shape::ExtremePoints;
/// let probes = ExtremePoints::new(&[[0.0, 0.0, 0.0], [3.0, 4.0, 0.0], [0.0, 0.0, 1.0]])?;
/// let farthest = probes.farthest_by(1.0, |point, _| point.norm_squared());
/// assert_eq!((farthest.corner, farthest.value), (Some(1), 5.0));
/// # Ok::<(), clench_shape::BodyError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ExtremePoints<const N: usize> {
    points: Vec<Vector<N>>,
    /// The number of each point in the list that the body was given by.
    numbers: Vec<usize>,
    root: Node<N>,
}

/// Some of the points, within a ball.
#[derive(Clone, Debug, PartialEq)]
struct Node<const N: usize> {
    center: Vector<N>,
    radius: f64,
    content: Content<N>,
}

#[derive(Clone, Debug, PartialEq)]
enum Content<const N: usize> {
    /// The points from one place in the list to another.
    Leaf(std::ops::Range<usize>),
    Branches(Box<[Node<N>; 2]>),
}

/// Where in a body something is largest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Farthest<const N: usize> {
    /// The point of the body.
    pub point: Vector<N>,
    /// Its number among the corners or vertices of the body; `None` on a body without any.
    pub corner: Option<usize>,
    /// How large it is there, in the unit of what was asked for.
    pub value: f64,
}

impl<const N: usize> ExtremePoints<N> {
    /// A body given by `points`: their hull, or anything between the points and the hull.
    ///
    /// Points inside the hull are left out, exactly, unless all are in one plane of space.
    ///
    /// # Errors
    ///
    /// [`BodyError::NoPoints`] and [`BodyError::PointOutOfRange`].
    pub fn new(points: &[[f64; N]]) -> Result<Self, BodyError> {
        let points = BodyError::checked_points(points)?;
        Ok(Self::of_hull(&points, &(0..points.len()).collect::<Vec<_>>()))
    }

    /// Those of the `points` with these numbers, at least one, that are corners of their hull.
    pub(crate) fn of_hull(points: &[Vector<N>], numbers: &[usize]) -> Self {
        let sites = numbers.iter().map(|&number| points[number]);
        let extreme = match N {
            2 => extreme_in_plane(&sites.map(|p| Vector::new([p[0], p[1]])).collect::<Vec<_>>()),
            _ => extreme_points(&sites.map(Vector::in_space).collect::<Vec<_>>()),
        };
        Self::of_points(points, extreme.into_iter().map(|place| numbers[place]).collect())
    }

    /// Those of `points`, at least one, that have these numbers.
    pub(crate) fn of_points(points: &[Vector<N>], mut numbers: Vec<usize>) -> Self {
        let root = Node::new(points, &mut numbers, 0);
        let points = numbers.iter().map(|&number| points[number]).collect();
        Self { points, numbers, root }
    }

    /// The points, in the order of the tree.
    #[must_use]
    pub fn points(&self) -> &[Vector<N>] {
        &self.points
    }

    /// The number of each of [`Self::points`] among the corners or vertices of the body.
    #[must_use]
    pub fn numbers(&self) -> &[usize] {
        &self.numbers
    }

    /// The point at which `square` is largest: the square of something, such as a distance, that
    /// from one place to another changes by at most `growth` per length.
    ///
    /// `square` is given a place, within the hull of the points, and a floor: where it is not above
    /// the floor it may return any number from itself up to the floor. Of points equally far any
    /// may be found, always the same for the same bits. The value found is the root.
    ///
    /// With a growth that is too small another point may be found. Cost: where one place stands
    /// out, evaluations at a small part of many points, on an ellipsoid of 10,000 at a tenth; at
    /// all of them where all tie.
    pub fn farthest_by(&self, growth: f64, square: impl Fn(Vector<N>, f64) -> f64) -> Farthest<N> {
        let mut search = Search { extremes: self, growth, square, best: (0, f64::NEG_INFINITY) };
        match &self.root.content {
            Content::Leaf(places) => search.scan(places.clone()),
            Content::Branches(branches) => search.descend(branches),
        }
        let (place, square) = search.best;
        Farthest {
            point: self.points[place],
            corner: Some(self.numbers[place]),
            value: square.sqrt(),
        }
    }
}

impl<const N: usize> Node<N> {
    /// The tree over the points with these numbers, which are sorted into its order; `first` is the
    /// place of the first one in the whole order.
    fn new(points: &[Vector<N>], numbers: &mut [usize], first: usize) -> Self {
        let along = |axis: usize| numbers.iter().map(move |&i| points[i][axis]);
        let low = Vector::<N>::from_fn(|axis| along(axis).fold(f64::INFINITY, f64::min));
        let high = Vector::<N>::from_fn(|axis| along(axis).fold(f64::NEG_INFINITY, f64::max));
        let center = low + (high - low) * 0.5;
        let distances = numbers.iter().map(|&i| (points[i] - center).scaled_norm());
        let radius = distances.fold(0.0, f64::max);
        if numbers.len() <= LEAF {
            return Self { center, radius, content: Content::Leaf(first..first + numbers.len()) };
        }
        let extent = high - low;
        let longest = (1..N).fold(0, |m, axis| if extent[axis] > extent[m] { axis } else { m });
        let middle = numbers.len() / 2;
        let order = |i: &usize, j: &usize| {
            points[*i][longest].total_cmp(&points[*j][longest]).then(i.cmp(j))
        };
        numbers.select_nth_unstable_by(middle, order);
        let (near, far) = numbers.split_at_mut(middle);
        let branches = [Self::new(points, near, first), Self::new(points, far, first + middle)];
        Self { center, radius, content: Content::Branches(Box::new(branches)) }
    }
}

/// The numbers of the extreme points of the plane; of a single one its own.
fn extreme_in_plane(points: &[Vector<2>]) -> Vec<usize> {
    let largest = points.iter().fold(0.0_f64, |m, p| m.max(p.max_abs()));
    let scale = if largest.is_normal() { unit_scale(largest) } else { 1.0 };
    let points: Vec<Vector<2>> = points.iter().map(|&p| p * scale).collect();
    match hull(&points, &sorted(&points)) {
        none if none.is_empty() => vec![0],
        extreme => extreme,
    }
}

/// A search for the largest square, and the best so far.
struct Search<'a, const N: usize, F> {
    extremes: &'a ExtremePoints<N>,
    growth: f64,
    square: F,
    best: (usize, f64),
}

impl<const N: usize, F: Fn(Vector<N>, f64) -> f64> Search<'_, N, F> {
    /// Looks at all points of a leaf.
    fn scan(&mut self, places: std::ops::Range<usize>) {
        let (mut place, mut largest) = self.best;
        for next in places {
            let square = (self.square)(self.extremes.points[next], largest);
            // What is not a number is to be seen, and stays.
            let larger = square > largest || square.is_nan();
            place = if larger { next } else { place };
            largest = if larger { square } else { largest };
        }
        self.best = (place, largest);
    }

    fn descend(&mut self, branches: &[Node<N>; 2]) {
        let bounds = branches.each_ref().map(|branch| self.bound(branch));
        let order = if bounds[0] >= bounds[1] { [0, 1] } else { [1, 0] };
        for branch in order {
            if bounds[branch] > self.best.1 || bounds[branch].is_nan() {
                match &branches[branch].content {
                    Content::Leaf(places) => self.scan(places.clone()),
                    Content::Branches(branches) => self.descend(branches),
                }
            }
        }
    }

    /// What no square in the node exceeds.
    fn bound(&self, node: &Node<N>) -> f64 {
        let rise = self.growth * node.radius;
        let room = (self.best.1.max(0.0).sqrt() - rise).max(0.0);
        let root = (self.square)(node.center, room * room).sqrt() + rise;
        root * root
    }
}
