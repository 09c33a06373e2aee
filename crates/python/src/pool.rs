//! Many small pieces of work on several threads.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// The results of `work` for the numbers below `count`, in their order, on as many threads; `None` if `stop`
/// was set meanwhile.
pub(crate) fn map<T: Send>(
    count: usize,
    threads: usize,
    stop: &AtomicBool,
    work: impl Fn(usize) -> T + Sync,
) -> Option<Vec<T>> {
    let next = AtomicUsize::new(0);
    let some = || {
        let mut done = Vec::new();
        while !stop.load(Ordering::Relaxed) {
            let number = next.fetch_add(1, Ordering::Relaxed);
            if number >= count {
                break;
            }
            done.push((number, work(number)));
        }
        done
    };
    let mut all = std::thread::scope(|scope| {
        let workers: Vec<_> = (0..threads.clamp(1, count.max(1))).map(|_| scope.spawn(some)).collect();
        // A worker that has failed takes the others with it: the caller reports it.
        workers
            .into_iter()
            .flat_map(|worker| worker.join().unwrap_or_else(|why| std::panic::resume_unwind(why)))
            .collect::<Vec<_>>()
    });
    all.sort_by_key(|(number, _)| *number);
    (!stop.load(Ordering::Relaxed)).then(|| all.into_iter().map(|(_, result)| result).collect())
}
