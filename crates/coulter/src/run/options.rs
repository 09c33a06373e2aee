//! What a run is asked to do, and how it can end.

use crate::blocks::TooManyBlocks;
use crate::interrupts::Interrupts;
use crate::simulation::{Next, ObserverError};
use input::CaseError;
use report::Summary;
use results::OutputError;
use results::history::History;
use solver::device::{Device, DeviceError};
use solver::error::Breakdown;
use solver::halo::{Alone, Communicator};
use std::path::{Path, PathBuf};

/// What to do with a folder that already holds a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// Refuse to start.
    Anew,
    /// Replace the run.
    Replace,
    /// Continue the run from its last checkpoint; start if there is none.
    Resume,
    /// Continue the run as schedulers need it: a finished run is left unchanged, unreadable checkpoints lead
    /// to a new start, and a lock is waited for up to a minute.
    AutoResume,
}

/// How to run.
#[derive(Debug)]
pub struct RunOptions<'a> {
    /// Results folder.
    pub folder: &'a Path,
    /// What to do with an existing run.
    pub start: Start,
    /// Show no progress.
    pub quiet: bool,
    /// Warnings that memory or disk space may not suffice, for the log.
    pub warnings: &'a [String],
    /// Requests from outside during the run.
    pub interrupts: &'a Interrupts,
    /// The case file as typed, with overrides written into it; stored with the results.
    pub typed: &'a str,
    /// Path of the case file, beside which the files that it names lie.
    pub source_name: &'a str,
    /// The communicator of the run, asked for at its start; [`alone`] for a run in one process.
    pub communicator: fn() -> Box<dyn Communicator>,
    /// What strains the soil.
    pub device: Device,
}

impl<'a> RunOptions<'a> {
    /// A run in one process that shows no progress.
    #[must_use]
    pub fn quiet(
        folder: &'a Path,
        start: Start,
        typed: &'a str,
        source_name: &'a str,
        interrupts: &'a Interrupts,
    ) -> Self {
        Self {
            folder,
            start,
            quiet: true,
            warnings: &[],
            interrupts,
            typed,
            source_name,
            communicator: alone,
            device: Device::Processor,
        }
    }
}

/// The communicator of a run in one process.
#[must_use]
pub fn alone() -> Box<dyn Communicator> {
    Box::new(Alone::default())
}

/// A follower of the samples of a run, whatever its precision: the caller of
/// [`run_followed`](super::run_followed).
pub trait Follower {
    /// The history has a new sample, the last one of each of its lists, and the tables and fields of the
    /// folder are up to it. The run waits meanwhile.
    fn sampled(&mut self, history: &History) -> Next;
}

/// Nobody follows the run.
#[derive(Clone, Copy, Debug)]
pub struct NoFollower;

impl Follower for NoFollower {
    fn sampled(&mut self, _: &History) -> Next {
        Next::Continue
    }
}

/// How a run ended.
#[derive(Debug)]
pub enum End {
    /// The run reached its end, now or before.
    Finished(Box<Summary>),
    /// The run was stopped by this signal, or by a follower (0); the checkpoint from which it can be resumed.
    Stopped(i32, PathBuf),
}

/// Why a run did not reach its end.
#[derive(Debug, thiserror::Error)]
pub enum RunError {
    /// The case cannot be simulated; nothing was written.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// The grid cannot be cut into as many blocks as there are processes; nothing was written.
    #[error(transparent)]
    Blocks(#[from] TooManyBlocks),
    /// The device that the run asks for is not there, or cannot run the case; nothing was written.
    #[error("--device: {0}")]
    Device(#[from] DeviceError),
    /// The device was lost, which says nothing of the physics: the run can be resumed from its last
    /// checkpoint.
    #[error(transparent)]
    Lost(Box<Breakdown>),
    /// Another process of the run has failed, and says why.
    #[error("another process of the run has failed")]
    Elsewhere,
    /// Results could not be read or written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// An observer of the run failed in another way.
    #[error(transparent)]
    Observer(ObserverError),
    /// The folder holds the run of another case.
    #[error(
        "{} holds the run of another case file (or of other values of its keys); use --force to start again, or another \
         folder with -o DIR", .0.display()
    )]
    OtherCase(PathBuf),
    /// There is no intact checkpoint to resume from.
    #[error("{}: {problem}; use --force to start again", .path.display())]
    Unusable {
        /// The file.
        path: PathBuf,
        /// What is wrong with the file.
        problem: String,
    },
    /// The physics failed in an earlier run, and would fail again.
    #[error("the run in {} broke down before: {cause}; use --force to start again", .folder.display())]
    BrokeDownBefore {
        /// The cause.
        cause: String,
        /// Folder of the earlier run.
        folder: PathBuf,
    },
    /// The physics failed.
    #[error(
        "{cause}\nthe state at that time is in {} and {}; the last good checkpoint is unchanged",
        .folder.display(), .checkpoint.display()
    )]
    Physics {
        /// The cause.
        cause: Box<Breakdown>,
        /// Folder of the results so far.
        folder: PathBuf,
        /// The checkpoint of the state that failed.
        checkpoint: PathBuf,
    },
}

impl From<ObserverError> for RunError {
    fn from(error: ObserverError) -> Self {
        error.downcast().map_or_else(Self::Observer, |error| Self::Output(*error))
    }
}
