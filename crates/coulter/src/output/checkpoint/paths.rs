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

/// Extension of the files that hold soil and nodes of a block.
const PORTION: &str = "portion";

/// Name of the file with soil and nodes of a block, at a step.
pub(super) fn portion_name(step: u64, [rank, blocks]: [usize; 2]) -> String {
    format!("{step:012}_{rank:04}_of_{blocks:04}.{PORTION}")
}

/// Removes the portions of steps before that of the checkpoint before the last, which is at `step`.
///
/// # Errors
/// When one cannot be removed.
pub(super) fn remove_old_portions(dir: &Path, step: u64) -> Result<(), OutputError> {
    let folder = dir.join(CHECKPOINTS);
    let mut portions = Vec::new();
    for entry in fs::read_dir(&folder).named("list", &folder)? {
        let path = entry.named("list", &folder)?.path();
        if path.extension().is_some_and(|extension| extension == PORTION) {
            let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            let of_step: Option<u64> = name.split('_').next().and_then(|number| number.parse().ok());
            portions.extend(of_step.map(|step| (step, path)));
        }
    }
    let before = portions.iter().map(|(of_step, _)| *of_step).filter(|of_step| *of_step < step).max();
    let is_old = |of_step: u64| of_step != step && Some(of_step) != before;
    for (_, path) in portions.iter().filter(|(of_step, _)| is_old(*of_step)) {
        fs::remove_file(path).named("remove", path)?;
    }
    Ok(())
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
