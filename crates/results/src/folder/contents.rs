//! The contents of a results folder, and clearing it for a new result.

use super::lock::LOCK;
use super::run_record::{Outcome, RUN_RECORD, RunRecord};
use crate::files::{
    BODIES, CHECKPOINTS, EntryKind, FIELDS, Inside, LISTS, LOG, Named, OutputError, PICTURES, PLOTS, REPORT,
    RESOLVED, SUMMARY, TYPED, VARIATIONS,
};
use crate::tables::{
    BOUNDARIES_FILE, ENERGY_FILE, GROUND_LEFT_FILE, HEIGHT_MAP_FILE, HistoryNames, filtered_name,
    forces_name, joint_name, part_name, rim_name, rut_name,
};
use std::path::Path;

/// The contents of a results folder.
#[derive(Debug)]
pub enum Contents {
    /// Nothing.
    Nothing,
    /// A run, with its record.
    Run(Box<RunRecord>),
    /// Files that are not a result of Coulter.
    Foreign,
}

/// Inspects a folder.
///
/// # Errors
/// When it cannot be listed, or holds a run of another version of the format.
pub fn inspect(dir: &Path) -> Result<Contents, OutputError> {
    if !dir.exists() {
        return Ok(Contents::Nothing);
    }
    // The record names the bodies, hence the files. Without one only the files that a run writes before it
    // are known to be ours.
    match RunRecord::read(dir) {
        Ok(record) => return Ok(Contents::Run(Box::new(record))),
        // A run, but which files it wrote is not known; or the record is a link.
        Err(error @ (OutputError::Format { .. } | OutputError::File { .. })) => return Err(error),
        Err(_) => {}
    }
    let early = [LOCK.to_owned(), format!("{RUN_RECORD}.part")];
    for name in Inside::of(dir, "").names().named("list", dir)? {
        // Variations outlive the case's own run while that is started again.
        let is_ours = if name == VARIATIONS {
            runs_in(&Inside::of(dir, VARIATIONS))?.iter().all(|(_, contents)| !contents.is_foreign())
        } else {
            early.iter().any(|e| name == e.as_str())
        };
        if !is_ours {
            return Ok(Contents::Foreign);
        }
    }
    Ok(Contents::Nothing)
}

impl Contents {
    fn is_foreign(&self) -> bool {
        matches!(self, Self::Foreign)
    }
}

/// The folders of runs in such a folder, with their contents.
fn runs_in(folder: &Inside) -> Result<Vec<(Inside, Contents)>, OutputError> {
    match folder.kind() {
        Ok(None) => return Ok(Vec::new()),
        Ok(Some(EntryKind::Folder)) => {}
        _ => return Ok(vec![(folder.clone(), Contents::Foreign)]),
    }
    let names = folder.names().named("list", &folder.path())?;
    let runs = names.into_iter().map(|name| {
        let run = folder.join(name);
        let contents = if run.is_folder() { inspect(&run.path())? } else { Contents::Foreign };
        Ok((run, contents))
    });
    runs.collect()
}

/// Removes the runs of variations, and their folders if nothing else is in them; what no run has written
/// stays.
pub fn clear_beside(dir: &Path) -> Result<(), OutputError> {
    let folder = &Inside::of(dir, VARIATIONS);
    for (run, contents) in runs_in(folder)? {
        if let Contents::Run(record) = &contents {
            remove_result(&run.path(), record)?;
        }
        if !contents.is_foreign() {
            remove_file(&run.join(LOCK))?;
            remove_if_empty(&run)?;
        }
    }
    if folder.is_folder() { remove_if_empty(folder) } else { Ok(()) }
}

/// Clears a folder for a new result; a folder with other files in it is never touched.
pub fn clear(dir: &Path, force: bool) -> Result<(), OutputError> {
    let path = dir.to_path_buf();
    match inspect(dir)? {
        Contents::Nothing => Ok(()),
        Contents::Foreign => Err(OutputError::Foreign { path }),
        Contents::Run(record) if force => remove_result(dir, &record),
        Contents::Run(record)
            if matches!(record.statistics.outcome, Outcome::Running | Outcome::Interrupted) =>
        {
            Err(OutputError::Unfinished { path })
        }
        Contents::Run(_) => Err(OutputError::Exists { path }),
    }
}

/// Removes files that a killed run left unfinished.
pub fn remove_parts(dir: &Path) -> Result<(), OutputError> {
    for folder in ["", BODIES, FIELDS, PICTURES, PLOTS, CHECKPOINTS] {
        let folder = Inside::of(dir, folder);
        for name in folder.names().named("list", &folder.path())? {
            if Path::new(&name).extension().is_some_and(|e| e == "part") {
                remove_file(&folder.join(name))?;
            }
        }
    }
    Ok(())
}

fn remove_result(dir: &Path, record: &RunRecord) -> Result<(), OutputError> {
    let HistoryNames { bodies: names, parts, joints } = record.names();
    let mut files: Vec<String> = (0..names.len())
        .flat_map(|n| [forces_name, filtered_name, rim_name, rut_name].map(|name| name(&names, n)))
        .collect();
    files.extend(parts.iter().map(|name| part_name(name)));
    files.extend(joints.iter().map(|name| joint_name(name)));
    let fixed = [
        SUMMARY,
        REPORT,
        ENERGY_FILE,
        BOUNDARIES_FILE,
        GROUND_LEFT_FILE,
        HEIGHT_MAP_FILE,
        RESOLVED,
        TYPED,
        LOG,
    ];
    files.extend(fixed.iter().chain(&LISTS).map(|name| (*name).to_owned()));
    for file in files {
        remove_file(&Inside::of(dir, file))?;
    }
    for (folder, extensions) in [
        (BODIES, &["stl", "obj", "ply", "csv"][..]),
        (FIELDS, &["vtr", "pvtr", "vtp", "vtkhdf"]),
        (PICTURES, &["png", "svg", "csv", "gif", "apng"]),
        (PLOTS, &["svg"]),
        (CHECKPOINTS, &["checkpoint", "portion"]),
    ] {
        remove_files(&Inside::of(dir, folder), extensions)?;
    }
    // Last: as long as it exists, the folder is recognised as a result and the removal can be repeated.
    remove_parts(dir)?;
    remove_file(&Inside::of(dir, RUN_RECORD))
}

fn remove_file(file: &Inside) -> Result<(), OutputError> {
    file.remove().named("remove", &file.path())
}

/// Removes the files with one of these extensions from a folder, and the folder if it is empty then.
fn remove_files(folder: &Inside, extensions: &[&str]) -> Result<(), OutputError> {
    let path = folder.path();
    let mut is_empty = folder.exists();
    for name in folder.names().named("list", &path)? {
        if Path::new(&name).extension().is_some_and(|e| extensions.iter().any(|extension| e == *extension)) {
            remove_file(&folder.join(name))?;
        } else {
            is_empty = false;
        }
    }
    if is_empty { folder.remove_folder().named("remove", &path) } else { Ok(()) }
}

fn remove_if_empty(folder: &Inside) -> Result<(), OutputError> {
    // No extension is removed: only an empty folder is.
    remove_files(folder, &[])
}
