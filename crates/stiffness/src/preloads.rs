//! Which contact forces balance by themselves, and whether the contacts can hold the body.

use clench_screw::Vector;
use faer::Mat;
use microlp::{ComparisonOp, OptimizationDirection, Problem, Variable};

use crate::{BALANCED, Grasp, GraspError};

/// A singular value below this many units of rounding of the largest, per row and column, counts
/// as zero: the entries of the wrench map are rounded by a few units each.
const ZERO_SINGULAR_VALUE: f64 = 4.0 * f64::EPSILON;

/// A margin below this many units of rounding, per contact, counts as zero: it is the least of
/// forces that sum to 1, each a combination of as many rounded entries as there are contacts.
pub(crate) const ZERO_MARGIN: f64 = 16.0 * f64::EPSILON;

/// A coefficient of the linear program below this, per contact, is rounding of a unit vector, and
/// would only spoil the program's scaling.
pub(crate) const ZERO_COEFFICIENT: f64 = f64::EPSILON;

/// The total of a null vector below this, per contact, is rounding: the vector is one of a basis
/// that is orthonormal to a few roundings per entry.
pub(crate) const ZERO_TOTAL: f64 = 16.0 * f64::EPSILON;

/// A share of the total below this is none: the linear programs decide what is feasible to about
/// this.
pub(crate) const NO_SHARE: f64 = 1e-9;

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
    /// The contacts whose push no forces of the others balance, wherever along their faces the
    /// fingers are: whatever the preload, nothing presses these on the part. Empty with force
    /// closure.
    pub unopposed: Vec<usize>,
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
        let (rank, basis) = self.balanced_forces();
        let best = best_preload(&basis)?;
        let can_press = best.as_ref().is_some_and(|b| b.margin > ZERO_MARGIN * count as f64);
        let unopposed = if can_press { Vec::new() } else { self.unopposed()? };
        Ok(Preloads { rank, force_closure: rank == N + M && can_press, basis, best, unopposed })
    }

    /// The rank of the wrench map, and its null vectors.
    ///
    /// Preloads that balance to the digits of a file are balanced: points of as few digits must not
    /// make a wrench that no forces can have.
    pub(crate) fn balanced_forces(&self) -> (usize, Vec<Vec<f64>>) {
        let balanced = self.loads().is_empty() && self.total_preload() > 0.0;
        let given = if balanced && self.equilibrium().holds { BALANCED } else { 0.0 };
        null_space(&self.wrench_map(N + M), given)
    }

    /// The contacts that carry nothing in any combination of forces along the normals that sum to
    /// none, without a pulling finger.
    fn unopposed(&self) -> Result<Vec<usize>, GraspError> {
        let normals = self.contacts().iter().map(|c| c.unit_wrench(self.centroid()).force);
        // What is true of a contact is true of all with its normal.
        let mut distinct: Vec<Vector<N>> = Vec::new();
        let mut number = |normal| {
            distinct.iter().position(|known| *known == normal).unwrap_or_else(|| {
                distinct.push(normal);
                distinct.len() - 1
            })
        };
        let numbers: Vec<usize> = normals.map(&mut number).collect();
        let map = Mat::from_fn(N, distinct.len(), |i, j| distinct[j][i]);
        let unopposed = unopposed(&null_space(&map, 0.0).1, distinct.len())?;
        let contacts = numbers.iter().enumerate().filter(|(_, number)| unopposed.contains(number));
        Ok(contacts.map(|(contact, _)| contact).collect())
    }

    /// The first `rows` of the wrench map, torques divided by the grasp's length.
    pub(crate) fn wrench_map(&self, rows: usize) -> Mat<f64> {
        let length = self.torque_length();
        let columns: Vec<_> =
            self.contacts().iter().map(|c| c.unit_wrench(self.centroid())).collect();
        Mat::from_fn(rows, columns.len(), |i, j| {
            if i < N { columns[j].force[i] } else { columns[j].torque[i - N] / length }
        })
    }
}

/// The rank and the null vectors of a map with a column for each contact. Singular values of the
/// part `given` of the largest, per contact, count as zero.
fn null_space(map: &Mat<f64>, given: f64) -> (usize, Vec<Vec<f64>>) {
    let (rows, count) = (map.nrows(), map.ncols());
    #[expect(clippy::expect_used, reason = "a grasp's wrench map is finite by construction")]
    let svd = map.svd().expect("the singular values of a finite matrix converge");
    let values = svd.S().column_vector();
    let rounding = ZERO_SINGULAR_VALUE * (count + rows) as f64;
    let zero = rounding.max(given * count as f64) * values[0];
    let rank = (0..count.min(rows)).filter(|&i| values[i] > zero).count();
    let null = (rank..count).map(|j| (0..count).map(|i| svd.V()[(i, j)]).collect()).collect();
    (rank, null)
}

/// Maximizes the least force over `{B y : sum(B y) = 1}`, a linear program in `y`.
fn best_preload(basis: &[Vec<f64>]) -> Result<Option<BestPreload>, GraspError> {
    let Some(count) = basis.first().map(Vec::len) else { return Ok(None) };
    let mut program = Program::new(basis, |_| 0.0, ComparisonOp::Eq);
    let least = program.problem.add_var(1.0, FREE);
    for i in 0..count {
        let mut row = program.force(basis, i);
        row.push((least, -1.0));
        program.problem.add_constraint(row.as_slice(), ComparisonOp::Ge, 0.0);
    }
    let Some(shares) = program.solve(basis)? else { return Ok(None) };
    let margin = shares.iter().copied().fold(f64::INFINITY, f64::min);
    Ok(Some(BestPreload { shares, margin }))
}

/// The contacts of `count` that carry nothing in any combination of null vectors without a pulling
/// finger: a linear program each, the largest share that the contact can have.
fn unopposed(basis: &[Vec<f64>], count: usize) -> Result<Vec<usize>, GraspError> {
    let mut found = Vec::new();
    for contact in 0..count {
        let largest = if basis.is_empty() { 0.0 } else { largest_share(basis, contact)? };
        if largest <= NO_SHARE {
            found.push(contact);
        }
    }
    Ok(found)
}

/// With a total of at most 1 rather than of 1: no forces at all are feasible then, and the solver
/// need not decide what is feasible to its last digit.
fn largest_share(basis: &[Vec<f64>], contact: usize) -> Result<f64, GraspError> {
    let mut program = Program::new(basis, |b| b[contact], ComparisonOp::Le);
    for i in 0..basis[0].len() {
        let row = program.force(basis, i);
        program.problem.add_constraint(row.as_slice(), ComparisonOp::Ge, 0.0);
    }
    Ok(program.solve(basis)?.map_or(0.0, |shares| shares[contact]))
}

/// A variable without bounds.
pub(crate) const FREE: (f64, f64) = (f64::NEG_INFINITY, f64::INFINITY);

/// A linear program over the weights `y` of null vectors, with `sum(B y)` equal to or at most 1.
struct Program {
    problem: Problem,
    weights: Vec<Variable>,
    noise: f64,
}

impl Program {
    /// Maximizes the sum of `value` times the weight over the null vectors.
    fn new(basis: &[Vec<f64>], value: impl Fn(&[f64]) -> f64, is: ComparisonOp) -> Self {
        let count = basis[0].len() as f64;
        let mut problem = Problem::new(OptimizationDirection::Maximize);
        let weights: Vec<_> = basis.iter().map(|b| problem.add_var(value(b), FREE)).collect();
        let sum = |b: &[f64]| above(b.iter().sum(), ZERO_TOTAL * count);
        let total: Vec<_> = weights.iter().zip(basis).map(|(&y, b)| (y, sum(b))).collect();
        problem.add_constraint(total.as_slice(), is, 1.0);
        Self { problem, weights, noise: ZERO_COEFFICIENT * count }
    }

    /// The force of a contact in terms of the weights.
    fn force(&self, basis: &[Vec<f64>], contact: usize) -> Vec<(Variable, f64)> {
        let entry = |b: &Vec<f64>| above(b[contact], self.noise);
        self.weights.iter().zip(basis).map(|(&y, b)| (y, entry(b))).collect()
    }

    /// The forces at the solution, with the sum 1; `None` when no combination of the null vectors
    /// has a total.
    fn solve(self, basis: &[Vec<f64>]) -> Result<Option<Vec<f64>>, GraspError> {
        let contacts = basis[0].len();
        let solution = match self.problem.solve().map(microlp::SolveOutcome::into_solution) {
            Ok(Ok(solution)) => solution,
            Err(microlp::Error::Infeasible) => return Ok(None),
            _ => return Err(GraspError::Preloads { contacts }),
        };
        let weights = self.weights.iter().map(|&y| solution.var_value(y));
        let weights: Vec<f64> = weights.collect();
        let force = |i: usize| weights.iter().zip(basis).map(|(y, b)| y * b[i]).sum::<f64>();
        let forces: Vec<f64> = (0..contacts).map(force).collect();
        let sum: f64 = forces.iter().sum();
        if sum <= NO_SHARE {
            return Ok(None);
        }
        Ok(Some(forces.iter().map(|force| force / sum).collect()))
    }
}

/// `value`, or 0 where it is no larger than `noise`.
pub(crate) fn above(value: f64, noise: f64) -> f64 {
    if value.abs() > noise { value } else { 0.0 }
}
