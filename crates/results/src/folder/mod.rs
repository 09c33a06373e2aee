//! A results folder as such: what it holds and may be cleared of, its lock, its log, and the record that
//! identifies it.
//!
//! One run at a time uses a folder, and files that no run has written are never touched.

mod contents;
mod describe;
mod lock;
mod log;
mod run_record;

pub use contents::{Contents, inspect};
pub use contents::{clear, clear_beside, remove_parts};
pub use lock::Lock;
pub use log::Log;
pub use run_record::{JointRecord, Outcome, PartRecord, RunRecord, RunStatistics, StageRecord, hash_of};
