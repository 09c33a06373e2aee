//! The curve of a closed-form model for a case: along the sinkage, along the slip, or the steady value of a tow.

use crate::measured::Quantity;
use analytic::Towing;
use analytic::forecast::{Body, Candidate, CurvePoint, Parameter, Prediction, Strength, curve, predict};
use coulter::case::Case;
use coulter::forecast::{ModelInput, model_input, outlook};

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

/// A model and its input.
#[derive(Clone, Debug)]
pub struct ClosedForm {
    /// The model.
    pub candidate: Candidate,
    /// Its input.
    pub input: ModelInput,
}

impl ClosedForm {
    /// The model of that name for a case; without a name, the recommended one.
    ///
    /// # Errors
    /// Why there is none, in words.
    pub fn of(case: &Case, name: Option<&str>) -> Result<Self, String> {
        let outlook = outlook(case).map_err(|why| format!("there is no closed form for this case: {why}"))?;
        let Some(name) = name else {
            let Some(best) = outlook.recommended() else {
                return Err(format!("no closed form applies. {}", outlook.forecast.recommendation));
            };
            return Ok(Self { candidate: best.model, input: outlook.input });
        };
        let wanted = Candidate::ALL.into_iter().find(|model| model.name().eq_ignore_ascii_case(name));
        let Some(candidate) = wanted else {
            let names: Vec<&str> = Candidate::ALL.into_iter().map(Candidate::name).collect();
            return Err(format!("`{name}` is no model; known are {}", names.join(", ")));
        };
        Ok(Self { candidate, input: outlook.input })
    }

    /// The same model for another case: other values of keys.
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

    /// Along what its curves run that are measured along a quantity.
    #[must_use]
    pub fn along(&self, abscissa: Quantity) -> Along {
        match abscissa {
            Quantity::Slip => Along::Slip,
            Quantity::Sinkage => Along::Sinkage,
            _ => Along::Steady,
        }
    }

    /// Whether the body is pressed down, so that its forces follow the sinkage.
    #[must_use]
    pub fn is_pressed(&self) -> bool {
        self.input.towing.pressed
    }
}

/// As [`ClosedForm::values`], of an input.
fn values(
    towing: &Towing,
    candidate: Candidate,
    quantity: Quantity,
    (along, at): (Along, &[f64]),
) -> Result<Vec<f64>, String> {
    let (parameter, at) = match along {
        Along::Sinkage => (Parameter::Sinkage, at),
        Along::Slip => (Parameter::Slip, at),
        // Setting the resistance factor to what it is changes nothing.
        Along::Steady => (Parameter::ResistanceFactor, &[towing.resistance_factor][..]),
    };
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

/// The prediction for a body that is pressed down. Unlike [`curve`] it makes no table of passive pressures for every point, which only
/// bodies under tow need, and which takes a thousand times as long as the rest.
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
        Quantity::Pressure => Some(prediction.vertical / base_area(towing)?),
        _ => None,
    }
}

/// The area of a level base [m²]; of a round body that is pressed down, that of its largest section.
fn base_area(towing: &Towing) -> Option<f64> {
    match &towing.body {
        Body::Plate(plate) => Some(plate.area()),
        Body::Faceted(body) if towing.pressed => {
            Some(0.25 * std::f64::consts::PI * body.length * body.length)
        }
        _ => None,
    }
}
