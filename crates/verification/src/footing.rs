//! B1, B2, B9: a strip footing on weightless undrained soil: smooth, rough, and nearly incompressible soil.

use crate::error::VerifyError;
use crate::probe::mean;
use crate::row::Row;
use crate::runner::Runner;
use std::f64::consts::PI;

const CASE: &str = include_str!("../../../validation/B1_strip_footing/case.toml");
const ROUGH: &str = include_str!("../../../validation/B2_rough_strip_footing/case.toml");
const SOURCE: &str = "Prandtl (1920): exact, 2 + π";
/// Width of the footing in the case file [m].
const WIDTH: f64 = 1.0;
/// Undrained strength in the case file [Pa].
const STRENGTH: f64 = 1e3;

/// Text for the documentation.
pub(crate) const ABOUT: &str = "A smooth rigid strip is pushed into undrained (Tresca), weightless soil. The exact \
    bearing capacity is (2 + π) s_u. Evaluated as the mean force over a penetration of 0.03 to 0.06 widths, over the \
    true width, the width of the slab and s_u; the contact points are inset by half a cell from the edges, as by default.";

/// Text for the documentation.
pub(crate) const ABOUT_ROUGH: &str = "The footing of B1 with a rough base: friction up to s_u, whatever the pressure. \
    On weightless soil the exact bearing capacity is that of the smooth strip, (2 + π) s_u. Evaluated as in B1.";
/// Text for the documentation.
pub(crate) const ABOUT_LOCKING: &str = "The footing of B1 at B/h = 16 on soil that is less and less compressible: a method that \
    locks would become too stiff. Evaluated as in B1; each factor must stay within 1 % of that with ν = 0.3.";

/// B2.
pub(crate) fn rough(runner: &mut Runner) -> Result<(), VerifyError> {
    let meshes: &[u32] = if runner.options.fast { &[8, 16] } else { &[8, 16, 32] };
    for &cells in meshes {
        let variant = format!("B/h = {cells}");
        let strip = Strip { id: "B2", case: ROUGH, cells, offset: 0.0, poisson_ratio: 0.3 };
        let (factor, seconds) = strip.bearing(runner, &variant)?;
        let row = Row::info("B2", variant, "bearing capacity factor N_c", factor);
        runner.rows.push(row.within(2.0 + PI, 0.04, SOURCE).took(seconds));
    }
    Ok(())
}

/// B9.
pub(crate) fn locking(runner: &mut Runner) -> Result<(), VerifyError> {
    let ratios: &[f64] = if runner.options.fast { &[0.3, 0.45] } else { &[0.3, 0.45, 0.49] };
    let mut first = None;
    for &poisson_ratio in ratios {
        let variant = format!("B/h = 16, ν = {poisson_ratio}");
        let strip = Strip { id: "B9", case: CASE, cells: 16, offset: 0.0, poisson_ratio };
        let (factor, seconds) = strip.bearing(runner, &variant)?;
        let row = Row::info("B9", variant, "bearing capacity factor N_c", factor).took(seconds);
        let expected = *first.get_or_insert(factor);
        let is_first = expected == factor;
        runner.rows.push(if is_first { row } else { row.within(expected, 0.01, "the same with ν = 0.3") });
    }
    Ok(())
}

/// Bearing capacity factor of B1 with this many cells across.
pub(crate) fn smooth_on(runner: &mut Runner, cells: u32) -> Result<f64, VerifyError> {
    Ok(bearing(runner, &format!("B/h = {cells}"), cells, 0.0)?.0)
}

/// The same for B2.
pub(crate) fn rough_on(runner: &mut Runner, cells: u32) -> Result<f64, VerifyError> {
    let strip = Strip { id: "B2", case: ROUGH, cells, offset: 0.0, poisson_ratio: 0.3 };
    Ok(strip.bearing(runner, &format!("B/h = {cells}"))?.0)
}

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    let exact = 2.0 + PI;
    let meshes: &[(u32, f64)] =
        if runner.options.fast { &[(8, 0.03), (16, 0.02)] } else { &[(8, 0.03), (16, 0.02), (32, 0.02)] };
    for &(cells, tolerance) in meshes {
        let variant = format!("B/h = {cells}");
        let (factor, seconds) = bearing(runner, &variant, cells, 0.0)?;
        let row = Row::info("B1", variant, "bearing capacity factor N_c", factor);
        runner.rows.push(row.within(exact, tolerance, SOURCE).took(seconds));
    }
    if runner.options.fast {
        return Ok(());
    }
    offsets(runner, exact)
}

/// Mean and scatter over the position of the edges within a cell.
fn offsets(runner: &mut Runner, exact: f64) -> Result<(), VerifyError> {
    let (mut factors, mut total) = (Vec::new(), 0.0);
    for offset in [0.0, 0.25, 0.5, 0.75] {
        let variant = format!("B/h = 16, edges at {offset} h");
        let (factor, seconds) = bearing(runner, &variant, 16, offset)?;
        runner.rows.push(Row::info("B1", variant, "bearing capacity factor N_c", factor).took(seconds));
        factors.push(factor);
        total += seconds;
    }
    let mean = factors.iter().sum::<f64>() / factors.len() as f64;
    let scatter = factors.iter().map(|f| (f - mean).abs() / mean).fold(0.0, f64::max);
    let variant = "B/h = 16, edges at 0, ¼, ½, ¾ h";
    let row = Row::info("B1", variant, "mean N_c", mean).within(exact, 0.02, SOURCE);
    runner.rows.push(row.took(total));
    let row = Row::info("B1", variant, "largest deviation from the mean", scatter);
    runner.rows.push(row.at_most(0.02, "design requirement: ±2 %").took(total));
    Ok(())
}

/// Bearing capacity factor with both edges moved outwards by `offset` cells, and its wall-clock time [s].
fn bearing(runner: &mut Runner, variant: &str, cells: u32, offset: f64) -> Result<(f64, f64), VerifyError> {
    Strip { id: "B1", case: CASE, cells, offset, poisson_ratio: 0.3 }.bearing(runner, variant)
}

/// A strip footing.
struct Strip {
    id: &'static str,
    case: &'static str,
    /// Cells across it.
    cells: u32,
    /// Cells by which both edges are moved outwards.
    offset: f64,
    poisson_ratio: f64,
}

impl Strip {
    /// Bearing capacity factor, and its wall-clock time [s].
    fn bearing(&self, runner: &mut Runner, variant: &str) -> Result<(f64, f64), VerifyError> {
        let cell = WIDTH / f64::from(self.cells);
        let width = WIDTH + 2.0 * self.offset * cell;
        let overrides = [
            format!("grid.cell={cell} m"),
            format!("body.footing.size=['{width} m', '0.5 m']"),
            format!("soil.poisson_ratio={}", self.poisson_ratio),
            // The grid must not follow the edges: the effect of their position within a cell is what is studied.
            "grid.fit=false".to_owned(),
        ];
        let simulation = runner.run(self.id, variant, self.case, &overrides)?;
        let slab = simulation.case.domain.high.y - simulation.case.domain.low.y;
        let range = [0.03 * WIDTH, 0.06 * WIDTH];
        let force = mean(&simulation.history.bodies[0], range, |s| s.sinkage, |s| s.vertical);
        Ok((force / (width * slab * STRENGTH), simulation.wall_s))
    }
}
