//! What a checkpoint holds, and the version of it.

use crate::history::History;
use crate::history::probes::LastSample;
use serde::{Deserialize, Serialize};
use solver::precision::Precision;
use solver::state::State;

/// What every checkpoint begins with.
pub(super) const MAGIC: &[u8; 7] = b"COULTER";
/// Version of what follows; a checkpoint of another version cannot be resumed.
pub(super) const VERSION: u8 = b'G';

/// What a checkpoint holds.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct Checkpoint<R = f64> {
    /// Name of the precision of its fields. It stands first, so that it can be read whatever it is.
    pub precision: String,
    /// The resolved case, as text; a run must not resume with another.
    pub case: String,
    /// The state of the solver.
    pub state: State<R>,
    /// The history so far.
    pub history: History,
    /// Time and impulses at the last sample.
    pub last_sample: LastSample,
}

/// The same, borrowed from a run that continues.
#[derive(Clone, Debug, Serialize)]
pub struct CheckpointView<'a, R> {
    /// Name of the precision of its fields.
    pub precision: &'static str,
    /// The resolved case, as text.
    pub case: String,
    /// The state of the solver.
    pub state: &'a State<R>,
    /// The history so far.
    pub history: &'a History,
    /// Time and impulses at the last sample.
    pub last_sample: &'a LastSample,
}

impl<R: Precision> CheckpointView<'_, R> {
    /// The same, owned.
    #[must_use]
    pub fn kept(&self) -> Checkpoint<R> {
        Checkpoint {
            precision: self.precision.to_owned(),
            case: self.case.clone(),
            state: self.state.clone(),
            history: self.history.clone(),
            last_sample: self.last_sample.clone(),
        }
    }
}
