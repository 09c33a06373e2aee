//! The arrays of a grid on a device.
#![allow(unsafe_code)] // The arrays of a device are known by their addresses alone.

use super::cells::Block;
use super::device_arrays::Arrays;
use super::device_remap::{INPUTS, Pass};
use super::device_run::run;
use super::lagrange::strained_columns;
use super::{Nodes, Real, Soil, State, constants};
use crate::device::{Address, DeviceError, Driver, Launch};
use crate::fields::HISTORY_COUNT;
use crate::grid::Grid;
use crate::model::Model;
use ::kernels::launch::{Kernel, MATERIALS, MEASURED, POWERS, PlaneSum, ROW_SUMS, Totals};
use ::kernels::sums::COEFFICIENTS;
use bytemuck::cast_slice;
use std::ptr::{null, null_mut};

/// Result of what a device is asked to do.
pub(super) type Done<T = ()> = Result<T, DeviceError>;

/// An array on the device, and the same on the processor.
pub(super) type Both<'a> = (Address, &'a mut Vec<Real>);

/// Addresses of the arrays, which the driver gives back when it is dropped.
#[derive(Clone, Copy, Debug)]
pub(super) struct Addresses {
    pub(super) row_flags: Address,
    pub(super) row_active: Address,
    pub(super) kind: Address,
    pub(super) held: Address,
    faces: [Address; 3],
    widths: [Address; 4],
    pub(super) fraction: Address,
    /// Masses of the cells, as if all soil of each were of its main material.
    pub(super) soil_mass: Address,
    /// Masses of the cells: the same array where there is only one material.
    pub(super) cell_mass: Address,
    pub(super) composition: [Option<Address>; MATERIALS - 1],
    pub(super) apart: Address,
    pub(super) mass: Address,
    pub(super) stress: [Address; 6],
    pub(super) history: [Option<Address>; HISTORY_COUNT],
    pub(super) velocity: [[Address; 3]; 2],
    pub(super) displacement: [Address; 3],
    pub(super) coefficients: [Address; COEFFICIENTS],
    powers: [Address; POWERS],
    pub(super) measured: [Address; MEASURED],
    pub(super) row_sums: [Address; ROW_SUMS],
    plane_sums: Address,
    pub(super) totals: Address,
    /// Which of the two velocity arrays holds those half a step ahead.
    pub(super) ahead: usize,
}

/// Does the same for each, until it fails.
fn each<T: Copy, const N: usize>(of: [T; N], job: &mut impl FnMut(T) -> Done<Address>) -> Done<[Address; N]> {
    let mut all = [Address(0); N];
    for (out, own) in all.iter_mut().zip(of) {
        *out = job(own)?;
    }
    Ok(all)
}

impl Addresses {
    /// Reserves the arrays of a grid on a device, and hands over its widths.
    pub(super) fn new(
        model: &Model,
        state: &State,
        width_x: &[Vec<Real>; 2],
        driver: &mut dyn Driver,
    ) -> Done<Self> {
        let grid = &model.grid;
        let (rows, planes) = (grid.rows() * (grid.cells()[2] + 3), grid.cells()[2] + 2);
        let faces = each([0, 1, 2], &mut |axis: usize| put(driver, cast_slice(&grid.faces[axis])))?;
        let [y, z] = [1, 2].map(|axis| widths(grid, axis));
        let [x, per_x] = width_x;
        let widths = each([x, per_x, &y, &z], &mut |widths: &Vec<Real>| put(driver, cast_slice(widths)))?;
        let mut array = |()| driver.allocate(grid.entries * size_of::<Real>());
        let mut history = [None; HISTORY_COUNT];
        for (own, _) in history.iter_mut().zip(&state.soil.history).filter(|(_, field)| !field.is_empty()) {
            *own = Some(array(())?);
        }
        let [fraction, soil_mass, apart, mass] = each([(); 4], &mut array)?;
        let mut composition = [None; MATERIALS - 1];
        for (own, _) in composition.iter_mut().zip(&state.soil.composition) {
            *own = Some(array(())?);
        }
        let cell_mass = if model.materials.len() == 1 { soil_mass } else { array(())? };
        let stress = each([(); 6], &mut array)?;
        let velocity = [each([(); 3], &mut array)?, each([(); 3], &mut array)?];
        let displacement = each([(); 3], &mut array)?;
        let coefficients = each([(); COEFFICIENTS], &mut array)?;
        let powers = each([(); POWERS], &mut array)?;
        let measured = each([(); MEASURED], &mut array)?;
        let row_sums = each([(); ROW_SUMS], &mut |()| driver.allocate(rows * size_of::<f64>()))?;
        let [row_flags, row_active, kind, held] =
            each([rows, rows, grid.entries, grid.entries], &mut |count| driver.allocate(count))?;
        Ok(Self {
            row_flags,
            row_active,
            kind,
            held,
            faces,
            widths,
            fraction,
            soil_mass,
            cell_mass,
            composition,
            apart,
            mass,
            stress,
            history,
            velocity,
            displacement,
            coefficients,
            powers,
            measured,
            row_sums,
            plane_sums: driver.allocate(planes * ROW_SUMS * size_of::<PlaneSum>())?,
            totals: driver.allocate(size_of::<Totals>())?,
            ahead: 0,
        })
    }

    /// Addresses and constants as the kernels take them.
    pub(super) fn arrays(&self, model: &Model) -> Arrays {
        let grid = &model.grid;
        let pointers = |velocity: [Address; 3]| velocity.map(Address::pointer);
        let inside = grid.inside(0);
        let mut densities = [0.0; MATERIALS];
        densities.iter_mut().zip(model.densities()).for_each(|(own, density)| *own = density);
        let widths = self.widths.map(|widths| widths.pointer::<Real>().cast_const());
        Arrays {
            entries: grid.entries,
            stride: [grid.stride[1], grid.stride[2]],
            planes: grid.cells()[2] + 2,
            cells: grid.cells(),
            faces: self.faces.map(|faces| faces.pointer::<f64>().cast_const()),
            inside: [inside.start, inside.end],
            range: [0, grid.entries],
            row_active: self.row_active.pointer(),
            nodes_in_row: grid.padded_nodes(),
            columns: columns(model),
            constants: constants::of_nodes(model, model.time_step()),
            hourglass_yielding: model.method.hourglass_yielding as Real,
            has_cubes: grid.has_cubes(),
            clears: false,
            row_flags: self.row_flags.pointer(),
            kind: self.kind.pointer(),
            held: self.held.pointer(),
            width_x: [widths[0], widths[1]],
            width_yz: [widths[2], widths[3]],
            fraction: self.fraction.pointer(),
            soil_mass: self.soil_mass.pointer(),
            materials: model.materials.len(),
            densities,
            cell_mass: self.cell_mass.pointer(),
            composition: self
                .composition
                .map(|own| own.map_or(null(), |at| at.pointer::<Real>().cast_const())),
            mass: self.mass.pointer(),
            stress: self.stress.map(Address::pointer),
            history: self.history.map(|own| own.map_or(null_mut(), Address::pointer)),
            velocity: [pointers(self.velocity[self.ahead]), pointers(self.velocity[1 - self.ahead])],
            displacement: self.displacement.map(Address::pointer),
            coefficients: self.coefficients.map(Address::pointer),
            powers: self.powers.map(Address::pointer),
            measured: self.measured.map(Address::pointer),
            row_sums: self.row_sums.map(Address::pointer),
            plane_sums: self.plane_sums.pointer(),
            totals: self.totals.pointer(),
        }
    }

    /// What changes in steps, beside the arrays of some soil: stress, history, and what is apart.
    pub(super) fn strained<'a>(&self, soil: &'a mut Soil) -> Vec<Both<'a>> {
        let Soil { apart, stress, history, .. } = soil;
        let stress = self.stress.into_iter().zip(stress);
        let history = self.history.into_iter().zip(history).filter_map(|(own, field)| Some((own?, field)));
        stress.chain(history).chain([(self.apart, apart)]).collect()
    }

    /// All arrays of soil, beside those of some.
    pub(super) fn soil<'a>(&self, soil: &'a mut Soil) -> Vec<Both<'a>> {
        let Soil { fraction, mass, apart, stress, history, composition } = soil;
        let amounts = [(self.fraction, fraction), (self.cell_mass, mass), (self.apart, apart)];
        let portions = self.composition.into_iter().flatten().zip(composition);
        let history = self.history.into_iter().zip(history).filter_map(|(own, field)| Some((own?, field)));
        let stress = self.stress.into_iter().zip(stress);
        amounts.into_iter().chain(stress).chain(history).chain(portions).collect()
    }

    /// Velocities ahead and masses, beside the arrays of some nodes.
    pub(super) fn nodes<'a>(&self, nodes: &'a mut Nodes) -> Vec<Both<'a>> {
        let velocity = self.velocity[self.ahead].into_iter().zip(&mut nodes.velocity);
        velocity.chain([(self.mass, &mut nodes.mass)]).collect()
    }
}

/// Reserves memory for some bytes and copies them there.
pub(super) fn put(driver: &mut dyn Driver, bytes: &[u8]) -> Done<Address> {
    let at = driver.allocate(bytes.len())?;
    driver.write(at, bytes)?;
    Ok(at)
}

/// Widths of the layers along an axis, 0 for ghosts [m].
fn widths(grid: &Grid, axis: usize) -> Vec<Real> {
    let mut widths = vec![0.0; grid.cells()[axis] + 2];
    (0..grid.cells()[axis]).for_each(|n| widths[n + 1] = grid.width(axis, n) as Real);
    widths
}

/// The columns of a row that are strained: beyond the domain, in it, and beyond it.
pub(super) fn columns(model: &Model) -> [[usize; 2]; 3] {
    let mut columns = [[0; 2]; 3];
    let inside = model.grid.inside(0);
    for (own, _) in strained_columns(model, true) {
        let part = if own.start < inside.start { 0 } else { 1 + usize::from(own.start >= inside.end) };
        columns[part] = [own.start, own.end];
    }
    columns
}

/// Has a device launch a kernel.
pub(super) fn launch<T>(
    driver: &mut dyn Driver,
    kernel: Kernel,
    threads: usize,
    arrays: &Arrays,
    more: &T,
) -> Done {
    let mut block = Block::default();
    let more = std::ptr::from_ref(more).cast::<u8>();
    driver.launch(Launch {
        kernel,
        threads,
        is_double: size_of::<Real>() == size_of::<f64>(),
        arguments: [std::ptr::from_ref(arrays).cast::<u8>(), more],
        // SAFETY: the arrays are those of the grid, `more` is what the kernel takes, and a driver gives every
        // thread a number of its own.
        on_processor: &mut |n| unsafe { run(kernel, arrays, more, &mut block, n) },
    })
}

/// What a kernel of a remap reads and writes.
pub(super) fn pass(axis: usize, inputs: &[Address], outputs: &[Address], number: f64) -> Pass {
    let mut own = Pass { axis, inputs: [null(); INPUTS], outputs: [null_mut(); 2], number };
    own.inputs.iter_mut().zip(inputs).for_each(|(to, from)| *to = from.pointer::<Real>().cast_const());
    own.outputs.iter_mut().zip(outputs).for_each(|(to, from)| *to = from.pointer());
    own
}
