//! What a run is asked to do, and how it can end.

use crate::interrupts::Interrupts;
use crate::output::OutputError;
use crate::output::summary::Summary;
use solver::error::Breakdown;
use std::path::{Path, PathBuf};

/// What to do with a folder that holds a run already.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// Refuse.
    Anew,
    /// Replace it.
    Replace,
    /// Go on with it from its last checkpoint; start if there is nothing.
    Resume,
    /// The same, for schedulers: a run that has come to its end is left as it is, checkpoints that cannot be read are no
    /// reason to fail, and a lock that goes away within a minute is waited for.
    AutoResume,
}

/// How to run.
#[derive(Debug)]
pub struct Options<'a> {
    /// Results folder.
    pub folder: &'a Path,
    /// What to do with what is there.
    pub start: Start,
    /// Show no progress.
    pub quiet: bool,
    /// Doubts whether the machine suffices, for the log.
    pub doubts: &'a [String],
    /// What is asked from outside while it runs.
    pub interrupts: &'a Interrupts,
    /// The case file as typed, with overrides written in; kept beside the results.
    pub typed: &'a str,
}

/// How a run ended.
#[derive(Debug)]
pub enum End {
    /// It came to its end, now or before.
    Finished(Box<Summary>),
    /// It was stopped by this signal; here is the checkpoint to go on from.
    Stopped(i32, PathBuf),
}

/// Why a run did not come to its end.
#[derive(Debug, thiserror::Error)]
pub enum RunError {
    /// Results could not be read or written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// The folder belongs to another case.
    #[error(
        "{} holds the run of another case file (or of other values of its keys); run with --force to start anew, or write \
         somewhere else with -o DIR", .0.display()
    )]
    OtherCase(PathBuf),
    /// There is nothing whole to go on from.
    #[error("{}: {problem}; run with --force to start anew", .path.display())]
    Unusable {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        problem: String,
    },
    /// The physics failed before, and would again.
    #[error("the run in {} broke down before: {cause}; run with --force to start anew", .folder.display())]
    BrokeDownBefore {
        /// How.
        cause: String,
        /// Where it is.
        folder: PathBuf,
    },
    /// The physics failed.
    #[error(
        "{cause}\nthe state at that time is in {} and {}; the last good checkpoint is kept beside it",
        .folder.display(), .checkpoint.display()
    )]
    Physics {
        /// How.
        cause: Box<Breakdown>,
        /// Where the results so far are.
        folder: PathBuf,
        /// The checkpoint of the state that failed.
        checkpoint: PathBuf,
    },
}
