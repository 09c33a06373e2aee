//! What a model predicts, and its entry in a forecast.

use super::Candidate;
use crate::disc::Mechanism;
use crate::error::{ModelError, ModelResult};

/// Prediction of a model; quantities that the model does not give are `None`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Prediction {
    /// Drag F_H [N]: resistance less [`Prediction::thrust`].
    pub drag: f64,
    /// Thrust of a driven body [N]: the torque of the soil about its axle over the radius on which it rolls;
    /// 0 where nothing drives it.
    pub thrust: f64,
    /// Vertical force F_V [N].
    pub vertical: f64,
    /// Lateral force along y, to the left [N].
    pub lateral: Option<f64>,
    /// Moments of the soil about x, y, z through the centre of the body [N m].
    pub moment: Option<[f64; 3]>,
    /// Sinkage z [m].
    pub sinkage: Option<f64>,
    /// Contact angle θ_f [rad].
    pub contact_angle: Option<f64>,
    /// Inclination η of the force to the vertical [rad].
    pub force_inclination: f64,
    /// The [`crate::slip`]: −1 locked, 0 rolling, above 0 driven.
    pub slip: Option<f64>,
    /// Failure mechanism under more than half of the thrust.
    pub mechanism: Option<Mechanism>,
    /// Fraction of the thrust under which the soil fails sideways, 0 to 1.
    pub sideways_fraction: Option<f64>,
    /// Pressure on the end of a cone or a pile [Pa], without the friction on its shaft.
    pub end_pressure: Option<f64>,
}

impl Prediction {
    /// Forces alone [N].
    pub(super) fn of_forces(drag: f64, vertical: f64, sinkage: Option<f64>) -> Self {
        Self {
            drag,
            thrust: 0.0,
            vertical,
            lateral: None,
            moment: None,
            sinkage,
            contact_angle: None,
            force_inclination: drag.atan2(vertical),
            slip: None,
            mechanism: None,
            sideways_fraction: None,
            end_pressure: None,
        }
    }
}

/// Entry of a model in a forecast.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelForecast {
    /// The model.
    pub model: Candidate,
    /// Name of the model.
    pub name: &'static str,
    /// Whether the case lies within the limits of the model.
    pub applicable: bool,
    /// Prediction of the model, if it has one, also outside its limits.
    pub prediction: Option<Prediction>,
    /// Why the model does not apply, or a caveat.
    pub note: String,
}

impl ModelForecast {
    /// The entry for a result; a model without a prediction is not applicable.
    pub(super) fn of(model: Candidate, result: ModelResult<Prediction>) -> Self {
        let (prediction, note) = match result {
            Ok(prediction) => (Some(prediction), String::new()),
            Err(ModelError::DoesNotExist { why, .. }) => (None, why),
            Err(why) => (None, why.to_string()),
        };
        Self { model, name: model.name(), applicable: prediction.is_some(), prediction, note }
    }

    /// Marks the prediction as outside the limits of the model, unless a reason is already given.
    pub(super) fn exclude(&mut self, why: &str) {
        if self.applicable {
            self.applicable = false;
            self.note = why.into();
        }
    }
}
