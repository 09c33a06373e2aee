//! `coulter render`: pictures in space and animations.

use crate::common::{results_folder, say};
use crate::failure::Failure;
use clap::ValueEnum;
use coulter::case::quantity::{TIME, parse};
use coulter::output::{Colouring, ImageFormat, RenderOptions, Viewpoint, render};
use indicatif::{ProgressBar, ProgressStyle};
use std::path::{Path, PathBuf};

/// Largest width or height of a picture [pixels]: the largest takes about a gigabyte to draw.
const MOST_PIXELS: usize = 4096;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The folder of a run
    #[arg(value_name = "DIR")]
    folder: PathBuf,
    /// A file to write; repeatable. *.png is a picture, *.gif an animation, *.apng one in full colour
    /// (view.png and view.gif in DIR/pictures unless given)
    #[arg(short, long, value_name = "FILE", value_parser = file)]
    output: Vec<PathBuf>,
    /// Replace files given with --output
    #[arg(long)]
    force: bool,
    /// From where: obliquely from behind, or from the side in plane strain, unless given
    #[arg(long, value_enum, value_name = "VIEW")]
    view: Option<View>,
    /// Direction of view in plan, from the tow (x) towards y; with --view it replaces that of the view
    #[arg(long, value_name = "DEGREES", allow_negative_numbers = true, value_parser = angle::<-360, 360>)]
    azimuth: Option<f64>,
    /// How far the viewer looks down
    #[arg(long, value_name = "DEGREES", allow_negative_numbers = true, value_parser = angle::<-20, 90>)]
    elevation: Option<f64>,
    /// Magnification
    #[arg(long, value_name = "FACTOR", value_parser = zoom)]
    zoom: Option<f64>,
    /// Move with the first body and show its surroundings
    #[arg(long)]
    follow: bool,
    /// What the colours of the soil show
    #[arg(long, value_enum, value_name = "WHAT", default_value = "height")]
    colour: Colour,
    /// Width and height in pixels
    #[arg(long, value_name = "WIDTHxHEIGHT", default_value = "960x540", value_parser = size)]
    size: [usize; 2],
    /// On a dark background
    #[arg(long)]
    dark: bool,
    /// Without title, scale and time
    #[arg(long)]
    plain: bool,
    /// Time of the picture, with its unit: the nearest recorded one (the last unless given)
    #[arg(long, value_name = "TIME", value_parser = time)]
    at: Option<f64>,
    /// How long the animation lasts, with its unit
    #[arg(long, value_name = "TIME", default_value = "5 s", value_parser = duration)]
    duration: f64,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum View {
    Oblique,
    Side,
    Above,
    Front,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Colour {
    /// Height above or below the undisturbed surface
    Height,
    /// Nothing: it looks like soil
    Soil,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let folder = results_folder(&arguments.folder)?;
    if let Some(path) = arguments.output.iter().find(|path| path.exists() && !arguments.force) {
        return Err(Failure::Request(format!("{} exists already; --force replaces it", path.display())));
    }
    let options = arguments.options();
    let style = ProgressStyle::with_template("drawing {bar:30} {pos} of {len}, {eta} left");
    let bar = ProgressBar::new(0).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    let outcome = render(folder, &options, &mut |done, all| {
        bar.set_length(all as u64);
        bar.set_position(done as u64);
    });
    bar.finish_and_clear();
    outcome.map_err(|error| Failure::Request(error.to_string()))?;
    say(&options.files.iter().map(|file| format!("{}\n", file.display())).collect::<String>())
}

impl Arguments {
    fn options(&self) -> RenderOptions {
        let files = if self.output.is_empty() {
            ["view.png", "view.gif"].map(|name| self.folder.join("pictures").join(name)).to_vec()
        } else {
            self.output.clone()
        };
        RenderOptions {
            files,
            viewpoint: self.viewpoint(),
            colouring: match self.colour {
                Colour::Height => Colouring::Height,
                Colour::Soil => Colouring::Plain,
            },
            size: self.size,
            dark: self.dark,
            labelled: !self.plain,
            time: self.at,
            duration: self.duration,
        }
    }

    /// `None` where nothing is said of it.
    fn viewpoint(&self) -> Option<Viewpoint> {
        let is_said = self.view.is_some()
            || self.azimuth.is_some()
            || self.elevation.is_some()
            || self.zoom.is_some()
            || self.follow;
        is_said.then(|| {
            let base = match self.view.unwrap_or(View::Oblique) {
                View::Oblique => Viewpoint::OBLIQUE,
                View::Side => Viewpoint::SIDE,
                View::Above => Viewpoint::ABOVE,
                View::Front => Viewpoint::FRONT,
            };
            Viewpoint {
                azimuth: self.azimuth.map_or(base.azimuth, f64::to_radians),
                elevation: self.elevation.map_or(base.elevation, f64::to_radians),
                zoom: self.zoom.unwrap_or(base.zoom),
                follow: self.follow,
            }
        })
    }
}

fn file(text: &str) -> Result<PathBuf, String> {
    ImageFormat::of(Path::new(text)).map(|_| PathBuf::from(text))
}

fn angle<const LOW: i32, const HIGH: i32>(text: &str) -> Result<f64, String> {
    let wanted = || format!("an angle from {LOW} to {HIGH} degrees");
    let angle: f64 = text.trim_end_matches("deg").trim().parse().map_err(|_| wanted())?;
    if (f64::from(LOW)..=f64::from(HIGH)).contains(&angle) { Ok(angle) } else { Err(wanted()) }
}

fn zoom(text: &str) -> Result<f64, String> {
    let factor = text.trim_end_matches('x').parse().ok().filter(|factor| (0.1..=50.0).contains(factor));
    factor.ok_or_else(|| "a factor from 0.1 to 50".to_owned())
}

fn size(text: &str) -> Result<[usize; 2], String> {
    let wanted = || format!("two numbers of pixels from 64 to {MOST_PIXELS}, such as 1280x720");
    let (width, height) = text.split_once('x').ok_or_else(wanted)?;
    let pixels = |text: &str| text.trim().parse().ok().filter(|n| (64..=MOST_PIXELS).contains(n));
    Ok([pixels(width).ok_or_else(wanted)?, pixels(height).ok_or_else(wanted)?])
}

fn time(text: &str) -> Result<f64, String> {
    let time = parse(text, &TIME).map_err(|_| "a time with its unit, such as \"0.5 s\"".to_owned())?;
    if time.is_finite() && time >= 0.0 { Ok(time) } else { Err("a time from 0 s on".to_owned()) }
}

fn duration(text: &str) -> Result<f64, String> {
    let time = time(text)?;
    if (0.1..=120.0).contains(&time) { Ok(time) } else { Err("from 0.1 s to 120 s".to_owned()) }
}
