//! What the spread of the inputs makes of the answer.

use super::Outlook;
use super::range::{Unreadable, known, value};
use super::{Setting, Variable};
use crate::case::Spread;
use analytic::Load;
use analytic::forecast::{Candidate, Parameter};
use analytic::uncertainty::{Quantity, Spread as Distribution, Uncertainty, propagate_towing};
use serde::Serialize;

/// Evaluations per quantity: intervals to about 1 %, indices to about 0.02 (measured).
const EVALUATIONS: usize = 8192;
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
        Ok(Self { key: key.to_owned(), variable, mean, deviation })
    }

    fn distribution(&self, setting: &Setting) -> (Parameter, Distribution) {
        let at = |x: f64| self.variable.model_value(setting, x);
        let (mean, above) = (at(self.mean), at(self.mean + self.deviation));
        (self.variable.parameter, Distribution::Normal { mean, deviation: above - mean })
    }
}

/// The distribution of one quantity of the recommended model.
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

/// Propagates the stated spreads through the weaker of BC and PW.
///
/// # Errors
/// The reason why they cannot be.
pub fn intervals(outlook: &Outlook, stated: &[Stated]) -> Result<Vec<Interval>, String> {
    let setting = &outlook.setting;
    let spreads: Vec<_> = stated.iter().map(|s| s.distribution(setting)).collect();
    let weight_varies = stated.iter().any(|s| s.variable.parameter == Parameter::Weight);
    let mut quantities = vec![("drag_N", Quantity::Drag)];
    if matches!(setting.towing.load, Load::Sinkage(_)) || weight_varies {
        quantities.push(("vertical_N", Quantity::Vertical));
    }
    if outlook.sinks() {
        quantities.push(("sinkage_m", Quantity::Sinkage));
    }
    let model = Candidate::Weaker;
    let one = |(name, quantity): (&'static str, Quantity)| {
        let found = propagate_towing(&setting.towing, &spreads, model, quantity, EVALUATIONS, SEED)
            .map_err(|why| why.to_string())?;
        Ok(interval(name, model.name(), found))
    };
    quantities.into_iter().map(one).collect()
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
