//! The state before the first step: soil at rest under its own weight, bodies where the case puts them.

use crate::balance::kinetic_energy;
use crate::grid::Grid;
use crate::halo::Halo;
pub use crate::model::Filling;
use crate::model::{Ground, Model};
use crate::precision::Precision;
use crate::state::{State, Twist};
use crate::uneven;
use glam::DVec3;
use std::ops::Range;

/// The state at rest of a box of soil.
#[must_use]
pub fn at_rest<R: Precision>(model: &Model, filling: &Filling) -> State<R> {
    at_rest_on(model, &Ground { fillings: vec![*filling], ..Ground::default() })
}

/// The state at rest of any ground. If there is an overburden, the soil reaches up to the lid of the box,
/// which does not move and bears the pressure from then on.
#[must_use]
pub fn at_rest_on<R: Precision>(model: &Model, ground: &Ground) -> State<R> {
    R::at_rest_on(model, ground)
}

/// Layers of a slab of the grid in which the state at rest of a block is found.
const SLAB: usize = 16;

/// The state at rest of a block of the grid, on the model's ground; the grid of the model is the whole before
/// and the block afterwards. Stresses are those under all that lies above, also where the grid is cut along
/// z: they are found in one slab across y after the other, so that no process needs memory for the whole.
#[must_use]
pub fn at_rest_in_block<R: Precision>(model: &mut Model, own: [Range<usize>; 3]) -> State<R> {
    let block = model.grid.block(own);
    let whole = std::mem::replace(&mut model.grid, block.clone());
    if !(block.is_cut(2, 0) || block.is_cut(2, 1)) {
        return at_rest_on(model, &model.ground);
    }
    let needed = block.first[1]..block.first[1] + block.cells()[1];
    let needed = needed.start.max(whole.domain[1].start)..needed.end.min(whole.domain[1].end);
    let last = whole.domain[1].end.saturating_sub(SLAB).max(whole.domain[1].start);
    let mut state: Option<State<R>> = None;
    for start in needed.clone().step_by(SLAB).map(|start| start.min(last)) {
        let rows = start..(start + SLAB).min(whole.domain[1].end);
        model.grid = whole.block([whole.domain[0].clone(), rows, whole.domain[2].clone()]);
        let slab = at_rest_on::<R>(model, &model.ground);
        let own = state.get_or_insert_with(|| slab.without_soil(&block));
        own.take_over(&block, &slab, &model.grid);
    }
    model.grid = block;
    state.unwrap_or_else(|| at_rest_on(model, &model.ground))
}

/// The state at rest of soil of any shape, of the first material: its volume fraction in every cell (see
/// [`Grid::index`]).
#[must_use]
pub fn at_rest_filled<R: Precision>(model: &Model, fraction: Vec<R>) -> State<R> {
    R::at_rest_filled(model, fraction)
}

/// Volume fractions of undisturbed ground in the cells of a grid.
#[must_use]
pub fn undisturbed_fractions(grid: &Grid, ground: &Ground) -> Vec<f64> {
    let mut fractions = vec![0.0; grid.entries];
    uneven::portions(grid, ground, |cell, portions| {
        fractions[cell] = portions.iter().sum::<f64>().min(1.0);
    });
    fractions
}

/// Sets all soil in motion with a velocity [m/s], but for what the walls hold; the energy balance counts its
/// energy as external work.
pub fn set_in_motion<R: Precision>(model: &Model, state: &mut State<R>, velocity: DVec3, halo: &Halo) {
    for n in (0..model.grid.entries).filter(|n| state.nodes.mass[*n] > R::default()) {
        let layers = model.grid.layers_of(n);
        let free = model.boundaries.free_components(&model.grid, model.grid.in_whole(layers));
        for ((field, own), free) in state.nodes.velocity.iter_mut().zip(velocity.to_array()).zip(free) {
            field[n] = R::cast(if free { own } else { 0.0 });
        }
    }
    state.energy_balance.kinetic_start = kinetic_energy(model, state, halo);
}

/// Sets a body in motion at the start, as far as its fixed motions and joints allow; the energy balance
/// counts its energy as external work.
pub fn set_body_in_motion<R: Precision>(model: &Model, state: &mut State<R>, body: usize, twist: Twist) {
    let mut start: Vec<_> = state.mechanism.bodies.iter().map(|body| (body.pose, body.twist)).collect();
    start[body].1 = twist;
    state.mechanism = model.mechanism().state(&start);
    state.energy_balance.kinetic_start = kinetic_energy(model, state, &Halo::whole());
}
