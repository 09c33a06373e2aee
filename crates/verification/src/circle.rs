//! B3, B3γ: circular and square footings, on undrained soil and on sand.

use crate::bearing::Footing;
use crate::error::VerifyError;
use crate::probe::mean;
use crate::runner::Runner;
use std::f64::consts::PI;

const CLAY: &str = include_str!("../validation/B3_circular_footing/case.toml");
const SAND: &str = include_str!("../validation/B3g_circular_footing_on_sand/case.toml");
/// Diameter of the circle, side of the square in the case files [m].
const WIDTH: f64 = 1.0;
/// Unit weight [N/m³] and Young's modulus [Pa] of the sand in the case file.
const UNIT_WEIGHT: f64 = 16e3;
const YOUNG_MODULUS: f64 = 800e6;
/// Speed [m/s] of the footing on sand in the case file, reached in a ramp of 0.2 s.
const SPEED: f64 = 0.0016;
/// Undrained strength in the case file [Pa].
const STRENGTH: f64 = 1e3;

const CLAY_FACTOR: &str = "bearing capacity factor N_c";
const SAND_FACTOR: &str = "bearing capacity factor N_γ";

/// B3.
pub(crate) fn clay(runner: &mut Runner) -> Result<(), VerifyError> {
    for (cells, is_rough) in [(8, false), (8, true), (16, false), (16, true)] {
        let variant = format!("{} circle, D/h = {cells}", word(is_rough));
        if runner.wants("B3", &variant)? {
            let (factor, seconds) = on_clay(runner, &variant, cells, is_rough, false)?;
            runner.put("B3", &variant, seconds, &[(CLAY_FACTOR, factor)])?;
        }
    }
    let variant = "rough square, B/h = 16";
    if runner.wants("B3", variant)? {
        let (factor, seconds) = on_clay(runner, variant, 16, true, true)?;
        runner.put("B3", variant, seconds, &[(CLAY_FACTOR, factor)])?;
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
        overrides.push("body.footing.friction=rough".to_owned());
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
    for (angle, is_rough) in [(20, false), (20, true), (30, false), (30, true)] {
        let variant = format!("{}, φ = ψ = {angle}°, D/h = 16", word(is_rough));
        if runner.wants("B3γ", &variant)? {
            let expected = runner.expectation("B3γ", &variant, SAND_FACTOR)?.value()?;
            let (factor, seconds) = on_sand(runner, &variant, angle, 16, is_rough, expected)?;
            runner.put("B3γ", &variant, seconds, &[(SAND_FACTOR, factor)])?;
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
    expected: f64,
) -> Result<(f64, f64), VerifyError> {
    let footing = Footing {
        angles: [f64::from(angle).to_radians(); 2],
        compliance: UNIT_WEIGHT * WIDTH / YOUNG_MODULUS,
        expected,
    };
    let overrides = [
        format!("run.duration={} s", 0.1 + 1.02 * footing.stretch()[1] * WIDTH / SPEED),
        format!("soil.friction_angle={angle} deg"),
        format!("soil.dilation_angle={angle} deg"),
        format!("grid.cell={} m", WIDTH / f64::from(cells)),
        format!("body.footing.friction={}", if is_rough { "rough" } else { "0" }),
    ];
    let simulation = runner.run("B3γ", variant, SAND, &overrides)?;
    let unit = 0.5 * simulation.case.soil.unit_weight * WIDTH * 0.25 * PI * WIDTH * WIDTH;
    let points = simulation.history.bodies[0].iter().map(|s| [s.sinkage / WIDTH, s.vertical / unit]);
    Ok((footing.weight_factor(points)?, simulation.wall_s))
}
