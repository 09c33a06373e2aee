//! C5: sand falls across gaps, a shelf collapses, a slot fills.

use crate::error::VerifyError;
use crate::runner::Runner;
use coulter::simulation::Simulation;
use std::ops::Range;

const CASE: &str = include_str!("../validation/C5_falls_and_slots/case.toml");
/// Cell of the case file [m], and acceleration of gravity [m/s²].
const CELL: f64 = 0.006;
const GRAVITY: f64 = 9.81;
/// Volume fraction from which on soil rests on what is below.
const RESTS: f64 = 0.9;
/// Layers of cells of the ground, of the bed that falls, and of the lower third of the slot.
const GROUND: usize = 10;
const BED: usize = 5;
const SLOT_THIRD: usize = 3;
/// Columns of the slot.
const SLOT: Range<usize> = 14..18;
/// First column and layers of the void below the shelf.
const SHELF: usize = 16;
const SHELF_VOID: Range<usize> = GROUND..GROUND + 4;

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    for (ground, onto) in [(GROUND, "sand"), (0, "the floor")] {
        for gap in [1, 2, 3, 5] {
            let variant = format!("{gap} {} on to {onto}", if gap == 1 { "cell" } else { "cells" });
            if runner.wants("C5", &variant)? {
                runner.part("C5", &variant, |runner| fall(runner, &variant, [ground, gap]))?;
            }
        }
    }
    runner.part("C5", "shelf", |runner| {
        let is_void = |i: usize, k: usize| i >= SHELF && SHELF_VOID.contains(&k);
        let simulation = filled(runner, "shelf", |i, k| k < GROUND + 10 && !is_void(i, k))?;
        let columns = simulation.model.grid.cells()[0];
        let void: f64 = (0..columns).map(|i| void_below(&simulation, i)).sum();
        let at_start = ((columns - SHELF) * SHELF_VOID.len()) as f64;
        let figures = [("void left below the shelf over that at the start", void / at_start)];
        runner.put("C5", "shelf", simulation.wall_s, &figures)
    })?;
    runner.part("C5", "slot", |runner| {
        let is_filled = |i: usize, k: usize| k < if SLOT.contains(&i) { GROUND } else { GROUND + 8 };
        let simulation = filled(runner, "slot", is_filled)?;
        let third = GROUND..GROUND + SLOT_THIRD;
        let cells = SLOT.flat_map(|i| third.clone().map(move |k| [i, k]));
        let soil: f64 = cells.map(|cell| fraction(&simulation, cell)).sum();
        let figures = [(
            "soil in the lower third of the slot over its volume",
            soil / (SLOT.len() * SLOT_THIRD) as f64,
        )];
        runner.put("C5", "slot", simulation.wall_s, &figures)
    })
}

/// The box, filled where `is_filled` says so of a column and a layer, at the end of its run.
fn filled(
    runner: &mut Runner,
    variant: &str,
    is_filled: impl Fn(usize, usize) -> bool,
) -> Result<Simulation, VerifyError> {
    let mut simulation = at_start(runner, &[], is_filled)?;
    runner.finish("C5", variant, &mut simulation)?;
    Ok(simulation)
}

fn at_start(
    runner: &Runner,
    overrides: &[String],
    is_filled: impl Fn(usize, usize) -> bool,
) -> Result<Simulation, VerifyError> {
    let case = runner.simulation(CASE, overrides)?.case;
    Ok(Simulation::filled(&case, |grid| {
        let mut fraction = vec![0.0; grid.entries];
        let [columns, _, layers] = grid.cells();
        for (i, k) in (0..columns).flat_map(|i| (0..layers).map(move |k| (i, k))) {
            fraction[grid.index(i, 0, k)] = if is_filled(i, k) { 1.0 } else { 0.0 };
        }
        fraction
    }))
}

/// A bed of sand falls across a gap of so many cells on to a ground of so many layers.
fn fall(runner: &mut Runner, variant: &str, [ground, gap]: [usize; 2]) -> Result<(), VerifyError> {
    let free = (2.0 * gap as f64 * CELL / GRAVITY).sqrt();
    let bed = ground + gap..ground + gap + BED;
    let duration = format!("run.duration={} s", 2.0 * free);
    let mut simulation = at_start(runner, &[duration], |_, k| k < ground || bed.contains(&k))?;
    let (mut largest, mut landing) = (0.0, f64::NAN);
    runner.finish_watched("C5", variant, &mut simulation, |now| {
        let downwards = -momentum(now);
        if downwards > largest {
            (largest, landing) = (downwards, now.state.time);
        }
    })?;
    let figures = [
        ("time of landing over that of free fall", landing / free),
        ("void below the sand at twice that time [cells]", void_below(&simulation, 0)),
    ];
    runner.put("C5", variant, simulation.wall_s, &figures)
}

/// Momentum of all soil along z [kg m/s].
fn momentum(simulation: &Simulation) -> f64 {
    let nodes = &simulation.state.nodes;
    nodes.mass.iter().zip(&nodes.velocity[2]).map(|(mass, v)| mass * v).sum()
}

fn fraction(simulation: &Simulation, [i, k]: [usize; 2]) -> f64 {
    simulation.state.soil.fraction[simulation.model.grid.index(i, 0, k)]
}

/// What is empty in a column below its highest cell in which soil rests [cells].
fn void_below(simulation: &Simulation, i: usize) -> f64 {
    let layers = simulation.model.grid.cells()[2];
    let top = (0..layers).rev().find(|k| fraction(simulation, [i, *k]) >= RESTS).unwrap_or(0);
    (0..top).map(|k| 1.0 - fraction(simulation, [i, k])).sum()
}
