//! `coulter sweep run`: cases of a study, by their ids or all that are left.

use super::folder::{opened, refused};
use super::teller::{Teller, told};
use crate::common::{DeviceOption, require_device, say, warn};
use crate::failure::Failure;
use crate::signals;
use coulter::case::cores;
use coulter::interrupts::Interrupts;
use coulter::run::Device;
use std::path::PathBuf;
use studies::study::Pool;
use studies::sweep::evaluate::{Shared, Unended, evaluate};
use studies::sweep::line::CaseLine;
use studies::sweep::outcome::Ending;
use studies::sweep::pool::{self, PoolEnd};
use studies::sweep::store::Store;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// Folder of a study that was expanded, or its file where that is results/NAME
    study: PathBuf,
    /// Ids of cases, separated by commas; may be repeated [default: all that are left]
    #[arg(long = "id", value_name = "ID", value_delimiter = ',')]
    ids: Vec<String>,
    /// Threads of each run of the solver
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = crate::common::study_threads())]
    threads: u16,
    /// Without --id: cases that run at the same time [default: as many as cores and memory allow]
    #[arg(long, value_name = "N", value_parser = crate::common::workers())]
    workers: Option<u16>,
    #[command(flatten)]
    on: DeviceOption,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    require_device(arguments.on.device)?;
    let threads = usize::from(arguments.threads);
    let shared = shared(&opened(&arguments.study)?, threads, arguments.on.device, signals::listen())?;
    if !arguments.ids.is_empty() {
        return some(&shared, &arguments.ids);
    }
    let lines = shared.store.lines().map_err(refused)?;
    let pool = Pool { workers: arguments.workers.map(usize::from), threads };
    let end = pooled(&shared, &lines, &pool, false);
    match (end.stopped, end.failed) {
        (Some(signal), _) => Err(stopped(signal)),
        (None, 0) => Ok(()),
        (None, failed) => {
            let message = format!("{failed} cases could not be run; `coulter sweep collect` says why");
            Err(Failure::Request(message))
        }
    }
}

/// Runs the cases of these ids one after the other. One that fails does not keep the others from being run.
fn some(shared: &Shared, ids: &[String]) -> Result<(), Failure> {
    let lines = shared.store.find(ids).map_err(refused)?;
    let (mut broken, mut failed) = (Vec::new(), Vec::new());
    for line in &lines {
        match evaluate(shared, line) {
            Ok(outcome) if outcome.ending == Ending::Done => say(&format!("{}\n", told(line, &Ok(outcome))))?,
            Ok(outcome) => broken.push(format!("{} {}: {}", line.id, outcome.ending.word(), outcome.reason)),
            Err(Unended::Stopped(signal)) => return Err(stopped(signal)),
            Err(why) => failed.push(format!("{}: {why}", line.id)),
        }
    }
    match (failed.is_empty(), broken.is_empty()) {
        (true, true) => Ok(()),
        (true, false) => Err(Failure::Physics(broken.join("\n"))),
        (false, _) => Err(Failure::Request([failed, broken].concat().join("\n"))),
    }
}

/// The failure of a study that a signal has stopped.
pub(super) fn stopped(signal: i32) -> Failure {
    let message = "stopped; what has ended is kept, and the same command goes on from here".to_owned();
    Failure::Stopped { signal, message }
}

/// Runs what is left of a study on this machine and tells how it gets on; `quiet`, nothing on standard
/// output.
pub(super) fn pooled(shared: &Shared, lines: &[CaseLine], pool: &Pool, quiet: bool) -> PoolEnd {
    if pool.workers.is_none() {
        warn(&cores::cores().notes);
    }
    let teller = Teller::of(shared, lines, quiet);
    let end = pool::run(shared, lines, pool, &teller);
    teller.end();
    end
}

/// What all cases of a study on this machine share.
pub(super) fn shared(
    store: &Store,
    threads: usize,
    device: Device,
    interrupts: Interrupts,
) -> Result<Shared, Failure> {
    let cases = store.origin().map_err(refused)?.cases;
    Ok(Shared { store: store.clone(), cases, threads, device, interrupts })
}
