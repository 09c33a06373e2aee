//! A11: the position of a body within its cell and its direction relative to the grid must not matter.

use crate::error::VerifyError;
use crate::probe::mean;
use crate::runner::Runner;
use coulter::history::BodySample;
use coulter::simulation::Simulation;

const BLOCK: &str = include_str!("../validation/A11_position_and_direction/block.toml");
const CYLINDER: &str = include_str!("../validation/A11_position_and_direction/cylinder.toml");
const ROTATED_BLOCK: &str = include_str!("../validation/A11_position_and_direction/rotated_block.toml");
/// Cell of the case files [m].
const CELL: f64 = 0.0625;
/// Strength times width of the case files [N/m].
const UNIT: f64 = 1e3;
const SPEED: f64 = 0.02;
const DRAG: &str = "drag over s_u d";

/// Directions in which the block is moved, and by how many cells.
const POSITIONS: [(&str, &[f64]); 3] =
    [("x", &[0.0, 0.5]), ("x", &[0.0, 0.25, 0.5, 0.75]), ("z", &[0.0, 0.25, 0.5, 0.75])];

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    runner.part("A11", "positions", positions)?;
    for (part, body, text) in
        [("directions", "cylinder", CYLINDER), ("directions of a block", "block", ROTATED_BLOCK)]
    {
        if runner.wants("A11", &pushed(body, 0.0))? {
            runner.part("A11", part, |runner| directions(runner, body, text))?;
        }
    }
    Ok(())
}

fn pushed(body: &str, angle: f64) -> String {
    format!("{body} pushed at {angle}°")
}

fn positions(runner: &mut Runner) -> Result<(), VerifyError> {
    for (axis, offsets) in POSITIONS {
        let all = offsets.iter().map(f64::to_string).collect::<Vec<_>>().join(", ");
        let all = format!("block at {all} h in {axis}");
        if !runner.wants("A11", &all)? {
            continue;
        }
        let (mut factors, mut seconds) = (Vec::new(), 0.0);
        for offset in offsets {
            let distance = offset * CELL;
            let change = match axis {
                "x" => format!("body.block.x={distance} m"),
                _ => format!("body.block.sinkage={} m", 3.5 - distance),
            };
            let variant = format!("block moved by {offset} h in {axis}");
            let simulation = runner.run("A11", &variant, BLOCK, &[change])?;
            let drag = force(&simulation, [0.05, 0.1], 1.0, |s| s.drag);
            runner.put("A11", &variant, simulation.wall_s, &[(DRAG, drag)])?;
            factors.push(drag);
            seconds += simulation.wall_s;
        }
        let mean = factors.iter().sum::<f64>() / factors.len() as f64;
        let scatter = factors.iter().fold(0.0, |most: f64, f| {
            let error = (f / mean - 1.0).abs();
            if error > most || error.is_nan() { error } else { most }
        });
        runner.put("A11", &all, seconds, &[("largest deviation from the mean drag", scatter)])?;
    }
    Ok(())
}

/// Drag over s_u d of the block on a mesh of this many cells across it.
pub(crate) fn block_on(runner: &mut Runner, cells: u32) -> Result<f64, VerifyError> {
    let cell = format!("grid.cell={} m", 1.0 / f64::from(cells));
    let simulation = runner.run("A11", &format!("d/h = {cells}"), BLOCK, &[cell])?;
    Ok(force(&simulation, [0.05, 0.1], 1.0, |s| s.drag))
}

/// Pushes a body at several angles to the grid; a block is rotated with its direction of motion.
fn directions(runner: &mut Runner, body: &str, text: &str) -> Result<(), VerifyError> {
    let mut straight = f64::NAN;
    for angle in [0.0_f64, 15.0, 30.0, 45.0] {
        let (sin, cos) = angle.to_radians().sin_cos();
        let mut changes = vec![
            format!("body.{body}.forward={{ speed = '{} m/s', ramp = '0.6 s' }}", SPEED * cos),
            format!("body.{body}.heave={{ speed = '{} m/s', ramp = '0.6 s' }}", SPEED * sin),
        ];
        if body == "block" {
            // A positive angle tilts the face from x downwards.
            changes.push(format!("body.block.pitch={} deg", -angle));
        }
        let variant = pushed(body, angle);
        let simulation = runner.run("A11", &variant, text, &changes)?;
        // The drag is against x, the vertical force along z.
        let along = force(&simulation, [0.1, 0.2], cos, |s| s.drag * cos - s.vertical * sin);
        let across = force(&simulation, [0.1, 0.2], cos, |s| s.drag * sin + s.vertical * cos);
        if angle == 0.0 {
            straight = along;
        }
        let mut figures = vec![(DRAG, along)];
        if angle != 0.0 {
            figures.push(("deviation of the drag from that at 0°", along / straight - 1.0));
        }
        figures.push(("transverse force over the drag", across / along));
        runner.put("A11", &variant, simulation.wall_s, &figures)?;
    }
    Ok(())
}

/// Mean of a force over a range of displacements along the motion, whose component along x is `cos`, over
/// strength and width.
fn force(simulation: &Simulation, range: [f64; 2], cos: f64, value: impl Fn(&BodySample) -> f64) -> f64 {
    mean(&simulation.history.bodies[0], range, |s| s.displacement / cos, value) / UNIT
}
