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

/// Masses of a storage plane of nodes from those of the cells [kg].
pub(crate) fn lagrange_mass(grid: &Grid, plane: usize, cell_mass: &[f64], node_mass: &mut [f64]) {
    let [nx, ny, _] = grid.cells();
    let [x, y, z] = grid.stride;
    for j in 0..=ny {
        for i in 0..=nx {
            let n = (j + 1) * y + i + 1;
            let at = |offset: usize| {
                let c = plane * z + n - offset;
                cell_mass[c] + cell_mass[c - x]
            };
            node_mass[n] = 0.125 * ((at(0) + at(y)) + (at(z) + at(y + z)));
        }
    }
}
