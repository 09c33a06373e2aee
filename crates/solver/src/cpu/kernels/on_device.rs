//! The Lagrangian stage on a device: what it is handed over, and what comes back.
//!
//! After a remap all fields go to the device. In a step only these cross: stress and history of the cells
//! that the processor changes (confined soil, ground beyond boundaries), velocities of the contact nodes, and
//! the sums. The state on the processor is complete again once the fields are brought home.
#![allow(unsafe_code)] // The arrays of a device are known by their addresses alone.

use super::cells::{Block, MaterialConstants};
use super::constants;
use super::device::{Arrays, Material, run};
use super::lagrange::{apply_boundaries, strained_columns};
use super::physics::law::Law;
use super::{Real, State, Workspace};
use crate::cpu::stage_sums::StageSums;
use crate::cpu::stopwatch::Stage;
use crate::device::{Address, DeviceError, Driver, Launch, Touched};
use crate::exact_sum::ExactSum;
use crate::fields::HISTORY_COUNT;
use crate::grid::Grid;
use crate::model::Model;
use ::kernels::exact_sum::NUMBERS;
use ::kernels::launch::{
    ACCOUNTED, INSIDE, Kernel, List, MEASURED, NODES, OWNED, POWERS, PlaneSum, ROW_SUMS, STRAINED, SUMS,
    Totals,
};
use ::kernels::sums::COEFFICIENTS;
use bytemuck::{cast_slice, cast_slice_mut};
use std::ptr::null_mut;

/// Numbers of a listed cell.
const OF_CELL: usize = 6 + HISTORY_COUNT;

/// A device with the fields of a grid.
#[derive(Debug)]
pub struct OnDevice {
    driver: Box<dyn Driver>,
    held: Addresses,
    /// Nodes and cells that the processor touches in a step.
    nodes: Listed,
    cells: Listed,
    /// Whether the device has the fields as they are after the last remap.
    is_current: bool,
    /// Whether the state on the processor is complete.
    is_home: bool,
    /// Which of the two velocity arrays holds those half a step ahead.
    ahead: usize,
    sums: StageSums,
    failed: Option<DeviceError>,
}

/// Addresses of the arrays, which the driver gives back when it is dropped.
#[derive(Clone, Copy, Debug)]
struct Addresses {
    row_flags: Address,
    kind: Address,
    held: Address,
    widths: [Address; 4],
    fraction: Address,
    soil_mass: Address,
    mass: Address,
    stress: [Address; 6],
    history: [Option<Address>; HISTORY_COUNT],
    velocity: [[Address; 3]; 2],
    displacement: [Address; 3],
    coefficients: [Address; COEFFICIENTS],
    powers: [Address; POWERS],
    measured: [Address; MEASURED],
    row_sums: [Address; ROW_SUMS],
    plane_sums: Address,
    totals: Address,
}

/// Nodes or cells on a list, with room for their numbers on the device.
#[derive(Debug, Default)]
struct Listed {
    entries: Vec<u32>,
    on_device: Option<[Address; 2]>,
    values: Vec<Real>,
}

/// Result of what a device is asked to do.
type Done<T = ()> = Result<T, DeviceError>;

impl OnDevice {
    /// Reserves the arrays of a grid on a device, and hands over what never changes.
    ///
    /// # Errors
    /// [`DeviceError`] if the device has not enough memory.
    pub(crate) fn new(
        model: &Model,
        state: &State,
        workspace: &Workspace,
        mut driver: Box<dyn Driver>,
    ) -> Done<Self> {
        let held = Addresses::new(&model.grid, state, &mut *driver)?;
        let grid = &model.grid;
        let widths = [1, 2].map(|axis| {
            let mut widths = vec![0.0; grid.cells()[axis] + 2];
            (0..grid.cells()[axis]).for_each(|n| widths[n + 1] = grid.width(axis, n) as Real);
            widths
        });
        let [x, per_x] = &workspace.width_x;
        for (to, from) in held.widths.into_iter().zip([x, per_x, &widths[0], &widths[1]]) {
            driver.write(to, cast_slice(from))?;
        }
        driver.write(held.held, &held_components(model))?;
        Ok(Self {
            driver,
            held,
            nodes: Listed::default(),
            cells: Listed::default(),
            is_current: false,
            is_home: true,
            ahead: 0,
            sums: StageSums::default(),
            failed: None,
        })
    }

    /// Sums of the last Lagrangian stage.
    pub(crate) fn sums(&self) -> StageSums {
        self.sums
    }

    /// Why the device has failed, if it has.
    pub(crate) fn failure(&self) -> Option<&DeviceError> {
        self.failed.as_ref()
    }

    /// Bytes that have crossed to the device and back.
    pub(crate) fn crossed(&self) -> u64 {
        self.driver.crossed()
    }

    /// The fields were changed on the processor: those of the device count no more.
    pub(crate) fn changed(&mut self) {
        (self.is_current, self.is_home) = (false, true);
    }

    /// Whether the state on the processor is complete.
    pub(crate) fn is_home(&self) -> bool {
        self.is_home
    }

    /// Does something unless the device has failed before; remembers if it fails now.
    fn unless_failed(&mut self, job: impl FnOnce(&mut Self) -> Done) {
        if self.failed.is_none() {
            self.failed = job(self).err();
        }
    }
}

impl Addresses {
    fn new(grid: &Grid, state: &State, driver: &mut dyn Driver) -> Done<Self> {
        let (rows, planes) = (grid.rows() * (grid.cells()[2] + 3), grid.cells()[2] + 2);
        let mut reals = |count: usize| driver.allocate(count * size_of::<Real>());
        let x = grid.stride[1] + crate::grid::LANES;
        let widths = each([x, x, grid.cells()[1] + 2, planes], &mut reals)?;
        let mut array = |()| reals(grid.entries);
        let mut history = [None; HISTORY_COUNT];
        for (own, _) in history.iter_mut().zip(&state.soil.history).filter(|(_, field)| !field.is_empty()) {
            *own = Some(array(())?);
        }
        let [fraction, soil_mass, mass] = each([(); 3], &mut array)?;
        let stress = each([(); 6], &mut array)?;
        let velocity = [each([(); 3], &mut array)?, each([(); 3], &mut array)?];
        let displacement = each([(); 3], &mut array)?;
        let coefficients = each([(); COEFFICIENTS], &mut array)?;
        let powers = each([(); POWERS], &mut array)?;
        let measured = each([(); MEASURED], &mut array)?;
        let row_sums = each([(); ROW_SUMS], &mut |()| driver.allocate(rows * size_of::<f64>()))?;
        let [row_flags, kind, held] =
            each([rows, grid.entries, grid.entries], &mut |count| driver.allocate(count))?;
        Ok(Self {
            row_flags,
            kind,
            held,
            widths,
            fraction,
            soil_mass,
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
        })
    }
}

/// Does the same for each, until it fails.
fn each<T: Copy, const N: usize>(of: [T; N], job: &mut impl FnMut(T) -> Done<Address>) -> Done<[Address; N]> {
    let mut all = [Address(0); N];
    for (out, own) in all.iter_mut().zip(of) {
        *out = job(own)?;
    }
    Ok(all)
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

/// The columns of a row that are strained: beyond the domain, in it, and beyond it.
fn columns(model: &Model) -> [[usize; 2]; 3] {
    let mut columns = [[0; 2]; 3];
    let inside = model.grid.inside(0);
    for (own, _) in strained_columns(model, true) {
        let part = if own.start < inside.start { 0 } else { 1 + usize::from(own.start >= inside.end) };
        columns[part] = [own.start, own.end];
    }
    columns
}

impl OnDevice {
    /// Strains the soil and moves its nodes by one step (see [`super::lagrange::lagrange`]).
    pub(crate) fn strain(
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
            if device.is_current {
                device.give_cells(model, state)?;
            } else {
                device.hand_over(model, state, workspace, touched())?;
                workspace.stopwatch().lap(Stage::Remap);
            }
            device.is_home = false;
            device.ahead = 1 - device.ahead;
            let arrays = device.arrays(model, clears);
            device.strain_all(model, &workspace.materials, &arrays)?;
            device.add_up(&arrays, &model.grid)?;
            device.take_nodes(model, state, &mut workspace.velocity_before)?;
            device.take_cells(model, state)
        });
        workspace.stopwatch().lap(Stage::Lagrange);
    }

    /// Addresses and constants as the kernels take them.
    fn arrays(&self, model: &Model, clears: bool) -> Arrays {
        let (grid, held) = (&model.grid, &self.held);
        let pointers = |velocity: [Address; 3]| velocity.map(Address::pointer);
        Arrays {
            entries: grid.entries,
            stride: [grid.stride[1], grid.stride[2]],
            planes: grid.cells()[2] + 2,
            nodes_in_row: grid.padded_nodes(),
            columns: columns(model),
            constants: constants::of_nodes(model, model.time_step()),
            hourglass_yielding: model.method.hourglass_yielding as Real,
            has_cubes: grid.has_cubes(),
            clears,
            row_flags: held.row_flags.pointer(),
            kind: held.kind.pointer(),
            held: held.held.pointer(),
            width_x: [
                held.widths[0].pointer::<Real>().cast_const(),
                held.widths[1].pointer::<Real>().cast_const(),
            ],
            width_yz: [
                held.widths[2].pointer::<Real>().cast_const(),
                held.widths[3].pointer::<Real>().cast_const(),
            ],
            fraction: held.fraction.pointer(),
            soil_mass: held.soil_mass.pointer(),
            mass: held.mass.pointer(),
            stress: held.stress.map(Address::pointer),
            history: held.history.map(|own| own.map_or(null_mut(), Address::pointer)),
            velocity: [pointers(held.velocity[self.ahead]), pointers(held.velocity[1 - self.ahead])],
            displacement: held.displacement.map(Address::pointer),
            coefficients: held.coefficients.map(Address::pointer),
            powers: held.powers.map(Address::pointer),
            measured: held.measured.map(Address::pointer),
            row_sums: held.row_sums.map(Address::pointer),
            plane_sums: held.plane_sums.pointer(),
            totals: held.totals.pointer(),
        }
    }

    fn launch<T>(&mut self, kernel: Kernel, threads: usize, arrays: &Arrays, more: &T) -> Done {
        let mut block = Block::default();
        let more = std::ptr::from_ref(more).cast::<u8>();
        self.driver.launch(Launch {
            kernel,
            threads,
            is_double: size_of::<Real>() == size_of::<f64>(),
            arguments: [std::ptr::from_ref(arrays).cast::<u8>(), more],
            // SAFETY: the arrays are those of the grid, `more` is what the kernel takes, and a driver gives
            // every thread a number of its own.
            on_processor: &mut |n| unsafe { run(kernel, arrays, more, &mut block, n) },
        })
    }

    /// Strains the cells of each material, then moves the nodes.
    fn strain_all(&mut self, model: &Model, materials: &[MaterialConstants], arrays: &Arrays) -> Done {
        let cells = model.grid.entries;
        for (n, material) in materials.iter().enumerate() {
            let kind = n as u8 + 1;
            macro_rules! strain {
                ($kernel:ident, $law:expr) => {
                    self.launch(Kernel::$kernel, cells, arrays, &Material::new(kind, material, $law))
                };
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
        self.launch(Kernel::MoveNodes, cells, arrays, &0_u64)
    }

    /// Adds up what rows and planes contribute.
    fn add_up(&mut self, arrays: &Arrays, grid: &Grid) -> Done {
        let planes = grid.cells()[2] + 2;
        self.launch(Kernel::SumRows, planes * grid.rows(), arrays, &0_u64)?;
        self.launch(Kernel::SumPlanes, planes * ROW_SUMS, arrays, &0_u64)?;
        self.launch(Kernel::SumAll, ROW_SUMS * NUMBERS, arrays, &0_u64)?;
        let mut words = [0_i64; SUMS * NUMBERS + 2];
        self.driver.read(self.held.totals, cast_slice_mut(&mut words))?;
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
    /// Hands over all fields after a remap, and what follows from where the soil is.
    fn hand_over(&mut self, model: &Model, state: &State, workspace: &Workspace, touched: Touched) -> Done {
        let (grid, held, driver) = (&model.grid, &self.held, &mut self.driver);
        let soil = &state.soil;
        let mass = workspace.mass_of_laws(&soil.mass);
        let scalars = [(held.fraction, soil.fraction.as_slice()), (held.soil_mass, mass)];
        let stress = held.stress.into_iter().zip(soil.stress.iter().map(Vec::as_slice));
        let history =
            held.history.iter().zip(&soil.history).filter_map(|(to, from)| Some(((*to)?, from.as_slice())));
        let nodes = held.displacement.iter().chain([&held.mass]).copied();
        let nodes = nodes.chain(held.velocity[self.ahead]);
        let fields = state.nodes.displacement.iter().chain([&state.nodes.mass]).chain(&state.nodes.velocity);
        let nodes = nodes.zip(fields.map(Vec::as_slice));
        for (to, from) in scalars.into_iter().chain(stress).chain(history).chain(nodes) {
            driver.write(to, cast_slice(from))?;
        }
        for at in held.velocity[1 - self.ahead].iter().chain(&held.coefficients) {
            driver.clear(*at, grid.entries * size_of::<Real>())?;
        }
        let flags = row_flags(model, workspace);
        driver.write(held.row_flags, &flags)?;
        driver.write(held.kind, &kinds(model, workspace, &flags))?;
        self.nodes.renew(touched.nodes, 6, &mut **driver)?;
        self.cells.renew(touched.cells, OF_CELL, &mut **driver)?;
        self.is_current = true;
        Ok(())
    }

    /// Gives the device stress and history of the cells that the processor has changed.
    fn give_cells(&mut self, model: &Model, state: &State) -> Done {
        let arrays: Vec<&Vec<Real>> = state.soil.stress.iter().chain(&state.soil.history).collect();
        for (c, numbers) in self.cells.each(OF_CELL) {
            for (number, array) in numbers.iter_mut().zip(&arrays) {
                *number = array.get(c).copied().unwrap_or_default();
            }
        }
        self.exchange(Kernel::GiveCells, model)
    }

    /// Gives the device the velocities that contact has found.
    pub(crate) fn give_velocities(&mut self, model: &Model, state: &State) {
        self.unless_failed(|device| {
            for (n, numbers) in device.nodes.each(3) {
                for (number, v) in numbers.iter_mut().zip(&state.nodes.velocity) {
                    *number = v[n];
                }
            }
            device.exchange(Kernel::GiveNodes, model)
        });
    }

    /// Takes the velocities of the contact nodes, ahead and before.
    fn take_nodes(&mut self, model: &Model, state: &mut State, before: &mut [Vec<Real>; 3]) -> Done {
        self.exchange(Kernel::TakeNodes, model)?;
        for (n, numbers) in self.nodes.each(6) {
            let arrays = state.nodes.velocity.iter_mut().chain(&mut *before);
            arrays.zip(numbers).for_each(|(array, number)| array[n] = *number);
        }
        Ok(())
    }

    /// Takes stress and history of the cells that the processor changes.
    fn take_cells(&mut self, model: &Model, state: &mut State) -> Done {
        self.exchange(Kernel::TakeCells, model)?;
        for (c, numbers) in self.cells.each(OF_CELL) {
            let arrays = state.soil.stress.iter_mut().chain(&mut state.soil.history);
            for (array, number) in arrays.zip(numbers).filter(|(array, _)| !array.is_empty()) {
                array[c] = *number;
            }
        }
        Ok(())
    }

    /// Gives or takes the numbers of the listed nodes or cells.
    fn exchange(&mut self, kernel: Kernel, model: &Model) -> Done {
        let (listed, each, gives) = match kernel {
            Kernel::GiveNodes => (&self.nodes, 3, true),
            Kernel::TakeNodes => (&self.nodes, 6, false),
            Kernel::GiveCells => (&self.cells, OF_CELL, true),
            _ => (&self.cells, OF_CELL, false),
        };
        let count = listed.entries.len();
        let Some([entries, values]) = listed.on_device else { return Ok(()) };
        if gives {
            self.driver.write(values, cast_slice(&listed.values[..each * count]))?;
        }
        let list = List::<Real> { count, entries: entries.pointer(), values: values.pointer() };
        self.launch(kernel, count, &self.arrays(model, false), &list)?;
        if !gives {
            let listed = if kernel == Kernel::TakeNodes { &mut self.nodes } else { &mut self.cells };
            self.driver.read(values, cast_slice_mut(&mut listed.values[..each * count]))?;
        }
        Ok(())
    }

    /// Makes the state on the processor complete.
    pub(crate) fn bring_home(&mut self, state: &mut State) {
        if self.is_home {
            return;
        }
        self.is_home = true;
        self.unless_failed(|device| {
            let Addresses { stress, history, velocity, displacement, .. } = device.held;
            let own = history.into_iter().zip(&mut state.soil.history);
            let history = own.filter_map(|(from, to)| Some((from?, to)));
            let nodes = velocity[device.ahead].into_iter().zip(&mut state.nodes.velocity);
            let nodes = nodes.chain(displacement.into_iter().zip(&mut state.nodes.displacement));
            for (from, to) in stress.into_iter().zip(&mut state.soil.stress).chain(history).chain(nodes) {
                device.driver.read(from, cast_slice_mut(to))?;
            }
            Ok(())
        });
    }
}

impl Listed {
    /// Other nodes or cells, with room for so many numbers of each.
    fn renew(&mut self, entries: Vec<u32>, most: usize, driver: &mut dyn Driver) -> Done {
        self.on_device.take().into_iter().flatten().for_each(|address| driver.free(address));
        self.entries = entries;
        self.values = vec![0.0; most * self.entries.len()];
        if !self.entries.is_empty() {
            let places = driver.allocate(size_of_val(self.entries.as_slice()))?;
            driver.write(places, cast_slice(&self.entries))?;
            self.on_device = Some([places, driver.allocate(size_of_val(self.values.as_slice()))?]);
        }
        Ok(())
    }

    /// The index in memory and the numbers of each.
    fn each(&mut self, numbers: usize) -> impl Iterator<Item = (usize, &mut [Real])> {
        self.entries.iter().map(|n| *n as usize).zip(self.values.chunks_exact_mut(numbers))
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
