//! Estimates of how much a run will write, and of the memory that writing takes.

use super::resolved::{Case, Precision};
use serde::Serialize;
use solver::fields::{Kinds, arrays};
use solver::state::RimSums;

/// A cell with soil in a field file [bytes]: 18 numbers of 32 bits, compressed; measured (towed disc 59,
/// column 61).
const PACKED_CELL: f64 = 60.0;
/// A cell without soil in a field file [bytes]: all zeros, compressed; measured.
const PACKED_VOID: f64 = 0.5;
/// A column of cells in a free-surface file [bytes]; measured on the towed disc.
const PACKED_COLUMN: f64 = 21.0;
/// Size of a body in its file [bytes]; measured.
const PACKED_BODY: f64 = 6e3;
/// A line of a body's history, and of the energy history [bytes]; measured.
const LINES: [f64; 2] = [236.0, 155.0];
/// Compressed over uncompressed size of the state in a checkpoint, for cells with soil; measured.
const PACKED_STATE: f64 = 0.93;
/// Report, pictures and plots [bytes]; measured.
const REPORT: f64 = 0.8e6;
/// Memory for pictures, each for light and for dark screens, plots and the report of any case [bytes];
/// measured.
const PICTURES: f64 = 31e6;
/// Largest number of records of the sums over a rim; when there are more, every second one is dropped. The
/// ends of a window are then known to about a hundredth of the run (chosen: memory and checkpoints stay small
/// however long the run).
pub const MOST_RIM_RECORDS: usize = 256;
/// Memory to write a checkpoint, over that of the fields: it is written in small blocks.
const CHECKPOINT: f64 = 0.1;

/// What a run will write to disk.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct OutputSize {
    /// Number of field files.
    pub frames: f64,
    /// All field files: soil, surface and bodies [bytes].
    pub fields_bytes: f64,
    /// Histories of bodies and of the energy [bytes].
    pub histories_bytes: f64,
    /// Two checkpoints: the new one is written next to the old one [bytes].
    pub checkpoints_bytes: f64,
    /// Everything [bytes].
    pub total_bytes: f64,
}

/// Output of a run of a case with so many cells, and so many of them with soil, in this many steps.
#[must_use]
pub fn output_size(case: &Case, [cells, filled]: [f64; 2], steps: f64) -> OutputSize {
    let (bodies, layers) = (case.bodies.len() as f64, case.grid.faces[2].len() as f64 - 1.0);
    let mirrored = if case.domain.symmetric { 2.0 } else { 1.0 };
    let soil = PACKED_CELL * filled + PACKED_VOID * (cells - filled);
    let one = soil + PACKED_COLUMN * mirrored * cells / layers.max(1.0) + PACKED_BODY * bodies;
    let frames = (case.duration / case.output.field_interval).floor() + 2.0;
    let lines = samples(case, steps) + 1.0;
    let fields_bytes = frames * one;
    let histories_bytes = lines * (LINES[0] * bodies + LINES[1]);
    let kinds = case.soils().fold(Kinds::default(), |kinds, (_, soil)| kinds.and(soil.material().kinds()));
    let arrays = arrays(case.soils().count(), kinds);
    let checkpoints_bytes = 2.0 * PACKED_STATE * arrays as f64 * width(case) * filled;
    let total_bytes = fields_bytes + histories_bytes + checkpoints_bytes + REPORT;
    OutputSize { frames, fields_bytes, histories_bytes, checkpoints_bytes, total_bytes }
}

/// Number of samples of the histories in this many steps: one a step at most.
fn samples(case: &Case, steps: f64) -> f64 {
    (case.duration / case.output.history_interval).ceil().min(steps)
}

/// Memory of the sums over the rims of all bodies in the course of a run [bytes]; `bins` is the number of
/// their bins.
#[must_use]
pub fn rim_memory(case: &Case, steps: f64, bins: f64) -> f64 {
    samples(case, steps).min(MOST_RIM_RECORDS as f64) * bins * size_of::<RimSums>() as f64
}

fn width(case: &Case) -> f64 {
    match case.numerics.precision {
        Precision::Double => 8.0,
        Precision::Single => 4.0,
    }
}

/// Peak memory for writing [bytes]: for a checkpoint, or for pictures and report at the end. A field file is
/// written in blocks and takes less.
#[must_use]
pub fn memory(case: &Case, steps: f64, fields: f64) -> f64 {
    let lines = samples(case, steps);
    // The report reads the histories as text and draws them.
    let report = PICTURES + lines * (LINES[0] * case.bodies.len() as f64 + LINES[1]);
    report.max(CHECKPOINT * fields)
}
