//! Pieces of the surface: a binary tree over patches and their triangles.
#![allow(
    clippy::cast_possible_truncation,
    reason = "there are fewer than twice as many groups as triangles, which are in memory"
)]

use std::ops::Range;

use clench_screw::{Mat, Vector};

use crate::polyhedron::rating::Spot;
use crate::polyhedron::scene::{Patch, Scene};
use crate::polyhedron::tips::{Centers, Tips};
use crate::search::Piece;
use crate::search::boxes::{arrange, largest_in_box, principal_box, value};

/// Groups with up to this many corners are looked at one by one instead of by their box.
const SCAN_LIMIT: usize = 48;

/// A node of the tree: some patches, a patch, or some triangles of one.
#[derive(Clone, Debug)]
struct Group {
    /// Its patches, of [`Pieces::order`].
    patches: Range<u32>,
    /// The corners of its hull, of [`Pieces::corners`]; of a large group, some of them.
    corners: Range<u32>,
    /// The box of a large group, of [`Pieces::boxes`].
    in_box: Option<u32>,
    /// The two halves; none of a single triangle or point.
    halves: Option<[u32; 2]>,
    /// The triangle, if it is one.
    triangle: Option<[Vector<3>; 3]>,
}

/// Where a group's wrenches are, and its stiffnesses.
#[derive(Clone, Copy, Debug)]
struct Enclosed {
    center: Vector<6>,
    axes: [Vector<6>; 6],
}

/// The wrenches at the corners of a piece, by which a convex function over it is bounded.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Corners<'a> {
    few: [Vector<6>; 3],
    many: Option<&'a [Vector<6>]>,
    in_box: Option<&'a Enclosed>,
}

impl Corners<'_> {
    /// The corners; of a large group some of them.
    pub(crate) fn all(&self) -> &[Vector<6>] {
        self.many.unwrap_or(&self.few)
    }

    /// An upper bound of `p^T form p`, where that is convex along each patch.
    pub(crate) fn largest(&self, form: &Mat<6, 6>) -> f64 {
        if let Some(Enclosed { center, axes }) = self.in_box {
            return largest_in_box(form, Vector::ZERO, *center, axes);
        }
        let values = self.all().iter().map(|&p| value(form, Vector::ZERO, p));
        values.fold(f64::NEG_INFINITY, f64::max)
    }

    /// A lower bound of `linear . p`.
    pub(crate) fn least_linear(&self, linear: Vector<6>) -> f64 {
        if let Some(Enclosed { center, axes }) = self.in_box {
            let spread: f64 = axes.iter().map(|axis| axis.dot(linear).abs()).sum();
            return center.dot(linear) - spread;
        }
        self.all().iter().map(|p| p.dot(linear)).fold(f64::INFINITY, f64::min)
    }
}

/// All groups; the first is the whole surface.
#[derive(Clone, Debug)]
pub(crate) struct Pieces<'a> {
    patches: &'a [Patch],
    groups: Vec<Group>,
    order: Vec<usize>,
    corners: Vec<Vector<6>>,
    boxes: Vec<Enclosed>,
    /// Where the tips of fingers on each group are, if that matters.
    centers: Option<(&'a Tips, Vec<Centers>)>,
}

impl<'a> Pieces<'a> {
    pub(crate) fn new(scene: &'a Scene<'_>) -> Self {
        let patches = &scene.patches[..];
        let middles: Vec<_> = patches.iter().map(|patch| patch.wrench(patch.middle())).collect();
        let mut order: Vec<_> = (0..patches.len()).collect();
        arrange(&middles, &mut order);
        let (groups, corners, boxes) = (Vec::new(), Vec::new(), Vec::new());
        let mut tree = Self { patches, groups, order, corners, boxes, centers: None };
        tree.grow(0, patches.len());
        tree.centers = scene.tips.as_ref().map(|tips| (tips, tree.all_centers(tips)));
        tree
    }

    /// The centers of all groups: halves come after what they are halves of.
    fn all_centers(&self, tips: &Tips) -> Vec<Centers> {
        let mut centers: Vec<Centers> = Vec::with_capacity(self.groups.len());
        for group in self.groups.iter().rev() {
            // The last group is the first of the list.
            let of = |half: u32| centers[self.groups.len() - 1 - half as usize];
            let number = self.order[group.patches.start as usize];
            let patch = &self.patches[number];
            centers.push(match (group.halves, &group.triangle) {
                (Some([one, other]), _) => of(one).joined(of(other)),
                (None, Some(triangle)) => tips.centers(patch, number, triangle),
                (None, None) => tips.centers(patch, number, &patch.corners),
            });
        }
        centers.reverse();
        centers
    }

    /// Where tips have to be apart: where those of fingers on these pieces are.
    pub(crate) fn centers(&self, node: &[Piece]) -> Option<(&'a Tips, Vec<Centers>)> {
        let (tips, centers) = self.centers.as_ref()?;
        let of = |&piece: &Piece| {
            let group = &self.groups[piece.group()];
            match group.triangle.filter(|_| piece.part() > 1) {
                Some(triangle) => {
                    let number = self.patches(piece)[0];
                    let corners = part_of(triangle, piece.part());
                    tips.centers(&self.patches[number], number, &corners)
                }
                None => centers[piece.group()],
            }
        };
        Some((tips, node.iter().map(of).collect()))
    }

    /// The group of the patches from `first` to before `end` of the order.
    fn grow(&mut self, first: usize, end: usize) -> u32 {
        if end - first == 1 {
            return self.grow_patch(first);
        }
        let place = self.groups.len();
        let wrenches: Vec<Vector<6>> = self.order[first..end]
            .iter()
            .flat_map(|&i| {
                let patch = &self.patches[i];
                patch.corners.iter().map(|&x| patch.wrench(x))
            })
            .collect();
        self.add((first, end), &wrenches, None);
        let middle = usize::midpoint(first, end);
        let halves = [self.grow(first, middle), self.grow(middle, end)];
        self.groups[place].halves = Some(halves);
        place as u32
    }

    /// The group of one patch, and those of its triangles.
    fn grow_patch(&mut self, at: usize) -> u32 {
        let place = self.groups.len();
        let patch = &self.patches[self.order[at]];
        let wrenches: Vec<_> = patch.corners.iter().map(|&x| patch.wrench(x)).collect();
        let mut order: Vec<_> = (0..patch.triangles.len()).collect();
        if let [triangle] = patch.triangles[..] {
            self.add((at, at + 1), &wrenches, Some(triangle));
        } else {
            self.add((at, at + 1), &wrenches, None);
            let middles: Vec<_> =
                patch.triangles.iter().map(|[a, b, c]| (*a + *b + *c) * (1.0 / 3.0)).collect();
            arrange(&middles, &mut order);
            if let Some(middle) = order.len().checked_div(2).filter(|&middle| middle > 0) {
                let (left, right) = order.split_at(middle);
                let halves = [self.grow_triangles(at, left), self.grow_triangles(at, right)];
                self.groups[place].halves = Some(halves);
            }
        }
        place as u32
    }

    fn grow_triangles(&mut self, at: usize, order: &[usize]) -> u32 {
        let place = self.groups.len();
        let patch = &self.patches[self.order[at]];
        let triangles = order.iter().map(|&t| patch.triangles[t]);
        let wrenches: Vec<_> = triangles.flatten().map(|x| patch.wrench(x)).collect();
        if let [one] = order {
            self.add((at, at + 1), &wrenches, Some(patch.triangles[*one]));
        } else {
            self.add((at, at + 1), &wrenches, None);
            let (left, right) = order.split_at(order.len() / 2);
            let halves = [self.grow_triangles(at, left), self.grow_triangles(at, right)];
            self.groups[place].halves = Some(halves);
        }
        place as u32
    }

    fn add(
        &mut self,
        (first, end): (usize, usize),
        wrenches: &[Vector<6>],
        triangle: Option<[Vector<3>; 3]>,
    ) {
        let from = self.corners.len();
        let mut in_box = None;
        if wrenches.len() > SCAN_LIMIT {
            let (center, axes) = principal_box(wrenches, Vector::from_fn(|_| 1.0));
            in_box = Some(self.boxes.len() as u32);
            self.boxes.push(Enclosed { center, axes });
            // Those at the ends of the box, so that what they span is what all span, and others.
            for axis in axes {
                let by_axis = |p: &&Vector<6>, q: &&Vector<6>| p.dot(axis).total_cmp(&q.dot(axis));
                self.corners.extend(wrenches.iter().min_by(by_axis));
                self.corners.extend(wrenches.iter().max_by(by_axis));
            }
            let stride = wrenches.len().div_ceil(SCAN_LIMIT - 12);
            self.corners.extend(wrenches.iter().step_by(stride));
        } else {
            self.corners.extend(wrenches);
        }
        self.groups.push(Group {
            patches: first as u32..end as u32,
            corners: from as u32..self.corners.len() as u32,
            in_box,
            halves: None,
            triangle,
        });
    }

    /// The patches of a piece.
    pub(crate) fn patches(&self, piece: Piece) -> &[usize] {
        let Range { start, end } = self.groups[piece.group()].patches;
        &self.order[start as usize..end as usize]
    }

    /// The patch of a piece that is of one.
    pub(crate) fn patch(&self, piece: Piece) -> Option<usize> {
        match self.patches(piece) {
            [one] => Some(*one),
            _ => None,
        }
    }

    /// Whether nothing of a piece is left to halve.
    pub(crate) fn is_point(&self, piece: Piece) -> bool {
        let group = &self.groups[piece.group()];
        group.halves.is_none() && group.triangle.is_none()
    }

    /// The two halves of a piece; `None` where there is nothing left to halve.
    pub(crate) fn halves(&self, piece: Piece) -> Option<[Piece; 2]> {
        let group = &self.groups[piece.group()];
        match group.halves {
            Some(halves) => Some(halves.map(Piece::whole)),
            None => group.triangle.and_then(|_| piece.halves()),
        }
    }

    /// The corners of a piece, as wrenches.
    pub(crate) fn corners(&self, piece: Piece) -> Corners<'_> {
        let group = &self.groups[piece.group()];
        let (few, in_box) = ([Vector::ZERO; 3], group.in_box.map(|i| &self.boxes[i as usize]));
        if piece.part() > 1
            && let Some(triangle) = group.triangle
        {
            let patch = &self.patches[self.patches(piece)[0]];
            let few = part_of(triangle, piece.part()).map(|x| patch.wrench(x));
            return Corners { few, many: None, in_box: None };
        }
        let Range { start, end } = group.corners;
        Corners { few, many: Some(&self.corners[start as usize..end as usize]), in_box }
    }

    /// Whether a spot is on a piece, to rounding.
    #[cfg(test)]
    pub(crate) fn holds(&self, piece: Piece, spot: &Spot) -> bool {
        let patch = &self.patches[spot.patch];
        let group = &self.groups[piece.group()];
        if !self.patches(piece).contains(&spot.patch) {
            return false;
        }
        match (group.triangle, group.halves) {
            (Some(triangle), _) => {
                crate::polyhedron::tests::is_on(patch, &part_of(triangle, piece.part()), spot)
            }
            (None, Some(halves)) => halves.iter().any(|&half| self.holds(Piece::whole(half), spot)),
            (None, None) => true,
        }
    }

    /// A place near the middle of a piece.
    pub(crate) fn middle(&self, piece: Piece) -> Spot {
        let patches = self.patches(piece);
        let number = patches[patches.len() / 2];
        let patch = &self.patches[number];
        let point = match self.groups[piece.group()].triangle {
            Some(triangle) => {
                let [a, b, c] = part_of(triangle, piece.part());
                (a + b + c) * (1.0 / 3.0)
            }
            None => patch.middle(),
        };
        Spot { patch: number, point }
    }
}

/// The dyadic part of a triangle: each time the half of its longest edge is taken.
fn part_of(mut triangle: [Vector<3>; 3], part: u64) -> [Vector<3>; 3] {
    let depth = part.ilog2();
    for level in (0..depth).rev() {
        let length = |i: usize| {
            let (a, b) = (triangle[(i + 1) % 3], triangle[(i + 2) % 3]);
            (a - b).norm_squared()
        };
        let longest = (1..3).fold(0, |i, j| if length(j) > length(i) { j } else { i });
        let [apex, a, b] = [0, 1, 2].map(|i| triangle[(longest + i) % 3]);
        let middle = (a + b) * 0.5;
        triangle = if part >> level & 1 == 0 { [apex, a, middle] } else { [apex, middle, b] };
    }
    triangle
}
