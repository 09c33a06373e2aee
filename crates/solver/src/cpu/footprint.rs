//! Memory that the workspace takes up, and what a whole run will take up, told before any of it exists.

use super::Real;
use super::contact::{BodyCell, TouchedNode, kept_per_patch};
use super::stress::Block;
use super::workspace::{COEFFICIENTS, NODE_SUMS, ROW_BUFFERS, RowSums, WorkerScratch, Workspace};
use crate::cpu::threads::MOST;
use crate::footprint::{self, Footprint};
use crate::grid::Grid;
use crate::model::Model;
use glam::DVec3;

/// Number of threads that a team gets which is asked for.
pub(crate) fn team_size(grid: &Grid, threads: usize) -> usize {
    let (rows, planes) = (grid.rows(), grid.cells()[2] + 1);
    // The nodes that wait for a worker's cells must not wait for those of another besides.
    threads.clamp(1, (planes * rows / (rows + 1)).min(MOST))
}

/// What a run of a model by so many threads will take up, each body being at last so far from its start [m].
#[must_use]
pub fn footprint(model: &Model, threads: usize, moved: &[DVec3]) -> Footprint {
    let grid = &model.grid;
    let [fields, fields_of_soil] = footprint::fields::<Real>(grid.entries);
    let per_surface_point = size_of::<(DVec3, u32)>() as f64;
    let per_patch = footprint::per_patch(size_of::<TouchedNode>()) + kept_per_patch(model);
    let [contact, layout] = footprint::contact(model, moved, [per_surface_point, per_patch]);
    let workspace = workspace(grid, team_size(grid, threads));
    let body_cells = footprint::body_cells(model) * size_of::<BodyCell>() as f64;
    Footprint { fields, fields_of_soil, workspace, contact: contact + body_cells, layout }
}

/// A workspace but for contact.
fn workspace(grid: &Grid, threads: usize) -> f64 {
    let [_, row, plane] = grid.stride;
    let (threads, rows, planes) = (threads as f64, grid.rows(), grid.cells()[2] + 1);
    let own = 3 * COEFFICIENTS * row + NODE_SUMS * plane + ROW_BUFFERS * row;
    let waiting = NODE_SUMS * (plane + row);
    let per_row = size_of::<RowSums>() + size_of::<bool>() + size_of::<[f64; 2]>();
    let of_rows = rows * (planes + 1) * per_row + rows * planes * size_of::<f64>();
    let reals = 3.0 * grid.entries as f64 + threads * own as f64 + (threads - 1.0) * waiting as f64;
    reals * size_of::<Real>() as f64 + threads * size_of::<Block>() as f64 + of_rows as f64
}

impl Workspace {
    /// Memory that it takes up [bytes], but for what the contact law keeps during a step.
    #[must_use]
    pub fn memory(&self) -> usize {
        let own = |w: &WorkerScratch| {
            let coefficients = w.coefficients.iter().chain([&w.first]).map(|c| &c.values);
            let rows = coefficients.chain([&w.below, &w.waiting, &w.row]);
            rows.map(|row| size_of_val(row.as_slice())).sum::<usize>() + size_of_val(&*w.block)
        };
        self.velocity_before.iter().map(|field| size_of_val(field.as_slice())).sum::<usize>()
            + self.workers.iter().map(own).sum::<usize>()
            + size_of_val(self.row_sums.as_slice())
            + size_of_val(self.costs.as_slice())
            + size_of_val(self.row_has_soil.as_slice())
            + size_of_val(self.row_values.as_slice())
            + self.contact_memory()
    }

    /// Memory for surfaces and contact points among it [bytes].
    #[must_use]
    pub fn contact_memory(&self) -> usize {
        self.surfaces.iter().map(super::contact::Surface::memory).sum::<usize>()
            + size_of_val(self.body_cells.as_slice())
            + size_of_val(self.touched.as_slice())
            + size_of_val(self.corner_nodes.as_slice())
            + size_of_val(self.patch.0.as_slice())
            + size_of_val(self.patch.1.as_slice())
            + size_of_val(self.friction.as_slice())
    }
}
