//! How far a part reaches from a point.

/// The corner farthest from some point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reach {
    /// The number of the corner.
    pub corner: usize,
    /// Its distance, LBR's `rho_max` (length).
    pub distance: f64,
}
