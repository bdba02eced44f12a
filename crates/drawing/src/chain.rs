//! From single curves to closed contours: ends that meet are joined.

use std::collections::HashMap;
use std::collections::hash_map::Entry;

use kurbo::Point;

use crate::error::DrawingError;
use crate::source::Source;

/// The corners of one strand.
#[derive(Clone, Debug)]
pub(super) struct Chain {
    pub(super) points: Vec<Point>,
    pub(super) source: usize,
}

/// A closed chain of corners.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Contour {
    pub(super) corners: Vec<Point>,
    /// Of each edge, from its corner to the next one.
    pub(super) sources: Vec<usize>,
}

/// What joining gives.
#[derive(Debug)]
pub(super) struct Joined {
    pub(super) contours: Vec<Contour>,
    /// The largest distance between two ends that were joined (length).
    pub(super) largest_gap: f64,
}

/// The chains without those that are there already, in either direction; and these, each with
/// the one that it repeats.
pub(super) fn without_repeats(chains: Vec<Chain>) -> (Vec<Chain>, Vec<[usize; 2]>) {
    let mut seen: HashMap<Vec<[u64; 2]>, usize> = HashMap::new();
    let (mut kept, mut repeats) = (Vec::new(), Vec::new());
    for chain in chains {
        // Adding zero makes the two zeros equal.
        let forth: Vec<[u64; 2]> =
            chain.points.iter().map(|p| [p.x, p.y].map(|x| (x + 0.0).to_bits())).collect();
        let mut back = forth.clone();
        back.reverse();
        match seen.entry(forth.min(back)) {
            Entry::Occupied(first) => repeats.push([chain.source, *first.get()]),
            Entry::Vacant(place) => {
                place.insert(chain.source);
                kept.push(chain);
            }
        }
    }
    (kept, repeats)
}

/// The contours that the chains make, their ends joined up to the distance `within`.
pub(super) fn joined(
    chains: &[Chain],
    sources: &[Source],
    within: f64,
) -> Result<Joined, DrawingError> {
    let mut contours = Vec::new();
    let mut largest_gap = 0.0_f64;
    let mut open: Vec<&Chain> = Vec::new();
    for chain in chains {
        let (first, last) = (chain.points[0], chain.points[chain.points.len() - 1]);
        let source = &sources[chain.source];
        if chain.points.iter().all(|point| point.distance(first) <= within) {
            return Err(DrawingError::TooShort { curve: Box::new(source.clone()), within });
        }
        let gap = first.distance(last);
        if gap <= within && chain.points.len() > 2 {
            largest_gap = largest_gap.max(gap);
            let corners = chain.points[..chain.points.len() - 1].to_vec();
            let sources = vec![chain.source; corners.len()];
            contours.push(Contour { corners, sources });
        } else {
            open.push(chain);
        }
    }
    let ends = Ends::of(&open, sources, within)?;
    largest_gap = largest_gap.max(ends.largest_gap);
    contours.extend(rounds(&open, &ends.partners));
    Ok(Joined { contours, largest_gap })
}

/// Follows chains from partner to partner until each is back where it began.
fn rounds(chains: &[&Chain], partners: &[usize]) -> Vec<Contour> {
    let mut used = vec![false; chains.len()];
    let mut contours = Vec::new();
    for first in 0..chains.len() {
        let mut contour = Contour { corners: Vec::new(), sources: Vec::new() };
        let mut entry = 2 * first;
        while !used[entry / 2] {
            let chain = chains[entry / 2];
            used[entry / 2] = true;
            // The last corner is the first one of the next chain.
            let count = chain.points.len() - 1;
            let forth = entry % 2 == 0;
            let corner = |i: usize| if forth { chain.points[i] } else { chain.points[count - i] };
            contour.corners.extend((0..count).map(corner));
            contour.sources.extend(std::iter::repeat_n(chain.source, count));
            entry = partners[entry ^ 1];
        }
        if !contour.corners.is_empty() {
            contours.push(contour);
        }
    }
    contours
}

/// The ends of open chains, in pairs: the start of chain `c` is number `2 c`, its end `2 c + 1`.
struct Ends {
    partners: Vec<usize>,
    largest_gap: f64,
}

impl Ends {
    fn of(chains: &[&Chain], sources: &[Source], within: f64) -> Result<Self, DrawingError> {
        let places: Vec<Point> = chains
            .iter()
            .flat_map(|chain| [chain.points[0], chain.points[chain.points.len() - 1]])
            .collect();
        let source = |end: usize| sources[chains[end / 2].source].clone();
        let mut partners: Vec<Option<usize>> = vec![None; places.len()];
        let mut cells: HashMap<[i64; 2], Vec<usize>> = HashMap::new();
        let mut largest_gap = 0.0_f64;
        for (end, place) in places.iter().enumerate() {
            let cell = cell(*place, within);
            let around = (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| [dx, dy]));
            for [dx, dy] in around {
                let near = [cell[0].saturating_add(dx), cell[1].saturating_add(dy)];
                for &other in cells.get(&near).map_or(&[][..], Vec::as_slice) {
                    if places[other].distance(*place) > within {
                        continue;
                    }
                    if let Some(third) = partners[end].or(partners[other]) {
                        let curves = Box::new([source(third), source(other), source(end)]);
                        return Err(DrawingError::Branch { curves, at: [place.x, place.y] });
                    }
                    largest_gap = largest_gap.max(places[other].distance(*place));
                    partners[end] = Some(other);
                    partners[other] = Some(end);
                }
            }
            cells.entry(cell).or_default().push(end);
        }
        match partners.iter().position(Option::is_none) {
            Some(end) => Err(open_end(end, &places, &partners, source)),
            None => Ok(Self { partners: partners.into_iter().flatten().collect(), largest_gap }),
        }
    }
}

/// The error that nothing goes on at an end, and what is nearest to it.
fn open_end(
    end: usize,
    places: &[Point],
    partners: &[Option<usize>],
    source: impl Fn(usize) -> Source,
) -> DrawingError {
    let others = (0..places.len()).filter(|&other| other != end && partners[other].is_none());
    let away = |other: &usize| places[*other].distance(places[end]);
    let nearest = others.min_by(|one, other| away(one).total_cmp(&away(other)));
    DrawingError::OpenEnd {
        curve: Box::new(source(end)),
        at: [places[end].x, places[end].y],
        nearest: nearest.map(|other| Box::new((source(other), away(&other)))),
        left_aside: Vec::new(),
    }
}

/// The square of a grid that a point is in; its side is the distance up to which ends meet, so
/// that those that meet are in neighbors.
fn cell(point: Point, side: f64) -> [i64; 2] {
    #[expect(clippy::cast_possible_truncation, reason = "beyond the range it saturates")]
    [point.x, point.y].map(|x| (x / side).floor() as i64)
}
