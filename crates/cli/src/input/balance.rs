//! The contacts of a file, those with a balanced preload from the loads and the other contacts.

use clench::contact::{Contact, Curvature, Geometry};
use clench::stiffness::{DeadLoad, reactions};

use super::boundary::Piece;
use super::contact::Entry;
use super::fault::{BalanceFault, Pull};
use super::grasp::Source;
use super::place::Place;
use super::schema::{self, Preload};
use crate::failure::Failure;

/// A contact, and the edge or face that it presses on; none of a smooth part.
type OnPiece<const N: usize, const M: usize> = (Contact<N, M>, Option<Piece>);

/// The contacts in their order, each made by `contact`. What those with a balanced preload carry
/// follows from the loads and from all others.
pub(super) fn contacts<const N: usize, const M: usize>(
    source: &Source<'_, N>,
    given: &[schema::Contact],
    loads: &[DeadLoad<N>],
    contact: impl Fn(&Entry<'_, N>) -> Result<OnPiece<N, M>, Failure>,
) -> Result<Vec<OnPiece<N, M>>, Failure> {
    let balanced = |given: &schema::Contact| matches!(given.preload, Some(Preload::Balanced));
    let entry = |(number, given)| {
        let balancing = balanced(given).then_some(0.0);
        Entry { source, number, given, balancing }
    };
    let mut entries: Vec<_> = given.iter().enumerate().map(entry).collect();
    if given.iter().any(balanced) {
        let mut acting = loads.to_vec();
        for entry in entries.iter().filter(|entry| entry.balancing.is_none()) {
            acting.push(force_of(&contact(entry)?.0));
        }
        balance::<N, M>(source, &mut entries, &acting)?;
    }
    entries.iter().map(contact).collect()
}

/// The force of a contact, as that of a load.
fn force_of<const N: usize, const M: usize>(contact: &Contact<N, M>) -> DeadLoad<N> {
    let overlap = contact.overlap();
    DeadLoad { point: overlap.point(), force: overlap.inward_normal() * contact.preload() }
}

/// Gives the balanced ones of `entries` the forces that balance what is `acting`.
fn balance<const N: usize, const M: usize>(
    source: &Source<'_, N>,
    entries: &mut [Entry<'_, N>],
    acting: &[DeadLoad<N>],
) -> Result<(), Failure> {
    let mut balanced: Vec<_> =
        entries.iter_mut().filter(|entry| entry.balancing.is_some()).collect();
    let supports: Vec<Geometry<N>> = balanced
        .iter()
        .map(|entry| Ok(entry.seated(Curvature::POINTED)?.geometry))
        .collect::<Result<_, Failure>>()?;
    let fault = |contact, fault: BalanceFault| {
        source.document.error(&Place::contact(contact).field("preload"), fault)
    };
    let forces = reactions::<N, M>(&supports, acting)
        .map_err(|e| fault(balanced[0].number, BalanceFault::from(e)))?;
    let pulling: Vec<Pull> = balanced
        .iter()
        .zip(&forces)
        .filter(|(_, force)| **force < 0.0)
        .map(|(entry, force)| Pull { contact: entry.number, force: -force })
        .collect();
    if let Some(first) = pulling.first() {
        let (contact, unit) = (first.contact, source.units.force.0.clone());
        return Err(fault(contact, BalanceFault::Pulling { pulling, unit }));
    }
    for (entry, force) in balanced.iter_mut().zip(forces) {
        entry.balancing = Some(force);
    }
    Ok(())
}
