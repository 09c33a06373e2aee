//! `coulter completions` and `coulter man`: what a shell and `man` want to know of the command.

use crate::common::say;
use crate::failure::Failure;
use clap::Command;
use clap_complete::Shell;
use std::path::PathBuf;

/// The name of the command in scripts and manual pages.
const NAME: &str = "coulter";

#[derive(Debug, clap::Args)]
pub(super) struct CompletionArguments {
    /// The shell that will read it
    shell: Shell,
}

#[derive(Debug, clap::Args)]
pub(super) struct ManArguments {
    /// An existing folder, such as ~/.local/share/man/man1: a page for the command and one for each of its
    /// subcommands are written there
    #[arg(value_name = "DIR")]
    folder: PathBuf,
}

/// Prints the script that completes the options and subcommands of a command.
pub(super) fn completions(mut command: Command, arguments: &CompletionArguments) -> Result<(), Failure> {
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut command, NAME, &mut script);
    say(&String::from_utf8_lossy(&script))
}

/// Writes the manual pages of a command and its subcommands.
pub(super) fn man(command: Command, arguments: &ManArguments) -> Result<(), Failure> {
    let folder = &arguments.folder;
    if !folder.is_dir() {
        return Err(Failure::Request(format!("{} is not a folder; make it first", folder.display())));
    }
    clap_mangen::generate_to(command, folder)
        .map_err(|error| Failure::Request(format!("cannot write to {}: {error}", folder.display())))?;
    say(&format!("{}\n", folder.join("coulter.1").display()))
}
