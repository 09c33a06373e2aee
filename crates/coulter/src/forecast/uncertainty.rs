//! How the uncertainty of the inputs, and the error of a model, propagate to the results.

use super::model_input::ModelInput;
use super::outlook::Outlook;
use super::range::{Unreadable, known, value};
use super::variable::Variable;
use analytic::forecast::{Candidate, Parameter};
use analytic::uncertainty::{Distribution, Uncertainty, propagate_towing, sweep_table};
use case::StandardDeviation;
use serde::Serialize;

/// Largest number of uncertain inputs; the errors of the model in resistance and in thrust are two more.
pub const MAX_INPUTS: usize = 8;
/// Fixed seed, so that results can be repeated.
const SEED: u64 = 1;

/// The standard deviation of an input.
#[derive(Clone, Debug, PartialEq)]
pub struct InputDeviation {
    /// The key, as typed.
    pub key: String,
    /// The variable.
    pub variable: Variable,
    /// Mean: the value in the case, in SI units.
    pub mean: f64,
    /// Standard deviation, in SI units.
    pub deviation: f64,
}

impl InputDeviation {
    /// Reads `KEY=DEVIATION`, such as `soil.friction_angle=2 deg`; the mean is that of the case.
    ///
    /// # Errors
    /// [`Unreadable`] says what is wrong.
    pub fn read(text: &str, input: &ModelInput) -> Result<Self, String> {
        let wrong =
            |why: &str| format!("--spread {text}: {why}; write it such as soil.friction_angle=\"2 deg\"");
        let (key, deviation) = text.split_once('=').ok_or_else(|| wrong("no `=`"))?;
        let variable = known(key.trim(), input).map_err(|e: Unreadable| e.to_string())?;
        let deviation = value(deviation, &variable).map_err(|why| wrong(&why))?;
        Self::new(key.trim(), variable, deviation, input).map_err(|why| wrong(&why))
    }

    /// A standard deviation that the case states.
    ///
    /// # Errors
    /// When the models do not use its key.
    pub fn of_case(stated: &StandardDeviation, input: &ModelInput) -> Result<Self, String> {
        let variable = known(&stated.key, input).map_err(|e| e.to_string())?;
        Self::new(&stated.key, variable, stated.deviation, input)
            .map_err(|why| format!("{}: {why}", stated.key))
    }

    fn new(key: &str, variable: Variable, deviation: f64, input: &ModelInput) -> Result<Self, String> {
        if deviation <= 0.0 {
            return Err("a standard deviation must be above 0".into());
        }
        let mean = variable.value(input).ok_or("the case does not give it a value")?;
        let may_be_negative = matches!(
            variable.parameter,
            Parameter::DilationAngle | Parameter::Backfill | Parameter::Slip | Parameter::Orientation
        );
        if mean < deviation && !may_be_negative {
            return Err(
                "the standard deviation is larger than the mean, which cannot be negative; use --against to vary it"
                    .into(),
            );
        }
        Ok(Self { key: key.to_owned(), variable, mean, deviation })
    }

    fn distribution(&self, input: &ModelInput) -> (Parameter, Distribution) {
        let at = |x: f64| self.variable.model_value(input, x);
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
    /// Standard deviation of ln(resistance of the soil over that of the model).
    pub model_error: f64,
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
    /// First-order Sobol index by input, in the order that they were stated; then that of the error of the
    /// model, and for a driven body that of the error of its thrust.
    pub first_order: Vec<f64>,
    /// Total Sobol index by input, likewise.
    pub total: Vec<f64>,
    /// Fraction of the samples for which the model has no answer.
    pub refused: f64,
    /// Number of evaluations.
    pub evaluations: usize,
}

/// The distributions of the results of the models.
#[derive(Clone, Debug, PartialEq)]
pub struct Intervals {
    /// The inputs and their standard deviations.
    pub inputs: Vec<InputDeviation>,
    /// Whether the standard deviations are assumed, because none were stated.
    pub assumed: bool,
    /// One distribution for each quantity of each model that applies.
    pub list: Vec<Interval>,
}

/// How many evaluations a model is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    /// Enough for an interval to about 1 %, immediately.
    Quick,
    /// Enough for Sobol indices as well: to about 0.005 for fast models, 0.03 for those that sum over the rim
    /// every time.
    Full,
}

impl Effort {
    /// Resistive force theory and Wong and Reece's wheel take a millisecond per evaluation, Godwin and
    /// Spoor's blade, which solves a stress field, a third of that, the others some microseconds; the wedge
    /// of a disc without a table solves many fields and takes ten milliseconds.
    fn evaluations(self, model: Candidate, has_table: bool, drives: bool) -> usize {
        let is_slow = matches!(
            model,
            Candidate::SpatialResistive
                | Candidate::PlanarResistive
                | Candidate::WongReece
                | Candidate::GodwinSpoor
        );
        let needs_table = matches!(
            model,
            Candidate::Governing | Candidate::Wedge | Candidate::PlaneStrain | Candidate::BrinchHansen
        );
        match self {
            // A difference of two uncertain terms needs more.
            Self::Quick if is_slow && drives => 480,
            Self::Quick if is_slow || (needs_table && !has_table) => 96,
            Self::Quick => 1024,
            Self::Full if needs_table && !has_table => 512,
            Self::Full if is_slow => 2048,
            Self::Full => 100_000,
        }
    }
}

/// Standard deviations that are assumed where none is stated: of the friction angle that of a careful
/// laboratory; of the friction on the body and of the undrained shear strength (as a fraction) a usual
/// scatter of published values.
const USUAL: (&str, f64, f64) = ("2 deg", 0.1, 0.2);

/// The standard deviations that are assumed where none is stated.
fn usual(input: &ModelInput) -> Vec<InputDeviation> {
    let (angle, friction, strength) = USUAL;
    let soil = &input.towing.soil;
    let of_soil = if soil.is_undrained() {
        format!("soil.shear_strength={} Pa", strength * soil.cohesion)
    } else {
        format!("soil.friction_angle={angle}")
    };
    // A body that is pressed down hardly depends on it; a smooth one is meant to be smooth.
    let is_rubbed = !input.towing.pressed && soil.body_friction > friction;
    let of_body = is_rubbed.then(|| format!("friction={friction}"));
    [Some(of_soil), of_body]
        .iter()
        .flatten()
        .filter_map(|text| InputDeviation::read(text, input).ok())
        .collect()
}

/// Propagates the stated standard deviations, or the assumed ones, and the error of the model itself through
/// every model that applies; a model that has no answer is left out.
#[must_use]
pub fn intervals(outlook: &Outlook, stated: Vec<InputDeviation>, effort: Effort) -> Intervals {
    let input = &outlook.input;
    let assumed = stated.is_empty();
    let inputs = if assumed { usual(input) } else { stated };
    let distributions: Vec<_> = inputs.iter().map(|s| s.distribution(input)).collect();
    let table = sweep_table(&input.towing, &distributions);
    let mut list = Vec::new();
    for model in outlook.forecast.models.iter().filter(|m| m.applicable) {
        let Some(value) = model.prediction else { continue };
        let count = effort.evaluations(model.model, table.is_some(), input.towing.drive.drives());
        let model_error = model.model.log_error(&input.towing);
        let own = Distribution::LogNormal { median: 1.0, log_deviation: model_error };
        let mut all = [&distributions[..], &[(Parameter::ResistanceFactor, own)]].concat();
        // The drag of what is driven is a small difference: its error is not a part of it, but that of either
        // term.
        if input.towing.drive.drives() {
            all.push((Parameter::ThrustFactor, own));
        }
        let found = propagate_towing(&input.towing, &all, model.model, count, SEED, table.as_ref());
        let Ok(found) = found else { continue };
        let mut add =
            |quantity, value, found| list.push(interval(quantity, (model.name, model_error), value, found));
        if !input.towing.pressed {
            add("drag_N", value.drag, found.drag);
        }
        if !outlook.sinks() {
            add("vertical_N", value.vertical, found.vertical);
        } else if let (Some(z), Some(sinkage)) = (value.sinkage, found.sinkage) {
            add("sinkage_m", z, sinkage);
        }
    }
    Intervals { inputs, assumed, list }
}

impl Intervals {
    /// The distribution of one quantity of one model.
    #[must_use]
    pub fn of(&self, model: &str, quantity: &str) -> Option<&Interval> {
        self.list.iter().find(|i| i.model == model && i.quantity == quantity)
    }
}

/// The distribution of one quantity whose value is that of the forecast.
///
/// The interval is widened to the value itself: where samples have no answer and are left out, the quantiles
/// are those of the rest and need not contain it.
fn interval(
    quantity: &'static str,
    (model, model_error): (&'static str, f64),
    value: f64,
    found: Uncertainty,
) -> Interval {
    let [low, middle, high] = found.quantiles;
    Interval {
        quantity,
        model,
        model_error,
        mean: found.mean,
        deviation: found.deviation,
        low: low.min(value),
        middle,
        high: high.max(value),
        first_order: found.first_order,
        total: found.total,
        refused: found.failed,
        evaluations: found.evaluations,
    }
}
