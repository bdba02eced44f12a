//! Values of options, each with words for what is expected of it.

use std::fmt::Display;
use std::num::NonZeroUsize;
use std::time::Duration;

use clench::optimize::polygon::MOST_FINGERS as MOST_ON_OUTLINE;
use clench::optimize::polyhedron::MOST_FINGERS;

use crate::input::schema::{Forbidden, ForbiddenLayer, ForbiddenStretch, Units};
use crate::input::{FORCE, Finite, Label, LayerStiffness, Name, Whole};
use crate::wording::digits;

/// Beside contacts that are given, one may be placed.
const FEWEST_FINGERS: usize = 1;

/// Three fingers hold an outline by their preload; two never do.
pub(super) const FEWEST_ON_OUTLINE: usize = 3;

/// Coordinates of a frame up to here leave products of three of them in the range of numbers.
const LARGEST_FRAME: f64 = 1e90;

/// A frame as it is written on the command line: of the plane by three numbers, of space by six.
#[derive(Clone, Debug)]
pub(crate) struct FrameArgument(pub(crate) Vec<f64>);

pub(super) fn frame(text: &str) -> Result<FrameArgument, String> {
    let numbers: Vec<f64> = text.split(',').map(finite).collect::<Result<_, _>>()?;
    if let Some(number) = numbers.iter().find(|number| number.abs() > LARGEST_FRAME) {
        return Err(format!("found {}, expected numbers up to {LARGEST_FRAME:e}", digits(*number)));
    }
    match numbers.len() {
        3 | 6 => Ok(FrameArgument(numbers)),
        count => Err(format!(
            "found {count} numbers, expected three in the plane: x,y,angle; \
             or six in space: x,y,z,rx,ry,rz"
        )),
    }
}

pub(super) fn fingers(text: &str) -> Result<usize, String> {
    let count = text.trim().parse().ok();
    count
        .filter(|count| (FEWEST_FINGERS..=MOST_FINGERS).contains(count))
        .ok_or_else(|| other_fingers(text))
}

/// That there cannot be so many fingers: only a part that is known says which range holds.
pub(super) fn other_fingers(found: impl Display) -> String {
    format!(
        "found {found}, expected from {FEWEST_ON_OUTLINE} to {MOST_ON_OUTLINE} on an outline, on \
         a solid from {FEWEST_FINGERS} to {MOST_FINGERS}"
    )
}

pub(super) fn positive(text: &str) -> Result<f64, String> {
    let value = finite(text)?;
    if value > 0.0 {
        Ok(value)
    } else {
        Err(format!("found {}, expected more than 0", digits(value)))
    }
}

pub(super) fn not_negative(text: &str) -> Result<f64, String> {
    let value = finite(text)?;
    if value >= 0.0 {
        Ok(value)
    } else {
        Err(format!("found {}, expected 0 or more", digits(value)))
    }
}

pub(super) fn reserve(text: &str) -> Result<f64, String> {
    let value = finite(text)?;
    let fits = (0.0..1.0).contains(&value);
    if fits {
        Ok(value)
    } else {
        Err(format!("found {}, expected from 0 to below 1", digits(value)))
    }
}

pub(super) fn one_or_more(text: &str) -> Result<NonZeroUsize, String> {
    let count: Option<usize> = text.trim().parse().ok();
    count.and_then(NonZeroUsize::new).ok_or_else(|| format!("found {text}, expected 1 or more"))
}

pub(super) fn nodes(text: &str) -> Result<u64, String> {
    let count = text.trim().parse().ok().filter(|count| *count > 0);
    count.ok_or_else(|| format!("found {text}, expected 1 or more"))
}

pub(super) fn seconds(text: &str) -> Result<Duration, String> {
    let value = positive(text)?;
    Duration::try_from_secs_f64(value)
        .map_err(|_| format!("found {}, expected fewer", digits(value)))
}

/// `K` or `LAYER=K`.
pub(super) fn stiffness(text: &str) -> Result<LayerStiffness, String> {
    // The name of a layer may have the sign itself.
    let (layer, number) = match text.rsplit_once('=') {
        Some((name, number)) => (Some(layer(name)?.0), number),
        None => (None, text),
    };
    Ok(LayerStiffness { layer, stiffness: Finite(positive(number)?) })
}

/// `LENGTH` or `LENGTH,FORCE`.
pub(super) fn units(text: &str) -> Result<Units, String> {
    let named = |name: &str| {
        layer(name.trim())
            .map_err(|_| format!("found `{text}`, expected the name of a unit, such as mm or mm,N"))
    };
    let (length, force) = text.split_once(',').unwrap_or((text, FORCE));
    if force.contains(',') {
        return Err(format!("found `{text}`, expected one unit of length and one of force"));
    }
    Ok(Units { length: named(length)?, force: named(force)? })
}

/// The name of a layer.
pub(super) fn layer(text: &str) -> Result<Name, String> {
    if text.trim().is_empty() || text.contains(char::is_control) {
        return Err("found no name, expected that of a layer".to_owned());
    }
    Ok(Name(text.to_owned()))
}

/// `EDGE`, `EDGE:FROM-TO` or `layer:NAME`.
pub(super) fn forbidden(text: &str) -> Result<Forbidden, String> {
    if let Some(name) = text.strip_prefix("layer:") {
        let layer = Label(layer(name)?.0);
        return Ok(Forbidden::Layer(ForbiddenLayer { layer }));
    }
    let wrong = || format!("found `{text}`, expected an edge, or EDGE:FROM-TO with FROM below TO");
    let (edge, stretch) = match text.split_once(':') {
        Some((edge, stretch)) => (edge, Some(stretch)),
        None => (text, None),
    };
    let edge = edge.trim().parse().ok().map(Whole).ok_or_else(wrong)?;
    let Some(stretch) = stretch else { return Ok(Forbidden::Edge(edge)) };
    // A dash may also be the sign of a number or of its power of ten.
    let ends = stretch.match_indices('-').find_map(|(dash, _)| {
        Some((finite(&stretch[..dash]).ok()?, finite(&stretch[dash + 1..]).ok()?))
    });
    match ends {
        Some((from, to)) if from < to => {
            Ok(Forbidden::Stretch(ForbiddenStretch { edge, from: Finite(from), to: Finite(to) }))
        }
        _ => Err(wrong()),
    }
}

fn finite(text: &str) -> Result<f64, String> {
    let number = text.trim().parse().ok().filter(|number: &f64| number.is_finite());
    number.ok_or_else(|| format!("found `{text}`, expected a finite number"))
}
