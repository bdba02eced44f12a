//! Repeatable random input.

/// A seeded source of numbers; prints its seed, so that a failing test can be run again.
#[derive(Debug)]
pub struct Random(fastrand::Rng);

impl Random {
    /// The source with the given seed.
    #[must_use]
    #[expect(clippy::print_stdout, reason = "a failing test shows which seed it had")]
    pub fn new(seed: u64) -> Self {
        println!("random seed {seed}");
        Self(fastrand::Rng::with_seed(seed))
    }

    /// A number between `low` and `high`, evenly spread.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.0.f64()
    }

    /// A whole number from 0 to `end`, exclusive.
    pub fn below(&mut self, end: usize) -> usize {
        self.0.usize(..end)
    }

    /// `N` numbers between `-size` and `size`.
    pub fn array<const N: usize>(&mut self, size: f64) -> [f64; N] {
        std::array::from_fn(|_| self.between(-size, size))
    }

    /// The corners of a star-shaped outline about the origin, counter-clockwise, radius 1 to 3.
    ///
    /// Each corner has its own sector of the full turn, so that neither edges of zero length nor
    /// crossings occur; most outlines with more than four corners are not convex.
    pub fn star(&mut self, corners: usize) -> Vec<[f64; 2]> {
        let sector = std::f64::consts::TAU / corners as f64;
        (0..corners)
            .map(|i| {
                let angle = sector * (i as f64 + self.between(0.1, 0.9));
                let radius = self.between(1.0, 3.0);
                [radius * angle.cos(), radius * angle.sin()]
            })
            .collect()
    }

    /// The corners of a convex outline: points in angular order on an ellipse, counter-clockwise.
    pub fn convex(&mut self, corners: usize) -> Vec<[f64; 2]> {
        let (a, b) = (self.between(1.0, 3.0), self.between(1.0, 3.0));
        let sector = std::f64::consts::TAU / corners as f64;
        (0..corners)
            .map(|i| {
                let angle = sector * (i as f64 + self.between(0.1, 0.9));
                [a * angle.cos(), b * angle.sin()]
            })
            .collect()
    }
}
