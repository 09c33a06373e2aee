//! The processes of an MPI run.
//!
//! The handle of the communicator is asked for whenever it is needed, so that a run may be handed from thread
//! to thread.

// Operations that have begun read and write memory until they end; no borrow lasts from one call to another.
#![allow(unsafe_code)]

use super::Communicator;
use ::mpi::collective::SystemOperation;
use ::mpi::datatype::{Partition, PartitionMut};
use ::mpi::request::{Request, StaticScope, WaitGuard};
use ::mpi::topology::{Rank, SimpleCommunicator};
use ::mpi::traits::{CommunicatorCollectives, Destination, Equivalence, Root, Source};
use ::mpi::{Tag, traits};

/// This process in the world of all that MPI has started.
#[derive(Debug, Default)]
pub struct World {
    exchange: Begun<f64>,
    gather: Begun<f64>,
    gathered: Gathered,
    added: Begun<i64>,
    compared: Begun<f64>,
}

/// Values that all processes gather, as this one gives them, and the number of those of each.
#[derive(Debug, Default)]
struct Gathered {
    own: Vec<f64>,
    counts: Vec<usize>,
}

/// Tags of messages in an exchange and in a gather.
const EXCHANGE: Tag = 1;
const GATHER: Tag = 2;

/// Processes that send what all gather directly to each other: it is under way while they compute. More of
/// them leave it to MPI, which passes it on from one to the next.
const DIRECTLY: usize = 16;

/// An operation that has begun.
type Begins<T> = Request<'static, [T], StaticScope>;

/// Operations that have begun. Dropping it waits for them.
struct Begun<T: 'static> {
    /// Operations that receive. Declared, and dropped, before the memory that they write.
    receives: Vec<WaitGuard<'static, [T]>>,
    /// Operations that send. These may go on after all has been received: until then a process would wait for
    /// others to receive what they do not need yet.
    sends: Vec<WaitGuard<'static, [T]>>,
    sent: Vec<Vec<T>>,
    received: Vec<Vec<T>>,
}

// SAFETY: MPI is initialised so that any thread may call it, one at a time, and what has begun belongs to no
// thread.
unsafe impl<T: Send> Send for Begun<T> {}

impl<T> std::fmt::Debug for Begun<T> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} operations begun", self.receives.len() + self.sends.len())
    }
}

impl<T> Default for Begun<T> {
    fn default() -> Self {
        Self { receives: Vec::new(), sends: Vec::new(), sent: Vec::new(), received: Vec::new() }
    }
}

impl<T: Copy + Default> Begun<T> {
    /// Ends what had begun before, and takes memory to send and to receive.
    fn renew(&mut self, sent: Vec<Vec<T>>, received: Vec<usize>) {
        self.receives.clear();
        self.sends.clear();
        self.sent = sent;
        self.received = received.into_iter().map(|length| vec![T::default(); length]).collect();
    }

    /// Begins an operation that reads memory to send.
    fn begin_to_read(&mut self, n: usize, begin: impl FnOnce(&'static [T]) -> Begins<T>) {
        let sent = &self.sent[n];
        // SAFETY: the memory belongs to this struct, which changes or frees it only once `sends` has been
        // cleared or dropped, and that waits for the operations.
        self.sends
            .push(WaitGuard::from(begin(unsafe { std::slice::from_raw_parts(sent.as_ptr(), sent.len()) })));
    }

    /// Begins an operation that writes memory to receive; no two may write the same.
    fn begin_to_write(&mut self, n: usize, begin: impl FnOnce(&'static mut [T]) -> Begins<T>) {
        let received = &mut self.received[n];
        let (start, length) = (received.as_mut_ptr(), received.len());
        // SAFETY: the same with `receives`, and no one else has a reference to it.
        self.receives.push(WaitGuard::from(begin(unsafe { std::slice::from_raw_parts_mut(start, length) })));
    }

    /// Waits until all is received, and returns it.
    fn end(&mut self) -> Vec<Vec<T>> {
        self.receives.clear();
        std::mem::take(&mut self.received)
    }
}

fn world() -> SimpleCommunicator {
    SimpleCommunicator::world()
}

impl Begun<f64> {
    fn send(&mut self, n: usize, to: usize, tag: Tag) {
        let world = world();
        let process = traits::Communicator::process_at_rank(&world, to as Rank);
        self.begin_to_read(n, |sent| process.immediate_send_with_tag(StaticScope, sent, tag));
    }

    fn receive(&mut self, n: usize, from: usize, tag: Tag) {
        let world = world();
        let process = traits::Communicator::process_at_rank(&world, from as Rank);
        self.begin_to_write(n, |received| {
            process.immediate_receive_into_with_tag(StaticScope, received, tag)
        });
    }
}

impl<T: Copy + Default + Equivalence> Begun<T> {
    /// Begins to reduce values over all processes; nothing where there are none.
    fn reduce(&mut self, values: Vec<T>, operation: SystemOperation) {
        let length = values.len();
        self.renew(vec![values], vec![length]);
        if length > 0 {
            let sent = self.sent[0].as_ptr();
            // SAFETY: the request is one of `receives`, and these are cleared or dropped before this memory,
            // too.
            let sent: &'static [T] = unsafe { std::slice::from_raw_parts(sent, length) };
            self.begin_to_write(0, |received| {
                world().immediate_all_reduce_into(StaticScope, sent, received, operation)
            });
        }
    }
}

/// The values of all processes, of which each has so many.
fn gather_known(own: &[f64], counts: &[i32]) -> Vec<f64> {
    let mut all = vec![0.0; counts.iter().sum::<i32>() as usize];
    let starts = starts(counts);
    let mut partition = PartitionMut::new(&mut all[..], counts, &starts[..]);
    world().all_gather_varcount_into(own, &mut partition);
    all
}

/// How many values each process has.
fn counts(own: usize) -> Vec<i32> {
    let mut counts = vec![0_i32; traits::Communicator::size(&world()) as usize];
    world().all_gather_into(&(own as i32), &mut counts[..]);
    counts
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

    fn begin_exchange(&mut self, messages: Vec<(usize, Vec<f64>)>) {
        let (partners, sent): (Vec<usize>, Vec<Vec<f64>>) = messages.into_iter().unzip();
        let lengths = sent.iter().map(Vec::len).collect();
        self.exchange.renew(sent, lengths);
        for (n, partner) in partners.iter().enumerate() {
            self.exchange.receive(n, *partner, EXCHANGE);
        }
        for (n, partner) in partners.iter().enumerate() {
            self.exchange.send(n, *partner, EXCHANGE);
        }
    }

    fn end_exchange(&mut self) -> Vec<Vec<f64>> {
        self.exchange.end()
    }

    fn begin_gather(&mut self, values: Vec<f64>, counts: &[usize]) {
        self.gathered = Gathered { own: values, counts: counts.to_vec() };
        if counts.len() > DIRECTLY {
            return;
        }
        let rank = self.rank();
        let received = counts.iter().enumerate().map(|(n, count)| if n == rank { 0 } else { *count });
        self.gather.renew(vec![self.gathered.own.clone()], received.collect());
        for other in (0..counts.len()).filter(|other| *other != rank) {
            if counts[other] > 0 {
                self.gather.receive(other, other, GATHER);
            }
            if counts[rank] > 0 {
                self.gather.send(0, other, GATHER);
            }
        }
    }

    fn end_gather(&mut self) -> Vec<f64> {
        let Gathered { own, counts } = std::mem::take(&mut self.gathered);
        if counts.len() > DIRECTLY {
            return gather_known(&own, &counts.iter().map(|count| *count as i32).collect::<Vec<_>>());
        }
        let mut all = self.gather.end();
        all[self.rank()] = own;
        all.concat()
    }

    fn begin_reduction(&mut self, added: Vec<i64>, compared: Vec<f64>) {
        self.added.reduce(added, SystemOperation::sum());
        self.compared.reduce(compared, SystemOperation::max());
    }

    fn end_reduction(&mut self) -> (Vec<i64>, Vec<f64>) {
        (self.added.end().concat(), self.compared.end().concat())
    }

    fn gather(&mut self, values: &[f64]) -> Vec<Vec<f64>> {
        let counts = counts(values.len());
        of_each(&gather_known(values, &counts), &counts)
    }

    fn collect(&mut self, values: &[f64]) -> Vec<Vec<f64>> {
        let counts = counts(values.len());
        let starts = starts(&counts);
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

    fn abort(&mut self, code: i32) {
        traits::Communicator::abort(&world(), code);
    }
}
