//! What becomes of stress and history after a remap: gaps under pressure close, stresses return to the yield
//! surface, and where no soil is left nothing is remembered.

use super::cells::{BLOCK, Block, CellRow, RowConstants};
use super::physics::tensor::mean;
use super::return_mapping::apply;
use crate::history::GAP_STRAIN;
use multiversion::multiversion;
use std::ops::Range;

/// Updates some cells of a row, of one material.
pub fn update_cells(constants: &RowConstants, cells: &mut CellRow, columns: Range<usize>, block: &mut Block) {
    for start in columns.clone().step_by(BLOCK) {
        (block.start, block.n) = (start, BLOCK.min(columns.end - start));
        close_gaps(constants, cells, block);
        if let Some(yield_law) = &constants.material.yield_law {
            apply(constants, yield_law, cells, block);
        }
        put_back(cells, block);
    }
}

/// Soil with a gap was mixed with soil under pressure: lets the pressure close the gap, or its volume is
/// lost. Soil looser than it can be has a gap.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
pub fn close_gaps(constants: &RowConstants, cells: &CellRow, b: &mut Block) {
    let (start, n) = b.span();
    let own = start..start + n;
    let (fraction, gap_strain) = (&cells.fraction[own.clone()], &cells.history[GAP_STRAIN][own.clone()]);
    let (mass, width) = (&cells.mass[own.clone()], &constants.width_x[own.clone()]);
    let area = cells.width_y * cells.width_z;
    let [densest, loosest] = [constants.material.densest, constants.material.loosest].map(|d| d * area);
    let stress = cells.stress.each_ref().map(|s| &s[own.clone()]);
    let (bulk, stiffening) = (constants.material.elastic.bulk, constants.material.stiffening);
    for i in 0..n {
        let [xx, yy, zz, xy, yz, xz] = [0, 1, 2, 3, 4, 5].map(|c| stress[c][i]);
        let pressure = -mean([xx, yy, zz, xy, yz, xz]);
        let bulk = stiffening.map_or(bulk, |stiffening| bulk * stiffening.factor(pressure));
        let most = pressure / bulk;
        // The mean of two gaps is more than mixed soil can close by, since a gap is a logarithmic strain.
        // Soil that is too loose for its gap to tell all has at least one up to where it bears pressure.
        let loose = loosest * width[i] * fraction[i] / mass[i] - 1.0;
        let gap = if gap_strain[i] > loose { gap_strain[i] } else { loose };
        let room = densest * width[i] * fraction[i] / mass[i] - 1.0 + most;
        let gap = if gap < room { gap } else { room };
        let gap = if gap > 0.0 { gap } else { 0.0 };
        let closes = (gap > 0.0) & (pressure > 0.0);
        let closed = if gap < most { gap } else { most };
        let relief = bulk * closed;
        b.gap_strain[i] = if closes { gap - closed } else { gap };
        b.trial[0][i] = if closes { xx + relief } else { xx };
        b.trial[1][i] = if closes { yy + relief } else { yy };
        b.trial[2][i] = if closes { zz + relief } else { zz };
        (b.trial[3][i], b.trial[4][i], b.trial[5][i]) = (xy, yz, xz);
        b.bears_stress[i] = if fraction[i] > 0.0 { 1.0 } else { 0.0 };
    }
}

/// Stores stress and gap; where no soil is left nothing is remembered.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
pub fn put_back(cells: &mut CellRow, b: &Block) {
    let (start, n) = b.span();
    let own = start..start + n;
    for (stress, trial) in cells.stress.iter_mut().zip(&b.trial) {
        let stress = &mut stress[own.clone()];
        for i in 0..n {
            stress[i] = if b.bears_stress[i] > 0.0 { trial[i] } else { 0.0 };
        }
    }
    cells.history[GAP_STRAIN][own.clone()].copy_from_slice(&b.gap_strain[..n]);
    for history in cells.history.iter_mut().filter(|history| !history.is_empty()) {
        let history = &mut history[own.clone()];
        for i in 0..n {
            history[i] = if b.bears_stress[i] > 0.0 { history[i] } else { 0.0 };
        }
    }
}
