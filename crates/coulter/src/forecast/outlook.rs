//! What the closed-form models say of a case.

use super::setting::{Setting, setting};
use crate::case::Case;
use analytic::Forecast;
use analytic::disc::{Drive, Mechanism};
use analytic::forecast::{Candidate, Load, ModelForecast};

/// The answer to a case.
#[derive(Clone, Debug)]
pub struct Outlook {
    /// Name of the case.
    pub case: String,
    /// How the case was brought to the form of the models.
    pub setting: Setting,
    /// What the models say.
    pub forecast: Forecast,
}

/// Evaluates every closed form for the body of `case`.
///
/// # Errors
/// The reason, in words, why no closed form can take the case.
pub fn outlook(case: &Case) -> Result<Outlook, String> {
    let setting = setting(case)?;
    let mut forecast = analytic::forecast(&setting.towing).map_err(|why| why.to_string())?;
    for model in forecast.models.iter_mut().chain(&mut forecast.models_full_friction) {
        if let Some(key) = missing_key(model.model, &setting) {
            model.note = key.to_owned();
        }
    }
    Ok(Outlook { case: case.name.clone(), setting, forecast })
}

/// Which key would let a model speak that the case gives too little.
fn missing_key(model: Candidate, setting: &Setting) -> Option<&'static str> {
    let towing = &setting.towing;
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
    /// The model to believe; none where it has no answer.
    #[must_use]
    pub fn recommended(&self) -> Option<&ModelForecast> {
        self.forecast.models.iter().find(|m| Some(m.model) == self.forecast.recommended)
    }

    /// The force that makes forces dimensionless: γ t d² of one body [N].
    #[must_use]
    pub fn force_scale(&self) -> f64 {
        self.setting.towing.body.force_scale(self.setting.towing.soil.unit_weight)
    }

    /// Whether the body sinks under its weight.
    #[must_use]
    pub fn sinks(&self) -> bool {
        matches!(self.setting.towing.load, Load::Weight(_))
    }
}

/// The mechanism in one word.
pub(super) fn mechanism_word(mechanism: Mechanism) -> &'static str {
    match mechanism {
        Mechanism::Sideways => "sideways",
        Mechanism::Forwards => "forwards",
    }
}
