//! Which preloads keep every contact on the body.

use clench_contact::Contact;
use faer::Mat;
use microlp::{ComparisonOp, OptimizationDirection, Problem};

use crate::preloads::{FREE, NO_SHARE, ZERO_COEFFICIENT, ZERO_MARGIN, ZERO_TOTAL, above};
use crate::{BALANCED, Grasp, GraspError};

/// Preloads have settled when a step changes none of them by more than this part of the largest:
/// many times the rounding of a step, and little beside [`BALANCED`].
const SETTLED: f64 = 1e-10;

/// After so many steps preloads have not settled: each is a small correction of the one before, or
/// there is no end to them.
const MOST_STEPS: usize = 100;

/// The balanced preloads with the least sum that leave each contact a force of its own.
#[derive(Clone, Debug, PartialEq)]
pub enum LeastPreloads {
    /// One force per contact.
    Found(Vec<f64>),
    /// Whatever the others do, no balanced preload presses these contacts so much; all that need
    /// force if each could be pressed, but not together.
    Unreachable {
        /// The contacts, from 0.
        contacts: Vec<usize>,
    },
    /// No forces of contacts that only push balance the dead loads.
    LoadsNotBalanced,
}

/// How preloads may change to keep contacts on the body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Remedy {
    /// Any way that balances: their sum becomes as small as can be.
    Least,
    /// All in the same ratio, up or down.
    Scaled,
}

/// Preloads under which no contact lifts off, or why there are none.
#[derive(Clone, Debug, PartialEq)]
pub enum NeededPreloads {
    /// These.
    Found(Needed),
    /// As for [`LeastPreloads::Unreachable`].
    Unreachable {
        /// The contacts, from 0.
        contacts: Vec<usize>,
    },
    /// As for [`LeastPreloads::LoadsNotBalanced`].
    LoadsNotBalanced,
    /// With the least sum these contacts press nothing, and without a force their laws have no
    /// stiffness: any force will do for them, and none is the least.
    NoLeast {
        /// The contacts, from 0.
        contacts: Vec<usize>,
    },
    /// To scale: these contacts lose force, and have no preload.
    NoPreload {
        /// The contacts, from 0.
        contacts: Vec<usize>,
    },
    /// To scale: the preloads balance dead loads, or do not balance, and more of them would not.
    NotByScaling,
    /// What the load cases do to the contact forces of the grasp as it is is not known.
    NoChanges,
}

/// Preloads under which no contact lifts off.
#[derive(Clone, Debug, PartialEq)]
pub struct Needed {
    /// One per contact (force).
    pub preloads: Vec<f64>,
    /// The change of each contact force under each load case (force).
    pub changes: Vec<Vec<f64>>,
    /// What the changes are those of.
    pub basis: Basis,
}

/// With which preloads the changes of contact forces were found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Basis {
    /// With the preloads that are needed: analyzed again, the grasp keeps its contacts.
    Needed,
    /// With those of the grasp as it is: changes depend on preloads, and finding one from the other
    /// came to no end. To first order only.
    Present,
}

impl<const N: usize, const M: usize> Grasp<N, M> {
    /// The preloads `f` with the least sum that balance the dead loads and leave contact `i` at
    /// least the force `least[i]`: a linear program. The grasp's own preloads do not matter.
    ///
    /// ```
    /// use clench_contact::{Contact, Geometry, Law};
    /// use clench_stiffness::{Grasp, LeastPreloads};
    /// // A bar between two fingers has as much from the left as from the right.
    /// let finger = |x: f64| {
    ///     let place = Geometry::on_face([x, 0.0].into(), [-x, 0.0].into(), 0.0);
    ///     Contact::<2, 1>::new(place, Law::linear(10.0)?, 0.0)
    /// };
    /// let grasp = Grasp::new(vec![finger(-1.0)?, finger(1.0)?])?;
    /// let LeastPreloads::Found(found) = grasp.least_preloads(&[3.0, 5.0])? else { panic!() };
    /// assert!((found[0] - 5.0).abs() < 1e-12 && (found[1] - 5.0).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`GraspError::LeastForces`] unless there is one for each contact, [`GraspError::LeastForce`]
    /// for one that is negative or not finite; [`GraspError::Preloads`] when the linear program has
    /// an answer that its solver does not find.
    pub fn least_preloads(&self, least: &[f64]) -> Result<LeastPreloads, GraspError> {
        let expected = self.contacts().len();
        if least.len() != expected {
            return Err(GraspError::LeastForces { found: least.len(), expected });
        }
        let bad = least.iter().position(|force| !(force.is_finite() && *force >= 0.0));
        if let Some(contact) = bad {
            return Err(GraspError::LeastForce { contact, value: least[contact] });
        }
        let Some(balancing) = self.balancing() else { return Ok(LeastPreloads::LoadsNotBalanced) };
        let (_, basis) = self.balanced_forces();
        let solve = |least: &[f64]| least_sum(&basis, &balancing, least);
        if let Some(preloads) = solve(least)? {
            return Ok(LeastPreloads::Found(preloads));
        }
        let nothing = vec![0.0; expected];
        if solve(&nothing)?.is_none() {
            return Ok(LeastPreloads::LoadsNotBalanced);
        }
        let pressed: Vec<usize> = (0..expected).filter(|&i| least[i] > 0.0).collect();
        let mut contacts = Vec::new();
        for &contact in &pressed {
            let mut alone = nothing.clone();
            alone[contact] = least[contact];
            if solve(&alone)?.is_none() {
                contacts.push(contact);
            }
        }
        let contacts = if contacts.is_empty() { pressed } else { contacts };
        Ok(LeastPreloads::Unreachable { contacts })
    }

    /// Preloads under which each contact keeps at least the part `reserve` of its preload, whatever
    /// load case acts: `f_i + change >= reserve f_i`; with a reserve of 0, no contact lifts off.
    ///
    /// `changes` finds the change of each contact force under each load case, for a grasp that
    /// differs from this one by its preloads; `None` if that grasp does not hold the body. For
    /// linear laws, to first order, preloads change nothing about it. Else new preloads follow from
    /// changes and new changes from preloads until both settle; if they do not, the
    /// [basis](Needed::basis) says so.
    ///
    /// # Errors
    ///
    /// [`GraspError::Reserve`] unless the reserve is from 0 to below 1; those of
    /// [`Self::least_preloads`].
    pub fn needed_preloads(
        &self,
        remedy: Remedy,
        reserve: f64,
        changes: impl Fn(&Self) -> Option<Vec<Vec<f64>>>,
    ) -> Result<NeededPreloads, GraspError> {
        if !(0.0..1.0).contains(&reserve) {
            return Err(GraspError::Reserve { value: reserve });
        }
        let Some(at_present) = changes(self) else { return Ok(NeededPreloads::NoChanges) };
        let first = match self.remedied(remedy, &self.lost(&at_present, reserve))? {
            NeededPreloads::Found(Needed { preloads, .. }) => preloads,
            none => return Ok(none),
        };
        let mut preloads = first.clone();
        for _ in 0..MOST_STEPS {
            let contacts = self.without_stiffness(&preloads);
            if !contacts.is_empty() {
                return Ok(NeededPreloads::NoLeast { contacts });
            }
            let Some(changes) = self.with_preloads(&preloads).and_then(|grasp| changes(&grasp))
            else {
                break;
            };
            let lost = self.lost(&changes, reserve);
            let NeededPreloads::Found(next) = self.remedied(remedy, &lost)? else { break };
            let largest = next.preloads.iter().copied().fold(0.0, f64::max);
            let steps = next.preloads.iter().zip(&preloads).map(|(new, old)| (new - old).abs());
            let settled = steps.fold(0.0, f64::max) <= SETTLED * largest;
            preloads = next.preloads;
            if settled {
                let basis = Basis::Needed;
                return Ok(NeededPreloads::Found(Needed { preloads, changes, basis }));
            }
        }
        let basis = Basis::Present;
        Ok(NeededPreloads::Found(Needed { preloads: first, changes: at_present, basis }))
    }

    /// The same grasp with other preloads; `None` if a law does not know them.
    fn with_preloads(&self, preloads: &[f64]) -> Option<Self> {
        let contact = |(contact, &preload): (&Contact<N, M>, &f64)| {
            Contact::new(*contact.overlap().geometry(), contact.law().clone(), preload).ok()
        };
        let contacts = self.contacts().iter().zip(preloads).map(contact).collect::<Option<_>>()?;
        Self::new(contacts).and_then(|grasp| grasp.with_loads(self.loads().to_vec())).ok()
    }

    /// The contacts with no preload, to rounding, whose laws have no stiffness then.
    fn without_stiffness(&self, preloads: &[f64]) -> Vec<usize> {
        let largest = preloads.iter().copied().fold(0.0, f64::max);
        let none = ZERO_MARGIN * preloads.len() as f64 * largest;
        let lacks = |contact: &Contact<N, M>| {
            Contact::<N, M>::new(*contact.overlap().geometry(), contact.law().clone(), 0.0).is_err()
        };
        let contacts = self.contacts().iter().zip(preloads).enumerate();
        let idle = contacts.filter(|(_, (contact, preload))| **preload <= none && lacks(contact));
        idle.map(|(number, _)| number).collect()
    }

    /// The preload that each contact needs under all load cases.
    fn lost(&self, changes: &[Vec<f64>], reserve: f64) -> Vec<f64> {
        let lost = |i: usize| changes.iter().map(|case| -case[i]).fold(0.0, f64::max);
        (0..self.contacts().len()).map(|i| lost(i) / (1.0 - reserve)).collect()
    }

    /// The preloads that leave each contact what it needs.
    fn remedied(&self, remedy: Remedy, least: &[f64]) -> Result<NeededPreloads, GraspError> {
        let found = |preloads| {
            let needed = Needed { preloads, changes: Vec::new(), basis: Basis::Present };
            NeededPreloads::Found(needed)
        };
        if remedy == Remedy::Least {
            return Ok(match self.least_preloads(least)? {
                LeastPreloads::Found(preloads) => found(preloads),
                LeastPreloads::Unreachable { contacts } => NeededPreloads::Unreachable { contacts },
                LeastPreloads::LoadsNotBalanced => NeededPreloads::LoadsNotBalanced,
            });
        }
        if !(self.loads().is_empty() && self.equilibrium().holds) {
            return Ok(NeededPreloads::NotByScaling);
        }
        let preloads: Vec<f64> = self.contacts().iter().map(Contact::preload).collect();
        let pairs = || least.iter().zip(&preloads);
        let without = pairs().enumerate().filter(|(_, (least, has))| **least > 0.0 && **has <= 0.0);
        let contacts: Vec<usize> = without.map(|(contact, _)| contact).collect();
        if !contacts.is_empty() {
            return Ok(NeededPreloads::NoPreload { contacts });
        }
        let needs = pairs().filter(|(least, _)| **least > 0.0);
        let factor = needs.map(|(least, has)| least / has).fold(0.0, f64::max);
        Ok(found(preloads.iter().map(|preload| preload * factor).collect()))
    }

    /// Contact forces of either sign that balance the dead loads; `None` if there are none.
    fn balancing(&self) -> Option<Vec<f64>> {
        let count = self.contacts().len();
        if self.loads().is_empty() {
            return Some(vec![0.0; count]);
        }
        if self.equilibrium().holds {
            return Some(self.contacts().iter().map(Contact::preload).collect());
        }
        let map = self.wrench_map(N + M);
        let loads = self.loads().iter().map(|load| load.wrench::<M>(self.centroid()));
        let wrench = loads.reduce(|sum, one| sum + one)?;
        let length = self.torque_length();
        let wanted = Mat::from_fn(N + M, 1, |i, _| {
            if i < N { -wrench.force[i] } else { -wrench.torque[i - N] / length }
        });
        #[expect(clippy::expect_used, reason = "a grasp's wrench map is finite by construction")]
        let svd = map.svd().expect("the singular values of a finite matrix converge");
        let (rank, _) = self.balanced_forces();
        let mut forces = vec![0.0; count];
        for k in 0..rank {
            let along = (0..N + M).map(|i| svd.U()[(i, k)] * wanted[(i, 0)]).sum::<f64>();
            let size = along / svd.S().column_vector()[k];
            forces.iter_mut().enumerate().for_each(|(j, force)| *force += svd.V()[(j, k)] * size);
        }
        let left = (0..N + M).map(|i| {
            let answered: f64 = (0..count).map(|j| map[(i, j)] * forces[j]).sum();
            (answered - wanted[(i, 0)]).abs()
        });
        let largest = (0..N + M).map(|i| wanted[(i, 0)].abs()).fold(0.0, f64::max);
        (left.fold(0.0, f64::max) <= BALANCED * largest).then_some(forces)
    }
}

/// `balancing + B y >= least` with the least sum, a linear program in `y`; `None` if no `y` does.
fn least_sum(
    basis: &[Vec<f64>],
    balancing: &[f64],
    least: &[f64],
) -> Result<Option<Vec<f64>>, GraspError> {
    let contacts = balancing.len();
    let forces = balancing.iter().chain(least).map(|force| force.abs());
    let scale = forces.fold(0.0, f64::max);
    if scale <= 0.0 {
        return Ok(Some(vec![0.0; contacts]));
    }
    let mut program = Problem::new(OptimizationDirection::Minimize);
    let noise = ZERO_COEFFICIENT * contacts as f64;
    let total = |b: &Vec<f64>| above(b.iter().sum(), ZERO_TOTAL * contacts as f64);
    let weights: Vec<_> = basis.iter().map(|b| program.add_var(total(b), FREE)).collect();
    for i in 0..contacts {
        let missing = (least[i] - balancing[i]) / scale;
        let entries = weights.iter().zip(basis).map(|(&y, b)| (y, above(b[i], noise)));
        let row: Vec<_> = entries.filter(|(_, entry)| entry.abs() > 0.0).collect();
        if !row.is_empty() {
            program.add_constraint(row.as_slice(), ComparisonOp::Ge, missing);
        } else if missing > NO_SHARE {
            return Ok(None);
        }
    }
    let weight: Vec<f64> = if basis.is_empty() {
        Vec::new()
    } else {
        match program.solve().map(microlp::SolveOutcome::into_solution) {
            Ok(Ok(solution)) => weights.iter().map(|&y| solution.var_value(y)).collect(),
            Err(microlp::Error::Infeasible) => return Ok(None),
            _ => return Err(GraspError::Preloads { contacts }),
        }
    };
    let force = |i: usize| {
        let more: f64 = weight.iter().zip(basis).map(|(y, b)| y * b[i]).sum();
        // What is less than nothing is so by rounding.
        (balancing[i] + scale * more).max(0.0)
    };
    Ok(Some((0..contacts).map(force).collect()))
}
