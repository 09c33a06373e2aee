//! The `coulter` command; everything it does is in the library.

use clap::Parser;
use std::process::ExitCode;

fn main() -> ExitCode {
    coulter::cli::run(&coulter::cli::Arguments::parse())
}
