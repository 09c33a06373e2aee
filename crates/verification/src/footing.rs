//! B1, B2, B9, B10, B11: a strip footing on weightless undrained soil: smooth, rough, nearly incompressible
//! soil, strength that grows with depth, and two layers.

use crate::error::VerifyError;
use crate::probe::mean;
use crate::runner::Runner;

const CASE: &str = include_str!("../validation/B1_strip_footing/case.toml");
const ROUGH: &str = include_str!("../validation/B2_rough_strip_footing/case.toml");
const LAYERS: &str = include_str!("../validation/B11_two_layers/case.toml");
const GROWING: &str = include_str!("../validation/B10_strength_with_depth/case.toml");
/// Width of the footing in the case file [m].
const WIDTH: f64 = 1.0;
/// Undrained strength in the case file [Pa].
const STRENGTH: f64 = 1e3;

/// Cells across the footing.
const MESHES: [u32; 3] = [8, 16, 32];
const FACTOR: &str = "bearing capacity factor N_c";

/// B2.
pub(crate) fn rough(runner: &mut Runner) -> Result<(), VerifyError> {
    for cells in MESHES {
        let variant = format!("B/h = {cells}");
        if runner.wants("B2", &variant)? {
            let strip = Strip { id: "B2", case: ROUGH, ..Strip::smooth(cells) };
            let (factor, seconds) = strip.bearing(runner, &variant)?;
            runner.put("B2", &variant, seconds, &[(FACTOR, factor)])?;
        }
    }
    Ok(())
}

/// B9.
pub(crate) fn locking(runner: &mut Runner) -> Result<(), VerifyError> {
    for poisson_ratio in [0.3, 0.45, 0.49] {
        let variant = format!("B/h = 16, ν = {poisson_ratio}");
        if runner.wants("B9", &variant)? {
            let strip = Strip { id: "B9", poisson_ratio, ..Strip::smooth(16) };
            let (factor, seconds) = strip.bearing(runner, &variant)?;
            runner.put("B9", &variant, seconds, &[(FACTOR, factor)])?;
        }
    }
    Ok(())
}

/// B10.
pub(crate) fn growing_strength(runner: &mut Runner) -> Result<(), VerifyError> {
    for growth in [1.0, 4.0] {
        for cells in MESHES {
            let variant = format!("k B/s_u0 = {growth}, B/h = {cells}");
            if runner.wants("B10", &variant)? {
                let below = vec![format!("soil.strength_gradient={} Pa/m", growth * STRENGTH / WIDTH)];
                let strip = Strip { id: "B10", case: GROWING, below, ..Strip::smooth(cells) };
                let (factor, seconds) = strip.bearing(runner, &variant)?;
                runner.put("B10", &variant, seconds, &[("F/(B s_u0)", factor)])?;
            }
        }
    }
    Ok(())
}

/// B11.
pub(crate) fn two_layers(runner: &mut Runner) -> Result<(), VerifyError> {
    for [ratio, depth] in [[2.0, 0.25], [0.5, 0.5]] {
        for cells in MESHES {
            let variant = format!("s_u2/s_u1 = {ratio}, H/B = {depth}, B/h = {cells}");
            if runner.wants("B11", &variant)? {
                let below = vec![
                    format!("layer.lower.shear_strength={} Pa", ratio * STRENGTH),
                    format!("layer.lower.top={} m", depth * WIDTH),
                ];
                let strip = Strip { id: "B11", case: LAYERS, below, ..Strip::smooth(cells) };
                let (factor, seconds) = strip.bearing(runner, &variant)?;
                runner.put("B11", &variant, seconds, &[("F/(B s_u1)", factor)])?;
            }
        }
    }
    Ok(())
}

/// Bearing capacity factor of B1 with this many cells across.
pub(crate) fn smooth_on(runner: &mut Runner, cells: u32) -> Result<f64, VerifyError> {
    Ok(bearing(runner, &format!("B/h = {cells}"), cells, 0.0)?.0)
}

/// N_c of the rough strip footing B2 on a mesh of so many cells over its breadth.
pub(crate) fn rough_on(runner: &mut Runner, cells: u32) -> Result<f64, VerifyError> {
    let strip = Strip { id: "B2", case: ROUGH, ..Strip::smooth(cells) };
    Ok(strip.bearing(runner, &format!("B/h = {cells}"))?.0)
}

/// B1.
pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    for cells in MESHES {
        let variant = format!("B/h = {cells}");
        if runner.wants("B1", &variant)? {
            let (factor, seconds) = bearing(runner, &variant, cells, 0.0)?;
            runner.put("B1", &variant, seconds, &[(FACTOR, factor)])?;
        }
    }
    for cells in [8, 16] {
        let variant = format!("B/h = {cells}, flat cells 3:1");
        if runner.wants("B1", &variant)? {
            let strip = Strip { flatness: 3, ..Strip::smooth(cells) };
            let (factor, seconds) = strip.bearing(runner, &variant)?;
            runner.put("B1", &variant, seconds, &[(FACTOR, factor)])?;
        }
    }
    offsets(runner)
}

/// Mean and scatter over the position of the edges within a cell.
fn offsets(runner: &mut Runner) -> Result<(), VerifyError> {
    let all = "B/h = 16, edges at 0, ¼, ½, ¾ h";
    if !runner.wants("B1", all)? {
        return Ok(());
    }
    let (mut factors, mut total) = (Vec::new(), 0.0);
    for offset in [0.0, 0.25, 0.5, 0.75] {
        let variant = format!("B/h = 16, edges at {offset} h");
        let (factor, seconds) = bearing(runner, &variant, 16, offset)?;
        runner.put("B1", &variant, seconds, &[(FACTOR, factor)])?;
        factors.push(factor);
        total += seconds;
    }
    let mean = factors.iter().sum::<f64>() / factors.len() as f64;
    let scatter = factors.iter().map(|f| (f - mean).abs() / mean).fold(0.0, f64::max);
    runner.put("B1", all, total, &[("mean N_c", mean), ("largest deviation from the mean", scatter)])
}

/// Bearing capacity factor with both edges moved outwards by `offset` cells, and its wall-clock time [s].
fn bearing(runner: &mut Runner, variant: &str, cells: u32, offset: f64) -> Result<(f64, f64), VerifyError> {
    Strip { offset, ..Strip::smooth(cells) }.bearing(runner, variant)
}

/// A strip footing.
struct Strip {
    id: &'static str,
    case: &'static str,
    /// Cells across the footing.
    cells: u32,
    /// Cells by which both edges are moved outwards.
    offset: f64,
    poisson_ratio: f64,
    /// Cell width along x over that along z.
    flatness: u32,
    /// Overrides for the strength of the soil below; without any it is that at the surface.
    below: Vec<String>,
}

impl Strip {
    /// The footing of B1.
    fn smooth(cells: u32) -> Self {
        Self { id: "B1", case: CASE, cells, offset: 0.0, poisson_ratio: 0.3, flatness: 1, below: Vec::new() }
    }

    /// Bearing capacity factor, and its wall-clock time [s].
    fn bearing(&self, runner: &mut Runner, variant: &str) -> Result<(f64, f64), VerifyError> {
        let cell = WIDTH / f64::from(self.cells);
        let width = WIDTH + 2.0 * self.offset * cell;
        let mut overrides = vec![
            format!("grid.cell={} m", cell / f64::from(self.flatness)),
            format!("grid.aspect=[{}, 1, 1]", self.flatness),
            format!("body.footing.size=['{width} m', '0.5 m']"),
            format!("soil.poisson_ratio={}", self.poisson_ratio),
            // The grid must not follow the edges: the effect of their position within a cell is what is
            // studied.
            "grid.fit=false".to_owned(),
        ];
        overrides.extend(self.below.iter().cloned());
        let simulation = runner.run(self.id, variant, self.case, &overrides)?;
        // Where strength changes with depth it is read early: with every hundredth of a width the footing
        // finds another one.
        let range = if self.below.is_empty() { [0.03, 0.06] } else { [0.005, 0.01] }.map(|part| part * WIDTH);
        let force = mean(&simulation.history.bodies[0], range, |s| s.sinkage, |s| s.vertical);
        Ok((force / (width * STRENGTH), simulation.wall_s))
    }
}
