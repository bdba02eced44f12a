//! What `optimize` is asked for.

use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::time::Duration;

use clap::error::ErrorKind;
use clap::{Args, ValueEnum};

use super::OutputArguments;
use super::value;
use crate::input::schema::Forbidden;

/// The gap of a search that only closes in on the best placement of a combination.
const DEFAULT_GAP: f64 = 1e-4;

/// What to optimize, and how.
#[derive(Debug, Args)]
pub(crate) struct OptimizeArguments {
    /// The part file.
    pub(crate) part: PathBuf,
    /// The number of frictionless fingers, from 3 to 8.
    #[arg(long, value_name = "N", value_parser = value::fingers)]
    #[arg(allow_hyphen_values = true)]
    pub(crate) fingers: usize,
    /// What to maximize; three fingers know quality only.
    #[arg(long, value_enum, default_value = "quality")]
    pub(crate) objective: ObjectiveArgument,
    /// With --objective rotation: the least `sigma_min` (force / length); 0 if left out.
    #[arg(long, value_name = "S", value_parser = value::not_negative)]
    #[arg(allow_hyphen_values = true)]
    pub(crate) least_translation: Option<f64>,
    /// The sum of all contact forces. Three fingers need it: they resist rotation by it alone.
    /// With more, the report adds the quality to second order.
    #[arg(long, value_name = "F", value_parser = value::positive)]
    #[arg(allow_hyphen_values = true)]
    pub(crate) preload: Option<f64>,
    /// The radius of the fingers' tips. With four and more it changes the optimum only by the
    /// least distance.
    #[arg(long, value_name = "R", value_parser = value::not_negative, default_value = "0")]
    #[arg(allow_hyphen_values = true)]
    pub(crate) finger_radius: f64,
    /// The least distance of two fingers on one edge; twice the finger radius if left out. Three
    /// fingers are on three edges.
    #[arg(long, value_name = "D", value_parser = value::not_negative)]
    #[arg(allow_hyphen_values = true)]
    pub(crate) least_distance: Option<f64>,
    /// The least share of the preload that each finger has: from 0 to below 1/N.
    #[arg(long, value_name = "P", value_parser = value::not_negative, default_value = "0")]
    #[arg(allow_hyphen_values = true)]
    pub(crate) least_share: f64,
    /// No finger nearer than this to an end of an edge. The margin of the file holds too.
    #[arg(long, value_name = "M", value_parser = value::not_negative)]
    #[arg(allow_hyphen_values = true)]
    pub(crate) margin: Option<f64>,
    /// No finger on this edge, or on this stretch of it: --forbid 3 --forbid 5:0-10. Lengths count
    /// from the edge's start. May be given several times, and adds to what the file forbids.
    #[arg(long, value_name = "EDGE[:FROM-TO]", value_parser = value::forbidden)]
    #[arg(allow_hyphen_values = true)]
    pub(crate) forbid: Vec<Forbidden>,
    /// Report the best placements on this many combinations of edges: 1 or more.
    #[arg(long, value_name = "T", value_parser = value::one_or_more, default_value = "1")]
    pub(crate) top: NonZeroUsize,
    /// Stop when no placement can be better by more than this part of the best. 0 if left out;
    /// 1e-4 with five and more fingers, or with --objective worst-point.
    #[arg(long, value_name = "G", value_parser = value::not_negative)]
    #[arg(allow_hyphen_values = true)]
    gap: Option<f64>,
    /// Stop after this time, with the best so far and a bound; so does Ctrl-C.
    #[arg(long, value_name = "SECONDS", value_parser = value::seconds)]
    #[arg(allow_hyphen_values = true)]
    pub(crate) time: Option<Duration>,
    /// Stop after bounding this many sets of combinations: unlike with a time, the answer is
    /// always the same.
    #[arg(long, value_name = "N", value_parser = value::nodes)]
    #[arg(allow_hyphen_values = true)]
    pub(crate) nodes: Option<u64>,
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
    /// `mu_eq`, the equivalent rotational stiffness.
    Rotation,
}

impl OptimizeArguments {
    /// The relative gap at which the search may stop.
    pub(crate) fn gap(&self) -> f64 {
        let closes_in = self.fingers > 4 || self.objective == ObjectiveArgument::WorstPoint;
        self.gap.unwrap_or(if closes_in { DEFAULT_GAP } else { 0.0 })
    }

    /// The least distance of two fingers on one edge; none where each is on an edge of its own.
    pub(crate) fn least_distance(&self) -> Option<f64> {
        let tips = 2.0 * self.finger_radius;
        (self.fingers > 3).then(|| self.least_distance.unwrap_or(tips))
    }

    /// Checks that the options go with each other.
    pub(super) fn checked(&self) -> Result<(), (ErrorKind, String)> {
        let conflict = |message: String| Err((ErrorKind::ArgumentConflict, message));
        let share_limit = (self.fingers as f64).recip();
        if self.fingers == 3 && self.preload.is_none() {
            let message = "--fingers 3 needs --preload <F>, the sum of all contact forces: three \
                           frictionless fingers resist rotation by their preload alone";
            return Err((ErrorKind::MissingRequiredArgument, message.to_owned()));
        }
        if self.fingers == 3 && self.objective != ObjectiveArgument::Quality {
            return conflict("--fingers 3 goes with --objective quality only".to_owned());
        }
        if self.fingers == 3 && self.least_distance.is_some() {
            let reason = "three fingers are on three edges";
            return conflict(format!("--least-distance does not go with --fingers 3: {reason}"));
        }
        if self.least_translation.is_some() && self.objective != ObjectiveArgument::Rotation {
            return conflict("--least-translation goes with --objective rotation only".to_owned());
        }
        if self.least_share >= share_limit {
            let (found, count) = (self.least_share, self.fingers);
            let message =
                format!("--least-share is {found}, expected less than 1/{count} of the preload");
            return Err((ErrorKind::ValueValidation, message));
        }
        Ok(())
    }
}
