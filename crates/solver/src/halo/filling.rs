//! Filling of ghost layers at cuts with the values of the blocks that own them, in one call, or in two with
//! something to compute between.

use super::Halo;
use super::decomposition::Neighbour;
use crate::grid::{GHOSTS, Grid};
use crate::scalar::Scalar;
use std::ops::Range;

/// Where the values of an array are located.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum At {
    /// Cells.
    Cells,
    /// Nodes.
    Nodes,
}

/// Ghost layers at cuts: of cells or of nodes, so many from the block outwards.
#[derive(Clone, Copy)]
pub(crate) struct Layers {
    /// Where the values are located.
    pub(crate) at: At,
    /// Number of layers, at most [`GHOSTS`].
    pub(crate) depth: usize,
}

/// Fills the ghost layers of some arrays with their owners' values.
pub(crate) fn fill<'a, R: Scalar>(
    halo: &Halo,
    grid: &Grid,
    at: At,
    arrays: impl IntoIterator<Item = &'a mut Vec<R>>,
) {
    fill_layers(halo, grid, Layers { at, depth: GHOSTS }, arrays);
}

/// Fills the first of the ghost layers only, beside the block.
pub(crate) fn fill_first<'a, R: Scalar>(
    halo: &Halo,
    grid: &Grid,
    at: At,
    arrays: impl IntoIterator<Item = &'a mut Vec<R>>,
) {
    fill_layers(halo, grid, Layers { at, depth: 1 }, arrays);
}

fn fill_layers<'a, R: Scalar>(
    halo: &Halo,
    grid: &Grid,
    layers: Layers,
    arrays: impl IntoIterator<Item = &'a mut Vec<R>>,
) {
    if !halo.is_alone() {
        let mut arrays: Vec<_> = arrays.into_iter().collect();
        begin_filling(halo, grid, layers, arrays.iter().map(|array| &**array));
        end_filling(halo, grid, layers, arrays.iter_mut().map(|array| &mut **array));
    }
}

/// Begins to fill ghost layers: sends the neighbours what they need.
pub(crate) fn begin_filling<'a, R: Scalar>(
    halo: &Halo,
    grid: &Grid,
    layers: Layers,
    arrays: impl Iterator<Item = &'a Vec<R>> + Clone,
) {
    let stride = grid.stride[1];
    let message = |neighbour: &Neighbour| {
        let sent = rows(grid, [1, 2].map(|axis| layers.edge(grid, axis, neighbour.side[axis - 1])));
        let mut values = Vec::with_capacity(sent.len() * arrays.clone().count() * stride);
        for array in arrays.clone() {
            for row in &sent {
                values.extend(array[row * stride..][..stride].iter().map(|value| value.to_f64()));
            }
        }
        (neighbour.rank, values)
    };
    halo.begin_exchange(halo.neighbours.iter().map(message).collect());
}

/// Fills the ghost layers with what the neighbours have sent.
pub(crate) fn end_filling<'a, R: Scalar>(
    halo: &Halo,
    grid: &Grid,
    layers: Layers,
    arrays: impl Iterator<Item = &'a mut Vec<R>>,
) {
    let stride = grid.stride[1];
    let received = halo.end_exchange();
    let filled = halo
        .neighbours
        .iter()
        .map(|neighbour| rows(grid, [1, 2].map(|axis| layers.ghosts(grid, axis, neighbour.side[axis - 1]))));
    let mut each: Vec<_> =
        filled.zip(&received).map(|(rows, values)| (rows, values.chunks_exact(stride))).collect();
    for array in arrays {
        for (rows, values) in &mut each {
            for (row, new) in rows.iter().zip(values) {
                let own = &mut array[row * stride..][..stride];
                own.iter_mut().zip(new).for_each(|(value, new)| *value = R::cast(*new));
            }
        }
    }
}

impl Layers {
    /// Layers along an axis needed by the neighbour on a side. Both blocks hold the nodes on the boundary
    /// between them.
    fn edge(self, grid: &Grid, axis: usize, side: i32) -> Range<usize> {
        let Self { at, depth } = self;
        let beyond = grid.own[axis].end - grid.first[axis];
        match side {
            0 => between_cuts(grid, at, axis),
            1 => beyond - depth..beyond,
            _ => {
                let first = grid.own[axis].start - grid.first[axis] + usize::from(at == At::Nodes);
                first..first + depth
            }
        }
    }

    /// Ghost layers along an axis that the neighbour on a side owns.
    fn ghosts(self, grid: &Grid, axis: usize, side: i32) -> Range<usize> {
        let Self { at, depth } = self;
        match side {
            0 => between_cuts(grid, at, axis),
            1 => {
                let first = grid.own[axis].end - grid.first[axis] + usize::from(at == At::Nodes);
                first..first + depth
            }
            _ => GHOSTS - depth..GHOSTS,
        }
    }
}

/// All layers along an axis but the ghost layers at cuts.
fn between_cuts(grid: &Grid, at: At, axis: usize) -> Range<usize> {
    let (own, first, on_boundary) = (&grid.own[axis], grid.first[axis], usize::from(at == At::Nodes));
    let low = if grid.is_cut(axis, 0) { own.start - first } else { 0 };
    let high = if grid.is_cut(axis, 1) { own.end - first } else { grid.cells()[axis] };
    low..high + on_boundary
}

/// Indices of the memory rows in some layers along y and z.
fn rows(grid: &Grid, [y, z]: [Range<usize>; 2]) -> Vec<usize> {
    z.flat_map(|k| y.clone().map(move |j| (k + 1) * grid.rows() + j + 1)).collect()
}
