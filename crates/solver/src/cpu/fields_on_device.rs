//! What a device with the fields of a grid does for a step, in either precision.

use super::stage_sums::StageSums;
use super::workspace::SoilWorkspace;
use crate::device::{DeviceError, Driver, Touched};
use crate::model::Model;
use crate::scalar::Scalar;
use crate::state::State;
use glam::DVec3;

/// The Lagrangian stage on a device.
pub trait DeviceStage<R: Scalar>: Sized {
    /// Reserves the arrays of a grid on a device, and hands over what never changes, and which cells and
    /// nodes remaps exchange beyond open boundaries.
    ///
    /// # Errors
    /// [`DeviceError`] if the device has not enough memory.
    fn new(
        model: &Model,
        state: &State<R>,
        workspace: &SoilWorkspace<R>,
        ghosts: Touched,
        driver: Box<dyn Driver>,
    ) -> Result<Self, DeviceError>;

    /// Bytes that have crossed to the device and back, or why it has failed.
    ///
    /// # Errors
    /// [`DeviceError`] if it has.
    fn crossed(&self) -> Result<u64, DeviceError>;

    /// The fields were changed on the processor: those of the device count no more.
    fn changed(&mut self);

    /// Whether the state on the processor is complete.
    fn is_home(&self) -> bool;

    /// Makes the state on the processor complete.
    fn bring_home(&mut self, state: &mut State<R>);

    /// Has the device strain the soil and move its nodes by one step. Of what is `touched` the nodes have
    /// come back; the device may still be at work on the rest.
    fn strain(
        &mut self,
        model: &Model,
        state: &mut State<R>,
        workspace: &mut SoilWorkspace<R>,
        touched: &dyn Fn() -> Touched,
    );

    /// Waits until the stage is done; its sums are known then, and the cells that are touched.
    fn end_stage(&mut self, model: &Model, state: &mut State<R>);

    /// Sums of the last Lagrangian stage.
    fn sums(&self) -> StageSums;

    /// Gives the device the velocities of the contact nodes.
    fn give_velocities(&mut self, model: &Model, state: &mut State<R>);
}

/// A remap on a device: what [`remap`](crate::remap) does with the soil's fields. Afterwards volume fractions
/// and masses are known to the processor, too.
pub trait DeviceRemap<R: Scalar> {
    /// Elastic and kinetic energy of each row [J].
    fn energies(&mut self, model: &Model, values: &mut [[f64; 2]]);

    /// Begins a remap of the `active` rows: takes back the voids that were lent, and moves the grid by
    /// `shift` [m].
    fn begin_remap(&mut self, model: &Model, active: &[bool], shift: DVec3);

    /// Volumes of the displaced cells and of the soil in them.
    fn displaced_volumes(&mut self, model: &Model);

    /// One sweep along an axis. No soil flows into the `filled` cells but from one into another.
    fn sweep(&mut self, model: &Model, axis: usize, filled: &[usize]);

    /// Takes what lies in the ghost layers and beside them, with the volumes of soil and cells.
    fn take_ghosts(&mut self, model: &Model, state: &mut State<R>, volumes: &mut [Vec<R>; 3]);

    /// Gives it back.
    fn give_ghosts(&mut self, model: &Model, state: &mut State<R>, volumes: &mut [Vec<R>; 3]);

    /// Volume fractions, and admissible stresses; volume [m³] and mass [kg] of the debris of each row.
    fn update_after_remap(&mut self, model: &Model, materials: &R::Materials, debris: &mut [[f64; 2]]);

    /// Sets displacements to zero and gives the nodes the masses of the cells round them; clears the entries
    /// of the arrays `before` that the processor has used.
    fn reset_nodes(&mut self, model: &Model, state: &mut State<R>, before: &mut [Vec<R>; 3]);

    /// Takes the soil of some cells, and the velocities and masses of some nodes.
    fn take_region(&mut self, model: &Model, state: &mut State<R>, touched: Touched);

    /// Gives them back.
    fn give_region(&mut self, model: &Model, state: &mut State<R>);

    /// Stops the nodes that have no mass.
    fn stop_massless(&mut self, model: &Model);

    /// Forgets the volume strains of soil apart from those of its cells.
    fn clear_apart(&mut self, model: &Model);

    /// Renews the nonlocal densities of the sand with a characteristic length, and takes them from the
    /// device.
    fn average_density(&mut self, model: &Model, density: &mut [R]);
}

impl<R: Scalar<OnDevice: DeviceStage<R>>> SoilWorkspace<R> {
    /// Sums of the Lagrangian stage over the block, once a device has done it.
    pub(crate) fn end_stage(&mut self, model: &Model, state: &mut State<R>) -> StageSums {
        match &mut self.device {
            Some(device) => {
                device.end_stage(model, state);
                device.sums()
            }
            None => self.sums_of_stage(),
        }
    }
}
