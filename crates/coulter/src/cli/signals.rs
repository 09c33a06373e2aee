//! Signals: SIGINT, SIGTERM and SIGHUP stop a run at its next step, SIGUSR1 has it write a checkpoint and go on. A second
//! stop ends the program at once. SIGXFSZ is an error of the write that meets it.

use crate::interrupts::Interrupts;
use signal_hook::consts::{SIGINT, SIGTERM};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// The requests that signals make from now on.
///
/// Where a handler cannot be set the signal does what it always does: nothing that was written is lost.
pub(super) fn listen() -> Interrupts {
    let interrupts = Interrupts::default();
    let mut stops = vec![SIGINT, SIGTERM];
    if !hangup_is_ignored() {
        stops.extend(hangup());
    }
    let stopping = Arc::new(AtomicBool::new(false));
    for signal in stops {
        // In this order: the second one finds the flag that the first one has set.
        let _ = signal_hook::flag::register_conditional_shutdown(signal, 128 + signal, Arc::clone(&stopping));
        let _ = signal_hook::flag::register(signal, Arc::clone(&stopping));
        let number = usize::try_from(signal).unwrap_or(0);
        let _ = signal_hook::flag::register_usize(signal, Arc::clone(&interrupts.stop), number);
    }
    on_request(&interrupts);
    interrupts
}

/// Has a write beyond a limit on the size of files (`ulimit -f`) fail, as one on a full disc does, instead of ending the
/// program by SIGXFSZ.
#[cfg(unix)]
pub(super) fn outlive_file_limits() {
    // The handler has nothing to do: that there is one is enough. Where it cannot be set the signal does what it always does.
    let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, Arc::default());
}

/// There is no such signal (untested).
#[cfg(not(unix))]
pub(super) fn outlive_file_limits() {}

#[cfg(unix)]
fn hangup() -> Option<i32> {
    Some(signal_hook::consts::SIGHUP)
}

/// There is none (untested).
#[cfg(not(unix))]
fn hangup() -> Option<i32> {
    None
}

#[cfg(unix)]
fn on_request(interrupts: &Interrupts) {
    let _ = signal_hook::flag::register(signal_hook::consts::SIGUSR1, Arc::clone(&interrupts.checkpoint));
}

/// There is no such signal (untested).
#[cfg(not(unix))]
fn on_request(_: &Interrupts) {}

/// Whether whoever started the program wants it to outlive its terminal (`nohup`); only Linux tells.
fn hangup_is_ignored() -> bool {
    let Ok(status) = std::fs::read_to_string("/proc/self/status") else { return false };
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    // Bit 0 stands for SIGHUP.
    mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).is_some_and(|mask| mask & 1 == 1)
}
