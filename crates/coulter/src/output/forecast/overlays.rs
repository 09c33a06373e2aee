//! The forecast as curves over the plots of a run.

use crate::forecast::{Outlook, outlook};
use analytic::forecast::{Candidate, ModelForecast, Parameter, curve};
use case::Case;
use results::overlay::{Overlay, PlotKind};

/// Points of a force–sinkage curve.
const POINTS: usize = 41;
/// How far the force–sinkage curve extends beyond the deepest forecast.
const BEYOND: f64 = 1.25;

/// The best model and its rival, 3D-RFT or the bearing capacity, as overlays: levels for the tow, and curves
/// against sinkage.
///
/// # Errors
/// The reason why the closed forms do not apply to the case.
pub fn overlays(case: &Case) -> Result<Vec<Overlay>, String> {
    let outlook = outlook(case)?;
    let [body] = &outlook.input.bodies[..] else {
        return Err("overlays are for a single body".into());
    };
    let best = outlook.best();
    let is_rival = |m: &&ModelForecast| {
        let is_known = matches!(m.model, Candidate::SpatialResistive | Candidate::Footing);
        is_known && m.applicable && Some(m.model) != best.map(|b| b.model)
    };
    let second = outlook.forecast.models.iter().find(is_rival);
    let models: Vec<&ModelForecast> = best.into_iter().chain(second).collect();
    if models.is_empty() {
        return Err("no closed form applies".into());
    }
    let mut overlays: Vec<Overlay> = models.iter().flat_map(|m| levels(&outlook, m, body)).collect();
    overlays.extend(force_sinkage(&outlook, &models, body)?);
    Ok(overlays)
}

fn levels(outlook: &Outlook, model: &ModelForecast, body: &str) -> Vec<Overlay> {
    let Some(found) = model.prediction else { return Vec::new() };
    let turn = found.slip.map(|slip| outlook.input.towing.drive.turn_ratio(slip));
    // The load of a free disc is known and not a result.
    let is_towed = !outlook.input.towing.pressed;
    let vertical = (!outlook.sinks()).then_some(found.vertical);
    // What is pressed down to a prescribed sinkage has a curve against sinkage only.
    let sinkage = found.sinkage.filter(|_| is_towed || outlook.sinks());
    let entries = [
        (PlotKind::ForceDisplacement, "F_H", Some(found.drag).filter(|_| is_towed)),
        (PlotKind::ForceDisplacement, "F_V", vertical.filter(|_| is_towed)),
        (PlotKind::SinkageDisplacement, "z", sinkage),
        (PlotKind::TurnRatio, "turn ratio", turn),
    ];
    let level = |(plot, what, value): (PlotKind, &str, Option<f64>)| {
        Some(overlay(plot, &format!("{} {what}", model.name), body, vec![[0.0, value?]]))
    };
    entries.into_iter().filter_map(level).collect()
}

fn force_sinkage(outlook: &Outlook, models: &[&ModelForecast], body: &str) -> Result<Vec<Overlay>, String> {
    let towing = &outlook.input.towing;
    // A block that sinks also rests on its base, which the force on its front at a given sinkage does not
    // include.
    if outlook.sinks() && towing.body.block().is_some() {
        return Ok(Vec::new());
    }
    let deepest = models.iter().filter_map(|m| m.prediction?.sinkage).fold(0.0, f64::max);
    let end = (BEYOND * deepest).min(0.9 * towing.body.height());
    if end <= 0.0 {
        return Ok(Vec::new());
    }
    let depths: Vec<f64> = (1..=POINTS).map(|n| end * n as f64 / POINTS as f64).collect();
    let candidates: Vec<Candidate> = models.iter().map(|m| m.model).collect();
    let points = curve(towing, Parameter::Sinkage, &depths, &candidates).map_err(|e| e.to_string())?;
    let mut overlays = Vec::new();
    for (n, model) in models.iter().enumerate() {
        let found = || points.iter().filter_map(|p| Some((p.value, p.models.get(n)?.prediction?)));
        let drag = found().map(|(z, p)| [z, p.drag]).collect();
        let vertical = found().map(|(z, p)| [z, p.vertical]).collect();
        if !towing.pressed {
            overlays.push(overlay(PlotKind::ForceSinkage, &format!("{} F_H", model.name), body, drag));
        }
        overlays.push(overlay(PlotKind::ForceSinkage, &format!("{} F_V", model.name), body, vertical));
    }
    overlays.retain(|o| !o.points.is_empty());
    Ok(overlays)
}

fn overlay(plot: PlotKind, name: &str, body: &str, points: Vec<[f64; 2]>) -> Overlay {
    Overlay { name: name.to_owned(), plot, body: Some(body.to_owned()), measured: false, points }
}
