//! Communication between the blocks of a grid: messages, sums and gathers.

pub mod decomposition;
pub(crate) mod filling;
pub mod in_process;
#[cfg(feature = "mpi")]
pub mod mpi;

use decomposition::{Decomposition, Neighbour};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Instant;

/// The processes of a run, each with a block of the grid, as one of them sees them. All must call the same
/// functions in the same order; one operation of each kind may have begun, others may begin and end before it
/// ends.
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

    /// Sends each process its own values, those of number `n` to process `n`, and returns what each has sent
    /// here.
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
    /// Bytes in messages to neighbours.
    pub message_bytes: u64,
    /// Operations of all processes together.
    pub collectives: u64,
    /// Bytes that this process has put into operations of all processes together.
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
    /// Numbers of blocks beyond this one along y and z, at the low end and at the high end.
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

    /// The communicator for a grid that is cut anew.
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

    /// Sends values to the neighbours at the low end and at the high end along `axis`, 1 or 2, and returns
    /// what these have sent; nothing where there is none. What is sent both ways between two blocks is of the
    /// same length.
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

    /// Ends the processes of all blocks, with an exit code: this one cannot go on, and the others would wait
    /// for it. Where there are no others, nothing happens.
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

    /// Communicates, like [`Line::timed`], in an operation of all processes, into which so many bytes go.
    fn collectively<T>(&mut self, bytes: usize, communicate: impl FnOnce(&mut dyn Communicator) -> T) -> T {
        self.traffic.collectives += 1;
        self.traffic.collective_bytes += bytes as u64;
        self.timed(communicate)
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
