//! Signals: SIGINT, SIGTERM and SIGHUP stop a run at its next step, SIGUSR1 makes it write a checkpoint and
//! continue. A second stop signal ends the program immediately, unless it is the first once more: `timeout`
//! and some schedulers signal a program, and then its group. SIGXFSZ becomes an error of the write that
//! causes it.

use coulter::interrupts::Interrupts;
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::low_level;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::time::Instant;

/// For so long [ms] a signal that comes again is the same request: chosen, above the time between the two of
/// `timeout` on a busy machine, below that in which a user presses Ctrl-C again.
const SAME_REQUEST: u64 = 500;

/// Installs the signal handlers; returns the requests that they set.
///
/// A signal whose handler cannot be installed keeps its default action: nothing that was written is lost.
pub(super) fn listen() -> Interrupts {
    let interrupts = Interrupts { at_sample: suspension(), ..Interrupts::default() };
    let mut stops = vec![SIGINT, SIGTERM];
    if !hangup_is_ignored() {
        stops.extend(hangup());
    }
    let (began, first) = (Instant::now(), Arc::new(AtomicU64::new(0)));
    for signal in stops {
        let number = usize::try_from(signal).unwrap_or(0);
        let first = Arc::clone(&first);
        let action = move || {
            let now = u64::try_from(began.elapsed().as_millis()).unwrap_or(u64::MAX);
            if is_second(&first, number, now) {
                low_level::exit(128 + signal);
            }
        };
        // SAFETY: it uses a clock, an atomic number and an exit meant for handlers; no memory, no lock.
        #[allow(unsafe_code)]
        let _ = unsafe { low_level::register(signal, action) };
        let _ = signal_hook::flag::register_usize(signal, Arc::clone(&interrupts.stop), number);
    }
    on_request(&interrupts);
    interrupts
}

/// Whether a stop signal that arrives `now` [ms] is a second one: another than the first, or the same later
/// than [`SAME_REQUEST`]. The first is kept in `first`.
fn is_second(first: &AtomicU64, signal: usize, now: u64) -> bool {
    let this = (now << 8) | signal as u64;
    match first.compare_exchange(0, this, Ordering::Relaxed, Ordering::Relaxed) {
        Ok(_) => false,
        Err(first) => first & 0xff != signal as u64 || now.saturating_sub(first >> 8) > SAME_REQUEST,
    }
}

/// Makes a write beyond a limit on the file size (`ulimit -f`) fail as on a full disk, instead of ending the
/// program by SIGXFSZ.
#[cfg(unix)]
pub(super) fn ignore_file_size_signal() {
    // An empty handler is enough. If it cannot be installed the signal keeps its default action.
    let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, Arc::default());
}

/// Does nothing: the system has no such signal (untested).
#[cfg(not(unix))]
pub(super) fn ignore_file_size_signal() {}

/// For tests: `COULTER_SUSPEND_EVERY=5` suspends the program (SIGSTOP) at every fifth sample, so that what is
/// done to it in its middle races no clock.
#[cfg(unix)]
fn suspension() -> Option<fn()> {
    static EVERY: AtomicUsize = AtomicUsize::new(0);
    static SAMPLES: AtomicUsize = AtomicUsize::new(0);
    let every = std::env::var("COULTER_SUSPEND_EVERY").ok()?.parse().ok().filter(|every| *every > 0)?;
    EVERY.store(every, Ordering::Relaxed);
    Some(|| {
        let samples = SAMPLES.fetch_add(1, Ordering::Relaxed) + 1;
        if samples.is_multiple_of(EVERY.load(Ordering::Relaxed)) {
            let _ = low_level::raise(signal_hook::consts::SIGSTOP);
        }
    })
}

/// No suspension: the system has no such signal (untested).
#[cfg(not(unix))]
fn suspension() -> Option<fn()> {
    None
}

#[cfg(unix)]
fn hangup() -> Option<i32> {
    Some(signal_hook::consts::SIGHUP)
}

/// No number: the system has no such signal (untested).
#[cfg(not(unix))]
fn hangup() -> Option<i32> {
    None
}

#[cfg(unix)]
fn on_request(interrupts: &Interrupts) {
    let _ = signal_hook::flag::register(signal_hook::consts::SIGUSR1, Arc::clone(&interrupts.checkpoint));
}

/// Does nothing: the system has no such signal (untested).
#[cfg(not(unix))]
fn on_request(_: &Interrupts) {}

/// Whether the program is to continue after its terminal is closed (`nohup`); known on Linux only.
fn hangup_is_ignored() -> bool {
    let Ok(status) = std::fs::read_to_string("/proc/self/status") else { return false };
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    // Bit 0 stands for SIGHUP.
    mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).is_some_and(|mask| mask & 1 == 1)
}

#[cfg(test)]
mod tests {
    use super::{SAME_REQUEST, is_second};
    use std::sync::atomic::AtomicU64;

    #[test]
    fn a_signal_to_program_and_group_is_one_request() {
        let first = AtomicU64::new(0);
        assert!(!is_second(&first, 15, 0));
        assert!(!is_second(&first, 15, 3));
        assert!(!is_second(&first, 15, SAME_REQUEST));
        assert!(is_second(&first, 15, SAME_REQUEST + 1));
        assert!(is_second(&first, 2, 3));
    }
}
