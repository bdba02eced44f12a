//! Best placements on the edges of a polygon.
//!
//! # Three fingers
//!
//! On a given triplet of edges the translational stiffness and the rotational stiffness are the
//! same for all placements whose normals meet in a point [LBR, proposition 5.1, with the finger's
//! radius]; what remains is to bring that point as near as possible to the part's geometric
//! center.
//!
//! # Four fingers on four stretches
//!
//! With `N` the 2 x 4 matrix of the columns `sqrt(k_i) n_i`, `Z` an orthonormal basis of its null
//! space, and `s_i = sqrt(k_i) gamma_i` (`gamma_i`: moment of the normal of finger `i`), every
//! placement is `s = N^T x + Z z`. The center of compliance is `d = J x` and the rotational
//! stiffness `mu = |z|^2` [LBR, eq. 18], so
//!
//! `mu_eq = |z|^2 / rho_max(d)^2` with `low_i <= a_i . d + Z_i . z <= high_i`,
//!
//! where `a_i = sqrt(k_i) J n_i`, and all `Z_i . (J z)` have one sign: they are the balancing
//! contact forces.
//!
//! 1. For a fixed `d`, `|z|^2` is convex in `z`, so it is largest at a corner of what is allowed:
//!    two constraints are active, and `z = z_0 + M d` is affine in `d`.
//! 2. On the part of such a face where one corner `v` of the outline is the farthest, the ratio
//!    `|z_0 + M d|^2 / |d - v|^2` compares two forms of rank 2 on the projective plane. Their
//!    pencil has the eigenvalues 0 (the minimum), infinity (`d = v`, which is never its own
//!    farthest corner) and one between, a saddle. So there is no maximum inside.
//! 3. The maximum lies on a line: an edge of the face, or a border between two regions of the
//!    farthest-corner partition. On a line the ratio of two quadratics is stationary where a
//!    quadratic vanishes.
//!
//! The optimum of a combination is thus the largest of finitely many closed forms. A least share of
//! the preload narrows the cone in `z`, a least distance on one edge is one more limit of `z`.
//!
//! # All combinations
//!
//! A node is a set of pieces of the boundary, one per finger: some stretches of edges with like
//! wrenches, one stretch, or a part of one. A finger's scaled wrench is `p = (a,
//! s)`, and the stiffness is `K = sum of p p^T`, so whatever is linear in `K` is a sum over the
//! fingers, and its largest value over the node is the sum of theirs: each is the largest value of
//! a quadratic form over the wrenches of one piece. Placements with a quality of `q` or more
//! fulfill, with `H = sum of a a^T`:
//!
//! - *translation*: `sum (a . u)^2 >= q` for any unit `u`;
//! - *rotation*: for any point `c`, corner `v` and vector `y`, with `l(x) = s - a . x`,
//!
//!   `sum l(c) l(c + 2 y) + |H y - q (c - v)|^2 / (sigma_min + q) >= q |c - v|^2`,
//!
//!   since `mu = sum l(c)^2 - e . H e` at the center of compliance `d = c + e`, `H e = sum l(c) a`,
//!   and what is left over in `mu - q |d - v|^2` is `2 (H y - q (c - v)) . e - e . (H + q) e`. With
//!   `y = q H^-1 (c - v)` for some `H` in the middle of the node the square is of second order in
//!   the node's size. Corners may be mixed: `|d - v|^2` is then a mean;
//! - *worst point*: `sum (p . t)^2 >= q |deflection of v by t|^2` for any twist `t` and corner `v`;
//! - *closure*: the balancing forces of four fingers are determinants of three wrenches each,
//!   linear but for terms of second order, and have one sign.
//!
//! A sum of these with weights that leaves no room over the node excludes it, as does a twist that
//! all forces on the node help. Weights come from a linear model of the node; what they are does
//! not matter for what is proved. All slack is of second order, so the number of nodes hardly
//! grows with that of the edges where the optimum is a smooth maximum.
//!
//! Nodes are opened best bound first, in rounds of a size that does not depend on the threads. With
//! four fingers a node of single stretches is solved in closed form; with more, and for the worst
//! point, stretches are halved on, and the search ends at a gap.

mod part;

mod fingers;
mod three;

mod springs;
mod triplets;

mod apart;
mod ascent;
mod bound;
mod closed_form;
mod crowded;

mod rating;
mod reason;
mod scene;
mod solution;
mod tips;

pub use fingers::{CROWDING_GAP, FEWEST_FINGERS, Fingers, MOST_FINGERS, fingers, four_fingers_on};
pub use part::{LARGEST_SPREAD, Part, SMOOTH_TURN, Stretch};
pub use three::{ThreeFingers, three_fingers, three_fingers_on};

#[cfg(test)]
mod tests;
