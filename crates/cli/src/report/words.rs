//! The words of reports: each is one value, in JSON and in text.

use std::fmt;

use clench::contact::Order;
use clench::metrics::LimitedBy;
use clench::optimize::Ended;
use clench::stiffness::Stability;
use serde::Serialize;

/// Whether the preload's terms are in the stiffness.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum OrderWord {
    First,
    Second,
}

/// How a grasp is stable.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum StabilityWord {
    FirstOrder,
    SecondOrder,
    Marginal,
    Unstable,
}

/// Which of the two stiffnesses is the quality.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum LimitWord {
    Translation,
    Rotation,
}

/// What is maximized.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum ObjectiveWord {
    Quality,
    WorstPoint,
    Rotation,
    /// On a solid, where rotations are many.
    #[serde(rename = "rotation")]
    AnyRotation,
}

/// Why a search ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum EndWord {
    Proved,
    Gap,
    Time,
    Nodes,
    Interrupted,
}

impl From<Ended> for EndWord {
    fn from(ended: Ended) -> Self {
        match ended {
            Ended::Proved => Self::Proved,
            Ended::Gap => Self::Gap,
            Ended::Time => Self::Time,
            Ended::Nodes => Self::Nodes,
            Ended::Cancelled => Self::Interrupted,
        }
    }
}

impl From<Order> for OrderWord {
    fn from(order: Order) -> Self {
        match order {
            Order::First => Self::First,
            Order::Second => Self::Second,
        }
    }
}

impl From<Stability> for StabilityWord {
    fn from(stability: Stability) -> Self {
        match stability {
            Stability::FirstOrder => Self::FirstOrder,
            Stability::SecondOrder => Self::SecondOrder,
            Stability::Marginal => Self::Marginal,
            Stability::Unstable => Self::Unstable,
        }
    }
}

impl From<LimitedBy> for LimitWord {
    fn from(limit: LimitedBy) -> Self {
        match limit {
            LimitedBy::Translation => Self::Translation,
            LimitedBy::Rotation => Self::Rotation,
        }
    }
}

impl fmt::Display for StabilityWord {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(match self {
            Self::FirstOrder => "first order",
            Self::SecondOrder => "second order",
            Self::Marginal => "marginal",
            Self::Unstable => "unstable",
        })
    }
}

/// The symbol of what is maximized.
impl fmt::Display for ObjectiveWord {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(match self {
            Self::Quality => "Q",
            Self::WorstPoint => "Q_pt",
            Self::Rotation => "mu_eq",
            Self::AnyRotation => "Q_V",
        })
    }
}

impl fmt::Display for LimitWord {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(match self {
            Self::Translation => "translation",
            Self::Rotation => "rotation",
        })
    }
}
