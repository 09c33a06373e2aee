//! The `coulter` command: each command is a call into the library, and this is the only crate that prints.
//!
//! [`main`] is the command, for the program and for the Python package. What the package shares with the
//! commands beyond the library is public here: [`RunRequest`], [`SweepRequest`], [`check_document`],
//! and [`Failure`] with its texts.

mod bench;
mod calibrate;
mod check;
mod common;
mod compare;
mod element;
mod export_fields;
mod export_fmu;
mod failure;
mod forecast;
mod import;
mod manual;
mod new;
mod pressure;
mod processes;
mod render;
mod report;
mod run;
mod run_time;
mod schema;
mod signals;
mod sweep;
mod verify;

use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
use common::{say, tell};
use coulter::printed::plain;
use std::borrow::Cow;
use std::ffi::OsString;
use std::path::Path;

pub use check::{check_document, check_text};
pub use common::{asked, budget, error_source};
pub use failure::{Failure, problems_text};
pub use run::{PreparedRun, RunRequest, graded};
pub use sweep::{SweepRequest, SweptStudy, sweep_study};

/// Predicts how a rigid object moves through soil.
#[derive(Debug, Parser)]
#[command(name = "coulter", version, arg_required_else_help = true)]
#[command(
    after_help = "Exit codes: 0 done (good or doubtful); 1 broken: do not use the result; 2 the request was wrong; \
130, 143, 129 stopped by SIGINT, SIGTERM, SIGHUP."
)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Writes a commented case file to start from
    New(new::Arguments),
    /// Writes a case from an input deck of Abaqus, with a report of what became of every keyword
    Import(import::Arguments),
    /// Shows how a case is understood and what it will cost; runs nothing
    Check(check::Arguments),
    /// Tests the soil of a case as in the laboratory: triaxial, oedometer, isotropic compression, simple
    /// shear
    Element(element::Arguments),
    /// Evaluates every closed-form model for a case, side by side
    Forecast(forecast::Arguments),
    /// Finds soil and contact parameters from measured curves, with their intervals
    Calibrate(calibrate::Arguments),
    /// Puts runs, closed forms and measurements side by side
    Compare(compare::Arguments),
    /// Calculates the passive pressure coefficients of a plane face, by every method
    Pressure(pressure::Arguments),
    /// Runs a case
    Run(run::Arguments),
    /// Runs a study: many cases that vary, by the closed forms, the solver or both; then tables, charts and a
    /// page
    Sweep(sweep::Arguments),
    /// Writes a case as a functional mock-up unit, which other simulators drive (FMI 3.0, co-simulation)
    ExportFmu(export_fmu::Arguments),
    /// Writes the fields of a run as VTKHDF, under the names of Abaqus: EVF, S, PEEQ, V, U, RF
    ExportFields(export_fields::Arguments),
    /// Runs the verification suite: expected, obtained, error
    Verify(verify::Arguments),
    /// Measures the speed of the solver on this machine, by stage; with --device also whether all bits are
    /// those of the processor
    Bench(bench::Arguments),
    /// Rebuilds report.html from results
    Report(report::Arguments),
    /// Draws soil and bodies in space: a picture and an animation, without a display
    Render(render::Arguments),
    /// Prints the JSON schema of case files, for editors; with --study that of study files
    Schema(schema::Arguments),
    /// Prints the script that completes commands and options in a shell: bash, elvish, fish, powershell, zsh
    Completions(manual::CompletionArguments),
    /// Writes the manual pages
    Man(manual::ManArguments),
}

/// Reads and executes a command line, the name of the program first; `program` is how scripts start this
/// command. The exit code says how it ended: 0 done (good or doubtful), 1 broken, 2 the request was wrong,
/// 128 + n stopped by signal n.
#[must_use]
pub fn main(program: &Path, arguments: impl IntoIterator<Item = OsString>) -> u8 {
    match parsed(arguments) {
        Ok(arguments) => execute(program, &arguments),
        // Help and version go to standard output, which may be full.
        Err(message) if !message.use_stderr() => match say(&message.render().to_string()) {
            Ok(()) => 0,
            Err(failure) => failure.report(),
        },
        Err(message) => {
            // Where standard error cannot be written, only the exit code remains. Colours are for what holds
            // nothing that acts on a terminal.
            let text = message.render().to_string();
            match plain(&text) {
                Cow::Borrowed(_) => drop(message.print()),
                Cow::Owned(shown) => tell(shown.trim_end()),
            }
            2
        }
    }
}

/// The arguments of a command line.
fn parsed(arguments: impl IntoIterator<Item = OsString>) -> Result<Arguments, clap::Error> {
    let mut command = with_negative_numbers(Arguments::command());
    let mut matches = command.try_get_matches_from_mut(arguments)?;
    Arguments::from_arg_matches_mut(&mut matches).map_err(|error| error.format(&mut command))
}

/// A command whose options take a negative number for a value, so that `--threads -1` is refused for its
/// range and not as an unknown option `-1`.
fn with_negative_numbers(command: clap::Command) -> clap::Command {
    let takes = |argument: &clap::Arg| argument.get_long().is_some() && argument.get_action().takes_values();
    command
        .mut_args(|argument| if takes(&argument) { argument.allow_negative_numbers(true) } else { argument })
        .mut_subcommands(with_negative_numbers)
}

/// Executes the command; the exit code says how it ended.
fn execute(program: &Path, arguments: &Arguments) -> u8 {
    signals::ignore_file_size_signal();
    let outcome = match &arguments.command {
        Command::New(arguments) => new::new(arguments),
        Command::Import(arguments) => import::run(arguments),
        Command::Check(arguments) => check::check(arguments),
        Command::Element(arguments) => element::element(arguments),
        Command::Forecast(arguments) => forecast::forecast(arguments),
        Command::Calibrate(arguments) => calibrate::run(arguments),
        Command::Compare(arguments) => compare::run(arguments),
        Command::Pressure(arguments) => pressure::pressure(arguments),
        Command::Run(arguments) => run::run(arguments),
        Command::Sweep(arguments) => sweep::sweep(program, arguments),
        Command::ExportFmu(arguments) => export_fmu::run(program, arguments),
        Command::ExportFields(arguments) => export_fields::run(arguments),
        Command::Verify(arguments) => verify::verify(arguments),
        Command::Bench(arguments) => bench::bench(arguments),
        Command::Report(arguments) => report::report(arguments),
        Command::Render(arguments) => render::run(arguments),
        Command::Schema(arguments) => schema::schema(arguments),
        Command::Completions(arguments) => manual::completions(Arguments::command(), arguments),
        Command::Man(arguments) => manual::man(Arguments::command(), arguments),
    };
    match outcome {
        Ok(()) => 0,
        Err(failure) => failure.report(),
    }
}
