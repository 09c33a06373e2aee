//! Transport along one axis: what the soil carries that crosses the faces.
//!
//! All functions work on one plane of cells (or nodes) and read whole arrays; they write only the plane they are given.
//! "Low face" of a cell is the one towards smaller coordinates; face values are kept at the cell above it, those of dual
//! faces at the node below. Rows are gone through with their ghosts, through which nothing flows.

use super::Real;
use super::physics::limiter::monotonised_central;
use crate::grid::Grid;
use multiversion::multiversion;

/// A sweep along one axis.
#[derive(Clone, Copy)]
pub(crate) struct Sweep<'a> {
    pub(crate) grid: &'a Grid,
    /// The axis: 0, 1, 2.
    pub(crate) axis: usize,
    /// Rows that may hold soil now or after the sweep, by plane and row.
    pub(crate) row_active: &'a [bool],
}

impl Sweep<'_> {
    /// Calls `job(cell, [i, j])` for the active cells (0-based layers along x and y) of a storage plane.
    pub(crate) fn each_cell(&self, plane: usize, mut job: impl FnMut(usize, [usize; 2])) {
        let [nx, ny, nz] = self.grid.cells();
        let [_, row, stride] = self.grid.stride;
        if plane > nz {
            return;
        }
        for j in 0..ny {
            if self.row_active[plane * (stride / row) + j + 1] {
                let start = plane * stride + (j + 1) * row + 1;
                for i in 0..nx {
                    job(start + i, [i, j]);
                }
            }
        }
    }

    /// Volume swept by the face of a cell whose lowest node is `n` [m³]: face area times the mean displacement of its four
    /// nodes.
    #[inline(always)]
    pub(crate) fn swept(&self, u: &[Real], n: usize, plane: usize, [i, j]: [usize; 2]) -> f64 {
        let [first, second] = [(self.axis + 1) % 3, (self.axis + 2) % 3];
        let layers = [i, j, plane - 1];
        let area = self.grid.width(first, layers[first]) * self.grid.width(second, layers[second]);
        let (a, b) = (self.grid.stride[first], self.grid.stride[second]);
        let u = |n: usize| f64::from(u[n]);
        0.25 * area * ((u(n) + u(n + a)) + (u(n + b) + u(n + a + b)))
    }

    /// Takes off what the high faces of a plane of cells sweep and adds what the low ones do: new volumes of the displaced
    /// cells.
    pub(crate) fn undo_displacement(&self, plane: usize, displacement: &[Real], cell: &mut [Real]) {
        let Self { grid, axis, .. } = *self;
        let ([nx, ny, nz], [_, row, base]) = (grid.cells(), grid.stride);
        let base = plane * base;
        // Nothing is swept by the walls of the box; those across x are at the ends of the rows.
        let ends = usize::from(axis == 0);
        let (own, x_faces) = (ends..nx - ends, &grid.faces[0][ends..=nx - ends]);
        for j in (0..ny).filter(|j| plane <= nz && self.row_active[(base + (j + 1) * row) / row]) {
            let (start, layer) = (base + (j + 1) * row + 1, [ends, j, plane - 1][axis]);
            let four = |open: bool, n: usize| {
                let [a, b] = [(axis + 1) % 3, (axis + 2) % 3].map(|other| grid.stride[other]);
                // The lowest plane is all ghosts, which do not move.
                [0, a, b, a + b].map(|corner| if open { n + corner } else { 0 })
            };
            let swept = |places: [usize; 4]| places.map(|n| &displacement[n..n + own.len()]);
            let (c, s) = (start + own.start, grid.stride[axis]);
            let faces = [four(layer > 0, c), four(layer + 1 < grid.cells()[axis], c + s)].map(swept);
            let across = match axis {
                0 => grid.width(1, j) * grid.width(2, plane - 1),
                1 => grid.width(2, plane - 1),
                _ => grid.width(1, j),
            };
            undo_row(faces, (axis > 0).then_some(x_faces), across, &mut cell[c - base..][..own.len()]);
            if axis == 0 {
                let [first, last] = [start, start + nx - 1];
                cell[first - base] -= self.swept(displacement, first + 1, plane, [0, j]) as Real;
                cell[last - base] += self.swept(displacement, last, plane, [nx - 1, j]) as Real;
            }
        }
    }

    /// How far along its slope, in cells, the value carried through the low faces of a plane lies from the middle of the
    /// donor: half of what the flux leaves behind; 0 where the donor is not full or a neighbour holds little soil.
    pub(crate) fn reaches(&self, plane: usize, [flux, fraction, soil]: [&[Real]; 3], out: &mut [Real]) {
        self.each_row(plane, out, |row, own| {
            reach_row(row.of(flux), row.round(fraction), row.round(soil), own)
        });
    }

    /// Mass that crosses the low faces of a plane of cells [kg], with `soil` volumes as they were before the sweep.
    pub(crate) fn mass_fluxes(
        &self,
        plane: usize,
        [soil, mass]: [&[Real]; 2],
        [flux, reach]: [&[Real]; 2],
        out: &mut [Real],
    ) {
        self.each_row(plane, out, |row, own| {
            mass_row(row.of(flux), row.of(reach), row.round(mass), row.round(soil), own)
        });
    }

    /// New value of a carried field in a plane of cells, with `soil` volumes as they were before the sweep.
    pub(crate) fn carry(
        &self,
        plane: usize,
        [soil, field]: [&[Real]; 2],
        [flux, reach]: [&[Real]; 2],
        out: &mut [Real],
    ) {
        let base = plane * self.grid.stride[2];
        out.copy_from_slice(&field[base..base + out.len()]);
        self.each_row(plane, out, |row, own| {
            let faces = [row.of(flux), row.above(flux), row.of(reach), row.above(reach)];
            carry_row(faces, row.round(field), row.of(soil), own);
        });
    }

    /// Calls `job(row, part of out)` for the active rows of a storage plane of cells.
    fn each_row(&self, plane: usize, out: &mut [Real], job: impl Fn(Row, &mut [Real])) {
        let [_, ny, nz] = self.grid.cells();
        let [_, row, stride] = self.grid.stride;
        for q in (1..=ny).filter(|q| plane <= nz && self.row_active[plane * (stride / row) + q]) {
            job(Row::new(self.grid, self.axis, [q, plane]), &mut out[q * row..(q + 1) * row]);
        }
    }
}

/// A row of cells or nodes and its neighbours along an axis.
#[derive(Clone, Copy)]
struct Row {
    start: usize,
    length: usize,
    stride: usize,
    plane: usize,
}

impl Row {
    fn new(grid: &Grid, axis: usize, [q, plane]: [usize; 2]) -> Self {
        let [_, length, stride] = grid.stride;
        Self { start: plane * stride + q * length, length, stride: grid.stride[axis], plane: stride }
    }

    /// The row of an array at a place; beyond the array that of the lowest plane, which is all ghosts.
    fn at(self, array: &[Real], start: Option<usize>) -> &[Real] {
        let start = start.filter(|s| s + self.length <= array.len()).unwrap_or(self.start % self.plane);
        &array[start..start + self.length]
    }

    fn of(self, array: &[Real]) -> &[Real] {
        self.at(array, Some(self.start))
    }

    fn above(self, array: &[Real]) -> &[Real] {
        self.at(array, Some(self.start + self.stride))
    }

    fn below(self, array: &[Real]) -> &[Real] {
        self.at(array, self.start.checked_sub(self.stride))
    }

    /// The rows from two below to two above.
    fn round(self, array: &[Real]) -> [&[Real]; 5] {
        let (start, s) = (self.start, self.stride);
        let places = [start.checked_sub(2 * s), start.checked_sub(s)].into_iter();
        let mut places = places.chain([start, start + s, start + 2 * s].map(Some));
        std::array::from_fn(|_| self.at(array, places.next().flatten()))
    }
}

/// Value carried over a face by `flux`, from the values in the two cells below it and the two above: the donor's, moved
/// by `reach` of its limited slope.
#[inline(always)]
fn carried([far_low, low, high, far_high]: [Real; 4], flux: Real, reach: Real) -> Real {
    let forward = flux > 0.0;
    let own = if forward { low } else { high };
    let behind = if forward { low - far_low } else { high - low };
    let ahead = if forward { high - low } else { far_high - high };
    own + reach * monotonised_central(behind, ahead)
}

/// Takes off the volumes swept by the high faces of a row and adds those by the low ones; the faces' areas are `across` times
/// the widths along x, if there are any.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn undo_row([low, high]: [[&[Real]; 4]; 2], x_faces: Option<&[f64]>, across: f64, cell: &mut [Real]) {
    let n = cell.len();
    let ([l0, l1, l2, l3], [h0, h1, h2, h3]) = (low.map(|u| &u[..n]), high.map(|u| &u[..n]));
    let mut undo = |i: usize, area: f64| {
        let low = [f64::from(l0[i]), f64::from(l1[i]), f64::from(l2[i]), f64::from(l3[i])];
        let high = [f64::from(h0[i]), f64::from(h1[i]), f64::from(h2[i]), f64::from(h3[i])];
        let swept = |u: [f64; 4]| 0.25 * area * ((u[0] + u[1]) + (u[2] + u[3]));
        cell[i] -= (swept(high) - swept(low)) as Real;
    };
    match x_faces.map(|x| &x[..=n]) {
        Some(x) => (0..n).for_each(|i| undo(i, (x[i + 1] - x[i]) * across)),
        None => (0..n).for_each(|i| undo(i, across)),
    }
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn reach_row(flux: &[Real], fraction: [&[Real]; 5], soil: [&[Real]; 5], out: &mut [Real]) {
    let n = out.len();
    let ([f0, f1, f2, f3, _], [_, v1, v2, ..]) = (fraction.map(|f| &f[..n]), soil.map(|v| &v[..n]));
    let flux = &flux[..n];
    for i in 0..n {
        let forward = flux[i] > 0.0;
        let (up, donor, down) = if forward { (f0[i], f1[i], f2[i]) } else { (f3[i], f2[i], f1[i]) };
        let smooth = (donor > 0.99) & (up > 0.5) & (down > 0.5);
        let (volume, side) = if forward { (v1[i], 0.5) } else { (v2[i], -0.5) };
        let share = flux[i].abs() / volume;
        out[i] = if smooth { side * (1.0 - share) } else { 0.0 };
    }
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn mass_row(flux: &[Real], reach: &[Real], mass: [&[Real]; 5], soil: [&[Real]; 5], out: &mut [Real]) {
    let n = out.len();
    let (flux, reach) = (&flux[..n], &reach[..n]);
    let ([m0, m1, m2, m3, _], [v0, v1, v2, v3, _]) = (mass, soil);
    let (m0, m1, m2, m3) = (&m0[..n], &m1[..n], &m2[..n], &m3[..n]);
    let (v0, v1, v2, v3) = (&v0[..n], &v1[..n], &v2[..n], &v3[..n]);
    let density = |mass: Real, volume: Real| if volume > 0.0 { mass / volume } else { 0.0 };
    for i in 0..n {
        let densities =
            [density(m0[i], v0[i]), density(m1[i], v1[i]), density(m2[i], v2[i]), density(m3[i], v3[i])];
        out[i] = flux[i] * carried(densities, flux[i], reach[i]);
    }
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn carry_row(faces: [&[Real]; 4], field: [&[Real]; 5], soil: &[Real], out: &mut [Real]) {
    let n = out.len();
    let ([low, high, reach_low, reach_high], [q0, q1, q2, q3, q4]) = (faces, field);
    let (low, high, reach_low, reach_high) = (&low[..n], &high[..n], &reach_low[..n], &reach_high[..n]);
    let (q0, q1, q2, q3, q4, soil) = (&q0[..n], &q1[..n], &q2[..n], &q3[..n], &q4[..n], &soil[..n]);
    for i in 0..n {
        let into = low[i] * carried([q0[i], q1[i], q2[i], q3[i]], low[i], reach_low[i]);
        let out_of = high[i] * carried([q1[i], q2[i], q3[i], q4[i]], high[i], reach_high[i]);
        let left = soil[i] - (high[i] - low[i]);
        let new = if left > 0.0 { (q2[i] * soil[i] - (out_of - into)) / left } else { 0.0 };
        let still = (low[i] == 0.0) & (high[i] == 0.0);
        out[i] = if still { q2[i] } else { new };
    }
}

/// Takes off what flows out through the high faces of a plane and adds what flows in through the low ones.
pub(crate) fn difference(grid: &Grid, axis: usize, plane: usize, face: &[Real], out: &mut [Real]) {
    let (base, s) = (plane * grid.stride[2], grid.stride[axis]);
    let n = out.len().min(face.len() - base - s);
    let (low, high) = (&face[base..base + n], &face[base + s..base + s + n]);
    for ((value, low), high) in out.iter_mut().zip(low).zip(high) {
        *value -= high - low;
    }
}

/// Calls `job(row, part of out)` for the rows of nodes in a storage plane.
fn each_node_row(grid: &Grid, axis: usize, plane: usize, out: &mut [Real], job: impl Fn(Row, &mut [Real])) {
    let row = grid.stride[1];
    for q in 1..=grid.cells()[1] + 1 {
        job(Row::new(grid, axis, [q, plane]), &mut out[q * row..(q + 1) * row]);
    }
}

/// Mass that crosses the dual faces between node `n` and the next along the axis [kg], for a plane of nodes.
pub(crate) fn dual_fluxes(grid: &Grid, axis: usize, plane: usize, mass_flux: &[Real], out: &mut [Real]) {
    out.fill(0.0);
    if axis == 2 && plane > grid.cells()[2] {
        return;
    }
    let [a, b] = [grid.stride[(axis + 1) % 3], grid.stride[(axis + 2) % 3]];
    each_node_row(grid, axis, plane, out, |row, own| {
        let pair = |back: usize| {
            let row = Row { start: row.start - back, ..row };
            [row.of(mass_flux), row.above(mass_flux)]
        };
        dual_flux_row([pair(0), pair(a), pair(b), pair(a + b)], own);
    });
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn dual_flux_row(faces: [[&[Real]; 2]; 4], out: &mut [Real]) {
    let n = out.len();
    let [[a0, a1], [b0, b1], [c0, c1], [d0, d1]] = faces;
    let (a0, a1, b0, b1) = (&a0[..n], &a1[..n], &b0[..n], &b1[..n]);
    let (c0, c1, d0, d1) = (&c0[..n], &c1[..n], &d0[..n], &d1[..n]);
    for i in 0..n {
        out[i] = 0.125 * (((a0[i] + a1[i]) + (b0[i] + b1[i])) + ((c0[i] + c1[i]) + (d0[i] + d1[i])));
    }
}

/// As [`Sweep::reaches`] for the dual faces above a plane of nodes: 0 where a neighbour of the donor has no mass.
pub(crate) fn dual_reaches(
    grid: &Grid,
    axis: usize,
    plane: usize,
    [mass, flux]: [&[Real]; 2],
    mass_moved: Real,
    out: &mut [Real],
) {
    each_node_row(grid, axis, plane, out, |row, own| {
        dual_reach_row(row.of(flux), row.round(mass), mass_moved, own);
    });
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn dual_reach_row(flux: &[Real], mass: [&[Real]; 5], mass_moved: Real, out: &mut [Real]) {
    let n = out.len();
    let ([_, m0, m1, m2, m3], flux) = (mass.map(|m| &m[..n]), &flux[..n]);
    for i in 0..n {
        let forward = flux[i] > 0.0;
        let (up, donor, down) = if forward { (m0[i], m1[i], m2[i]) } else { (m3[i], m2[i], m1[i]) };
        let smooth = (up > mass_moved) & (down > mass_moved);
        let share = flux[i].abs() / donor;
        let side = if forward { 0.5 } else { -0.5 };
        out[i] = if smooth { side * (1.0 - if share < 1.0 { share } else { 1.0 }) } else { 0.0 };
    }
}

/// New masses of a plane of nodes after the dual fluxes.
pub(crate) fn carry_mass(grid: &Grid, axis: usize, plane: usize, flux: &[Real], out: &mut [Real]) {
    each_node_row(grid, axis, plane, out, |row, own| {
        for ((mass, low), high) in own.iter_mut().zip(row.below(flux)).zip(row.of(flux)) {
            *mass -= high - low;
        }
    });
}

/// New velocity component of a plane of nodes after the dual fluxes have carried momentum.
pub(crate) fn carry_momentum(
    grid: &Grid,
    axis: usize,
    plane: usize,
    [velocity, mass, flux, reach]: [&[Real]; 4],
    out: &mut [Real],
) {
    let base = plane * grid.stride[2];
    out.copy_from_slice(&velocity[base..base + out.len()]);
    each_node_row(grid, axis, plane, out, |row, own| {
        let faces = [row.below(flux), row.of(flux), row.below(reach), row.of(reach)];
        momentum_row(faces, row.round(velocity), row.of(mass), own);
    });
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn momentum_row(faces: [&[Real]; 4], velocity: [&[Real]; 5], mass: &[Real], out: &mut [Real]) {
    let n = out.len();
    let ([low, high, reach_low, reach_high], [v0, v1, v2, v3, v4]) = (faces, velocity);
    let (low, high, reach_low, reach_high) = (&low[..n], &high[..n], &reach_low[..n], &reach_high[..n]);
    let (v0, v1, v2, v3, v4, mass) = (&v0[..n], &v1[..n], &v2[..n], &v3[..n], &v4[..n], &mass[..n]);
    let least = |a: Real, b: Real| if b < a { b } else { a };
    let most = |a: Real, b: Real| if b > a { b } else { a };
    for i in 0..n {
        let into = carried([v0[i], v1[i], v2[i], v3[i]], low[i], reach_low[i]);
        let out_of = carried([v1[i], v2[i], v3[i], v4[i]], high[i], reach_high[i]);
        let left = mass[i] - (high[i] - low[i]);
        let old = v2[i];
        let new = if left > 0.0 { (mass[i] * old - (high[i] * out_of - low[i] * into)) / left } else { 0.0 };
        // Where more flows out than there was, rounding decides: stay within what flowed in.
        let overdrawn = most(high[i], 0.0) - least(low[i], 0.0) > 0.5 * mass[i];
        let (a, b) = (if low[i] > 0.0 { into } else { old }, if high[i] < 0.0 { out_of } else { old });
        let (floor, ceiling) = (least(least(old, a), b), most(most(old, a), b));
        let bounded = least(most(new, floor), ceiling);
        let still = (low[i] == 0.0) & (high[i] == 0.0);
        out[i] = if still {
            old
        } else if overdrawn {
            bounded
        } else {
            new
        };
    }
}
