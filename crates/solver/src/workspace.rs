//! Scratch memory of the time step; nothing in it must survive a step.

use crate::balance;
use crate::contact;
use crate::contact::workspace::ContactWorkspace;
use crate::cpu::fields_on_device::DeviceStage;
use crate::cpu::seepage::SeepageWorkspace;
use crate::cpu::stopwatch::Stopwatch;
use crate::cpu::workspace::SoilWorkspace;
use crate::device::{self, DeviceError, Driver};
use crate::error::Breakdown;
use crate::ghosts::{self, Beyond};
use crate::grid::Grid;
use crate::halo::Halo;
use crate::kernels::Kernels;
use crate::model::{Model, RimBin};
use crate::pore_pressure;
use crate::state::State;
use mechanics::{Mechanism, Steering, Step, Work};

/// Threads and scratch memory of a run.
pub struct Workspace<R: Kernels = f64> {
    /// Scratch memory for the loops over cells.
    pub(crate) soil: SoilWorkspace<R>,
    /// Scratch memory for contact.
    pub(crate) contact: ContactWorkspace,
    /// Scratch memory for pore water.
    pub(crate) seepage: SeepageWorkspace,
    /// Bodies and joints.
    pub(crate) mechanism: Mechanism,
    /// Bodies and joints during a step.
    pub(crate) bodies: Step,
    /// The ground beyond boundaries at constant stress.
    pub(crate) beyond: Beyond<R>,
    /// Communication with the other blocks of the grid.
    pub(crate) halo: Halo,
}

impl<R: Kernels> std::fmt::Debug for Workspace<R> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Workspace with {:?}, {:?}", self.soil, self.contact)
    }
}

impl<R: Kernels> Workspace<R> {
    /// [`Workspace::of_block`], to be compiled for one precision.
    pub(crate) fn prepared(model: &Model, state: &mut State<R>, threads: usize, halo: Halo) -> Self {
        if state.step == 0 && !halo.is_alone() {
            balance::begin_in_blocks(model, state, &halo);
        }
        let soil = SoilWorkspace::new(model, state, threads);
        let mut workspace = Self {
            contact: ContactWorkspace::new(model, state, soil.crew(), &halo),
            soil,
            seepage: SeepageWorkspace::new(model),
            mechanism: model.mechanism(),
            bodies: Step::default(),
            beyond: Beyond::new(model, state),
            halo,
        };
        if state.step == 0 {
            let Self { soil, contact, halo, .. } = &mut workspace;
            contact::first_search(model, state, soil, contact, halo);
        }
        let Self { contact, seepage, soil, halo, .. } = &mut workspace;
        soil.strain_first(&model.grid, contact.first_row(&model.grid, halo));
        if state.step > 0 {
            contact.body_cells = contact::bodies_at_search(model, state, soil.crew());
            contact.confined = contact::find_confined(&model.grid, &state.soil, &contact.body_cells);
        }
        pore_pressure::find_paths(model, state, seepage, contact);
        workspace.soil.settle(state);
        workspace
    }

    /// What each row of cells of the block costs in a step, over that of a row of which no cell yields; y
    /// fastest.
    #[must_use]
    pub fn costs(&self, grid: &Grid) -> Vec<f64> {
        self.soil.costs_of_own(grid)
    }

    /// Other motions of the model's bodies take over: they start from the speeds that the bodies have.
    pub fn take_over(&mut self, model: &Model, state: &mut State<R>) {
        self.set_motions(model);
        let bodies = self.mechanism.bodies().iter().zip(&mut state.mechanism.bodies);
        bodies.for_each(|(body, now)| *now = body.taken_over(now));
    }

    /// Work done on a body in the last step.
    #[must_use]
    pub fn work(&self, body: usize) -> Work {
        self.bodies.work(body)
    }

    /// Another program steers bodies from here on, in their order; the others move as the model says. What a
    /// body has of kinetic energy goes with it, and counts as external work.
    pub fn steer(&mut self, model: &Model, state: &mut State<R>, steering: &[Option<Steering>]) {
        self.mechanism = model.mechanism().steered(steering);
        let own = model.mechanism();
        let before = own.kinetic_energy(&state.mechanism);
        let mut changed = false;
        for (body, now) in self.mechanism.bodies().iter().zip(&mut state.mechanism.bodies) {
            let is_elsewhere = body.steering.is_some_and(|steering| steering.replaces_motion());
            if is_elsewhere != now.is_elsewhere() {
                *now = body.taken_over(now);
                changed = true;
            }
        }
        if changed {
            let gained = own.kinetic_energy(&state.mechanism) - before;
            state.energy_balance.external += model.modelled_fraction() * gained;
        }
    }

    /// Sets other motions of the model's bodies, of a state in which they have taken over already.
    pub fn set_motions(&mut self, model: &Model) {
        self.mechanism = model.mechanism();
    }

    /// The bins of each body's rim, in the order of their arcs.
    pub fn rims(&self) -> impl Iterator<Item = &[RimBin]> {
        self.contact.surfaces.iter().map(contact::Surface::rim)
    }

    /// Has a device strain the soil from here on, and not the processor; changes no bit of a run.
    ///
    /// # Errors
    /// [`DeviceError`] if the device has not enough memory, or if this model needs what devices cannot do:
    /// pore water, or several blocks.
    pub fn use_device(
        &mut self,
        model: &Model,
        state: &State<R>,
        driver: Box<dyn Driver>,
    ) -> Result<(), DeviceError> {
        device::require::<R>(model, &*driver)?;
        if !self.halo.is_alone() {
            return Err(DeviceError("a grid in several blocks is strained on processors alone".to_owned()));
        }
        self.soil.device =
            Some(R::OnDevice::new(model, state, &self.soil, ghosts::touched(&model.grid), driver)?);
        Ok(())
    }

    /// Bytes that have crossed to the device and back; `None` without one.
    #[must_use]
    pub fn crossed_to_device(&self) -> Option<u64> {
        self.soil.device.as_ref()?.crossed().ok()
    }

    /// Completes the state with the fields that a device holds; between steps, only contact and bodies are
    /// up to date. `changes` says that the fields are then changed.
    pub fn bring_home(&mut self, state: &mut State<R>, changes: bool) {
        if let Some(device) = &mut self.soil.device {
            device.bring_home(state);
            if changes {
                device.changed();
            }
        }
    }

    /// Whether the state is complete without what a device holds.
    #[must_use]
    pub fn is_home(&self) -> bool {
        self.soil.device.as_ref().is_none_or(DeviceStage::is_home)
    }

    /// Fails if the device has.
    ///
    /// # Errors
    /// [`Breakdown::Device`]: the state is not complete.
    pub fn device_works(&self, state: &State<R>) -> Result<(), Breakdown> {
        let failed = self.soil.device.as_ref().and_then(|device| device.crossed().err());
        let (time, step) = (state.time, state.step);
        failed.map_or(Ok(()), |DeviceError(why)| Err(Breakdown::Device { why, time, step }))
    }

    /// Number of threads.
    #[must_use]
    pub fn threads(&self) -> usize {
        self.soil.threads()
    }

    /// Whether the nodes that contact needs of this block are moved before the others, so that they reach the
    /// other blocks meanwhile.
    #[must_use]
    pub fn moves_contact_first(&self) -> bool {
        self.soil.far_portions > 0
    }

    /// Communication with the other blocks of the grid.
    #[must_use]
    pub fn halo(&self) -> &Halo {
        &self.halo
    }

    /// Time by stage of the calling thread.
    pub fn stopwatch(&mut self) -> &mut Stopwatch {
        self.soil.stopwatch()
    }

    /// Memory in use [bytes], except what the contact law keeps during a step.
    #[must_use]
    pub fn memory(&self) -> usize {
        self.soil.memory() + self.contact.memory() + self.seepage.memory()
    }

    /// Memory in use for surfaces and contact points [bytes].
    #[must_use]
    pub fn contact_memory(&self) -> usize {
        self.contact.memory()
    }
}
