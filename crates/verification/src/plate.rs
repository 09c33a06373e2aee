//! B7: a smooth inclined plate pushed along its normal.

use crate::error::VerifyError;
use crate::line::at_zero;
use crate::runner::Runner;
use coulter::history::BodySample;

const CASE: &str = include_str!("../validation/B7_inclined_plate/case.toml");
/// Length of the face below the ground in the case file [m].
const LENGTH: f64 = 1.0;
/// Speed along the normal of the plate in the case file [m/s].
const SPEED: f64 = 0.02;
/// Length of the face above the ground [m].
const ABOVE: f64 = 0.5;

/// Friction angle and inclination of the face [°].
const PLATES: [(u32, u32); 3] = [(30, 60), (30, 40), (35, 30)];

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    for (angle, inclination) in PLATES {
        for dilation in [0, angle] {
            let variant = format!("φ = {angle}°, α = {inclination}°, ψ = {dilation}°, L/h = 16");
            if runner.wants("B7", &variant)? {
                let (coefficient, seconds) =
                    coefficient(runner, &variant, [angle, inclination, dilation], 16)?;
                runner.put("B7", &variant, seconds, &[("normal coefficient K_n", coefficient)])?;
            }
        }
    }
    Ok(())
}

/// K_n of the first plate with ψ = φ on a mesh of this many cells along the face.
pub(crate) fn first_on(runner: &mut Runner, cells: u32) -> Result<f64, VerifyError> {
    let (angle, inclination) = PLATES[0];
    let variant = format!("φ = ψ = {angle}°, α = {inclination}°, L/h = {cells}");
    Ok(coefficient(runner, &variant, [angle, inclination, angle], cells)?.0)
}

/// K_n for angles of friction, of the face and of dilation [°], and its wall-clock time [s].
fn coefficient(
    runner: &mut Runner,
    variant: &str,
    [angle, inclination, dilation]: [u32; 3],
    cells: u32,
) -> Result<(f64, f64), VerifyError> {
    let tilt = 90 - inclination;
    let (sin, cos) = f64::from(tilt).to_radians().sin_cos();
    // The lower face rises from the toe, at a depth of L cos: it must reach the ground.
    let thickness = (LENGTH * cos / sin).max(LENGTH) + 0.25 * LENGTH;
    let x = -LENGTH * sin - 0.5 * thickness * cos + 0.5 * (LENGTH + ABOVE) * sin;
    let motion = |speed: f64| format!("{{ speed = '{speed} m/s', ramp = '0.2 s' }}");
    let overrides = [
        format!("soil.friction_angle={angle} deg"),
        format!("soil.dilation_angle={dilation} deg"),
        format!("grid.cell={} m", LENGTH / f64::from(cells)),
        format!("body.plate.size=['{thickness} m', '{} m']", LENGTH + ABOVE),
        format!("body.plate.pitch={tilt} deg"),
        format!("body.plate.sinkage={} m", LENGTH * cos),
        format!("body.plate.x={x} m"),
        format!("body.plate.forward={}", motion(SPEED * cos)),
        format!("body.plate.heave={}", motion(-SPEED * sin)),
    ];
    let simulation = runner.run("B7", variant, CASE, &overrides)?;
    let half_weight = 0.5 * simulation.case.soil.unit_weight;
    let along_normal = |displacement: f64| displacement / cos;
    let value = |s: &BodySample| {
        let length = LENGTH + along_normal(s.displacement) * sin / cos;
        // The force on the plate along its normal, which points forward and down.
        (s.drag * cos + s.vertical * sin) / (half_weight * length * length)
    };
    let points =
        simulation.history.bodies[0].iter().map(|s| [along_normal(s.displacement) / LENGTH, value(s)]);
    let read: Vec<[f64; 2]> = points.filter(|[u, _]| (0.005..=0.025).contains(u)).collect();
    Ok((at_zero(&read), simulation.wall_s))
}
