//! D10: a tow of 50 diameters in a grid that follows the body.

use crate::error::VerifyError;
use crate::runner::Runner;
use coulter::simulation::Simulation;
use cpu_time::ProcessTime;

const CASE: &str = include_str!("../validation/D10_long_tow/case.toml");
/// Diameter in the case file [m].
const DIAMETER: f64 = 0.2;
/// Stretches of the tow whose drags are compared [d].
const STRETCHES: [[f64; 2]; 2] = [[5.0, 15.0], [40.0, 50.0]];
/// Where the run is whose speed is compared [d].
const EARLY: f64 = 5.0;
/// Number of pairs of timings, and steps in each.
const PAIRS: [u32; 2] = [25, 200];

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    let variant = "50 d";
    if !runner.wants("D10", variant)? {
        return Ok(());
    }
    let mut late = runner.simulation(CASE, &[])?;
    runner.finish("D10", variant, &mut late)?;
    let samples = &late.history.bodies[0];
    let drag = STRETCHES.map(|[from, to]| {
        let inside = samples.iter().filter(|s| (from..to).contains(&(s.displacement / DIAMETER)));
        let (count, sum) = inside.fold((0.0, 0.0), |(n, sum), s| (n + 1.0, sum + s.drag));
        sum / count
    });
    let mut early = runner.simulation(CASE, &[])?;
    while !early.is_done() && travelled(&early) < EARLY {
        early.advance()?;
    }
    let figures = [
        ("drag of the last 10 d over that from 5 to 15 d", drag[1] / drag[0]),
        ("processor time of a step after 50 d over that after 5 d", slowdown(&mut late, &mut early)?),
        ("drag F_H [N]", drag[1]),
    ];
    runner.put("D10", variant, late.wall_s, &figures)
}

/// Displacement of the disc [d].
fn travelled(simulation: &Simulation) -> f64 {
    simulation.history.bodies[0].last().map_or(0.0, |sample| sample.displacement / DIAMETER)
}

/// Median ratio of the processor times of both runs, taken in turns: the speed of the machine changes over
/// minutes.
fn slowdown(late: &mut Simulation, early: &mut Simulation) -> Result<f64, VerifyError> {
    let [pairs, steps] = PAIRS;
    let time = |simulation: &mut Simulation| {
        let began = ProcessTime::now();
        simulation.steps(steps).map(|()| began.elapsed().as_secs_f64())
    };
    let mut ratios = Vec::new();
    for _ in 0..if late.history.bodies[0].len() > 1 { pairs } else { 0 } {
        let (after, before) = (time(late)?, time(early)?);
        ratios.push(after / before);
    }
    ratios.sort_by(f64::total_cmp);
    Ok(ratios.get(ratios.len() / 2).copied().unwrap_or(f64::NAN))
}
