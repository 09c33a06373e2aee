//! Energies of a row of the grid.

use super::rows::energy::{Cells, elastic_row, kinetic_row};
use super::{Nodes, Soil};
use crate::grid::{Grid, LANES};
use crate::material::Material;
use crate::model::Model;

/// Elastic energy of the soil in row `q` of a memory plane [J].
pub(crate) fn elastic(model: &Model, soil: &Soil, [q, plane]: [usize; 2]) -> f64 {
    let grid = &model.grid;
    if !grid.is_inside([q, plane]) {
        return 0.0;
    }
    let columns = grid.inside(0);
    let start = plane * grid.stride[2] + q * grid.stride[1] + 1 + columns.start;
    let own = start..start + columns.len().next_multiple_of(LANES);
    let cells = Cells {
        faces: &grid.faces[0][columns.start..=columns.end],
        fraction: &soil.fraction[own.clone()],
        across: grid.width(1, q - 1) * grid.width(2, plane - 1),
        kinds: &[],
        kind: 0,
    };
    let stress = soil.stress.each_ref().map(|s| &s[own.clone()]);
    if let [material] = model.materials.as_slice() {
        return elastic_row(&material.elastic, material.stiffening().as_ref(), cells, stress);
    }
    let kinds: Vec<u8> = own.clone().map(|c| soil.main_material(c) as u8).collect();
    let of_material = |(number, material): (usize, &Material)| {
        let cells = Cells { kinds: &kinds, kind: number as u8, ..cells };
        elastic_row(&material.elastic, material.stiffening().as_ref(), cells, stress)
    };
    model.materials.iter().enumerate().map(of_material).sum()
}

/// Kinetic energy of row `q` of a memory plane of nodes [J].
pub(crate) fn kinetic(grid: &Grid, nodes: &Nodes, [q, plane]: [usize; 2]) -> f64 {
    let [_, row, stride] = grid.stride;
    let own = plane * stride + q * row..plane * stride + (q + 1) * row;
    let [x, y, z] = nodes.velocity.each_ref().map(|v| &v[own.clone()]);
    kinetic_row(&nodes.mass[own], [x, y, z])
}
