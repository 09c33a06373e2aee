//! The contact nodes.

use super::problem::{ContactNode, corners};
use crate::grid::Grid;
use crate::model::Model;
use crate::state::Contact;

/// The contact nodes, in the order of the whole grid, and for each contact point the indices of its cell's
/// nodes among them.
pub(super) fn contact_nodes(model: &Model, contacts: &[Contact]) -> (Vec<ContactNode>, Vec<[u32; 8]>) {
    let of = |c: &Contact| corners_in_whole(&model.grid, c.cell.map(|layer| layer as usize));
    let mut nodes: Vec<usize> = contacts.iter().flat_map(of).collect();
    nodes.sort_unstable();
    nodes.dedup();
    let index = |node: usize| nodes.partition_point(|n| *n < node) as u32;
    let corner_nodes = contacts.iter().map(|c| of(c).map(index)).collect();
    let [_, nx, plane] = stride_in_whole(&model.grid);
    let layers = |node: usize| [node % nx, node % plane / nx, node / plane];
    (nodes.iter().map(|node| contact_node(model, layers(*node))).collect(), corner_nodes)
}

/// Numbers of a cell's nodes in the whole grid.
pub(super) fn corners_in_whole(grid: &Grid, cell: [usize; 3]) -> [usize; 8] {
    let stride = stride_in_whole(grid);
    let first: usize = (0..3).map(|axis| cell[axis] * stride[axis]).sum();
    corners(stride).map(|offset| first + offset)
}

/// Distances between the numbers of neighbouring nodes of the whole grid along each axis.
fn stride_in_whole(grid: &Grid) -> [usize; 3] {
    let [nx, ny, _] = grid.whole_cells().map(|n| n + 1);
    [1, nx, nx * ny]
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
