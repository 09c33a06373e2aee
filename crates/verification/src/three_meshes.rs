//! D11: the light disc on three meshes that resolve its sinkage.

use crate::error::VerifyError;
use crate::grid_convergence::{half_width, limit};
use crate::runner::Runner;
use coulter::case::meshes::representative_width;
use coulter::confidence::variations::ErrorSource;
use coulter::confidence::{Confidence, OnMesh, Status, VariationResult, VariedRun, evaluate};
use coulter::history::reference::Reference;
use coulter::history::steady::SteadyWindow;
use coulter::simulation::Simulation;
use coulter::trust::Setting;

const CASE: &str = include_str!("../validation/D11_three_meshes/case.toml");
/// The meshes, with the widths of their cells over those of the finest.
const MESHES: [(&str, f64); 3] = [("coarse", 2.25), ("middle", 1.5), ("fine", 1.0)];
/// The body in the case file.
const BODY: &str = "disc";
/// Figures of the body: key, name, and how many of its units the SI unit is.
const FIGURES: [(&str, &str, f64); 3] = [
    ("drag_N", "drag F_H [N]", 1.0),
    ("sinkage_m", "sinkage [mm]", 1e3),
    ("turn_ratio", "turn ratio ω r / v", 1.0),
];

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    let variant = "three meshes";
    if !runner.wants("D11", variant)? {
        return Ok(());
    }
    let finest = runner.simulation(CASE, &[])?.case.grid.cell;
    let mut meshes = Vec::new();
    for (name, ratio) in MESHES {
        let simulation = runner.run("D11", name, CASE, &[format!("grid.cell={} m", ratio * finest)])?;
        meshes.push((name, simulation));
    }
    let wall_s = meshes.iter().map(|(_, simulation)| simulation.wall_s).sum();
    let Some((last, fine)) = meshes.pop() else { return Ok(()) };
    let confidence = together(&fine, &meshes);
    let figures = &confidence.bodies[BODY].figures;
    for ((name, simulation), result) in meshes.iter().zip(&confidence.variations) {
        let found = &result.bodies[BODY];
        put(runner, name, simulation, |key| found.get(key).copied())?;
    }
    put(runner, last, &fine, |key| figures.get(key).map(|figure| figure.value))?;
    let three = |key: &str| -> Option<[OnMesh; 3]> {
        let others = confidence.variations.iter();
        let mut all: Vec<OnMesh> = others
            .map(|result| Some(OnMesh { width: result.width_m, value: *result.bodies[BODY].get(key)? }))
            .collect::<Option<_>>()?;
        all.push(OnMesh { width: confidence.width_m, value: figures.get(key)?.value });
        all.try_into().ok()
    };
    // Of the turn ratio over 1, of the others over the value.
    let index = |key: &str| {
        three(key).map_or(f64::NAN, |three| {
            let scale = if key == "turn_ratio" { 1.0 } else { three[2].value.abs() };
            half_width(&three) / scale
        })
    };
    let extrapolated = three("sinkage_m").and_then(|three| limit(&three)).unwrap_or(f64::NAN);
    runner.put(
        "D11",
        variant,
        wall_s,
        &[
            ("grid-convergence index of the drag", index("drag_N")),
            ("grid-convergence index of the sinkage", index("sinkage_m")),
            ("grid-convergence index of the vertical force", index("vertical_N")),
            ("grid-convergence index of the turn ratio", index("turn_ratio")),
            ("sinkage, extrapolated to h = 0 [mm]", 1e3 * extrapolated),
        ],
    )
}

/// The intervals that follow from the run on the finest mesh and those on the others.
fn together(fine: &Simulation, others: &[(&str, Simulation)]) -> Confidence {
    let case = &fine.case;
    let result = |(name, simulation): &(&str, Simulation)| VariationResult {
        name: (*name).to_owned(),
        source: ErrorSource::Mesh,
        status: Status::Examined,
        width_m: representative_width(&simulation.case),
        time_factor: 1.0,
        ..VariationResult::default()
    };
    let results: Vec<VariationResult> = others.iter().map(result).collect();
    let runs: Vec<VariedRun> = results
        .iter()
        .zip(others)
        .map(|(result, (_, simulation))| VariedRun { result, history: Some(&simulation.history) })
        .collect();
    let own = (&fine.history, fine.trust(None).verdict);
    let bodies = (&Reference::all(case)[..], &Setting::of(case).bodies[..]);
    let confidence = Confidence { width_m: representative_width(case), ..Confidence::default() };
    evaluate(confidence, own, &runs, bodies, case.output.steady_fraction)
}

/// The figures of one mesh.
fn put(
    runner: &mut Runner,
    name: &str,
    simulation: &Simulation,
    figure: impl Fn(&str) -> Option<f64>,
) -> Result<(), VerifyError> {
    let mut figures: Vec<(&str, f64)> =
        FIGURES.iter().map(|(key, name, unit)| (*name, unit * figure(key).unwrap_or(f64::NAN))).collect();
    let samples = &simulation.history.bodies[0];
    let references = Reference::all(&simulation.case);
    let steady = SteadyWindow::of(samples, &references[0], simulation.steady_part()).steady;
    figures.push(("drag noise over the mean", steady.drag_noise.unwrap_or(f64::NAN)));
    let sinkage = figure("sinkage_m").unwrap_or(f64::NAN);
    figures.push(("sinkage over the height of a cell", sinkage / simulation.case.grid.cell));
    runner.put("D11", name, simulation.wall_s, &figures)
}
