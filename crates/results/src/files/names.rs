//! The names of files and folders inside a results folder.

/// Folder of checkpoints inside a results folder.
pub const CHECKPOINTS: &str = "checkpoints";
/// Folder of the files that bodies were read from.
pub const BODIES: &str = "bodies";
/// Folder of the field files.
pub const FIELDS: &str = "fields";
/// Folder of the pictures.
pub const PICTURES: &str = "pictures";
/// Folder of the plots.
pub const PLOTS: &str = "plots";
/// The case as it was understood.
pub const RESOLVED: &str = "resolved.toml";
/// The case as it was typed.
pub const TYPED: &str = "case.toml";
/// The page of the run.
pub const REPORT: &str = "report.html";
/// The log: what happened when.
pub const LOG: &str = "run.log";
/// Lists of the field files by time.
pub const LISTS: [&str; 3] = ["soil.pvd", "surface.pvd", "body.pvd"];
/// Folder of the runs of variations of the case.
pub const VARIATIONS: &str = "variations";
/// The figures of the run.
pub const SUMMARY: &str = "summary.json";

/// A body's name in a form that is safe in file names.
#[must_use]
pub fn file_safe(name: &str) -> String {
    name.chars().map(|c| if c.is_alphanumeric() || "-_".contains(c) { c } else { '_' }).collect()
}
