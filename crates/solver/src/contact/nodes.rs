//! The contact nodes.

use super::problem::{ContactNode, corners};
use crate::model::Model;
use crate::state::Contact;

/// The contact nodes, in the order of the whole grid, and for each contact point the indices of its cell's
/// nodes among them.
pub(super) fn contact_nodes(model: &Model, contacts: &[Contact]) -> (Vec<ContactNode>, Vec<[u32; 8]>) {
    let [nx, ny, _] = model.grid.whole_cells().map(|n| n + 1);
    let stride = [1, nx, nx * ny];
    let number = |c: &Contact| (0..3).map(|axis| c.cell[axis] as usize * stride[axis]).sum::<usize>();
    let of = |c: &Contact| corners(stride).map(|offset| number(c) + offset);
    let mut nodes: Vec<usize> = contacts.iter().flat_map(of).collect();
    nodes.sort_unstable();
    nodes.dedup();
    let index = |node: usize| nodes.partition_point(|n| *n < node) as u32;
    let corner_nodes = contacts.iter().map(|c| of(c).map(index)).collect();
    let layers = |node: usize| [node % nx, node / nx % ny, node / (nx * ny)];
    (nodes.iter().map(|node| contact_node(model, layers(*node))).collect(), corner_nodes)
}

/// A node of the whole grid.
fn contact_node(model: &Model, whole: [usize; 3]) -> ContactNode {
    let grid = &model.grid;
    ContactNode {
        node: grid.node_index(whole),
        is_owned: grid.owns_node(whole),
        is_free: model.boundaries.free_components(grid, whole),
        ..ContactNode::default()
    }
}
