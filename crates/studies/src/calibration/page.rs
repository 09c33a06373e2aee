//! The page of a calibration: parameters, predicted against measured, samples of every pair.

use super::calibrate::{Calibration, Request};
use super::data::MeasuredCurve;
use super::document::{correlations, parameters, state, values};
use super::runs::SolverPoint;
use super::stage::{Band, Stage};
use crate::sheet::{Sheet, SheetFigure, SheetSection, SheetTable, short};
use crate::sources::LeftOut;
use coulter::output::plots::{Chart, Curve, Stroke};

/// Pairs of unknowns that are drawn at most, and samples of each.
const PAIRS: usize = 15;
const SAMPLES: usize = 400;

/// The page as HTML.
///
/// # Errors
/// What the template engine says.
pub fn page(request: &Request<'_>, calibration: &Calibration) -> Result<String, String> {
    let mut sections = Vec::new();
    if let Some(stage) = &calibration.closed {
        sections.extend(of_stage(stage, &[]));
    }
    if let Some(solver) = &calibration.solver {
        let verified = solver.verified.as_ref().map(|seen| values(&solver.stage, seen)).unwrap_or_default();
        sections.extend(of_stage(&solver.stage, &verified));
        sections.push(runs(request, &solver.points));
    }
    let stages = || calibration.closed.iter().chain(calibration.solver.as_ref().map(|solver| &solver.stage));
    let warnings = stages().flat_map(|stage| {
        stage.advice.iter().map(|a| [format!("{}: {}", stage.model, a.message), a.cure.clone()])
    });
    let names: Vec<String> = request.records.iter().map(|record| record.name.clone()).collect();
    let sheet = Sheet {
        title: format!("Calibration of {}", request.case.file_name().unwrap_or_default().display()),
        facts: vec![
            ["case".to_owned(), request.case.display().to_string()],
            ["measured".to_owned(), names.join(", ")],
            ["unknowns".to_owned(), request.space.unknowns.iter().map(|u| u.name.clone()).collect::<Vec<_>>().join(", ")],
        ],
        warnings: calibration
            .left_out
            .iter()
            .map(LeftOut::text)
            .chain(calibration.remarks.iter().cloned())
            .map(|note| [note, String::new()])
            .chain(warnings)
            .collect(),
        sections,
        footer: "Intervals are those of the posterior density, 5 to 95 %; docs/how-to/read-a-posterior.md explains likelihood, priors and sampler."
            .to_owned(),
    };
    sheet.html()
}

fn of_stage(stage: &Stage, verified: &[Vec<f64>]) -> Vec<SheetSection> {
    let mut tables = vec![parameters(stage)];
    if stage.posterior.marginals.len() > 1 {
        tables.push(correlations(stage));
    }
    let noise = stage.posterior.noise.map_or(String::new(), |[median, low, high]| {
        format!(
            " Noise, estimated: {} % ({} to {} %).",
            short(100.0 * median),
            short(100.0 * low),
            short(100.0 * high)
        )
    });
    let note = format!(
        "Sum of squared residuals over their noise: {} for {} points.{noise}",
        short(stage.squares),
        stage.points
    );
    let figures = stage
        .curves
        .iter()
        .zip(&stage.bands)
        .enumerate()
        .map(|(n, (curve, band))| against(curve, band, verified.get(n)));
    vec![
        SheetSection { title: format!("Parameters by {}", stage.model), note, tables, figures: figures.collect() },
        SheetSection {
            title: "What the measurements leave open".to_owned(),
            note: "Samples of the posterior, and the best values. A narrow slanted cloud: the two cannot be told apart.".to_owned(),
            tables: Vec::new(),
            figures: pairs(stage),
        },
    ]
}

/// Predicted against measured along the abscissa.
fn against(curve: &MeasuredCurve, band: &Band, verified: Option<&Vec<f64>>) -> SheetFigure {
    let points = |values: &[f64]| curve.at.iter().zip(values).map(|(x, y)| [*x, *y]).collect::<Vec<_>>();
    let line = |name: &str, colour: usize, stroke: Stroke, values: &[f64]| Curve {
        name: name.to_owned(),
        points: points(values),
        colour,
        stroke,
    };
    let mut curves = vec![
        line("90 % band", 0, Stroke::Dashed, &band.low),
        line("", 0, Stroke::Dashed, &band.high),
        line("best", 0, Stroke::Solid, &band.best),
    ];
    curves.extend(verified.map(|values| line("run at the best values", 2, Stroke::Dots, values)));
    curves.push(line("measured", 1, Stroke::Dots, &curve.values));
    let label = |quantity: crate::measured::Quantity| format!("{} [{}]", quantity.label(), quantity.unit());
    let chart = Chart {
        title: curve.quantity.label().to_owned(),
        x_label: curve.abscissa.map_or("steady mean".to_owned(), label),
        y_label: label(curve.quantity),
        with_zero: true,
        curves,
        ..Chart::default()
    };
    SheetFigure { svg: chart.svg(), caption: format!("{}: predicted and measured.", curve.name) }
}

fn pairs(stage: &Stage) -> Vec<SheetFigure> {
    let marginals = &stage.posterior.marginals;
    let samples = &stage.posterior.samples;
    let every = samples.len().div_ceil(SAMPLES).max(1);
    let name = |n: usize| match marginals[n].unit.as_str() {
        "" => marginals[n].name.replace('_', " "),
        unit => format!("{} [{unit}]", marginals[n].name.replace('_', " ")),
    };
    let pair = |(i, j): (usize, usize)| {
        let cloud = samples.iter().step_by(every).map(|sample| [sample[i], sample[j]]).collect();
        let best = vec![[stage.best[i], stage.best[j]]];
        let chart = Chart {
            x_label: name(i),
            y_label: name(j),
            curves: vec![
                Curve { name: "samples".to_owned(), points: cloud, colour: 4, stroke: Stroke::Dots },
                Curve { name: "best".to_owned(), points: best, colour: 1, stroke: Stroke::Dots },
            ],
            ..Chart::default()
        };
        let correlation = stage.posterior.correlations[j][i];
        SheetFigure { svg: chart.svg(), caption: format!("Correlation {correlation:.2}.") }
    };
    let count = marginals.len();
    let all = (0..count).flat_map(|i| (i + 1..count).map(move |j| (i, j)));
    all.take(PAIRS).map(pair).collect()
}

fn runs(request: &Request<'_>, points: &[SolverPoint]) -> SheetSection {
    let names = request.space.unknowns.iter().map(|u| u.name.clone());
    let row = |(n, point): (usize, &SolverPoint)| {
        let (state, why) = state(point);
        let mut cells = vec![format!("{}", n + 1)];
        cells.extend(point.values.iter().map(|value| short(*value)));
        cells.extend([state.to_owned(), why]);
        cells
    };
    let head = std::iter::once("run".to_owned())
        .chain(names)
        .chain(["grade".to_owned(), "why it cannot be used".to_owned()]);
    SheetSection {
        title: "Runs of the solver".to_owned(),
        note: "The last one is at the best values.".to_owned(),
        tables: vec![SheetTable { head: head.collect(), rows: points.iter().enumerate().map(row).collect() }],
        figures: Vec::new(),
    }
}
