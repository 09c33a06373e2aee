//! A team of threads that lives as long as the run. The only file that starts a thread.
//!
//! A step has a handful of short parallel phases. A thread pool that sleeps between them costs more than the
//! phases, so the team spins for a while, then yields, before it goes to sleep.
#![allow(unsafe_code)]

use super::partition::RowPartition;
use smallvec::SmallVec;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Condvar, Mutex};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

type Job = *const (dyn Fn(usize) + Sync);

struct Shared {
    /// Number of the current job; a change of it is the signal to start.
    turn: AtomicUsize,
    /// Number of workers that have not finished it.
    busy: AtomicUsize,
    /// Whether a worker has panicked.
    failed: AtomicBool,
    /// Whether the threads should end.
    leave: AtomicBool,
    job: Mutex<Option<JobPointer>>,
    asleep: Mutex<()>,
    wake: Condvar,
}

#[derive(Clone, Copy)]
struct JobPointer(Job);
// SAFETY: the pointer is only dereferenced between the start and the end of `Team::run`, which outlives the
// call.
unsafe impl Send for JobPointer {}

/// A fixed team of workers; worker 0 is the calling thread.
pub struct Team {
    shared: Arc<Shared>,
    threads: Vec<JoinHandle<()>>,
}

impl std::fmt::Debug for Team {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Team of {}", self.size())
    }
}

const SPINS: u32 = 4000;
/// How long a thread offers its core to others before it goes to sleep: longer than what the calling thread
/// does alone within a step, since it takes a tenth of a millisecond to wake.
const PATIENCE: Duration = Duration::from_millis(2);

impl Team {
    /// A team of `size` workers (at least one, at most [`MAX_WORKERS`]).
    #[must_use]
    pub fn new(size: usize) -> Self {
        let shared = Arc::new(Shared {
            turn: AtomicUsize::new(0),
            busy: AtomicUsize::new(0),
            failed: AtomicBool::new(false),
            leave: AtomicBool::new(false),
            job: Mutex::new(None),
            asleep: Mutex::new(()),
            wake: Condvar::new(),
        });
        let threads = (1..size.clamp(1, MAX_WORKERS))
            // Where the system has no room for another thread the team is smaller: results do not depend on
            // its size.
            .map_while(|worker| {
                let shared = Arc::clone(&shared);
                std::thread::Builder::new().spawn(move || serve(&shared, worker)).ok()
            })
            .collect();
        Self { shared, threads }
    }

    /// Number of workers.
    #[must_use]
    pub fn size(&self) -> usize {
        self.threads.len() + 1
    }

    /// Runs `job(worker)` once on every worker and waits for all of them.
    ///
    /// # Panics
    /// If the job panics on any worker.
    pub fn run(&self, job: &(dyn Fn(usize) + Sync)) {
        if self.threads.is_empty() {
            job(0);
            return;
        }
        // SAFETY: only the lifetime is erased; this function does not return before every worker is done with
        // it.
        let pointer: Job = unsafe { std::mem::transmute(std::ptr::from_ref(job)) };
        *self.shared.job.lock().unwrap_or_else(std::sync::PoisonError::into_inner) =
            Some(JobPointer(pointer));
        self.shared.busy.store(self.threads.len(), Ordering::Relaxed);
        self.shared.turn.fetch_add(1, Ordering::Release);
        {
            let _guard = self.shared.asleep.lock();
            self.shared.wake.notify_all();
        }
        let own = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| job(0)));
        wait_until(|| self.shared.busy.load(Ordering::Acquire) == 0);
        if let Err(panic) = own {
            std::panic::resume_unwind(panic);
        }
        assert!(!self.shared.failed.load(Ordering::Relaxed), "a worker thread panicked");
    }

    /// Runs `job` on every item: on the first by the first worker and so on, on those beyond the number of
    /// workers by whoever is ready first. A single item is processed by the calling thread, without
    /// synchronisation.
    ///
    /// # Panics
    /// If the job panics.
    pub fn for_each<T: Send>(&self, items: &mut [T], job: impl Fn(&mut T) + Sync) {
        match items {
            [] => return,
            [item] => return job(item),
            _ => {}
        }
        let base = ItemsPointer(items.as_mut_ptr());
        let (count, next) = (items.len(), AtomicUsize::new(self.size()));
        self.run(&|worker| {
            let mut own = worker;
            while own < count {
                // SAFETY: numbers of workers are unique, and so are those beyond that are counted up: no two
                // workers get the same item.
                job(unsafe { &mut *base.at(own) });
                own = next.fetch_add(1, Ordering::Relaxed);
            }
        });
    }

    /// Runs `job`, like [`Team::for_each`], on the items of an iterator.
    pub fn distribute<T: Send>(&self, items: impl Iterator<Item = T>, job: impl Fn(&mut T) + Sync) {
        self.for_each(&mut team_items(items), job);
    }

    /// Calls `job(row, output)` for every row of the partition, in parallel, with the row of `output`.
    pub fn rows<T: Send>(
        &self,
        partition: &RowPartition,
        output: &mut [T],
        job: impl Fn(usize, &mut [T]) + Sync,
    ) {
        self.distribute(partition.split(output).zip(partition.ranges()), |(rows, range)| {
            for (row, own) in range.clone().zip(rows.chunks_exact_mut(partition.stride)) {
                job(row, own);
            }
        });
    }

    /// Like [`Team::rows`] for two arrays that are written together.
    pub(crate) fn rows2<T: Send>(
        &self,
        partition: &RowPartition,
        first: &mut [T],
        second: &mut [T],
        job: impl Fn(usize, &mut [T], &mut [T]) + Sync,
    ) {
        self.distribute(
            partition.split(first).zip(partition.split(second)).zip(partition.ranges()),
            |((first, second), range)| {
                let own =
                    first.chunks_exact_mut(partition.stride).zip(second.chunks_exact_mut(partition.stride));
                for (row, (first, second)) in range.clone().zip(own) {
                    job(row, first, second);
                }
            },
        );
    }
}

/// The threads of a team that are at work, for loops other than over rows.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Crew<'a> {
    team: &'a Team,
    workers: usize,
}

impl<'a> Crew<'a> {
    /// The threads of a team, at most as many as a partition has ranges.
    pub(crate) fn of(team: &'a Team, partition: &RowPartition) -> Self {
        Self { team, workers: partition.ranges().len().min(team.size()) }
    }

    /// Calls `job(first, portion)` on successive portions of the items, in parallel; no portion but a single
    /// one has fewer than `least` items.
    pub(crate) fn portions<T: Send>(
        self,
        items: &mut [T],
        least: usize,
        job: impl Fn(usize, &mut [T]) + Sync,
    ) {
        let size = self.portion(items.len(), least);
        let each = items.chunks_mut(size).enumerate();
        self.team.distribute(each, |(n, portion)| job(*n * size, portion));
    }

    /// Calls `job(first, portion, portion)` on successive portions of two lists of equal length, in parallel,
    /// like [`Crew::portions`].
    pub(crate) fn portions2<A: Send, B: Send>(
        self,
        first: &mut [A],
        second: &mut [B],
        least: usize,
        job: impl Fn(usize, &mut [A], &mut [B]) + Sync,
    ) {
        let size = self.portion(first.len(), least);
        let each = first.chunks_mut(size).zip(second.chunks_mut(size)).enumerate();
        self.team.distribute(each, |(n, (first, second))| job(*n * size, first, second));
    }

    /// Number of items in a portion.
    fn portion(self, items: usize, least: usize) -> usize {
        items.div_ceil((items / least).clamp(1, self.workers)).max(1)
    }

    /// The results of `job(range)` for successive ranges of so many numbers below `length`, in order.
    pub(crate) fn collect<T: Send>(
        self,
        length: usize,
        range: usize,
        job: impl Fn(Range<usize>) -> T + Sync,
    ) -> Vec<T> {
        let ranges = (0..length).step_by(range).map(|first| first..length.min(first + range));
        if self.workers == 1 {
            return ranges.map(job).collect();
        }
        let mut results: Vec<_> = ranges.map(|range| (range, None)).collect();
        self.team.for_each(&mut results, |(range, result)| *result = Some(job(range.clone())));
        results.into_iter().filter_map(|(_, result)| result).collect()
    }
}

/// Maximum number of workers of a team; beyond it a number is a slip of the pen.
pub const MAX_WORKERS: usize = 4096;

/// As many workers' items lie on the stack, so that a step allocates no memory; those of larger teams do not.
const ON_STACK: usize = 64;

/// Items for the workers of a team.
pub(crate) fn team_items<T>(items: impl Iterator<Item = T>) -> SmallVec<[T; ON_STACK]> {
    items.collect()
}

struct ItemsPointer<T>(*mut T);
// SAFETY: used to hand out disjoint items of a slice of `Send` values.
unsafe impl<T: Send> Sync for ItemsPointer<T> {}
impl<T> ItemsPointer<T> {
    fn at(&self, n: usize) -> *mut T {
        self.0.wrapping_add(n)
    }
}

impl Drop for Team {
    fn drop(&mut self) {
        self.shared.leave.store(true, Ordering::Release);
        self.shared.turn.fetch_add(1, Ordering::Release);
        {
            let _guard = self.shared.asleep.lock();
            self.shared.wake.notify_all();
        }
        for thread in self.threads.drain(..) {
            let _ = thread.join();
        }
    }
}

fn serve(shared: &Shared, worker: usize) {
    let mut turn = 0;
    loop {
        wait_for_turn(shared, turn);
        turn += 1;
        if shared.leave.load(Ordering::Acquire) {
            return;
        }
        let job = *shared.job.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        if let Some(JobPointer(job)) = job {
            // SAFETY: `Team::run` keeps the job alive until `busy` is 0, which this worker has not yet
            // allowed.
            let done = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| unsafe { (*job)(worker) }));
            if done.is_err() {
                shared.failed.store(true, Ordering::Relaxed);
            }
        }
        shared.busy.fetch_sub(1, Ordering::Release);
    }
}

fn wait_until(done: impl Fn() -> bool) {
    let mut tries = 0_u32;
    while !done() {
        tries = tries.saturating_add(1);
        if tries < SPINS { std::hint::spin_loop() } else { std::thread::yield_now() }
    }
}

fn wait_for_turn(shared: &Shared, turn: usize) {
    let ready = || shared.turn.load(Ordering::Acquire) != turn;
    for _ in 0..SPINS {
        if ready() {
            return;
        }
        std::hint::spin_loop();
    }
    let start = Instant::now();
    while start.elapsed() < PATIENCE {
        if ready() {
            return;
        }
        std::thread::yield_now();
    }
    let mut guard = shared.asleep.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    while !ready() {
        guard = shared.wake.wait(guard).unwrap_or_else(std::sync::PoisonError::into_inner);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_item_is_processed_once_each_time() {
        for size in [1, 2, 3, 5] {
            let team = Team::new(size);
            let mut counts = vec![0_usize; 3 * size];
            for _ in 0..1000 {
                team.for_each(&mut counts, |c| *c += 1);
            }
            assert_eq!(counts, vec![1000; 3 * size]);
        }
    }

    #[test]
    fn a_crew_takes_every_item_once_and_keeps_their_order() {
        let team = Team::new(3);
        let crew = Crew { team: &team, workers: 3 };
        for length in [0, 1, 2, 7, 100] {
            let mut items = vec![0; length];
            crew.portions(&mut items, 2, |first, portion| {
                portion.iter_mut().enumerate().for_each(|(n, item)| *item += first + n);
            });
            assert!(items.iter().enumerate().all(|(n, item)| n == *item));
            let collected = crew.collect(length, 4, |range| range.collect::<Vec<_>>());
            assert_eq!(collected.concat(), items);
        }
    }

    #[test]
    fn every_row_is_processed_once() {
        let partition = RowPartition::new(2, &[0.0, 1.0, 5.0, 1.0, 1.0, 0.0], [3, 1], 4);
        assert_eq!(partition.all(), 2..8);
        let mut array = vec![0.0; 40];
        Team::new(3)
            .rows(&partition, &mut array, |row, output| output.iter_mut().for_each(|x| *x += row as f64));
        for row in 0..10 {
            let expected = if (2..8).contains(&row) { row as f64 } else { 0.0 };
            assert!(array[row * 4..row * 4 + 4].iter().all(|x| *x == expected));
        }
    }
}
