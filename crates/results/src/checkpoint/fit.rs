//! Whether a checkpoint that was read is one of a case: code that goes on from it assumes that it has as many
//! of everything.

use super::contents::Checkpoint;
use crate::history::probes::places;
use crate::history::rim::RimHistory;
use case::Case;
use mechanics::Motion;
use solver::model::Model;
use solver::precision::Precision;
use solver::state::Body;

/// Most samples of a run, far from what their number can hold (chosen).
const MOST_SAMPLES: usize = 1 << 48;

impl<R: Precision> Checkpoint<R> {
    /// Whether the checkpoint can be a checkpoint of a run of a case; the model is that of the case, its grid
    /// that on which the state was read.
    #[must_use]
    pub fn is_of(&self, case: &Case, model: &Model) -> bool {
        self.state.is_of(model) && self.has_history_of(case) && self.has_stages_of(case)
    }

    fn has_history_of(&self, case: &Case) -> bool {
        let (history, bodies) = (&self.history, case.bodies.len());
        let (parts, joints) = (places(case), &case.joints);
        let mut rims = history.rims.iter().zip(&self.state.bodies);
        history.names.iter().eq(case.bodies.iter().map(|body| &body.name))
            && history.part_names.iter().eq(parts.iter().map(|(name, _)| name))
            && history.joint_names.iter().eq(joints.iter().map(|joint| &joint.name))
            && [history.bodies.len(), history.rims.len(), self.last_sample.impulses.len()] == [bodies; 3]
            && [history.parts.len(), history.joints.len()] == [parts.len(), joints.len()]
            && rims.all(|(rim, body)| is_of(rim, body))
    }

    fn has_stages_of(&self, case: &Case) -> bool {
        let stages = &self.history.stages;
        stages.is_empty() == case.stages.is_empty()
            && stages.len() <= case.stages.len()
            && stages.iter().all(|stage| stage.motions.len() == case.bodies.len())
            && stages.iter().flat_map(|stage| &stage.motions).flatten().all(Motion::is_sound)
    }
}

/// Whether the history of a rim is that of a body.
fn is_of(rim: &RimHistory, body: &Body) -> bool {
    let sums = rim.bins.len() + 1;
    sums == body.rim.len()
        && rim.stride.is_power_of_two()
        && rim.stride < MOST_SAMPLES
        && rim.records.iter().all(|record| record.sums.len() == sums && record.number < MOST_SAMPLES)
}
