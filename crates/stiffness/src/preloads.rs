//! Which contact forces balance by themselves, and whether the contacts can hold the body.

use faer::Mat;
use microlp::{ComparisonOp, OptimizationDirection, Problem};

use crate::{Grasp, GraspError};

/// A singular value below this many units of rounding of the largest, per row and column, counts
/// as zero: the entries of the wrench map are rounded by a few units each.
const ZERO_SINGULAR_VALUE: f64 = 4.0 * f64::EPSILON;

/// A margin below this many units of rounding, per contact, counts as zero: it is the least of
/// forces that sum to 1, each a combination of as many rounded entries as there are contacts.
const ZERO_MARGIN: f64 = 16.0 * f64::EPSILON;

/// A coefficient of the linear program below this, per contact, is rounding of a unit vector, and
/// would only spoil the program's scaling.
const ZERO_COEFFICIENT: f64 = f64::EPSILON;

/// The contact forces that balance by themselves: the null space of the wrench map.
///
/// The wrench map has one column `(n, b x n)` per contact; torques are divided by the grasp's
/// length.
#[derive(Clone, Debug, PartialEq)]
pub struct Preloads {
    /// Rank of the wrench map; `N + M` when the contacts can produce any wrench (with either
    /// sign).
    pub rank: usize,
    /// Orthonormal null vectors, one force per contact each.
    pub basis: Vec<Vec<f64>>,
    /// The balanced preload with the largest least force, with total 1, and that least force;
    /// `None` when no balanced preload has a positive total.
    pub best: Option<BestPreload>,
    /// Whether pushing contacts can resist any wrench: the rank is full and a balanced preload
    /// with all forces positive exists.
    pub force_closure: bool,
}

/// The balanced preload whose weakest finger presses most.
#[derive(Clone, Debug, PartialEq)]
pub struct BestPreload {
    /// One share per contact; they sum to 1.
    pub shares: Vec<f64>,
    /// The least share, `t*`; positive exactly if all fingers can press at once.
    pub margin: f64,
}

impl<const N: usize, const M: usize> Grasp<N, M> {
    /// The balanced preloads of these contacts, whatever their own preloads are.
    ///
    /// # Errors
    ///
    /// [`GraspError::Preloads`] when the linear program over the preloads has an answer that its
    /// solver does not find.
    pub fn preloads(&self) -> Result<Preloads, GraspError> {
        let count = self.contacts().len();
        let (rank, basis) = self.null_space();
        let best = best_preload(&basis)?;
        let can_press = best.as_ref().is_some_and(|b| b.margin > ZERO_MARGIN * count as f64);
        Ok(Preloads { rank, force_closure: rank == N + M && can_press, basis, best })
    }

    fn null_space(&self) -> (usize, Vec<Vec<f64>>) {
        let count = self.contacts().len();
        let length = self.torque_length();
        let columns: Vec<_> =
            self.contacts().iter().map(|c| c.unit_wrench(self.centroid())).collect();
        let map = Mat::from_fn(N + M, count, |i, j| {
            if i < N { columns[j].force[i] } else { columns[j].torque[i - N] / length }
        });
        #[expect(clippy::expect_used, reason = "a grasp's wrench map is finite by construction")]
        let svd = map.svd().expect("the singular values of a finite matrix converge");
        let values = svd.S().column_vector();
        let count_of_values = count.min(N + M);
        let zero = ZERO_SINGULAR_VALUE * (count + N + M) as f64 * values[0];
        let rank = (0..count_of_values).filter(|&i| values[i] > zero).count();
        let null = (rank..count).map(|j| (0..count).map(|i| svd.V()[(i, j)]).collect()).collect();
        (rank, null)
    }
}

/// Maximizes the least force over `{B y : sum(B y) = 1}`, a linear program in `y`.
fn best_preload(basis: &[Vec<f64>]) -> Result<Option<BestPreload>, GraspError> {
    let Some(count) = basis.first().map(Vec::len) else { return Ok(None) };
    let free = (f64::NEG_INFINITY, f64::INFINITY);
    let mut program = Problem::new(OptimizationDirection::Maximize);
    let least = program.add_var(1.0, free);
    let weights: Vec<_> = basis.iter().map(|_| program.add_var(0.0, free)).collect();
    let noise = ZERO_COEFFICIENT * count as f64;
    let clean = |x: f64| if x.abs() > noise { x } else { 0.0 };
    for i in 0..count {
        let mut row: Vec<_> = weights.iter().zip(basis).map(|(&y, b)| (y, clean(b[i]))).collect();
        row.push((least, -1.0));
        program.add_constraint(row.as_slice(), ComparisonOp::Ge, 0.0);
    }
    let total: Vec<_> =
        weights.iter().zip(basis).map(|(&y, b)| (y, clean(b.iter().sum()))).collect();
    program.add_constraint(total.as_slice(), ComparisonOp::Eq, 1.0);
    let solution = match program.solve().map(microlp::SolveOutcome::into_solution) {
        Ok(Ok(solution)) => solution,
        // No combination of the null vectors has a total.
        Err(microlp::Error::Infeasible) => return Ok(None),
        _ => return Err(GraspError::Preloads { contacts: count }),
    };

    let forces: Vec<f64> = (0..count)
        .map(|i| weights.iter().zip(basis).map(|(&y, b)| solution.var_value(y) * b[i]).sum())
        .collect();
    let sum: f64 = forces.iter().sum();
    let shares: Vec<f64> = forces.iter().map(|force| force / sum).collect();
    let margin = shares.iter().copied().fold(f64::INFINITY, f64::min);
    Ok(Some(BestPreload { shares, margin }))
}
