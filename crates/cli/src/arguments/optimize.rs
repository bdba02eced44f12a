//! What `optimize` is asked for.

use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::time::Duration;

use clap::error::ErrorKind;
use clap::{Args, ValueEnum};
use clench::optimize::polygon::MOST_FINGERS;
use clench::optimize::{Effort, Objective};

use super::OutputArguments;
use super::part::PartArguments;
use super::value;
use crate::input::schema::Forbidden;

/// The gap of a search that only closes in on the best placement of a combination.
const DEFAULT_GAP: f64 = 1e-4;

/// The gap of a search on a solid: the last percents of its proof take the longest.
const SOLID_GAP: f64 = 0.05;

/// The time of a search that closes in.
const DEFAULT_TIME: Duration = Duration::from_mins(1);

/// More than three fingers on one plane hold a solid hardly better than three.
const MOST_ON_FACE: usize = 3;

/// What to optimize, and how.
#[derive(Debug, Args)]
pub(crate) struct OptimizeArguments {
    /// The part file, or a drawing (.dxf, .svg) or a mesh (.stl, .obj) with --stiffness.
    pub(crate) part: PathBuf,
    /// The number of frictionless fingers to place: from 3 to 8 on an outline; on a solid from 1 to
    /// 12, from 7 to 16 with those of --fix.
    #[arg(long, value_name = "N", value_parser = value::fingers)]
    #[arg(allow_hyphen_values = true)]
    pub(crate) fingers: usize,
    /// Contacts that are given besides, such as locators; solids only. A grasp file, its part left
    /// out or the same. A law that is not linear counts by its slope at the preload.
    #[arg(long, value_name = "FILE")]
    pub(crate) fix: Option<PathBuf>,
    /// Choose among the contacts of this file rather than among all places; solids only. A file
    /// as for --fix.
    #[arg(long, value_name = "FILE")]
    pub(crate) candidates: Option<PathBuf>,
    /// What to maximize: if left out quality, on a solid worst-point, whose bounds are the
    /// tightest. Three fingers on an outline know quality only.
    #[arg(long, value_enum)]
    objective: Option<ObjectiveArgument>,
    /// With --objective rotation: the least `sigma_min` (force / length); 0 if left out.
    #[arg(long, value_name = "S", value_parser = value::not_negative)]
    #[arg(allow_hyphen_values = true)]
    pub(crate) least_translation: Option<f64>,
    /// The sum of all contact forces. Three fingers on an outline need it: they resist rotation by
    /// it alone. With more, the report adds the quality to second order.
    #[arg(long, value_name = "F", value_parser = value::positive)]
    #[arg(allow_hyphen_values = true)]
    pub(crate) preload: Option<f64>,
    /// The radius of the tips of the fingers that are placed. They touch only where a disc, on a
    /// solid a ball, of this radius has room, and do not overlap each other.
    #[arg(long, value_name = "R", value_parser = value::not_negative, default_value = "0")]
    #[arg(allow_hyphen_values = true)]
    pub(crate) finger_radius: f64,
    /// The least share of the preload that each contact has: from 0 to below 1/N, N with those of
    /// --fix.
    #[arg(long, value_name = "P", value_parser = value::not_negative, default_value = "0")]
    #[arg(allow_hyphen_values = true)]
    pub(crate) least_share: f64,
    /// The least gap between the tips of two fingers, one of them placed; 0 if left out.
    #[arg(long, value_name = "C", value_parser = value::not_negative)]
    #[arg(allow_hyphen_values = true)]
    pub(crate) clearance: Option<f64>,
    /// No finger nearer than this to a corner, along the boundary, or on a solid to where a plane
    /// ends. Corners of less than 0.5 rad are those of flattened curves and do not count. The
    /// margin of the file holds too.
    #[arg(long, value_name = "M", value_parser = value::not_negative)]
    #[arg(allow_hyphen_values = true)]
    pub(crate) margin: Option<f64>,
    /// Outlines only: no finger on this edge, or on this stretch of it: --forbid 3 --forbid 5:0-10.
    /// Lengths count from the edge's start; layer:NAME stands for all edges on a layer of a
    /// drawing. May be given several times, and adds to what the file forbids.
    #[arg(long, value_name = "EDGE[:FROM-TO]", value_parser = value::forbidden)]
    #[arg(allow_hyphen_values = true)]
    pub(crate) forbid: Vec<Forbidden>,
    /// On a solid: at most so many of the placed fingers on one plane; 3 if left out.
    #[arg(long, value_name = "N", value_parser = value::one_or_more)]
    most_on_face: Option<NonZeroUsize>,
    /// On a solid: a motion counts as free if no contact has a lever of more than this part of the
    /// part's reach on it.
    #[arg(long, value_name = "R", value_parser = value::not_negative)]
    #[arg(allow_hyphen_values = true)]
    pub(crate) roundness: Option<f64>,
    /// Report the best placements on this many combinations of edges, of faces or of candidates: 1
    /// or more.
    #[arg(long, value_name = "T", value_parser = value::one_or_more, default_value = "1")]
    top: NonZeroUsize,
    /// Stop when no placement can be better by more than this part of the best. 0 if left out;
    /// 1e-4 with five and more fingers, or with --objective worst-point; 0.05 on a solid.
    #[arg(long, value_name = "G", value_parser = value::not_negative)]
    #[arg(allow_hyphen_values = true)]
    gap: Option<f64>,
    /// Stop after this time, with the best so far and a bound; so does Ctrl-C. 60 if neither this
    /// nor --nodes is given, on an outline only with five and more fingers, or with --objective
    /// worst-point.
    #[arg(long, value_name = "SECONDS", value_parser = value::seconds)]
    #[arg(allow_hyphen_values = true)]
    time: Option<Duration>,
    /// Stop after bounding this many sets of combinations: unlike with a time, the answer is
    /// always the same.
    #[arg(long, value_name = "N", value_parser = value::nodes)]
    #[arg(allow_hyphen_values = true)]
    nodes: Option<u64>,
    #[command(flatten)]
    pub(crate) of_part: PartArguments,
    #[command(flatten)]
    pub(crate) output: OutputArguments,
}

/// What is maximized.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ObjectiveArgument {
    /// Q, the least of `sigma_min` and `mu_eq`.
    Quality,
    /// `Q_pt`, the least force per deflection of any point of the part.
    WorstPoint,
    /// `mu_eq`, the equivalent rotational stiffness; on a solid `Q_V`, the least of all rotations.
    Rotation,
}

impl OptimizeArguments {
    /// The files that are read.
    pub(crate) fn files(&self) -> Vec<&Path> {
        let given = [&self.fix, &self.candidates].into_iter().flatten();
        std::iter::once(&self.part).chain(given).map(PathBuf::as_path).collect()
    }

    /// How far a search on an outline goes.
    pub(crate) fn effort_on_outline(&self) -> Effort {
        let closes_in = self.fingers > 4 || self.maximized(2) == ObjectiveArgument::WorstPoint;
        if closes_in {
            self.closing_in(DEFAULT_GAP)
        } else {
            let gap = self.gap.unwrap_or(0.0);
            Effort { top: self.top, gap, time: self.time, nodes: self.nodes }
        }
    }

    /// How far a search on a solid goes.
    pub(crate) fn effort_on_solid(&self) -> Effort {
        self.closing_in(SOLID_GAP)
    }

    /// How far a search goes that only closes in on the best placement of a combination.
    fn closing_in(&self, gap: f64) -> Effort {
        let gap = self.gap.unwrap_or(gap);
        let time = if self.nodes.is_some() { self.time } else { self.time.or(Some(DEFAULT_TIME)) };
        Effort { top: self.top, gap, time, nodes: self.nodes }
    }

    /// How many of the placed fingers may be on one plane of a solid.
    pub(crate) fn most_on_face(&self) -> usize {
        self.most_on_face.map_or(MOST_ON_FACE, NonZeroUsize::get)
    }

    /// What is maximized on a part of this dimension.
    pub(crate) fn maximized(&self, dimension: u8) -> ObjectiveArgument {
        let default =
            if dimension == 3 { ObjectiveArgument::WorstPoint } else { ObjectiveArgument::Quality };
        self.objective.unwrap_or(default)
    }

    /// The same for the search.
    pub(crate) fn objective(&self, dimension: u8) -> Objective {
        match self.maximized(dimension) {
            ObjectiveArgument::Quality => Objective::Quality,
            ObjectiveArgument::WorstPoint => Objective::WorstPoint,
            ObjectiveArgument::Rotation => {
                let least_translation = self.least_translation.unwrap_or(0.0);
                Objective::Rotation { least_translation }
            }
        }
    }

    /// Checks that the options go with each other, whatever the part is.
    pub(super) fn checked(&self) -> Result<(), (ErrorKind, String)> {
        if self.least_translation.is_some() && self.objective != Some(ObjectiveArgument::Rotation) {
            let message = "--least-translation goes with --objective rotation only".to_owned();
            return Err((ErrorKind::ArgumentConflict, message));
        }
        let files = [("the part", Some(&self.part)), ("--fix", self.fix.as_ref())];
        let files = files.into_iter().chain([("--candidates", self.candidates.as_ref())]);
        let from_input = files.filter(|(_, file)| file.is_some_and(|file| file.as_os_str() == "-"));
        let names: Vec<&str> = from_input.map(|(name, _)| name).collect();
        if names.len() > 1 {
            let names = names.join(" and ");
            let message = format!("{names} are all `-`, but there is one standard input");
            return Err((ErrorKind::ArgumentConflict, message));
        }
        Ok(())
    }

    /// Checks that the options go with an outline.
    pub(crate) fn check_for_outline(&self) -> Result<(), String> {
        let (count, share_limit) = (self.fingers, (self.fingers as f64).recip());
        if !(value::FEWEST_ON_OUTLINE..=MOST_FINGERS).contains(&count) {
            return Err(format!("--fingers: {}", value::other_fingers(count)));
        }
        let given = [
            ("--fix", self.fix.is_some()),
            ("--candidates", self.candidates.is_some()),
            ("--most-on-face", self.most_on_face.is_some()),
            ("--roundness", self.roundness.is_some()),
        ];
        if let Some((option, _)) = given.iter().find(|(_, given)| *given) {
            return Err(format!("{option} goes with a solid, but the part is an outline"));
        }
        if count == 3 && self.preload.is_none() {
            let message = "--fingers 3 needs --preload <F>, the sum of all contact forces: three \
                           frictionless fingers resist rotation by their preload alone";
            return Err(message.to_owned());
        }
        if count == 3 && self.maximized(2) != ObjectiveArgument::Quality {
            return Err("--fingers 3 goes with --objective quality only".to_owned());
        }
        if self.least_share >= share_limit {
            let found = self.least_share;
            return Err(format!(
                "--least-share is {found}, expected less than 1/{count} of the preload"
            ));
        }
        Ok(())
    }

    /// Checks that the options go with a solid.
    pub(crate) fn check_for_solid(&self) -> Result<(), String> {
        let given = [("--forbid", !self.forbid.is_empty())];
        match given.iter().find(|(_, given)| *given) {
            Some((option, _)) => {
                Err(format!("{option} goes with an outline, but the part is a solid"))
            }
            None => Ok(()),
        }
    }
}
