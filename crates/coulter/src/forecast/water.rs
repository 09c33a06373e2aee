//! What water does to the forecast: whether it can follow, the suction where it cannot, and its drag on the
//! bodies.

use super::model_input::ModelInput;
use super::saturated::{BladeUnderWater, PloughUnderWater};
use analytic::cutting::{PloughForce, SaturatedCut};
use analytic::forecast::{Forecast, ModelForecast};
use analytic::{PoreWater, Suction};
use case::Case;
use case::resolved::Water;
use input::text::wrapped;
use serde_json::{Value, json};
use std::fmt::Write;

/// Factors by which the suction may be off: a third of it, itself, and three times as much.
const FACTORS: [f64; 3] = [1.0 / 3.0, 1.0, 3.0];

/// A forecast under water.
#[derive(Clone, Debug)]
pub struct UnderWater {
    /// Largest speed of the bodies [m/s].
    pub speed: f64,
    /// Drainage number at the largest speed of the bodies; `None` for soil without friction.
    pub drainage_number: Option<f64>,
    /// Drag of the water on all bodies at this speed [N].
    pub drag: f64,
    /// The models with a third of the suction, with it and with three times as much; `None` where the water
    /// follows freely.
    pub suction: Option<[Suction; 3]>,
    /// The body as a blade that cuts saturated sand; `None` for one without a plane front, and where the
    /// water follows freely.
    pub blade: Option<BladeUnderWater>,
    /// The tow force of a plough, if the case has its coefficients.
    pub plough: Option<PloughUnderWater>,
}

impl UnderWater {
    /// The forecast under water of a case whose models have this input; `None` on dry ground.
    ///
    /// # Errors
    /// In words, where the soil contracts faster than its water can leave, or no model has an answer with
    /// suction.
    pub(super) fn of(case: &Case, input: &ModelInput) -> Result<Option<Self>, String> {
        let Some(water) = case.water else {
            let message =
                "the coefficients of a plough are for ground under water; add [water], or remove them";
            return if case.forecast.plough.is_some() { Err(message.into()) } else { Ok(None) };
        };
        let speed = case.largest_speed();
        let bodies = case.bodies.iter().map(|body| case.fluid(body).drag * speed * speed);
        let plough = case.forecast.plough.as_ref();
        let mut found = Self {
            speed,
            drainage_number: case.drainage_number(),
            drag: bodies.sum(),
            suction: None,
            blade: None,
            plough: plough.map(|plough| PloughUnderWater::of(case, input, plough, speed)).transpose()?,
        };
        let (Some(number), Some(strain), Some(permeability)) =
            (found.drainage_number, case.volume_strain(), water.permeability)
        else {
            return Ok(Some(found));
        };
        if strain < 0.0 && number > Water::DRAINED[0] {
            return Err(format!(
                "the soil is loose and contracts as it is sheared (ε = {strain:.4}), faster than its water can leave (drainage number \
                 {number:.3}): it may liquefy"
            ));
        }
        if strain > 0.0 && speed > 0.0 {
            let pores = PoreWater {
                unit_weight: water.unit_weight(case.gravity),
                depth: (water.level - case.ground.surface()).max(0.0),
                permeability,
                volume_strain: strain,
            };
            let at = |times: f64| pores.forecast(&input.towing, speed, times).map_err(|why| why.to_string());
            found.suction = Some([at(FACTORS[0])?, at(FACTORS[1])?, at(FACTORS[2])?]);
            found.blade = BladeUnderWater::of(input, &pores, speed, FACTORS);
        }
        Ok(Some(found))
    }

    /// What the drainage number means.
    fn drains(&self) -> &'static str {
        match self.drainage_number {
            Some(number) if number > Water::DRAINED[1] => "the soil does not drain",
            Some(number) if number > Water::DRAINED[0] => "partly drained",
            _ => "drained",
        }
    }

    /// The forecast under water as text, for a forecast in which the models without suction are `drained`.
    pub(super) fn text(&self, drained: &Forecast, sinks: bool) -> String {
        let mut text = String::new();
        if let Some(number) = self.drainage_number {
            // Writing to a string cannot fail.
            let _ = writeln!(
                text,
                "\ndrainage number (γ_w/γ′) v ε/k = {number:.3} at {:.4} m/s: {} (up to {} it does, up to {} partly)",
                self.speed,
                self.drains(),
                Water::DRAINED[0],
                Water::DRAINED[1]
            );
        }
        if let Some(suction) = &self.suction {
            let mut parts = Vec::new();
            for model in drained.models.iter().filter(|model| model.applicable) {
                let found = suction.each_ref().map(|one| answer(&one.forecast, model));
                if let [Some(low), Some(middle), Some(high)] = found {
                    let sinkage = |p: &ModelForecast| {
                        p.prediction.and_then(|p| p.sinkage).map_or(f64::NAN, |z| 1e3 * z)
                    };
                    let drag = |p: &ModelForecast| p.prediction.map_or(f64::NAN, |p| p.drag);
                    let all = [low, middle, high];
                    let mut part = format!("{}: F_H = {}", model.name, spread(all.map(drag), "N"));
                    if sinks {
                        part += &format!(", z = {}", spread(all.map(sinkage), "mm"));
                    }
                    parts.push(part);
                }
            }
            let capped = if suction[1].cavitates { ", at which the water cavitates" } else { "" };
            let note = format!(
                "with suction, an order of magnitude ({}{capped}): {}. The table is for drained soil",
                spread(suction.each_ref().map(|one| 1e-3 * one.pressure), "kPa"),
                if parts.is_empty() { "no model has an answer".to_owned() } else { parts.join("; ") }
            );
            let _ = writeln!(text, "{}", wrapped(&note));
        }
        for line in self.blade.iter().map(blade_text).chain(self.plough.iter().map(plough_text)) {
            let _ = writeln!(text, "{}", wrapped(&line));
        }
        if self.drag > 0.0 {
            let _ = writeln!(text, "drag of the water on all bodies, in addition: {:.4} N", self.drag);
        }
        text
    }

    /// The forecast under water as JSON, for the models that apply without suction.
    pub(super) fn document(&self, drained: &Forecast) -> Value {
        let one = |suction: &Suction| {
            let models = drained.models.iter().filter(|model| model.applicable).filter_map(|model| {
                let found = answer(&suction.forecast, model)?.prediction?;
                Some(json!({
                    "name": model.name, "drag_N": found.drag, "vertical_N": found.vertical, "sinkage_m": found.sinkage,
                }))
            });
            json!({
                "suction_Pa": suction.pressure, "cavitates": suction.cavitates, "models": models.collect::<Vec<_>>(),
            })
        };
        json!({
            "speed_m_s": self.speed, "drainage_number": self.drainage_number, "water_drag_N": self.drag,
            "suction_factors": FACTORS, "with_suction": self.suction.as_ref().map(|all| all.each_ref().map(one)),
            "blade": self.blade.as_ref().map(blade_document), "plough": self.plough.as_ref().map(plough_document),
        })
    }
}

/// The cut of a blade in words.
fn blade_text(blade: &BladeUnderWater) -> String {
    let cuts = match &blade.cuts {
        Ok(cuts) => cuts,
        Err(why) => return format!("blade in saturated sand (Miedema): no answer: {why}"),
    };
    let of = |value: fn(&SaturatedCut) -> f64, unit: &str| spread(cuts.each_ref().map(value), unit);
    let capped = if cuts[1].cavitates { "; the water cavitates, the force grows no further" } else { "" };
    format!(
        "blade in saturated sand (Miedema, plane strain, the weight of the layer included), for a third of ε/k, ε/k and three times it: \
         F_H = {}, F_V = {}; shear angle {:.1}°, suction on the shear plane {}, on the blade {}{capped}",
        of(|cut| cut.force.drag, "N"),
        of(|cut| cut.force.vertical, "N"),
        cuts[1].shear_angle.to_degrees(),
        of(|cut| 1e-3 * cut.shear_suction, "kPa"),
        of(|cut| 1e-3 * cut.blade_suction, "kPa")
    )
}

/// The tow force of a plough in words.
fn plough_text(plough: &PloughUnderWater) -> String {
    let [low, high] = plough.forces;
    let of = |part: fn(&PloughForce) -> f64| format!("{:.4} to {:.4} N", part(&low), part(&high));
    format!(
        "tow force of a plough, C_w W′ + C_s γ′ D³ + C_d v D², with the coefficients of the case (W′ = {:.4} N, D = {:.4} m): {}; friction {}, \
         slow resistance {}, by the speed {}",
        plough.weight,
        plough.depth,
        of(PloughForce::total),
        of(|force| force.friction),
        of(|force| force.slow),
        of(|force| force.rate)
    )
}

fn blade_document(blade: &BladeUnderWater) -> Value {
    let one = |cut: &SaturatedCut| {
        json!({
            "drag_N": cut.force.drag, "vertical_N": cut.force.vertical, "shear_angle_rad": cut.shear_angle,
            "shear_suction_Pa": cut.shear_suction, "blade_suction_Pa": cut.blade_suction, "cavitates": cut.cavitates,
        })
    };
    let depth = if blade.depth.is_finite() { json!(blade.depth) } else { Value::Null };
    json!({
        "blade_angle_rad": blade.angle, "depth_m": depth, "note": blade.cuts.as_ref().err(),
        "cuts": blade.cuts.as_ref().ok().map(|cuts| cuts.each_ref().map(one)),
    })
}

fn plough_document(plough: &PloughUnderWater) -> Value {
    let one = |force: PloughForce| json!({ "tow_N": force.total(), "friction_N": force.friction, "slow_N": force.slow, "rate_N": force.rate });
    let [low, high] = plough.forces.map(one);
    json!({ "weight_N": plough.weight, "depth_m": plough.depth, "low": low, "high": high })
}

/// The answer of the same model in another forecast, if it has one there.
fn answer<'a>(forecast: &'a Forecast, model: &ModelForecast) -> Option<&'a ModelForecast> {
    forecast.models.iter().find(|other| other.model == model.model && other.prediction.is_some())
}

/// A value with its range.
fn spread([a, middle, b]: [f64; 3], unit: &str) -> String {
    format!("{middle:.3} {unit} ({:.3} to {:.3})", a.min(b), a.max(b))
}
