//! What a results folder holds, and clearing it for a new result.

use super::csv::{BOUNDARIES, ENERGY, forces_name};
use super::error::{Named, OutputError};
use super::lock::LOCK;
pub use super::names::CHECKPOINTS;
use super::names::{FIELDS, LISTS, LOG, PICTURES, PLOTS, REPORT, RESOLVED, TYPED};
use super::run_record::{Outcome, RUN_RECORD, RunRecord};
use super::summary::SUMMARY;
use std::fs;
use std::path::Path;

/// What a results folder holds.
#[derive(Debug)]
pub enum Holds {
    /// Nothing.
    Nothing,
    /// A run, as it tells of itself.
    Run(Box<RunRecord>),
    /// Files that are no result of Coulter.
    Others,
}

/// Looks at a folder.
///
/// # Errors
/// When it cannot be listed.
pub fn look(dir: &Path) -> Result<Holds, OutputError> {
    if !dir.exists() {
        return Ok(Holds::Nothing);
    }
    // The record names the bodies, hence the files. Without one nothing here is known to be ours, but for what a run
    // writes before it.
    if let Ok(record) = RunRecord::read(dir) {
        return Ok(Holds::Run(Box::new(record)));
    }
    let early = [LOCK.to_owned(), format!("{RUN_RECORD}.part")];
    for entry in fs::read_dir(dir).named("list", dir)? {
        let name = entry.named("list", dir)?.file_name();
        if !early.iter().any(|e| name == e.as_str()) {
            return Ok(Holds::Others);
        }
    }
    Ok(Holds::Nothing)
}

/// Makes room for a new result; a folder with other files in it is never touched.
pub(super) fn clear(dir: &Path, force: bool) -> Result<(), OutputError> {
    let path = dir.to_path_buf();
    match look(dir)? {
        Holds::Nothing => Ok(()),
        Holds::Others => Err(OutputError::Foreign { path }),
        Holds::Run(record) if force => remove_result(dir, &record),
        Holds::Run(record)
            if matches!(record.statistics.outcome, Outcome::Running | Outcome::Interrupted) =>
        {
            Err(OutputError::Unfinished { path })
        }
        Holds::Run(_) => Err(OutputError::Exists { path }),
    }
}

/// Removes what a killed run was about to write.
pub(super) fn remove_parts(dir: &Path) -> Result<(), OutputError> {
    for folder in ["", FIELDS, PICTURES, PLOTS, CHECKPOINTS] {
        let folder = dir.join(folder);
        if !folder.is_dir() {
            continue;
        }
        for entry in fs::read_dir(&folder).named("list", &folder)? {
            let path = entry.named("list", &folder)?.path();
            if path.extension().is_some_and(|e| e == "part") {
                remove_file(&path)?;
            }
        }
    }
    Ok(())
}

fn remove_result(dir: &Path, record: &RunRecord) -> Result<(), OutputError> {
    let names: Vec<String> = record.bodies.iter().map(|b| b.name.clone()).collect();
    let mut files: Vec<String> = (0..names.len()).map(|n| forces_name(&names, n)).collect();
    let fixed = [SUMMARY, REPORT, ENERGY, BOUNDARIES, RESOLVED, TYPED, LOG];
    files.extend(fixed.iter().chain(&LISTS).map(|name| (*name).to_owned()));
    for file in files {
        remove_file(&dir.join(file))?;
    }
    for (folder, endings) in [
        (FIELDS, &["vtr", "vtp"][..]),
        (PICTURES, &["png", "svg", "csv"]),
        (PLOTS, &["svg"]),
        (CHECKPOINTS, &["checkpoint"]),
    ] {
        remove_files(&dir.join(folder), endings)?;
    }
    // Last: as long as it is there, the folder is known as a result and the removal can be taken up again.
    remove_parts(dir)?;
    remove_file(&dir.join(RUN_RECORD))
}

fn remove_file(path: &Path) -> Result<(), OutputError> {
    if path.is_file() { fs::remove_file(path).named("remove", path) } else { Ok(()) }
}

/// Removes the files with one of these endings from a folder, and the folder when it is empty then.
fn remove_files(folder: &Path, endings: &[&str]) -> Result<(), OutputError> {
    if !folder.is_dir() {
        return Ok(());
    }
    let mut others = false;
    for entry in fs::read_dir(folder).named("list", folder)? {
        let path = entry.named("list", folder)?.path();
        if path.extension().is_some_and(|e| endings.iter().any(|ending| e == *ending)) {
            remove_file(&path)?;
        } else {
            others = true;
        }
    }
    if others { Ok(()) } else { fs::remove_dir(folder).named("remove", folder) }
}
