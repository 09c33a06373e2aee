//! The `coulter` command; everything it does is in the library.

use std::process::ExitCode;

fn main() -> ExitCode {
    coulter::cli::main()
}
