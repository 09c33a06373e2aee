//! Communication between the blocks of a grid: exchange of ghost layers, sums, and gathers.

pub mod decomposition;
pub mod in_process;
#[cfg(feature = "mpi")]
pub mod mpi;

use crate::grid::{GHOSTS, Grid};
use crate::scalar::Scalar;
use decomposition::Decomposition;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Instant;

/// The processes of a run, each with a block of the grid, as one of them sees them. All must call the same functions in the same
/// order.
pub trait Communicator: Send {
    /// Number of this process, from 0.
    fn rank(&self) -> usize;

    /// Number of processes.
    fn size(&self) -> usize;

    /// Sends values to two other processes and returns what these have sent here; nothing where there is none. Lengths are the same
    /// in both directions.
    fn exchange(&mut self, with: [Option<usize>; 2], values: [Vec<f64>; 2]) -> [Vec<f64>; 2];

    /// Sends `values` to all processes, and returns those of each.
    fn gather(&mut self, values: &[f64]) -> Vec<Vec<f64>>;

    /// Sends `values` to process 0, which gets those of each; the others get nothing.
    fn collect(&mut self, values: &[f64]) -> Vec<Vec<f64>>;

    /// Sends each process its own values, those of number `n` to process `n`, and returns what each has sent here.
    fn deliver(&mut self, values: Vec<Vec<f64>>) -> Vec<Vec<f64>>;

    /// Replaces each of `values` by its sum over all processes.
    fn add(&mut self, values: &mut [i64]);

    /// Replaces each of `values` by the largest in any process.
    fn largest(&mut self, values: &mut [f64]);

    /// Ends all processes, with an exit code: this one cannot go on, and the others would wait for it.
    fn abort(&mut self, code: i32);
}

/// The only process of a run.
#[derive(Clone, Copy, Debug)]
pub struct Alone;

impl Communicator for Alone {
    fn rank(&self) -> usize {
        0
    }

    fn size(&self) -> usize {
        1
    }

    fn exchange(&mut self, _: [Option<usize>; 2], _: [Vec<f64>; 2]) -> [Vec<f64>; 2] {
        Default::default()
    }

    fn gather(&mut self, values: &[f64]) -> Vec<Vec<f64>> {
        vec![values.to_vec()]
    }

    fn collect(&mut self, values: &[f64]) -> Vec<Vec<f64>> {
        self.gather(values)
    }

    fn deliver(&mut self, values: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
        values
    }

    fn add(&mut self, _: &mut [i64]) {}

    fn largest(&mut self, _: &mut [f64]) {}

    fn abort(&mut self, _: i32) {}
}

/// What a process has sent so far.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Traffic {
    /// Messages to neighbours.
    pub messages: u64,
    /// Bytes in them.
    pub message_bytes: u64,
    /// Operations of all processes together.
    pub collectives: u64,
    /// Bytes that this process has put into them.
    pub collective_bytes: u64,
    /// Time spent on all this, waiting for others included [s].
    pub seconds: f64,
}

/// Communication of a block with the others; nothing for a block that is the whole grid.
#[derive(Default)]
pub struct Halo {
    line: Option<Mutex<Line>>,
    rank: usize,
    blocks: usize,
    /// Ranks of the neighbours along y and z, at the low end and at the high end.
    neighbours: [[Option<usize>; 2]; 2],
    /// Numbers of blocks beyond it along y and z, at the low end and at the high end.
    beyond: [[usize; 2]; 2],
}

/// The communicator, and what went through it.
struct Line {
    communicator: Box<dyn Communicator>,
    traffic: Traffic,
}

impl std::fmt::Debug for Halo {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Halo of block {} of {}", self.rank, self.blocks())
    }
}

impl Halo {
    /// A block that is the whole grid.
    #[must_use]
    pub fn whole() -> Self {
        Self::default()
    }

    /// The block that a process has in a decomposition with one for each.
    ///
    /// # Panics
    /// If there are not as many processes as blocks.
    #[must_use]
    pub fn of_block(decomposition: &Decomposition, communicator: Box<dyn Communicator>) -> Self {
        let (rank, blocks) = (communicator.rank(), communicator.size());
        assert!(blocks == decomposition.count(), "one block for each process");
        let neighbours = decomposition.neighbours(rank);
        let line = (blocks > 1).then(|| Mutex::new(Line { communicator, traffic: Traffic::default() }));
        Self { line, rank, blocks, neighbours, beyond: decomposition.beyond(rank) }
    }

    /// Whether this block is the whole grid.
    #[must_use]
    pub fn is_alone(&self) -> bool {
        self.line.is_none()
    }

    /// Number of this block.
    #[must_use]
    pub fn rank(&self) -> usize {
        self.rank
    }

    /// Number of blocks.
    #[must_use]
    pub fn blocks(&self) -> usize {
        self.blocks.max(1)
    }

    /// Numbers of blocks along `axis`, 1 or 2, beyond the low end of this one and beyond its high end.
    #[must_use]
    pub fn beyond(&self, axis: usize) -> [usize; 2] {
        self.beyond[axis - 1]
    }

    /// The same communicator, for a grid that is cut anew.
    ///
    /// # Panics
    /// If there are not as many processes as blocks.
    #[must_use]
    pub fn recut(self, decomposition: &Decomposition) -> Self {
        let Self { line, rank, blocks, .. } = self;
        assert!(blocks.max(1) == decomposition.count(), "one block for each process");
        let (neighbours, beyond) = (decomposition.neighbours(rank), decomposition.beyond(rank));
        Self { line, rank, blocks, neighbours, beyond }
    }

    /// What this block has sent so far.
    #[must_use]
    pub fn traffic(&self) -> Traffic {
        self.line().map_or_else(Traffic::default, |line| line.traffic)
    }

    fn line(&self) -> Option<MutexGuard<'_, Line>> {
        self.line.as_ref().map(|line| line.lock().unwrap_or_else(PoisonError::into_inner))
    }

    /// Sends values to the neighbours at the low end and at the high end along `axis`, 1 or 2, and returns what these have sent;
    /// nothing where there is none. What is sent both ways between two blocks is of the same length.
    pub fn exchange(&self, axis: usize, values: [Vec<f64>; 2]) -> [Vec<f64>; 2] {
        let Some(mut line) = self.line() else { return Default::default() };
        let with = self.neighbours[axis - 1];
        for (_, own) in with.iter().zip(&values).filter(|(with, _)| with.is_some()) {
            line.traffic.messages += 1;
            line.traffic.message_bytes += size_of_val(own.as_slice()) as u64;
        }
        line.timed(|communicator| communicator.exchange(with, values))
    }

    /// The values of all blocks, those of the first first, the same everywhere.
    pub fn gather(&self, values: Vec<f64>) -> Vec<f64> {
        match self.line() {
            None => values,
            Some(mut line) => line
                .collectively(size_of_val(values.as_slice()), |communicator| communicator.gather(&values))
                .concat(),
        }
    }

    /// The values of each block, in block 0; nothing in the others.
    pub fn collect(&self, values: Vec<f64>) -> Vec<Vec<f64>> {
        match self.line() {
            None => vec![values],
            Some(mut line) => line
                .collectively(size_of_val(values.as_slice()), |communicator| communicator.collect(&values)),
        }
    }

    /// Sends each block its own values, and returns what each has sent to this one.
    pub fn deliver(&self, values: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
        match self.line() {
            None => values,
            Some(mut line) => line.timed(|communicator| communicator.deliver(values)),
        }
    }

    /// Replaces each of `values` by its sum over all blocks.
    pub fn add(&self, values: &mut [i64]) {
        if let Some(mut line) = self.line() {
            line.collectively(size_of_val(values), |communicator| communicator.add(values));
        }
    }

    /// Replaces each of `values` by the largest in any block.
    pub fn largest(&self, values: &mut [f64]) {
        if let Some(mut line) = self.line() {
            line.collectively(size_of_val(values), |communicator| communicator.largest(values));
        }
    }

    /// Waits for all blocks.
    pub fn meet(&self) {
        self.add(&mut [0]);
    }

    /// Ends the processes of all blocks, with an exit code: this one cannot go on, and the others would wait for it. Where there are no
    /// others, nothing happens.
    pub fn abort(&self, code: i32) {
        if let Some(mut line) = self.line() {
            line.communicator.abort(code);
        }
    }
}

impl Line {
    /// Communicates, and adds the time that this takes.
    fn timed<T>(&mut self, communicate: impl FnOnce(&mut dyn Communicator) -> T) -> T {
        let clock = Instant::now();
        let outcome = communicate(self.communicator.as_mut());
        self.traffic.seconds += clock.elapsed().as_secs_f64();
        outcome
    }

    /// The same for an operation of all processes, into which so many bytes go.
    fn collectively<T>(&mut self, bytes: usize, communicate: impl FnOnce(&mut dyn Communicator) -> T) -> T {
        self.traffic.collectives += 1;
        self.traffic.collective_bytes += bytes as u64;
        self.timed(communicate)
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
    halo: &Halo,
    grid: &Grid,
    at: At,
    arrays: impl IntoIterator<Item = &'a mut Vec<R>>,
) {
    fill_layers(halo, grid, (at, GHOSTS), arrays);
}

/// Fills the first of the ghost layers only, beside the block.
pub(crate) fn fill_first<'a, R: Scalar>(
    halo: &Halo,
    grid: &Grid,
    at: At,
    arrays: impl IntoIterator<Item = &'a mut Vec<R>>,
) {
    fill_layers(halo, grid, (at, 1), arrays);
}

/// Fills so many ghost layers, from the block outwards.
fn fill_layers<'a, R: Scalar>(
    halo: &Halo,
    grid: &Grid,
    (at, depth): (At, usize),
    arrays: impl IntoIterator<Item = &'a mut Vec<R>>,
) {
    if halo.is_alone() {
        return;
    }
    let mut arrays: Vec<_> = arrays.into_iter().collect();
    let stride = grid.stride[1];
    for axis in [1, 2] {
        let sent = [0, 1].map(|end| {
            let mut values = Vec::new();
            if grid.is_cut(axis, end) {
                let sent = rows(grid, at, axis, edge(grid, (at, depth), axis, end));
                values.reserve(sent.len() * arrays.len() * stride);
                for array in &arrays {
                    for row in &sent {
                        values.extend(array[row * stride..][..stride].iter().map(|value| value.to_f64()));
                    }
                }
            }
            values
        });
        for (end, received) in halo.exchange(axis, sent).into_iter().enumerate() {
            if !grid.is_cut(axis, end) {
                continue;
            }
            let filled = rows(grid, at, axis, ghosts(grid, (at, depth), axis, end));
            let mut received = received.chunks_exact(stride);
            for array in &mut arrays {
                for row in &filled {
                    let own = &mut array[row * stride..][..stride];
                    for (value, new) in own.iter_mut().zip(received.next().unwrap_or_default()) {
                        *value = R::cast(*new);
                    }
                }
            }
        }
    }
}

/// Layers needed by the neighbour at an end. Both blocks hold the nodes on the boundary between them.
fn edge(grid: &Grid, (at, depth): (At, usize), axis: usize, end: usize) -> std::ops::Range<usize> {
    let on_boundary = usize::from(at == At::Nodes);
    if end == 0 {
        let own = grid.own[axis].start - grid.first[axis];
        own + on_boundary..own + on_boundary + depth
    } else {
        let beyond = grid.own[axis].end - grid.first[axis];
        beyond - depth..beyond
    }
}

/// Ghost layers at an end.
fn ghosts(grid: &Grid, (at, depth): (At, usize), axis: usize, end: usize) -> std::ops::Range<usize> {
    if end == 0 {
        GHOSTS - depth..GHOSTS
    } else {
        let own = grid.own[axis].end - grid.first[axis] + usize::from(at == At::Nodes);
        own..own + depth
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
    halo: &Halo,
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
