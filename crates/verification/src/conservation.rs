//! A9, C3, C4: what every run of the suite must conserve: energy and soil volume; and soil inside the bodies.

use crate::error::VerifyError;
use crate::run_balances::RunBalances;
use crate::runner::Runner;

/// A9: the energy balance.
pub(crate) fn energy(runner: &mut Runner) -> Result<(), VerifyError> {
    let total = |run: &RunBalances| Some(run.energy.closure());
    worst_of_each(runner, "A9", "unexplained energy over external work", total)?;
    for (quantity, value) in [
        ("hourglass energy over external work", (|e| e.energy.hourglass) as fn(&RunBalances) -> f64),
        ("remap loss over external work", |e| e.energy.remap_loss),
        ("bulk viscosity over external work", |e| e.energy.viscous),
    ] {
        worst_of_each(runner, "A9", quantity, |run| fraction(run, value(run)))?;
    }
    Ok(())
}

/// C3: the soil's volume.
pub(crate) fn volume(runner: &mut Runner) -> Result<(), VerifyError> {
    let volume = |run: &RunBalances| (!run.dilates).then_some(run.volume_error);
    worst_of_each(runner, "C3", "change of soil volume", volume)?;
    worst_of_each(runner, "C3", "portion of the mass in overdense soil", |run| Some(run.overdense))?;
    worst_of_each(runner, "C3", "change of soil mass, debris included", |run| Some(run.mass_error))
}

/// C4: soil inside the bodies.
pub(crate) fn leak(runner: &mut Runner) -> Result<(), VerifyError> {
    worst_of_each(runner, "C4", "soil inside the body over its embedded volume", |run| {
        // A body above the ground, without soil inside it, says nothing.
        let touching = run.bodies.iter().filter(|b| b.embedded_volume != 0.0 || b.leaked_volume != 0.0);
        let leaks = touching.map(|b| b.leaked_volume / b.embedded_volume);
        leaks.reduce(f64::max)
    })
}

fn fraction(run: &RunBalances, value: f64) -> Option<f64> {
    (run.energy.external != 0.0).then(|| value / run.energy.external.abs())
}

/// One row for each benchmark that was run: that of its worst run.
fn worst_of_each(
    runner: &mut Runner,
    id: &'static str,
    quantity: &str,
    value: impl Fn(&RunBalances) -> Option<f64>,
) -> Result<(), VerifyError> {
    let mut benchmarks: Vec<&'static str> = runner.balances.iter().map(|run| run.id).collect();
    benchmarks.dedup();
    for benchmark in benchmarks {
        let runs = runner.balances.iter().filter(|run| run.id == benchmark);
        let values = runs.filter_map(|run| value(run).map(|v| (run, v)));
        // What is not a number is the worst of all.
        let size = |v: f64| if v.is_nan() { f64::INFINITY } else { v.abs() };
        let Some((run, worst)) = values.max_by(|a, b| size(a.1).total_cmp(&size(b.1))) else { continue };
        let case = format!("{benchmark}, {}", run.case);
        runner.put(id, &case, 0.0, &[(quantity, worst)])?;
    }
    Ok(())
}
