//! The quantities that closed-form models predict, each declared here: from these follow the entries of the
//! document, the numbers of `models.csv`, the closed forms in tables of studies, and what Python is given.

use super::outlook::Outlook;
use analytic::forecast::ModelForecast;

type Answer = fn(&Outlook, &ModelForecast) -> Option<f64>;

/// A quantity that models predict. One that a run has, too, has the same name there: see
/// `history::quantities`.
#[derive(Debug)]
pub struct Predicted {
    /// Name of the quantity, such as `vertical`.
    pub name: &'static str,
    /// SI unit of the quantity; `-` for a number without one.
    pub unit: &'static str,
    /// What a model of the outlook says, in its unit; `None` where it does not.
    pub of: Answer,
}

const fn predicted(name: &'static str, unit: &'static str, of: Answer) -> Predicted {
    Predicted { name, unit, of }
}

/// All quantities that models predict.
pub const PREDICTED: [Predicted; 11] = [
    predicted("drag", "N", |_, m| Some(m.prediction?.drag)),
    predicted("vertical", "N", |_, m| Some(m.prediction?.vertical)),
    predicted("lateral", "N", |_, m| m.prediction?.lateral),
    predicted("axle_torque", "N m", |outlook, m| Some(outlook.moment(m)?[1])),
    predicted("sinkage", "m", |_, m| m.prediction?.sinkage),
    predicted("contact_angle", "rad", |_, m| m.prediction?.contact_angle),
    predicted("force_inclination", "rad", |_, m| Some(m.prediction?.force_inclination)),
    predicted("slip", "-", |_, m| m.prediction?.slip),
    predicted("F_H_bar", "-", |outlook, m| Some(m.prediction?.drag / outlook.force_scale()?)),
    predicted("F_V_bar", "-", |outlook, m| Some(m.prediction?.vertical / outlook.force_scale()?)),
    predicted("Z", "-", |outlook, m| Some(m.prediction?.sinkage? / outlook.length_scale())),
];

impl Outlook {
    /// What a model says of the quantity with this name, in its SI unit.
    #[must_use]
    pub fn predicted(&self, model: &ModelForecast, name: &str) -> Option<f64> {
        PREDICTED
            .iter()
            .find(|quantity| quantity.name == name)
            .and_then(|quantity| (quantity.of)(self, model))
    }
}
