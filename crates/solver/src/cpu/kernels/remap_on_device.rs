//! A remap on a device, and what of it crosses: of the cells beside open boundaries and round the bodies all,
//! for the processor refills those and moves the soil out of these; of the others volume fraction and mass.

use super::addresses::{Done, launch, pass, put};
use super::cells::MaterialConstants;
use super::device_arrays::Arrays;
use super::device_remap::{Averaging, Closed, Elasticity, Pass};
use super::listed::{Listed, Region};
use super::nonlocal::{Spreading, passes};
use super::on_device::OnDevice;
use super::physics::sand::Sand;
use super::sweep::closed_faces;
use super::{Real, State};
use crate::cpu::fields_on_device::DeviceRemap;
use crate::device::{Address, Driver, Touched};
use crate::fields::{Carrier, GAP_STRAIN, HISTORY, NONLOCAL_DENSITY};
use crate::grid::Grid;
use crate::model::{FRACTION_KEPT, Model};
use ::kernels::launch::Kernel;
use ::physics::elastic::Stiffening;
use bytemuck::{cast_slice, cast_slice_mut};
use glam::DVec3;
use std::ptr::null;

/// Whether numbers are taken from the device or given to it.
#[derive(Clone, Copy, PartialEq)]
enum Direction {
    Take,
    Give,
}

impl OnDevice {
    /// Exchanges the fields in a region, and the volumes of soil and cells, if any.
    fn exchange(
        &mut self,
        model: &Model,
        direction: Direction,
        state: &mut State,
        region: fn(&mut Self) -> &mut Region,
        volumes: Option<&mut [Vec<Real>; 3]>,
    ) -> Done {
        let held = self.held;
        let arrays = held.arrays(model);
        let mut own = std::mem::take(region(self));
        let mut of_cells = held.soil(&mut state.soil);
        of_cells.extend(held.velocity[1 - held.ahead].into_iter().zip(volumes.into_iter().flatten()).take(2));
        let mut of_nodes = held.nodes(&mut state.nodes);
        let driver = &mut *self.driver;
        let done = if direction == Direction::Take {
            let cells = own.cells.take(driver, &arrays, &mut of_cells);
            cells.and_then(|()| own.nodes.take(driver, &arrays, &mut of_nodes))
        } else {
            let cells = own.cells.give(driver, &arrays, &of_cells);
            cells.and_then(|()| own.nodes.give(driver, &arrays, &of_nodes))
        };
        *region(self) = own;
        done
    }

    /// Launches a kernel for all cells or nodes.
    fn pass(&mut self, model: &Model, kernel: Kernel, pass: &Pass) -> Done {
        launch(&mut *self.driver, kernel, model.grid.entries, &self.held.arrays(model), pass)
    }

    /// Finds the main material of each cell, where there are several.
    fn mix(&mut self, model: &Model) -> Done {
        if model.materials.len() == 1 {
            return Ok(());
        }
        launch(&mut *self.driver, Kernel::Mix, model.grid.entries, &self.held.arrays(model), &0_u64)
    }

    fn sweep_along(&mut self, model: &Model, axis: usize, filled: &[usize]) -> Done {
        let mut held = self.held;
        let mut sweep = Sweep { driver: &mut *self.driver, arrays: held.arrays(model), axis };
        let [soil, cell, mut flux] = held.velocity[1 - held.ahead];
        let (mut spare, mass) = (held.fraction, held.cell_mass);
        let (displacement, reach) = (held.displacement[axis], held.displacement[axis]);
        sweep.run(Kernel::VolumeFraction, &[soil, cell], spare, 0.0)?;
        sweep.run(Kernel::VolumeFlux, &[displacement, spare, soil, cell], flux, 0.0)?;
        sweep.close(&mut self.closed, closed_faces(filled, model.grid.stride[axis]).collect(), flux)?;
        sweep.run(Kernel::UndoDisplacement, &[displacement], cell, 0.0)?;
        sweep.run(Kernel::Reach, &[flux, spare, soil], reach, 0.0)?;
        let needed = held.history.iter_mut().zip(HISTORY).filter_map(|(field, h)| Some((field.as_mut()?, h)));
        let (by_volume, by_mass): (Vec<_>, Vec<_>) =
            needed.partition(|(_, variable)| variable.carrier == Carrier::Volume);
        let by_volume = by_volume.into_iter().map(|(field, _)| field);
        let portions = held.composition.iter_mut().flatten();
        for field in held.stress.iter_mut().chain(by_volume).chain(portions) {
            sweep.run(Kernel::Carry, &[soil, *field, flux, reach], spare, 0.0)?;
            std::mem::swap(field, &mut spare);
        }
        sweep.run(Kernel::MassFlux, &[soil, mass, flux, reach], spare, 0.0)?;
        sweep.run(Kernel::Difference, &[flux], soil, 0.0)?;
        for (field, _) in by_mass {
            sweep.run(Kernel::Carry, &[mass, *field, spare, reach], flux, 0.0)?;
            std::mem::swap(field, &mut flux);
        }
        sweep.run(Kernel::Difference, &[spare], mass, 0.0)?;
        sweep.run(Kernel::DualFlux, &[spare], flux, 0.0)?;
        sweep.run(Kernel::DualReach, &[held.mass, flux], reach, model.mass_moved())?;
        for velocity in &mut held.velocity[held.ahead] {
            sweep.run(Kernel::CarryMomentum, &[*velocity, held.mass, flux, reach], spare, 0.0)?;
            std::mem::swap(velocity, &mut spare);
        }
        sweep.run(Kernel::CarryMass, &[flux], held.mass, 0.0)?;
        held.fraction = spare;
        held.velocity[1 - held.ahead] = [soil, cell, flux];
        self.held = held;
        Ok(())
    }

    /// Averages the density of the sand with a characteristic length; what is measured at nodes in steps
    /// makes room for that.
    fn average(&mut self, model: &Model, density: &mut [Real]) -> Done {
        let found =
            model.materials.iter().enumerate().find_map(|(n, m)| Some((n, m, m.characteristic_length?)));
        let Some((number, material, length)) = found else { return Ok(()) };
        let Some(::physics::law::Law::Sand(law)) = &material.yield_law else { return Ok(()) };
        let Some(stored) = self.held.history[NONLOCAL_DENSITY] else { return Ok(()) };
        let arrays = self.held.arrays(model);
        let [mut own, mut other] =
            [[0, 1], [2, 3]].map(|both: [usize; 2]| both.map(|n| self.held.measured[n]));
        for at in self.held.measured {
            self.driver.clear(at, arrays.entries * size_of::<Real>())?;
        }
        let mut averaging = Averaging {
            pass: pass(0, &[], &own, 0.0),
            weights: null(),
            law: Sand::cast(law),
            kind: number as u8 + 1,
        };
        launch(&mut *self.driver, Kernel::CollectDensity, arrays.entries, &arrays, &averaging)?;
        let (passes, count) = passes(&model.grid, length);
        let mut weights = Vec::new();
        for pass in &passes {
            weights.push(put(&mut *self.driver, cast_slice(&pass.weights))?);
        }
        for (Spreading { axis, .. }, weights) in (0..count).flat_map(|_| passes.iter().zip(&weights)) {
            averaging.weights = weights.pointer::<[Real; 2]>().cast_const();
            for (from, to) in own.into_iter().zip(other) {
                averaging.pass = pass(*axis, &[from], &[to], 0.0);
                launch(&mut *self.driver, Kernel::SpreadDensity, arrays.entries, &arrays, &averaging)?;
            }
            std::mem::swap(&mut own, &mut other);
        }
        averaging.pass = pass(0, &own, &[stored], 0.0);
        launch(&mut *self.driver, Kernel::StoreDensity, arrays.entries, &arrays, &averaging)?;
        self.driver.read(stored, cast_slice_mut(density))?;
        weights.into_iter().for_each(|at| self.driver.free(at));
        Ok(())
    }

    /// Reads the first two sums of each row but those of the lowest plane, which is all ghosts.
    fn read_rows(&mut self, grid: &Grid, values: &mut [[f64; 2]]) -> Done {
        let mut sums = vec![0.0_f64; values.len()];
        for (n, at) in self.held.row_sums.into_iter().take(2).enumerate() {
            self.driver.read(at, cast_slice_mut(&mut sums))?;
            values.iter_mut().zip(&sums).skip(grid.rows()).for_each(|(value, sum)| value[n] = *sum);
        }
        Ok(())
    }
}

/// A sweep.
struct Sweep<'a> {
    driver: &'a mut dyn Driver,
    arrays: Arrays,
    axis: usize,
}

impl Sweep<'_> {
    /// Launches a kernel for all cells or nodes.
    fn run(&mut self, kernel: Kernel, inputs: &[Address], output: Address, number: f64) -> Done {
        let pass = pass(self.axis, inputs, &[output], number);
        launch(self.driver, kernel, self.arrays.entries, &self.arrays, &pass)
    }

    /// Closes faces to what flows to one side.
    fn close(&mut self, closed: &mut Listed, faces: Vec<(usize, Real)>, flux: Address) -> Done {
        let sides: Vec<Real> = faces.iter().map(|(_, side)| *side).collect();
        let faces = faces.into_iter().map(|(face, _)| face as u32).collect();
        closed.renew(faces, 1, self.driver)?;
        let Some([faces, values]) = closed.addresses() else { return Ok(()) };
        self.driver.write(values, cast_slice(&sides))?;
        let closed = Closed {
            count: sides.len(),
            faces: faces.pointer::<u32>().cast_const(),
            sides: values.pointer::<Real>().cast_const(),
            flux: flux.pointer(),
        };
        launch(self.driver, Kernel::Close, sides.len(), &self.arrays, &closed)
    }
}

impl DeviceRemap<Real> for OnDevice {
    fn energies(&mut self, model: &Model, values: &mut [[f64; 2]]) {
        self.unless_failed(|device| {
            let arrays = device.held.arrays(model);
            for (number, material) in model.materials.iter().enumerate() {
                let law = Elasticity {
                    elastic: material.elastic,
                    stiffening: material.stiffening().unwrap_or(Stiffening { least: 1.0, most: 1.0 }),
                    stiffens: material.stiffening().is_some(),
                    kind: number as u8 + 1,
                };
                launch(&mut *device.driver, Kernel::RowEnergies, values.len(), &arrays, &law)?;
            }
            device.read_rows(&model.grid, values)
        });
    }

    fn begin_remap(&mut self, model: &Model, active: &[bool], shift: DVec3) {
        self.unless_failed(|device| {
            let held = device.held;
            device.is_home = false;
            let active: Vec<u8> = active.iter().map(|own| u8::from(*own)).collect();
            device.driver.write(held.row_active, &active)?;
            if let Some(gap) = held.history[GAP_STRAIN] {
                device.pass(model, Kernel::TakeBack, &pass(0, &[], &[gap, held.apart], 0.0))?;
            }
            for (displacement, shift) in held.displacement.into_iter().zip(shift.to_array()) {
                if shift != 0.0 {
                    device.pass(model, Kernel::Shift, &pass(0, &[], &[displacement], shift))?;
                }
            }
            Ok(())
        });
    }

    fn displaced_volumes(&mut self, model: &Model) {
        self.unless_failed(|device| {
            let held = device.held;
            let [soil, cell, _] = held.velocity[1 - held.ahead];
            let [x, y, z] = held.displacement;
            let inputs = &[x, y, z, held.fraction, held.apart];
            device.pass(model, Kernel::DisplacedVolumes, &pass(0, inputs, &[soil, cell], 0.0))
        });
    }

    fn sweep(&mut self, model: &Model, axis: usize, filled: &[usize]) {
        self.unless_failed(|device| device.sweep_along(model, axis, filled));
    }

    fn take_ghosts(&mut self, model: &Model, state: &mut State, volumes: &mut [Vec<Real>; 3]) {
        self.unless_failed(|device| {
            device.exchange(model, Direction::Take, state, |own| &mut own.ghosts, Some(volumes))
        });
    }

    fn give_ghosts(&mut self, model: &Model, state: &mut State, volumes: &mut [Vec<Real>; 3]) {
        self.unless_failed(|device| {
            device.exchange(model, Direction::Give, state, |own| &mut own.ghosts, Some(volumes))
        });
    }

    fn update_after_remap(
        &mut self,
        model: &Model,
        materials: &Vec<MaterialConstants>,
        debris: &mut [[f64; 2]],
    ) {
        self.unless_failed(|device| {
            let held = device.held;
            let arrays = held.arrays(model);
            device.driver.clear(held.fraction, arrays.entries * size_of::<Real>())?;
            let [volume, ..] = held.velocity[1 - held.ahead];
            let fields = pass(0, &[volume], &[held.fraction, held.cell_mass], FRACTION_KEPT);
            launch(&mut *device.driver, Kernel::NewFractions, debris.len(), &arrays, &fields)?;
            device.mix(model)?;
            device.all_cells(materials, &arrays, true)?;
            device.read_rows(&model.grid, debris)
        });
    }

    fn reset_nodes(&mut self, model: &Model, state: &mut State, before: &mut [Vec<Real>; 3]) {
        for array in before {
            self.ghosts.clear(array);
            self.nodes.entries.iter().for_each(|n| array[*n as usize] = 0.0);
        }
        self.unless_failed(|device| {
            let held = device.held;
            for at in held.displacement.into_iter().chain(held.velocity[1 - held.ahead]) {
                device.driver.clear(at, model.grid.entries * size_of::<Real>())?;
            }
            device.pass(model, Kernel::NodalMass, &pass(0, &[held.cell_mass], &[held.mass], 0.0))?;
            let State { soil, nodes, .. } = state;
            let amounts = [(held.fraction, &mut soil.fraction), (held.cell_mass, &mut soil.mass)];
            let portions = held.composition.into_iter().flatten().zip(&mut soil.composition);
            for (from, to) in amounts.into_iter().chain([(held.mass, &mut nodes.mass)]).chain(portions) {
                device.driver.read(from, cast_slice_mut(to))?;
            }
            device.is_prepared = false;
            Ok(())
        });
    }

    fn take_region(&mut self, model: &Model, state: &mut State, touched: Touched) {
        self.unless_failed(|device| {
            device.region.renew(touched, &mut *device.driver)?;
            device.exchange(model, Direction::Take, state, |own| &mut own.region, None)
        });
    }

    fn give_region(&mut self, model: &Model, state: &mut State) {
        self.unless_failed(|device| {
            device.exchange(model, Direction::Give, state, |own| &mut own.region, None)
        });
    }

    fn stop_massless(&mut self, model: &Model) {
        self.unless_failed(|device| {
            let held = device.held;
            // Soil that was moved out of bodies has mixed with other.
            device.mix(model)?;
            for velocity in held.velocity[held.ahead] {
                let fields = pass(0, &[held.mass], &[velocity], model.mass_moved());
                device.pass(model, Kernel::StopMassless, &fields)?;
            }
            Ok(())
        });
    }

    fn clear_apart(&mut self, model: &Model) {
        self.unless_failed(|device| {
            device.driver.clear(device.held.apart, model.grid.entries * size_of::<Real>())
        });
    }

    fn average_density(&mut self, model: &Model, density: &mut [Real]) {
        self.unless_failed(|device| device.average(model, density));
    }
}
