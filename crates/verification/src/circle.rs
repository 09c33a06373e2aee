//! B3, B3γ: circular and square footings, on undrained soil and on sand.

use crate::error::VerifyError;
use crate::line::at_zero;
use crate::probe::mean;
use crate::row::Row;
use crate::runner::Runner;
use std::f64::consts::PI;

const CLAY: &str = include_str!("../../../validation/B3_circular_footing/case.toml");
const SAND: &str = include_str!("../../../validation/B3g_circular_footing_on_sand/case.toml");
const CIRCLE: &str = "Eason & Shield (1960), Houlsby & Wroth (1983): smooth 5.69, rough 6.05";
const SQUARE: &str = "Salgado et al. (2004): bounds for a rough square (recalled, not re-read)";
const WEIGHT: &str =
    "method of characteristics, computed for this project (see the benchmark list of the design)";
/// Diameter of the circle, side of the square in the case files [m].
const WIDTH: f64 = 1.0;
/// Unit weight [N/m³] and Young's modulus [Pa] of the sand in the case file.
const UNIT_WEIGHT: f64 = 16e3;
const YOUNG_MODULUS: f64 = 800e6;
/// Speed [m/s] of the footing on sand in the case file, reached in a ramp of 0.2 s.
const SPEED: f64 = 0.0016;
/// Undrained strength in the case file [Pa].
const STRENGTH: f64 = 1e3;

/// Text for the documentation.
pub(crate) const ABOUT: &str = "A circular footing on undrained (Tresca), weightless soil, a quarter of it modelled; friction \
    under the rough one is limited to s_u. The exact factors are 5.69 (smooth) and 6.05 (rough). A square footing is compared with \
    published bounds. Evaluated as the mean force over a penetration of 0.03 to 0.06 diameters, over the true area and s_u, without \
    a correction for embedment and heave.";
/// Text for the documentation.
pub(crate) const ABOUT_SAND: &str = "A circular footing on dry sand without cohesion, ψ = φ, a quarter of it modelled: \
    q_u = ½ γ D N_γ. Penetration w and heave act as a surcharge proportional to w: the pressure is extrapolated to w = 0 along the \
    straight line fitted over w = 3 to 6 N_γ γ D²/E, beyond the elastic rise. E is so high that the sand fails before it heaves, \
    and the speed (0.0016 D/s) so low that waves hardly matter.";

/// B3.
pub(crate) fn clay(runner: &mut Runner) -> Result<(), VerifyError> {
    let meshes: &[u32] = if runner.options.fast { &[8] } else { &[8, 16] };
    for &cells in meshes {
        for (is_rough, exact) in [(false, 5.69), (true, 6.05)] {
            let variant = format!("{} circle, D/h = {cells}", word(is_rough));
            let (factor, seconds) = on_clay(runner, &variant, cells, is_rough, false)?;
            let row = Row::info("B3", variant, "bearing capacity factor N_c", factor).took(seconds);
            // The design requires 4 % at D/h = 16.
            runner.rows.push(if cells >= 16 {
                row.within(exact, 0.04, CIRCLE)
            } else {
                row.compared_with(exact, exact, CIRCLE)
            });
        }
    }
    if !runner.options.fast {
        let variant = "rough square, B/h = 16";
        let (factor, seconds) = on_clay(runner, variant, 16, true, true)?;
        let row = Row::info("B3", variant, "bearing capacity factor N_c", factor).took(seconds);
        runner.rows.push(row.compared_with(5.52, 6.22, SQUARE));
    }
    Ok(())
}

/// Bearing capacity factor of the smooth circle with this many cells across.
pub(crate) fn smooth_on(runner: &mut Runner, cells: u32) -> Result<f64, VerifyError> {
    Ok(on_clay(runner, &format!("smooth circle, D/h = {cells}"), cells, false, false)?.0)
}

fn word(is_rough: bool) -> &'static str {
    if is_rough { "rough" } else { "smooth" }
}

/// Bearing capacity factor on undrained soil, and its wall-clock time [s].
fn on_clay(
    runner: &mut Runner,
    variant: &str,
    cells: u32,
    is_rough: bool,
    is_square: bool,
) -> Result<(f64, f64), VerifyError> {
    let mut overrides = vec![format!("grid.cell={} m", WIDTH / f64::from(cells))];
    if is_rough {
        overrides
            .extend(["body.footing.friction=rough".to_owned(), "body.footing.adhesion_factor=1".to_owned()]);
    }
    let text = if is_square {
        CLAY.replace(ROUND, &format!("shape = \"block\"\nsize = [\"{WIDTH} m\", \"{WIDTH} m\", \"0.5 m\"]\n"))
    } else {
        CLAY.to_owned()
    };
    let simulation = runner.run("B3", variant, &text, &overrides)?;
    let area = if is_square { WIDTH * WIDTH } else { 0.25 * PI * WIDTH * WIDTH };
    let range = [0.03 * WIDTH, 0.06 * WIDTH];
    let force = mean(&simulation.history.bodies[0], range, |s| s.sinkage, |s| s.vertical);
    Ok((force / (area * STRENGTH), simulation.wall_s))
}

/// The round footing in the case file.
const ROUND: &str = "shape = \"cylinder\"\naxis = \"z\"\ndiameter = \"1 m\"\nlength = \"0.5 m\"\n";

/// B3γ.
pub(crate) fn sand(runner: &mut Runner) -> Result<(), VerifyError> {
    let variants: &[(u32, u32, [f64; 2])] =
        if runner.options.fast { &[] } else { &[(20, 16, [1.271, 2.42]), (30, 16, [7.114, 15.5])] };
    for &(angle, cells, exact) in variants {
        for is_rough in [false, true] {
            let variant = format!("{}, φ = ψ = {angle}°, D/h = {cells}", word(is_rough));
            let exact = exact[usize::from(is_rough)];
            let (factor, seconds) = on_sand(runner, &variant, angle, cells, is_rough, exact)?;
            let row = Row::info("B3γ", variant, "bearing capacity factor N_γ", factor);
            runner.rows.push(row.within(exact, 0.12, WEIGHT).took(seconds));
        }
    }
    Ok(())
}

/// N_γ on sand, and its wall-clock time [s].
fn on_sand(
    runner: &mut Runner,
    variant: &str,
    angle: u32,
    cells: u32,
    is_rough: bool,
    exact: f64,
) -> Result<(f64, f64), VerifyError> {
    // Scale of the elastic settlement under the exact load, over the diameter.
    let elastic = exact * UNIT_WEIGHT * WIDTH / YOUNG_MODULUS;
    let (from, to) = (3.0 * elastic, 6.0 * elastic);
    let overrides = [
        format!("run.duration={} s", 0.1 + 1.02 * to * WIDTH / SPEED),
        format!("soil.friction_angle={angle} deg"),
        format!("soil.dilation_angle={angle} deg"),
        format!("grid.cell={} m", WIDTH / f64::from(cells)),
        format!("body.footing.friction={}", if is_rough { "rough" } else { "0" }),
    ];
    let simulation = runner.run("B3γ", variant, SAND, &overrides)?;
    let unit = 0.5 * simulation.case.soil.unit_weight * WIDTH * 0.25 * PI * WIDTH * WIDTH;
    let points = simulation.history.bodies[0].iter().map(|s| [s.sinkage / WIDTH, s.vertical / unit]);
    let read: Vec<[f64; 2]> = points.filter(|[w, _]| (from..=to).contains(w)).collect();
    Ok((at_zero(&read), simulation.wall_s))
}
