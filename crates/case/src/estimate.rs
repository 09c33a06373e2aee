//! What a case will cost: cells, memory, time step, number of steps.

use super::grid;
use super::model::model;
use super::output_size::{self, OutputSize};
use super::path::travel;
use super::resolved::{Body, Case, Grid, Ground, Precision};
use glam::DVec3;
use serde::Serialize;
use solver::footprint::{self, Footprint, rim_bins, surface_points};
use solver::grid::{LANES, finest_of, longer_step};
use solver::precision::Scalar as _;
use std::f64::consts::FRAC_PI_4;

/// The program itself, its libraries and its input [bytes]; measured on Linux: what `coulter check` takes for
/// a small case.
const PROGRAM: f64 = 15.2e6;
/// Sinkage of a free body that its weight does not press in, over its height (chosen).
const SINKAGE: f64 = 0.1;

/// Memory of a run [bytes].
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Memory {
    /// The program itself.
    pub program_bytes: f64,
    /// Fields on the grid, and the workspace of the step.
    pub grid_bytes: f64,
    /// Contact points of the bodies.
    pub contact_bytes: f64,
    /// Sums over the rims of the bodies, and peak memory for writing results.
    pub outputs_bytes: f64,
}

impl Memory {
    /// Total [bytes].
    #[must_use]
    pub fn total(&self) -> f64 {
        self.program_bytes + self.grid_bytes + self.contact_bytes + self.outputs_bytes
    }
}

/// Cells and steps of a case.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Estimate {
    /// Cells of the grid.
    pub cells: f64,
    /// Cells that contain soil at the start.
    pub filled_cells: f64,
    /// The smallest cell width [m].
    pub smallest_cell_m: f64,
    /// Speed of pressure waves in the soil [m/s].
    pub wave_speed_m_per_s: f64,
    /// Time step [s].
    pub time_step_s: f64,
    /// Number of time steps.
    pub steps: f64,
}

/// What a case will cost in time, memory and disk space.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Cost {
    /// Cells and steps.
    #[serde(flatten)]
    pub estimate: Estimate,
    /// Total memory [bytes].
    pub memory_bytes: f64,
    /// Memory by what takes it.
    pub memory: Memory,
    /// What the run will write.
    pub output: OutputSize,
}

/// The cost of a case. This takes some time where there are many bodies.
#[must_use]
pub fn cost(case: &Case) -> Cost {
    let estimate = estimate(case);
    let memory = memory(case, &estimate);
    let output = output_size::output_size(case, [estimate.cells, estimate.filled_cells], estimate.steps);
    Cost { estimate, memory_bytes: memory.total(), memory, output }
}

/// Cells and steps of `case`.
#[must_use]
pub fn estimate(case: &Case) -> Estimate {
    let wave_speed = case.soils().map(|(_, soil)| soil.material().wave_speed()).fold(0.0, f64::max);
    let aspect = case.grid.aspect;
    let widths = DVec3::from_array(case.grid.faces.each_ref().map(|faces| finest_of(faces)));
    let time_step =
        case.numerics.courant * ((widths / aspect).min_element() * longer_step(aspect)) / wave_speed;
    let (cells, filled_cells) = (cells(&case.grid), filled_cells(case));
    Estimate {
        cells,
        filled_cells,
        smallest_cell_m: widths.min_element(),
        wave_speed_m_per_s: wave_speed,
        time_step_s: time_step,
        steps: (case.duration / time_step).ceil(),
    }
}

/// Number of cells, as a floating-point number, which cannot overflow.
pub(super) fn cells(grid: &Grid) -> f64 {
    grid.faces.iter().map(|f| f.len().saturating_sub(1) as f64).product()
}

/// Memory that a run will take; nothing is allocated.
fn memory(case: &Case, estimate: &Estimate) -> Memory {
    let &Estimate { cells, filled_cells: filled, steps, .. } = estimate;
    let Footprint { fields, fields_of_soil, workspace, contact, layout } = footprint(case);
    let void = 1.0 - (filled / cells).clamp(0.0, 1.0);
    let outputs = output_size::memory(case, steps, fields);
    Memory {
        program_bytes: PROGRAM,
        grid_bytes: fields - void * fields_of_soil + workspace,
        contact_bytes: contact,
        // The contact points are generated before anything is written.
        outputs_bytes: outputs.max(layout - contact)
            + output_size::rim_memory(case, steps, all_rim_bins(case)),
    }
}

/// Bins of the rims of all bodies.
fn all_rim_bins(case: &Case) -> f64 {
    let model = model(case, LANES);
    model.bodies.iter().map(|body| rim_bins(&model, body)).sum()
}

/// The body with the most contact points: its name and their number, without laying them out.
#[must_use]
pub fn most_contact_points(case: &Case) -> Option<(String, f64)> {
    let model = model(case, LANES);
    let points = model.bodies.iter().map(|body| (body.name.clone(), surface_points(&model, body)));
    points.max_by(|a, b| a.1.total_cmp(&b.1))
}

/// Sinkage [m] at which the soil of a case would bear a body that is free to sink, for estimates of a run; at
/// most its height.
#[must_use]
pub fn expected_sinkage(case: &Case, body: &Body) -> f64 {
    let rest = grid::rest(body, grid::is_towed(body, case.duration), &case.soil, case.gravity);
    rest.unwrap_or(SINKAGE * body.size().z)
}

/// Estimated displacement of a body at the end [m].
fn moved(case: &Case, body: &Body) -> DVec3 {
    let guide = body.guided().translation;
    let [x, y, z] = guide.each_ref().map(|freedom| travel(freedom, case.duration));
    DVec3::new(x, y, if guide[2].is_free() { -expected_sinkage(case, body) } else { z })
}

fn footprint(case: &Case) -> Footprint {
    let threads = machine::cores::threads(case.numerics.threads);
    let moved: Vec<DVec3> = case.bodies.iter().map(|body| moved(case, body)).collect();
    match case.numerics.precision {
        Precision::Double => footprint::footprint::<f64>(&model(case, f64::LANES), threads, &moved),
        Precision::Single => footprint::footprint::<f32>(&model(case, f32::LANES), threads, &moved),
    }
}

fn filled_cells(case: &Case) -> f64 {
    let (low, high, fraction) = match case.ground {
        Ground::Level { .. } => (case.domain.low, case.domain.high.with_z(case.top_of_ground()), 1.0),
        Ground::Column { low, high, radius: None } => (low, high, 1.0),
        Ground::Column { low, high, radius: Some(_) } => (low, high, FRAC_PI_4),
    };
    let inside = |axis: usize| {
        case.grid.faces[axis].windows(2).filter(|w| w[1] > low[axis] && w[0] < high[axis]).count() as f64
    };
    fraction * inside(0) * inside(1) * inside(2)
}
