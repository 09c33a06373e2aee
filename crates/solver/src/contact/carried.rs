//! Remnants of soil in cells that bodies fill: they are carried along.
//!
//! A body that moves on leaves a little soil in the cells that it comes to fill. The nodes round it have no
//! other soil, and nothing but the stress of the remnant would resist the pressure of contact, which would
//! drive them on for ever. They move with the body instead, and contact does not act on them.

use super::body_fraction::{BodyCell, FILLED, by_cell};
use super::problem::corners;
use crate::fields::Soil;
use crate::grid::Grid;
use crate::model::Model;
use crate::scalar::Scalar;
use crate::state::State;
use glam::DVec3;
use std::collections::BTreeMap;

/// Mass of a node over that of one in the midst of soil up to which it belongs to a remnant (chosen: twice
/// what cells that are just filled have space for).
pub(super) const REMNANT: f64 = 0.1;

/// Whether all soil round a node lies in cells that bodies fill.
pub(super) fn is_among_filled<R: Scalar>(
    grid: &Grid,
    soil: &Soil<R>,
    node: usize,
    is_filled: impl Fn(usize) -> bool,
) -> bool {
    let cells = corners(grid.stride).map(|offset| node - offset);
    cells.into_iter().all(|c| soil.fraction[c] <= R::default() || is_filled(c))
}

/// Gives the nodes of remnants the velocity of the body in which they lie; after a remap.
pub(crate) fn carry<R: Scalar>(model: &Model, state: &mut State<R>, body_cells: &[BodyCell]) {
    let grid = &model.grid;
    let mut occupied = by_cell(body_cells);
    occupied.retain(|_, (bodies, _)| *bodies >= FILLED);
    let State { soil, nodes, .. } = &*state;
    let mut carried = BTreeMap::new();
    let with_soil = occupied.iter().filter(|(cell, _)| soil.fraction[**cell] > R::default());
    for (cell, (_, most)) in with_soil {
        let density = model.materials[soil.main_material(*cell)].density;
        for offset in corners(grid.stride) {
            let node = cell + offset;
            let (mass, full) = (nodes.mass[node].to_f64(), density * grid.volume_round(grid.layers_of(node)));
            let is_remnant = mass > model.mass_moved() && mass < REMNANT * full;
            if is_remnant && is_among_filled(grid, soil, node, |c| occupied.contains_key(&c)) {
                carried.entry(node).or_insert(most.body);
            }
        }
    }
    for (node, body) in carried {
        let layers = grid.layers_of(node);
        let at = DVec3::from_array(std::array::from_fn(|axis| grid.faces[axis][layers[axis]]));
        let arm = at + state.grid_position - state.pose(body).position;
        let velocity = state.twist(body).at(arm).to_array();
        let free = model.boundaries.free_components(grid, grid.in_whole(layers));
        for ((field, own), free) in state.nodes.velocity.iter_mut().zip(velocity).zip(free) {
            field[node] = R::cast(if free { own } else { 0.0 });
        }
    }
}
