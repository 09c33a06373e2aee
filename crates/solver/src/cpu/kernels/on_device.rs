//! The Lagrangian stage on a device: what it is handed over, and what comes back.
//!
//! In a step only these cross: stress and history of the cells that the processor changes (confined soil,
//! ground beyond boundaries), velocities of the contact nodes, and the sums. The state on the processor is
//! complete again once the fields are brought home.

use super::addresses::{Addresses, Done, columns, launch};
use super::cells::MaterialConstants;
use super::device::Material;
use super::device_arrays::Arrays;
use super::lagrange::apply_boundaries;
use super::listed::{Listed, Region};
use super::physics::law::Law;
use super::{Nodes, Real, State, Workspace};
use crate::cpu::fields_on_device::DeviceStage;
use crate::cpu::stage_sums::StageSums;
use crate::cpu::stopwatch::Stage;
use crate::device::{DeviceError, Driver, Touched};
use crate::exact_sum::ExactSum;
use crate::fields::HISTORY_COUNT;
use crate::grid::Grid;
use crate::model::Model;
use ::kernels::exact_sum::NUMBERS;
use ::kernels::launch::{ACCOUNTED, INSIDE, Kernel, NODES, OWNED, ROW_SUMS, STRAINED, SUMS};
use bytemuck::{cast_slice, cast_slice_mut};

/// A device with the fields of a grid.
#[derive(Debug)]
pub struct OnDevice {
    pub(super) driver: Box<dyn Driver>,
    pub(super) held: Addresses,
    /// Nodes and cells that the processor touches in a step.
    pub(super) nodes: Listed,
    cells: Listed,
    /// Whether the device has the fields of the state.
    is_current: bool,
    /// Whether it knows where the soil is since the last remap.
    pub(super) is_prepared: bool,
    /// Whether the state on the processor is complete.
    pub(super) is_home: bool,
    /// What remaps exchange of the ghost layers.
    pub(super) ghosts: Region,
    /// What the processor has taken last during a remap.
    pub(super) region: Region,
    /// Faces that a sweep closes.
    pub(super) closed: Listed,
    sums: StageSums,
    failed: Option<DeviceError>,
}

impl OnDevice {
    /// Does something unless the device has failed before; remembers if it fails now.
    pub(super) fn unless_failed(&mut self, job: impl FnOnce(&mut Self) -> Done) {
        if self.failed.is_none() {
            self.failed = job(self).err();
        }
    }
}

impl DeviceStage<Real> for OnDevice {
    fn new(
        model: &Model,
        state: &State,
        workspace: &Workspace,
        ghosts: Touched,
        mut driver: Box<dyn Driver>,
    ) -> Done<Self> {
        let held = Addresses::new(model, state, &workspace.width_x, &mut *driver)?;
        driver.write(held.held, &held_components(model))?;
        let mut beyond = Region::default();
        beyond.renew(ghosts, &mut *driver)?;
        Ok(Self {
            driver,
            held,
            nodes: Listed::default(),
            cells: Listed::default(),
            is_current: false,
            is_prepared: false,
            is_home: true,
            ghosts: beyond,
            region: Region::default(),
            closed: Listed::default(),
            sums: StageSums::default(),
            failed: None,
        })
    }

    fn crossed(&self) -> Done<u64> {
        self.failed.clone().map_or(Ok(self.driver.crossed()), Err)
    }

    fn changed(&mut self) {
        (self.is_current, self.is_prepared, self.is_home) = (false, false, true);
    }

    fn is_home(&self) -> bool {
        self.is_home
    }

    fn bring_home(&mut self, state: &mut State) {
        if self.is_home {
            return;
        }
        self.unless_failed(|device| {
            let (held, driver) = (device.held, &mut *device.driver);
            let nodes = held.velocity[held.ahead].into_iter().zip(&mut state.nodes.velocity);
            let nodes = nodes.chain(held.displacement.into_iter().zip(&mut state.nodes.displacement));
            for (from, to) in held.strained(&mut state.soil).into_iter().chain(nodes) {
                driver.read(from, cast_slice_mut(to))?;
            }
            device.is_home = true;
            Ok(())
        });
    }

    fn strain(
        &mut self,
        model: &Model,
        state: &mut State,
        workspace: &mut Workspace,
        touched: &dyn Fn() -> Touched,
    ) {
        let clears = workspace.clear < 2;
        workspace.clear += u8::from(clears);
        workspace.stopwatch().lap(Stage::Other);
        self.unless_failed(|device| {
            if !device.is_current {
                device.hand_over(model, state, workspace)?;
                // As a remap expects them; contact nodes alone have entries from here on.
                workspace.velocity_before.iter_mut().for_each(|array| array.fill(0.0));
            }
            if !device.is_prepared {
                device.prepare(model, workspace, touched())?;
                workspace.stopwatch().lap(Stage::Remap);
            }
            let strained = device.held.strained(&mut state.soil);
            device.cells.give(&mut *device.driver, &device.held.arrays(model), &strained)?;
            device.is_home = false;
            device.held.ahead = 1 - device.held.ahead;
            let arrays = Arrays { clears, ..device.held.arrays(model) };
            device.near_first(&workspace.materials, &arrays, state, &mut workspace.velocity_before)
        });
        workspace.stopwatch().lap(Stage::Lagrange);
    }

    fn end_stage(&mut self, model: &Model, state: &mut State) {
        self.unless_failed(|device| {
            let arrays = device.held.arrays(model);
            device.add_up(&arrays, &model.grid)?;
            device.cells.take(&mut *device.driver, &arrays, &mut device.held.strained(&mut state.soil))
        });
    }

    fn sums(&self) -> StageSums {
        self.sums
    }

    fn give_velocities(&mut self, model: &Model, state: &mut State) {
        self.unless_failed(|device| {
            let velocity = device.held.velocity[device.held.ahead];
            let both: Vec<_> = velocity.into_iter().zip(&mut state.nodes.velocity).collect();
            device.nodes.give(&mut *device.driver, &device.held.arrays(model), &both)
        });
    }
}

/// For each node the velocity components that boundaries hold, one bit for each.
fn held_components(model: &Model) -> Vec<u8> {
    let grid = &model.grid;
    let [_, row, _] = grid.stride;
    let mut held = vec![0_u8; grid.entries];
    let nodes = grid.padded_nodes();
    for r in grid.rows()..grid.rows() * (grid.cells()[2] + 2) {
        let [q, plane] = grid.row_and_plane(r);
        if q == 0 {
            continue;
        }
        let mut free = [(); 3].map(|()| vec![1.0; nodes]);
        apply_boundaries(model, [q, plane], &mut free.each_mut().map(Vec::as_mut_slice));
        for (axis, free) in free.iter().enumerate() {
            for (held, free) in held[r * row + 1..].iter_mut().zip(free) {
                *held |= u8::from(*free == 0.0) << axis;
            }
        }
    }
    held
}

/// How each row is treated.
fn row_flags(model: &Model, workspace: &Workspace) -> Vec<u8> {
    let grid = &model.grid;
    let rows = grid.rows();
    let has_soil = |p: usize, q: usize| workspace.row_is_strained[p * rows + q];
    let flags = |r: usize| {
        let [q, p] = grid.row_and_plane(r);
        if q == 0 || p == 0 {
            return 0;
        }
        let strained = has_soil(p, q) && model.boundaries.strain_row(grid, [q, p]);
        let nodes = has_soil(p - 1, q - 1) || has_soil(p - 1, q) || has_soil(p, q - 1) || has_soil(p, q);
        let accounted =
            grid.accounts_for(1, q - 1 + grid.first[1]) && grid.accounts_for(2, p - 1 + grid.first[2]);
        let each = [
            (strained, STRAINED),
            (nodes, NODES),
            (grid.owned_row(r).is_some(), OWNED),
            (grid.is_inside([q, p]), INSIDE),
            (accounted, ACCOUNTED),
        ];
        each.into_iter().filter(|(has, _)| *has).fold(0, |all, (_, flag)| all | flag)
    };
    (0..workspace.row_is_strained.len()).map(flags).collect()
}

impl OnDevice {
    /// Strains the soil and moves its nodes, those that contact needs first: they come back while the device
    /// is at work on the others.
    fn near_first(
        &mut self,
        materials: &[MaterialConstants],
        arrays: &Arrays,
        state: &mut State,
        before: &mut [Vec<Real>; 3],
    ) -> Done {
        let nodes = self.near(arrays);
        let [row, plane] = arrays.stride;
        // A node moves under the forces of the cells round it.
        let cells = [nodes[0].saturating_sub(plane + row + 1), nodes[1]];
        let launch_moves = |driver: &mut dyn Driver, range: [usize; 2]| match range[1].checked_sub(range[0]) {
            None | Some(0) => Ok(()),
            Some(count) => launch(driver, Kernel::MoveNodes, count, &Arrays { range, ..*arrays }, &0_u64),
        };
        self.all_cells(materials, &Arrays { range: cells, ..*arrays }, false)?;
        launch_moves(&mut *self.driver, nodes)?;
        let [ahead, ago] = [self.held.ahead, 1 - self.held.ahead].map(|n| self.held.velocity[n]);
        let ahead = ahead.into_iter().zip(&mut state.nodes.velocity);
        let mut both: Vec<_> = ahead.chain(ago.into_iter().zip(before)).collect();
        self.nodes.begin_taking(&mut *self.driver, arrays, &both)?;
        for range in [[0, cells[0]], [cells[1], arrays.entries]] {
            self.all_cells(materials, &Arrays { range, ..*arrays }, false)?;
        }
        for range in [[0, nodes[0]], [nodes[1], arrays.entries]] {
            launch_moves(&mut *self.driver, range)?;
        }
        self.nodes.end_taking(&mut *self.driver, &mut both)
    }

    /// The rows of nodes, one after the other in memory, in which those lie that contact needs.
    fn near(&self, arrays: &Arrays) -> [usize; 2] {
        let ends = [self.nodes.entries.first(), self.nodes.entries.last()];
        let [Some(first), Some(last)] = ends.map(|n| n.map(|n| *n as usize / arrays.stride[0])) else {
            return [0, 0];
        };
        [first * arrays.stride[0], (last + 1) * arrays.stride[0]]
    }

    /// Strains the cells of each material, or makes their stress admissible after a remap.
    pub(super) fn all_cells(
        &mut self,
        materials: &[MaterialConstants],
        arrays: &Arrays,
        is_after_remap: bool,
    ) -> Done {
        let (driver, cells) = (&mut *self.driver, arrays.range[1] - arrays.range[0]);
        if cells == 0 {
            return Ok(());
        }
        for (n, material) in materials.iter().enumerate() {
            let kind = n as u8 + 1;
            macro_rules! strain {
                ($kernel:ident, $law:expr) => {{
                    let material = Material::new(kind, material, $law, is_after_remap);
                    launch(driver, Kernel::$kernel, cells, arrays, &material)
                }};
            }
            let Some(law) = &material.yield_law else {
                strain!(StrainElastic, ())?;
                continue;
            };
            if let Law::MohrCoulomb(law) = law {
                strain!(StrainMohrCoulomb, *law)
            } else if let Law::MenetreyWillam(law) = law {
                strain!(StrainMenetreyWillam, *law)
            } else if let Law::VonMises(law) = law {
                strain!(StrainVonMises, *law)
            } else if let Law::Sand(law) = law {
                strain!(StrainSand, *law)
            } else if let Law::Clay(law) = law {
                strain!(StrainClay, *law)
            } else {
                // A law that has no kernel yet.
                Err(DeviceError("devices do not have the soil's law".to_owned()))
            }?;
        }
        Ok(())
    }

    /// Adds up what rows and planes contribute.
    fn add_up(&mut self, arrays: &Arrays, grid: &Grid) -> Done {
        let planes = grid.cells()[2] + 2;
        let driver = &mut *self.driver;
        launch(driver, Kernel::SumLanes, 8 * planes * grid.rows(), arrays, &0_u64)?;
        launch(driver, Kernel::SumRows, planes * grid.rows(), arrays, &0_u64)?;
        launch(driver, Kernel::SumPlanes, planes * ROW_SUMS, arrays, &0_u64)?;
        launch(driver, Kernel::SumAll, ROW_SUMS * NUMBERS, arrays, &0_u64)?;
        let mut words = [0_i64; SUMS * NUMBERS + 2];
        driver.read(self.held.totals, cast_slice_mut(&mut words))?;
        let (numbers, most) = words.split_at(SUMS * NUMBERS);
        let mut sums = [ExactSum::default(); SUMS];
        for (sum, numbers) in sums.iter_mut().zip(numbers.as_chunks().0) {
            *sum = ExactSum::of_numbers(*numbers);
        }
        self.sums = StageSums::of_device(sums, [most[0], most[1]].map(|bits| f64::from_bits(bits as u64)));
        Ok(())
    }
}

// What crosses.
impl OnDevice {
    /// Hands over all fields.
    fn hand_over(&mut self, model: &Model, state: &mut State, workspace: &Workspace) -> Done {
        let (grid, held, driver) = (&model.grid, &self.held, &mut self.driver);
        let State { soil, nodes: Nodes { velocity, displacement, mass }, .. } = state;
        driver.write(held.fraction, cast_slice(&soil.fraction))?;
        driver.write(held.cell_mass, cast_slice(&soil.mass))?;
        driver.write(held.soil_mass, cast_slice(workspace.mass_of_laws(&soil.mass)))?;
        for (to, from) in held.composition.into_iter().flatten().zip(&soil.composition) {
            driver.write(to, cast_slice(from))?;
        }
        driver.write(held.mass, cast_slice(mass))?;
        let nodes = held.displacement.into_iter().zip(displacement);
        let nodes = nodes.chain(held.velocity[held.ahead].into_iter().zip(velocity));
        for (to, from) in held.strained(soil).into_iter().chain(nodes) {
            driver.write(to, cast_slice(from))?;
        }
        for at in held.velocity[1 - held.ahead] {
            driver.clear(at, grid.entries * size_of::<Real>())?;
        }
        self.is_current = true;
        Ok(())
    }

    /// Hands over what follows from where the soil is after a remap.
    fn prepare(&mut self, model: &Model, workspace: &Workspace, touched: Touched) -> Done {
        let driver = &mut *self.driver;
        for at in self.held.coefficients {
            driver.clear(at, model.grid.entries * size_of::<Real>())?;
        }
        let flags = row_flags(model, workspace);
        driver.write(self.held.row_flags, &flags)?;
        driver.write(self.held.kind, &kinds(model, workspace, &flags))?;
        self.nodes.renew(touched.nodes, 6, driver)?;
        self.cells.renew(touched.cells, 7 + HISTORY_COUNT, driver)?;
        self.is_prepared = true;
        Ok(())
    }
}

/// For each cell the number of its material, from 1 on; 0 where it is not strained.
fn kinds(model: &Model, workspace: &Workspace, flags: &[u8]) -> Vec<u8> {
    let row = model.grid.stride[1];
    let mut kinds = vec![0_u8; model.grid.entries];
    let columns = columns(model);
    for r in (0..flags.len()).filter(|r| flags[*r] & STRAINED != 0) {
        let start = r * row + 1;
        for c in columns.iter().flat_map(|[first, end]| start + first..start + end) {
            kinds[c] = 1 + workspace.material.get(c).copied().unwrap_or(0);
        }
    }
    kinds
}
