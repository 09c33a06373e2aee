//! What the closed-form models say of a case.

use super::model_input::{ModelInput, model_input};
use super::water::UnderWater;
use analytic::Forecast;
use analytic::disc::{Drive, Mechanism};
use analytic::forecast::{Candidate, Load, ModelForecast};
use case::Case;

/// The forecast for a case.
#[derive(Clone, Debug)]
pub struct Outlook {
    /// Name of the case.
    pub case: String,
    /// The input of the models.
    pub input: ModelInput,
    /// The results of the models.
    pub forecast: Forecast,
    /// What water does to the body; `None` on dry ground.
    pub under_water: Option<UnderWater>,
}

/// Evaluates every closed-form model for the body of `case`.
///
/// # Errors
/// The reason, in words, why no closed form applies to the case.
pub fn outlook(case: &Case) -> Result<Outlook, String> {
    let input = model_input(case)?;
    let mut forecast = analytic::forecast(&input.towing).map_err(|why| why.to_string())?;
    for model in forecast.models.iter_mut().chain(&mut forecast.models_other_strength) {
        if let Some(key) = missing_key(model.model, &input) {
            model.note = key.to_owned();
        }
    }
    if input.mirrored {
        for found in forecast.models.iter_mut().chain(&mut forecast.models_other_strength) {
            if let Some(found) = &mut found.prediction {
                // The left of the mirror image is the right.
                found.lateral = found.lateral.map(|force| 0.0 - force);
            }
        }
    }
    let under_water = UnderWater::of(case, &input)?;
    Ok(Outlook { case: case.name.clone(), input, forecast, under_water })
}

/// The key that a model needs and the case lacks, if that is why the model does not apply.
fn missing_key(model: Candidate, input: &ModelInput) -> Option<&'static str> {
    let towing = &input.towing;
    if towing.body.disc().is_none() || towing.drive != Drive::Free || towing.assembly.is_some() {
        return None;
    }
    match model {
        Candidate::Bekker | Candidate::WongReece if towing.terrain.is_none() => Some(
            "needs plate constants: [forecast] terrain = \"LETE sand\" (or another published soil), or \
             sinkage_exponent, cohesive_modulus and frictional_modulus",
        ),
        Candidate::WismerLuth | Candidate::Brixius
            if towing.cone_index.is_none() && matches!(towing.load, Load::Weight(_)) =>
        {
            Some("needs the cone index: [forecast] cone_index = \"300 kPa\"")
        }
        _ => None,
    }
}

impl Outlook {
    /// The recommended model; `None` if there is none, or it has no answer.
    #[must_use]
    pub fn recommended(&self) -> Option<&ModelForecast> {
        self.forecast.models.iter().find(|m| Some(m.model) == self.forecast.recommended)
    }

    /// The best model that applies: the recommended one, or one that is not recommended for want of a good
    /// record.
    #[must_use]
    pub fn best(&self) -> Option<&ModelForecast> {
        let best = analytic::forecast::best(&self.input.towing, &self.forecast.models);
        self.forecast.models.iter().find(|m| Some(m.model) == best)
    }

    /// Moments of the soil about x, y, z [N m] that a model predicts for the body itself: of one that is
    /// towed backwards the models are given the mirror image about x = 0.
    #[must_use]
    pub fn moment(&self, model: &ModelForecast) -> Option<[f64; 3]> {
        let [x, y, z] = model.prediction?.moment?;
        Some(if self.input.mirrored { [x, -y, -z] } else { [x, y, z] })
    }

    /// The reference force γ t d² [N], of several bodies that of all; `None` for weightless soil.
    #[must_use]
    pub fn force_scale(&self) -> Option<f64> {
        self.input.towing.force_scale()
    }

    /// The reference length d [m].
    #[must_use]
    pub fn length_scale(&self) -> f64 {
        self.input.towing.reference_lengths()[0]
    }

    /// Whether the body sinks under its weight.
    #[must_use]
    pub fn sinks(&self) -> bool {
        matches!(self.input.towing.load, Load::Weight(_))
    }
}

/// The mechanism in one word.
pub(super) fn mechanism_word(mechanism: Mechanism) -> &'static str {
    match mechanism {
        Mechanism::Sideways => "sideways",
        Mechanism::Forwards => "forwards",
    }
}
