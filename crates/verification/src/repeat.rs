//! A8: the same case gives the same bits, and its mirror image the mirrored result.

use crate::error::VerifyError;
use crate::probe::mean;
use crate::runner::Runner;
use coulter::history::BodySample;
use coulter::output::checkpoint::Checkpoint;
use coulter::simulation::Simulation;
use solver::state::State;

const CASE: &str = include_str!("../validation/A8_repeatability/case.toml");
/// Distance of the disc from the middle in the mirrored pair, a fraction of a cell [m].
const OFFSET: f64 = 7e-3;

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    let one = runner.run("A8", "1 thread", CASE, &["numerics.threads=1".into()])?;
    for threads in [2, 3] {
        let variant = format!("{threads} threads");
        let other = runner.run("A8", &variant, CASE, &[format!("numerics.threads={threads}")])?;
        let figures = [("values that differ from the run on 1 thread", differences(&one, &other))];
        runner.put("A8", &variant, other.wall_s, &figures)?;
    }
    let resumed = resumed(runner)?;
    let figures = [("values that differ from the uninterrupted run", differences(&one, &resumed))];
    runner.put("A8", "stopped half way", resumed.wall_s, &figures)?;
    mirrored(runner, "disc in the middle, 0.2 s", &one, &one)?;
    for (name, duration) in [("50 ms", 0.05), ("0.2 s", 0.2)] {
        let aside = |y: f64| [format!("body.disc.y={y} m"), format!("run.duration={duration} s")];
        let left = runner.run("A8", &format!("disc moved to +y, {name}"), CASE, &aside(OFFSET))?;
        let right = runner.run("A8", &format!("disc moved to −y, {name}"), CASE, &aside(-OFFSET))?;
        mirrored(runner, &format!("disc moved to +y and −y, {name}"), &left, &right)?;
    }
    crate::moving::run(runner)
}

/// The case, stopped half way and resumed from the checkpoint on disk.
fn resumed(runner: &mut Runner) -> Result<Simulation, VerifyError> {
    let mut first = runner.simulation(CASE, &[])?;
    while first.state.time < 0.5 * first.case.duration {
        first.advance()?;
    }
    let folder = std::env::temp_dir().join(format!("coulter-verify-{}", std::process::id()));
    first.checkpoint().write(&folder)?;
    let read = Checkpoint::read(&folder, &first.model.grid);
    // A folder that cannot be removed does no harm.
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
    let balance = usize::from(a.state.energy_balance != b.state.energy_balance)
        + usize::from(a.state.step != b.state.step);
    (cells + bodies + contacts + lines + energy + lengths + balance) as f64
}

fn fields(state: &State) -> impl Iterator<Item = &Vec<f64>> {
    let soil = &state.soil;
    let nodes = &state.nodes;
    [&soil.fraction, &soil.mass, &nodes.mass]
        .into_iter()
        .chain(&soil.stress)
        .chain(&soil.history)
        .chain(&nodes.velocity)
        .chain(&nodes.displacement)
}

/// Rows on how far `b` deviates from the mirror image of `a` about the middle of the box.
fn mirrored(runner: &mut Runner, variant: &str, a: &Simulation, b: &Simulation) -> Result<(), VerifyError> {
    let speed = 0.2;
    let grid = &a.model.grid;
    let [nx, ny, nz] = grid.cells();
    let (mut fraction, mut velocity) = (0.0_f64, 0.0_f64);
    let worse = |most: f64, error: f64| if error > most || error.is_nan() { error } else { most };
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
                    let error = a.state.soil.fraction[cell] - b.state.soil.fraction[image];
                    fraction = worse(fraction, error.abs());
                }
            }
        }
    }
    let seconds = a.wall_s + b.wall_s;
    let drag = [a, b].map(|s| force(s, |b| b.drag));
    let lateral = force(a, |b| b.lateral) + force(b, |b| b.lateral);
    let figures = [
        ("deviation of the volume fraction from its mirror image", fraction),
        ("deviation of the velocity from its mirror image", velocity),
        ("deviation of the mean drag from that of the mirror image", (drag[0] / drag[1] - 1.0).abs()),
        ("sum of mean lateral forces over the drag", lateral.abs() / drag[0]),
    ];
    runner.put("A8", variant, seconds, &figures)
}

/// Mean of a force over the second half of a run [N].
fn force(simulation: &Simulation, value: impl Fn(&BodySample) -> f64) -> f64 {
    let duration = simulation.case.duration;
    mean(&simulation.history.bodies[0], [0.5 * duration, duration], |b| b.time, value)
}
