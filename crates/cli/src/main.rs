//! The `coulter` command: each command is a call into the library, and this is the only crate that prints.

mod bench;
mod check;
mod common;
mod element;
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
use common::say;
use std::process::ExitCode;

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
    /// Shows how a case is understood and what it will cost; runs nothing
    Check(check::Arguments),
    /// Tests the soil of a case as in the laboratory: triaxial, oedometer, isotropic compression, simple shear
    Element(element::Arguments),
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
fn main() -> ExitCode {
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
fn run(arguments: &Arguments) -> ExitCode {
    signals::ignore_file_size_signal();
    let outcome = match &arguments.command {
        Command::New(arguments) => new::new(arguments),
        Command::Check(arguments) => check::check(arguments),
        Command::Element(arguments) => element::element(arguments),
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
