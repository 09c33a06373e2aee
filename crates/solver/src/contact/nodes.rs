//! The nodes that contact acts on.

use super::scene::{TouchedNode, corners};
use crate::model::Model;
use crate::state::Contact;

/// The nodes that contact acts on, in memory order, and for each contact the places of its cell's nodes among them.
pub(super) fn contact_nodes(model: &Model, contacts: &[Contact]) -> (Vec<TouchedNode>, Vec<[u32; 8]>) {
    let grid = &model.grid;
    let of = |c: &Contact| corners(grid.stride).map(|offset| c.base + offset);
    let mut nodes: Vec<usize> = contacts.iter().flat_map(of).collect();
    nodes.sort_unstable();
    nodes.dedup();
    let place = |node: usize| nodes.partition_point(|n| *n < node) as u32;
    let corner_nodes = contacts.iter().map(|c| of(c).map(place)).collect();
    let touched = |node| TouchedNode {
        node,
        free_of_walls: model.boundaries.free_components(grid.place(node), grid.cells()),
        ..TouchedNode::default()
    };
    (nodes.into_iter().map(touched).collect(), corner_nodes)
}
