//! No bound is below a placement under it.

use clench_testkit::Random;

use super::{OBJECTIVES, held, part, piece_of, rating, touch};
use crate::polyhedron::Fingers;
use crate::polyhedron::bound::{Pieces, Relaxation};
use crate::polyhedron::rating::{Rating, Spot, Worth};
use crate::polyhedron::scene::Scene;
use crate::search::{Floor, Piece};

/// Bounds are rounded outward; a placement's own last digits are not.
const DIGITS: f64 = 1e-11;

fn quality(worth: Worth) -> f64 {
    let Worth::Held(quality, _) = worth else { panic!("{worth:?} does not hold") };
    quality
}

/// The bounds of a chain of nodes around a placement, each a half of the one before, by cuts that
/// are handed on.
fn check_chain<const K: usize>(
    r: &mut Random,
    relaxation: &Relaxation<'_>,
    pieces: &Pieces<'_>,
    (worth, spots): (Worth, [Spot; K]),
    what: &str,
) -> usize {
    let quality = quality(worth);
    let mut hint = None;
    let mut depths = [0; K];
    let mut sharp = 0;
    for _ in 0..40 {
        depths[r.below(K)] += 1 + r.below(4);
        let node: Vec<Piece> =
            spots.iter().zip(depths).map(|(spot, depth)| piece_of(pieces, spot, depth)).collect();
        let floor = Floor { quality: quality * r.between(0.0, 0.9999), second: 0.0 };
        let bounded = relaxation.bound(&node, &floor, hint.as_ref());
        let Some(bounded) = bounded else {
            panic!("{quality} was excluded above {}: {what}, {node:?}", floor.quality)
        };
        assert!(bounded.bound >= quality * (1.0 - DIGITS), "{} < {quality}: {what}", bounded.bound);
        sharp += usize::from(bounded.bound < 1.2 * quality);
        // Sometimes a bound is found anew.
        hint = (r.below(4) > 0).then_some(bounded.hint);
    }
    sharp
}

#[test]
fn no_bound_is_below_a_placement_under_it() {
    let mut r = Random::new(61);
    let (mut chains, mut sharp) = (0, 0);
    for round in 0..72 {
        let kind = round % 6;
        let part = part(&mut r, kind);
        let objective = OBJECTIVES[round / 6 % 4];
        let given = if round % 3 == 0 { 3 } else { 0 };
        let fixed = (0..given).map(|_| touch(&mut r, &part)).collect();
        let least_share = if round % 5 == 0 { 0.01 } else { 0.0 };
        let fingers = Fingers { fixed, objective, least_share, ..Fingers::new(7) };
        let scene = Scene::of_part(&part, &fingers).unwrap();
        let rating = rating(&scene, &fingers);
        let pieces = Pieces::new(&scene);
        let relaxation = Relaxation::new(rating, &pieces);
        for seed in 0..3 {
            let Some(found) = held::<7>(rating, seed) else { continue };
            chains += 1;
            let what = format!("body {kind}, {objective:?}, {given} given, seed {seed}");
            sharp += check_chain(&mut r, &relaxation, &pieces, found, &what);

            // Asked for as large a share as the least that it has.
            let shares = rating.shares(&found.1);
            let least_share = 0.9999 * shares.iter().copied().fold(1.0, f64::min);
            let fingers = Fingers { least_share, ..fingers.clone() };
            let rating = Rating { scene: &scene, fingers: &fingers };
            let relaxation = Relaxation::new(rating, &pieces);
            check_chain(&mut r, &relaxation, &pieces, found, &what);
        }
    }
    assert!(chains > 150, "{chains} placements");
    assert!(sharp > chains, "the bounds are of no use: {sharp} of {} are near", 40 * chains);
}
