//! A9, C3, C4: what every run of the suite must conserve: energy and soil volume; and soil inside the bodies.

use crate::row::Row;
use crate::run_balances::RunBalances;
use crate::runner::Runner;

const OWN: &str = "conservation; limit of the design";

/// Text for the documentation.
pub(crate) const ABOUT_ENERGY: &str = "External work must equal the sum of kinetic, elastic, plastic, friction, viscous and \
    hourglass energy and of the loss in remaps, at the end of every run of the suite. Figures are fractions of the external work; \
    the worst run of each benchmark is shown.";
/// Text for the documentation.
pub(crate) const ABOUT_VOLUME: &str = "Largest relative change of the soil's volume at any time of every run of the suite; \
    elastic compression is part of it. Runs with dilating soil are left out, because their volume is expected to grow. The change \
    of mass at the end of every run is given for information.";
/// Text for the documentation.
pub(crate) const ABOUT_LEAK: &str = "Soil found inside the body at the end of every run with contact, over the volume of \
    the body below the undisturbed surface.";

/// A9: the energy balance.
pub(crate) fn energy(runner: &mut Runner) {
    each(runner, "A9", "unexplained energy over external work", 0.01, |run| Some(run.energy.closure()));
    each(runner, "A9", "hourglass energy over external work", 0.02, |run| {
        fraction(run, run.energy.hourglass)
    });
    for (quantity, value) in [
        ("remap loss over external work", (|e| e.energy.remap_loss) as fn(&RunBalances) -> f64),
        ("bulk viscosity over external work", |e| e.energy.viscous),
    ] {
        worst_of_each(
            runner,
            |run| fraction(run, value(run)),
            |worst| Row::info("A9", worst.0, quantity, worst.1),
        );
    }
}

/// C3: the soil's volume.
pub(crate) fn volume(runner: &mut Runner) {
    each(runner, "C3", "change of soil volume", 0.005, |run| (!run.dilates).then_some(run.volume_error));
    let row =
        |worst: (String, f64)| Row::info("C3", worst.0, "change of soil mass, debris included", worst.1);
    worst_of_each(runner, |run| Some(run.mass_error), row);
}

/// C4: soil inside the bodies.
pub(crate) fn leak(runner: &mut Runner) {
    each(runner, "C4", "soil inside the body over its embedded volume", 0.001, |run| {
        // A body above the ground, without soil inside it, says nothing.
        let touching = run.bodies.iter().filter(|b| b.embedded_volume != 0.0 || b.leaked_volume != 0.0);
        let leaks = touching.map(|b| b.leaked_volume / b.embedded_volume);
        leaks.reduce(f64::max)
    });
}

fn fraction(run: &RunBalances, value: f64) -> Option<f64> {
    (run.energy.external != 0.0).then(|| value / run.energy.external.abs())
}

fn each(
    runner: &mut Runner,
    id: &'static str,
    quantity: &str,
    limit: f64,
    value: impl Fn(&RunBalances) -> Option<f64>,
) {
    worst_of_each(runner, value, |worst| Row::info(id, worst.0, quantity, worst.1).at_most(limit, OWN));
}

/// One row for each benchmark that was run: that of its worst run.
fn worst_of_each(
    runner: &mut Runner,
    value: impl Fn(&RunBalances) -> Option<f64>,
    row: impl Fn((String, f64)) -> Row,
) {
    let mut ids: Vec<&'static str> = runner.balances.iter().map(|run| run.id).collect();
    ids.dedup();
    for id in ids {
        let runs = runner.balances.iter().filter(|run| run.id == id);
        let values = runs.filter_map(|run| value(run).map(|v| (run, v)));
        // What is not a number is the worst of all.
        let size = |v: f64| if v.is_nan() { f64::INFINITY } else { v.abs() };
        let Some((run, worst)) = values.max_by(|a, b| size(a.1).total_cmp(&size(b.1))) else { continue };
        let row = row((format!("{id}, {}", run.case), worst));
        runner.rows.push(row);
    }
}
