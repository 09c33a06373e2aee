//! The names of files and folders inside a results folder.

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
