//! What a case will cost: cells, memory, time step, number of steps.

use super::resolved::{Case, Grid, Ground, Precision};
use serde::Serialize;
use std::f64::consts::FRAC_PI_4;

/// Memory per cell, all fields and scratch together, in double precision [bytes]; chosen on the safe side.
const BYTES_PER_CELL: f64 = 400.0;
/// Share of it that single precision takes; what does not halve is on the safe side too.
const SINGLE: f64 = 0.55;

/// What a case will cost.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Estimate {
    /// Cells of the grid.
    pub cells: f64,
    /// Cells with soil at the start, whole or partly.
    pub filled_cells: f64,
    /// Memory [bytes].
    pub memory_bytes: f64,
    /// The smallest cell width [m].
    pub smallest_cell_m: f64,
    /// Speed of pressure waves in the soil [m/s].
    pub wave_speed_m_per_s: f64,
    /// Time step [s].
    pub time_step_s: f64,
    /// Number of time steps.
    pub steps: f64,
}

/// What `case` will cost.
#[must_use]
pub fn estimate(case: &Case) -> Estimate {
    let (young, nu) = (case.soil.young_modulus, case.soil.poisson_ratio);
    let bulk = young / (3.0 * (1.0 - 2.0 * nu));
    let shear = young / (2.0 * (1.0 + nu));
    let wave_speed = ((bulk + 4.0 / 3.0 * shear) / case.soil.density).sqrt();
    let widths = case.grid.faces.iter().flat_map(|f| f.windows(2).map(|w| w[1] - w[0]));
    let smallest = widths.fold(f64::INFINITY, f64::min);
    let time_step = case.numerics.courant * smallest / wave_speed;
    Estimate {
        cells: cells(&case.grid),
        filled_cells: filled_cells(case),
        memory_bytes: memory(&case.grid, case.numerics.precision),
        smallest_cell_m: smallest,
        wave_speed_m_per_s: wave_speed,
        time_step_s: time_step,
        steps: (case.duration / time_step).ceil(),
    }
}

/// Number of cells, as a float that cannot overflow.
pub(super) fn cells(grid: &Grid) -> f64 {
    grid.faces.iter().map(|f| f.len().saturating_sub(1) as f64).product()
}

/// Memory with the ghost layer all round [bytes].
pub(super) fn memory(grid: &Grid, precision: Precision) -> f64 {
    let share = if precision == Precision::Single { SINGLE } else { 1.0 };
    share * BYTES_PER_CELL * grid.faces.iter().map(|f| f.len() as f64 + 1.0).product::<f64>()
}

fn filled_cells(case: &Case) -> f64 {
    let (low, high, share) = match case.ground {
        Ground::Level { surface } => (case.domain.low, case.domain.high.with_z(surface), 1.0),
        Ground::Column { low, high, radius: None } => (low, high, 1.0),
        Ground::Column { low, high, radius: Some(_) } => (low, high, FRAC_PI_4),
    };
    let inside = |axis: usize| {
        case.grid.faces[axis].windows(2).filter(|w| w[1] > low[axis] && w[0] < high[axis]).count() as f64
    };
    share * inside(0) * inside(1) * inside(2)
}

/// Memory that this machine has to spare [bytes], where the system says so.
pub(super) fn memory_available() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/meminfo").ok()?;
    let line = text.lines().find(|l| l.starts_with("MemAvailable:"))?;
    let kilobytes: f64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(1024.0 * kilobytes)
}
