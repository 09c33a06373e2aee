//! Stages of a run, in SI units.

mod check;
mod keys;
mod read;

pub(crate) use check::check;
pub(crate) use keys::{KEYS, UNTIL};
pub(crate) use read::{guide, stages};

use mechanics::Motion;
use serde::Serialize;
use std::path::PathBuf;

/// A stage of a run.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Stage {
    /// Name of the stage in the file.
    pub name: String,
    /// How long the stage lasts [s]; where something else ends it, how long at most.
    pub duration: f64,
    /// What ends the stage.
    pub until: Option<Until>,
    /// Whether averages are taken over this stage.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub steady: bool,
    /// The motions that change at the beginning of the stage.
    pub changes: Vec<Change>,
}

/// A motion that changes at the beginning of a stage.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Change {
    /// The body, by number.
    pub body: usize,
    /// The degree of freedom, by its number in [`super::body::MOTIONS`].
    pub motion: usize,
    /// How the body moves from then on; times of the motion count from there.
    pub to: Motion,
}

/// What ends a stage: a quantity of a body reaches a value, or passes it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Until {
    /// The body, by number.
    pub body: usize,
    /// The quantity that ends the stage.
    pub quantity: StageQuantity,
    /// Value that ends the stage, in SI units.
    pub value: f64,
}

/// A quantity that can end a stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum StageQuantity {
    /// Depth of the lowest point below the surface [m].
    Sinkage,
    /// Displacement along the tow since the stage began [m].
    Displacement,
    /// Vertical force of the soil on the body [N].
    VerticalForce,
    /// Drag [N].
    Drag,
    /// Torque of the soil about the axle [N m].
    AxleTorque,
}

impl StageQuantity {
    /// All quantities that can end a stage, each with its key.
    pub const ALL: [(&'static str, Self); 5] = [
        ("sinkage", Self::Sinkage),
        ("displacement", Self::Displacement),
        ("vertical_force", Self::VerticalForce),
        ("drag", Self::Drag),
        ("axle_torque", Self::AxleTorque),
    ];

    /// Name of the quantity in words, and its unit.
    #[must_use]
    pub fn words(self) -> [&'static str; 2] {
        match self {
            Self::Sinkage => ["sinkage", "m"],
            Self::Displacement => ["displacement", "m"],
            Self::VerticalForce => ["vertical force", "N"],
            Self::Drag => ["drag", "N"],
            Self::AxleTorque => ["axle torque", "N m"],
        }
    }

    /// The axis along which the body moves until it is reached, and in which direction it counts.
    pub(crate) fn axis(self) -> Option<(usize, f64)> {
        match self {
            Self::Sinkage => Some((2, -1.0)),
            Self::Displacement => Some((0, 1.0)),
            Self::VerticalForce | Self::Drag | Self::AxleTorque => None,
        }
    }
}

/// A file of a table that a motion follows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MotionTable {
    /// Names of the keys that lead to it: `body`, `disc`, `forward`.
    pub keys: Vec<String>,
    /// Where the file is.
    pub path: PathBuf,
}

/// The stage over which averages are taken: the one that says so; otherwise the last in which a body is
/// towed, or else the last.
pub(crate) fn steady(stages: &[Stage]) -> Option<usize> {
    let tows = |stage: &Stage| stage.changes.iter().any(|change| change.motion < 2 && change.to.may_move());
    let named = stages.iter().position(|stage| stage.steady);
    named.or_else(|| stages.iter().rposition(tows)).or(stages.len().checked_sub(1))
}
