//! What a measurement of the speed says.

use serde::Serialize;

/// What was measured.
#[derive(Clone, Debug, Serialize)]
pub struct Measurement {
    /// Version of the document.
    pub format: u32,
    /// Name of the case.
    pub case: String,
    /// Precision of the arithmetic.
    pub precision: &'static str,
    /// Threads of the second measurement.
    pub threads: usize,
    /// Cells of the grid along x, y, z.
    pub cells: [usize; 3],
    /// Cells with soil.
    pub filled_cells: usize,
    /// Steps measured.
    pub steps: u32,
    /// Remaps among the steps.
    pub remaps: u64,
    /// Number of steps that take as long as a remap, one thread.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub steps_in_remap: Option<f64>,
    /// Speed of one thread in single precision over that in double precision; only of a run in single
    /// precision.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub times_double: Option<f64>,
    /// Memory in single precision over that in double precision; only of a run in single precision.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub memory_of_double: Option<f64>,
    /// Million steps of a cell with soil per second of processor time, one thread.
    pub million_cell_steps_per_core_second: f64,
    /// Million steps of a cell with soil per second of processor time, all threads together.
    pub million_cell_steps_per_core_second_threads: f64,
    /// Speed of all threads over that of one, by the wall clock.
    pub speed_up: f64,
    /// Memory of state and workspace per cell of the grid, with or without soil [bytes].
    pub bytes_per_cell: f64,
    /// Traffic with the main memory that one thread can have [GB/s].
    #[serde(rename = "triad_GB_per_s")]
    pub triad: f64,
    /// Multiply-adds that one thread can do in the precision of the run [GFLOP/s]; measured in double
    /// precision.
    #[serde(rename = "fma_GFLOP_per_s")]
    pub fma: f64,
    /// Traffic with the main memory that all threads can have [GB/s].
    #[serde(rename = "triad_threads_GB_per_s")]
    pub triad_threads: f64,
    /// Multiply-adds that all threads can do in the precision of the run [GFLOP/s]; measured in double
    /// precision.
    #[serde(rename = "fma_threads_GFLOP_per_s")]
    pub fma_threads: f64,
    /// Share of the cell-steps in which the soil yields.
    pub yielding: f64,
    /// Share of the time by stage, one thread.
    pub split: Split,
    /// Operations of the stages that can be counted [GFLOP/s], one thread.
    #[serde(rename = "achieved_GFLOP_per_s")]
    pub operations: Operations,
    /// Traffic of the Lagrangian stage if each array crosses the bus once [GB/s], one thread.
    #[serde(rename = "achieved_GB_per_s")]
    pub traffic: f64,
}

/// Fractions of the time.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Split {
    /// Strain, trial stress, force coefficients.
    pub lagrange: f64,
    /// Return mapping.
    pub plasticity: f64,
    /// Forces gathered, velocities, displacements.
    pub nodes: f64,
    /// The Eulerian stage.
    pub remap: f64,
    /// Contact and bodies.
    pub contact: f64,
    /// Energy balance and checks.
    pub other: f64,
}

/// Rates of arithmetic [GFLOP/s].
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Operations {
    /// Strain, trial stress, force coefficients.
    pub lagrange: f64,
    /// Return mapping.
    pub plasticity: f64,
    /// Forces gathered, velocities, displacements.
    pub nodes: f64,
}
