//! Communication between the blocks of a grid: exchange of ghost layers, and global gathers.

pub mod in_process;

use crate::grid::{GHOSTS, Grid};
use crate::scalar::Scalar;

/// Communication of a block with the others. All blocks must call the same functions in the same order.
pub trait Halo: Send {
    /// Whether this block is the whole grid.
    fn is_alone(&self) -> bool;

    /// Sends `values` to the neighbour at the low end (0) or the high end (1) along `axis`, and returns what
    /// the neighbour has sent.
    fn exchange(&mut self, axis: usize, end: usize, values: Vec<f64>) -> Vec<f64>;

    /// Sends `values` to all blocks, and returns the values of all, concatenated in the same order
    /// everywhere.
    fn gather(&mut self, values: Vec<f64>) -> Vec<f64>;
}

/// A block that is the whole grid: nothing is exchanged.
#[derive(Clone, Copy, Debug, Default)]
pub struct Whole;

impl Halo for Whole {
    fn is_alone(&self) -> bool {
        true
    }

    fn exchange(&mut self, _: usize, _: usize, values: Vec<f64>) -> Vec<f64> {
        values
    }

    fn gather(&mut self, values: Vec<f64>) -> Vec<f64> {
        values
    }
}

/// Where the values of an array are located.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum At {
    /// Cells.
    Cells,
    /// Nodes.
    Nodes,
}

/// Fills the ghost layers of some arrays with their owners' values.
pub(crate) fn fill<'a, R: Scalar>(
    halo: &mut dyn Halo,
    grid: &Grid,
    at: At,
    arrays: impl IntoIterator<Item = &'a mut Vec<R>>,
) {
    if halo.is_alone() {
        return;
    }
    let mut arrays: Vec<_> = arrays.into_iter().collect();
    for axis in [1, 2] {
        let ends: Vec<usize> = (0..2).filter(|end| grid.is_cut(axis, *end)).collect();
        for end in ends {
            let sent = rows(grid, at, axis, edge(grid, at, axis, end));
            let mut values = Vec::with_capacity(sent.len() * arrays.len() * grid.stride[1]);
            for array in &arrays {
                for row in &sent {
                    let own = &array[row * grid.stride[1]..][..grid.stride[1]];
                    values.extend(own.iter().map(|value| value.to_f64()));
                }
            }
            let received = halo.exchange(axis, end, values);
            let filled = rows(grid, at, axis, ghosts(grid, at, axis, end));
            let mut received = received.chunks_exact(grid.stride[1]);
            for array in &mut arrays {
                for row in &filled {
                    let own = &mut array[row * grid.stride[1]..][..grid.stride[1]];
                    for (value, new) in own.iter_mut().zip(received.next().unwrap_or_default()) {
                        *value = R::cast(*new);
                    }
                }
            }
        }
    }
}

/// Layers needed by the neighbour at an end. Both blocks hold the nodes on the boundary between them.
fn edge(grid: &Grid, at: At, axis: usize, end: usize) -> std::ops::Range<usize> {
    let on_boundary = usize::from(at == At::Nodes);
    if end == 0 {
        let own = grid.own[axis].start - grid.first[axis];
        own + on_boundary..own + on_boundary + GHOSTS
    } else {
        let beyond = grid.own[axis].end - grid.first[axis];
        beyond - GHOSTS..beyond
    }
}

/// Ghost layers at an end.
fn ghosts(grid: &Grid, at: At, axis: usize, end: usize) -> std::ops::Range<usize> {
    if end == 0 {
        0..GHOSTS
    } else {
        let own = grid.own[axis].end - grid.first[axis] + usize::from(at == At::Nodes);
        own..own + GHOSTS
    }
}

/// Indices of the memory rows in some layers along y or z.
fn rows(grid: &Grid, at: At, axis: usize, layers: std::ops::Range<usize>) -> Vec<usize> {
    let [_, ny, nz] = grid.cells().map(|n| n + usize::from(at == At::Nodes));
    let row = |j: usize, k: usize| (k + 1) * grid.rows() + j + 1;
    if axis == 1 {
        (0..nz).flat_map(|k| layers.clone().map(move |j| row(j, k))).collect()
    } else {
        layers.flat_map(|k| (0..ny).map(move |j| row(j, k))).collect()
    }
}

/// Values of all blocks with their keys, sorted by key, so that a sum over them does not depend on the
/// partition of the grid.
pub(crate) fn in_order<const N: usize>(
    halo: &mut dyn Halo,
    own: impl Iterator<Item = (usize, [f64; N])>,
) -> Vec<(usize, [f64; N])> {
    let values = own.flat_map(|(key, values)| std::iter::once(key as f64).chain(values)).collect();
    let all = halo.gather(values);
    let mut all: Vec<(usize, [f64; N])> = all
        .chunks_exact(N + 1)
        .map(|entry| (entry[0] as usize, std::array::from_fn(|n| entry[n + 1])))
        .collect();
    all.sort_by_key(|(key, _)| *key);
    all
}
