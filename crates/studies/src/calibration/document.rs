//! A calibration as JSON, as tables of text and as CSV. Names in the JSON are a contract on which scripts
//! rely.

use super::calibrate::{Calibration, Request};
use super::posterior::Marginal;
use super::runs::{RunOutcome, SolverPoint};
use super::stage::Stage;
use crate::sheet::{SheetTable, short};
use crate::sources::LeftOut;
use coulter::formats;
use coulter::printed::text_cell;
use serde_json::{Value, json};
use std::fmt::Write as _;

/// The document of a calibration.
#[must_use]
pub fn document(request: &Request<'_>, calibration: &Calibration) -> Value {
    let measured: Vec<Value> = calibration.last().iter().flat_map(|stage| &stage.curves).map(|curve| {
        json!({
            "name": curve.name, "quantity": curve.quantity.name(), "unit": curve.quantity.unit(),
            "abscissa": curve.abscissa.map(|a| a.name()), "at": curve.at, "values": curve.values,
            "standard_deviations": curve.deviations, "residuals": if curve.is_logarithmic { "logarithms" } else { "scaled" },
        })
    }).collect();
    let solver = calibration.solver.as_ref().map(|solver| {
        json!({
            "result": stage(&solver.stage, request),
            "predictivity": solver.predictivity,
            "components": solver.components,
            "runs": solver.points.iter().map(|point| run(point, request)).collect::<Vec<_>>(),
            "verification": solver.verified.as_ref().map(|seen| values(&solver.stage, seen)),
            "largest_surprise": solver.surprise,
        })
    });
    json!({
        "format": formats::DOCUMENT,
        "case": request.case.display().to_string(),
        "unknowns": request.space.unknowns.iter().map(|u| json!({
            "name": u.name, "unit": u.unit, "prior": u.prior.text(&u.unit),
        })).collect::<Vec<_>>(),
        "links": request.space.links.iter().map(|link| link.text.clone()).collect::<Vec<_>>(),
        "seed": request.effort.seed,
        "measured": measured,
        "left_out": calibration.left_out.iter().map(LeftOut::text).collect::<Vec<_>>(),
        "remarks": calibration.remarks,
        "closed_form": calibration.closed.as_ref().map(|closed| stage(closed, request)),
        "solver": solver,
    })
}

/// What residuals see, as values [SI] of each curve.
pub(super) fn values(stage: &Stage, seen: &[f64]) -> Vec<Vec<f64>> {
    let mut first = 0;
    let mut list = Vec::new();
    for curve in &stage.curves {
        let points = curve.values.len();
        list.push((0..points).filter_map(|n| seen.get(first + n).map(|s| curve.unseen(n, *s))).collect());
        first += points;
    }
    list
}

fn stage(stage: &Stage, request: &Request<'_>) -> Value {
    let marginal = |m: &Marginal| {
        json!({
            "name": m.name, "unit": m.unit, "prior": m.prior, "best": m.best, "median": m.median,
            "interval_90": m.interval, "width_over_prior": m.width, "r_hat": m.reduction,
            "effective_samples": m.effective,
        })
    };
    let bands = stage.curves.iter().zip(&stage.bands).map(
        |(curve, band)| json!({ "at": curve.at, "best": band.best, "low": band.low, "high": band.high }),
    );
    json!({
        "model": stage.model,
        "parameters": stage.posterior.marginals.iter().map(marginal).collect::<Vec<_>>(),
        "correlations": stage.posterior.correlations,
        "noise": stage.posterior.noise.map(|[median, low, high]| json!({ "median": median, "interval_90": [low, high] })),
        "squares": stage.squares,
        "points": stage.points,
        "acceptance": stage.posterior.acceptance,
        "curves": bands.collect::<Vec<_>>(),
        "overrides": request.space.overrides(&stage.best).unwrap_or_default(),
        "warnings": stage.advice.iter().map(|a| json!({ "message": a.message, "cure": a.cure })).collect::<Vec<_>>(),
    })
}

/// How a run went: one word, and why where it cannot be used.
pub(super) fn state(point: &SolverPoint) -> (&'static str, String) {
    match &point.outcome {
        RunOutcome::Curves(_) => (point.verdict.map_or("", |verdict| verdict.name()), String::new()),
        RunOutcome::Failed(why) => ("failed", why.clone()),
        RunOutcome::Refused(why) => ("refused", why.clone()),
    }
}

fn run(point: &SolverPoint, request: &Request<'_>) -> Value {
    let (state, why) = state(point);
    let folders: Vec<String> = point.folders.iter().map(|folder| folder.display().to_string()).collect();
    let named = request.space.unknowns.iter().zip(&point.values).map(|(u, v)| (u.name.clone(), json!(v)));
    json!({
        "values": named.collect::<serde_json::Map<_, _>>(), "folders": folders, "state": state, "reason": why,
    })
}

/// The table of the unknowns.
#[must_use]
pub fn parameters(stage: &Stage) -> SheetTable {
    let row = |m: &Marginal| {
        let [low, high] = m.interval;
        vec![
            if m.unit.is_empty() { m.name.clone() } else { format!("{} [{}]", m.name, m.unit) },
            short(m.best),
            short(m.median),
            format!("{} to {}", short(low), short(high)),
            m.prior.clone(),
            format!("{:.0} %", 100.0 * m.width),
        ]
    };
    let head = ["parameter", "best", "median", "90 % interval", "prior", "of its width"];
    SheetTable {
        head: head.map(str::to_owned).to_vec(),
        rows: stage.posterior.marginals.iter().map(row).collect(),
    }
}

/// The table of correlations.
#[must_use]
pub fn correlations(stage: &Stage) -> SheetTable {
    let names: Vec<String> = stage.posterior.marginals.iter().map(|m| m.name.clone()).collect();
    let row = |(name, row): (&String, &Vec<f64>)| {
        std::iter::once(name.clone()).chain(row.iter().map(|c| format!("{c:.2}"))).collect()
    };
    SheetTable {
        head: std::iter::once("correlation".to_owned()).chain(names.iter().cloned()).collect(),
        rows: names.iter().zip(&stage.posterior.correlations).map(row).collect(),
    }
}

/// What a terminal shows of a calibration.
#[must_use]
pub fn text(calibration: &Calibration) -> String {
    let mut text = String::new();
    for left_out in &calibration.left_out {
        let _ = writeln!(text, "{}", left_out.text());
    }
    let stages = calibration.closed.iter().chain(calibration.solver.as_ref().map(|solver| &solver.stage));
    for stage in stages {
        let _ =
            writeln!(text, "{}: Σ(r/σ)² = {} for {} points", stage.model, short(stage.squares), stage.points);
        if let Some([median, low, high]) = stage.posterior.noise {
            let percent = |part: f64| short(100.0 * part);
            let _ = writeln!(text, "noise {} % ({} to {} %)", percent(median), percent(low), percent(high));
        }
        let _ = write!(text, "{}", parameters(stage).text());
        if stage.posterior.marginals.len() > 1 {
            let _ = write!(text, "{}", correlations(stage).text());
        }
        for advice in &stage.advice {
            let _ = writeln!(text, "WARNING: {}\n  {}", advice.message, advice.cure);
        }
        text.push('\n');
    }
    if let Some(solver) = &calibration.solver {
        let failed = solver.points.iter().filter(|point| !matches!(point.outcome, RunOutcome::Curves(_)));
        let _ = writeln!(
            text,
            "{} runs, {} of them cannot be used; surrogate of {} components, Q² = {:.3}",
            solver.points.len(),
            failed.count(),
            solver.components,
            solver.predictivity
        );
        let verified = match solver.surprise {
            Some(surprise) => format!(
                "the run at the best values is within {surprise:.1} standard deviations of the surrogate"
            ),
            None => "the run at the best values cannot be used: take them for unverified".to_owned(),
        };
        let _ = writeln!(text, "{verified}");
    }
    for remark in &calibration.remarks {
        let _ = writeln!(text, "note: {remark}");
    }
    text
}

/// The runs as CSV: values, state, folder, reason.
#[must_use]
pub fn runs_csv(request: &Request<'_>, points: &[SolverPoint]) -> String {
    let header = request
        .space
        .unknowns
        .iter()
        .map(|u| text_cell(&format!("{} [{}]", u.name, if u.unit.is_empty() { "-" } else { &u.unit })));
    let mut text = format!("{},state,folder,reason\n", header.collect::<Vec<_>>().join(","));
    for point in points {
        let (state, why) = state(point);
        let values: Vec<String> = point.values.iter().map(f64::to_string).collect();
        let folder = point.folders.last().map_or(String::new(), |folder| folder.display().to_string());
        let _ = writeln!(
            text,
            "{},{state},{},{}",
            values.join(","),
            text_cell(&folder),
            text_cell(&why.replace('\n', " "))
        );
    }
    text
}

/// The samples of the posterior as CSV.
#[must_use]
pub fn samples_csv(stage: &Stage) -> String {
    let header = stage
        .posterior
        .marginals
        .iter()
        .map(|m| text_cell(&format!("{} [{}]", m.name, if m.unit.is_empty() { "-" } else { &m.unit })));
    let mut text = format!("{}\n", header.collect::<Vec<_>>().join(","));
    for sample in &stage.posterior.samples {
        let _ = writeln!(text, "{}", sample.iter().map(f64::to_string).collect::<Vec<_>>().join(","));
    }
    text
}
