//! The Lagrangian stage for a device with a thread for each cell, node, row or plane of the grid.
//!
//! Every function is what one thread does, with the loops of the other modules on a row of one cell. It
//! writes only what is its own, so that the order of the threads changes no bit. Arrays cover the grid with
//! its ghosts, as those of the solver do; how rows and cells are to be treated is found there and handed over
//! as flags.
#![allow(unsafe_code)] // The arrays of a device are known by their addresses alone.

use super::Real;
use super::cells::{Block, CellRow, MaterialConstants, RowConstants, block_size, runs};
use super::device_remap::{
    Averaging, Closed, Elasticity, Pass, carry, carry_mass, carry_momentum, close, collect_density,
    difference, displaced_volumes, dual_flux, dual_reach, mass_flux, new_fractions, nodal_mass, reach,
    row_energies, shift, spread_density, stop_massless, store_density, take_back, undo_displacement,
    volume_flux, volume_fraction,
};
use super::lanes::{lane_max, lane_sum};
use super::nodes::{NodeConstants, NodeRow, finish_row, gather_forces, move_row};
use super::physics::clay::Clay;
use super::physics::elastic::{Elastic, Stiffening};
use super::physics::menetrey_willam::MenetreyWillam;
use super::physics::mohr_coulomb::MohrCoulomb;
use super::physics::sand::Sand;
use super::physics::viscosity::BulkViscosity;
use super::physics::von_mises::VonMises;
use super::post_remap::{close_gaps, put_back};
use super::return_mapping::{clay, menetrey_willam, mohr_coulomb, sand, von_mises};
use super::stress::{
    corner_sums, cut_off_stress, force_coefficients, linear_trial_stress, stiffening_trial_stress,
    strained_widths,
};
use crate::exact_sum::NUMBERS;
use crate::history::{
    GAP_STRAIN, HISTORY_COUNT, INTACT_STRENGTH, NONLOCAL_DENSITY, PLASTIC_STRAIN, PRECONSOLIDATION,
    STRESS_RATIO,
};
use crate::launch::{
    ACCOUNTED, INSIDE, Kernel, List, MEASURED, NODES, OWNED, POWERS, PlaneSum, ROW_SUMS, STRAINED, SUMS,
    Totals,
};
use crate::sums::{COEFFICIENTS, NODE_SUMS};
use std::ops::Range;
use std::slice::{from_raw_parts, from_raw_parts_mut};

/// Addresses of the arrays on the device, and constants of all cells and nodes.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Arrays {
    /// Numbers in an array with its ghosts.
    pub entries: usize,
    /// Numbers in a row, and in a plane.
    pub stride: [usize; 2],
    /// Planes of the memory.
    pub planes: usize,
    /// Number of cells along x, y, z.
    pub cells: [usize; 3],
    /// Positions of their faces [m].
    pub faces: [*const f64; 3],
    /// Columns of the domain.
    pub inside: [usize; 2],
    /// Rows that may hold soil during a remap.
    pub row_active: *const bool,
    /// Nodes of a row that move.
    pub nodes_in_row: usize,
    /// Columns that are strained, in three parts: of these the outer two lie beyond the domain.
    pub columns: [[usize; 2]; 3],
    /// Constants of the nodes.
    pub constants: NodeConstants,
    /// Fraction of the hourglass viscosity that acts in yielding cells.
    pub hourglass_yielding: Real,
    /// Whether the cells of the fine zone are cubes.
    pub has_cubes: bool,
    /// Whether velocities must still be set to zero where there is no soil.
    pub clears: bool,
    /// How a row is treated: [`STRAINED`] and the other flags.
    pub row_flags: *const u8,
    /// Number of a cell's material, from 1 on; 0 for a cell that is not strained.
    pub kind: *const u8,
    /// Which components of a node's velocity boundaries hold: one bit for each.
    pub held: *const u8,
    /// Widths of the columns [m], 0 in ghosts, and ¼ of their inverses.
    pub width_x: [*const Real; 2],
    /// Widths of the rows of a plane, and of the planes [m].
    pub width_yz: [*const Real; 2],
    /// Volume fractions.
    pub fraction: *const Real,
    /// Masses of the cells [kg], as if all soil of a cell were of its main material.
    pub soil_mass: *const Real,
    /// Masses of the nodes [kg].
    pub mass: *const Real,
    /// Stresses [Pa].
    pub stress: [*mut Real; 6],
    /// History variables; null where no material needs them.
    pub history: [*mut Real; HISTORY_COUNT],
    /// Velocities half a step ahead, half a step ago [m/s].
    pub velocity: [[*mut Real; 3]; 2],
    /// Displacements since the last remap [m].
    pub displacement: [*mut Real; 3],
    /// Coefficients of the nodal forces; zero where a cell is not strained.
    pub coefficients: [*mut Real; COEFFICIENTS],
    /// Dissipation of the cells: plastic work [J], by bulk viscosity and by hourglass viscosity [W].
    pub powers: [*mut Real; POWERS],
    /// Work of gravity [J], kinetic energy [J] and largest displacements [m], heavy and light, of the nodes.
    pub measured: [*mut Real; MEASURED],
    /// Sums over the rows.
    pub row_sums: [*mut f64; ROW_SUMS],
    /// Sums over the rows of each plane.
    pub plane_sums: *mut PlaneSum,
    /// Sums over all rows.
    pub totals: *mut Totals,
}

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
    c: usize,
) {
    // SAFETY: every address below is that of cell `c`, of its column, row or plane, or of one of its nodes.
    unsafe {
        if c >= a.entries || !is_concerned(a, material, c) {
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
            mass: from_raw_parts(a.soil_mass.add(c), 1),
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
            let nodes = [0, row, plane, row + plane]
                .map(|offset| a.velocity[1].map(|v| from_raw_parts(v.add(c + offset).cast_const(), 2)));
            corner_sums(&nodes, block);
            if material.stiffens {
                stiffening_trial_stress(&constants, &material.stiffening, &cells, block);
            } else {
                linear_trial_stress(&constants, &cells, block);
            }
        }
        if let Some(return_mapping) = return_mapping {
            return_mapping(&constants, &material.law, &mut cells, block);
        }
        if material.is_after_remap {
            put_back(&mut cells, block);
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

/// Whether a cell is strained as this material, or, after a remap, lies in a row that may hold soil.
///
/// # Safety
/// There must be such a cell.
#[inline(always)]
unsafe fn is_concerned<L>(a: &Arrays, material: &Material<L>, c: usize) -> bool {
    let [row, plane] = a.stride;
    let (column, q, p) = (c % row, c % plane / row, c / plane);
    let [nx, ny, nz] = a.cells;
    // SAFETY: as the caller promises.
    unsafe {
        if material.is_after_remap {
            let is_cell = (1..=nx).contains(&column) && (1..=ny).contains(&q) && (1..=nz).contains(&p);
            is_cell && *a.row_active.add(c / row)
        } else {
            *a.kind.add(c) == material.kind
        }
    }
}

/// Moves a node under the forces of the eight cells round it, and measures it.
///
/// # Safety
/// The addresses must be those of arrays of the grid, and no other thread may have the same node.
#[inline(always)]
pub unsafe fn move_node(a: &Arrays, n: usize) {
    let [row, plane] = a.stride;
    // SAFETY: flags are those of rows with neighbours on all sides; all other addresses are those of the node
    // or of a cell beside it.
    unsafe {
        if n >= a.planes * plane || !(1..=a.nodes_in_row).contains(&(n % row)) {
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

/// Adds up what the cells and nodes of a row contribute, in the order in which the processor does.
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
        let flags = *a.row_flags.add(r);
        let start = r * row + 1;
        let mut own = [0.0; POWERS];
        let mut beyond = [0.0; POWERS];
        if flags & STRAINED != 0 {
            for (part, [first, end]) in a.columns.into_iter().enumerate() {
                let kinds = from_raw_parts(a.kind.add(start), end);
                for (run, _) in runs(kinds, first..end) {
                    let is_beyond = part != 1 || flags & INSIDE == 0;
                    add_run(a, start, run, if is_beyond { &mut beyond } else { &mut own });
                }
            }
        }
        let measured = |n: usize| from_raw_parts(a.measured[n].add(start).cast_const(), a.nodes_in_row);
        let [mut gravity, mut kinetic, mut displacement, mut light] = [0.0_f64; 4];
        if flags & NODES != 0 {
            (gravity, kinetic) = (lane_sum(measured(0)), lane_sum(measured(1)));
            (displacement, light) = (lane_max(measured(2)).into(), lane_max(measured(3)).into());
        }
        let [plastic, viscous, hourglass] = own;
        let lost_beyond = beyond[0] + beyond[1] + beyond[2];
        let sums = [plastic, viscous, hourglass, gravity, kinetic, lost_beyond, displacement, light];
        for n in 0..ROW_SUMS {
            *a.row_sums[n].add(r) = sums[n];
        }
    }
}

/// Adds the dissipation of a run of cells, block by block.
///
/// # Safety
/// The run must lie in the row that begins at `start`.
#[inline(always)]
unsafe fn add_run(a: &Arrays, start: usize, run: Range<usize>, sums: &mut [f64; POWERS]) {
    let (size, dt) = (block_size(run.len()), f64::from(a.constants.dt));
    for first in run.clone().step_by(size) {
        let n = size.min(run.end - first);
        // SAFETY: as the caller promises.
        let [work, viscous, damped] = a
            .powers
            .map(|power| lane_sum(unsafe { from_raw_parts(power.add(start + first).cast_const(), n) }));
        sums[0] += work;
        sums[1] += viscous * dt;
        sums[2] += damped * dt;
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

macro_rules! run {
    (() $($variant:ident $name:ident($type:ty): |$a:ident, $more:ident, $block:ident, $n:ident| $does:expr;)*) => {
        /// Does what a thread of a kernel does.
        ///
        /// # Safety
        /// The arrays must be those of a grid, `more` the address of what the kernel is handed over besides,
        /// and no other thread may have the same number.
        pub unsafe fn run(kernel: Kernel, arrays: &Arrays, more: *const u8, block: &mut Block, number: usize) {
            match kernel {
                $(Kernel::$variant => {
                    // SAFETY: as the caller promises.
                    unsafe {
                        let ($a, $more, $block, $n) = (arrays, &*more.cast::<$type>(), block, number);
                        $does;
                    }
                })*
            }
        }

        /// Size of what a kernel is handed over besides the arrays [bytes].
        #[must_use]
        pub fn size_of_more(kernel: Kernel) -> usize {
            match kernel {
                $(Kernel::$variant => size_of::<$type>(),)*
            }
        }
    };
}

crate::each_kernel!(run,);
