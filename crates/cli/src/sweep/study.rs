//! A whole study on this machine, for whoever asks for it.

use super::folder::{expanded, refused};
use super::run::{shared, stopped};
use crate::common::{STUDY_THREADS, WORKERS, require_device, require_range};
use crate::failure::Failure;
use coulter::interrupts::Interrupts;
use coulter::run::Device;
use std::path::PathBuf;
use studies::study::{Pool, Study};
use studies::sweep::collect::{Counts, collect};
use studies::sweep::pool::{self, Watcher};
use studies::sweep::report;

/// A study that is to be run, and how.
#[derive(Clone, Debug)]
pub struct SweepRequest {
    /// The study file.
    pub study: PathBuf,
    /// The quick version: fewer levels, cheaper runs, as the study file says.
    pub quick: bool,
    /// Folder of the study; by default `results/NAME`, of the quick version `results/NAME_quick`.
    pub output: Option<PathBuf>,
    /// Cases that run at the same time; by default those of the study, or as many as cores and memory allow.
    pub workers: Option<u16>,
    /// Threads of each run of the solver; by default those of the study.
    pub threads: Option<u16>,
    /// What strains the soil.
    pub device: Device,
}

/// A study that has been run and collected.
#[derive(Clone, Debug)]
pub struct SweptStudy {
    /// Folder of the study.
    pub folder: PathBuf,
    /// How many cases of the study have become what.
    pub counts: Counts,
}

/// Expands a study, runs what is left of it and writes its tables, charts and page, as `coulter sweep` does.
///
/// # Errors
/// [`Failure`] where the study is wrong, its folder cannot be used, or `interrupts` have stopped it; what has
/// ended is kept.
pub fn sweep_study(
    request: &SweepRequest,
    interrupts: &Interrupts,
    watcher: &dyn Watcher,
) -> Result<SweptStudy, Failure> {
    require_range("workers", request.workers, WORKERS)?;
    require_range("threads", request.threads, STUDY_THREADS)?;
    require_device(request.device)?;
    let expanded = expanded(&request.study, request.quick, request.output.as_deref())?;
    let pool = pool_of(&expanded.study, request.workers, request.threads);
    let shared = shared(&expanded.store, pool.threads, request.device, interrupts.clone())?;
    if let Some(signal) = pool::run(&shared, &expanded.lines, &pool, watcher).stopped {
        return Err(stopped(signal));
    }
    let collected = collect(&expanded.store, &expanded.study, &expanded.lines);
    report::write(&expanded.store, &expanded.study, &collected).map_err(refused)?;
    Ok(SweptStudy { folder: expanded.store.folder, counts: collected.counts })
}

/// The pool of a study, as it states it or as it is asked for.
pub(super) fn pool_of(study: &Study, workers: Option<u16>, threads: Option<u16>) -> Pool {
    Pool {
        workers: workers.map(usize::from).or(study.pool.workers),
        threads: threads.map_or(study.pool.threads, usize::from),
    }
}
