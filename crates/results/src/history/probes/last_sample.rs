//! What the probes remember from one sample to the next.

use mechanics::Wrench;
use serde::{Deserialize, Serialize};
use solver::state::{ContactImpulse, State};

/// Time and impulses at the last sample. Part of a checkpoint: the next forces are averages since then.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LastSample {
    /// Time [s].
    pub time: f64,
    /// Impulse of the soil on each body since the start.
    pub impulses: Vec<ContactImpulse>,
    /// Impulse of the soil on each part of each body since the start.
    pub parts: Vec<Vec<ContactImpulse>>,
    /// Impulse of each joint on its second body since the start.
    pub joints: Vec<Wrench>,
}

impl LastSample {
    /// Time and impulses of a state.
    #[must_use]
    pub fn of<R>(state: &State<R>) -> Self {
        Self {
            time: state.time,
            impulses: state.bodies.iter().map(|body| body.contact_impulse).collect(),
            parts: state.bodies.iter().map(|body| body.parts.clone()).collect(),
            joints: state.mechanism.joints.iter().map(|joint| joint.on_second).collect(),
        }
    }
}
