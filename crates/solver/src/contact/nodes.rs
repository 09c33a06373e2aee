//! The nodes that contact acts on.

use super::scene::{TouchedNode, corners};
use crate::model::{Model, Wall};
use crate::state::Contact;
use glam::DVec3;

/// The nodes that contact acts on, in memory order, and for each contact the places of its cell's nodes among them.
pub(super) fn contact_nodes(model: &Model, contacts: &[Contact]) -> (Vec<TouchedNode>, Vec<[u32; 8]>) {
    let grid = &model.grid;
    let of = |c: &Contact| corners(grid.stride).map(|offset| c.base + offset);
    let mut nodes: Vec<usize> = contacts.iter().flat_map(of).collect();
    nodes.sort_unstable();
    nodes.dedup();
    let place = |node: usize| nodes.partition_point(|n| *n < node) as u32;
    let corner_nodes = contacts.iter().map(|c| of(c).map(place)).collect();
    let touched =
        |node| TouchedNode { node, free_of_walls: free_of_walls(model, node), ..TouchedNode::default() };
    (nodes.into_iter().map(touched).collect(), corner_nodes)
}

/// 1 along the axes in which no wall stops a node, 0 along the others.
fn free_of_walls(model: &Model, node: usize) -> DVec3 {
    let place = model.grid.place(node);
    let cells = model.grid.cells();
    let mut free = DVec3::ONE;
    for axis in 0..3 {
        for (wall, at) in model.walls[axis].iter().zip([0, cells[axis]]) {
            match wall {
                Wall::Smooth if place[axis] == at => free[axis] = 0.0,
                Wall::Fixed if place[axis] == at => free = DVec3::ZERO,
                _ => {}
            }
        }
    }
    free
}
