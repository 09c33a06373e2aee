//! Several blocks in one process, each on its own thread: a stand-in for message passing, for the tests.

use super::decomposition::Decomposition;
use super::{Communicator, Halo};
use crate::grid::Grid;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Barrier, Mutex, PoisonError};

/// One of several communicators that are linked to each other in one process.
#[derive(Debug)]
pub struct InProcess {
    rank: usize,
    /// Links to and from each of the others.
    links: Vec<Option<Link>>,
    board: Arc<Board>,
    /// Communicators with which an exchange has begun.
    partners: Vec<usize>,
    gathered: Vec<f64>,
    reduced: (Vec<i64>, Vec<f64>),
}

/// Channels to and from another communicator.
type Link = (Sender<Vec<f64>>, Receiver<Vec<f64>>);

/// Shared memory of the collective operations: one slot for each.
#[derive(Debug)]
struct Board {
    slots: Mutex<Vec<Vec<f64>>>,
    barrier: Barrier,
}

/// Communicators that are linked to each other, `count` of them.
#[must_use]
pub fn communicators(count: usize) -> Vec<InProcess> {
    let board = Arc::new(Board { slots: Mutex::new(vec![Vec::new(); count]), barrier: Barrier::new(count) });
    let of_rank = |rank| InProcess {
        rank,
        links: (0..count).map(|_| None).collect(),
        board: Arc::clone(&board),
        partners: Vec::new(),
        gathered: Vec::new(),
        reduced: Default::default(),
    };
    let mut all: Vec<InProcess> = (0..count).map(of_rank).collect();
    for low in 0..count {
        for high in low + 1..count {
            let ((up, from_low), (down, from_high)) = (channel(), channel());
            all[low].links[high] = Some((up, from_high));
            all[high].links[low] = Some((down, from_low));
        }
    }
    all
}

/// Partitions a grid before the given layers of its domain along y and z. Returns each block with its link to
/// the others.
///
/// # Panics
/// If a block gets too few layers (see [`Grid::block`]).
#[must_use]
pub fn partition(whole: &Grid, before: [&[usize]; 2]) -> Vec<(Grid, Halo)> {
    let cut = Decomposition::cut(whole, before);
    let blocks = (0..cut.count()).map(|number| whole.block(cut.own(number)));
    let halos = communicators(cut.count()).into_iter().map(|own| Halo::of_block(&cut, Box::new(own)));
    blocks.zip(halos).collect()
}

impl Communicator for InProcess {
    fn rank(&self) -> usize {
        self.rank
    }

    fn size(&self) -> usize {
        self.links.len()
    }

    /// # Panics
    /// If one of the others has failed.
    fn begin_exchange(&mut self, messages: Vec<(usize, Vec<f64>)>) {
        self.partners = messages.iter().map(|(partner, _)| *partner).collect();
        for (partner, values) in messages {
            let sent = self.links[partner].as_ref().map(|(to, _)| to.send(values));
            assert!(sent.is_some_and(|sent| sent.is_ok()), "the neighbour has gone");
        }
    }

    /// # Panics
    /// If one of the others has failed.
    fn end_exchange(&mut self) -> Vec<Vec<f64>> {
        let received = |partner: &usize| self.links[*partner].as_ref().and_then(|(_, from)| from.recv().ok());
        self.partners
            .iter()
            .map(|partner| received(partner).unwrap_or_else(|| panic!("the neighbour has gone")))
            .collect()
    }

    fn begin_gather(&mut self, values: Vec<f64>, _: &[usize]) {
        self.gathered = values;
    }

    fn end_gather(&mut self) -> Vec<f64> {
        let own = std::mem::take(&mut self.gathered);
        self.gather(&own).concat()
    }

    fn begin_reduction(&mut self, added: Vec<i64>, compared: Vec<f64>) {
        self.reduced = (added, compared);
    }

    fn end_reduction(&mut self) -> (Vec<i64>, Vec<f64>) {
        let (mut added, mut compared) = std::mem::take(&mut self.reduced);
        // The board takes any 64 bits.
        let bits = added.iter().map(|value| f64::from_bits(value.cast_unsigned()));
        let all = self.gather(&bits.chain(compared.iter().copied()).collect::<Vec<_>>());
        for (n, value) in added.iter_mut().enumerate() {
            *value = all.iter().map(|own| own[n].to_bits().cast_signed()).sum();
        }
        for (n, value) in compared.iter_mut().enumerate() {
            *value = all.iter().map(|own| own[added.len() + n]).fold(f64::NEG_INFINITY, f64::max);
        }
        (added, compared)
    }

    fn gather(&mut self, values: &[f64]) -> Vec<Vec<f64>> {
        let slots = || self.board.slots.lock().unwrap_or_else(PoisonError::into_inner);
        slots()[self.rank] = values.to_vec();
        self.board.barrier.wait();
        let all = slots().clone();
        self.board.barrier.wait();
        all
    }

    fn collect(&mut self, values: &[f64]) -> Vec<Vec<f64>> {
        let all = self.gather(values);
        if self.rank == 0 { all } else { Vec::new() }
    }

    /// # Panics
    /// If one of the others has failed.
    fn deliver(&mut self, mut values: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
        for (link, values) in self.links.iter().zip(&mut values) {
            if let Some((to, _)) = link {
                assert!(to.send(std::mem::take(values)).is_ok(), "another block has gone");
            }
        }
        for (link, values) in self.links.iter().zip(&mut values) {
            if let Some((_, from)) = link {
                *values = from.recv().unwrap_or_else(|_| panic!("another block has gone"));
            }
        }
        values
    }

    /// # Panics
    /// Always.
    fn abort(&mut self, code: i32) {
        panic!("block {} cannot go on ({code})", self.rank);
    }
}
