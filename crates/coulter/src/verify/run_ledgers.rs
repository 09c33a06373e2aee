//! The ledgers of a run that a benchmark made.

use super::trace::Trace;
use crate::history::{BodySample, EnergySample};
use crate::trust::Trust;
use serde::{Deserialize, Serialize};

/// The ledgers of one run at its end.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Ledgers {
    /// Benchmark.
    #[serde(skip)]
    pub id: &'static str,
    /// Which variant.
    pub case: String,
    /// Energy.
    pub energy: EnergySample,
    /// Largest departure of the soil volume from that at the start, at any time, as a share.
    pub volume_off: f64,
    /// Change of the soil's mass, crumbs counted, as a share.
    pub mass_off: f64,
    /// Whether the soil dilates, so that its volume is meant to grow.
    pub dilates: bool,
    /// The bodies at the end.
    pub bodies: Vec<BodySample>,
    /// Wall clock [s].
    pub seconds: f64,
    /// What the run did.
    pub trace: Trace,
    /// Whether it would be believed.
    pub trust: Trust,
}
