//! The interface between the time step and the kernels of either precision.

use crate::cpu::fields_on_device::{DeviceRemap, DeviceStage};
use crate::cpu::kernels::{double, single};
use crate::cpu::workspace::SoilWorkspace;
use crate::device::Touched;
use crate::grid::Grid;
use crate::halo::Halo;
use crate::model::Model;
use crate::scalar::Scalar;
use crate::state::{Known, Nodes, Soil, State};
use glam::DVec3;

/// A number type with its kernels. Rows are numbered in memory order (see [`Grid::row_and_plane`]).
pub trait Kernels: Scalar<OnDevice: DeviceStage<Self> + DeviceRemap<Self>> {
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

    /// Begins a remap of the `active` rows: takes back the voids that were lent to the soil, and makes the
    /// displacements relative to the grid, which has moved by `shift` [m].
    fn begin_remap(
        model: &Model,
        state: &mut State<Self>,
        workspace: &mut SoilWorkspace<Self>,
        active: &[bool],
        shift: DVec3,
    );

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

    /// Sets the displacement to zero, gives the nodes the masses of the cells round them, and leaves the
    /// scratch arrays zero where there is no soil, as the Lagrangian stage expects them.
    fn reset_nodes(model: &Model, state: &mut State<Self>, workspace: &mut SoilWorkspace<Self>);

    /// Stops nodes that have lost their soil; only after a remap, not between sweeps.
    fn stop_massless(model: &Model, state: &mut State<Self>, workspace: &mut SoilWorkspace<Self>);

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

            fn begin_remap(
                model: &Model,
                state: &mut State<Self>,
                workspace: &mut SoilWorkspace<Self>,
                active: &[bool],
                shift: DVec3,
            ) {
                $module::sweep::begin_remap(model, state, workspace, active, shift);
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

            fn reset_nodes(model: &Model, state: &mut State<Self>, workspace: &mut SoilWorkspace<Self>) {
                $module::sweep::reset_nodes(model, state, workspace);
            }

            fn stop_massless(model: &Model, state: &mut State<Self>, workspace: &mut SoilWorkspace<Self>) {
                $module::sweep::stop_massless(model, state, workspace);
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
