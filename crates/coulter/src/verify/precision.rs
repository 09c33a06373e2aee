//! P1: single precision beside double.

use super::bench::{Bench, VerifyError, mean};
use super::row::Row;
use crate::output::record::BodySample;
use crate::simulation::Simulation;
use glam::DVec3;
use solver::precision::Precision;
use solver::start::Filling;

const FOOTING: &str = include_str!("../../../../validation/B1_strip_footing/case.toml");
const WALL: &str = include_str!("../../../../validation/B5_passive_wall/case.toml");
const TOW: &str = include_str!("../../../../cases/towed_disc.toml");
const SAND: &str = include_str!("../../../../validation/A4_soil_at_rest/case.toml");
const SAME: &str = "the same run in double precision; the limit is the design's";
const SCATTER: &str = "scatter of runs that differ by rounding";
/// Steps of the sand at rest.
const STEPS: usize = 10_000;

/// What it is about.
pub(super) const ABOUT: &str = "The same cases with `numerics.precision` double and single: the footing of B1 and the wall of B5, \
    whose forces are smooth and must agree within 1 %, and the towed disc of D3, where any two runs that differ by rounding part \
    company after a while; what that alone does to its means is told by a third run in double precision with a disc 10⁻⁹ heavier. \
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

/// The towed disc: double, double with a disc that is heavier by less than anyone could weigh, single.
fn towed(bench: &mut Bench) -> Result<(), VerifyError> {
    let double = bench.run("P1", "D3, double", TOW, &[])?;
    let other =
        bench.run("P1", "D3, double, heavier by 1e-9", TOW, &["body.disc.weight=40.00000004 N".into()])?;
    let single = bench.run("P1", "D3, single", TOW, &[SINGLE.into()])?;
    type Value = fn(&BodySample) -> f64;
    let figures: [(&str, Value); 3] =
        [("drag", |b| b.drag), ("sinkage", |b| b.sinkage), ("spin", |b| b.spin)];
    for (name, value) in figures {
        let last = |s: &Simulation| {
            let end = s.case.duration;
            // Over the last 30 % of the tow.
            mean(&s.history.bodies[0], [0.7 * end, end], |b| b.time, value)
        };
        for (variant, run) in [("D3, double, heavier by 1e-9", &other), ("D3, single", &single)] {
            let quantity = format!("mean {name} over that in double");
            let row = Row::note("P1", variant, &quantity, last(run) / last(&double)).took(run.wall_s);
            bench.rows.push(if run.wall_s == single.wall_s { row.within(1.0, 0.02, SCATTER) } else { row });
        }
    }
    Ok(())
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
