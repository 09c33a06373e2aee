//! The processes of an MPI run.
//!
//! The handle of the communicator is asked for whenever it is needed, so that a run may be handed from thread to thread.

use super::Communicator;
use ::mpi::collective::SystemOperation;
use ::mpi::datatype::{Partition, PartitionMut};
use ::mpi::request::{WaitGuard, scope};
use ::mpi::topology::{Rank, SimpleCommunicator};
use ::mpi::traits::{CommunicatorCollectives, Destination, Root, Source};
use ::mpi::{Tag, traits};

/// This process in the world of all that MPI has started.
#[derive(Clone, Copy, Debug)]
pub struct World;

/// Tags of messages towards the low end and towards the high end.
const TAGS: [Tag; 2] = [1, 2];

fn world() -> SimpleCommunicator {
    SimpleCommunicator::world()
}

/// How many values each process has, and where they begin among all.
fn places(own: usize) -> [Vec<i32>; 2] {
    let mut counts = vec![0_i32; World.size()];
    world().all_gather_into(&(own as i32), &mut counts[..]);
    let starts = starts(&counts);
    [counts, starts]
}

/// Where the values of each process begin among all.
fn starts(counts: &[i32]) -> Vec<i32> {
    counts.iter().scan(0, |next, count| Some(std::mem::replace(next, *next + count))).collect()
}

/// The values of each process from those of all.
fn of_each(all: &[f64], counts: &[i32]) -> Vec<Vec<f64>> {
    let mut rest = all;
    let mut take = |count: usize| {
        let (own, others) = rest.split_at(count);
        rest = others;
        own.to_vec()
    };
    counts.iter().map(|count| take(*count as usize)).collect()
}

impl Communicator for World {
    fn rank(&self) -> usize {
        traits::Communicator::rank(&world()) as usize
    }

    fn size(&self) -> usize {
        traits::Communicator::size(&world()) as usize
    }

    fn exchange(&mut self, with: [Option<usize>; 2], values: [Vec<f64>; 2]) -> [Vec<f64>; 2] {
        let world = world();
        let process = |rank: usize| traits::Communicator::process_at_rank(&world, rank as Rank);
        let mut received = values.each_ref().map(|own| vec![0.0; own.len()]);
        scope(|scope| {
            let mut guards = Vec::with_capacity(4);
            for ((rank, into), tag) in with.into_iter().zip(&mut received).zip(TAGS.into_iter().rev()) {
                if let Some(rank) = rank {
                    let request = process(rank).immediate_receive_into_with_tag(scope, &mut into[..], tag);
                    guards.push(WaitGuard::from(request));
                }
            }
            for ((rank, own), tag) in with.into_iter().zip(&values).zip(TAGS) {
                if let Some(rank) = rank {
                    let request = process(rank).immediate_send_with_tag(scope, &own[..], tag);
                    guards.push(WaitGuard::from(request));
                }
            }
        });
        received
    }

    fn gather(&mut self, values: &[f64]) -> Vec<Vec<f64>> {
        let [counts, starts] = places(values.len());
        let mut all = vec![0.0; counts.iter().sum::<i32>() as usize];
        let mut partition = PartitionMut::new(&mut all[..], &counts[..], &starts[..]);
        world().all_gather_varcount_into(values, &mut partition);
        of_each(&all, &counts)
    }

    fn collect(&mut self, values: &[f64]) -> Vec<Vec<f64>> {
        let [counts, starts] = places(values.len());
        let world = world();
        let root = traits::Communicator::process_at_rank(&world, 0);
        if self.rank() != 0 {
            root.gather_varcount_into(values);
            return Vec::new();
        }
        let mut all = vec![0.0; counts.iter().sum::<i32>() as usize];
        let mut partition = PartitionMut::new(&mut all[..], &counts[..], &starts[..]);
        root.gather_varcount_into_root(values, &mut partition);
        of_each(&all, &counts)
    }

    fn deliver(&mut self, values: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
        let counts: Vec<i32> = values.iter().map(|own| own.len() as i32).collect();
        let mut received = vec![0_i32; counts.len()];
        world().all_to_all_into(&counts[..], &mut received[..]);
        let (sent, [counts, received]) = (values.concat(), [counts, received]);
        let mut all = vec![0.0; received.iter().sum::<i32>() as usize];
        let [from, to] = [&counts, &received].map(|counts| starts(counts));
        let own = Partition::new(&sent[..], &counts[..], &from[..]);
        let mut partition = PartitionMut::new(&mut all[..], &received[..], &to[..]);
        world().all_to_all_varcount_into(&own, &mut partition);
        of_each(&all, &received)
    }

    fn add(&mut self, values: &mut [i64]) {
        let own = values.to_vec();
        world().all_reduce_into(&own[..], values, SystemOperation::sum());
    }

    fn largest(&mut self, values: &mut [f64]) {
        let own = values.to_vec();
        world().all_reduce_into(&own[..], values, SystemOperation::max());
    }

    fn abort(&mut self, code: i32) {
        traits::Communicator::abort(&world(), code);
    }
}
