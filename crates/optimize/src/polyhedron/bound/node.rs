//! What is known of all placements on some pieces of the surface.

use clench_screw::{Mat, SymmetricEigen, Vector};

use super::ROUNDING;
use super::closure::{Contacts, helps_all, normals_balance};
use super::cut::Cut;
use super::pieces::{Corners, Pieces};
use crate::polyhedron::rating::Rating;
use crate::polyhedron::vectors::first;
use crate::search::boxes::value;
use crate::search::{Piece, below};

/// What is the same for all placements on one combination of patches.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Normals {
    /// `K_11`.
    pub(super) translational: Mat<3, 3>,
    /// The least and the largest that `sigma_min` can be, by its rounding.
    pub(super) sigma: (f64, f64),
}

/// Pieces that fingers are on, one each, and the given contacts.
#[derive(Clone, Debug)]
pub(super) struct Node<'a> {
    pub(super) fingers: Vec<Corners<'a>>,
    pub(super) fixed: &'a [(Vector<6>, f64)],
    /// Where each finger is on one patch.
    pub(super) normals: Option<Normals>,
    /// The sum of all stiffnesses, at most.
    size: f64,
    /// The square of the longest unit wrench.
    largest_square: f64,
}

impl<'a> Node<'a> {
    /// The node of some pieces, with the normals of the one that it is a half of; `None` where too
    /// many fingers are on one patch or too near to each other, where contacts cannot balance, or
    /// hold too little.
    pub(super) fn new(
        rating: Rating<'a>,
        pieces: &'a Pieces<'a>,
        node: &[Piece],
        known: Option<Normals>,
    ) -> Option<Self> {
        let scene = rating.scene;
        let patches: Vec<Option<usize>> = node.iter().map(|&p| pieces.patch(p)).collect();
        if is_crowded(&patches, scene.most_on_patch) {
            return None;
        }
        if pieces.centers(node).is_some_and(|(tips, centers)| tips.are_never_apart(&centers)) {
            return None;
        }
        let stiffest = |piece: &Piece| {
            let weights = pieces.patches(*piece).iter().map(|&p| scene.patches[p].weight);
            weights.fold(0.0, f64::max)
        };
        // Shares are those of unit wrenches, and known where the stiffness is.
        let weights: Vec<f64> = node.iter().map(stiffest).collect();
        let given = scene.fixed.iter().map(|&(_, weight)| weight);
        let size = weights.iter().copied().chain(given).map(|weight| weight * weight).sum();
        let patches: Option<Vec<usize>> = patches.into_iter().collect();
        let normals = match (known, &patches) {
            (Some(normals), _) => Some(normals),
            (None, Some(patches)) => Some(Normals::new(rating, patches, size)?),
            (None, None) => None,
        };
        let fingers: Vec<_> = node.iter().map(|&p| pieces.corners(p)).collect();
        let least_share = if normals.is_some() { rating.fingers.least_share } else { 0.0 };
        let contacts = Contacts {
            fingers: &fingers,
            weights: &weights,
            fixed: &scene.fixed,
            least_share,
            longest: scene.longest_wrench,
        };
        if helps_all(&contacts) {
            return None;
        }
        let largest_square = scene.longest_wrench * scene.longest_wrench;
        Some(Self { fingers, fixed: &scene.fixed, normals, size, largest_square })
    }

    /// A lower bound of `sigma_min`.
    pub(super) fn sigma(&self) -> f64 {
        self.normals.map_or(0.0, |normals| normals.sigma.0)
    }

    /// No placement has a larger `sigma_min`: where normals are not known, it is no more than the
    /// mean of the three principal stiffnesses, whose sum is that of all stiffnesses.
    pub(super) fn largest_translation(&self) -> f64 {
        let mean = self.size * ((1.0 + ROUNDING) / 3.0);
        self.normals.map_or(mean, |normals| normals.sigma.1)
    }

    /// What no placement surpasses by a cut.
    pub(super) fn bound(&self, cut: &Cut) -> f64 {
        let placed: f64 = self.fingers.iter().map(|corners| corners.largest(&cut.form)).sum();
        let fixed = self.fixed.iter();
        let fixed: f64 = fixed.map(|&(w, k)| value(&cut.form, Vector::ZERO, w) * k * k).sum();
        let rounding = ROUNDING * cut.form.max_abs() * 6.0 * self.largest_square * self.size;
        cut.limits.largest_objective(placed + fixed + rounding, self.sigma())
    }
}

impl Normals {
    /// `None` where the normals of these patches cannot balance, or hold too little.
    fn new(rating: Rating<'_>, patches: &[usize], size: f64) -> Option<Self> {
        let Rating { scene, fingers } = rating;
        let placed = patches.iter().map(|&p| (scene.patches[p].normal, scene.patches[p].weight));
        let fixed = scene.fixed.iter().map(|&(w, weight)| (first(w), weight));
        let all: Vec<_> = placed.chain(fixed).collect();
        let normals: Vec<_> = all.iter().map(|&(n, _)| n).collect();
        if !normals_balance(&normals) {
            return None;
        }
        let translational = all
            .iter()
            .fold(Mat::ZERO, |sum, &(n, weight)| sum + Mat::outer(n, n) * (weight * weight));
        let least = SymmetricEigen::new(&translational).ok()?.values[0];
        let rounding = ROUNDING * size;
        let asked = below(fingers.objective.least_translation() / scene.stiffness_unit);
        let sigma = (least - rounding, least + rounding);
        (sigma.0 > 0.0 && sigma.1 >= asked).then_some(Self { translational, sigma })
    }
}

/// Whether more than so many fingers are on one patch.
fn is_crowded(patches: &[Option<usize>], most: usize) -> bool {
    let on = |patch: Option<usize>| patches.iter().filter(|&&p| p == patch).count();
    patches.iter().any(|&patch| patch.is_some() && on(patch) > most)
}
