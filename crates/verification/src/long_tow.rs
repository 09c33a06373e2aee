//! D10: a tow of 50 diameters in a grid that follows the body.

use crate::error::VerifyError;
use crate::runner::Runner;
use cpu_time::ProcessTime;

const CASE: &str = include_str!("../../../validation/D10_long_tow/case.toml");
/// Diameter in the case file [m].
const DIAMETER: f64 = 0.2;
/// Stretches of the tow that are compared [d].
const STRETCHES: [[f64; 2]; 2] = [[5.0, 15.0], [40.0, 50.0]];

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    let variant = "50 d";
    if !runner.wants("D10", variant)? {
        return Ok(());
    }
    let mut simulation = runner.simulation(CASE, &[])?;
    // Displacement [d] and processor time [s] at the samples.
    let mut clock = vec![(0.0, 0.0)];
    let began = ProcessTime::now();
    while !simulation.is_done() {
        simulation.advance()?;
        let displacement = simulation.history.bodies[0].last().map_or(0.0, |s| s.displacement / DIAMETER);
        if displacement >= clock.len() as f64 {
            clock.push((displacement, began.elapsed().as_secs_f64()));
            runner.report_progress(&format!("D10: {displacement:.0} of 50 d"));
        }
    }
    runner.finish("D10", variant, &mut simulation)?;
    let samples = &simulation.history.bodies[0];
    let drag = STRETCHES.map(|[from, to]| {
        let inside = samples.iter().filter(|s| (from..to).contains(&(s.displacement / DIAMETER)));
        let (count, sum) = inside.fold((0.0, 0.0), |(n, sum), s| (n + 1.0, sum + s.drag));
        sum / count
    });
    // The least of ten diameters: whatever else runs on the machine only adds to it.
    let cost = STRETCHES.map(|[from, to]| {
        let each = clock.windows(2).filter(|pair| pair[0].0 >= from && pair[0].0 < to);
        each.map(|pair| (pair[1].1 - pair[0].1) / (pair[1].0 - pair[0].0)).fold(f64::INFINITY, f64::min)
    });
    let figures = [
        ("drag of the last 10 d over that from 5 to 15 d", drag[1] / drag[0]),
        ("least processor time of one of the last 10 d over that of one from 5 to 15 d", cost[1] / cost[0]),
        ("drag F_H [N]", drag[1]),
    ];
    runner.put("D10", variant, simulation.wall_s, &figures)
}
