//! Energies of a row, summed in double precision.

use super::{Nodes, Real, Soil};
use crate::grid::{Grid, LANES};
use crate::material::Material;
use crate::model::Model;
use multiversion::multiversion;
use physics::elastic::{Elastic, Stiffening};
use physics::tensor::Symmetric;

/// Elastic energy of the soil in row `q` of a memory plane [J].
pub(crate) fn elastic(model: &Model, soil: &Soil, [q, plane]: [usize; 2]) -> f64 {
    let grid = &model.grid;
    if !grid.is_inside([q, plane]) {
        return 0.0;
    }
    let columns = grid.inside(0);
    let start = plane * grid.stride[2] + q * grid.stride[1] + 1 + columns.start;
    let own = start..start + columns.len().next_multiple_of(LANES);
    let across = grid.width(1, q - 1) * grid.width(2, plane - 1);
    let stress = soil.stress.each_ref().map(|s| &s[own.clone()]);
    let cells =
        Cells { faces: &grid.faces[0][columns.start..=columns.end], fraction: &soil.fraction[own.clone()] };
    if let [material] = model.materials.as_slice() {
        return elastic_row(material, cells, stress, across);
    }
    let of_material = |(number, material): (usize, &Material)| {
        let each = cells.fraction.iter().zip(own.clone());
        let own: Vec<Real> =
            each.map(|(f, c)| if soil.main_material(c) == number { *f } else { 0.0 }).collect();
        elastic_row(material, Cells { fraction: &own, ..cells }, stress, across)
    };
    model.materials.iter().enumerate().map(of_material).sum()
}

/// A row of cells: its faces [m], and volume fractions. Cells beyond the last face count nothing.
#[derive(Clone, Copy)]
struct Cells<'a> {
    faces: &'a [f64],
    fraction: &'a [Real],
}

fn elastic_row(material: &Material, cells: Cells, stress: [&[Real]; 6], across: f64) -> f64 {
    match material.stiffening() {
        Some(stiffening) => stiffening_row(&material.elastic, &stiffening, cells, stress, across),
        None => linear_row(&material.elastic, cells, stress, across),
    }
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn linear_row(elastic: &Elastic, cells: Cells, stress: [&[Real]; 6], across: f64) -> f64 {
    sum_of_row(|stress| elastic.energy(stress), cells, stress, across)
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn stiffening_row(
    elastic: &Elastic,
    stiffening: &Stiffening,
    cells: Cells,
    stress: [&[Real]; 6],
    across: f64,
) -> f64 {
    sum_of_row(|stress| stiffening.energy(*elastic, stress), cells, stress, across)
}

/// Sum over a row of the energies from their densities.
#[inline(always)]
fn sum_of_row(
    density: impl Fn(Symmetric) -> f64,
    Cells { faces, fraction }: Cells,
    stress: [&[Real]; 6],
    across: f64,
) -> f64 {
    let mut lanes = [0.0; LANES];
    for start in (0..fraction.len()).step_by(LANES) {
        let mut width = [0.0; LANES];
        for (width, pair) in width.iter_mut().zip(faces[start..].windows(2)) {
            *width = pair[1] - pair[0];
        }
        let f = &fraction[start..start + LANES];
        let [xx, yy, zz, xy, yz, xz] = stress.map(|s| &s[start..start + LANES]);
        for l in 0..LANES {
            let stress = [
                f64::from(xx[l]),
                f64::from(yy[l]),
                f64::from(zz[l]),
                f64::from(xy[l]),
                f64::from(yz[l]),
                f64::from(xz[l]),
            ];
            lanes[l] += f64::from(f[l]) * (width[l] * across) * density(stress);
        }
    }
    total_of(lanes)
}

/// Kinetic energy of row `q` of a memory plane of nodes [J].
pub(crate) fn kinetic(grid: &Grid, nodes: &Nodes, [q, plane]: [usize; 2]) -> f64 {
    let [_, row, stride] = grid.stride;
    let own = plane * stride + q * row..plane * stride + (q + 1) * row;
    let [x, y, z] = nodes.velocity.each_ref().map(|v| &v[own.clone()]);
    kinetic_row(&nodes.mass[own], [x, y, z])
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn kinetic_row(mass: &[Real], velocity: [&[Real]; 3]) -> f64 {
    let mut lanes = [0.0; LANES];
    let [x, y, z] = velocity.map(|v| v.chunks(LANES));
    for (((m, x), y), z) in mass.chunks(LANES).zip(x).zip(y).zip(z) {
        for (l, lane) in lanes.iter_mut().enumerate().take(m.len()) {
            let [m, x, y, z] = [f64::from(m[l]), f64::from(x[l]), f64::from(y[l]), f64::from(z[l])];
            *lane += 0.5 * m * (x * x + y * y + z * z);
        }
    }
    total_of(lanes)
}

/// Sum of a vector's lanes.
fn total_of(lanes: [f64; LANES]) -> f64 {
    lanes.into_iter().fold(0.0, |a, b| a + b)
}
