//! What a checkpoint holds, and the version of it.

use crate::history::History;
use crate::history::probes::LastSample;
use serde::{Deserialize, Serialize};
use solver::grid::Grid;
use solver::halo::Halo;
use solver::precision::Precision;
use solver::state::State;
use std::ops::Range;

/// First bytes of every checkpoint.
pub(super) const MAGIC: &[u8; 7] = b"COULTER";
/// Version of what follows, where that is not in the layout of its types: what a number means, how a file is
/// packed.
pub(super) const VERSION: u8 = b'K';

/// Soil and nodes of a block, in a file of their own beside the checkpoint.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct PortionFile {
    /// Name of the file.
    pub(super) name: String,
    /// Layers of cells of the whole grid along x, y, z that it holds.
    pub(super) layers: [Range<usize>; 3],
    /// Hash of the content of the file.
    pub(super) hash: u64,
}

/// The content of a checkpoint.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct Checkpoint<R = f64> {
    /// Name of the precision of the fields. This stands first, so that it can be read whatever the precision
    /// is.
    pub precision: String,
    /// The resolved case, as text; a run must not resume with another.
    pub case: String,
    /// The state of the solver; without soil and nodes as long as these are in files of their own.
    pub state: State<R>,
    /// Files of soil and nodes; none where the grid was in one block.
    pub(super) portions: Vec<PortionFile>,
    /// The history so far.
    pub history: History,
    /// Time and impulses at the last sample.
    pub last_sample: LastSample,
}

/// The content of a checkpoint, borrowed from a run that continues.
#[derive(Debug)]
pub struct CheckpointView<'a, R> {
    /// Name of the precision of the fields.
    pub precision: &'static str,
    /// The resolved case, as text.
    pub case: String,
    /// The state of the solver.
    pub state: &'a State<R>,
    /// The grid, or the block of it that this process has, and its halo.
    pub block: (&'a Grid, &'a Halo),
    /// The history so far.
    pub history: &'a History,
    /// Time and impulses at the last sample.
    pub last_sample: &'a LastSample,
}

/// The part of a checkpoint that is written into the main file, in the order of [`Checkpoint`].
#[derive(Debug, Serialize)]
pub(super) struct Record<'a, R> {
    pub(super) precision: &'static str,
    pub(super) case: &'a str,
    pub(super) state: &'a State<R>,
    pub(super) portions: &'a [PortionFile],
    pub(super) history: &'a History,
    pub(super) last_sample: &'a LastSample,
}

impl<R: Precision> CheckpointView<'_, R> {
    /// The content of the checkpoint, owned.
    #[must_use]
    pub fn kept(&self) -> Checkpoint<R> {
        Checkpoint {
            precision: self.precision.to_owned(),
            case: self.case.clone(),
            state: self.state.clone(),
            portions: Vec::new(),
            history: self.history.clone(),
            last_sample: self.last_sample.clone(),
        }
    }
}
