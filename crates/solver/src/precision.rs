//! The precision of the fields, as programs that use the solver see it.

use crate::cpu::fields_on_device::DeviceStage;
use crate::error::Breakdown;
use crate::halo::Halo;
use crate::halo::decomposition::Decomposition;
use crate::kernels::Kernels;
use crate::model::{Ground, Model};
pub use crate::scalar::Scalar;
use crate::state::State;
use crate::workspace::Workspace;

/// A number type for which the time step is compiled: `f64` or `f32`. Each method is what the function that
/// it names calls; it is compiled in this crate, and not again in each program.
pub trait Precision: Kernels {
    /// See [`step`](crate::step::step).
    ///
    /// # Errors
    /// [`Breakdown`] when the state has become unphysical.
    fn step(model: &Model, state: &mut State<Self>, workspace: &mut Workspace<Self>)
    -> Result<(), Breakdown>;

    /// See [`at_rest_on`](crate::initial::at_rest_on).
    fn at_rest_on(model: &Model, ground: &Ground) -> State<Self>;

    /// See [`at_rest_filled`](crate::initial::at_rest_filled).
    fn at_rest_filled(model: &Model, fraction: Vec<Self>) -> State<Self>;

    /// See [`Workspace::of_block`].
    fn workspace(model: &Model, state: &mut State<Self>, threads: usize, halo: Halo) -> Workspace<Self>;
}

impl<R: Precision> Workspace<R> {
    /// Workspace for a model and a team of `threads`. Before the first step, this includes the first contact
    /// search.
    #[must_use]
    pub fn new(model: &Model, state: &mut State<R>, threads: usize) -> Self {
        Self::of_block(model, state, threads, Halo::whole())
    }

    /// Scratch memory for one block of a partitioned grid.
    #[must_use]
    pub fn of_block(model: &Model, state: &mut State<R>, threads: usize, halo: Halo) -> Self {
        R::workspace(model, state, threads, halo)
    }

    /// A workspace for another state of the same model, with the same threads and device.
    pub fn restart(&mut self, model: &Model, state: &mut State<R>) {
        let mut device = self.soil.device.take();
        *self = Self::of_block(model, state, self.threads(), Halo::whole());
        if let Some(device) = &mut device {
            device.changed();
        }
        self.soil.device = device;
    }

    /// Passes soil from block to block until the grid is cut in this way; changes no bit of the run. All
    /// blocks must do so after the same step.
    ///
    /// # Panics
    /// If there are not as many blocks as before.
    pub fn recut(&mut self, model: &mut Model, state: &mut State<R>, cut: &Decomposition) {
        let threads = self.threads();
        (model.grid, *state) = state.recut(&model.grid, cut, &self.halo);
        let halo = std::mem::take(&mut self.halo).recut(cut);
        *self = Self::of_block(model, state, threads, halo);
    }
}
