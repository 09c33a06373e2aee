//! The Lagrangian stage for a device with a thread for each cell, node, row or plane of the grid.
//!
//! Every function is what one thread does, with the loops of the other modules on a row of one cell. It
//! writes only what is its own, so that the order of the threads changes no bit. Arrays cover the grid with
//! its ghosts, as those of the solver do; how rows and cells are to be treated is found there and handed over
//! as flags.
#![allow(unsafe_code)] // The arrays of a device are known by their addresses alone.

use super::Real;
use super::cells::{Block, CellRow, MaterialConstants, RowConstants, block_size, runs};
use super::device_arrays::Arrays;
use super::lanes::total_of_lanes;
use super::nodes::{NodeRow, finish_row, gather_forces, move_row};
use super::physics::elastic::{Elastic, Stiffening};
use super::physics::viscosity::BulkViscosity;
use super::post_remap::{close_gaps, put_back};
use super::stress::{
    corner_sums, cut_off_stress, force_coefficients, linear_trial_stress, stiffening_trial_stress,
    strained_widths,
};
use crate::exact_sum::NUMBERS;
use crate::history::{
    GAP_STRAIN, INTACT_STRENGTH, NONLOCAL_DENSITY, PLASTIC_STRAIN, PRECONSOLIDATION, STRESS_RATIO,
};
use crate::launch::{
    ACCOUNTED, INSIDE, List, MEASURED, NODES, OWNED, POWERS, PlaneSum, ROW_SUMS, STRAINED, SUMS,
};
use crate::sums::{COEFFICIENTS, NODE_SUMS};
use std::slice::{from_raw_parts, from_raw_parts_mut};

/// A material, and the law by which it yields.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Material<L> {
    kind: u8,
    stiffens: bool,
    is_after_remap: bool,
    elastic: Elastic,
    stiffening: Stiffening,
    critical_density: Real,
    densest: Real,
    loosest: Real,
    viscosity: BulkViscosity,
    hourglass: Real,
    law: L,
}

impl<L> Material<L> {
    /// The material of this kind (see [`Arrays::kind`]), to be strained, or, after a remap, to be made
    /// admissible.
    pub fn new(kind: u8, constants: &MaterialConstants, law: L, is_after_remap: bool) -> Self {
        let MaterialConstants { elastic, critical_density, densest, loosest, viscosity, hourglass, .. } =
            *constants;
        let stiffens = constants.stiffening.is_some();
        let stiffening = constants.stiffening.unwrap_or(Stiffening { least: 1.0, most: 1.0 });
        Self {
            kind,
            stiffens,
            is_after_remap,
            elastic,
            stiffening,
            critical_density,
            densest,
            loosest,
            viscosity,
            hourglass,
            law,
        }
    }

    fn constants(&self) -> MaterialConstants {
        MaterialConstants {
            elastic: self.elastic,
            stiffening: if self.stiffens { Some(self.stiffening) } else { None },
            yield_law: None,
            critical_density: self.critical_density,
            densest: self.densest,
            loosest: self.loosest,
            viscosity: self.viscosity,
            hourglass: self.hourglass,
        }
    }
}

/// A return mapping of a block of cells.
pub type ReturnMapping<L> = fn(&RowConstants, &L, &mut CellRow, &mut Block) -> usize;

/// The history variables that any soil has, as bits of their numbers.
pub const PLAIN: u32 = 1 << PLASTIC_STRAIN | 1 << GAP_STRAIN;
/// Those of sand.
pub const SAND: u32 = PLAIN | 1 << STRESS_RATIO | 1 << PRECONSOLIDATION | 1 << NONLOCAL_DENSITY;
/// Those of clay.
pub const CLAY: u32 = PLAIN | 1 << INTACT_STRENGTH;

/// Strains a cell of a law that needs this history: updates its stress, and finds the coefficients of the
/// nodal forces and its dissipation. After a remap it makes its stress admissible instead.
///
/// # Safety
/// The addresses must be those of arrays of the grid, and no other thread may have the same cell.
#[inline(always)]
pub unsafe fn strain<L, const HISTORY: u32>(
    a: &Arrays,
    material: &Material<L>,
    return_mapping: Option<ReturnMapping<L>>,
    block: &mut Block,
    thread: usize,
) {
    let c = a.range[0] + thread;
    // SAFETY: every address below is that of cell `c`, of its column, row or plane, or of one of its nodes.
    unsafe {
        if c >= a.range[1] || !is_concerned(a, material, c) {
            return;
        }
        let [row, plane] = a.stride;
        let (column, q, p) = (c % row, c % plane / row, c / plane);
        let constants = RowConstants {
            material: &material.constants(),
            hourglass_yielding: a.hourglass_yielding,
            has_cubes: a.has_cubes,
            width_x: from_raw_parts(a.width_x[0].add(column), 1),
            per_width_x: from_raw_parts(a.width_x[1].add(column), 1),
            dt: if material.is_after_remap { 0.0 } else { a.constants.dt },
        };
        let mut cells = CellRow {
            fraction: from_raw_parts(a.fraction.add(c), 1),
            mass: from_raw_parts(a.soil_mass.add(c).cast_const(), 1),
            stress: a.stress.map(|s| from_raw_parts_mut(s.add(c), 1)),
            history: std::array::from_fn(|h| {
                let is_needed = HISTORY & (1 << h) != 0;
                if is_needed { from_raw_parts_mut(a.history[h].add(c), 1) } else { Default::default() }
            }),
            width_y: *a.width_yz[0].add(q),
            width_z: *a.width_yz[1].add(p),
        };
        (block.start, block.n) = (0, 1);
        if material.is_after_remap {
            close_gaps(&constants, &cells, block);
        } else {
            trial_stress(a, material, &constants, &cells, block, c);
        }
        if let Some(return_mapping) = return_mapping {
            return_mapping(&constants, &material.law, &mut cells, block);
        }
        if material.is_after_remap {
            put_back(&mut cells, block);
            if block.bears_stress[0] <= 0.0 {
                forget::<HISTORY>(a, c);
            }
            return;
        }
        if !a.has_cubes {
            strained_widths(&constants, &cells, block);
        }
        cut_off_stress(&constants, &mut cells, block);
        force_coefficients(block, &mut a.coefficients.map(|f| from_raw_parts_mut(f.add(c), 1)));
        *a.powers[0].add(c) = block.work[0];
        *a.powers[1].add(c) = block.viscous_power[0];
        *a.powers[2].add(c) = block.damped_power[0];
    }
}

/// Trial stress of a cell.
///
/// # Safety
/// There must be such a cell.
#[inline(always)]
unsafe fn trial_stress<L>(
    a: &Arrays,
    material: &Material<L>,
    constants: &RowConstants,
    cells: &CellRow,
    block: &mut Block,
    c: usize,
) {
    let [row, plane] = a.stride;
    // SAFETY: as the caller promises.
    let nodes = [0, row, plane, row + plane]
        .map(|offset| a.velocity[1].map(|v| unsafe { from_raw_parts(v.add(c + offset).cast_const(), 2) }));
    corner_sums(&nodes, block);
    if material.stiffens {
        stiffening_trial_stress(constants, &material.stiffening, cells, block);
    } else {
        linear_trial_stress(constants, cells, block);
    }
}

/// Forgets the history variables of a cell that its own law does not need.
///
/// # Safety
/// There must be such a cell.
#[inline(always)]
unsafe fn forget<const HISTORY: u32>(a: &Arrays, c: usize) {
    for (h, field) in a.history.iter().enumerate() {
        if HISTORY & (1 << h) == 0 && !field.is_null() {
            // SAFETY: as the caller promises.
            unsafe { *field.add(c) = 0.0 };
        }
    }
}

/// Whether a cell is strained as this material, or, after a remap, lies in a row that may hold soil.
///
/// # Safety
/// There must be such a cell.
#[inline(always)]
unsafe fn is_concerned<L>(a: &Arrays, material: &Material<L>, c: usize) -> bool {
    // SAFETY: as the caller promises.
    unsafe {
        let kind = *a.kind.add(c);
        if material.is_after_remap {
            may_hold_soil(a, c) && (a.materials == 1 || kind == material.kind)
        } else {
            kind == material.kind
        }
    }
}

/// Whether this is a cell of a row that may hold soil during a remap.
///
/// # Safety
/// It must be an index in memory within the planes of the grid.
#[inline(always)]
pub(super) unsafe fn may_hold_soil(a: &Arrays, c: usize) -> bool {
    let ([row, plane], [nx, ny, nz]) = (a.stride, a.cells);
    let is_cell = (1..=nx).contains(&(c % row))
        && (1..=ny).contains(&(c % plane / row))
        && (1..=nz).contains(&(c / plane));
    // SAFETY: as the caller promises.
    is_cell && unsafe { *a.row_active.add(c / row) }
}

/// Moves a node under the forces of the eight cells round it, and measures it.
///
/// # Safety
/// The addresses must be those of arrays of the grid, and no other thread may have the same node.
#[inline(always)]
pub unsafe fn move_node(a: &Arrays, thread: usize) {
    let ([row, plane], n) = (a.stride, a.range[0] + thread);
    // SAFETY: flags are those of rows with neighbours on all sides; all other addresses are those of the node
    // or of a cell beside it.
    unsafe {
        if n >= a.range[1] || n >= a.planes * plane || !(1..=a.nodes_in_row).contains(&(n % row)) {
            return;
        }
        if *a.row_flags.add(n / row) & NODES == 0 {
            if a.clears {
                for axis in 0..3 {
                    *a.velocity[0][axis].add(n) = 0.0;
                }
            }
            return;
        }
        let (mut below, mut sum) = ([0.0; 2 * NODE_SUMS], [0.0; 2 * NODE_SUMS]);
        gather_forces([&pairs(a, n - plane - row), &pairs(a, n - plane)], [2, 1], &mut below, &mut sum);
        gather_forces([&pairs(a, n - row), &pairs(a, n)], [2, 1], &mut below, &mut sum);
        let mut nodes = NodeRow {
            mass: from_raw_parts(a.mass.add(n), 1),
            before: a.velocity[1].map(|v| from_raw_parts(v.add(n).cast_const(), 1)),
            displacement: a.displacement.map(|u| from_raw_parts_mut(u.add(n), 1)),
            velocity: a.velocity[0].map(|v| from_raw_parts_mut(v.add(n), 1)),
        };
        move_row(&a.constants, &mut nodes, &sum, 2);
        let held = *a.held.add(n);
        for axis in 0..3 {
            if held & (1 << axis) != 0 {
                nodes.velocity[axis][0] = 0.0;
            }
        }
        let mut buffer = [0.0; MEASURED];
        finish_row(&a.constants, &nodes, &mut buffer);
        for place in 0..MEASURED {
            *a.measured[place].add(n) = buffer[place];
        }
    }
}

/// Coefficients of the forces of a cell and of the one before it, as two rows of one cell and its ghost.
///
/// # Safety
/// There must be a cell before this one.
#[inline(always)]
unsafe fn pairs(a: &Arrays, cell: usize) -> [Real; 2 * COEFFICIENTS] {
    let mut out = [0.0; 2 * COEFFICIENTS];
    for place in 0..COEFFICIENTS {
        let f = a.coefficients[place];
        // SAFETY: as the caller promises.
        (out[2 * place], out[2 * place + 1]) = unsafe { (*f.add(cell - 1), *f.add(cell)) };
    }
    out
}

/// Numbers of a row that are added up in eight lanes: the first eight make room for the sums of these.
struct Series {
    start: *mut Real,
    count: usize,
}

impl Series {
    /// Adds up the numbers of a lane, or finds the largest, and leaves that in the first of them.
    ///
    /// # Safety
    /// There must be as many numbers, and no other thread may have the same lane.
    #[inline(always)]
    unsafe fn reduce(&self, lane: usize, both: impl Fn(Real, Real) -> Real) {
        if self.count >= 8 {
            // SAFETY: as the caller promises.
            unsafe {
                let each = (0..self.count / 8).map(|chunk| *self.start.add(8 * chunk + lane));
                *self.start.add(lane) = each.fold(0.0, both);
            }
        }
    }

    /// The numbers of the lanes, and those beyond the last whole vector.
    ///
    /// # Safety
    /// There must be as many numbers, and all lanes must have been reduced.
    #[inline(always)]
    unsafe fn lanes(&self) -> LanesAndTail<'_> {
        let whole = self.count / 8 * 8;
        // SAFETY: as the caller promises.
        unsafe {
            let lane = |n: usize| if whole > 0 { *self.start.add(n) } else { 0.0 };
            let tail = from_raw_parts(self.start.add(whole).cast_const(), self.count - whole);
            LanesAndTail { lanes: std::array::from_fn(lane), tail }
        }
    }
}

/// Sums of lanes, and the numbers beyond the last whole vector.
struct LanesAndTail<'a> {
    lanes: [Real; 8],
    tail: &'a [Real],
}

impl LanesAndTail<'_> {
    #[inline(always)]
    fn total(&self) -> f64 {
        total_of_lanes(self.lanes, self.tail)
    }

    #[inline(always)]
    fn most(&self) -> f64 {
        self.lanes.iter().chain(self.tail).fold(0.0, |a, b| larger(a, *b)).into()
    }
}

#[inline(always)]
fn larger(a: Real, b: Real) -> Real {
    if b > a { b } else { a }
}

/// Adds up the numbers of each lane of a row: eight threads that read what lies side by side. Threads are
/// numbered row by row, one for each lane.
///
/// # Safety
/// The addresses must be those of arrays of the grid, and no other thread may have the same number.
#[inline(always)]
pub unsafe fn sum_lane(a: &Arrays, thread: usize) {
    let ([row, plane], r, lane) = (a.stride, thread / 8, thread % 8);
    if r >= a.planes * plane / row {
        return;
    }
    // SAFETY: all addresses are those of the row; a thread has its lane for itself.
    unsafe {
        each_block(a, r, |block, _| {
            for power in &a.powers {
                block.of(power).reduce(lane, |sum, own| sum + own);
            }
        });
        if *a.row_flags.add(r) & NODES != 0 {
            for (n, measured) in a.measured.iter().enumerate() {
                let nodes = Series { start: measured.add(r * row + 1), count: a.nodes_in_row };
                nodes.reduce(lane, |so_far, own| if n < 2 { so_far + own } else { larger(so_far, own) });
            }
        }
    }
}

/// A block of cells: the first, and how many.
struct CellsOfBlock {
    first: usize,
    count: usize,
}

impl CellsOfBlock {
    #[inline(always)]
    fn of(&self, array: &*mut Real) -> Series {
        Series { start: array.wrapping_add(self.first), count: self.count }
    }
}

/// Calls `job` with the blocks of strained cells of a row, in which the processor adds up, and whether they
/// lie beyond the domain.
///
/// # Safety
/// There must be such a row.
#[inline(always)]
unsafe fn each_block(a: &Arrays, r: usize, mut job: impl FnMut(CellsOfBlock, bool)) {
    // SAFETY: as the caller promises.
    let (flags, start) = (unsafe { *a.row_flags.add(r) }, r * a.stride[0] + 1);
    if flags & STRAINED == 0 {
        return;
    }
    for (part, [first, end]) in a.columns.into_iter().enumerate() {
        // SAFETY: the columns are those of a row.
        let kinds = unsafe { from_raw_parts(a.kind.add(start).cast_const(), end) };
        for (run, _) in runs(kinds, first..end) {
            let size = block_size(run.len());
            for first in run.clone().step_by(size) {
                let block = CellsOfBlock { first: start + first, count: size.min(run.end - first) };
                job(block, part != 1 || flags & INSIDE == 0);
            }
        }
    }
}

/// Adds up what the cells and nodes of a row contribute, in the order in which the processor does, once the
/// lanes are added up.
///
/// # Safety
/// The addresses must be those of arrays of the grid, and no other thread may have the same row.
#[inline(always)]
pub unsafe fn sum_row(a: &Arrays, r: usize) {
    let [row, plane] = a.stride;
    if r >= a.planes * plane / row {
        return;
    }
    // SAFETY: all addresses are those of the row.
    unsafe {
        let mut sums = [[0.0; POWERS]; 2];
        each_block(a, r, |block, is_beyond| {
            let sums = &mut sums[usize::from(is_beyond)];
            let dt = f64::from(a.constants.dt);
            let [work, viscous, damped] = a.powers.each_ref().map(|power| block.of(power).lanes().total());
            sums[0] += work;
            sums[1] += viscous * dt;
            sums[2] += damped * dt;
        });
        let measured = |n: usize| Series { start: a.measured[n].add(r * row + 1), count: a.nodes_in_row };
        let [mut gravity, mut kinetic, mut displacement, mut light] = [0.0_f64; 4];
        if *a.row_flags.add(r) & NODES != 0 {
            (gravity, kinetic) = (measured(0).lanes().total(), measured(1).lanes().total());
            (displacement, light) = (measured(2).lanes().most(), measured(3).lanes().most());
        }
        let [[plastic, viscous, hourglass], beyond] = sums;
        let lost_beyond = beyond[0] + beyond[1] + beyond[2];
        let sums = [plastic, viscous, hourglass, gravity, kinetic, lost_beyond, displacement, light];
        for n in 0..ROW_SUMS {
            *a.row_sums[n].add(r) = sums[n];
        }
    }
}

/// Adds up one of the sums over the rows of a plane: exactly, or the largest of the displacements. Threads
/// are numbered plane by plane, one for each sum.
///
/// # Safety
/// The addresses must be those of arrays of the grid, and no other thread may have the same number.
#[inline(always)]
pub unsafe fn sum_plane(a: &Arrays, thread: usize) {
    let [row, plane] = a.stride;
    let (rows, p, n) = (plane / row, thread / ROW_SUMS, thread % ROW_SUMS);
    if p >= a.planes {
        return;
    }
    // SAFETY: all addresses are those of the plane.
    unsafe {
        let out = &mut *a.plane_sums.add(thread);
        *out = PlaneSum::default();
        let flag = if n == SUMS - 1 { ACCOUNTED } else { OWNED };
        for r in (p * rows..(p + 1) * rows).filter(|r| *a.row_flags.add(*r) & flag != 0) {
            let value = *a.row_sums[n].add(r);
            if n < SUMS {
                out.exact.add(value);
            } else if value > out.most {
                out.most = value;
            }
        }
        out.exact.carry();
    }
}

/// Adds up one digit of a sum over the planes, or finds the largest displacement. Threads are numbered sum by
/// sum, one for each digit.
///
/// # Safety
/// The addresses must be those of arrays of the grid, and no other thread may have the same number.
#[inline(always)]
pub unsafe fn total(a: &Arrays, thread: usize) {
    let (n, digit) = (thread / NUMBERS, thread % NUMBERS);
    if n >= ROW_SUMS || (n >= SUMS && digit > 0) {
        return;
    }
    // SAFETY: the addresses are those of the planes' sums and of the totals.
    unsafe {
        let each = (0..a.planes).map(|p| &*a.plane_sums.add(p * ROW_SUMS + n));
        let totals = a.totals;
        if n < SUMS {
            (*totals).numbers[n][digit] = each.map(|sum| sum.exact.digit(digit)).sum();
        } else {
            let larger = |most: f64, sum: &PlaneSum| if sum.most > most { sum.most } else { most };
            (*totals).most[n - SUMS] = each.fold(0.0, larger);
        }
    }
}

/// Takes the numbers of a node or cell on a list.
///
/// # Safety
/// The list must be one of nodes or cells of the grid, with room for all numbers.
#[inline(always)]
pub unsafe fn take(list: &List<Real>, thread: usize) {
    if thread < list.count {
        // SAFETY: as the caller promises.
        unsafe {
            let n = *list.entries.add(thread) as usize;
            for (place, array) in list.arrays.iter().take(list.numbers).enumerate() {
                *list.values.add(place * list.count + thread) = *array.add(n);
            }
        }
    }
}

/// Gives a node or cell on a list its numbers.
///
/// # Safety
/// The list must be one of nodes or cells of the grid, none of them twice, with all numbers of each.
#[inline(always)]
pub unsafe fn give(list: &List<Real>, thread: usize) {
    if thread < list.count {
        // SAFETY: as the caller promises.
        unsafe {
            let n = *list.entries.add(thread) as usize;
            for (place, array) in list.arrays.iter().take(list.numbers).enumerate() {
                *array.add(n) = *list.values.add(place * list.count + thread);
            }
        }
    }
}
