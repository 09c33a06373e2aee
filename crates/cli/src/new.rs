//! `coulter new`: a commented case file to start from.

use crate::common::say;
use crate::failure::Failure;
use clap::ValueEnum;
use std::fmt::Write;
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// What to start from; --list says what each is
    #[arg(value_enum, default_value = "towed-disc", hide_possible_values = true)]
    template: Template,
    /// List what there is to start from
    #[arg(long, conflicts_with_all = ["output", "force"])]
    list: bool,
    /// Where to write it [default: the template's name, in the current folder]
    #[arg(short, long)]
    output: Option<PathBuf>,
    /// Overwrite an existing file
    #[arg(long)]
    force: bool,
}

/// The first line of the shipped cases.
const SCHEMA: &str = "#:schema ./schema.json\n";

macro_rules! templates {
    ($($name:ident: $file:literal, $about:literal;)*) => {
        #[derive(Clone, Copy, Debug, clap::ValueEnum)]
        enum Template {
            $(#[doc = $about] $name,)*
        }

        impl Template {
            /// File name and text.
            fn file(self) -> (&'static str, &'static str) {
                match self {
                    $(Self::$name => ($file, include_str!(concat!("../../../cases/", $file))),)*
                }
            }
        }
    };
}

templates! {
    TowedDisc: "towed_disc.toml", "A free disc towed over dry sand";
    Rockhopper: "rockhopper.toml", "Three rockhopper discs on one axle, each free to turn";
    SweptWing: "swept_wing.toml", "Four discs along a wing that is swept by 45°";
    Cable: "disc_on_a_cable.toml", "A disc towed by a cable";
    DrivenWheel: "driven_wheel.toml", "A driven wheel at 30 % slip";
    Footing: "strip_footing.toml", "A strip footing on undrained soil";
    PassiveWall: "passive_wall.toml", "A wall pushed into a bank of sand";
    Column: "column_collapse.toml", "A column of sand that collapses";
}

pub(super) fn new(arguments: &Arguments) -> Result<(), Failure> {
    if arguments.list {
        return say(&list());
    }
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

/// The templates, one a line.
fn list() -> String {
    let mut text = String::new();
    for value in Template::value_variants().iter().filter_map(Template::to_possible_value) {
        let about = value.get_help().map(ToString::to_string).unwrap_or_default();
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{:14}{about}", value.get_name());
    }
    text
}
