//! The closed forms for the same case that the solver runs: what every applicable model says of its disc.

mod curves;
mod document;
pub mod overlay;
mod range;
mod setting;
mod spread;
mod tables;
mod variable;

pub use curves::{Curves, Series, curves};
pub use document::document;
pub use range::{Range, Unreadable};
pub use setting::{Setting, setting};
pub use spread::{Interval, Stated, intervals};
pub use tables::{models_table, table, uncertainty_table};
pub use variable::{Variable, find, variables};

use crate::case::Case;
use analytic::Forecast;
use analytic::disc::Mechanism;
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

/// Evaluates every closed form for the disc of `case`.
///
/// # Errors
/// The reason, in words, why no closed form can take the case.
pub fn outlook(case: &Case) -> Result<Outlook, String> {
    let setting = setting(case)?;
    let forecast = analytic::forecast(&setting.towing).map_err(|why| why.to_string())?;
    Ok(Outlook { case: case.name.clone(), setting, forecast })
}

impl Outlook {
    /// The model to believe: the one of BC and PW whose mechanism governs; none where neither has an answer.
    #[must_use]
    pub fn recommended(&self) -> Option<&ModelForecast> {
        let weaker = self.model(Candidate::Weaker)?;
        let governing = match weaker.prediction?.mechanism {
            Some(Mechanism::Forwards) => Candidate::Wedge,
            _ => Candidate::Bearing,
        };
        self.model(governing)
    }

    fn model(&self, candidate: Candidate) -> Option<&ModelForecast> {
        self.forecast.models.iter().find(|m| m.model == candidate)
    }

    /// The force that makes forces dimensionless: γ t d² of one disc [N].
    #[must_use]
    pub fn force_scale(&self) -> f64 {
        self.setting.towing.disc.force_scale(self.setting.towing.soil.unit_weight)
    }

    /// Whether the disc sinks under its weight.
    #[must_use]
    pub fn sinks(&self) -> bool {
        matches!(self.setting.towing.load, Load::Weight(_))
    }
}

/// The mechanism in one word.
pub(crate) fn mechanism_word(mechanism: Mechanism) -> &'static str {
    match mechanism {
        Mechanism::Sideways => "sideways",
        Mechanism::Forwards => "forwards",
    }
}
