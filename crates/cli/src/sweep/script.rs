//! `coulter sweep script`: a study for other engines.

use super::folder::{opened, refused};
use crate::common::{DeviceOption, say};
use crate::failure::Failure;
use std::path::{Path, PathBuf};
use studies::sweep::script::{self, ENGINES, Wish};

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// Folder of a study that was expanded, or its file where that is results/NAME
    study: PathBuf,
    /// The engine; `ids` prints the ids that are left, one a line, for any other
    #[arg(long = "for", value_name = "ENGINE", value_parser = clap::builder::PossibleValuesParser::new(ENGINES))]
    engine: String,
    /// Cases of one job or task, which it runs one after the other
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    chunk: u32,
    /// Threads of each run of the solver
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = crate::common::study_threads())]
    threads: u16,
    #[command(flatten)]
    on: DeviceOption,
    /// The coulter command on the machines of the engine [default: that of this command]
    #[arg(long, value_name = "PATH")]
    command: Option<String>,
}

pub(super) fn script(program: &Path, arguments: &Arguments) -> Result<(), Failure> {
    let store = opened(&arguments.study)?;
    let lines = store.lines().map_err(refused)?;
    let own = || program.display().to_string();
    let wish = Wish {
        engine: arguments.engine.clone(),
        chunk: arguments.chunk as usize,
        threads: usize::from(arguments.threads),
        device: arguments.on.device,
        command: arguments.command.clone().unwrap_or_else(own),
    };
    say(&script::script(&store, &lines, &wish).map_err(Failure::Request)?)
}
