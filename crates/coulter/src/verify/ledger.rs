//! A9, C3, C4: the ledgers of every case that the suite runs: energy, soil volume, soil inside the bodies.

use super::bench::Bench;
use super::row::Row;
use super::run_ledgers::Ledgers;

const OWN: &str = "conservation; the limit is the design's";

/// What it is about.
pub(super) const ABOUT_ENERGY: &str = "External work must be kinetic + elastic + plastic + friction + viscous + hourglass \
    energy and the loss in remaps, at the end of every run of the suite; shares are of the external work. The worst run of \
    each benchmark is shown.";
/// What it is about.
pub(super) const ABOUT_VOLUME: &str = "The soil's volume at any time of every run of the suite, over that at the start; \
    elastic compression is part of the difference. Runs with dilating soil are left out: their volume is meant to grow. The mass \
    at the end of every run is told besides.";
/// What it is about.
pub(super) const ABOUT_LEAK: &str = "Soil found inside the body at the end of every run with contact, over the volume of \
    the body below the undisturbed surface.";

/// A9: the energy ledger.
pub(super) fn energy(bench: &mut Bench) {
    each(bench, "A9", "unexplained energy over external work", 0.01, |run| Some(run.energy.closure()));
    each(bench, "A9", "hourglass energy over external work", 0.02, |run| share(run, run.energy.hourglass));
    for (quantity, value) in [
        ("remap loss over external work", (|e| e.energy.remap_loss) as fn(&Ledgers) -> f64),
        ("bulk viscosity over external work", |e| e.energy.viscous),
    ] {
        worst_of_each(
            bench,
            |run| share(run, value(run)),
            |worst| Row::note("A9", worst.0, quantity, worst.1),
        );
    }
}

/// C3: the soil's volume.
pub(super) fn volume(bench: &mut Bench) {
    each(bench, "C3", "change of soil volume", 0.005, |run| (!run.dilates).then_some(run.volume_off));
    let row = |worst: (String, f64)| Row::note("C3", worst.0, "change of soil mass, crumbs counted", worst.1);
    worst_of_each(bench, |run| Some(run.mass_off), row);
}

/// C4: soil inside the bodies.
pub(super) fn leak(bench: &mut Bench) {
    each(bench, "C4", "soil inside the body over its embedded volume", 0.001, |run| {
        // A body that has no part in the ground and no soil in it tells nothing.
        let touching = run.bodies.iter().filter(|b| b.embedded_volume != 0.0 || b.leaked_volume != 0.0);
        let leaks = touching.map(|b| b.leaked_volume / b.embedded_volume);
        leaks.reduce(f64::max)
    });
}

fn share(run: &Ledgers, value: f64) -> Option<f64> {
    (run.energy.external != 0.0).then(|| value / run.energy.external.abs())
}

fn each(
    bench: &mut Bench,
    id: &'static str,
    quantity: &str,
    limit: f64,
    value: impl Fn(&Ledgers) -> Option<f64>,
) {
    worst_of_each(bench, value, |worst| Row::note(id, worst.0, quantity, worst.1).at_most(limit, OWN));
}

/// One row for each benchmark that was run: that of its worst run.
fn worst_of_each(
    bench: &mut Bench,
    value: impl Fn(&Ledgers) -> Option<f64>,
    row: impl Fn((String, f64)) -> Row,
) {
    let mut ids: Vec<&'static str> = bench.ledgers.iter().map(|run| run.id).collect();
    ids.dedup();
    for id in ids {
        let runs = bench.ledgers.iter().filter(|run| run.id == id);
        let values = runs.filter_map(|run| value(run).map(|v| (run, v)));
        // What is not a number is the worst of all.
        let size = |v: f64| if v.is_nan() { f64::INFINITY } else { v.abs() };
        let Some((run, worst)) = values.max_by(|a, b| size(a.1).total_cmp(&size(b.1))) else { continue };
        let row = row((format!("{id}, {}", run.case), worst));
        bench.rows.push(row);
    }
}
