//! B6: a rough vertical wall pushed into sand.

use crate::error::VerifyError;
use crate::probe::mean;
use crate::runner::Runner;

const CASE: &str = include_str!("../validation/B6_rough_passive_wall/case.toml");
/// Depth of the wall in the case file [m].
const HEIGHT: f64 = 1.0;

/// Friction angle [°], and ratio of the wall friction angle to it.
const WALLS: [(u32, f64); 2] = [(30, 0.5), (35, 2.0 / 3.0)];

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    for (angle, ratio) in WALLS {
        let delta = ratio * f64::from(angle).to_radians();
        for dilation in [0, angle] {
            let variant = format!("φ = {angle}°, δ = {:.1}°, ψ = {dilation}°, H/h = 16", delta.to_degrees());
            if runner.wants("B6", &variant)? {
                let (coefficient, seconds) = coefficient(runner, &variant, angle, delta, dilation, 16)?;
                runner.put("B6", &variant, seconds, &[("K_n = K_p cos δ", coefficient)])?;
            }
        }
    }
    Ok(())
}

/// K_n of the first wall with ψ = φ on a mesh of this many cells over its depth.
pub(crate) fn first_on(runner: &mut Runner, cells: u32) -> Result<f64, VerifyError> {
    let (angle, ratio) = WALLS[0];
    let delta = ratio * f64::from(angle).to_radians();
    Ok(coefficient(runner, &format!("φ = ψ = {angle}°, H/h = {cells}"), angle, delta, angle, cells)?.0)
}

/// K_n, and its wall-clock time [s].
fn coefficient(
    runner: &mut Runner,
    variant: &str,
    angle: u32,
    delta: f64,
    dilation: u32,
    cells: u32,
) -> Result<(f64, f64), VerifyError> {
    let overrides = [
        format!("soil.friction_angle={angle} deg"),
        format!("soil.dilation_angle={dilation} deg"),
        format!("body.wall.friction={}", delta.tan()),
        format!("grid.cell={} m", HEIGHT / f64::from(cells)),
    ];
    let simulation = runner.run("B6", variant, CASE, &overrides)?;
    let unit = 0.5 * simulation.case.soil.unit_weight * HEIGHT * HEIGHT;
    let range = [0.02 * HEIGHT, 0.05 * HEIGHT];
    let value = mean(&simulation.history.bodies[0], range, |s| s.displacement, |s| s.drag_normal / unit);
    Ok((value, simulation.wall_s))
}
