//! The names of files and folders inside a results folder.

/// Folder of checkpoints inside a results folder.
pub(crate) const CHECKPOINTS: &str = "checkpoints";
/// Folder of the files that bodies were read from.
pub(crate) const BODIES: &str = "bodies";
pub(crate) const FIELDS: &str = "fields";
/// Folder of the runs on coarser meshes.
pub(crate) const MESHES: &str = "meshes";
pub(crate) const PICTURES: &str = "pictures";
pub(crate) const PLOTS: &str = "plots";
pub(crate) const RESOLVED: &str = "resolved.toml";
pub(crate) const TYPED: &str = "case.toml";
pub(crate) const REPORT: &str = "report.html";
pub(crate) const LOG: &str = "run.log";
pub(crate) const LISTS: [&str; 3] = ["soil.pvd", "surface.pvd", "body.pvd"];
/// Folder of the runs of variations of the case.
pub(crate) const VARIATIONS: &str = "variations";
pub(crate) const SUMMARY: &str = "summary.json";

/// A body's name in a form that is safe in file names.
pub(crate) fn file_safe(name: &str) -> String {
    name.chars().map(|c| if c.is_alphanumeric() || "-_".contains(c) { c } else { '_' }).collect()
}
