//! P1: single precision beside double.

use super::bench::Bench;
use super::error::VerifyError;
use super::probe::mean;
use super::row::Row;
use crate::history::BodySample;
use crate::simulation::Simulation;
use glam::DVec3;
use solver::precision::Precision;
use solver::start::Filling;

const FOOTING: &str = include_str!("../../../../validation/B1_strip_footing/case.toml");
const WALL: &str = include_str!("../../../../validation/B5_passive_wall/case.toml");
const TOW: &str = include_str!("../../../../cases/towed_disc.toml");
const SAND: &str = include_str!("../../../../validation/A4_soil_at_rest/case.toml");
const SAME: &str = "the same run in double precision; the limit is the design's";
/// Runs of the tow in either precision.
const RUNS: usize = 4;
/// Steps of the sand at rest.
const STEPS: usize = 10_000;

/// What it is about.
pub(super) const ABOUT: &str = "The same cases with `numerics.precision` double and single: the footing of B1 and the wall of B5, \
    whose forces are smooth and must agree within 1 %, and the towed disc of D3 at d/h = 10, where any two \
    runs that differ by rounding part company: four runs each, with discs heavier by parts of 10⁻⁵ from run to run, tell how \
    far single runs scatter and whether the means differ by more. \
    And the sand of A4, which in single precision does not rest to the last digit: its largest speed over that of its pressure \
    waves.";

pub(super) fn run(bench: &mut Bench) -> Result<(), VerifyError> {
    let cells = if bench.wish.fast { 8 } else { 16 };
    let footing = [format!("grid.cell={} m", 1.0 / f64::from(cells)), "grid.fit=false".to_owned()];
    let force = |s: &Simulation| mean(&s.history.bodies[0], [0.03, 0.06], |b| b.sinkage, |b| b.vertical);
    smooth(bench, &format!("B1, B/h = {cells}"), (FOOTING, &footing), &force)?;
    let wall = [format!("grid.cell={} m", 1.0 / f64::from(cells))];
    let force = |s: &Simulation| mean(&s.history.bodies[0], [0.05, 0.1], |b| b.displacement, |b| b.drag);
    smooth(bench, &format!("B5, H/h = {cells}"), (WALL, &wall), &force)?;
    at_rest(bench)?;
    if bench.wish.fast { Ok(()) } else { towed(bench) }
}

const SINGLE: &str = "numerics.precision=single";

/// A case in both precisions, with a force that must be the same.
fn smooth(
    bench: &mut Bench,
    name: &str,
    (case, overrides): (&str, &[String]),
    force: &dyn Fn(&Simulation) -> f64,
) -> Result<(), VerifyError> {
    let double = bench.run("P1", &format!("{name}, double"), case, overrides)?;
    let mut narrow = overrides.to_vec();
    narrow.push(SINGLE.into());
    let single = bench.run("P1", &format!("{name}, single"), case, &narrow)?;
    let row = Row::note("P1", name, "force, single over double", force(&single) / force(&double));
    bench.rows.push(row.within(1.0, 0.01, SAME).took(double.wall_s + single.wall_s));
    Ok(())
}

/// The towed disc, whose course no two runs share: as many runs in either precision, each with a disc that is heavier than the
/// last by less than anyone could weigh.
fn towed(bench: &mut Bench) -> Result<(), VerifyError> {
    let mut means = [[[0.0; RUNS]; 2]; 2];
    let mut seconds = 0.0;
    for (precision, means) in ["double", "single"].into_iter().zip(&mut means) {
        for n in 0..RUNS {
            let overrides = [
                "grid.cell=20 mm".to_owned(),
                format!("body.disc.weight={} N", 40.0 * (1.0 + 1e-5 * n as f64)),
                format!("numerics.precision={precision}"),
            ];
            let run = bench.run("P1", &format!("D3, d/h = 10, {precision}, {n}"), TOW, &overrides)?;
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
    for (name, double, single) in [("drag", double[0], single[0]), ("sinkage", double[1], single[1])] {
        let ((double, spread), (single, other)) = (spread(double), spread(single));
        let variant = format!("D3, d/h = 10, {RUNS} runs each, {name}");
        let error = ((spread * spread + other * other) / RUNS as f64).sqrt();
        let note = |quantity, value| Row::note("P1", variant.as_str(), quantity, value).took(seconds);
        bench.rows.extend([
            note("scatter in double over the mean", spread / double),
            note("scatter in single over the mean", other / single),
            note("mean, single over double", single / double),
            note("difference of the means over its standard error", (single - double).abs() / error),
        ]);
    }
    Ok(())
}

/// Mean and standard deviation.
fn spread(values: [f64; RUNS]) -> (f64, f64) {
    let mean = values.iter().sum::<f64>() / RUNS as f64;
    let squares: f64 = values.iter().map(|v| (v - mean).powi(2)).sum();
    (mean, (squares / (RUNS - 1) as f64).sqrt())
}

/// What is left of rest.
fn at_rest(bench: &mut Bench) -> Result<(), VerifyError> {
    let model = bench.simulation(SAND, &[])?.model;
    let surface = 0.5 * model.grid.finest();
    let filling = Filling::between(DVec3::splat(-1e9), DVec3::new(1e9, 1e9, surface));
    let mut state = f32::start_under(&model, &filling, 0.0);
    let mut workspace = f32::workspace(&model, &state, 1);
    let mut speed = 0.0_f32;
    for _ in 0..STEPS {
        f32::step(&model, &mut state, &mut workspace)?;
        speed = state.nodes.velocity.iter().flatten().fold(speed, |most, v| most.max(v.abs()));
    }
    let speed = f64::from(speed) / model.wave_speed();
    bench.rows.push(Row::note("P1", "A4, surface at 0.5 h, single", "largest speed over wave speed", speed));
    Ok(())
}
