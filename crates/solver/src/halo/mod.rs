//! What blocks of one grid tell each other: the contents of ghost layers, and values that all must know.

pub mod in_process;

use crate::grid::{GHOSTS, Grid};
use crate::scalar::Scalar;

/// How a block reaches the others. All blocks call the same functions in the same order.
pub trait Halo: Send {
    /// Whether there is no other block.
    fn is_alone(&self) -> bool;

    /// Sends `values` to the neighbour across a cut, the one at the low end (0) or the high end (1) along `axis`, and returns
    /// what that one has sent.
    fn exchange(&mut self, axis: usize, end: usize, values: Vec<f64>) -> Vec<f64>;

    /// Sends `values` to all blocks, and returns what each has sent, one after the other.
    fn gather(&mut self, values: Vec<f64>) -> Vec<f64>;
}

/// One block that is the whole grid.
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

/// What an array belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum At {
    /// Cells.
    Cells,
    /// Nodes.
    Nodes,
}

/// Fills the ghost layers of some arrays with what their owners hold.
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
        let cuts: Vec<usize> = (0..2).filter(|end| grid.is_cut(axis, *end)).collect();
        for end in cuts {
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

/// Layers that the neighbour across a cut needs. Nodes on the cut itself both blocks have.
fn edge(grid: &Grid, at: At, axis: usize, end: usize) -> std::ops::Range<usize> {
    let on_cut = usize::from(at == At::Nodes);
    if end == 0 {
        let own = grid.own[axis].start - grid.first[axis];
        own + on_cut..own + on_cut + GHOSTS
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

/// Rows of the memory in some layers along y or z.
fn rows(grid: &Grid, at: At, axis: usize, layers: std::ops::Range<usize>) -> Vec<usize> {
    let [_, ny, nz] = grid.cells().map(|n| n + usize::from(at == At::Nodes));
    let row = |j: usize, k: usize| (k + 1) * grid.rows() + j + 1;
    if axis == 1 {
        (0..nz).flat_map(|k| layers.clone().map(move |j| row(j, k))).collect()
    } else {
        layers.flat_map(|k| (0..ny).map(move |j| row(j, k))).collect()
    }
}

/// Values of all blocks, each with a key, in the order of the keys: a sum over them is the same however the grid is cut.
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
