//! Where the checkpoints of a results folder are.

use crate::output::files::{CHECKPOINTS, Named, OutputError};
use std::fs;
use std::path::{Path, PathBuf};

const LAST: &str = "last.checkpoint";
const PREVIOUS: &str = "previous.checkpoint";
const FAILED: &str = "failed.checkpoint";

/// Path of the last checkpoint of a results folder.
#[must_use]
pub fn path(dir: &Path) -> PathBuf {
    dir.join(CHECKPOINTS).join(LAST)
}

/// Path of the checkpoint of the state in which a run broke down.
#[must_use]
pub fn failed_path(dir: &Path) -> PathBuf {
    dir.join(CHECKPOINTS).join(FAILED)
}

/// Path of the checkpoint before the last.
pub(super) fn previous_path(dir: &Path) -> PathBuf {
    dir.join(CHECKPOINTS).join(PREVIOUS)
}

/// Whether a results folder has a checkpoint to resume from.
#[must_use]
pub fn exists(dir: &Path) -> bool {
    [LAST, PREVIOUS].iter().any(|name| dir.join(CHECKPOINTS).join(name).is_file())
}

/// Removes the last checkpoint: a damaged one must not replace the one before.
///
/// # Errors
/// When it is there and cannot be removed.
pub fn forget_last(dir: &Path) -> Result<(), OutputError> {
    let path = path(dir);
    if path.is_file() { fs::remove_file(&path).named("remove", &path) } else { Ok(()) }
}

/// Removes the checkpoint before the last: a run that has come to its end needs no other to fall back on.
///
/// # Errors
/// When it is there and cannot be removed.
pub fn forget_previous(dir: &Path) -> Result<(), OutputError> {
    let path = previous_path(dir);
    if path.is_file() { fs::remove_file(&path).named("remove", &path) } else { Ok(()) }
}
