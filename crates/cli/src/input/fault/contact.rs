//! What can be wrong with a contact.

use std::borrow::Cow;
use std::fmt;

use clench::contact::ContactError;

use crate::input::material;
use crate::input::units::{forces, lengths};
use crate::input::{Piece, PieceKind};
use crate::wording::{digits, distance as far, quoted, rough_digits};

/// A point or a direction in a message.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Coordinates(pub(crate) Vec<f64>);

/// Why a contact was refused.
#[derive(Debug, thiserror::Error)]
pub(crate) enum ContactFault {
    /// A law, a finger or a preload is not valid.
    #[error(transparent)]
    Library(#[from] ContactError),
    /// Neither a point nor a center, or both.
    #[error("found {found}, expected exactly one of `point` and `center`")]
    PointOrCenter { found: &'static str },
    /// A center says how deep the finger presses; so does a preload.
    #[error("found a `preload` beside a `center`, from which the preload follows")]
    PreloadWithCenter,
    /// A balanced preload where nothing is balanced.
    #[error(
        "found `balanced`, expected a number: `optimize` finds how a preload is shared, and needs \
         a force only for a law that is not linear"
    )]
    NothingToBalance,
    /// The center of something that has none.
    #[error(
        "found a `center` of a finger that is not round, expected a finger with a `radius`, zero \
         or more"
    )]
    CenterOfNothing,
    /// The finger does not touch the part.
    #[error(
        "contact {contact} is apart from the part by {}: its center is {} away",
        far(*.gap, unit), far(*.distance, unit)
    )]
    Apart { contact: usize, gap: f64, distance: f64, unit: String },
    /// The finger touches at a corner.
    #[error(
        "contact {contact} touches where the boundary has no normal: nearest to its center is \
         {foot}, a corner or an edge of the part"
    )]
    CenterBeside { contact: usize, foot: Coordinates },
    /// A contact floats beside the part, or lies within it.
    #[error(
        "contact {contact} is off the boundary: found it {} away from {nearest}, \
         {side} the part, expected at most {} {unit}",
        far(*.distance, unit), rough_digits(*.allowed)
    )]
    OffBoundary {
        contact: usize,
        distance: f64,
        nearest: Nearest,
        side: &'static str,
        allowed: f64,
        unit: String,
    },
    /// A contact is on another edge or face than it says.
    #[error("contact {contact} is not on {piece}: found it on {nearest}")]
    OffPiece { contact: usize, piece: Piece, nearest: Nearest },
    /// An edge or face number is too large.
    #[error("found {kind} {found}, expected one from 0 to {last}")]
    NoSuchPiece { kind: PieceKind, found: u64, last: usize },
    /// An edge of a solid, a face of an outline, or either of something smooth.
    #[error("found `{found}`, but {}", has_pieces(*.kind))]
    WrongPiece { found: PieceKind, kind: Option<PieceKind> },
    /// A contact at a corner, which has no normal.
    #[error(
        "contact {contact} is where {}s {} and {} meet: expected {} or an `inward_normal` that \
         says which of them it presses on",
        .first.kind, .first.number, .second.number, named(.first.kind)
    )]
    AmbiguousPiece { contact: usize, first: Piece, second: Piece },
    /// A normal that is not that of the boundary.
    #[error(
        "found the inward normal {found} of contact {contact}, expected {expected}, that of {at}"
    )]
    OtherNormal { contact: usize, found: Coordinates, expected: Coordinates, at: Nearest },
    /// No law, and no stiffness of the part to make one from.
    #[error("contact {contact} has no `law`, and the part no `stiffness`: expected one of them")]
    NoLaw { contact: usize },
    /// A finger that is described not at all, or twice.
    #[error("found {found}, expected exactly one of {expected}")]
    FingerShape { found: String, expected: &'static str },
    /// Principal curvatures without their direction, or as many as something else.
    #[error("found {found}, expected two `curvatures`, and the `direction` of the first")]
    Curvatures { found: String },
    /// Hertz' law by the modulus and by materials, or by neither.
    #[error(
        "found {found}, expected an `effective_modulus`, or the materials of both `finger` and \
         `part`"
    )]
    HertzModulus { found: &'static str },
    /// A disc on an edge touches along a line.
    #[error(
        "a disc on an edge touches along a line, where Hertz' law of a point does not hold: use \
         `line`, or give the `relative_radius` of a contact that is round in space"
    )]
    PlanarHertz,
    /// A line contact that is none.
    #[error("a `line` contact is that of a disc on a straight edge, found {found}")]
    LineOnOther { found: &'static str },
    /// A finger that is not described is pointed, which Hertz' law does not know.
    #[error(
        "contact {contact} has no `finger`, so it is pointed, but Hertz' law needs a smooth \
         boundary: expected a `finger` with a radius or curvatures"
    )]
    PointedByDefault { contact: usize },
    /// A tolerance that nothing keeps.
    #[error("the tolerance is {}, but has to be a number, zero or positive", digits(*.value))]
    Tolerance { value: f64 },
    /// A relative tolerance that takes all, or that nothing keeps.
    #[error(
        "the tolerance is {}, but has to be a number from 0 up to, and not including, 1: it is \
         relative",
        digits(*.value)
    )]
    RelativeTolerance { value: f64 },
    /// There is no material of this name.
    #[error("found {}, but no material has this name; known are {}", quoted(found), materials())]
    UnknownMaterial { found: String, nearest: Option<&'static str> },
    /// A name of a material without the sizes of the units.
    #[error(
        "a material by its name needs units of known size, found length `{length}` and force \
         `{force}`; known are the lengths {} and the forces {}",
        lengths(),
        forces()
    )]
    UnknownUnits { length: String, force: String },
}

/// What of the boundary is near.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Nearest(pub(crate) Option<Piece>);

impl ContactFault {
    pub(super) fn help(&self) -> Option<Cow<'static, str>> {
        let fixed = match self {
            Self::OtherNormal { .. } => "leave `inward_normal` out: it follows from the part",
            Self::Apart { .. } => "move the center nearer, or give a `point` and a `preload`",
            Self::UnknownMaterial { nearest: Some(nearest), .. } => {
                return Some(Cow::Owned(format!("did you mean `{nearest}`?")));
            }
            Self::UnknownMaterial { nearest: None, .. } => "give { young = .., poisson = .. }",
            Self::UnknownUnits { .. } => "name the units, or give { young = .., poisson = .. }",
            _ => return None,
        };
        Some(Cow::Borrowed(fixed))
    }
}

impl fmt::Display for Coordinates {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        // Zero has no sign.
        let numbers: Vec<String> = self.0.iter().map(|v| digits(v + 0.0)).collect();
        write!(out, "[{}]", numbers.join(", "))
    }
}

impl fmt::Display for Nearest {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Some(piece) => piece.fmt(out),
            None => out.write_str("the boundary"),
        }
    }
}

fn materials() -> String {
    material::names().collect::<Vec<_>>().join(", ")
}

const fn named(kind: PieceKind) -> &'static str {
    match kind {
        PieceKind::Edge => "an `edge`",
        PieceKind::Face => "a `face`",
    }
}

const fn has_pieces(kind: Option<PieceKind>) -> &'static str {
    match kind {
        Some(PieceKind::Edge) => "contacts of an outline are on an `edge`",
        Some(PieceKind::Face) => "contacts of a solid are on a `face`",
        None => "a smooth part has no edges and no faces",
    }
}
