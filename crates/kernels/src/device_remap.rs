//! Remaps for a device: what a thread does for its cell, node or row, with the loops of the processor.
//!
//! As in [`super::device`], it writes only what is its own. Arrays that a kernel writes are not among those
//! that it reads, but for what is its own.
#![allow(unsafe_code)] // The arrays of a device are known by their addresses alone.

use super::Real;
use super::device::may_hold_soil;
use super::device_arrays::Arrays;
use super::energy::{Cells, elastic_row, kinetic_row};
use super::flux::{FluxInputs, close_face};
use super::nonlocal::{Averaged, Spread};
use super::physics::sand::Sand;
use super::remap;
use super::transport::Sweep;
use crate::launch::INSIDE;
use crate::layout::{LANES, Layout, Part};
use crate::mixture::{main_material, mass_as_main};
use ::physics::elastic::{Elastic, Stiffening};
use std::slice::{from_raw_parts, from_raw_parts_mut};

/// Most arrays that a kernel of a remap reads.
pub const INPUTS: usize = 5;

/// What a kernel of a remap reads and writes, besides what all have.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Pass {
    /// The axis of a sweep.
    pub axis: usize,
    /// Arrays that are read, null beyond the last.
    pub inputs: [*const Real; INPUTS],
    /// Arrays that are written.
    pub outputs: [*mut Real; 2],
    /// A number: which one, the kernel says.
    pub number: f64,
}

/// Faces through which nothing flows to one side.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Closed {
    /// How many there are.
    pub count: usize,
    /// The cells above them: indices in memory.
    pub faces: *const u32,
    /// The side, see [`close_face`].
    pub sides: *const Real,
    /// Volume that flows through each face [m³].
    pub flux: *mut Real,
}

/// The elastic law of a material.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Elasticity {
    /// Elastic moduli.
    pub elastic: Elastic,
    /// How these grow with the pressure.
    pub stiffening: Stiffening,
    /// Whether they do.
    pub stiffens: bool,
    /// The material's number, from 1 on.
    pub kind: u8,
}

/// What a kernel of the average of the sand's density reads and writes, and the sand.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Averaging {
    /// The arrays, and the axis of a pass.
    pub pass: Pass,
    /// Weights of the neighbours for each layer along the axis.
    pub weights: *const [Real; 2],
    /// The law of the sand.
    pub law: Sand,
    /// Its number, from 1 on.
    pub kind: u8,
}

/// What all kernels here know of their thread.
struct Own<'a> {
    arrays: &'a Arrays,
    pass: &'a Pass,
    part: Part,
}

impl<'a> Own<'a> {
    /// The thread of the cell or node `n`, unless this lies in the lowest plane, which is all ghosts, or
    /// beyond the grid.
    #[inline(always)]
    fn new(arrays: &'a Arrays, pass: &'a Pass, n: usize) -> Option<Self> {
        let plane = arrays.stride[1];
        let part = Part { start: n, length: 1 };
        (plane..arrays.planes * plane).contains(&n).then_some(Self { arrays, pass, part })
    }

    /// All of an array.
    ///
    /// # Safety
    /// There must be an array of the grid that no thread writes.
    #[inline(always)]
    unsafe fn input(&self, n: usize) -> &'a [Real] {
        // SAFETY: as the caller promises.
        unsafe { from_raw_parts(self.pass.inputs[n], self.arrays.entries) }
    }

    /// The thread's own number of an array.
    ///
    /// # Safety
    /// There must be an array of the grid, and no other thread may have the same cell.
    #[inline(always)]
    unsafe fn output(&self, n: usize) -> &'a mut [Real] {
        // SAFETY: as the caller promises.
        unsafe { from_raw_parts_mut(self.pass.outputs[n].add(self.part.start), 1) }
    }

    #[inline(always)]
    unsafe fn sweep(&self) -> Sweep<'a> {
        // SAFETY: there is a flag for each row.
        unsafe {
            let row_active = from_raw_parts(
                self.arrays.row_active,
                self.arrays.planes * (self.arrays.stride[1] / self.arrays.stride[0]),
            );
            Sweep { layout: layout(self.arrays), axis: self.pass.axis, row_active }
        }
    }
}

/// The layout of the grid.
///
/// # Safety
/// The addresses must be those of the faces of a grid.
#[inline(always)]
unsafe fn layout(a: &Arrays) -> Layout<'_> {
    let faces = |axis: usize| {
        // SAFETY: as the caller promises.
        unsafe { from_raw_parts(a.faces[axis], a.cells[axis] + 1) }
    };
    Layout { cells: a.cells, stride: [1, a.stride[0], a.stride[1]], faces: [faces(0), faces(1), faces(2)] }
}

/// Declares kernels with a thread for each cell or node: what it does with its [`Own`].
macro_rules! threads {
    ($($(#[$doc:meta])* $name:ident: |$own:ident| $does:expr;)*) => {
        $(
            $(#[$doc])*
            ///
            /// # Safety
            /// The addresses must be those of arrays of the grid, and no other thread may have the same
            /// number.
            #[inline(always)]
            pub unsafe fn $name(arrays: &Arrays, pass: &Pass, n: usize) {
                if let Some($own) = Own::new(arrays, pass, n) {
                    // SAFETY: as the caller promises.
                    unsafe { $does }
                }
            }
        )*
    };
}

threads! {
    /// Volumes of a displaced cell and of the soil in it, from displacements, fraction and `apart`.
    displaced_volumes: |own| {
        let fields = [own.input(3), own.input(4)];
        let displacement = [own.input(0), own.input(1), own.input(2)];
        let out = [own.output(0), own.output(1)];
        remap::displaced_volumes(&layout(own.arrays), own.part, displacement, fields, out);
    };
    /// Volume fraction of a displaced cell, from the volumes of soil and cell.
    volume_fraction: |own| {
        let n = own.part.start;
        remap::volume_fractions(&own.input(0)[n..=n], &own.input(1)[n..=n], own.output(0));
    };
    /// Soil volume through the low face of a cell, from displacement, fraction, volumes of soil and cell.
    volume_flux: |own| {
        let [displacement, fraction, soil, cell] = [own.input(0), own.input(1), own.input(2), own.input(3)];
        let inputs = FluxInputs { sweep: own.sweep(), displacement, fraction, soil, cell };
        inputs.volume_fluxes(own.part, own.output(0));
    };
    /// Volume of a displaced cell, without the displacement along the axis.
    undo_displacement: |own| own.sweep().undo_displacement(own.part, own.input(0), own.output(0));
    /// Reach of the flux through the low face of a cell, from flux, fraction and volume of the soil.
    reach: |own| own.sweep().reaches(own.part, [own.input(0), own.input(1), own.input(2)], own.output(0));
    /// A carried field, from volume or mass, the field, flux and reach.
    carry: |own| {
        let faces = [own.input(2), own.input(3)];
        own.sweep().carry(own.part, [own.input(0), own.input(1)], faces, own.output(0));
    };
    /// Mass through the low face of a cell, from volume and mass of the soil, flux and reach.
    mass_flux: |own| {
        let faces = [own.input(2), own.input(3)];
        own.sweep().mass_fluxes(own.part, [own.input(0), own.input(1)], faces, own.output(0));
    };
    /// What a cell holds, after the flux through its faces.
    difference: |own| own.sweep().difference(own.part, own.input(0), own.output(0));
    /// Mass through a dual face, from that through the faces.
    dual_flux: |own| own.sweep().dual_fluxes(own.part, own.input(0), own.output(0));
    /// Reach of a dual flux, from nodal mass and flux; the number is the mass from which on nodes move.
    dual_reach: |own| {
        let inputs = [own.input(0), own.input(1)];
        own.sweep().dual_reaches(own.part, inputs, own.pass.number as Real, own.output(0));
    };
    /// A component of a nodal velocity, from velocity, mass, flux and reach.
    carry_momentum: |own| {
        let inputs = [own.input(0), own.input(1), own.input(2), own.input(3)];
        own.sweep().carry_momentum(own.part, inputs, own.output(0));
    };
    /// Mass of a node after the dual flux.
    carry_mass: |own| own.sweep().carry_mass(own.part, own.input(0), own.output(0));
    /// Mass of a node, from those of the cells.
    nodal_mass: |own| remap::nodal_masses(&layout(own.arrays), own.part, own.input(0), own.output(0));
    /// Stops a node whose mass is no more than the number.
    stop_massless: |own| {
        let n = own.part.start;
        remap::stop_massless(&own.input(0)[n..=n], own.pass.number as Real, own.output(0));
    };
    /// Takes back the void that was lent to the soil of a cell: gap strain, and what was lent.
    take_back: |own| remap::take_back(own.output(0), own.output(1));
    /// Displacement of a node relative to a grid that has moved by the number.
    shift: |own| {
        let [i, j, k] = [own.part.start % own.arrays.stride[0], own.row_in_plane(), own.plane()];
        let [nx, ny, nz] = own.arrays.cells;
        if (1..=nx + 1).contains(&i) && (1..=ny + 1).contains(&j) && (1..=nz + 1).contains(&k) {
            remap::shift(own.output(0), own.pass.number);
        }
    };
}

impl Own<'_> {
    fn row_in_plane(&self) -> usize {
        self.part.start % self.arrays.stride[1] / self.arrays.stride[0]
    }

    fn plane(&self) -> usize {
        self.part.start / self.arrays.stride[1]
    }
}

/// Finds the main material of a cell, and its mass if all its soil were of that.
///
/// # Safety
/// The addresses must be those of arrays of the grid, and no other thread may have the same cell.
#[inline(always)]
pub unsafe fn mix(a: &Arrays, c: usize) {
    // SAFETY: all addresses are those of the cell, or of its row.
    unsafe {
        if may_hold_soil(a, c) {
            let others = a.composition.iter().take(a.materials - 1).map(|portion| f64::from(*portion.add(c)));
            let densities = &a.densities[..a.materials];
            *a.kind.add(c) = 1 + main_material(others.clone()) as u8;
            *a.soil_mass.add(c) = mass_as_main(densities, others, f64::from(*a.cell_mass.add(c))) as Real;
        }
    }
}

/// Lets nothing flow through a face to one side.
///
/// # Safety
/// The faces must be those of cells of the grid, none of them twice.
#[inline(always)]
pub unsafe fn close(closed: &Closed, thread: usize) {
    if thread < closed.count {
        // SAFETY: as the caller promises.
        unsafe {
            let face = *closed.faces.add(thread) as usize;
            close_face(&mut *closed.flux.add(face), *closed.sides.add(thread));
        }
    }
}

/// Volume fractions of a row, from the volumes of soil, and its masses without debris: what fills less than
/// the number of a cell. Volume and mass of the debris become the first two sums over the row. The fractions
/// must be zero before.
///
/// # Safety
/// The addresses must be those of arrays of the grid, and no other thread may have the same row.
#[inline(always)]
pub unsafe fn new_fractions(a: &Arrays, pass: &Pass, r: usize) {
    let [row, plane] = a.stride;
    if !(plane / row..a.planes * plane / row).contains(&r) {
        return;
    }
    // SAFETY: all addresses are those of the row.
    unsafe {
        let mut debris = [0.0; 2];
        if *a.row_active.add(r) {
            let [first, end] = if *a.row_flags.add(r) & INSIDE != 0 { a.inside } else { [0; 2] };
            let fields = pass.outputs.map(|out| from_raw_parts_mut(out.add(r * row), row));
            let volume = from_raw_parts(pass.inputs[0], a.entries);
            let removed = remap::Debris { below: pass.number, counted: first..end };
            debris = remap::new_fractions(&layout(a), r, volume, fields, &removed);
        }
        for (sums, own) in a.row_sums.iter().zip(debris) {
            *sums.add(r) = own;
        }
    }
}

/// Elastic energy of the first material and kinetic energy of a row become its first two sums; the elastic
/// energy of other materials is added.
///
/// # Safety
/// The addresses must be those of arrays of the grid, and no other thread may have the same row.
#[inline(always)]
pub unsafe fn row_energies(a: &Arrays, law: &Elasticity, r: usize) {
    let [row, plane] = a.stride;
    if !(plane / row..a.planes * plane / row).contains(&r) {
        return;
    }
    // SAFETY: all addresses are those of the row.
    unsafe {
        let layout = layout(a);
        let [q, p] = layout.row_and_plane(r);
        let mut elastic = 0.0;
        if *a.row_flags.add(r) & INSIDE != 0 {
            let [first, end] = a.inside;
            let (start, n) = (r * row + 1 + first, (end - first).next_multiple_of(LANES));
            let cells = Cells {
                faces: &layout.faces[0][first..=end],
                fraction: from_raw_parts(a.fraction.add(start), n),
                across: layout.width(1, q - 1) * layout.width(2, p - 1),
                kinds: if a.materials > 1 { from_raw_parts(a.kind.add(start).cast_const(), n) } else { &[] },
                kind: law.kind,
            };
            let stress = a.stress.map(|s| from_raw_parts(s.add(start).cast_const(), n));
            let stiffening = if law.stiffens { Some(&law.stiffening) } else { None };
            elastic = elastic_row(&law.elastic, stiffening, cells, stress);
        }
        if law.kind > 1 {
            *a.row_sums[0].add(r) += elastic;
            return;
        }
        let own = |array: *const Real| from_raw_parts(array.add(r * row), row);
        let kinetic = kinetic_row(own(a.mass), a.velocity[0].map(|v| own(v.cast_const())));
        (*a.row_sums[0].add(r), *a.row_sums[1].add(r)) = (elastic, kinetic);
    }
}

impl<'a> Own<'a> {
    /// The sand of the grid that is averaged.
    ///
    /// # Safety
    /// The addresses must be those of arrays of the grid.
    #[inline(always)]
    unsafe fn averaged(&self, law: &'a Sand, kind: u8) -> Averaged<'a> {
        let a = self.arrays;
        // SAFETY: as the caller promises.
        unsafe {
            Averaged {
                layout: layout(a),
                width_x: from_raw_parts(a.width_x[0], a.stride[0]),
                law,
                fraction: from_raw_parts(a.fraction, a.entries),
                mass: from_raw_parts(a.soil_mass.cast_const(), a.entries),
                material: if a.materials > 1 { from_raw_parts(a.kind.cast_const(), a.entries) } else { &[] },
                number: kind,
            }
        }
    }
}

/// Volume fraction of a cell, and its relative density times that.
///
/// # Safety
/// The addresses must be those of arrays of the grid, and no other thread may have the same number.
#[inline(always)]
pub unsafe fn collect_density(a: &Arrays, averaging: &Averaging, n: usize) {
    if let Some(own) = Own::new(a, &averaging.pass, n) {
        // SAFETY: as the caller promises.
        unsafe {
            own.averaged(&averaging.law, averaging.kind).collect(own.part, [own.output(0), own.output(1)])
        }
    }
}

/// A pass of the average over a cell, of one field.
///
/// # Safety
/// The addresses must be those of arrays of the grid, and no other thread may have the same number.
#[inline(always)]
pub unsafe fn spread_density(a: &Arrays, averaging: &Averaging, n: usize) {
    if let Some(own) = Own::new(a, &averaging.pass, n) {
        let axis = averaging.pass.axis;
        // SAFETY: as the caller promises.
        unsafe {
            let weights = from_raw_parts(averaging.weights, a.cells[axis]);
            Spread { layout: layout(a), axis, weights }.pass(own.part, own.input(0), own.output(0));
        }
    }
}

/// The difference between the average and the own relative density of a cell.
///
/// # Safety
/// The addresses must be those of arrays of the grid, and no other thread may have the same number.
#[inline(always)]
pub unsafe fn store_density(a: &Arrays, averaging: &Averaging, n: usize) {
    if let Some(own) = Own::new(a, &averaging.pass, n) {
        // SAFETY: as the caller promises.
        unsafe {
            let averages = [own.input(0), own.input(1)];
            own.averaged(&averaging.law, averaging.kind).store(own.part, averages, own.output(0));
        }
    }
}
