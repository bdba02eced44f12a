//! Best placements on the faces of a solid.
//!
//! Each finger is a spring along the normal of a facet, `k` its stiffness; its scaled wrench is
//! `p = sqrt(k) (n, x cross n)`, about the middle of the part. The stiffness is `K = sum of p p^T`,
//! and on a facet `p` is affine in the contact point `x`. The normals of a combination of facets
//! decide the translational stiffness `K_11`, whatever the points.
//!
//! # Upper bounds
//!
//! A node is a set of pieces of the surface, one per finger: some facets with like wrenches, one
//! facet, or a triangle of one. Whatever is linear in `K` is a sum over the fingers. For a twist
//! `t = (w, omega)` and the velocity `v` that it gives a body point, placements with an objective
//! of `q` or more fulfill
//!
//! - worst point: `sum of (p . t)^2 >= q |v|^2`, since no force at that point moves it by more than
//!   `1 / q` of itself;
//! - rotation: with the force-free twist `t - (e, 0)` that has the same rotation,
//!   `t^T K t - e . K_11 e >= q |v - e|^2`. Any multiple of `f - K_11 e = 0` may be added, where
//!   the force `f` of `t` is linear in `K`: for any vector `y`
//!
//!   `sum of (p . t) (p . (t + 2 (y, 0))) >= q |v|^2 - g . (K_11 + q)^-1 g`, `g = K_11 y - q v`,
//!
//!   where the least over all `e` was taken. With `y = q K_11^-1 v`, known on a combination of
//!   facets, the last term vanishes;
//! - quality: `sum of (p . (u, 0))^2 >= q` for a unit vector `u`, and, since each principal
//!   rotation moves some point by the radius `r` of a cylinder around the body at least,
//!   `sum of (p . t)^2 >= q r^2 |omega|^2`. The latter holds for rotation as well, on any node.
//!
//! Each left side is a sum of functions that are convex in the contact points, also where
//! inequalities are added up with weights, so each finger's share is largest at a corner of its
//! piece. The largest `q` that the sum of these allows is a bound. Weights come from a game:
//! fingers spread over the corners of their pieces against the twist that they resist least. What
//! the weights are does not matter for what is proved; a node hands its own on to its halves.
//!
//! Pieces on which all forces help some twist are excluded, and so are combinations whose normals
//! cannot balance with all fingers pushing.
//!
//! The bound of a node is that of fingers in several places at once, with a part of their stiffness
//! in each. Seven fingers have 14 coordinates, and until all are known to a fraction of the part's
//! size that is far from what seven springs can do: searches for many free fingers end by time,
//! with a gap of some ten percent. With up to three free fingers beside given ones they close, but
//! for the quality, whose bound by a cylinder need not come down to it.
//!
//! Pieces on which two fingers are always nearer to each other than their tips have room are
//! excluded as well. Where that is in doubt, and halving a piece would hardly change the bound, the
//! largest piece in doubt is halved.
//!
//! # Placements
//!
//! Ascents start by chance, with seeds that depend on nothing but their number. Random steps come
//! near a summit; then linear programs find it: near a placement the objective is the least of
//! smooth functions, one for each point and direction that give way, and the shares of the preload
//! have to stay positive.

mod part;
mod touch;

mod fingers;
mod tips;

mod search;

mod ascent;
mod summit;

mod bound;

mod rating;
mod round;
mod scene;
mod solution;
mod vectors;

mod motion;

pub(crate) use motion::described;

pub use fingers::{
    FEWEST_CONTACTS, Fingers, MOST_CONTACTS, MOST_FINGERS, PUSHING, ROUNDNESS, Spacing, fingers,
    fingers_among,
};
pub use part::Part;
pub use touch::{Touch, TouchKind};

#[cfg(test)]
mod tests;
