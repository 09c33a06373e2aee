//! The balances of a run that a benchmark made: energy, volume, mass.

use crate::trace::Trace;
use coulter::history::{BodySample, EnergySample};
use coulter::trust::Trust;
use serde::{Deserialize, Serialize};

/// The balances of one run at its end.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct RunBalances {
    /// Benchmark.
    #[serde(skip)]
    pub id: &'static str,
    /// Variant of the benchmark.
    pub case: String,
    /// Energy.
    pub energy: EnergySample,
    /// Largest relative change of the soil volume since the start, at any time.
    pub volume_error: f64,
    /// Largest portion of the soil's mass at any time in overdense soil.
    pub overdense: f64,
    /// Relative change of the soil's mass, VOF debris included.
    pub mass_error: f64,
    /// Whether the soil dilates, so that its volume is expected to grow.
    pub dilates: bool,
    /// The bodies at the end.
    pub bodies: Vec<BodySample>,
    /// Wall-clock time [s].
    pub seconds: f64,
    /// What the run did.
    pub trace: Trace,
    /// The grade that a user would be given.
    pub trust: Trust,
}
