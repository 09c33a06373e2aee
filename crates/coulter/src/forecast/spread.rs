//! What the spread of the inputs makes of the answer.

use super::outlook::Outlook;
use super::range::{Unreadable, known, value};
use super::setting::Setting;
use super::variable::Variable;
use crate::case::Spread;
use analytic::forecast::{Candidate, Parameter};
use analytic::uncertainty::{Spread as Distribution, Uncertainty, propagate_towing, sweep_table};
use serde::Serialize;

/// The same number for everybody, so that an answer can be repeated.
const SEED: u64 = 1;

/// A standard deviation that was stated.
#[derive(Clone, Debug, PartialEq)]
pub struct Stated {
    /// The key, as typed.
    pub key: String,
    /// What it is of.
    pub variable: Variable,
    /// Mean: the value in the case, in SI units.
    pub mean: f64,
    /// Standard deviation, in SI units.
    pub deviation: f64,
}

impl Stated {
    /// Reads `KEY=DEVIATION`, such as `soil.friction_angle=2 deg`; the mean is that of the case.
    ///
    /// # Errors
    /// [`Unreadable`] says what is wrong.
    pub fn read(text: &str, setting: &Setting) -> Result<Self, String> {
        let wrong =
            |why: &str| format!("--spread {text}: {why}; write it such as soil.friction_angle=\"2 deg\"");
        let (key, deviation) = text.split_once('=').ok_or_else(|| wrong("no `=`"))?;
        let variable = known(key.trim(), setting).map_err(|e: Unreadable| e.to_string())?;
        let deviation = value(deviation, &variable).map_err(|why| wrong(&why))?;
        Self::new(key.trim(), variable, deviation, setting).map_err(|why| wrong(&why))
    }

    /// A spread that the case itself states.
    ///
    /// # Errors
    /// When the models do not know its key.
    pub fn of_case(spread: &Spread, setting: &Setting) -> Result<Self, String> {
        let variable = known(&spread.key, setting).map_err(|e| e.to_string())?;
        Self::new(&spread.key, variable, spread.deviation, setting)
            .map_err(|why| format!("{}: {why}", spread.key))
    }

    fn new(key: &str, variable: Variable, deviation: f64, setting: &Setting) -> Result<Self, String> {
        if deviation <= 0.0 {
            return Err("a standard deviation must be above 0".into());
        }
        let mean = variable.value(setting).ok_or("the case gives it no value")?;
        let may_be_negative = matches!(
            variable.parameter,
            Parameter::DilationAngle | Parameter::Backfill | Parameter::Slip | Parameter::Orientation
        );
        if mean < deviation && !may_be_negative {
            return Err(
                "the spread reaches below 0 within one standard deviation; --against shows what it does"
                    .into(),
            );
        }
        Ok(Self { key: key.to_owned(), variable, mean, deviation })
    }

    fn distribution(&self, setting: &Setting) -> (Parameter, Distribution) {
        let at = |x: f64| self.variable.model_value(setting, x);
        let (mean, above) = (at(self.mean), at(self.mean + self.deviation));
        (self.variable.parameter, Distribution::Normal { mean, deviation: (above - mean).abs() })
    }
}

/// The distribution of one quantity of one model.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Interval {
    /// `drag_N`, `vertical_N` or `sinkage_m`.
    pub quantity: &'static str,
    /// Name of the model.
    pub model: &'static str,
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub deviation: f64,
    /// The value that 5 % lie below.
    pub low: f64,
    /// The value that half lie below.
    pub middle: f64,
    /// The value that 95 % lie below.
    pub high: f64,
    /// First-order Sobol index by input, in the order that they were stated.
    pub first_order: Vec<f64>,
    /// Total Sobol index by input.
    pub total: Vec<f64>,
    /// Share of the samples that the model refused.
    pub refused: f64,
    /// How many evaluations were made.
    pub evaluations: usize,
}

/// How the answers of the models spread as the inputs do.
#[derive(Clone, Debug, PartialEq)]
pub struct Intervals {
    /// The inputs and their standard deviations.
    pub inputs: Vec<Stated>,
    /// Whether nobody stated them.
    pub assumed: bool,
    /// One for each quantity of each model that applies.
    pub list: Vec<Interval>,
}

/// How many evaluations a model gets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    /// Enough for an interval to about 1 %, in a blink.
    Glance,
    /// Enough for Sobol indices, too: to about 0.005 of closed models, 0.03 of those that sum over the rim each time.
    Study,
}

impl Effort {
    /// Resistive force theory and Wong and Reece's wheel take a millisecond each time, Godwin and Spoor's blade, which
    /// solves its stress field, a third of one, the others some microseconds; a disc's wedge without a table solves many
    /// fields and takes ten milliseconds.
    fn evaluations(self, model: Candidate, has_table: bool) -> usize {
        let is_slow = matches!(
            model,
            Candidate::SpatialResistive
                | Candidate::PlanarResistive
                | Candidate::WongReece
                | Candidate::GodwinSpoor
        );
        let needs_table = matches!(
            model,
            Candidate::Weaker | Candidate::Wedge | Candidate::PlaneStrain | Candidate::BrinchHansen
        );
        match self {
            Self::Glance if is_slow || (needs_table && !has_table) => 96,
            Self::Glance => 1024,
            Self::Study if needs_table && !has_table => 512,
            Self::Study if is_slow => 2048,
            Self::Study => 100_000,
        }
    }
}

/// The standard deviation of the friction angle where nobody states any: a careful laboratory's.
const USUAL_DEVIATION: f64 = 2.0;

/// The spread that is assumed where none is stated.
fn usual(setting: &Setting) -> Vec<Stated> {
    let text = format!("soil.friction_angle={USUAL_DEVIATION} deg");
    Stated::read(&text, setting).into_iter().collect()
}

/// Propagates the stated spreads, or the usual one, through every model that applies; one that refuses is left out.
#[must_use]
pub fn intervals(outlook: &Outlook, stated: Vec<Stated>, effort: Effort) -> Intervals {
    let setting = &outlook.setting;
    let assumed = stated.is_empty();
    let inputs = if assumed { usual(setting) } else { stated };
    let spreads: Vec<_> = inputs.iter().map(|s| s.distribution(setting)).collect();
    let table = sweep_table(&setting.towing, &spreads);
    let mut list = Vec::new();
    for model in outlook.forecast.models.iter().filter(|m| m.applicable) {
        let count = effort.evaluations(model.model, table.is_some());
        let found = propagate_towing(&setting.towing, &spreads, model.model, count, SEED, table.as_ref());
        let Ok(found) = found else { continue };
        list.push(interval("drag_N", model.name, found.drag));
        if outlook.sinks() {
            list.extend(found.sinkage.map(|sinkage| interval("sinkage_m", model.name, sinkage)));
        } else {
            list.push(interval("vertical_N", model.name, found.vertical));
        }
    }
    Intervals { inputs, assumed, list }
}

impl Intervals {
    /// That of one quantity of one model.
    #[must_use]
    pub fn of(&self, model: &str, quantity: &str) -> Option<&Interval> {
        self.list.iter().find(|i| i.model == model && i.quantity == quantity)
    }
}

fn interval(quantity: &'static str, model: &'static str, found: Uncertainty) -> Interval {
    let [low, middle, high] = found.quantiles;
    Interval {
        quantity,
        model,
        mean: found.mean,
        deviation: found.deviation,
        low,
        middle,
        high,
        first_order: found.first_order,
        total: found.total,
        refused: found.refused,
        evaluations: found.evaluations,
    }
}
