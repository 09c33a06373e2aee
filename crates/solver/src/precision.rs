//! The two precisions of the soil's fields, for those who hold a state of either and need not know which.

use crate::cpu::stopwatch::Stopwatch;
use crate::error::Breakdown;
use crate::footprint::Footprint;
use crate::model::{Filling, Model};
use crate::state::State;
use crate::{double, single};
use glam::DVec3;
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::fmt::Debug;

/// `f64` or `f32`.
pub trait Precision:
    Copy + Default + PartialEq + Debug + Into<f64> + Send + Sync + Serialize + DeserializeOwned + 'static
{
    /// Its name in case files and reports.
    const NAME: &'static str;
    /// Numbers in the widest vector.
    const LANES: usize;
    /// Memory that steps work in.
    type Workspace: Debug;

    /// See [`double::start::start_under`].
    fn start_under(model: &Model, filling: &Filling, overburden: f64) -> State<Self>;
    /// See [`double::start::start_filled`].
    fn start_filled(model: &Model, fraction: Vec<Self>) -> State<Self>;
    /// See [`double::start::set_in_motion`].
    fn set_in_motion(model: &Model, state: &mut State<Self>, velocity: DVec3);
    /// See [`double::workspace::Workspace::new`].
    fn workspace(model: &Model, state: &State<Self>, threads: usize) -> Self::Workspace;
    /// See [`double::step::step`].
    ///
    /// # Errors
    /// [`Breakdown`] when the state has become unphysical.
    fn step(model: &Model, state: &mut State<Self>, workspace: &mut Self::Workspace)
    -> Result<(), Breakdown>;
    /// Number of threads.
    fn threads(workspace: &Self::Workspace) -> usize;
    /// Memory that a workspace takes up [bytes].
    fn memory(workspace: &Self::Workspace) -> usize;
    /// See [`double::footprint::footprint`].
    fn footprint(model: &Model, threads: usize, moved: &[DVec3]) -> Footprint;
    /// Where the time of the calling thread goes.
    fn stopwatch(workspace: &mut Self::Workspace) -> &mut Stopwatch;
    /// Kinetic energy of soil and bodies [J] (modelled share).
    fn kinetic_energy(model: &Model, state: &State<Self>) -> f64;
    /// Elastic energy of the soil [J].
    fn elastic_energy(model: &Model, state: &State<Self>) -> f64;
    /// Volume of the soil [m³].
    fn soil_volume(model: &Model, state: &State<Self>) -> f64;
}

macro_rules! precision {
    ($module:ident, $name:literal) => {
        impl Precision for $module::Real {
            const NAME: &'static str = $name;
            const LANES: usize = $module::LANES;
            type Workspace = $module::workspace::Workspace;

            fn start_under(model: &Model, filling: &Filling, overburden: f64) -> State<Self> {
                $module::start::start_under(model, filling, overburden)
            }

            fn start_filled(model: &Model, fraction: Vec<Self>) -> State<Self> {
                $module::start::start_filled(model, fraction)
            }

            fn set_in_motion(model: &Model, state: &mut State<Self>, velocity: DVec3) {
                $module::start::set_in_motion(model, state, velocity);
            }

            fn workspace(model: &Model, state: &State<Self>, threads: usize) -> Self::Workspace {
                Self::Workspace::new(model, state, threads)
            }

            fn step(
                model: &Model,
                state: &mut State<Self>,
                workspace: &mut Self::Workspace,
            ) -> Result<(), Breakdown> {
                $module::step::step(model, state, workspace)
            }

            fn threads(workspace: &Self::Workspace) -> usize {
                workspace.threads()
            }

            fn memory(workspace: &Self::Workspace) -> usize {
                workspace.memory()
            }

            fn footprint(model: &Model, threads: usize, moved: &[DVec3]) -> Footprint {
                $module::footprint::footprint(model, threads, moved)
            }

            fn stopwatch(workspace: &mut Self::Workspace) -> &mut Stopwatch {
                workspace.stopwatch()
            }

            fn kinetic_energy(model: &Model, state: &State<Self>) -> f64 {
                $module::audit::kinetic_energy(model, state)
            }

            fn elastic_energy(model: &Model, state: &State<Self>) -> f64 {
                $module::audit::elastic_energy(model, state)
            }

            fn soil_volume(model: &Model, state: &State<Self>) -> f64 {
                $module::energy::soil_volume(&model.grid, &state.soil)
            }
        }
    };
}

precision!(double, "double");
precision!(single, "single");
