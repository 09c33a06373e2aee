//! The curve of a closed-form model for a case: along the sinkage, along the slip, or the steady value of a
//! tow.

use crate::measured::Quantity;
use analytic::Towing;
use analytic::forecast::{
    Body, Candidate, CurvePoint, Parameter, Prediction, Strength, best_at, curve, judge, predict,
};
use coulter::case::Case;
use coulter::forecast::{ModelInput, model_input};

/// Along what a closed-form curve runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Along {
    /// The sinkage [m].
    Sinkage,
    /// The slip.
    Slip,
    /// Nothing: the steady value of a tow.
    Steady,
}

impl Along {
    /// Along what a curve runs that was measured along a quantity.
    #[must_use]
    pub fn of(abscissa: Quantity) -> Self {
        match abscissa {
            Quantity::Slip => Self::Slip,
            Quantity::Sinkage => Self::Sinkage,
            _ => Self::Steady,
        }
    }

    fn parameter(self) -> Parameter {
        match self {
            Self::Sinkage => Parameter::Sinkage,
            Self::Slip => Parameter::Slip,
            // Setting the resistance factor to what it is changes nothing.
            Self::Steady => Parameter::ResistanceFactor,
        }
    }
}

/// Places at which models are judged before one is chosen (chosen: a model ends at some depth or slip, not in
/// between).
const TRIALS: usize = 24;
/// Places that are judged one by one; of more, those between two take the verdict of both.
const JUDGED: usize = 240;

/// The closed forms of a case, of which one is chosen at the points that are asked for.
#[derive(Clone, Debug)]
pub struct ClosedForms {
    /// Input of the models.
    pub input: ModelInput,
    wanted: Option<Candidate>,
}

impl ClosedForms {
    /// The closed forms of a case, or the one of that name.
    ///
    /// # Errors
    /// Why there is none, in words.
    pub fn of(case: &Case, name: Option<&str>) -> Result<Self, String> {
        let input =
            model_input(case).map_err(|why| format!("there is no closed form for this case: {why}"))?;
        let known = |name: &str| {
            Candidate::ALL.into_iter().find(|model| model.name().eq_ignore_ascii_case(name)).ok_or_else(
                || {
                    let names: Vec<&str> = Candidate::ALL.into_iter().map(Candidate::name).collect();
                    format!("`{name}` is no model; known are {}", names.join(", "))
                },
            )
        };
        Ok(Self { input, wanted: name.map(known).transpose()? })
    }

    /// Whether the body is pressed down, so that its forces follow the sinkage.
    #[must_use]
    pub fn is_pressed(&self) -> bool {
        self.input.towing.pressed
    }

    /// The closed form that applies at most of the points, the best of them where several do: each point is
    /// judged for itself, whatever the case itself prescribes.
    ///
    /// # Errors
    /// Why none applies at any of them, in words.
    pub fn chosen(self, along: Along, at: &[f64]) -> Result<ClosedForm, String> {
        if let Some(candidate) = self.wanted {
            return Ok(ClosedForm { candidate, input: self.input });
        }
        let towing = &self.input.towing;
        let trials: Vec<Towing> = match along {
            Along::Steady => vec![towing.clone()],
            _ => spread(at, TRIALS).map(|x| towing.with(along.parameter(), x)).collect(),
        };
        let mut votes: Vec<(Candidate, usize)> = Vec::new();
        for best in trials.iter().filter_map(|trial| best_at(trial).ok().flatten()) {
            match votes.iter_mut().find(|(known, _)| *known == best) {
                Some((_, count)) => *count += 1,
                None => votes.push((best, 1)),
            }
        }
        match votes.into_iter().reduce(|most, next| if next.1 > most.1 { next } else { most }) {
            Some((candidate, _)) => Ok(ClosedForm { candidate, input: self.input }),
            None => Err(format!("no closed form applies{}", reason(&trials))),
        }
    }
}

/// So many of the values at most, evenly among them.
fn spread(at: &[f64], most: usize) -> impl Iterator<Item = f64> {
    let count = at.len().min(most);
    (0..count).map(move |n| at[if count > 1 { n * (at.len() - 1) / (count - 1) } else { 0 }])
}

/// Why no model applies: of the first case, what is wrong with it, or what the recommendation says.
fn reason(trials: &[Towing]) -> String {
    let Some(trial) = trials.first() else { return ": there is no point".to_owned() };
    match analytic::forecast(trial) {
        Ok(forecast) => format!(". {}", forecast.recommendation),
        Err(why) => format!(": {why}"),
    }
}

/// A model and its input.
#[derive(Clone, Debug)]
pub struct ClosedForm {
    /// The model.
    pub candidate: Candidate,
    /// Input of the model.
    pub input: ModelInput,
}

impl ClosedForm {
    /// The model for another case: other values of keys.
    ///
    /// # Errors
    /// Why there is none, in words.
    pub fn for_case(&self, case: &Case) -> Result<Self, String> {
        Ok(Self { candidate: self.candidate, input: model_input(case)? })
    }

    /// The values of a quantity at some abscissae; one value for [`Along::Steady`], whatever these are.
    ///
    /// # Errors
    /// Why the model has none, in words.
    pub fn values(&self, quantity: Quantity, along: Along, at: &[f64]) -> Result<Vec<f64>, String> {
        let mut values = values(&self.input.towing, self.candidate, quantity, (along, at))?;
        if self.input.mirrored && quantity == Quantity::Lateral {
            // The left of the mirror image is the right.
            values.iter_mut().for_each(|force| *force = 0.0 - *force);
        }
        Ok(values)
    }

    /// For each abscissa why the model does not apply there; `None` where it does.
    #[must_use]
    pub fn refusals(&self, along: Along, at: &[f64]) -> Vec<Option<String>> {
        if along == Along::Steady {
            return vec![self.refusal(along, 0.0); at.len()];
        }
        if at.len() <= JUDGED {
            return at.iter().map(|x| self.refusal(along, *x)).collect();
        }
        let judged: Vec<(usize, Option<String>)> = (0..JUDGED)
            .map(|n| n * (at.len() - 1) / (JUDGED - 1))
            .map(|n| (n, self.refusal(along, at[n])))
            .collect();
        let of = |n: usize| {
            let after = judged.partition_point(|(place, _)| *place < n);
            let above = judged.get(after).and_then(|(_, why)| why.clone());
            above.or_else(|| judged.get(after.saturating_sub(1)).and_then(|(_, why)| why.clone()))
        };
        (0..at.len()).map(of).collect()
    }

    fn refusal(&self, along: Along, x: f64) -> Option<String> {
        let towing = &self.input.towing;
        let case = match along {
            Along::Steady => towing.clone(),
            _ => towing.with(along.parameter(), x),
        };
        match judge(&case, &[self.candidate]) {
            Ok(found) if found[0].applicable => None,
            Ok(found) => Some(format!("{} does not apply: {}", self.candidate.name(), found[0].note)),
            Err(why) => Some(why.to_string()),
        }
    }
}

/// Values of a model, like [`ClosedForm::values`], for an input.
fn values(
    towing: &Towing,
    candidate: Candidate,
    quantity: Quantity,
    (along, at): (Along, &[f64]),
) -> Result<Vec<f64>, String> {
    let parameter = along.parameter();
    let at = if along == Along::Steady { &[towing.resistance_factor][..] } else { at };
    let predictions = if towing.pressed {
        at.iter()
            .map(|value| pressed(towing, candidate, (parameter, *value)))
            .collect::<Result<Vec<_>, _>>()?
    } else {
        let points = curve(towing, parameter, at, &[candidate]).map_err(|error| error.to_string())?;
        points.iter().map(|point| answer(point, candidate)).collect::<Result<_, _>>()?
    };
    let value = |prediction: &Prediction| {
        read(prediction, quantity, towing)
            .ok_or_else(|| format!("{} does not give the {}", candidate.name(), quantity.name()))
    };
    predictions.iter().map(value).collect()
}

/// The prediction for a body that is pressed down, whose limits are judged apart.
fn pressed(
    towing: &Towing,
    candidate: Candidate,
    (parameter, value): (Parameter, f64),
) -> Result<Prediction, String> {
    let case = towing.with(parameter, value);
    let plastic = Strength::recommended(&case).applied(&case).map_err(|error| error.to_string())?;
    let used = if candidate.is_plastic() { &plastic } else { &case };
    predict(candidate, used, None).map_err(|why| format!("{} has no answer: {why}", candidate.name()))
}

/// The prediction at a point of a curve.
fn answer(point: &CurvePoint, candidate: Candidate) -> Result<Prediction, String> {
    let found = point.models.first();
    found.and_then(|model| model.prediction).ok_or_else(|| {
        let why = found.map_or("", |model| model.note.as_str());
        format!("{} has no answer at {}: {why}", candidate.name(), point.value)
    })
}

/// A quantity of a prediction.
fn read(prediction: &Prediction, quantity: Quantity, towing: &Towing) -> Option<f64> {
    match quantity {
        Quantity::Drag => Some(prediction.drag),
        Quantity::Vertical => Some(prediction.vertical),
        Quantity::Lateral => prediction.lateral,
        Quantity::Sinkage => prediction.sinkage,
        Quantity::Slip => prediction.slip,
        Quantity::Pressure => match prediction.end_pressure {
            Some(pressure) => Some(pressure),
            None => Some(prediction.vertical / base_area(towing)?),
        },
        _ => None,
    }
}

/// The area of a level base [m²]; of a round body that is pressed down, that of its largest section.
fn base_area(towing: &Towing) -> Option<f64> {
    match &towing.body {
        Body::Plate(plate) => Some(plate.area()),
        Body::Cone(cone) => Some(0.25 * std::f64::consts::PI * cone.diameter * cone.diameter),
        Body::Faceted(body) if towing.pressed => {
            Some(0.25 * std::f64::consts::PI * body.length * body.length)
        }
        _ => None,
    }
}
