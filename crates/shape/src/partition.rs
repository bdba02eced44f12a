//! The regions of the plane with one farthest corner each.

use clench_screw::Vector;

use crate::border::border;
use crate::stretch::Stretches;
use crate::tree::Tree;
use crate::triangulation::Triangulation;
use crate::{Border, Reach, Stretch};

/// Up to this many corners of the hull a scan over all of them is quicker than the tree.
///
/// Measured for random points about random convex outlines, scan against tree: 21 ns against 26 at
/// 24 corners, 29 against 28 at 32, 48 against 30 at 48, 1400 against 100 at 1000.
const SCAN_LIMIT: usize = 32;

/// The farthest-corner partition of the plane: the convex regions `R_i` of [LBR, section 5].
///
/// Each corner of the hull has one region, where it is the farthest; all are unbounded. A corner
/// inside the hull is never farthest and has none.
#[derive(Clone, Debug, PartialEq)]
pub struct FarthestPartition {
    corners: Vec<usize>,
    sites: Vec<Vector<2>>,
    borders: Vec<Border>,
    regions: Vec<Region>,
    /// None when there are few sites.
    tree: Option<Tree>,
}

/// The region of one farthest corner.
#[derive(Clone, Debug, PartialEq)]
pub struct Region {
    /// The number of the corner.
    pub corner: usize,
    /// Its borders, counter-clockwise about the region: places in
    /// [`FarthestPartition::borders`]. The first and the last are rays.
    pub borders: Vec<usize>,
}

impl FarthestPartition {
    /// The partition for a hull's corners, counter-clockwise, and their farthest triangulation.
    pub(crate) fn new(corners: &[usize], sites: Vec<Vector<2>>, mesh: &Triangulation) -> Self {
        let (borders, numbers) = borders(corners, &sites, mesh);
        let regions = (0..sites.len())
            .map(|site| Region { corner: corners[site], borders: around(site, mesh, &numbers) })
            .collect();
        let tree = (sites.len() > SCAN_LIMIT).then(|| Tree::new(&sites, mesh));
        Self { corners: corners.to_vec(), sites, borders, regions, tree }
    }

    /// The regions, in the order of the hull.
    #[must_use]
    pub fn regions(&self) -> &[Region] {
        &self.regions
    }

    /// The borders between regions, each once.
    ///
    /// There are `2 h - 3` for `h` corners of the hull, `h` of them rays. Where more than three
    /// corners are on one circle, to rounding, borders shrink to points and are left out.
    #[must_use]
    pub fn borders(&self) -> &[Border] {
        &self.borders
    }

    /// The corner farthest from `point`; see [`Polygon::farthest`](crate::Polygon::farthest).
    #[must_use]
    pub(crate) fn farthest(&self, point: Vector<2>) -> Reach {
        let (site, squared) = self.farthest_site(point);
        Reach { corner: self.corners[site], distance: squared.sqrt() }
    }

    /// The farthest corners along a segment; see
    /// [`Polygon::farthest_along`](crate::Polygon::farthest_along).
    pub(crate) fn farthest_along(
        &self,
        start: Vector<2>,
        end: Vector<2>,
    ) -> impl Iterator<Item = Stretch> {
        let (first, _) = self.farthest_site(start);
        Stretches::new((&self.sites, &self.corners), first, start, end - start)
    }

    fn farthest_site(&self, point: Vector<2>) -> (usize, f64) {
        match &self.tree {
            Some(tree) => tree.farthest(point),
            None => scan(&self.sites, point),
        }
    }
}

/// The farthest site and its squared distance, by looking at all; the first of several.
fn scan(sites: &[Vector<2>], point: Vector<2>) -> (usize, f64) {
    let mut best = (0, -1.0);
    for (site, &at) in sites.iter().enumerate() {
        let squared = (point - at).norm_squared();
        if squared > best.1 {
            best = (site, squared);
        }
    }
    best
}

/// For each side of each triangle the number of its border, where it has one.
type BorderNumbers = Vec<[Option<usize>; 3]>;

/// The borders dual to the sides of the triangles.
fn borders(
    corners: &[usize],
    sites: &[Vector<2>],
    mesh: &Triangulation,
) -> (Vec<Border>, BorderNumbers) {
    let triangles = mesh.triangles();
    let mut borders = Vec::with_capacity(2 * sites.len());
    let mut numbers: BorderNumbers = vec![[None; 3]; triangles.len()];
    for (t, triangle) in triangles.iter().enumerate() {
        for i in 0..3 {
            let across = triangle.across[i];
            if across.is_some_and(|other| other < t) {
                continue;
            }
            let beyond = across.map(|other| &triangles[other]);
            let Some(found) = border((sites, corners), triangle, i, beyond) else {
                continue;
            };
            numbers[t][i] = Some(borders.len());
            if let Some(other) = across {
                let side = triangles[other].across.iter().position(|&back| back == Some(t));
                numbers[other][side.unwrap_or_default()] = Some(borders.len());
            }
            borders.push(found);
        }
    }
    (borders, numbers)
}

/// The numbers of the borders of a site's region, counter-clockwise.
///
/// The region is on the far side of the plane, turned by half a turn, so that its borders come in
/// the order of the sides at the site, from the hull's side after it to the one before.
fn around(site: usize, mesh: &Triangulation, numbers: &BorderNumbers) -> Vec<usize> {
    let mut at = Some(mesh.outer(site));
    let mut borders = Vec::new();
    let mut first = true;
    while let Some(t) = at {
        let triangle = &mesh.triangles()[t];
        let i = triangle.index_of(site);
        if first {
            borders.extend(numbers[t][(i + 2) % 3]);
            first = false;
        }
        borders.extend(numbers[t][(i + 1) % 3]);
        at = triangle.across[(i + 1) % 3];
    }
    borders
}
