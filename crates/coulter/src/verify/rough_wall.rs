//! B6: a rough vertical wall pushed into sand.

use super::bench::Bench;
use super::error::VerifyError;
use super::probe::mean;
use super::row::Row;
use analytic::bearing::davis_friction_angle;
use analytic::earth_pressure::{Face, sokolovskii};
use std::f64::consts::FRAC_PI_2;

const CASE: &str = include_str!("../../../../validation/B6_rough_passive_wall/case.toml");
const EXACT: &str = "Sokolovskii (1965), as the crate `analytic` computes it";
/// Depth of the wall in the case file [m].
const HEIGHT: f64 = 1.0;

/// What it is about.
pub(super) const ABOUT: &str = "A vertical wall with friction tan δ is pushed into deep sand; its toe is inside the soil, \
    because the slip surface dips below it. K_n = 2 P_n / (γ H²), P_n being the part of the thrust that is normal to the wall: \
    K_p cos δ. With ψ = φ it must be Sokolovskii's, with ψ = 0 between his at Davis' φ* and at φ. Read over a displacement of \
    0.02 to 0.05 H, over the undisturbed height.";

/// Friction angle [°] and wall friction over it.
const WALLS: [(u32, f64); 2] = [(30, 0.5), (35, 2.0 / 3.0)];

pub(super) fn run(bench: &mut Bench) -> Result<(), VerifyError> {
    let walls = if bench.wish.fast { &WALLS[..1] } else { &WALLS[..] };
    for &(angle, share) in walls {
        for is_associated in [false, true] {
            if !(bench.wish.fast && is_associated) {
                push(bench, angle, share, is_associated)?;
            }
        }
    }
    Ok(())
}

/// Normal coefficient of a vertical wall; angles in radians.
fn exact(friction_angle: f64, wall_friction: f64) -> f64 {
    let wall_friction = wall_friction.min(friction_angle);
    let face = Face { friction_angle, wall_friction, surface: FRAC_PI_2, backfill: 0.0 };
    sokolovskii(&face).map_or(f64::NAN, |field| field.coefficient)
}

fn push(bench: &mut Bench, angle: u32, share: f64, is_associated: bool) -> Result<(), VerifyError> {
    let phi = f64::from(angle).to_radians();
    let delta = share * phi;
    let dilation = if is_associated { angle } else { 0 };
    let variant = format!("φ = {angle}°, δ = {:.1}°, ψ = {dilation}°, H/h = 16", delta.to_degrees());
    let (coefficient, seconds) = coefficient(bench, &variant, angle, delta, dilation, 16)?;
    let row = Row::note("B6", variant, "K_n = K_p cos δ", coefficient).took(seconds);
    let limit = exact(phi, delta);
    bench.rows.push(if is_associated {
        row.within(limit, 0.08, EXACT)
    } else {
        let operative = davis_friction_angle(phi, 0.0).unwrap_or(f64::NAN);
        row.between(exact(operative, delta), limit, 0.08, EXACT)
    });
    Ok(())
}

/// K_n of the first wall with ψ = φ on a mesh of so many cells over its depth.
pub(super) fn first_on(bench: &mut Bench, cells: u32) -> Result<f64, VerifyError> {
    let (angle, share) = WALLS[0];
    let delta = share * f64::from(angle).to_radians();
    Ok(coefficient(bench, &format!("φ = ψ = {angle}°, H/h = {cells}"), angle, delta, angle, cells)?.0)
}

/// K_n, and the seconds it took.
fn coefficient(
    bench: &mut Bench,
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
    let simulation = bench.run("B6", variant, CASE, &overrides)?;
    let slab = simulation.case.domain.high.y - simulation.case.domain.low.y;
    let unit = 0.5 * simulation.case.soil.unit_weight * HEIGHT * HEIGHT * slab;
    let range = [0.02 * HEIGHT, 0.05 * HEIGHT];
    let value = mean(&simulation.history.bodies[0], range, |s| s.displacement, |s| s.drag_normal / unit);
    Ok((value, simulation.wall_s))
}
