//! What the variations of a case say. The names are part of `summary.json`, a contract.

use super::convergence::Convergence;
use super::wanted::Wanted;
use crate::confidence::variations::ErrorSource;
use crate::trust::Verdict;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The intervals of a run, and the variations that they follow from.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Confidence {
    /// Wall-clock time that the variations were allowed to take together [s]; `null` without a limit.
    pub budget_s: Option<f64>,
    /// Wall-clock time that the variations took [s].
    pub spent_s: f64,
    /// How accurate the figures were to be; nothing without `--accuracy`.
    #[serde(skip_serializing_if = "Wanted::is_nothing")]
    pub wanted: Wanted,
    /// Representative cell width of the case's own mesh [m].
    pub width_m: f64,
    /// The variations, in the order in which they are run.
    pub variations: Vec<VariationResult>,
    /// The bodies by name.
    pub bodies: BTreeMap<String, BodyConfidence>,
}

/// What became of a variation, or of a source of uncertainty.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Status {
    /// The variation was run, and counts.
    Examined,
    /// The variation does not apply to the case.
    NotApplicable,
    /// The variation was not asked for.
    NotAskedFor,
    /// The variation was not run for lack of budget.
    #[default]
    NotExamined,
    /// The variation was run to its end, but cannot be compared.
    NotComparable,
    /// The run of the variation is broken.
    Broken,
}

impl Status {
    /// The status in words.
    #[must_use]
    pub fn words(self) -> &'static str {
        match self {
            Self::Examined => "examined",
            Self::NotApplicable => "does not apply",
            Self::NotAskedFor => "not asked for",
            Self::NotExamined => "not examined",
            Self::NotComparable => "not comparable",
            Self::Broken => "broken",
        }
    }

    /// Whether an interval lacks what it should say.
    #[must_use]
    pub fn is_missing(self) -> bool {
        matches!(self, Self::NotExamined | Self::NotComparable | Self::Broken)
    }
}

/// One variation and its results.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct VariationResult {
    /// Name of the variation.
    pub name: String,
    /// Source of uncertainty that the variation examines.
    pub source: ErrorSource,
    /// What differs from the case, in words.
    pub what: String,
    /// What became of the variation.
    pub status: Status,
    /// Why the variation does not count; `null` where it does.
    pub because: Option<String>,
    /// Folder of the variation below the results folder; empty where it was not run.
    pub folder: String,
    /// Wall-clock time that was predicted from that of the case's own run [s].
    pub predicted_wall_s: Option<f64>,
    /// Wall-clock time that the variation took [s].
    pub wall_s: Option<f64>,
    /// Representative cell width [m].
    pub width_m: f64,
    /// How much longer everything takes that the case prescribes.
    pub time_factor: f64,
    /// Name of the variation from which this one differs, on whose cells it is; `null` where that is the case
    /// itself.
    pub beside: Option<String>,
    /// Grade of the variation's run.
    pub verdict: Option<Verdict>,
    /// Figures by body, averaged over the window of the case's own run.
    pub bodies: BTreeMap<String, BTreeMap<String, f64>>,
}

/// The intervals of a body.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct BodyConfidence {
    /// Why there is no interval; `null` where there are intervals.
    pub no_interval_because: Option<String>,
    /// Change of the force over its mean over the window: of the drag of a body that is towed since the
    /// stretch before the window, of the same length; of the vertical force of one that is pressed over the
    /// window; otherwise `null`. Where it is large, an interval is that of the mean over the window, not of a
    /// load that stays.
    pub force_change: Option<f64>,
    /// Intervals by figure: `drag_N`, `vertical_N`, `lateral_N`, `sinkage_m`, `turn_ratio`; those without a
    /// meaning are left out.
    pub figures: BTreeMap<String, ConfidenceInterval>,
}

/// The interval of a figure (90 %), with what it consists of.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ConfidenceInterval {
    /// The value of the run: its steady mean, in the unit of the figure.
    pub value: f64,
    /// The interval, in the unit of the figure. The value need not lie in its middle.
    pub interval: [f64; 2],
    /// Half of the width of the interval, in the unit of the figure.
    pub half_width: f64,
    /// Half-width over the value; of a force below a tenth of the whole force on the body over that tenth, of
    /// the turn ratio over 1. `null` where the value is 0 and the half-width is not.
    pub relative_half_width: Option<f64>,
    /// The largest contribution; `null` where all are 0.
    pub dominated_by: Option<ErrorSource>,
    /// Whether every source that applies was examined; where not, the interval may be too narrow.
    pub is_complete: bool,
    /// Contributions of the sources of uncertainty to the interval.
    pub contributions: Vec<Contribution>,
}

/// What one source of uncertainty contributes to an interval.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Contribution {
    /// The source.
    pub source: ErrorSource,
    /// Whether the source was examined.
    pub status: Status,
    /// Why the source was not examined; `null` where it was.
    pub because: Option<String>,
    /// Change of the figure by the variation, in the unit of the figure; `null` for mesh and statistics.
    pub change: Option<f64>,
    /// How far the source takes the interval below the value, in the unit of the figure.
    pub below: f64,
    /// How far the source takes the interval above the value, in the unit of the figure.
    pub above: f64,
    /// The larger of both over what half-widths are compared with; `null` where that is 0.
    pub relative: Option<f64>,
    /// How the figure converges, of the mesh; `null` where the mesh was not examined.
    pub convergence: Option<Convergence>,
}

impl Contribution {
    /// The larger of both sides.
    #[must_use]
    pub fn size(&self) -> f64 {
        self.below.max(self.above)
    }
}
