//! What is expected where, in words.

use super::super::number::in_words;
use super::super::place::{Place, Step};

/// Where to put what is at `place` by mistake.
pub(in super::super) fn help(place: &Place) -> Option<&'static str> {
    let [Step::Field(name)] = place.steps() else { return None };
    match name.as_str() {
        "finger_radius" => Some(
            "give `finger = { radius = .. }` in each contact, or --finger-radius to `optimize`",
        ),
        "total_preload" => Some("give `preload` in each contact, or --preload to `optimize`"),
        "fingers" => Some("give --fingers to `optimize`"),
        "objective" => Some("give --objective to `optimize`"),
        "clearance" => Some("give --clearance to `optimize`"),
        "least_share" => Some("give --least-share to `optimize`"),
        "least_translation" => Some("give --least-translation to `optimize`"),
        "margin" | "forbidden" => Some("put it under [part.planar]"),
        _ => None,
    }
}

/// What is expected of the field `name` of the table at `place`.
pub(in super::super) fn expected(place: &Place, name: &str) -> &'static str {
    let material = place.steps().last().is_some_and(|step| {
        matches!(step, Step::Field(field) if field == "law") && matches!(name, "finger" | "part")
    });
    match name {
        _ if material => "a material: its name, or a table with `young` and `poisson`",
        "part" => "a table with `planar` or `spatial`",
        "stiffness" if *place == Place::planar() => "a positive number, or a list of one per edge",
        "stiffness" | "coefficient" | "exponent" | "thickness" | "reference_depth" | "young" => {
            "a positive number"
        }
        "poisson" => "a number, at most 1/2",
        "point" | "force" if place.steps().len() > 1 => in_words(&[]),
        "pitch" => "the distances [x, y] of holes, two positive numbers",
        "travel" => "a positive length",
        "from" | "to" if has(place, "keep_out") => in_words(&[3]),
        "edge" => "the number of an edge",
        "from" | "to" => "a length along the edge, from its start",
        "name" => "a name",
        "kind" => "`linear`, `power`, `hertz` or `line`",
        _ => "the name of a unit, such as \"mm\"",
    }
}

fn has(place: &Place, name: &str) -> bool {
    place.steps().iter().any(|step| matches!(step, Step::Field(field) if field == name))
}
