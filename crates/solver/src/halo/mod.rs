//! Communication between the blocks of a grid: exchange of ghost layers, sums, and gathers.

pub mod decomposition;
pub mod in_process;
#[cfg(feature = "mpi")]
pub mod mpi;

use crate::grid::{GHOSTS, Grid};
use crate::scalar::Scalar;
use decomposition::{Decomposition, Neighbour};
use std::ops::Range;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Instant;

/// The processes of a run, each with a block of the grid, as one of them sees them. All must call the same functions in the same
/// order; one operation of each kind may have begun, others may begin and end before it ends.
pub trait Communicator: Send {
    /// Number of this process, from 0.
    fn rank(&self) -> usize;

    /// Number of processes.
    fn size(&self) -> usize;

    /// Begins to send each of these processes a message, and to receive one of the same length from it.
    fn begin_exchange(&mut self, messages: Vec<(usize, Vec<f64>)>);

    /// Ends the exchange that was begun: what each of the processes has sent, in the same order.
    fn end_exchange(&mut self) -> Vec<Vec<f64>>;

    /// Begins to send `values` to all processes, of which each sends so many.
    fn begin_gather(&mut self, values: Vec<f64>, counts: &[usize]);

    /// Ends the gather that was begun: the values of all processes, those of the first first.
    fn end_gather(&mut self) -> Vec<f64>;

    /// Begins to find the sums over all processes of some numbers, and the largest in any process of others.
    fn begin_reduction(&mut self, added: Vec<i64>, compared: Vec<f64>);

    /// Ends the reduction that was begun.
    fn end_reduction(&mut self) -> (Vec<i64>, Vec<f64>);

    /// Replaces each of `values` by the largest in any process.
    fn largest(&mut self, values: &mut [f64]) {
        self.begin_reduction(Vec::new(), values.to_vec());
        values.copy_from_slice(&self.end_reduction().1);
    }

    /// Sends `values` to all processes, and returns those of each.
    fn gather(&mut self, values: &[f64]) -> Vec<Vec<f64>>;

    /// Sends `values` to process 0, which gets those of each; the others get nothing.
    fn collect(&mut self, values: &[f64]) -> Vec<Vec<f64>>;

    /// Sends each process its own values, those of number `n` to process `n`, and returns what each has sent here.
    fn deliver(&mut self, values: Vec<Vec<f64>>) -> Vec<Vec<f64>>;

    /// Ends all processes, with an exit code: this one cannot go on, and the others would wait for it.
    fn abort(&mut self, code: i32);
}

/// The only process of a run.
#[derive(Clone, Debug, Default)]
pub struct Alone {
    gathered: Vec<f64>,
    reduced: (Vec<i64>, Vec<f64>),
}

impl Communicator for Alone {
    fn rank(&self) -> usize {
        0
    }

    fn size(&self) -> usize {
        1
    }

    fn begin_exchange(&mut self, _: Vec<(usize, Vec<f64>)>) {}

    fn end_exchange(&mut self) -> Vec<Vec<f64>> {
        Vec::new()
    }

    fn begin_gather(&mut self, values: Vec<f64>, _: &[usize]) {
        self.gathered = values;
    }

    fn end_gather(&mut self) -> Vec<f64> {
        std::mem::take(&mut self.gathered)
    }

    fn begin_reduction(&mut self, added: Vec<i64>, compared: Vec<f64>) {
        self.reduced = (added, compared);
    }

    fn end_reduction(&mut self) -> (Vec<i64>, Vec<f64>) {
        std::mem::take(&mut self.reduced)
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
    neighbours: Vec<Neighbour>,
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
        let beside = [-1, 1].map(|end| {
            let side = if axis == 1 { [end, 0] } else { [0, end] };
            self.neighbours.iter().find(|neighbour| neighbour.side == side).map(|neighbour| neighbour.rank)
        });
        let each = beside.iter().zip(values);
        self.begin_exchange(each.filter_map(|(rank, values)| rank.map(|rank| (rank, values))).collect());
        let mut received = self.end_exchange().into_iter();
        beside.map(|rank| rank.and_then(|_| received.next()).unwrap_or_default())
    }

    /// Begins to send messages to other blocks, and to receive one of the same length from each.
    fn begin_exchange(&self, messages: Vec<(usize, Vec<f64>)>) {
        if let Some(mut line) = self.line() {
            line.traffic.messages += messages.len() as u64;
            let bytes: usize = messages.iter().map(|(_, values)| size_of_val(values.as_slice())).sum();
            line.traffic.message_bytes += bytes as u64;
            line.timed(|communicator| communicator.begin_exchange(messages));
        }
    }

    /// What these blocks have sent, in the same order.
    fn end_exchange(&self) -> Vec<Vec<f64>> {
        self.line().map_or_else(Vec::new, |mut line| line.timed(|communicator| communicator.end_exchange()))
    }

    /// Begins to send values to all blocks, of which each sends so many.
    pub(crate) fn begin_gather(&self, values: Vec<f64>, counts: &[usize]) {
        if let Some(mut line) = self.line() {
            let bytes = size_of_val(values.as_slice());
            line.collectively(bytes, |communicator| communicator.begin_gather(values, counts));
        }
    }

    /// The values of all blocks, those of the first first.
    pub(crate) fn end_gather(&self) -> Vec<f64> {
        self.line().map_or_else(Vec::new, |mut line| line.timed(|communicator| communicator.end_gather()))
    }

    /// Begins to find the sums over all blocks of some numbers, and the largest in any block of others.
    pub(crate) fn begin_reduction(&self, added: Vec<i64>, compared: Vec<f64>) {
        if let Some(mut line) = self.line() {
            let bytes = size_of_val(added.as_slice()) + size_of_val(compared.as_slice());
            line.collectively(bytes, |communicator| communicator.begin_reduction(added, compared));
        }
    }

    /// Ends the reduction that was begun.
    pub(crate) fn end_reduction(&self) -> (Vec<i64>, Vec<f64>) {
        self.line()
            .map_or_else(Default::default, |mut line| line.timed(|communicator| communicator.end_reduction()))
    }

    /// The values of all blocks, those of the first first, the same everywhere.
    pub fn gather(&self, values: Vec<f64>) -> Vec<f64> {
        self.gather_each(values).concat()
    }

    /// The values of each block, the same everywhere.
    pub(crate) fn gather_each(&self, values: Vec<f64>) -> Vec<Vec<f64>> {
        match self.line() {
            None => vec![values],
            Some(mut line) => {
                line.collectively(size_of_val(values.as_slice()), |communicator| communicator.gather(&values))
            }
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
        if !self.is_alone() {
            self.begin_reduction(values.to_vec(), Vec::new());
            values.copy_from_slice(&self.end_reduction().0);
        }
    }

    /// Replaces each of `values` by the largest in any block.
    pub fn largest(&self, values: &mut [f64]) {
        if !self.is_alone() {
            self.begin_reduction(Vec::new(), values.to_vec());
            values.copy_from_slice(&self.end_reduction().1);
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
    layers: (At, usize),
    arrays: impl IntoIterator<Item = &'a mut Vec<R>>,
) {
    if !halo.is_alone() {
        let mut arrays: Vec<_> = arrays.into_iter().collect();
        begin_filling(halo, grid, layers, arrays.iter().map(|array| &**array));
        end_filling(halo, grid, layers, arrays.iter_mut().map(|array| &mut **array));
    }
}

/// Begins to fill so many ghost layers: sends the neighbours what they need.
pub(crate) fn begin_filling<'a, R: Scalar>(
    halo: &Halo,
    grid: &Grid,
    (at, depth): (At, usize),
    arrays: impl Iterator<Item = &'a Vec<R>> + Clone,
) {
    let stride = grid.stride[1];
    let message = |neighbour: &Neighbour| {
        let sent = rows(grid, [1, 2].map(|axis| edge(grid, (at, depth), axis, neighbour.side[axis - 1])));
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
    (at, depth): (At, usize),
    arrays: impl Iterator<Item = &'a mut Vec<R>>,
) {
    let stride = grid.stride[1];
    let received = halo.end_exchange();
    let filled = halo.neighbours.iter().map(|neighbour| {
        rows(grid, [1, 2].map(|axis| ghosts(grid, (at, depth), axis, neighbour.side[axis - 1])))
    });
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

/// Layers along an axis needed by the neighbour on a side. Both blocks hold the nodes on the boundary between them.
fn edge(grid: &Grid, (at, depth): (At, usize), axis: usize, side: i32) -> Range<usize> {
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
fn ghosts(grid: &Grid, (at, depth): (At, usize), axis: usize, side: i32) -> Range<usize> {
    match side {
        0 => between_cuts(grid, at, axis),
        1 => {
            let first = grid.own[axis].end - grid.first[axis] + usize::from(at == At::Nodes);
            first..first + depth
        }
        _ => GHOSTS - depth..GHOSTS,
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
