//! Checkpoints: everything that changes, so that a run can resume as if it had never stopped.
//!
//! A file holds a magic word with the version of the file, the hash of the layout of its contents, a
//! compressed record of the state, the history and the case that they belong to, and at its end the hash of
//! the compressed record. It is written next to the last one, synced to disk and then moved over it; the last
//! becomes the one before. A kill at any time leaves one whole.

mod contents;
mod fit;
mod layout;
mod paths;
mod read;
mod write;

pub use contents::{Checkpoint, CheckpointView};
pub use paths::{exists, failed_path, forget_last, forget_previous, path};
