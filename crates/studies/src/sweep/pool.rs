//! The pool of this machine: cases that run side by side, as many as cores and memory allow.

use super::evaluate::{Shared, Unended, evaluate};
use super::line::CaseLine;
use super::outcome::Outcome;
use crate::study::{ModelKind, Pool};
use coulter::case::cores;
use coulter::case::machine::memory_available;
use std::collections::HashSet;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Condvar, Mutex};

/// Part of the free memory that a pool may use.
const MEMORY_SHARE: f64 = 0.8;

/// Who is told how a pool gets on.
pub trait Watcher: Sync {
    /// A case begins.
    fn begun(&self, _line: &CaseLine) {}
    /// A case has ended, or could not.
    fn ended(&self, line: &CaseLine, outcome: &Result<Outcome, Unended>);
}

/// How a pool has ended.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PoolEnd {
    /// Cases that have an outcome now and had none before.
    pub ended: usize,
    /// Cases that could not be brought to one.
    pub failed: usize,
    /// The signal that stopped the pool, if one did.
    pub stopped: Option<i32>,
}

/// What is left to do, and what is being done.
struct Queue<'a> {
    /// Cases in the order in which they are begun, the last one first.
    left: Vec<&'a CaseLine>,
    /// Memory of the runs that are on [bytes].
    used: f64,
    /// Number of cases that are on.
    running: usize,
    end: PoolEnd,
}

/// Runs the cases that have no outcome yet: the closed forms, which take no time, in their order; then the
/// runs of the solver, the largest of them first, so that none is left for the end.
pub fn run(shared: &Shared, lines: &[CaseLine], pool: &Pool, watcher: &dyn Watcher) -> PoolEnd {
    let had = shared.store.with_outcome().unwrap_or_default();
    let mut seen = HashSet::new();
    let mut left: Vec<&CaseLine> = lines.iter().filter(|line| seen.insert(&line.id)).collect();
    left.retain(|line| !had.contains(line.id.as_str()) || shared.store.outcome(&line.id).is_none());
    left.reverse();
    let is_closed = |line: &CaseLine| line.model == ModelKind::ClosedForm;
    left.sort_by(|a, b| is_closed(a).cmp(&is_closed(b)).then(a.memory_bytes.total_cmp(&b.memory_bytes)));
    let memory = memory_available().map_or(f64::INFINITY, |free| MEMORY_SHARE * free);
    let cores = cores::cores().count;
    let has_runs = left.iter().any(|line| line.model == ModelKind::Solver);
    let usual = if has_runs { (cores / pool.threads).max(1) } else { cores };
    let workers = pool.workers.unwrap_or(usual).clamp(1, left.len().max(1));
    let queue = Mutex::new(Queue { left, used: 0.0, running: 0, end: PoolEnd::default() });
    let free = Condvar::new();
    std::thread::scope(|scope| {
        // This thread is one of them; where the system has no room for more, it does all the work.
        for _ in 1..workers {
            let work = || work(shared, (&queue, &free, memory), watcher);
            let _ = std::thread::Builder::new().spawn_scoped(scope, work);
        }
        work(shared, (&queue, &free, memory), watcher);
    });
    let mut end = queue.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner).end;
    end.stopped = end.stopped.or_else(|| shared.interrupts.stopped_by());
    end
}

/// Takes cases from the queue until none is left.
fn work(shared: &Shared, (queue, free, memory): (&Mutex<Queue>, &Condvar, f64), watcher: &dyn Watcher) {
    while let Some(line) = next(shared, queue, free, memory) {
        watcher.begun(line);
        // A fault in one case must not take the others with it.
        let outcome = catch_unwind(AssertUnwindSafe(|| evaluate(shared, line))).unwrap_or_else(|_| {
            let why = "an internal error: please report it with the case".to_owned();
            let noted = shared.store.note_failure(&line.id, &why);
            Err(noted.map_or_else(Unended::from, |()| Unended::Other(why)))
        });
        watcher.ended(line, &outcome);
        let mut queue = queue.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        queue.used -= line.memory_bytes;
        queue.running -= 1;
        match outcome {
            Ok(_) => queue.end.ended += 1,
            Err(Unended::Stopped(signal)) => queue.end.stopped = Some(signal),
            // Another engine has it: its outcome is not ours.
            Err(Unended::Busy(_)) => {}
            Err(_) => queue.end.failed += 1,
        }
        free.notify_all();
    }
}

/// The next case for which there is memory; waits for some. `None` where none is left, or a signal has
/// stopped the pool.
fn next<'a>(shared: &Shared, queue: &Mutex<Queue<'a>>, free: &Condvar, memory: f64) -> Option<&'a CaseLine> {
    let mut queue = queue.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    loop {
        if shared.interrupts.stopped_by().is_some() || queue.left.is_empty() {
            return None;
        }
        let used = queue.used;
        // A case that is larger than all memory runs alone: the system decides.
        let fits = |line: &&CaseLine| used + line.memory_bytes <= memory;
        let chosen = queue.left.iter().rposition(fits);
        let chosen = chosen.or_else(|| (queue.running == 0).then(|| queue.left.len() - 1));
        if let Some(n) = chosen {
            let line = queue.left.remove(n);
            queue.used += line.memory_bytes;
            queue.running += 1;
            return Some(line);
        }
        queue = free.wait(queue).unwrap_or_else(std::sync::PoisonError::into_inner);
    }
}
