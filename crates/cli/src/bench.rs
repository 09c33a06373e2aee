//! `coulter bench`: how fast the solver is on this machine.

use crate::common::{say, say_json};
use crate::failure::Failure;
use coulter::bench::{self, Options, TOWED_DISC};
use coulter::case;
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The case file [default: the towed disc, 20 mm deep and moving]
    case: Option<PathBuf>,
    /// Sets a key, such as grid.cell="5 mm"; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
    /// Threads to compare with one; 0 for one per core
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = crate::common::threads())]
    threads: u16,
    /// Steps before the measurement
    #[arg(long, value_name = "N", default_value_t = 500)]
    warm_up: u32,
    /// Steps to measure
    #[arg(long, value_name = "N", default_value_t = 1500, value_parser = clap::value_parser!(u32).range(1..))]
    steps: u32,
    /// Print one JSON document
    #[arg(long)]
    json: bool,
}

pub(super) fn bench(arguments: &Arguments) -> Result<(), Failure> {
    let case = match &arguments.case {
        Some(path) => case::load(path, &arguments.overrides)?,
        None => {
            let (text, moving) = TOWED_DISC;
            let overrides: Vec<String> =
                moving.iter().map(ToString::to_string).chain(arguments.overrides.iter().cloned()).collect();
            case::parse(text, "light_disc.toml", &overrides)?
        }
    };
    let cores = || std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let threads = if arguments.threads == 0 { cores() } else { usize::from(arguments.threads) };
    let options = Options { case, threads, warm_up: arguments.warm_up, steps: arguments.steps };
    let measured = bench::measure(&options).map_err(|cause| Failure::Physics(cause.to_string()))?;
    if arguments.json {
        return say_json(&measured);
    }
    say(&bench::table(&measured))
}
