//! Sums over the whole grid, always in double precision: energies, mass and volume of the soil. Taken at samples and round
//! a remap, not every step.
//!
//! Every row is added up by itself, then the rows in the order of the memory: the same whoever adds them up.

use super::workspace::Workspace;
use super::{Nodes, Real, Soil, State};
use crate::grid::Grid;
use crate::model::Model;

/// Elastic energy of the soil [J].
pub(crate) fn elastic(model: &Model, soil: &Soil) -> f64 {
    sum_rows(&model.grid, |place| elastic_of(model, soil, place))
}

/// Kinetic energy of the nodes [J].
pub(crate) fn kinetic(grid: &Grid, nodes: &Nodes) -> f64 {
    sum_rows(grid, |place| kinetic_of(grid, nodes, place))
}

/// Elastic and kinetic energy of the soil [J], by the whole team.
pub(crate) fn total(model: &Model, state: &State, workspace: &mut Workspace) -> f64 {
    let rows = Workspace::rows(&model.grid);
    let Workspace { team, cut, row_values, .. } = workspace;
    team.deal(cut.split_by(rows, row_values).zip(cut.ranges()), |(values, planes)| {
        for (n, value) in values.iter_mut().enumerate() {
            let place = [n % rows, planes.start + n / rows];
            *value = [elastic_of(model, &state.soil, place), kinetic_of(&model.grid, &state.nodes, place)];
        }
    });
    let [elastic, kinetic] = workspace.total_of_rows();
    elastic + kinetic
}

/// Elastic energy of the soil in row `q` of a storage plane [J].
fn elastic_of(model: &Model, soil: &Soil, place: [usize; 2]) -> f64 {
    sum_cells(&model.grid, &soil.fraction, place, |c, volume| {
        let stress = soil.stress.each_ref().map(|s| f64::from(s[c]));
        f64::from(soil.fraction[c]) * volume * model.elastic.energy(stress)
    })
}

/// Kinetic energy of row `q` of a storage plane of nodes [J].
fn kinetic_of(grid: &Grid, nodes: &Nodes, [q, plane]: [usize; 2]) -> f64 {
    let [_, row, stride] = grid.stride;
    let own = plane * stride + q * row..plane * stride + (q + 1) * row;
    let [x, y, z] = nodes.velocity.each_ref().map(|v| &v[own.clone()]);
    let each = nodes.mass[own].iter().zip(x).zip(y).zip(z);
    each.map(|(((m, x), y), z)| [m, x, y, z].map(|value| f64::from(*value)))
        .map(|[m, x, y, z]| 0.5 * m * (x * x + y * y + z * z))
        .sum()
}

/// Volume of the soil [m³].
#[must_use]
pub fn soil_volume(grid: &Grid, soil: &Soil) -> f64 {
    sum_rows(grid, |place| {
        sum_cells(grid, &soil.fraction, place, |c, volume| f64::from(soil.fraction[c]) * volume)
    })
}

/// Mass of the soil [kg].
#[must_use]
pub fn soil_mass(soil: &Soil) -> f64 {
    soil.mass.iter().map(|mass| f64::from(*mass)).sum()
}

/// Sum over the rows `[q, plane]` of the grid, of cells and of nodes, in memory order.
fn sum_rows(grid: &Grid, of_row: impl Fn([usize; 2]) -> f64) -> f64 {
    let [_, ny, nz] = grid.cells();
    (1..=nz + 1).flat_map(|plane| (1..=ny + 1).map(move |q| [q, plane])).map(of_row).fold(0.0, |a, b| a + b)
}

/// Sum of `value(cell, cell volume)` over the cells with soil of row `q` of a storage plane.
fn sum_cells(
    grid: &Grid,
    fraction: &[Real],
    [q, plane]: [usize; 2],
    value: impl Fn(usize, f64) -> f64,
) -> f64 {
    let [nx, ny, nz] = grid.cells();
    if !(1..=ny).contains(&q) || plane > nz {
        return 0.0;
    }
    let start = plane * grid.stride[2] + q * grid.stride[1] + 1;
    let cells = (0..nx).filter(|i| fraction[start + i] > 0.0);
    cells.map(|i| value(start + i, grid.volume(i, q - 1, plane - 1))).fold(0.0, |a, b| a + b)
}
