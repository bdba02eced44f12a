//! Where the tips of fingers have room.

use serde::Serialize;

use super::number::UnitNames;
use super::page::Page;
use crate::wording::counted;

/// More of a list are counted.
const LISTED: usize = 12;

/// Percents.
const PERCENT: f64 = 100.0;

/// What of a part can be touched, and what meets something.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct AccessReport {
    /// Of an outline.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) outline: Option<OutlineReport>,
    /// Of the surface; not where fingers are chosen among candidates.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) surface: Option<SurfaceReport>,
    /// Candidates whose tips have no room.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(crate) left_out: Vec<MeetsReport>,
    /// Given contacts that overlap the part, a keep-out or each other.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(crate) overlapping: Vec<MeetsReport>,
}

/// How much of an outline and its holes fingers may touch.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct OutlineReport {
    /// A part of the length.
    pub(crate) share: f64,
    /// The edges that cannot be touched at all.
    pub(crate) closed_edges: Vec<usize>,
}

/// How much of a surface is accessible.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct SurfaceReport {
    /// A part of the area.
    pub(crate) share: f64,
    /// What is accessible but left out is this near to what is not, or nearer (length).
    pub(crate) tolerance: f64,
    /// The lowest face of each plane that cannot be touched at all.
    pub(crate) closed_faces: Vec<usize>,
}

/// A contact of a file, and what its tip meets.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct MeetsReport {
    pub(crate) contact: usize,
    pub(crate) meets: String,
}

impl AccessReport {
    /// Nothing that is worth a word.
    pub(crate) fn is_empty(&self) -> bool {
        let everywhere = self.outline.is_none() && self.surface.is_none();
        everywhere && self.left_out.is_empty() && self.overlapping.is_empty()
    }

    /// The lines of the text.
    pub(super) fn lines(&self, page: &mut Page, units: UnitNames<'_>) {
        if let Some(OutlineReport { share, closed_edges }) = &self.outline {
            let closed = match &closed_edges[..] {
                [] => String::new(),
                [edge] => format!("; edge {edge} not at all"),
                edges => format!("; {} edges not at all: {}", edges.len(), listed(edges)),
            };
            let percent = PERCENT * share;
            page.head("room", format_args!("{percent:.1} % of the outline is accessible{closed}"));
        }
        if let Some(SurfaceReport { share, tolerance, closed_faces }) = &self.surface {
            let closed = match &closed_faces[..] {
                [] => String::new(),
                [face] => format!("; the plane of face {face} not at all"),
                faces => {
                    let (count, faces) = (faces.len(), listed(faces));
                    format!("; {count} planes not at all: those of faces {faces}")
                }
            };
            let (percent, tolerance) = (PERCENT * share, units.length(*tolerance));
            page.head(
                "room",
                format_args!("{percent:.1} % of the surface is accessible, to {tolerance}{closed}"),
            );
        }
        for (name, what, list) in [
            ("left out", "candidate", &self.left_out),
            ("overlap", "fixed contact", &self.overlapping),
        ] {
            if list.is_empty() {
                continue;
            }
            let one = |m: &MeetsReport| format!("{what} {} meets {}", m.contact, m.meets);
            let shown = list.iter().take(LISTED).map(one).collect::<Vec<_>>().join("; ");
            let more = match list.len().saturating_sub(LISTED) {
                0 => String::new(),
                more => format!("; and {}", counted(more, "other")),
            };
            page.head(name, format_args!("{shown}{more}"));
        }
    }
}

/// The first of these numbers.
fn listed(numbers: &[usize]) -> String {
    let shown = numbers.iter().take(LISTED).map(usize::to_string).collect::<Vec<_>>().join(", ");
    let more = if numbers.len() > LISTED { ", .." } else { "" };
    format!("{shown}{more}")
}
