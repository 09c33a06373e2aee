//! The meshes of a study, and what they cost.

use crate::run_time;
use coulter::case::Case;
use coulter::case::estimate::{self, Cost};
use coulter::case::quantity::short;
use coulter::case::resources::format_bytes;
use serde::Serialize;
use std::fmt::Write;

/// One mesh of a study.
#[derive(Debug, Serialize)]
pub(super) struct MeshCost {
    /// `grid.cell` [m].
    cell_m: f64,
    cost: Cost,
    /// Estimated time of the run on this machine [s].
    estimated_wall_s: Option<f64>,
}

impl MeshCost {
    pub(super) fn of(case: &Case) -> Self {
        let cost = estimate::cost(case);
        Self { cell_m: case.grid.cell, estimated_wall_s: run_time::estimate(case, &cost), cost }
    }
}

/// A line for each mesh, the coarsest first, and one for all of them.
pub(super) fn describe_meshes(text: &mut String, meshes: &[MeshCost]) -> std::fmt::Result {
    for (n, mesh) in meshes.iter().enumerate() {
        let Cost { estimate, memory_bytes, output, .. } = &mesh.cost;
        writeln!(
            text,
            "mesh {}   cells of {} mm: {} cells, {} steps, memory {}, results {}{}",
            n + 1,
            short(1e3 * mesh.cell_m),
            estimate.cells,
            estimate.steps,
            format_bytes(*memory_bytes),
            format_bytes(output.total_bytes),
            mesh.estimated_wall_s.map_or(String::new(), |seconds| format!(", about {seconds:.0} s"))
        )?;
    }
    let Some(finest) = meshes.last() else { return Ok(()) };
    let work = |mesh: &MeshCost| mesh.cost.estimate.steps * mesh.cost.estimate.filled_cells;
    let ratio = meshes.iter().map(work).sum::<f64>() / work(finest);
    let results: f64 = meshes.iter().map(|mesh| mesh.cost.output.total_bytes).sum();
    let seconds: Option<f64> = meshes.iter().map(|mesh| mesh.estimated_wall_s).sum();
    writeln!(
        text,
        "meshes   together {ratio:.2} times the work of the finest, results {}{}",
        format_bytes(results),
        seconds.map_or(String::new(), |seconds| format!(", run time about {seconds:.0} s on this machine"))
    )
}
