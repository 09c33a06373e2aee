//! `coulter new`: a commented case file to start from.

use crate::common::say;
use crate::failure::Failure;
use clap::ValueEnum;
use std::fmt::Write;
use std::path::{Path, PathBuf};

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

/// The surface that the tool from an STL file refers to.
const OPENER: &str = include_str!("../cases/opener.stl");

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
                    $(Self::$name => ($file, include_str!(concat!("../cases/", $file))),)*
                }
            }
        }
    };
}

templates! {
    TowedDisc: "towed_disc.toml", "A free disc towed over dry sand";
    PressAndTow: "press_and_tow.toml", "A disc that is pressed into sand, held, towed and lifted, in stages";
    UnderWater: "disc_under_water.toml", "A free disc towed over sand under water";
    Rockhopper: "rockhopper.toml", "Three rockhopper discs on one axle, each free to turn";
    Boulder: "disc_over_boulder.toml", "A disc that rolls over a boulder";
    HoppingGear: "rockhopper_stone.toml", "A rockhopper segment that hops over a stone";
    Balls: "row_of_balls.toml", "A row of balls, pushed";
    SweptWing: "swept_wing.toml", "Four discs along a wing that is swept by 45°";
    Cable: "disc_on_a_cable.toml", "A disc towed by a cable";
    DrivenWheel: "driven_wheel.toml", "A driven wheel at 30 % slip";
    GrouseredWheel: "grousered_wheel.toml", "A driven wheel with grousers";
    WheelOnSlope: "wheel_on_slope.toml", "A driven wheel with grousers that climbs a slope";
    FurrowedField: "furrowed_field.toml", "A free disc towed across the furrows of a field";
    HarrowDisc: "harrow_disc.toml", "A dished harrow disc at 20° yaw and 15° tilt";
    Opener: "double_disc_opener.toml", "A double-disc opener";
    Blade: "blade.toml", "A blade with a rake angle of 45°";
    Cone: "cone.toml", "A cone penetrometer";
    Scoop: "scoop.toml", "A scoop that is filled, lifted and emptied";
    Pipe: "pipe.toml", "A pipe that is pressed into sand and swept sideways";
    StlTool: "stl_tool.toml", "A tool from an STL file";
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
    if let Template::StlTool = arguments.template {
        write(&path.with_file_name("opener.stl"), OPENER, arguments.force)?;
    }
    write(&path, text, arguments.force)?;
    let shown = path.display();
    say(&format!("wrote {shown}; next: coulter check {shown}\n"))
}

/// Writes a file; one that exists only with `force`.
fn write(path: &Path, text: &str, force: bool) -> Result<(), Failure> {
    let shown = path.display();
    let mut options = std::fs::OpenOptions::new();
    options.write(true);
    // create_new atomically refuses an existing file.
    if force {
        options.create(true).truncate(true)
    } else {
        options.create_new(true)
    };
    let written =
        options.open(path).and_then(|mut file| std::io::Write::write_all(&mut file, text.as_bytes()));
    written.map_err(|error| match error.kind() {
        std::io::ErrorKind::AlreadyExists => Failure::Request(format!(
            "{shown} exists already; --force overwrites it, -o FILE writes to another file"
        )),
        _ => Failure::Request(format!("{shown} cannot be written: {error}")),
    })
}

/// The templates, one a line.
fn list() -> String {
    let mut text = String::new();
    let templates = || Template::value_variants().iter().filter_map(Template::to_possible_value);
    let width = templates().map(|value| value.get_name().len()).max().unwrap_or(0) + 2;
    for value in templates() {
        let about = value.get_help().map(ToString::to_string).unwrap_or_default();
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{:width$}{about}", value.get_name());
    }
    text
}
