//! The pool of this machine: cases that run side by side, as many as cores and memory allow, also that of the
//! device which they share.

use super::evaluate::{Shared, Unended, evaluate};
use super::expand;
use super::line::CaseLine;
use super::outcome::Outcome;
use crate::study::{ModelKind, Pool};
use coulter::case::cores;
use coulter::case::machine::memory_available;
use coulter::run::on_device;
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

/// Memory [bytes], of the processor and of a device.
type Memory = [f64; 2];

/// A case that is to be run, and what it takes.
type Wanted<'a> = (&'a CaseLine, Memory);

/// What is left to do, and what is being done.
struct Queue<'a> {
    /// Cases in the order in which they are begun, the last one first.
    left: Vec<Wanted<'a>>,
    /// What the runs that are on take.
    used: Memory,
    /// Number of cases that are on.
    running: usize,
    end: PoolEnd,
}

impl<'a> Queue<'a> {
    /// Takes the first case for which there is memory.
    fn take(&mut self, memory: Memory) -> Option<Wanted<'a>> {
        let used = self.used;
        let fits = |(_, taken): &Wanted| [0, 1].iter().all(|of| used[*of] + taken[*of] <= memory[*of]);
        // A case that is larger than all memory runs alone: the system decides.
        let alone = || (self.running == 0).then(|| self.left.len() - 1);
        let (line, taken) = self.left.remove(self.left.iter().rposition(fits).or_else(alone)?);
        self.used = [0, 1].map(|of| used[of] + taken[of]);
        self.running += 1;
        Some((line, taken))
    }
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
    let of_device = shared.device.open().ok().flatten().and_then(|driver| driver.free_memory());
    let memory = [memory_available(), of_device].map(|free| free.map_or(f64::INFINITY, |f| MEMORY_SHARE * f));
    let on_device = |line: &CaseLine| match (of_device, line.model) {
        (Some(_), ModelKind::Solver) => footprint(shared, line),
        _ => 0.0,
    };
    let left: Vec<Wanted> =
        left.into_iter().map(|line| (line, [line.memory_bytes, on_device(line)])).collect();
    let cores = cores::cores().count;
    let has_runs = left.iter().any(|(line, _)| line.model == ModelKind::Solver);
    let usual = if has_runs { (cores / pool.threads).max(1) } else { cores };
    let workers = pool.workers.unwrap_or(usual).clamp(1, left.len().max(1));
    let queue = Mutex::new(Queue { left, used: [0.0; 2], running: 0, end: PoolEnd::default() });
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

/// Memory that a case takes on a device [bytes]; one that is not valid takes none.
fn footprint(shared: &Shared, line: &CaseLine) -> f64 {
    let case = shared.cases.get(line.case).and_then(|base| expand::read(base, line).ok());
    case.map_or(0.0, |case| on_device::footprint(&case))
}

/// Takes cases from the queue until none is left.
fn work(shared: &Shared, (queue, free, memory): (&Mutex<Queue>, &Condvar, Memory), watcher: &dyn Watcher) {
    while let Some((line, taken)) = next(shared, queue, free, memory) {
        watcher.begun(line);
        // A fault in one case must not take the others with it.
        let outcome = catch_unwind(AssertUnwindSafe(|| evaluate(shared, line))).unwrap_or_else(|_| {
            let why = "an internal error: please report it with the case".to_owned();
            let noted = shared.store.note_failure(&line.id, &why);
            Err(noted.map_or_else(Unended::from, |()| Unended::Other(why)))
        });
        watcher.ended(line, &outcome);
        let mut queue = queue.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        queue.used = [0, 1].map(|of| queue.used[of] - taken[of]);
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
fn next<'a>(shared: &Shared, queue: &Mutex<Queue<'a>>, free: &Condvar, memory: Memory) -> Option<Wanted<'a>> {
    let mut queue = queue.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    loop {
        if shared.interrupts.stopped_by().is_some() || queue.left.is_empty() {
            return None;
        }
        if let Some(wanted) = queue.take(memory) {
            return Some(wanted);
        }
        queue = free.wait(queue).unwrap_or_else(std::sync::PoisonError::into_inner);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sweep::id::CaseId;

    #[test]
    fn cases_that_run_side_by_side_have_memory_on_processor_and_device() {
        let line = CaseLine {
            id: CaseId::of_run(1),
            point: 1,
            part: String::new(),
            case: 0,
            model: ModelKind::Solver,
            meshes: None,
            factors: Vec::new(),
            set: Vec::new(),
            memory_bytes: 0.0,
            refused: String::new(),
        };
        let left = vec![(&line, [1.0, 5.0]), (&line, [3.0, 1.0]), (&line, [2.0, 4.0]), (&line, [9.0, 9.0])];
        let mut queue = Queue { left, used: [0.0; 2], running: 0, end: PoolEnd::default() };
        let mut taken = || queue.take([4.0, 6.0]).map(|(_, taken)| taken);
        // The largest runs neither beside others nor before them.
        assert_eq!([taken(), taken()], [Some([2.0, 4.0]), None]);
        queue.used = [0.0; 2];
        queue.running = 0;
        let mut taken = || queue.take([4.0, 6.0]).map(|(_, taken)| taken);
        assert_eq!([taken(), taken(), taken()], [Some([3.0, 1.0]), Some([1.0, 5.0]), None]);
        (queue.used, queue.running) = ([0.0; 2], 0);
        assert_eq!(queue.take([4.0, 6.0]).map(|(_, taken)| taken), Some([9.0, 9.0]));
    }
}
