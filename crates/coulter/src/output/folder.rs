//! The names inside a results folder, and making room for a new result.

use super::csv::forces_name;
use super::error::{Named, OutputError};
use super::run_record::{RUN_RECORD, RunRecord};
use super::summary::SUMMARY;
use std::fs;
use std::path::Path;

/// Folder of checkpoints inside a results folder.
pub const CHECKPOINTS: &str = "checkpoints";
pub(super) const FIELDS: &str = "fields";
pub(super) const PICTURES: &str = "pictures";
pub(super) const PLOTS: &str = "plots";
pub(super) const RESOLVED: &str = "resolved.toml";
pub(super) const TYPED: &str = "case.toml";
pub(super) const REPORT: &str = "report.html";
pub(super) const LOG: &str = "run.log";
pub(super) const LISTS: [&str; 3] = ["soil.pvd", "surface.pvd", "body.pvd"];

/// Makes room for a new result.
pub(super) fn clear(dir: &Path, force: bool) -> Result<(), OutputError> {
    if !dir.exists() {
        return Ok(());
    }
    let mut entries = fs::read_dir(dir).named("list", dir)?;
    if entries.next().is_none() {
        return Ok(());
    }
    // The record names the bodies, hence the files. Without one nothing here is known to be ours.
    let Ok(record) = RunRecord::read(dir) else {
        return Err(OutputError::Foreign { path: dir.to_path_buf() });
    };
    if !force {
        return Err(OutputError::Exists { path: dir.to_path_buf() });
    }
    remove_result(dir, &record)
}

fn remove_result(dir: &Path, record: &RunRecord) -> Result<(), OutputError> {
    let names: Vec<String> = record.bodies.iter().map(|b| b.name.clone()).collect();
    let mut files: Vec<String> = (0..names.len()).map(|n| forces_name(&names, n)).collect();
    let fixed = [SUMMARY, REPORT, "energy.csv", RESOLVED, TYPED, LOG];
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
