//! P1: single precision compared with double.

use crate::error::VerifyError;
use crate::probe::mean;
use crate::runner::Runner;
use coulter::history::BodySample;
use coulter::simulation::Simulation;
use glam::DVec3;
use solver::initial::{self, Filling};
use solver::step::step;
use solver::workspace::Workspace;

const FOOTING: &str = include_str!("../validation/B1_strip_footing/case.toml");
const WALL: &str = include_str!("../validation/B5_passive_wall/case.toml");
const TOW: &str = include_str!("../cases/light_disc.toml");
const SAND: &str = include_str!("../validation/A4_soil_at_rest/case.toml");
/// Runs of the tow in each precision.
const RUNS: usize = 4;
/// Time steps of the sand at rest.
const STEPS: usize = 10_000;

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    let mesh = |cells: u32| format!("grid.cell={} m", 1.0 / f64::from(cells));
    for cells in [8, 16] {
        let force = |s: &Simulation| mean(&s.history.bodies[0], [0.03, 0.06], |b| b.sinkage, |b| b.vertical);
        let overrides = [mesh(cells), "grid.fit=false".to_owned()];
        smooth(runner, &format!("B1, B/h = {cells}"), FOOTING, &overrides, &force)?;
    }
    for cells in [8, 16] {
        let force = |s: &Simulation| mean(&s.history.bodies[0], [0.05, 0.1], |b| b.displacement, |b| b.drag);
        smooth(runner, &format!("B5, H/h = {cells}"), WALL, &[mesh(cells)], &force)?;
    }
    at_rest(runner)?;
    towed(runner)
}

const SINGLE: &str = "numerics.precision=single";

/// A case in both precisions, with a force that must be the same.
fn smooth(
    runner: &mut Runner,
    name: &str,
    case: &str,
    overrides: &[String],
    force: &dyn Fn(&Simulation) -> f64,
) -> Result<(), VerifyError> {
    if !runner.wants("P1", name)? {
        return Ok(());
    }
    let double = runner.run("P1", &format!("{name}, double"), case, overrides)?;
    let mut in_single = overrides.to_vec();
    in_single.push(SINGLE.into());
    let single = runner.run("P1", &format!("{name}, single"), case, &in_single)?;
    let ratio = force(&single) / force(&double);
    runner.put("P1", name, double.wall_s + single.wall_s, &[("force, single over double", ratio)])
}

/// The towed disc, in which rounding errors grow: several runs in each precision, with weights that differ by
/// less than could be measured.
fn towed(runner: &mut Runner) -> Result<(), VerifyError> {
    let variants = ["drag", "sinkage"].map(|name| format!("D3, d/h = 10, {RUNS} runs each, {name}"));
    if !runner.wants("P1", &variants[0])? {
        return Ok(());
    }
    let mut means = [[[0.0; RUNS]; 2]; 2];
    let mut seconds = 0.0;
    for (precision, means) in ["double", "single"].into_iter().zip(&mut means) {
        for n in 0..RUNS {
            let overrides = [
                "grid.cell=20 mm".to_owned(),
                format!("body.disc.weight={} N", 40.0 * (1.0 + 1e-5 * n as f64)),
                format!("numerics.precision={precision}"),
            ];
            let run = runner.run("P1", &format!("D3, d/h = 10, {precision}, {n}"), TOW, &overrides)?;
            let end = run.case.duration;
            // Over the last 30 % of the tow.
            let last = |value: fn(&BodySample) -> f64| {
                mean(&run.history.bodies[0], [0.7 * end, end], |b| b.time, value)
            };
            (means[0][n], means[1][n]) = (last(|b| b.drag), last(|b| b.sinkage));
            seconds += run.wall_s;
        }
    }
    let [double, single] = means;
    for ((variant, double), single) in variants.iter().zip(double).zip(single) {
        let ((double, scatter), (single, other)) = (mean_and_scatter(double), mean_and_scatter(single));
        let error = ((scatter * scatter + other * other) / RUNS as f64).sqrt();
        let figures = [
            ("scatter in double over the mean", scatter / double),
            ("scatter in single over the mean", other / single),
            ("mean, single over double", single / double),
            ("difference of the means over its standard error", (single - double).abs() / error),
        ];
        runner.put("P1", variant, seconds, &figures)?;
    }
    Ok(())
}

/// Mean and standard deviation.
fn mean_and_scatter(values: [f64; RUNS]) -> (f64, f64) {
    let mean = values.iter().sum::<f64>() / RUNS as f64;
    let squares: f64 = values.iter().map(|v| (v - mean).powi(2)).sum();
    (mean, (squares / (RUNS - 1) as f64).sqrt())
}

/// The residual motion of sand at rest.
fn at_rest(runner: &mut Runner) -> Result<(), VerifyError> {
    let model = runner.simulation(SAND, &[])?.model;
    let surface = 0.5 * model.grid.finest();
    let filling = Filling::between(DVec3::splat(-1e9), DVec3::new(1e9, 1e9, surface));
    let mut state = initial::at_rest::<f32>(&model, &filling);
    let mut workspace = Workspace::new(&model, &mut state, 1);
    let mut speed = 0.0_f32;
    for _ in 0..runner.lasting(STEPS) {
        step(&model, &mut state, &mut workspace)?;
        speed = state.nodes.velocity.iter().flatten().fold(speed, |most, v| most.max(v.abs()));
    }
    let speed = f64::from(speed) / model.wave_speed();
    runner.put("P1", "A4, surface at 0.5 h, single", 0.0, &[("largest speed over wave speed", speed)])
}
