//! The farthest site of a point, in logarithmic time.

use clench_screw::{Vector, planar};

use crate::triangulation::{Triangle, Triangulation, to_circumcenter, widest};

/// A triangle of the farthest triangulation, with the three parts of the plane about it.
///
/// From the circumcenter, the rays away from the three corners stay within the regions of these
/// corners, since a point moving straight away from its farthest site keeps it. So the rays divide
/// the plane into three sectors, and the farthest site of a point in the sector between two rays
/// is on the chain of the hull between the two corners. With the triangles in the order of a
/// centroid decomposition, each step leaves at most half of them.
#[derive(Clone, Debug, PartialEq)]
struct Node {
    /// The site with the widest angle first, then counter-clockwise.
    sites: [usize; 3],
    at: [Vector<2>; 3],
    /// The direction of the rays: to the circumcenter from each of the sites.
    away: [Vector<2>; 3],
    /// The node to go on with in the sector opposite each site, where any triangles are left.
    children: [Option<usize>; 3],
}

/// The nodes; the first is the root.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tree(Vec<Node>);

impl Tree {
    /// The search tree of a farthest triangulation. Cost: O(h log h).
    pub(crate) fn new(sites: &[Vector<2>], mesh: &Triangulation) -> Self {
        let triangles = mesh.triangles();
        let mut nodes: Vec<Node> = Vec::with_capacity(triangles.len());
        let mut used = vec![false; triangles.len()];
        let mut open: Vec<(usize, Option<(usize, usize)>)> = vec![(0, None)];
        while let Some((within, parent)) = open.pop() {
            let center = centroid(triangles, &used, within);
            used[center] = true;
            let (node, across) = Node::new(sites, &triangles[center]);
            let index = nodes.len();
            nodes.push(node);
            if let Some((above, slot)) = parent {
                nodes[above].children[slot] = Some(index);
            }
            for (slot, next) in across.into_iter().enumerate() {
                open.extend(next.filter(|&t| !used[t]).map(|t| (t, Some((index, slot)))));
            }
        }
        Self(nodes)
    }

    /// The site farthest from `point`, and its squared distance.
    ///
    /// The farthest of all sites met on the way is kept. A rounding can lead to the wrong side of a
    /// ray only near that ray, where its own site is farthest up to the rounding, and is kept.
    pub(crate) fn farthest(&self, point: Vector<2>) -> (usize, f64) {
        let (mut best, mut largest) = (self.0[0].sites[0], -1.0);
        let mut next = Some(0);
        while let Some(index) = next {
            let node = &self.0[index];
            let squared = node.at.map(|site| (point - site).norm_squared());
            for i in 0..3 {
                if squared[i] > largest {
                    (best, largest) = (node.sites[i], squared[i]);
                }
            }
            next = node.children[node.sector(point)];
        }
        (best, largest)
    }
}

impl Node {
    /// The node of a triangle without children, and the neighbors opposite its sites.
    fn new(sites: &[Vector<2>], triangle: &Triangle) -> (Self, [Option<usize>; 3]) {
        let at = triangle.corners.map(|c| sites[c]);
        let widest = widest(at);
        let turned: [usize; 3] = std::array::from_fn(|i| (widest + i) % 3);
        let node = Self {
            sites: turned.map(|i| triangle.corners[i]),
            at: turned.map(|i| at[i]),
            away: turned.map(|i| to_circumcenter(at, i)),
            children: [None; 3],
        };
        (node, turned.map(|i| triangle.across[i]))
    }

    /// The number of the site whose opposite sector `point` is in.
    ///
    /// The two sectors beside the widest angle are less than half a turn each: left of the first
    /// ray's line, right of the second's, and in front of the circumcenter. The third is the rest
    /// of the plane. Where two sites nearly coincide, the two lines round to one and do not tell
    /// front from back; there the site opposite is farther than both behind the circumcenter only.
    fn sector(&self, point: Vector<2>) -> usize {
        let offsets = self.at.map(|site| point - site);
        let left: [f64; 3] = std::array::from_fn(|i| planar::cross(self.away[i], offsets[i]));
        // Site k is farther than site i by this much, in squares, without cancellation.
        let excess = |k: usize, i: usize| (self.at[i] - self.at[k]).dot(offsets[i] + offsets[k]);
        let between = |i: usize, j: usize, k: usize| {
            left[i] >= 0.0 && left[j] <= 0.0 && (excess(k, i) <= 0.0 || excess(k, j) <= 0.0)
        };
        if between(2, 0, 1) {
            1
        } else if between(0, 1, 2) {
            2
        } else {
            0
        }
    }
}

/// The triangle whose removal leaves parts of at most half the size, among the unused triangles
/// connected with `start`.
fn centroid(triangles: &[Triangle], used: &[bool], start: usize) -> usize {
    // Each triangle with the place of the one it was reached from, and the size of its subtree.
    let mut found = vec![(start, 0, 1_usize)];
    let mut next = 0;
    while next < found.len() {
        let (t, parent, _) = found[next];
        let came_from = found[parent].0;
        for beside in triangles[t].across.into_iter().flatten() {
            if !used[beside] && beside != came_from {
                found.push((beside, next, 1));
            }
        }
        next += 1;
    }
    for i in (1..found.len()).rev() {
        let (t, parent, size) = found[i];
        if 2 * size >= found.len() {
            return t;
        }
        found[parent].2 += size;
    }
    start
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Misled {
        hull: [[f64; 2]; 4],
        point: [f64; 2],
    }

    /// Hulls with two corners a rounding apart, found by random search: each misled a search that
    /// compared lengths to find the widest angle, or distances to tell front from back.
    const MISLED: [Misled; 4] = [
        Misled {
            hull: [
                [-0.961_034_187_029_657_1, 0.276_429_541_402_950_9],
                [-0.208_963_156_857_603_55, -0.977_923_513_919_214_8],
                [-0.208_963_156_857_603_5, -0.977_923_513_919_214_7],
                [0.259_502_201_577_532_45, 0.965_742_516_086_153_1],
            ],
            point: [216.053_167_551_859_81, -331.575_834_586_320_64],
        },
        Misled {
            hull: [
                [-0.694_207_020_676_031_8, 0.719_775_390_274_013_3],
                [0.920_289_780_355_011_1, -0.391_237_421_745_575_9],
                [0.920_289_780_355_011_2, -0.391_237_421_745_575_7],
                [0.176_760_752_524_368_26, 0.984_253_847_524_620_1],
            ],
            point: [-0.096_502_458_278_581_45, -0.068_584_047_450_105_1],
        },
        Misled {
            hull: [
                [-0.807_541_675_400_070_8, 0.589_810_514_056_884_9],
                [-0.807_541_675_400_070_7, 0.589_810_514_056_884_8],
                [0.627_072_369_101_386_2, -0.778_961_002_816_941_4],
                [0.446_389_133_471_847_55, 0.894_838_947_251_545_8],
            ],
            point: [-15.735_784_346_767_314, -14.338_432_157_310_36],
        },
        Misled {
            hull: [
                [-0.900_966_944_034_496_6, 0.433_887_734_047_806_56],
                [-0.069_896_845_140_747_41, -0.997_554_224_611_058_6],
                [-0.069_896_845_140_747_34, -0.997_554_224_611_058_7],
                [0.081_792_869_598_777_82, 0.996_649_349_813_061],
            ],
            point: [-10.842_368_937_819_63, -7.730_349_282_535_362],
        },
    ];

    #[test]
    fn corners_a_rounding_apart_do_not_mislead_the_search() {
        for Misled { hull, point } in MISLED {
            let (sites, point) = (hull.map(Vector::from), Vector::from(point));
            let (_, squared) = Tree::new(&sites, &Triangulation::new(&sites)).farthest(point);
            let largest = sites.iter().fold(0.0_f64, |m, &at| m.max((point - at).norm_squared()));
            // The two corners that nearly coincide are equally far, to rounding.
            assert!(squared >= largest * (1.0 - 4.0 * f64::EPSILON), "{point:?}: {squared}");
        }
    }
}
