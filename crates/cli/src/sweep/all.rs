//! `coulter sweep STUDY.toml`: a whole study on this machine.

use super::collect::written;
use super::expand::summary;
use super::run::{pooled, shared, stopped};
use super::source::Source;
use super::study::pool_of;
use crate::common::{DeviceOption, require_device, say};
use crate::failure::Failure;
use crate::signals;

#[derive(Debug, clap::Args)]
#[group(id = "whole study")] // a name of its own beside that of the steps, which a build with checks demands
pub(super) struct Arguments {
    #[command(flatten)]
    source: Source,
    /// Cases that run at the same time [default: as many as cores and memory allow]
    #[arg(long, value_name = "N", value_parser = crate::common::workers())]
    workers: Option<u16>,
    /// Threads of each run of the solver [default: those of the study, usually 1]
    #[arg(long, value_name = "N", value_parser = crate::common::study_threads())]
    threads: Option<u16>,
    #[command(flatten)]
    on: DeviceOption,
    /// Print one JSON document
    #[arg(long)]
    json: bool,
}

pub(super) fn all(arguments: &Arguments) -> Result<(), Failure> {
    require_device(arguments.on.device)?;
    let expanded = arguments.source.expanded()?;
    if !arguments.json {
        say(&summary(&expanded))?;
    }
    let pool = pool_of(&expanded.study, arguments.workers, arguments.threads);
    let shared = shared(&expanded.store, pool.threads, arguments.on.device, signals::listen())?;
    let end = pooled(&shared, &expanded.lines, &pool, arguments.json);
    if let Some(signal) = end.stopped {
        return Err(stopped(signal));
    }
    written(&expanded, arguments.json)
}
