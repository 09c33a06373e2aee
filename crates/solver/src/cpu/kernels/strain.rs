//! The Lagrangian stage of a run of cells.

use super::Real;
use super::cells::{Block, CellRow, RowConstants, block_size};
use super::return_mapping::apply;
use super::stress::{
    NodeRows, add_pore_pressure, corner_sums, cut_off_stress, force_coefficients, linear_trial_stress,
    stiffening_trial_stress, strained_widths,
};
use crate::cpu::stage_sums::RowSums;
use crate::cpu::stopwatch::{Stage, Stopwatch};
use crate::fields::PORE_PRESSURE_AHEAD;
use ::kernels::sums::COEFFICIENTS;
use std::ops::Range;

/// Strains a run of cells of one material for one step: updates their stresses and writes the coefficients of
/// the nodal forces to the rows of `forces`. Adds the dissipation to `sums`.
pub(crate) fn strain_cells(
    constants: &RowConstants,
    nodes: &NodeRows,
    (cells, run): (&mut CellRow, Range<usize>),
    (block, stopwatch): (&mut Block, &mut Stopwatch),
    forces: &mut [&mut [Real]; COEFFICIENTS],
    sums: &mut RowSums,
) {
    let size = block_size(run.len());
    for start in run.clone().step_by(size) {
        (block.start, block.n) = (start, size.min(run.end - start));
        corner_sums(nodes, block);
        match &constants.material.stiffening {
            Some(stiffening) => stiffening_trial_stress(constants, stiffening, cells, block),
            None => linear_trial_stress(constants, cells, block),
        }
        if let Some(yield_law) = &constants.material.yield_law {
            stopwatch.lap(Stage::Lagrange);
            let returned = apply(constants, yield_law, cells, block);
            stopwatch.count_returned(returned);
            sums.yields += returned as u32;
            stopwatch.lap(Stage::Plasticity);
        }
        if !constants.has_cubes {
            strained_widths(constants, cells, block);
        }
        let [plastic, viscous, hourglass] = cut_off_stress(constants, cells, block);
        sums.plastic += plastic;
        sums.viscous += viscous * f64::from(constants.dt);
        sums.hourglass += hourglass * f64::from(constants.dt);
        if !cells.history[PORE_PRESSURE_AHEAD].is_empty() {
            sums.seepage += add_pore_pressure(constants, cells, block) * f64::from(constants.dt);
        }
        force_coefficients(block, forces);
        stopwatch.lap(Stage::Lagrange);
    }
}
