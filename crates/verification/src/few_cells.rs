//! C6: bodies on few cells, beside the same on finer ones.

use crate::error::VerifyError;
use crate::probe::mean;
use crate::runner::Runner;
use coulter::history::BodySample;
use coulter::simulation::Simulation;

const CONE: &str = include_str!("../validation/C6_bodies_on_few_cells/cone.toml");
const BLOCK: &str = include_str!("../validation/C6_bodies_on_few_cells/block.toml");
const DISC: &str = include_str!("../validation/C6_bodies_on_few_cells/disc.toml");
/// Portion of the run at its end over which forces are averaged.
const STEADY: f64 = 0.3;

/// A force of a sample, and what it is called.
type Force = (&'static str, fn(&BodySample) -> f64);
const DRAG: Force = ("drag over that on the finest cells", |sample| sample.drag);
const VERTICAL: Force = ("vertical force over that on the finest cells", |sample| sample.vertical);

/// A case on some grids: variants and cells [mm], the finest first.
type Grids = &'static [(&'static str, f64)];

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    let cases: [(&str, Grids, &[Force]); 3] = [
        (
            CONE,
            &[("cone, 13.4 cells", 6.1), ("cone, 7.8 cells", 10.4), ("cone, 4.6 cells", 17.8)],
            &[VERTICAL],
        ),
        (BLOCK, &[("block, 16 cells", 6.25), ("block, 8 cells", 12.5)], &[DRAG, VERTICAL]),
        (DISC, &[("disc, 4 cells", 3.125), ("disc, 2 cells", 6.25), ("disc, 1 cell", 12.5)], &[DRAG]),
    ];
    for (case, grids, forces) in cases {
        compare(runner, case, grids, forces)?;
    }
    Ok(())
}

/// Runs a case on its grids; the forces on all but the first are told over those on the first.
fn compare(runner: &mut Runner, case: &str, grids: Grids, forces: &[Force]) -> Result<(), VerifyError> {
    let mut finest: Option<Vec<f64>> = None;
    for (variant, cell) in grids {
        if !runner.wants("C6", variant)? {
            return Ok(());
        }
        let simulation = runner.run("C6", variant, case, &[format!("grid.cell={cell} mm")])?;
        let found: Vec<f64> = forces.iter().map(|(_, force)| steady(&simulation, *force)).collect();
        let mut figures = vec![("mean force [N]", found[0])];
        if let Some(finest) = &finest {
            let ratios = forces.iter().zip(&found).zip(finest);
            figures.extend(ratios.map(|(((name, _), own), finest)| (*name, own / finest)));
        }
        runner.put("C6", variant, simulation.wall_s, &figures)?;
        finest.get_or_insert(found);
    }
    Ok(())
}

fn steady(simulation: &Simulation, force: fn(&BodySample) -> f64) -> f64 {
    let range = [(1.0 - STEADY) * simulation.case.duration, f64::INFINITY];
    mean(&simulation.history.bodies[0], range, |sample| sample.time, force)
}
