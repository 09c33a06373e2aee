//! The time step compiled for each precision.

use crate::error::Breakdown;
use crate::halo::Halo;
use crate::model::{Ground, Model};
use crate::precision::Precision;
use crate::rest;
use crate::state::State;
use crate::step;
use crate::workspace::Workspace;

macro_rules! compiled {
    ($real:ty) => {
        impl Precision for $real {
            fn step(
                model: &Model,
                state: &mut State<Self>,
                workspace: &mut Workspace<Self>,
            ) -> Result<(), Breakdown> {
                step::stages(model, state, workspace)
            }

            fn at_rest_on(model: &Model, ground: &Ground) -> State<Self> {
                rest::of_ground(model, ground)
            }

            fn at_rest_filled(model: &Model, fraction: Vec<Self>) -> State<Self> {
                rest::of_fractions(model, fraction)
            }

            fn workspace(
                model: &Model,
                state: &mut State<Self>,
                threads: usize,
                halo: Halo,
            ) -> Workspace<Self> {
                Workspace::prepared(model, state, threads, halo)
            }
        }
    };
}

compiled!(f64);
compiled!(f32);
