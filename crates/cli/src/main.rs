//! The `coulter` command.

mod allocator;

use std::process::ExitCode;

#[global_allocator]
static MEMORY: allocator::Memory = allocator::Memory;

fn main() -> ExitCode {
    let program = std::env::current_exe().unwrap_or_else(|_| "coulter".into());
    ExitCode::from(coulter_cli::main(&program, std::env::args_os()))
}
