//! The command, for the console script of the wheel.

use pyo3::prelude::*;
use std::ffi::OsString;
use std::path::PathBuf;

/// Executes a command line, the name of the program first, as the `coulter` program does; returns its exit
/// code. It installs its own signal handlers and is for a process of its own.
#[pyfunction]
pub(crate) fn main(py: Python<'_>, program: PathBuf, arguments: Vec<OsString>) -> u8 {
    py.detach(|| coulter_cli::main(&program, arguments))
}
