//! One row of cells: velocity gradient → trial stress → return mapping → nodal force coefficients.
//!
//! A row is processed in blocks of up to 96 cells (192 in single precision), whose scratch memory fits into
//! the first-level cache, by a few simple loops. The formulas are free of branches, and what a loop writes
//! lies in the block or is passed as an argument, so that the compiler can exclude aliasing and vectorises
//! them. Each loop is compiled for several instruction sets; without `mul_add`, all give the same bits.

use super::Real;
use super::cells::{BLOCK, Block, CellRow, Lane, RowConstants};
use super::lanes::lane_sum;
use super::physics::brick::Sums;
use super::physics::elastic::{Elastic, Stiffening};
use super::physics::tensor::{Symmetric, deviator, jaumann, mean};
use super::physics::viscosity::strained_width;
use crate::history::{GAP_STRAIN, PORE_PRESSURE_AHEAD};
use crate::sums::COEFFICIENTS;
use multiversion::multiversion;

/// Nodal velocities in the four rows of nodes around a row of cells: (y, z) = (0,0), (1,0), (0,1), (1,1).
pub type NodeRows<'a> = [[&'a [Real]; 3]; 4];

/// Corner sums of the velocities of a block.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
pub fn corner_sums(nodes: &NodeRows, b: &mut Block) {
    let (start, n) = b.span();
    b.hourglass = [0.0; BLOCK];
    let Block { plain: [px, py, pz], side: [sx, sy, sz], hourglass, .. } = b;
    let own = start..start + n + 1;
    let row = |row: usize, q: usize| &nodes[row][q][own.clone()];
    component_sums([row(0, 0), row(1, 0), row(2, 0), row(3, 0)], px, sx, hourglass);
    component_sums([row(0, 1), row(1, 1), row(2, 1), row(3, 1)], py, sy, hourglass);
    component_sums([row(0, 2), row(1, 2), row(2, 2), row(3, 2)], pz, sz, hourglass);
}

#[inline(always)]
fn component_sums(v: [&[Real]; 4], plain: &mut Lane, [x, y, z]: &mut [Lane; 3], hourglass: &mut Lane) {
    let n = (v[0].len() - 1).min(BLOCK);
    // Slices of visibly equal length: otherwise the compiler leaves a vector's worth of cells to a scalar
    // loop.
    let (v0, v1, v2, v3) = (&v[0][..=n], &v[1][..=n], &v[2][..=n], &v[3][..=n]);
    for i in 0..n {
        let corners = [[v0[i], v0[i + 1]], [v1[i], v1[i + 1]], [v2[i], v2[i + 1]], [v3[i], v3[i + 1]]];
        let sums = Sums::of(corners);
        plain[i] = sums.plain;
        x[i] = sums.side[0];
        y[i] = sums.side[1];
        z[i] = sums.side[2];
        hourglass[i] += sums.hourglass();
    }
}

/// Trial stresses of a block with constant moduli.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
pub fn linear_trial_stress(constants: &RowConstants, cells: &CellRow, b: &mut Block) {
    let elastic = constants.material.elastic;
    trial_stress(constants, |_| elastic, cells, b);
}

/// Trial stresses of a block whose moduli grow with the pressure.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
pub fn stiffening_trial_stress(
    constants: &RowConstants,
    stiffening: &Stiffening,
    cells: &CellRow,
    b: &mut Block,
) {
    let elastic = constants.material.elastic;
    trial_stress(constants, |stress| stiffening.moduli(elastic, -mean(stress)), cells, b);
}

/// Trial stresses of a block, with the moduli at the stress before.
#[inline(always)]
fn trial_stress(
    constants: &RowConstants,
    moduli: impl Fn(Symmetric) -> Elastic,
    cells: &CellRow,
    b: &mut Block,
) {
    let (start, n) = b.span();
    let own = start..start + n;
    let (per_width, fraction) = (&constants.per_width_x[own.clone()], &cells.fraction[own.clone()]);
    let gap_strain = &cells.history[GAP_STRAIN][own.clone()];
    let [xx, yy, zz, xy, yz, xz] = &cells.stress;
    let (old_xx, old_yy, old_zz) = (&xx[own.clone()], &yy[own.clone()], &zz[own.clone()]);
    let (old_xy, old_yz, old_xz) = (&xy[own.clone()], &yz[own.clone()], &xz[own]);
    let dt = constants.dt;
    let (per_y, per_z) = (0.25 / cells.width_y, 0.25 / cells.width_z);
    for i in 0..n {
        let per_x = per_width[i];
        let (xx, xy, xz) = (b.side[0][0][i] * per_x, b.side[0][1][i] * per_y, b.side[0][2][i] * per_z);
        let (yx, yy, yz) = (b.side[1][0][i] * per_x, b.side[1][1][i] * per_y, b.side[1][2][i] * per_z);
        let (zx, zy, zz) = (b.side[2][0][i] * per_x, b.side[2][1][i] * per_y, b.side[2][2][i] * per_z);
        let strain_rate: Symmetric = [xx, yy, zz, 0.5 * (xy + yx), 0.5 * (yz + zy), 0.5 * (xz + zx)];
        let spin = [0.5 * (xy - yx), 0.5 * (yz - zy), 0.5 * (xz - zx)];
        let volumetric = xx + yy + zz;
        // A gap closes before pressure builds up.
        let gap = gap_strain[i];
        let open = gap + volumetric * dt;
        let has_gap = gap > 0.0;
        let has_soil = fraction[i] > 0.0;
        let stays_open = has_gap & (open > 0.0);
        let closing = if open < 0.0 { open } else { 0.0 };
        let volume_strain = if has_gap { closing } else { volumetric * dt };
        b.gap_strain[i] = if stays_open & has_soil { open } else { 0.0 };
        let old = [old_xx[i], old_yy[i], old_zz[i], old_xy[i], old_yz[i], old_xz[i]];
        let elastic = moduli(old);
        let shear = deviator(strain_rate);
        let rotation = jaumann(old, spin);
        let hydrostatic = elastic.bulk * volume_strain;
        let stiffness = 2.0 * elastic.shear * dt;
        b.trial[0][i] = old[0] + hydrostatic + stiffness * shear[0] + rotation[0] * dt;
        b.trial[1][i] = old[1] + hydrostatic + stiffness * shear[1] + rotation[1] * dt;
        b.trial[2][i] = old[2] + hydrostatic + stiffness * shear[2] + rotation[2] * dt;
        b.trial[3][i] = old[3] + stiffness * shear[3] + rotation[3] * dt;
        b.trial[4][i] = old[4] + stiffness * shear[4] + rotation[4] * dt;
        b.trial[5][i] = old[5] + stiffness * shear[5] + rotation[5] * dt;
        b.rate[i] = volumetric;
        b.bears_stress[i] = if has_soil & !stays_open { 1.0 } else { 0.0 };
    }
    b.work = [0.0; BLOCK];
}

/// Lengths for bulk viscosity of cells that are not cubes.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
pub fn strained_widths(constants: &RowConstants, cells: &CellRow, b: &mut Block) {
    let (start, n) = b.span();
    let own = start..start + n;
    let (width, per_width) = (&constants.width_x[own.clone()], &constants.per_width_x[own]);
    let (hy, hz) = (cells.width_y, cells.width_z);
    let (per_y, per_z) = (0.25 / hy, 0.25 / hz);
    for i in 0..n {
        let rates = [b.side[0][0][i] * per_width[i], b.side[1][1][i] * per_y, b.side[2][2][i] * per_z];
        b.strained_width[i] = strained_width([width[i], hy, hz], rates);
    }
}

/// Stress cut-off: stores the stress at the end of the step, zero where the soil bears none, and computes the
/// stress-bearing areas, the bulk viscosity and the hourglass damping. Returns the plastic work [J] and the
/// dissipation by bulk and hourglass viscosity [W] of the block.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
pub fn cut_off_stress(constants: &RowConstants, cells: &mut CellRow, b: &mut Block) -> [f64; 3] {
    let (start, n) = b.span();
    let own = start..start + n;
    let (width, fraction) = (&constants.width_x[own.clone()], &cells.fraction[own.clone()]);
    let (hy, hz) = (cells.width_y, cells.width_z);
    for i in 0..n {
        let hx = width[i];
        let volume = hx * hy * hz;
        let length = mean_width(hx, hy, hz);
        let f = if b.bears_stress[i] > 0.0 { fraction[i] } else { 0.0 };
        let strained = if constants.has_cubes { length } else { b.strained_width[i] };
        let viscous = constants.material.viscosity.stress(strained, b.rate[i]);
        // Yielding soil resists shear with its strength alone, whatever its stiffness; so should its
        // hourglass modes.
        let factor = if b.yields[i] > 0.0 { constants.hourglass_yielding } else { 1.0 };
        let h = f * factor * constants.material.hourglass * length * length;
        b.area[0][i] = -0.25 * f * hy * hz;
        b.area[1][i] = -0.25 * f * hx * hz;
        b.area[2][i] = -0.25 * f * hx * hy;
        b.viscous[i] = viscous;
        b.damping[i] = h;
        b.work[i] *= f * volume;
        b.viscous_power[i] = viscous * b.rate[i] * f * volume;
        b.damped_power[i] = h * b.hourglass[i];
    }
    let [xx, yy, zz, xy, yz, xz] = &mut cells.stress;
    cut_off_three(b, 0, &mut xx[own.clone()], &mut yy[own.clone()], &mut zz[own.clone()]);
    cut_off_three(b, 3, &mut xy[own.clone()], &mut yz[own.clone()], &mut xz[own.clone()]);
    cells.history[GAP_STRAIN][own].copy_from_slice(&b.gap_strain[..n]);
    [&b.work, &b.viscous_power, &b.damped_power].map(|lane| lane_sum(&lane[..n]))
}

/// The cut-off of three components of the stress, from `first` on.
#[inline(always)]
fn cut_off_three(b: &mut Block, first: usize, one: &mut [Real], two: &mut [Real], three: &mut [Real]) {
    let n = one.len().min(BLOCK);
    let (one, two, three) = (&mut one[..n], &mut two[..n], &mut three[..n]);
    for i in 0..n {
        let s = |c: usize| if b.bears_stress[i] > 0.0 { b.trial[first + c][i] } else { 0.0 };
        (one[i], two[i], three[i]) = (s(0), s(1), s(2));
        (b.trial[first][i], b.trial[first + 1][i], b.trial[first + 2][i]) = (one[i], two[i], three[i]);
    }
}

/// Adds the pore pressure to the stresses that act on the nodes, in all soil: unlike the grains, the water in
/// it bears pressure across an open gap, too. Returns the power that goes into the water [W].
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
pub fn add_pore_pressure(constants: &RowConstants, cells: &CellRow, b: &mut Block) -> f64 {
    let (start, n) = b.span();
    let own = start..start + n;
    let (width, fraction) = (&constants.width_x[own.clone()], &cells.fraction[own.clone()]);
    let pressure = &cells.history[PORE_PRESSURE_AHEAD][own];
    let (hy, hz) = (cells.width_y, cells.width_z);
    for i in 0..n {
        let (hx, f) = (width[i], fraction[i]);
        b.area[0][i] = -0.25 * f * hy * hz;
        b.area[1][i] = -0.25 * f * hx * hz;
        b.area[2][i] = -0.25 * f * hx * hy;
        let viscous = if b.bears_stress[i] > 0.0 { b.viscous[i] } else { 0.0 };
        b.viscous[i] = viscous - pressure[i];
        b.work[i] = -pressure[i] * b.rate[i] * f * (hx * hy * hz);
    }
    lane_sum(&b.work[..n])
}

/// Coefficients of the nodal forces from stress and hourglass viscosity: the plain term, and the terms signed
/// by the corner's side.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
pub fn force_coefficients(b: &Block, forces: &mut [&mut [Real]; COEFFICIENTS]) {
    let (start, n) = b.span();
    let own = start..start + n;
    let [px, xx, xy, xz, py, yx, yy, yz, pz, zx, zy, zz, damping] = forces;
    let [px, xx, xy, xz] = [px, xx, xy, xz].map(|row| &mut row[own.clone()]);
    let [py, yx, yy, yz] = [py, yx, yy, yz].map(|row| &mut row[own.clone()]);
    let [pz, zx, zy, zz] = [pz, zx, zy, zz].map(|row| &mut row[own.clone()]);
    component_coefficients(b, 0, px, xx, xy, xz);
    component_coefficients(b, 1, py, yx, yy, yz);
    component_coefficients(b, 2, pz, zx, zy, zz);
    for (out, damping) in damping[own].iter_mut().zip(&b.damping) {
        *out = 8.0 * damping;
    }
}

/// Coefficients of component `q` of the force: the plain term, and those signed by the side along x, y, z.
#[inline(always)]
fn component_coefficients(
    b: &Block,
    q: usize,
    plain: &mut [Real],
    x: &mut [Real],
    y: &mut [Real],
    z: &mut [Real],
) {
    /// Index of a component of a symmetric tensor, by row and column.
    const INDEX: [[usize; 3]; 3] = [[0, 3, 5], [3, 1, 4], [5, 4, 2]];
    let n = plain.len().min(BLOCK);
    let (plain, x, y, z) = (&mut plain[..n], &mut x[..n], &mut y[..n], &mut z[..n]);
    let [sx, sy, sz] = [&b.trial[INDEX[q][0]], &b.trial[INDEX[q][1]], &b.trial[INDEX[q][2]]];
    let stress = |side: usize, s: Real, i: usize| if q == side { s + b.viscous[i] } else { s };
    for i in 0..n {
        let damping = b.damping[i];
        plain[i] = damping * b.plain[q][i];
        x[i] = damping * b.side[q][0][i] + b.area[0][i] * stress(0, sx[i], i);
        y[i] = damping * b.side[q][1][i] + b.area[1][i] * stress(1, sy[i], i);
        z[i] = damping * b.side[q][2][i] + b.area[2][i] * stress(2, sz[i], i);
    }
}

/// Harmonic mean of the widths of a cell [m], 0 in a ghost: close to the cube root of the volume, smaller in
/// a stretched cell, and cheaper.
#[inline(always)]
fn mean_width(hx: Real, hy: Real, hz: Real) -> Real {
    3.0 * hx * hy * hz / (hx * hy + hy * hz + hx * hz)
}
