//! Best placements on the edges of a polygon.
//!
//! # Three fingers
//!
//! On a given triplet of edges the translational stiffness and the rotational stiffness are the
//! same for all placements whose normals meet in a point [LBR, proposition 5.1, with the finger's
//! radius]; what remains is to bring that point as near as possible to the part's geometric
//! center.
//!
//! # Four fingers
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
//! The optimum of a combination is thus the largest of finitely many closed forms.

mod part;
mod solution;

mod three;

mod four;
mod quadruple;
mod ratio;

mod search;

mod convex;
mod edge_sets;
mod leaders;
mod scene;

pub use four::{FourFingers, four_fingers, four_fingers_on};
pub use part::{LARGEST_SPREAD, Part};
pub use three::{ThreeFingers, three_fingers, three_fingers_on};
