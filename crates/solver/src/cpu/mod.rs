//! The loops over cells and nodes, on the processor's cores.

pub mod contact;
pub mod energy;
pub mod lagrange;
pub mod machine;
pub mod remap;
pub mod stopwatch;
pub mod stress;
pub mod threads;
pub mod transport;
pub mod workspace;

use crate::grid::Grid;

/// Nodal masses from the masses of the cells [kg].
pub(crate) fn lagrange_mass(grid: &Grid, cell_mass: &[f64], node_mass: &mut [f64]) {
    let [nx, ny, nz] = grid.cells();
    let [x, y, z] = grid.stride;
    for k in 0..=nz {
        for j in 0..=ny {
            for i in 0..=nx {
                let n = grid.index(i, j, k);
                let at = |offset: usize| cell_mass[n - offset] + cell_mass[n - offset - x];
                node_mass[n] = 0.125 * ((at(0) + at(y)) + (at(z) + at(y + z)));
            }
        }
    }
}
