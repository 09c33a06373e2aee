//! The dimensionless groups of a body.

use coulter::case::Case;
use coulter::case::resolved::{Body, Motion};
use coulter::history::reference::Reference;
use serde::Serialize;

/// Dimensionless groups of one body; `None` where the soil is weightless.
#[derive(Debug, Serialize)]
pub(super) struct Groups {
    /// t/d.
    pub(super) t_bar: f64,
    /// W/(γtd²).
    #[serde(rename = "W_bar")]
    pub(super) w_bar: Option<f64>,
    /// E/(γd).
    #[serde(rename = "E_bar")]
    pub(super) e_bar: Option<f64>,
    /// c/(γd), or s_u/(γd).
    pub(super) c_bar: Option<f64>,
    /// v²/(g d), of the fastest prescribed motion.
    pub(super) froude: Option<f64>,
}

/// The groups of one body of a case.
pub(super) fn groups(case: &Case, body: &Body) -> Groups {
    let reference = Reference::of(case, body);
    let (d, t) = (reference.length, reference.width);
    let gamma = case.soil.unit_weight;
    let over_weight = |x: f64| (gamma > 0.0).then_some(x / gamma);
    let speed = body.guided().translation.iter().map(prescribed_speed).fold(0.0, f64::max);
    Groups {
        t_bar: t / d,
        w_bar: body.pressing_force(case.normal_weight(body)).and_then(|w| over_weight(w / (t * d * d))),
        e_bar: over_weight(case.soil.young_modulus / d),
        c_bar: case.soil.law.cohesion().and_then(|c| over_weight(c / d)),
        froude: (case.gravity > 0.0).then_some(speed.powi(2) / (case.gravity * d)),
    }
}

fn prescribed_speed(freedom: &Motion) -> f64 {
    if let Motion::Prescribed { speed, .. } = freedom { speed.abs() } else { 0.0 }
}
