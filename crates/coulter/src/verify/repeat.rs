//! A8: the same case gives the same bits, and its mirror image the mirrored result.

use super::bench::Bench;
use super::error::VerifyError;
use super::probe::mean;
use super::row::Row;
use crate::history::BodySample;
use crate::output::checkpoint::Checkpoint;
use crate::simulation::Simulation;
use solver::state::State;

const CASE: &str = include_str!("../../../../validation/A8_repeatability/case.toml");
const BITS: &str = "same input, same bits";
const MIRROR: &str = "the equations know no left and right";
/// By how much the disc stands off the middle in the mirrored pair, a part of a cell [m].
const OFFSET: f64 = 7e-3;

/// What it is about.
pub(super) const ABOUT: &str = "A small towed disc, the whole of it. Run on 1, 2 and 3 threads, and run straight or with \
    a checkpoint half way that is written to disk, read and resumed: the number of values in the state and the history that \
    differ must be 0. Its field is compared with its own mirror image in y, and with that of a disc moved to the other side, \
    after 50 ms and at the end: the largest difference in volume fraction and in velocity (over the tow speed), anywhere. \
    And a strip is pressed into a bank of clay, once at rest and once with everything moving at 0.2 m/s over the grid.";

pub(super) fn run(bench: &mut Bench) -> Result<(), VerifyError> {
    let one = bench.run("A8", "1 thread", CASE, &["numerics.threads=1".into()])?;
    for threads in [2, 3] {
        let variant = format!("{threads} threads");
        let other = bench.run("A8", &variant, CASE, &[format!("numerics.threads={threads}")])?;
        let row = Row::note("A8", variant, "values that differ from 1 thread", differences(&one, &other));
        bench.rows.push(row.at_most(0.0, BITS).took(other.wall_s));
    }
    let resumed = resumed(bench)?;
    let row = Row::note(
        "A8",
        "stopped half way",
        "values that differ from the straight run",
        differences(&one, &resumed),
    );
    bench.rows.push(row.at_most(0.0, BITS).took(resumed.wall_s));
    mirrored(bench, "disc in the middle, 0.2 s", &one, &one);
    for (name, duration) in [("50 ms", 0.05), ("0.2 s", 0.2)] {
        let aside = |place: f64| [format!("body.disc.y={place} m"), format!("run.duration={duration} s")];
        let left = bench.run("A8", &format!("disc moved to +y, {name}"), CASE, &aside(OFFSET))?;
        let right = bench.run("A8", &format!("disc moved to −y, {name}"), CASE, &aside(-OFFSET))?;
        mirrored(bench, &format!("disc moved to +y and −y, {name}"), &left, &right);
    }
    if bench.wish.fast { Ok(()) } else { super::moving::run(bench) }
}

/// The case, stopped half way and resumed from the checkpoint on disk.
fn resumed(bench: &mut Bench) -> Result<Simulation, VerifyError> {
    let mut first = bench.simulation(CASE, &[])?;
    while first.state.time < 0.5 * first.case.duration {
        first.advance()?;
    }
    let folder = std::env::temp_dir().join(format!("coulter-verify-{}", std::process::id()));
    first.checkpoint().write(&folder)?;
    let read = Checkpoint::read(&folder);
    // A folder that stays behind does no harm.
    let _ = std::fs::remove_dir_all(&folder);
    let mut second = Simulation::resume(&first.case, read?.0, first.wall_s);
    while !second.is_done() {
        second.advance()?;
    }
    Ok(second)
}

/// Number of values of state and history that are not the same to the bit.
fn differences(a: &Simulation, b: &Simulation) -> f64 {
    let fields = fields(&a.state).zip(fields(&b.state));
    let cells: usize =
        fields.map(|(a, b)| a.iter().zip(b).filter(|(a, b)| a.to_bits() != b.to_bits()).count()).sum();
    let bodies = a.state.bodies.iter().zip(&b.state.bodies).filter(|(a, b)| a != b).count();
    let contacts = a.state.contacts.iter().zip(&b.state.contacts).filter(|(a, b)| a != b).count();
    let samples = a.history.bodies.iter().flatten().zip(b.history.bodies.iter().flatten());
    let lines = samples.filter(|(a, b)| a != b).count();
    let energy = a.history.energy.iter().zip(&b.history.energy).filter(|(a, b)| a != b).count();
    let lengths = a.history.energy.len().abs_diff(b.history.energy.len());
    let ledger = usize::from(a.state.ledger != b.state.ledger) + usize::from(a.state.step != b.state.step);
    (cells + bodies + contacts + lines + energy + lengths + ledger) as f64
}

fn fields(state: &State) -> impl Iterator<Item = &Vec<f64>> {
    let soil = &state.soil;
    let nodes = &state.nodes;
    [&soil.fraction, &soil.mass, &soil.plastic_strain, &soil.gap_strain, &nodes.mass]
        .into_iter()
        .chain(&soil.stress)
        .chain(&nodes.velocity)
        .chain(&nodes.displacement)
}

/// Rows on how far `b` is from the mirror image of `a` in the middle of the box.
fn mirrored(bench: &mut Bench, variant: &str, a: &Simulation, b: &Simulation) {
    let speed = 0.2;
    let grid = &a.model.grid;
    let [nx, ny, nz] = grid.cells();
    let (mut fraction, mut velocity) = (0.0_f64, 0.0_f64);
    let worse = |most: f64, off: f64| if off > most || off.is_nan() { off } else { most };
    for k in 0..=nz {
        for j in 0..=ny {
            for i in 0..=nx {
                let (node, image) = (grid.index(i, j, k), grid.index(i, ny - j, k));
                for (axis, sign) in [(0, 1.0), (1, -1.0), (2, 1.0)] {
                    let v = |s: &State, n: usize| s.nodes.velocity[axis][n];
                    velocity = worse(velocity, (v(&a.state, node) - sign * v(&b.state, image)).abs() / speed);
                }
                if i < nx && j < ny && k < nz {
                    let (cell, image) = (grid.index(i, j, k), grid.index(i, ny - 1 - j, k));
                    let off = a.state.soil.fraction[cell] - b.state.soil.fraction[image];
                    fraction = worse(fraction, off.abs());
                }
            }
        }
    }
    let seconds = a.wall_s + b.wall_s;
    let note = |quantity, value| Row::note("A8", variant, quantity, value).took(seconds);
    let drag = [a, b].map(|s| force(s, |b| b.drag));
    let lateral = force(a, |b| b.lateral) + force(b, |b| b.lateral);
    bench.rows.extend([
        note("volume fraction off its mirror image", fraction).at_most(1e-12, MIRROR),
        note("velocity off its mirror image", velocity).at_most(1e-12, MIRROR),
        note("mean drag off that of the mirror image", (drag[0] / drag[1] - 1.0).abs()),
        note("sum of mean lateral forces over the drag", lateral.abs() / drag[0]),
    ]);
}

/// Mean of a force over the second half of a run [N].
fn force(simulation: &Simulation, value: impl Fn(&BodySample) -> f64) -> f64 {
    let duration = simulation.case.duration;
    mean(&simulation.history.bodies[0], [0.5 * duration, duration], |b| b.time, value)
}
