//! What `coulter calibrate` is asked for, from the words of the command line.

use crate::common::{DeviceOption, choices};
use crate::failure::Failure;
use coulter::case::{self, quantity};
use std::path::{Path, PathBuf};
use studies::calibration::{Effort, ModelChoice, Noise, Plan, Request, Selection, Space, read_design};
use studies::measured::{self, Quantity};

#[derive(Debug, clap::Args)]
pub(crate) struct Arguments {
    /// The case file
    pub(super) case: PathBuf,
    /// Measured curves: CSV files with units in the header
    #[arg(required = true, value_name = "MEASURED")]
    measured: Vec<PathBuf>,
    /// What is to be found, with its prior: KEY="28 deg".."45 deg", KEY="33 ± 3 deg" or KEY="32 MPa */ 3";
    /// may be repeated
    #[arg(long = "parameter", value_name = "KEY=PRIOR")]
    parameters: Vec<String>,
    /// A key that follows from parameters, such as soil.minimum_density="2650/(1 + e_max) [kg/m^3]"; may be
    /// repeated
    #[arg(long = "link", value_name = "KEY=EXPRESSION [UNIT]")]
    links: Vec<String>,
    /// Which model is calibrated
    #[arg(long, value_enum, default_value_t = Model::ClosedForm)]
    model: Model,
    /// Which closed form; the recommended one unless it is named as in `coulter forecast`
    #[arg(long, value_name = "NAME")]
    closed_form: Option<String>,
    /// Runs of the solver at most
    #[arg(long, value_name = "RUNS", default_value_t = 30)]
    budget: usize,
    /// Noise of the measurements, as a part of the value; estimated unless it is given or the file has
    /// standard deviations
    #[arg(long, value_name = "PERCENT")]
    noise: Option<String>,
    /// Error of the model that all points of a curve have in common, as a part of the value
    #[arg(long, value_name = "PERCENT")]
    model_error: Option<String>,
    /// The part of the abscissa that is fitted, such as "5 mm".."25 mm"
    #[arg(long, value_name = "FROM..TO")]
    window: Option<String>,
    /// What is fitted, such as drag,vertical [default: every force, pressure and torque of the file]
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    quantity: Vec<String>,
    /// What a column of a measured file is: COLUMN=QUANTITY, COLUMN="-QUANTITY [UNIT]" of the other sign,
    /// COLUMN=- to leave it out; may be repeated
    #[arg(long = "column", value_name = "COLUMN=QUANTITY")]
    columns: Vec<String>,
    /// With --model both: keep the solver's runs within what the closed form leaves open
    #[arg(long)]
    narrow: bool,
    /// Points that are run first: a CSV file with a column for each parameter, such as runs.csv
    #[arg(long, value_name = "FILE")]
    design: Option<PathBuf>,
    /// Samples of the posterior in each of four chains
    #[arg(long, value_name = "N", default_value_t = 2500)]
    samples: usize,
    /// Seed of all random numbers
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// Threads of a run; 0 for as many as a run has by default (`coulter run --help`)
    #[arg(long, value_name = "N", value_parser = crate::common::threads())]
    threads: Option<u16>,
    #[command(flatten)]
    pub(super) on: DeviceOption,
    /// Sets a key of the case; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub(super) overrides: Vec<String>,
    /// Where to write [default: results/NAME-calibration]
    #[arg(short, long, value_name = "DIR")]
    pub(super) output: Option<PathBuf>,
    /// Overwrite the calibration of another request
    #[arg(long)]
    pub(super) force: bool,
    /// Print one JSON document
    #[arg(long)]
    pub(super) json: bool,
}

/// Which model is calibrated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Model {
    /// The closed form: at once
    ClosedForm,
    /// The solver, through a surrogate of its curves
    Solver,
    /// Both
    Both,
}

impl Arguments {
    /// The request; its runs will lie in the folder `runs`.
    pub(super) fn request<'a>(&'a self, runs: &'a Path) -> Result<Request<'a>, Failure> {
        let space = Space::read(&self.parameters, &self.links)?;
        let choices = choices(&self.columns)?;
        let mut records = Vec::new();
        for path in &self.measured {
            records.push(measured::read(path, &choices)?);
        }
        measured::refuse_unused(&choices, records.iter()).map_err(Failure::Request)?;
        let noise = match self.noise.as_deref().map(|typed| percent("--noise", typed)).transpose()? {
            Some(noise) if noise > 0.0 => Noise::Given(noise),
            Some(_) => return Err(Failure::Request("--noise must be above 0 %, such as 5%".to_owned())),
            None => Noise::Estimated,
        };
        let model_error = self.model_error.as_deref().map(|typed| percent("--model-error", typed));
        if self.samples < 100 || self.samples > 1_000_000 {
            return Err(Failure::Request("--samples: 100 to 1000000 samples of each chain".to_owned()));
        }
        let quantities = self.quantity.iter().map(|name| quantity_named(name)).collect::<Result<_, _>>()?;
        let window = self.window.as_deref().map(window).transpose()?;
        let design = match &self.design {
            Some(path) => read_design(path, &space)?,
            None => Vec::new(),
        };
        Ok(Request {
            case: &self.case,
            overrides: &self.overrides,
            space,
            records,
            selection: Selection { quantities, window, is_pressed: false },
            model: match self.model {
                Model::ClosedForm => ModelChoice::ClosedForm,
                Model::Solver => ModelChoice::Solver,
                Model::Both => ModelChoice::Both,
            },
            closed_form: self.closed_form.as_deref(),
            noise,
            model_error: model_error.transpose()?.unwrap_or(0.0),
            effort: Effort { samples: self.samples, seed: self.seed },
            plan: Plan { budget: self.budget, design, ranges: Vec::new() },
            narrow: self.narrow,
            threads: self.threads.map(usize::from),
            device: self.on.device,
            folder: runs,
        })
    }

    /// What identifies the request, to recognise it again: everything but where and how fast. With it goes
    /// the content of case and measurements, as files change.
    pub(super) fn identity(&self, request: &Request<'_>) -> Result<String, Failure> {
        let Self { parameters, links, overrides, quantity, measured, .. } = self;
        let rest = (&self.closed_form, &self.noise, &self.model_error, &self.window, &self.samples);
        let content = request.fingerprint(&case::text(&self.case)?);
        Ok(format!(
            "{:?} {measured:?} {parameters:?} {links:?} {overrides:?} {quantity:?} {rest:?} {:?} {} {} {content}",
            self.case, self.model, self.budget, self.seed
        ))
    }
}

/// A part such as `5%` or `0.05`.
fn percent(option: &str, typed: &str) -> Result<f64, Failure> {
    let text = typed.trim();
    let read = match text.strip_suffix('%') {
        Some(number) => number.trim().parse::<f64>().map(|number| 0.01 * number),
        None => text.parse::<f64>(),
    };
    match read {
        Ok(part) if (0.0..=2.0).contains(&part) => Ok(part),
        _ => Err(Failure::Request(format!("{option} {typed}: give a part of the value, such as 5% or 0.05"))),
    }
}

/// The quantity of that name.
pub(crate) fn quantity_named(name: &str) -> Result<Quantity, Failure> {
    Quantity::named(name.trim()).ok_or_else(|| {
        let known: Vec<&str> = Quantity::names().collect();
        let cure = case::nearest(name, known.iter().copied()).map_or_else(
            || format!("known are {}", known.join(", ")),
            |near| format!("did you mean `{near}`?"),
        );
        Failure::Request(format!("--quantity {name}: not a quantity; {cure}"))
    })
}

/// A window such as `"5 mm".."25 mm"` or `"0.4 m".."0.8 m"`, in SI units; plain numbers are slips.
pub(crate) fn window(typed: &str) -> Result<[f64; 2], Failure> {
    let wrong = |why: &str| {
        Failure::Request(format!("--window {typed}: {why}; write it such as \"0.4 m\"..\"0.8 m\""))
    };
    let (from, to) = typed.split_once("..").ok_or_else(|| wrong("no `..` between two values"))?;
    let value = |text: &str| {
        let text = text.trim().trim_matches(['"', '\'']).trim();
        let plain = text.parse::<f64>().ok().filter(|number| number.is_finite());
        plain.map_or_else(|| quantity::parse_any(text).map(|(value, _)| value), Ok)
    };
    let ends = [from, to].map(|text| value(text).map_err(|error| wrong(&error.to_string())));
    let [from, to] = ends;
    let (from, to) = (from?, to?);
    if from < to { Ok([from, to]) } else { Err(wrong("the second value must be above the first")) }
}
