//! Several blocks in one process, each on its own thread: a stand-in for message passing, for the tests.

use super::Halo;
use crate::grid::Grid;
use std::ops::Range;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Barrier, Mutex, PoisonError};

/// To and from a neighbour.
type Link = (Sender<Vec<f64>>, Receiver<Vec<f64>>);

/// One of several blocks.
#[derive(Debug)]
pub struct InProcess {
    number: usize,
    /// To and from the neighbours along y and z, at the low end and at the high end.
    neighbours: [[Option<Link>; 2]; 2],
    board: Arc<Board>,
}

/// Shared memory of the gathers: one slot for each block.
#[derive(Debug)]
struct Board {
    slots: Mutex<Vec<Vec<f64>>>,
    barrier: Barrier,
}

/// Partitions a grid before the given layers of its domain along y and z. Returns each block with its links to the others.
///
/// # Panics
/// If a block gets too few layers (see [`Grid::block`]).
#[must_use]
pub fn partition(whole: &Grid, before: [&[usize]; 2]) -> Vec<(Grid, InProcess)> {
    let ranges = |axis: usize| -> Vec<Range<usize>> {
        let domain = &whole.domain[axis];
        let ends = before[axis - 1].iter().map(|layer| domain.start + layer).chain([domain.end]);
        ends.scan(domain.start, |start, end| Some(std::mem::replace(start, end)..end)).collect()
    };
    let [rows, planes] = [ranges(1), ranges(2)];
    let count = rows.len() * planes.len();
    let board = Arc::new(Board { slots: Mutex::new(vec![Vec::new(); count]), barrier: Barrier::new(count) });
    let mut blocks: Vec<(Grid, InProcess)> = (0..count)
        .map(|number| {
            let (j, k) = (number % rows.len(), number / rows.len());
            let own = [whole.domain[0].clone(), rows[j].clone(), planes[k].clone()];
            let block = InProcess { number, neighbours: Default::default(), board: Arc::clone(&board) };
            (whole.block(own), block)
        })
        .collect();
    for number in 0..count {
        for (axis, step, is_last) in
            [(0, 1, (number + 1).is_multiple_of(rows.len())), (1, rows.len(), number + rows.len() >= count)]
        {
            if !is_last {
                let ((up, from_below), (down, from_above)) = (channel(), channel());
                blocks[number].1.neighbours[axis][1] = Some((up, from_above));
                blocks[number + step].1.neighbours[axis][0] = Some((down, from_below));
            }
        }
    }
    blocks
}

impl Halo for InProcess {
    fn is_alone(&self) -> bool {
        false
    }

    /// # Panics
    /// If the neighbour has failed.
    fn exchange(&mut self, axis: usize, end: usize, values: Vec<f64>) -> Vec<f64> {
        let Some((to, from)) = &self.neighbours[axis - 1][end] else { return values };
        assert!(to.send(values).is_ok(), "the neighbour has gone");
        from.recv().unwrap_or_else(|_| panic!("the neighbour has gone"))
    }

    fn gather(&mut self, values: Vec<f64>) -> Vec<f64> {
        let slots = || self.board.slots.lock().unwrap_or_else(PoisonError::into_inner);
        slots()[self.number] = values;
        self.board.barrier.wait();
        let all = slots().concat();
        self.board.barrier.wait();
        all
    }
}
