//! `coulter new`: a commented case file to start from.

use crate::common::say;
use crate::failure::Failure;
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// What to start from
    #[arg(value_enum, default_value = "towed-disc")]
    template: Template,
    /// Where to write it [default: the template's name, in the current folder]
    #[arg(short, long)]
    output: Option<PathBuf>,
    /// Overwrite an existing file
    #[arg(long)]
    force: bool,
}

/// The first line of the shipped cases.
const SCHEMA: &str = "#:schema ./schema.json\n";

#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum Template {
    /// A free disc towed over dry sand
    TowedDisc,
    /// A strip footing on undrained soil
    Footing,
    /// A wall pushed into a bank of sand
    PassiveWall,
    /// A column of sand that collapses
    Column,
}

impl Template {
    /// File name and text.
    fn file(self) -> (&'static str, &'static str) {
        match self {
            Self::TowedDisc => ("towed_disc.toml", include_str!("../../../cases/towed_disc.toml")),
            Self::Footing => ("strip_footing.toml", include_str!("../../../cases/strip_footing.toml")),
            Self::PassiveWall => ("passive_wall.toml", include_str!("../../../cases/passive_wall.toml")),
            Self::Column => ("column_collapse.toml", include_str!("../../../cases/column_collapse.toml")),
        }
    }
}

pub(super) fn new(arguments: &Arguments) -> Result<(), Failure> {
    let (name, text) = arguments.template.file();
    // The shipped cases refer to the schema in their folder; there is none with the new file.
    let text = text.strip_prefix(SCHEMA).unwrap_or(text);
    let path = arguments.output.clone().unwrap_or_else(|| name.into());
    let shown = path.display();
    let mut options = std::fs::OpenOptions::new();
    options.write(true);
    // create_new atomically refuses an existing file.
    if arguments.force {
        options.create(true).truncate(true)
    } else {
        options.create_new(true)
    };
    let written =
        options.open(&path).and_then(|mut file| std::io::Write::write_all(&mut file, text.as_bytes()));
    match written {
        Ok(()) => say(&format!("wrote {shown}; next: coulter check {shown}\n")),
        Err(error) if error.kind() == std::io::ErrorKind::AlreadyExists => Err(Failure::Request(format!(
            "{shown} exists already; --force overwrites it, -o FILE writes to another file"
        ))),
        Err(error) => Err(Failure::Request(format!("{shown} cannot be written: {error}"))),
    }
}
