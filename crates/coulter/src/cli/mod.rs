//! The command line: each command is a call into the library, and the only code that prints.

mod bench;
mod check;
mod failure;
mod forecast;
mod new;
mod pressure;
mod report;
mod run;
mod schema;
mod signals;
mod speed;
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
    after_help = "Exit codes: 0 done (good or doubtful); 1 broken: the result is not to be used; 2 the request was wrong; \
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
    /// Says how a case is understood and what it will cost; runs nothing
    Check(check::Arguments),
    /// What the closed-form models say of a case, side by side, at once
    Forecast(forecast::Arguments),
    /// Passive pressure coefficients of a plane face, by every method
    Pressure(pressure::Arguments),
    /// Runs a case
    Run(run::Arguments),
    /// Runs the verification suite: expected, obtained, error
    Verify(verify::Arguments),
    /// Measures how fast the solver is on this machine, and where the time goes
    Bench(bench::Arguments),
    /// Rebuilds report.html from results
    Report(report::Arguments),
    /// Prints the JSON schema of case files, for editors
    Schema,
}

/// Reads the command line and does what it asks; the exit code says how it went.
#[must_use]
pub fn main() -> ExitCode {
    match Arguments::try_parse() {
        Ok(arguments) => run(&arguments),
        // Help and version go to standard output, which may be full.
        Err(told) if !told.use_stderr() => match say(&told.render().to_string()) {
            Ok(()) => ExitCode::SUCCESS,
            Err(failure) => failure.tell(),
        },
        Err(told) => {
            // Where standard error cannot be written, the exit code is all there is.
            let _ = told.print();
            ExitCode::from(2)
        }
    }
}

/// Does what was asked; the exit code says how it went.
#[must_use]
pub fn run(arguments: &Arguments) -> ExitCode {
    signals::outlive_file_limits();
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
        Err(failure) => failure.tell(),
    }
}

/// Numbers of threads that a team may have.
fn threads() -> clap::builder::RangedI64ValueParser<u16> {
    clap::value_parser!(u16).range(0..=solver::cpu::threads::MOST as i64)
}

/// Prints to standard output. A reader that has gone away (`| head`) is no error.
fn say(text: &str) -> Result<(), Failure> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(Failure::Request(format!("cannot write to standard output: {error}")))
        }
        _ => Ok(()),
    }
}

/// Refuses a file where a folder of results is to be.
fn is_no_file(folder: &Path) -> Result<(), Failure> {
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
