//! `coulter export-fmu`: a case as a functional mock-up unit.

use crate::common::say;
use crate::failure::Failure;
use coulter_fmu::{Fmu, FmuError, Steered, export, library_name};
use std::path::{Path, PathBuf};

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The case file
    case: PathBuf,
    /// How the other simulator moves a body: velocity, pose, load or coupled (as a body of its mechanism);
    /// may be repeated; other bodies move as the case says
    #[arg(long = "steer", value_name = "BODY=HOW")]
    steered: Vec<String>,
    /// Sets a key, such as soil.friction_angle="38 deg"; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
    /// Where to write it [default: the name of the case with .fmu, in the current folder]
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Overwrite an existing file
    #[arg(long)]
    force: bool,
    /// The library that goes into it [default: the one that lies beside this program]
    #[arg(long, value_name = "FILE")]
    library: Option<PathBuf>,
}

pub(super) fn run(program: &Path, arguments: &Arguments) -> Result<(), Failure> {
    let steered = arguments.steered.iter().map(|text| steered(text)).collect::<Result<_, _>>()?;
    let fmu = Fmu::of_file(&arguments.case, &arguments.overrides, &steered).map_err(|error| match error {
        FmuError::Case(error) => error.into(),
        other => Failure::Request(other.to_string()),
    })?;
    let to = arguments.output.clone().unwrap_or_else(|| format!("{}.fmu", fmu.case.name).into());
    if to.exists() && !arguments.force {
        let message = format!("{} exists; use --force to replace it", to.display());
        return Err(Failure::Request(message));
    }
    let library = arguments.library.clone().map_or_else(|| library(program), Ok)?;
    export(&fmu, &library, &to).map_err(|error| Failure::Request(error.to_string()))?;
    say(&format!("{}\n", to.display()))
}

fn steered(text: &str) -> Result<(String, Steered), Failure> {
    let refused = |why: String| Failure::Request(format!("--steer {text}: {why}"));
    let (body, how) = text.split_once('=').ok_or_else(|| refused("write BODY=HOW".to_owned()))?;
    Ok((body.to_owned(), how.parse().map_err(|why: coulter_fmu::UnknownSteering| refused(why.to_string()))?))
}

/// The library, as it is built or installed with the program.
fn library(program: &Path) -> Result<PathBuf, Failure> {
    let name = library_name();
    let own = std::env::current_exe().unwrap_or_else(|_| program.to_path_buf());
    let beside = own.parent().unwrap_or(Path::new("."));
    let places =
        [beside.join("deps").join(&name), beside.join(&name), beside.join("../lib/coulter").join(&name)];
    places.iter().find(|place| place.is_file()).cloned().ok_or_else(|| {
        Failure::Request(format!(
            "{name} is not beside {}: build it from the same source with `cargo build --release -p coulter-fmu`, and name it \
             with --library",
            own.display()
        ))
    })
}
