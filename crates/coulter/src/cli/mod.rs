//! The command line: each command is a call into the library, and the only code that prints.

mod bench;
mod check;
mod failure;
mod forecast;
mod new;
mod pressure;
mod report;
mod run;
mod run_time;
mod schema;
mod signals;
mod verify;

use clap::{Parser, Subcommand};
pub use failure::Failure;
use std::io::Write;
use std::path::Path;
use std::process::ExitCode;

/// Predicts how a rigid object moves through soil.
#[derive(Debug, Parser)]
#[command(name = "coulter", version, arg_required_else_help = true)]
#[command(
    after_help = "Exit codes: 0 done (good or doubtful); 1 broken: do not use the result; 2 the request was wrong; \
130, 143, 129 stopped by SIGINT, SIGTERM, SIGHUP."
)]
pub struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Writes a commented case file to start from
    New(new::Arguments),
    /// Shows how a case is understood and what it will cost; runs nothing
    Check(check::Arguments),
    /// Evaluates every closed-form model for a case, side by side
    Forecast(forecast::Arguments),
    /// Calculates the passive pressure coefficients of a plane face, by every method
    Pressure(pressure::Arguments),
    /// Runs a case
    Run(run::Arguments),
    /// Runs the verification suite: expected, obtained, error
    Verify(verify::Arguments),
    /// Measures the speed of the solver on this machine, by stage
    Bench(bench::Arguments),
    /// Rebuilds report.html from results
    Report(report::Arguments),
    /// Prints the JSON schema of case files, for editors
    Schema,
}

/// Reads and executes the command line; the exit code says how it ended.
#[must_use]
pub fn main() -> ExitCode {
    match Arguments::try_parse() {
        Ok(arguments) => run(&arguments),
        // Help and version go to standard output, which may be full.
        Err(message) if !message.use_stderr() => match say(&message.render().to_string()) {
            Ok(()) => ExitCode::SUCCESS,
            Err(failure) => failure.report(),
        },
        Err(message) => {
            // Where standard error cannot be written, only the exit code remains.
            let _ = message.print();
            ExitCode::from(2)
        }
    }
}

/// Executes the command; the exit code says how it ended.
#[must_use]
pub fn run(arguments: &Arguments) -> ExitCode {
    signals::ignore_file_size_signal();
    let outcome = match &arguments.command {
        Command::New(arguments) => new::new(arguments),
        Command::Check(arguments) => check::check(arguments),
        Command::Forecast(arguments) => forecast::forecast(arguments),
        Command::Pressure(arguments) => pressure::pressure(arguments),
        Command::Run(arguments) => run::run(arguments),
        Command::Verify(arguments) => verify::verify(arguments),
        Command::Bench(arguments) => bench::bench(arguments),
        Command::Report(arguments) => report::report(arguments),
        Command::Schema => schema::schema(),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}

/// The allowed numbers of threads.
fn threads() -> clap::builder::RangedI64ValueParser<u16> {
    clap::value_parser!(u16).range(0..=solver::cpu::threads::MAX_WORKERS as i64)
}

/// Prints to standard output. A reader that has closed the pipe (`| head`) is not an error.
fn say(text: &str) -> Result<(), Failure> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(Failure::Request(format!("cannot write to standard output: {error}")))
        }
        _ => Ok(()),
    }
}

/// Refuses a file where a results folder is expected.
fn refuse_file(folder: &Path) -> Result<(), Failure> {
    if !folder.exists() || folder.is_dir() {
        return Ok(());
    }
    let shown = folder.display();
    Err(Failure::Request(format!(
        "{shown} is a file, not a folder; name a folder for the results with -o DIR"
    )))
}

/// Prints one JSON document.
fn say_json(value: &impl serde::Serialize) -> Result<(), Failure> {
    let text = serde_json::to_string_pretty(value).map_err(|e| Failure::Request(e.to_string()))?;
    say(&format!("{text}\n"))
}
