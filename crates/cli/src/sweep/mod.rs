//! `coulter sweep`: studies of cases that vary.

mod all;
mod collect;
mod expand;
mod folder;
mod run;
mod script;
mod source;
mod study;
mod teller;

use crate::failure::Failure;
use std::path::Path;

pub use study::{SweepRequest, SweptStudy, sweep_study};

#[derive(Debug, clap::Args)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
pub(super) struct Arguments {
    #[command(subcommand)]
    step: Option<Step>,
    #[command(flatten)]
    all: all::Arguments,
}

#[derive(Debug, clap::Subcommand)]
enum Step {
    /// Lists the cases of a study in cases.jsonl, each with an id; runs nothing
    Expand(expand::Arguments),
    /// Runs the cases of these ids, or those that are left; a case that has an outcome is left as it is
    Run(run::Arguments),
    /// Puts the outcomes into tables, charts and a page; lists what is missing and why
    Collect(collect::Arguments),
    /// Prints a script that runs the cases that are left with another engine
    Script(script::Arguments),
}

pub(super) fn sweep(program: &Path, arguments: &Arguments) -> Result<(), Failure> {
    match &arguments.step {
        None => all::all(&arguments.all),
        Some(Step::Expand(arguments)) => expand::expand(arguments),
        Some(Step::Run(arguments)) => run::run(arguments),
        Some(Step::Collect(arguments)) => collect::collect(arguments),
        Some(Step::Script(arguments)) => script::script(program, arguments),
    }
}
