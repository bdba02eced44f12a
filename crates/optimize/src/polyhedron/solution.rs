//! From spots to a solution: the metrics of what was found.

use clench_metrics::{EquivalentStiffness, Principal, Quality, WorstPoint};
use clench_screw::{Stiffness, Vector, Wrench};
use clench_shape::{FaceFeature, Facet, Polyhedron};

use super::rating::{Rating, Spot};
use crate::{Objective, OptimizeError, Placement, Solution};

impl Rating<'_> {
    /// The solution with fingers at these spots, in the frame of the part, where `number` numbers
    /// what they touch.
    pub(super) fn solution(
        &self,
        spots: &[Spot],
        number: &dyn Fn(Spot) -> usize,
    ) -> Result<Solution<3, 3>, OptimizeError> {
        let scene = self.scene;
        let mut shares = self.shares(spots);
        let given_shares = shares.split_off(spots.len());
        let mut placements: Vec<_> = spots
            .iter()
            .zip(shares)
            .map(|(&spot, share)| {
                let patch = &scene.patches[spot.patch];
                let stiffness = patch.weight * patch.weight * scene.stiffness_unit;
                let placement = Placement {
                    on: number(spot),
                    point: scene.unscaled(spot.point),
                    inward_normal: patch.normal,
                    share,
                };
                (placement, stiffness)
            })
            .collect();
        let by_place = |p: &Placement<3>, q: &Placement<3>| {
            let along = |i: usize| p.point[i].total_cmp(&q.point[i]);
            p.on.cmp(&q.on).then(along(0)).then(along(1)).then(along(2))
        };
        placements.sort_by(|(p, _), (q, _)| by_place(p, q));
        let given = self.fingers.fixed.iter().map(|t| (t.inward_normal, t.point, t.stiffness));
        let placed = placements.iter().map(|(p, k)| (p.inward_normal, p.point, *k));
        let contacts: Vec<_> = placed.chain(given).collect();
        let about = |origin: Vector<3>| {
            contacts.iter().fold(Stiffness::ZERO, |sum, &(normal, point, k)| {
                sum + Stiffness::outer(&Wrench::of_force_at(normal, point - origin)) * k
            })
        };
        let placements: Vec<_> = placements.into_iter().map(|(placement, _)| placement).collect();
        let touched = || placements.iter().map(|p| p.on).collect();
        let body = scene.body;
        let evaluated = Principal::near(scene.unscaled(Vector::ZERO), about).and_then(|found| {
            let quality = Quality::of(&found, body)?;
            let objective = match self.fingers.objective {
                Objective::Quality => quality.value,
                Objective::Rotation { .. } => EquivalentStiffness::least(&found, body)?.value,
                Objective::WorstPoint => WorstPoint::of(&found, body)?.stiffness,
            };
            Ok((found, quality, objective))
        });
        match evaluated {
            Ok((principal, quality, objective)) => {
                Ok(Solution { placements, given_shares, objective, quality, principal })
            }
            Err(source) => Err(OptimizeError::OutOfRange { touched: touched(), source }),
        }
    }
}

/// The number of the face of a facet that a point on it is on; at an edge, the lowest.
pub(super) fn face_at(solid: &Polyhedron, facet: &Facet, point: Vector<3>) -> usize {
    let place = solid.place(point);
    let faces = match place.on {
        FaceFeature::Interior => vec![place.face],
        FaceFeature::Edge { faces, .. } => faces.to_vec(),
        FaceFeature::Vertex { faces, .. } => faces,
    };
    let of_facet = faces.into_iter().filter(|face| facet.faces().contains(face)).min();
    of_facet.unwrap_or(facet.faces()[0])
}
