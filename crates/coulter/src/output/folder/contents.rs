//! The contents of a results folder, and clearing it for a new result.

use super::lock::LOCK;
use super::run_record::{Outcome, RUN_RECORD, RunRecord};
use crate::output::files::{
    BODIES, CHECKPOINTS, FIELDS, LISTS, LOG, MESHES, Named, OutputError, PICTURES, PLOTS, REPORT, RESOLVED,
    SUMMARY, TYPED, VARIATIONS,
};
use crate::output::tables::{
    BOUNDARIES_FILE, ENERGY_FILE, GROUND_LEFT_FILE, HEIGHT_MAP_FILE, HistoryNames, filtered_name,
    forces_name, joint_name, part_name, rim_name, rut_name,
};
use std::fs;
use std::path::{Path, PathBuf};

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
    // The record names the bodies, hence the files. Without one only the files that a run writes before it are known to be
    // ours.
    match RunRecord::read(dir) {
        Ok(record) => return Ok(Contents::Run(Box::new(record))),
        // A run, but which files it wrote is not known.
        Err(error @ OutputError::Format { .. }) => return Err(error),
        Err(_) => {}
    }
    let early = [LOCK.to_owned(), format!("{RUN_RECORD}.part")];
    for entry in fs::read_dir(dir).named("list", dir)? {
        let entry = entry.named("list", dir)?;
        let name = entry.file_name();
        // Runs on coarser meshes outlive that on the finest while it is started again, and so do variations.
        let mut is_ours = early.iter().any(|e| name == e.as_str());
        for folder in BESIDE.into_iter().filter(|folder| name == *folder) {
            is_ours = runs_in(&dir.join(folder))?.iter().all(|(_, contents)| !contents.is_foreign());
        }
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

/// The folders that hold runs beside that of the case: on coarser meshes, and of its variations.
const BESIDE: [&str; 2] = [MESHES, VARIATIONS];

/// The folders of runs in such a folder, with their contents.
fn runs_in(folder: &Path) -> Result<Vec<(PathBuf, Contents)>, OutputError> {
    let mut runs = Vec::new();
    if folder.is_symlink() || folder.is_file() {
        return Ok(vec![(folder.to_path_buf(), Contents::Foreign)]);
    }
    if !folder.is_dir() {
        return Ok(runs);
    }
    for entry in fs::read_dir(folder).named("list", folder)? {
        let path = entry.named("list", folder)?.path();
        let contents = if path.is_dir() && !path.is_symlink() { inspect(&path)? } else { Contents::Foreign };
        runs.push((path, contents));
    }
    Ok(runs)
}

/// Removes the runs on coarser meshes and those of variations, and their folders if nothing else is in them; what no run has
/// written stays.
pub(crate) fn clear_beside(dir: &Path) -> Result<(), OutputError> {
    BESIDE.into_iter().try_for_each(|name| clear_runs(&dir.join(name)))
}

fn clear_runs(folder: &Path) -> Result<(), OutputError> {
    for (path, contents) in runs_in(folder)? {
        if let Contents::Run(record) = &contents {
            remove_result(&path, record)?;
        }
        if !contents.is_foreign() {
            remove_file(&path.join(LOCK))?;
            remove_if_empty(&path)?;
        }
    }
    if folder.is_symlink() { Ok(()) } else { remove_if_empty(folder) }
}

/// Clears a folder for a new result; a folder with other files in it is never touched.
pub(crate) fn clear(dir: &Path, force: bool) -> Result<(), OutputError> {
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
pub(crate) fn remove_parts(dir: &Path) -> Result<(), OutputError> {
    for folder in ["", BODIES, FIELDS, PICTURES, PLOTS, CHECKPOINTS] {
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
        remove_file(&dir.join(file))?;
    }
    for (folder, extensions) in [
        (BODIES, &["stl", "obj", "ply", "csv"][..]),
        (FIELDS, &["vtr", "pvtr", "vtp"]),
        (PICTURES, &["png", "svg", "csv", "gif", "apng"]),
        (PLOTS, &["svg"]),
        (CHECKPOINTS, &["checkpoint", "portion"]),
    ] {
        remove_files(&dir.join(folder), extensions)?;
    }
    // Last: as long as it exists, the folder is recognised as a result and the removal can be repeated.
    remove_parts(dir)?;
    remove_file(&dir.join(RUN_RECORD))
}

fn remove_file(path: &Path) -> Result<(), OutputError> {
    if path.is_file() { fs::remove_file(path).named("remove", path) } else { Ok(()) }
}

/// Removes the files with one of these extensions from a folder, and the folder if it is empty then.
fn remove_files(folder: &Path, extensions: &[&str]) -> Result<(), OutputError> {
    if !folder.is_dir() {
        return Ok(());
    }
    let mut is_empty = true;
    for entry in fs::read_dir(folder).named("list", folder)? {
        let path = entry.named("list", folder)?.path();
        if path.extension().is_some_and(|e| extensions.iter().any(|extension| e == *extension)) {
            remove_file(&path)?;
        } else {
            is_empty = false;
        }
    }
    if is_empty { fs::remove_dir(folder).named("remove", folder) } else { Ok(()) }
}

fn remove_if_empty(folder: &Path) -> Result<(), OutputError> {
    // No extension is removed: only an empty folder is.
    remove_files(folder, &[])
}
