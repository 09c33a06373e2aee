//! Where the checkpoints of a results folder are.

use crate::files::{CHECKPOINTS, Inside, Named, OutputError};
use std::path::{Path, PathBuf};

/// Stands for the path of a checkpoint that is in no file.
pub(super) const IN_MEMORY: &str = "the checkpoint";

const LAST: &str = "last.checkpoint";
const PREVIOUS: &str = "previous.checkpoint";
const FAILED: &str = "failed.checkpoint";

/// Path of the last checkpoint of a results folder.
#[must_use]
pub fn path(dir: &Path) -> PathBuf {
    last(dir).path()
}

/// The last checkpoint of a results folder.
pub(super) fn last(dir: &Path) -> Inside {
    Inside::of(dir, CHECKPOINTS).join(LAST)
}

/// Path of the checkpoint of the state in which a run broke down.
#[must_use]
pub fn failed_path(dir: &Path) -> PathBuf {
    failed(dir).path()
}

/// The checkpoint of the state in which a run broke down.
pub(super) fn failed(dir: &Path) -> Inside {
    Inside::of(dir, CHECKPOINTS).join(FAILED)
}

/// The checkpoint before the last.
pub(super) fn previous(dir: &Path) -> Inside {
    Inside::of(dir, CHECKPOINTS).join(PREVIOUS)
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
    let folder = Inside::of(dir, CHECKPOINTS);
    let mut portions = Vec::new();
    for name in folder.names().named("list", &folder.path())? {
        if Path::new(&name).extension().is_some_and(|extension| extension == PORTION) {
            let shown = name.to_string_lossy();
            let of_step: Option<u64> = shown.split('_').next().and_then(|number| number.parse().ok());
            portions.extend(of_step.map(|step| (step, folder.join(&name))));
        }
    }
    let before = portions.iter().map(|(of_step, _)| *of_step).filter(|of_step| *of_step < step).max();
    let is_old = |of_step: u64| of_step != step && Some(of_step) != before;
    for (_, portion) in portions.iter().filter(|(of_step, _)| is_old(*of_step)) {
        portion.remove().named("remove", &portion.path())?;
    }
    Ok(())
}

/// Whether a results folder has a checkpoint to resume from; reading it says whether it can be used.
#[must_use]
pub fn exists(dir: &Path) -> bool {
    last(dir).exists() || previous(dir).exists()
}

/// Removes the last checkpoint: a damaged one must not replace the one before.
///
/// # Errors
/// When it is there and cannot be removed.
pub fn forget_last(dir: &Path) -> Result<(), OutputError> {
    last(dir).remove().named("remove", &path(dir))
}

/// Removes the checkpoint before the last: a run that has finished needs no other to fall back on.
///
/// # Errors
/// When it is there and cannot be removed.
pub fn forget_previous(dir: &Path) -> Result<(), OutputError> {
    let previous = previous(dir);
    previous.remove().named("remove", &previous.path())
}
