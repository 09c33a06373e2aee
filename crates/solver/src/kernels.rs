//! The interface between the time step and the kernels of either precision.

use crate::cpu::kernels::{double, single};
use crate::cpu::stage_sums::StageSums;
use crate::cpu::workspace::SoilWorkspace;
use crate::device::{DeviceError, Driver, Touched};
use crate::grid::Grid;
use crate::halo::Halo;
use crate::model::Model;
use crate::scalar::Scalar;
use crate::state::{Known, Nodes, Soil, State};

/// A number type with its kernels. Rows are numbered in memory order (see [`Grid::row_and_plane`]).
pub trait Kernels: Scalar {
    /// Strains the soil and moves its nodes by one step of `dt` [s]: stresses and displacements at the end of
    /// the step, velocities without contact half a step later. Calls `known` as soon as the nodes of the
    /// block that contact needs are moved. A device only brings back what is `touched` in a step.
    fn lagrangian_stage(
        model: &Model,
        state: &mut State<Self>,
        workspace: &mut SoilWorkspace<Self>,
        dt: f64,
        known: &mut Known<'_, Self>,
        touched: &dyn Fn() -> Touched,
    );

    /// Reserves the fields on a device.
    fn on_device(
        model: &Model,
        state: &State<Self>,
        workspace: &SoilWorkspace<Self>,
        driver: Box<dyn Driver>,
    ) -> Result<Self::OnDevice, DeviceError>;

    /// Sums of the last Lagrangian stage.
    fn sums_of_device(device: &Self::OnDevice) -> StageSums;

    /// Bytes that have crossed to a device and back, or why it has failed.
    fn crossed(device: &Self::OnDevice) -> Result<u64, DeviceError>;

    /// Gives a device the velocities of the contact nodes.
    fn give_velocities(model: &Model, state: &State<Self>, device: &mut Self::OnDevice);

    /// Whether the state is complete without what a device holds.
    fn is_home(device: &Self::OnDevice) -> bool;

    /// Another state takes the place of what a device holds.
    fn forget(device: &mut Self::OnDevice);

    /// Completes the state with what a device holds; `changes` if it is then changed on the processor.
    fn bring_home(state: &mut State<Self>, device: &mut Self::OnDevice, changes: bool);

    /// Volumes [m³] of the displaced cells and of the soil in them, from which the sweeps of a remap start.
    fn displaced_volumes(model: &Model, state: &State<Self>, workspace: &mut SoilWorkspace<Self>);

    /// One sweep of a remap along `axis`, over the `active` rows. No soil flows into the `filled` cells
    /// but from one into another.
    fn sweep(
        model: &Model,
        state: &mut State<Self>,
        workspace: &mut SoilWorkspace<Self>,
        axis: usize,
        active: &[bool],
        filled: &[usize],
    );

    /// Post-remap update: volume fractions from the transported volumes, and admissible stresses. Volume [m³]
    /// and mass [kg] of the debris removed are left in the workspace's values by row.
    fn update_after_remap(
        model: &Model,
        soil: &mut Soil<Self>,
        workspace: &mut SoilWorkspace<Self>,
        active: &[bool],
    );

    /// Post-remap update of one cell into which overlap removal has moved soil.
    fn update_cell(model: &Model, soil: &mut Soil<Self>, workspace: &mut SoilWorkspace<Self>, cell: usize);

    /// Renews the nonlocal densities of soil with a characteristic length.
    fn average_density(
        model: &Model,
        soil: &mut Soil<Self>,
        workspace: &mut SoilWorkspace<Self>,
        halo: &Halo,
    );

    /// Masses of a row of nodes from those of the cells [kg].
    fn nodal_masses(grid: &Grid, row: usize, cell_mass: &[Self], node_mass: &mut [Self]);

    /// Elastic energy of the soil in a row of cells [J].
    fn elastic_energy(model: &Model, soil: &Soil<Self>, row: [usize; 2]) -> f64;

    /// Kinetic energy of a row of nodes [J].
    fn kinetic_energy(grid: &Grid, nodes: &Nodes<Self>, row: [usize; 2]) -> f64;
}

macro_rules! precision {
    ($module:ident, $name:literal, $round_off:literal) => {
        impl Scalar for $module::Real {
            const NAME: &'static str = $name;
            const LANES: usize = $module::LANES;
            const ROUND_OFF: f64 = $round_off;
            type CellBlock = ::kernels::$module::cells::Block;

            type Materials = Vec<::kernels::$module::cells::MaterialConstants>;

            type OnDevice = $module::on_device::OnDevice;

            fn materials(model: &Model) -> Self::Materials {
                $module::constants::of_materials(model)
            }

            fn cast(value: f64) -> Self {
                value as Self
            }

            fn cell_block() -> Box<Self::CellBlock> {
                Box::default()
            }
        }

        impl Kernels for $module::Real {
            fn lagrangian_stage(
                model: &Model,
                state: &mut State<Self>,
                workspace: &mut SoilWorkspace<Self>,
                dt: f64,
                known: &mut Known<'_, Self>,
                touched: &dyn Fn() -> Touched,
            ) {
                match workspace.device.take() {
                    Some(mut device) => {
                        device.strain(model, state, workspace, touched);
                        workspace.device = Some(device);
                    }
                    None => $module::lagrange::lagrange(model, state, workspace, dt, known),
                }
            }

            fn on_device(
                model: &Model,
                state: &State<Self>,
                workspace: &SoilWorkspace<Self>,
                driver: Box<dyn Driver>,
            ) -> Result<Self::OnDevice, DeviceError> {
                $module::on_device::OnDevice::new(model, state, workspace, driver)
            }

            fn sums_of_device(device: &Self::OnDevice) -> StageSums {
                device.sums()
            }

            fn crossed(device: &Self::OnDevice) -> Result<u64, DeviceError> {
                device.failure().cloned().map_or(Ok(device.crossed()), Err)
            }

            fn give_velocities(model: &Model, state: &State<Self>, device: &mut Self::OnDevice) {
                device.give_velocities(model, state);
            }

            fn is_home(device: &Self::OnDevice) -> bool {
                device.is_home()
            }

            fn forget(device: &mut Self::OnDevice) {
                device.changed();
            }

            fn bring_home(state: &mut State<Self>, device: &mut Self::OnDevice, changes: bool) {
                device.bring_home(state);
                if changes {
                    device.changed();
                }
            }

            fn displaced_volumes(model: &Model, state: &State<Self>, workspace: &mut SoilWorkspace<Self>) {
                $module::sweep::displaced_volumes(model, state, workspace);
            }

            fn sweep(
                model: &Model,
                state: &mut State<Self>,
                workspace: &mut SoilWorkspace<Self>,
                axis: usize,
                active: &[bool],
                filled: &[usize],
            ) {
                $module::sweep::sweep(model, state, workspace, axis, active, filled);
            }

            fn update_after_remap(
                model: &Model,
                soil: &mut Soil<Self>,
                workspace: &mut SoilWorkspace<Self>,
                active: &[bool],
            ) {
                $module::post_remap::update_after_remap(model, soil, workspace, active);
            }

            fn update_cell(
                model: &Model,
                soil: &mut Soil<Self>,
                workspace: &mut SoilWorkspace<Self>,
                cell: usize,
            ) {
                $module::post_remap::update_cell(model, soil, workspace, cell);
            }

            fn average_density(
                model: &Model,
                soil: &mut Soil<Self>,
                workspace: &mut SoilWorkspace<Self>,
                halo: &Halo,
            ) {
                $module::nonlocal::average(model, soil, workspace, halo);
            }

            fn nodal_masses(grid: &Grid, row: usize, cell_mass: &[Self], node_mass: &mut [Self]) {
                $module::sweep::nodal_masses(grid, row, cell_mass, node_mass);
            }

            fn elastic_energy(model: &Model, soil: &Soil<Self>, row: [usize; 2]) -> f64 {
                $module::energy::elastic(model, soil, row)
            }

            fn kinetic_energy(grid: &Grid, nodes: &Nodes<Self>, row: [usize; 2]) -> f64 {
                $module::energy::kinetic(grid, nodes, row)
            }
        }
    };
}

precision!(double, "double", 1e-12);
precision!(single, "single", 1e-6);
