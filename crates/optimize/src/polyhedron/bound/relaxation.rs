//! Upper bounds over all placements of spring fingers on some pieces of the surface.

use clench_metrics::{EquivalentStiffness, Principal, WorstPoint};
use clench_screw::{Cholesky, Mat, SymmetricEigen, Vector, Wrench};

use super::closure::{Contacts, helps_all, normals_balance};
use super::cut::Cut;
use super::pieces::{Corners, Pieces};
use super::{ROUNDING, least_cylinder_squared};
use crate::Objective;
use crate::polyhedron::rating::{Rating, stiffness};
use crate::search::boxes::value;
use crate::search::{Bounded, Floor, Piece, above, below};

/// Cuts that are added where none is inherited, and where one is.
const FIRST_CUTS: usize = 16;
const NEXT_CUTS: usize = 4;

/// Steps of the golden section for the weight of a cut.
const SECTIONS: usize = 10;

/// The golden section.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// The bounds; see [`super`] for their derivation.
#[derive(Debug)]
pub(crate) struct Relaxation<'a> {
    rating: Rating<'a>,
    pieces: &'a Pieces<'a>,
    /// The square of a radius that no cylinder around the body falls below, times its axis' unit
    /// rotation: what any principal rotation moves the body by, at least.
    cylinder_squared: f64,
}

/// What a node hands on to its halves.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hint {
    cut: Cut,
    normals: Option<Normals>,
}

/// What is the same for all placements on one combination of patches.
#[derive(Clone, Copy, Debug)]
struct Normals {
    /// `K_11`, and the least and the largest that `sigma_min` can be, up to rounding.
    translational: Mat<3, 3>,
    sigma: (f64, f64),
}

/// A node with what is known of it.
struct Node<'a> {
    fingers: Vec<Corners<'a>>,
    fixed: &'a [(Vector<6>, f64)],
    /// Where all are known.
    normals: Option<Normals>,
    /// The sum of all stiffnesses, at most.
    size: f64,
}

impl Node<'_> {
    fn sigma(&self) -> f64 {
        self.normals.map_or(0.0, |normals| normals.sigma.0)
    }

    /// What no placement surpasses by a cut.
    fn bound(&self, cut: &Cut) -> f64 {
        let placed: f64 = self.fingers.iter().map(|corners| corners.largest(&cut.form)).sum();
        let fixed = self.fixed.iter();
        let fixed: f64 = fixed.map(|&(w, k)| value(&cut.form, Vector::ZERO, w) * k * k).sum();
        // Unit wrenches about the middle of the part have squares of at most 2.
        let rounding = ROUNDING * cut.form.max_abs() * 12.0 * self.size;
        cut.largest_objective(placed + fixed + rounding, self.sigma())
    }
}

impl<'a> Relaxation<'a> {
    pub(crate) fn new(rating: Rating<'a>, pieces: &'a Pieces<'a>) -> Self {
        let cylinder_squared = least_cylinder_squared(rating.scene.extremes.points());
        Self { rating, pieces, cylinder_squared }
    }

    /// The bound of a node; `None` when no placement on it exceeds `floor`.
    pub(crate) fn bound(
        &self,
        node: &[Piece],
        floor: &Floor,
        hint: Option<&Hint>,
    ) -> Option<Bounded<Hint>> {
        if self.is_crowded(node) {
            return None;
        }
        let known = self.node(node, hint)?;
        let most = self.largest_by_translation(&known);
        if most <= above(floor.quality) {
            return None;
        }
        let (bound, cut) = self.best_cut(&known, floor, hint.map(|hint| &hint.cut))?;
        let split = self.split(node, &known, &cut);
        let hint = Hint { cut, normals: known.normals };
        Some(Bounded { bound: bound.min(most), split, hint })
    }

    /// Whether too many fingers are on one patch.
    fn is_crowded(&self, node: &[Piece]) -> bool {
        let most = self.rating.scene.most_on_patch;
        let patch = |piece: Piece| self.pieces.patch(piece);
        (0..node.len()).any(|i| {
            let this = patch(node[i]);
            this.is_some() && node[..i].iter().filter(|&&p| patch(p) == this).count() >= most
        })
    }

    /// What is known of a node; `None` where contacts on it cannot balance, or hold too little.
    fn node(&self, node: &[Piece], hint: Option<&Hint>) -> Option<Node<'a>> {
        let Rating { scene, fingers } = self.rating;
        let corners: Vec<Corners<'a>> = node.iter().map(|&p| self.pieces.corners(p)).collect();
        let patches: Option<Vec<usize>> = node.iter().map(|&p| self.pieces.patch(p)).collect();
        let stiffest = |piece: &Piece| {
            let weights = self.pieces.patches(*piece).iter().map(|&p| scene.patches[p].weight);
            weights.fold(0.0, f64::max).powi(2)
        };
        let fixed_size: f64 = scene.fixed.iter().map(|&(_, weight)| weight * weight).sum();
        let size = match &patches {
            Some(known) => known.iter().map(|&p| scene.patches[p].weight.powi(2)).sum::<f64>(),
            None if node.len() < 64 => node.iter().map(stiffest).sum(),
            None => f64::INFINITY,
        } + fixed_size;
        let normals = match (hint.and_then(|hint| hint.normals), &patches) {
            (Some(normals), _) => Some(normals),
            (None, Some(patches)) => Some(self.normals(patches, size)?),
            (None, None) => None,
        };
        let weights: Vec<f64> = match &patches {
            Some(known) => known.iter().map(|&p| scene.patches[p].weight).collect(),
            None => vec![1.0; node.len()],
        };
        let least_share = if patches.is_some() { fingers.least_share } else { 0.0 };
        let contacts =
            Contacts { fingers: &corners, weights: &weights, fixed: &scene.fixed, least_share };
        if helps_all(&contacts) {
            return None;
        }
        Some(Node { fingers: corners, fixed: &scene.fixed, normals, size })
    }

    /// What is the same for all placements on these patches; `None` where their normals cannot
    /// balance, or hold too little.
    fn normals(&self, patches: &[usize], size: f64) -> Option<Normals> {
        let Rating { scene, fingers } = self.rating;
        let placed = patches.iter().map(|&p| (scene.patches[p].normal, scene.patches[p].weight));
        let fixed = scene.fixed.iter().map(|&(w, weight)| (force(w), weight));
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
        (sigma.0 > 0.0 && sigma.1 >= asked).then_some(Normals { translational, sigma })
    }

    /// What no placement surpasses, by its translational stiffness alone.
    fn largest_by_translation(&self, node: &Node<'_>) -> f64 {
        match (self.rating.fingers.objective, node.normals) {
            (Objective::Quality | Objective::WorstPoint, Some(normals)) => normals.sigma.1,
            _ => f64::INFINITY,
        }
    }

    /// The least bound by cuts that is found, and its cut; `None` when it is not above the floor.
    fn best_cut(&self, node: &Node<'_>, floor: &Floor, hint: Option<&Cut>) -> Option<(f64, Cut)> {
        let least = above(floor.quality);
        let mut best = hint.map(|cut| (node.bound(cut), *cut));
        // The weights of the corners of each finger, as if it were in many places at once.
        let even = |corners: &Corners<'_>| {
            let count = corners.all().len();
            vec![(count as f64).recip(); count]
        };
        let mut shares: Vec<Vec<f64>> = node.fingers.iter().map(even).collect();
        let steps = if hint.is_some() { NEXT_CUTS } else { FIRST_CUTS };
        for step in 0..steps {
            if best.as_ref().is_some_and(|(bound, _)| *bound <= least) {
                return None;
            }
            let Some(cut) = self.violated(node, &shares, floor.quality) else { break };
            best = Some(match best {
                None => (node.bound(&cut), cut),
                Some(best) => improved(node, best, &cut),
            });
            let Some((_, cut)) = &best else { break };
            // Each finger moves to where the cut is largest.
            let part = 2.0 / (step as f64 + 3.0);
            for (corners, shares) in node.fingers.iter().zip(&mut shares) {
                let rise = |p: &Vector<6>| value(&cut.form, Vector::ZERO, *p);
                let values: Vec<f64> = corners.all().iter().map(rise).collect();
                let top =
                    (0..values.len()).fold(0, |i, j| if values[j] > values[i] { j } else { i });
                shares.iter_mut().for_each(|share| *share *= 1.0 - part);
                shares[top] += part;
            }
        }
        match best {
            Some((bound, _)) if bound <= least => None,
            // Nothing is known: what is spread over corners holds nothing.
            None => Some((f64::INFINITY, Cut::plain(Mat::ZERO))),
            known => known,
        }
    }

    /// The cut that fingers spread over the corners with these weights violate most.
    fn violated(&self, node: &Node<'_>, shares: &[Vec<f64>], demand: f64) -> Option<Cut> {
        let spread = node.fingers.iter().zip(shares).flat_map(|(corners, shares)| {
            corners.all().iter().zip(shares).map(|(&p, share)| p * share.sqrt())
        });
        let fixed = node.fixed.iter().map(|&(wrench, weight)| wrench * weight);
        let principal = Principal::of(Vector::ZERO, &stiffness(spread.chain(fixed))).ok()?;
        let body = &self.rating.scene.extremes;
        let outer = |t: Vector<6>| Mat::outer(t, t);
        match self.rating.fingers.objective {
            Objective::WorstPoint => {
                let worst = WorstPoint::of(&principal, body).ok()?;
                let load = Wrench::of_force_at(worst.direction, worst.point);
                let twist = principal.displacement(Vector::ZERO, &load);
                let speed = twist.velocity_at(worst.point).norm();
                Some(Cut::plain(outer(joined(twist.linear, twist.angular) * speed.recip())))
            }
            Objective::Quality => {
                let (sigma, mu) = (principal.translational(), principal.rotational());
                if sigma.values[0] * self.cylinder_squared <= mu.values[0] {
                    let twist = joined(sigma.vectors[0], Vector::ZERO);
                    return Some(Cut::plain(outer(twist)));
                }
                Some(self.by_cylinder(&principal))
            }
            Objective::Rotation { .. } => {
                let Some(Normals { translational, .. }) = &node.normals else {
                    return Some(self.by_cylinder(&principal));
                };
                let softest = EquivalentStiffness::least(&principal, body).ok()?;
                let twist = principal.force_free_twist(softest.rotation);
                let velocity = twist.velocity_at(softest.farthest.point);
                let per_speed = velocity.norm().recip();
                let v = velocity * per_speed;
                // Sharpest for what the relaxation may reach.
                let q = demand.max(softest.value);
                let y = Cholesky::new(translational).ok()?.solve(v) * q;
                let t = joined(twist.linear, twist.angular) * per_speed;
                let form = Mat::outer(t, t + joined(y, Vector::ZERO) * 2.0).symmetric_part();
                let resisted = *translational * y;
                let (b, c) = (v.dot(resisted), resisted.norm_squared());
                Some(Cut { form, plain: 0.0, a: v.norm_squared(), b, c })
            }
        }
    }

    /// That the softest rotation has to move some point by the radius of a cylinder.
    fn by_cylinder(&self, principal: &Principal<3, 3>) -> Cut {
        let twist = principal.force_free_twist(principal.rotational().vectors[0]);
        let twist = joined(twist.linear, twist.angular);
        Cut::plain(Mat::outer(twist, twist) * self.cylinder_squared.recip())
    }

    /// The finger whose piece raises the bound most by its extent.
    fn split(&self, pieces: &[Piece], node: &Node<'_>, cut: &Cut) -> usize {
        let several = node.normals.is_none();
        let mut most = (0, f64::NEG_INFINITY);
        for (i, (corners, &piece)) in node.fingers.iter().zip(pieces).enumerate() {
            if self.pieces.halves(piece).is_none() {
                continue;
            }
            // Which patches first: all else is known better then.
            if several != (self.pieces.patches(piece).len() > 1) {
                continue;
            }
            let all = corners.all();
            let mean =
                all.iter().fold(Vector::ZERO, |sum, &p| sum + p) * (all.len() as f64).recip();
            let rise = corners.largest(&cut.form) - value(&cut.form, Vector::ZERO, mean);
            if rise > most.1 {
                most = (i, rise);
            }
        }
        most.0
    }
}

/// The better of a cut and its mean with another one, by a search for the weight of that.
fn improved(node: &Node<'_>, best: (f64, Cut), other: &Cut) -> (f64, Cut) {
    let (first, second) = (Sums::new(node, &best.1), Sums::new(node, other));
    let at = |part: f64| first.mixed_bound(part, &second, (&best.1, other), node.sigma());
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..SECTIONS {
        let (a, b) = (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
        if at(a) < at(b) {
            high = b;
        } else {
            low = a;
        }
    }
    let cut = best.1.mixed(0.5 * (low + high), other);
    let bound = node.bound(&cut);
    if bound < best.0 { (bound, cut) } else { best }
}

/// The values of a cut at all corners.
struct Sums {
    fingers: Vec<Vec<f64>>,
    fixed: f64,
}

impl Sums {
    fn new(node: &Node<'_>, cut: &Cut) -> Self {
        let at = |p: &Vector<6>| value(&cut.form, Vector::ZERO, *p);
        Self {
            fingers: node.fingers.iter().map(|f| f.all().iter().map(at).collect()).collect(),
            fixed: node.fixed.iter().map(|(w, weight)| at(w) * weight * weight).sum(),
        }
    }

    /// The bound, without rounding and the boxes of large groups, by a mean of two cuts.
    fn mixed_bound(&self, part: f64, other: &Self, cuts: (&Cut, &Cut), sigma: f64) -> f64 {
        let mean = |x: f64, y: f64| x * (1.0 - part) + y * part;
        let mut total = mean(self.fixed, other.fixed);
        for (these, those) in self.fingers.iter().zip(&other.fingers) {
            let all = these.iter().zip(those).map(|(&x, &y)| mean(x, y));
            total += all.fold(f64::NEG_INFINITY, f64::max);
        }
        let (this, that) = cuts;
        let constants = Cut {
            form: Mat::ZERO,
            plain: mean(this.plain, that.plain),
            a: mean(this.a, that.a),
            b: mean(this.b, that.b),
            c: mean(this.c, that.c),
        };
        constants.largest_objective(total, sigma)
    }
}

/// The first three components of a wrench.
fn force(wrench: Vector<6>) -> Vector<3> {
    Vector::new([wrench[0], wrench[1], wrench[2]])
}

/// A twist with these parts.
fn joined(linear: Vector<3>, angular: Vector<3>) -> Vector<6> {
    let ([a, b, c], [d, e, f]) = (linear.to_array(), angular.to_array());
    Vector::new([a, b, c, d, e, f])
}
