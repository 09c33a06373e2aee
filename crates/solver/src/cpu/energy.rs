//! Sums over the whole grid, always in double precision: energies, mass and volume of the soil. Taken at samples and round a remap, not every step.

use super::{Nodes, Real, Soil};
use crate::grid::Grid;
use crate::model::Model;

/// Elastic energy of the soil [J].
pub(crate) fn elastic(model: &Model, soil: &Soil) -> f64 {
    sum_cells(&model.grid, &soil.fraction, |c, volume| {
        let stress = soil.stress.each_ref().map(|s| f64::from(s[c]));
        f64::from(soil.fraction[c]) * volume * model.elastic.energy(stress)
    })
}

/// Kinetic energy of the nodes [J].
pub(crate) fn kinetic(nodes: &Nodes) -> f64 {
    let [vx, vy, vz] = &nodes.velocity;
    let each = nodes.mass.iter().zip(vx).zip(vy).zip(vz);
    each.filter(|(((m, _), _), _)| **m > 0.0)
        .map(|(((m, x), y), z)| [m, x, y, z].map(|value| f64::from(*value)))
        .map(|[m, x, y, z]| 0.5 * m * (x * x + y * y + z * z))
        .sum()
}

/// Volume of the soil [m³].
#[must_use]
pub fn soil_volume(grid: &Grid, soil: &Soil) -> f64 {
    sum_cells(grid, &soil.fraction, |c, volume| f64::from(soil.fraction[c]) * volume)
}

/// Mass of the soil [kg].
#[must_use]
pub fn soil_mass(soil: &Soil) -> f64 {
    soil.mass.iter().map(|mass| f64::from(*mass)).sum()
}

/// Sum of `value(cell, cell volume)` over the cells with soil, in memory order.
fn sum_cells(grid: &Grid, fraction: &[Real], value: impl Fn(usize, f64) -> f64) -> f64 {
    let [nx, ny, nz] = grid.cells();
    let mut sum = 0.0;
    for k in 0..nz {
        for j in 0..ny {
            let mut row = 0.0;
            for i in 0..nx {
                let c = grid.index(i, j, k);
                if fraction[c] > 0.0 {
                    row += value(c, grid.volume(i, j, k));
                }
            }
            sum += row;
        }
    }
    sum
}
