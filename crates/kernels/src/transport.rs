//! Transport along one axis: what the soil carries that crosses the faces.
//!
//! All functions work on some neighbours in a row of cells (or nodes), and read whole arrays; they write only
//! those they are given: the processor a row with its ghosts, through which nothing flows, a device one cell.
//! "Low face" of a cell is the one towards smaller coordinates; face values are kept at the cell above it,
//! those of dual faces at the node below.

use super::Real;
use super::physics::limiter::monotonised_central;
use crate::layout::{Layout, Part};
use multiversion::multiversion;
use std::ops::Range;

/// A sweep along one axis.
#[derive(Clone, Copy, Debug)]
pub struct Sweep<'a> {
    /// The grid.
    pub layout: Layout<'a>,
    /// The axis: 0, 1, 2.
    pub axis: usize,
    /// Rows that may hold soil now or after the sweep, by plane and row.
    pub row_active: &'a [bool],
}

impl Sweep<'_> {
    /// 0-based layers along y and z of a row of cells, if it is active.
    #[inline(always)]
    fn layers(&self, row: usize) -> Option<[usize; 2]> {
        self.layout.layers_of_row(row).filter(|_| self.row_active[row])
    }

    /// Calls `job(cell, its 0-based layers)` for the cells of a part of a row, if this is active.
    #[inline(always)]
    pub fn each_cell(&self, part: Part, job: impl FnMut(usize, [usize; 3])) {
        if self.row_active[part.start / self.layout.stride[1]] {
            self.layout.each_cell(part, job);
        }
    }

    /// Volume swept by the face of a cell whose lowest node is `n` [m³]: face area times the mean
    /// displacement of its four nodes.
    #[inline(always)]
    pub fn swept(&self, u: &[Real], n: usize, layers: [usize; 3]) -> f64 {
        let [first, second] = [(self.axis + 1) % 3, (self.axis + 2) % 3];
        let area = self.layout.width(first, layers[first]) * self.layout.width(second, layers[second]);
        let (a, b) = (self.layout.stride[first], self.layout.stride[second]);
        let u = |n: usize| f64::from(u[n]);
        0.25 * area * ((u(n) + u(n + a)) + (u(n + b) + u(n + a + b)))
    }

    /// Takes off what the high faces of a part of a row sweep and adds what the low ones do: new volumes of
    /// the displaced cells.
    #[inline(always)]
    pub fn undo_displacement(&self, part: Part, displacement: &[Real], cell: &mut [Real]) {
        let (first, columns) = (part.start % self.layout.stride[1], self.layout.columns(part));
        let (low, high) = (columns.start, columns.end);
        // The outermost columns have a wall across x on one side.
        let ends =
            if self.axis == 0 { [high.min(2), high.min(self.layout.cells[0].max(2))] } else { [low; 2] };
        let mut next = low;
        for end in [ends[0], ends[1], high] {
            if next < end {
                let own = next - first..end - first;
                self.undo_columns(part.start - first, next..end, displacement, &mut cell[own]);
                next = end;
            }
        }
    }

    /// [`Sweep::undo_displacement`] in some columns of the row that begins at `start`. Nothing is swept by
    /// the walls of the box: of the columns beside one across x, each must come alone.
    #[inline(always)]
    fn undo_columns(&self, start: usize, columns: Range<usize>, displacement: &[Real], cell: &mut [Real]) {
        let Self { layout, axis, .. } = *self;
        let Some([j, k]) = self.layers(start / layout.stride[1]) else { return };
        let [lowest, highest] = [[columns.start - 1, columns.end - 2], [j, j], [k, k]][axis];
        let four = |open: bool, n: usize| {
            let [a, b] = [(axis + 1) % 3, (axis + 2) % 3].map(|other| layout.stride[other]);
            // The lowest plane is all ghosts, which do not move.
            [0, a, b, a + b].map(|corner| if open { n + corner } else { 0 })
        };
        let swept = |starts: [usize; 4]| starts.map(|n| &displacement[n..n + columns.len()]);
        let (c, s) = (start + columns.start, layout.stride[axis]);
        let faces = [four(lowest > 0, c), four(highest + 1 < layout.cells[axis], c + s)].map(swept);
        let across = match axis {
            0 => layout.width(1, j) * layout.width(2, k),
            1 => layout.width(2, k),
            _ => layout.width(1, j),
        };
        let x_faces = &layout.faces[0][columns.start - 1..columns.end];
        undo_row(faces, (axis > 0).then_some(x_faces), across, cell);
    }

    /// How far along its slope, in cells, the value carried through the low faces of a part of a row lies
    /// from the middle of the donor: half of what the flux leaves behind; 0 where the donor is not full or a
    /// neighbour holds little soil.
    #[inline(always)]
    pub fn reaches(&self, part: Part, [flux, fraction, soil]: [&[Real]; 3], out: &mut [Real]) {
        if let Some(row) = self.active(part) {
            reach_row(row.of(flux), row.round(fraction), row.round(soil), out);
        }
    }

    /// Mass that crosses the low faces of a part of a row [kg], with `soil` volumes as they were before the
    /// sweep.
    #[inline(always)]
    pub fn mass_fluxes(
        &self,
        part: Part,
        [soil, mass]: [&[Real]; 2],
        [flux, reach]: [&[Real]; 2],
        out: &mut [Real],
    ) {
        match self.active(part) {
            Some(row) => mass_row(row.of(flux), row.of(reach), row.round(mass), row.round(soil), out),
            None => out.fill(0.0),
        }
    }

    /// New value of a carried field in a part of a row, with `soil` volumes as they were before the sweep.
    #[inline(always)]
    pub fn carry(
        &self,
        part: Part,
        [soil, field]: [&[Real]; 2],
        [flux, reach]: [&[Real]; 2],
        out: &mut [Real],
    ) {
        match self.active(part) {
            Some(row) => {
                let faces = [row.of(flux), row.above(flux), row.of(reach), row.above(reach)];
                carry_row(faces, row.round(field), row.of(soil), out);
            }
            None => out.copy_from_slice(&field[part.start..part.start + part.length]),
        }
    }

    /// Takes off what flows out through the high faces of a part of a row and adds what flows in through the
    /// low ones.
    #[inline(always)]
    pub fn difference(&self, part: Part, face: &[Real], out: &mut [Real]) {
        if let Some(row) = self.active(part) {
            for ((value, low), high) in out.iter_mut().zip(row.of(face)).zip(row.above(face)) {
                *value -= high - low;
            }
        }
    }

    /// Mass that crosses the dual faces between a node and the next along the axis [kg], for a part of a row
    /// of nodes.
    #[inline(always)]
    pub fn dual_fluxes(&self, part: Part, mass_flux: &[Real], out: &mut [Real]) {
        let Self { layout, axis, .. } = *self;
        let [_, plane] = layout.row_and_plane(part.start / layout.stride[1]);
        let Some(row) = self.of_nodes(part).filter(|_| axis < 2 || plane <= layout.cells[2]) else {
            out.fill(0.0);
            return;
        };
        let [a, b] = [layout.stride[(axis + 1) % 3], layout.stride[(axis + 2) % 3]];
        let pair = |back: usize| {
            let row = Row { part: Part { start: part.start - back, ..part }, ..row };
            [row.of(mass_flux), row.above(mass_flux)]
        };
        dual_flux_row([pair(0), pair(a), pair(b), pair(a + b)], out);
    }

    /// How far the flux of a donor reaches, like [`Sweep::reaches`], for the dual faces above a part of a row
    /// of nodes: 0 where a neighbour of the donor has no mass.
    #[inline(always)]
    pub fn dual_reaches(&self, part: Part, [mass, flux]: [&[Real]; 2], mass_moved: Real, out: &mut [Real]) {
        if let Some(row) = self.of_nodes(part) {
            dual_reach_row(row.of(flux), row.round(mass), mass_moved, out);
        }
    }

    /// New masses of a part of a row of nodes after the dual fluxes.
    #[inline(always)]
    pub fn carry_mass(&self, part: Part, flux: &[Real], out: &mut [Real]) {
        if let Some(row) = self.of_nodes(part) {
            for ((mass, low), high) in out.iter_mut().zip(row.below(flux)).zip(row.of(flux)) {
                *mass -= high - low;
            }
        }
    }

    /// New velocity component of a part of a row of nodes after the dual fluxes have carried momentum.
    #[inline(always)]
    pub fn carry_momentum(&self, part: Part, [velocity, mass, flux, reach]: [&[Real]; 4], out: &mut [Real]) {
        match self.of_nodes(part) {
            Some(row) => {
                let faces = [row.below(flux), row.of(flux), row.below(reach), row.of(reach)];
                momentum_row(faces, row.round(velocity), row.of(mass), out);
            }
            None => out.copy_from_slice(&velocity[part.start..part.start + part.length]),
        }
    }

    /// A part of a row of cells with its neighbours, if it is active.
    #[inline(always)]
    fn active(&self, part: Part) -> Option<Row> {
        self.layers(part.start / self.layout.stride[1]).map(|_| Row::new(self, part))
    }

    /// A part of a row of nodes with its neighbours, if it is one.
    #[inline(always)]
    fn of_nodes(&self, part: Part) -> Option<Row> {
        let [q, _] = self.layout.row_and_plane(part.start / self.layout.stride[1]);
        (1..=self.layout.cells[1] + 1).contains(&q).then(|| Row::new(self, part))
    }
}

/// A part of a row of cells or nodes and its neighbours along an axis.
#[derive(Clone, Copy)]
struct Row {
    part: Part,
    /// Columns before the part.
    before: usize,
    /// Distance between neighbours along the axis, between rows, between planes.
    stride: usize,
    row: usize,
    plane: usize,
}

impl Row {
    #[inline(always)]
    fn new(sweep: &Sweep, part: Part) -> Self {
        let stride = sweep.layout.stride;
        let before = part.start % stride[1];
        Self { part, before, stride: stride[sweep.axis], row: stride[1], plane: stride[2] }
    }

    /// The part of an array from `start` on; where a whole row would reach beyond the array, that of the
    /// lowest plane, which is all ghosts.
    #[inline(always)]
    fn at(self, array: &[Real], start: Option<usize>) -> &[Real] {
        let in_array = |s: &usize| s + self.row <= array.len() + self.before;
        let start = start.filter(in_array).unwrap_or_else(|| self.part.start % self.plane);
        &array[start..start + self.part.length]
    }

    #[inline(always)]
    fn of(self, array: &[Real]) -> &[Real] {
        self.at(array, Some(self.part.start))
    }

    #[inline(always)]
    fn above(self, array: &[Real]) -> &[Real] {
        self.at(array, Some(self.part.start + self.stride))
    }

    #[inline(always)]
    fn below(self, array: &[Real]) -> &[Real] {
        self.at(array, self.part.start.checked_sub(self.stride))
    }

    /// The parts from two below to two above.
    #[inline(always)]
    fn round(self, array: &[Real]) -> [&[Real]; 5] {
        let (start, s) = (self.part.start, self.stride);
        [
            self.at(array, start.checked_sub(2 * s)),
            self.at(array, start.checked_sub(s)),
            self.at(array, Some(start)),
            self.at(array, Some(start + s)),
            self.at(array, Some(start + 2 * s)),
        ]
    }
}

/// Value carried over a face by `flux`, from the values in the two cells below it and the two above: the
/// donor's, moved by `reach` of its limited slope.
#[inline(always)]
fn carried([far_low, low, high, far_high]: [Real; 4], flux: Real, reach: Real) -> Real {
    let forward = flux > 0.0;
    let own = if forward { low } else { high };
    let behind = if forward { low - far_low } else { high - low };
    let ahead = if forward { high - low } else { far_high - high };
    own + reach * monotonised_central(behind, ahead)
}

/// Takes off the volumes swept by the high faces of a row and adds those by the low ones; the faces' areas
/// are `across` times the widths along x, if there are any.
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
        let swept_fraction = flux[i].abs() / volume;
        out[i] = if smooth { side * (1.0 - swept_fraction) } else { 0.0 };
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

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn dual_reach_row(flux: &[Real], mass: [&[Real]; 5], mass_moved: Real, out: &mut [Real]) {
    let n = out.len();
    let ([_, m0, m1, m2, m3], flux) = (mass.map(|m| &m[..n]), &flux[..n]);
    for i in 0..n {
        let forward = flux[i] > 0.0;
        let (up, donor, down) = if forward { (m0[i], m1[i], m2[i]) } else { (m3[i], m2[i], m1[i]) };
        let smooth = (up > mass_moved) & (down > mass_moved);
        let fraction = flux[i].abs() / donor;
        let side = if forward { 0.5 } else { -0.5 };
        out[i] = if smooth { side * (1.0 - if fraction < 1.0 { fraction } else { 1.0 }) } else { 0.0 };
    }
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
