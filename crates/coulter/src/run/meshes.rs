//! A case on several meshes: the runs on the coarser ones first, whose answers come early, then that on its
//! own.

use super::options::{End, RunError, RunOptions, Start};
use super::part::Part;
use super::start::{begin_study, ended_before, lock};
use super::{run_locked, verdict};
use case::meshes::CoarserMesh;
use case::{Case, require_valid};
use report::{add_mesh_study, mesh_folder, study_lines};
use results::progress;

/// Runs a case on its own mesh and on coarser ones, and writes its results with the study of all of them.
///
/// The case's own results lie in the folder as those of [`super::run`], whose summary and report have the
/// study as well, and those of the coarser meshes below it in `meshes`. With [`Start::Resume`] and
/// [`Start::AutoResume`] runs that have come to their end are left unchanged, and the one that was stopped is
/// resumed. A coarser run that breaks down does not keep the others from running.
///
/// # Errors
/// As [`super::run`]; [`RunError::Physics`] only where the case breaks down on its own mesh.
pub fn run_meshes(case: &Case, coarser: &[CoarserMesh], options: &RunOptions) -> Result<End, RunError> {
    require_valid(case)?;
    for mesh in coarser {
        require_valid(&mesh.case)?;
    }
    let _lock = lock(options)?;
    let names: Vec<String> = coarser.iter().map(|mesh| mesh.name.clone()).collect();
    let is_new = begin_study(case, &names, options)?;
    for (n, mesh) in coarser.iter().enumerate() {
        if let Some(stopped) = run_coarser(mesh, label(n, coarser.len()), options)? {
            return Ok(stopped);
        }
    }
    if !is_new && has_ended(case, options)? {
        let summary = add_mesh_study(options.folder, case, &names)?;
        let lines = [study_lines(&summary), verdict(&summary)].concat();
        progress::tell(&lines.join("\n"), options.quiet);
        return Ok(End::Finished(Box::new(summary)));
    }
    let label = label(coarser.len(), coarser.len());
    let start = if is_new { Start::Replace } else { options.start };
    let part = Part { label, meshes: names, is_beside: false };
    run_locked(case, &RunOptions { start, ..*options }, &part)
}

/// Whether the run on the case's own mesh has come to its end. One that broke down is run again from its last
/// checkpoint if a person asks for that, as without a study.
fn has_ended(case: &Case, options: &RunOptions) -> Result<bool, RunError> {
    match ended_before(case, options.folder) {
        Err(RunError::BrokeDownBefore { .. }) if options.start == Start::Resume => Ok(false),
        other => other.map(|summary| summary.is_some()),
    }
}

fn label(mesh: usize, coarser: usize) -> String {
    format!("mesh {} of {}", mesh + 1, coarser + 1)
}

/// The run on a coarser mesh, unless it has come to its end before; how it was stopped, if it was.
fn run_coarser(mesh: &CoarserMesh, label: String, options: &RunOptions) -> Result<Option<End>, RunError> {
    let folder = mesh_folder(options.folder, &mesh.name)?;
    let own = RunOptions { folder: &folder, typed: &mesh.typed, warnings: &[], ..*options };
    let _lock = lock(&own)?;
    if matches!(options.start, Start::Resume | Start::AutoResume) {
        match ended_before(&mesh.case, &folder) {
            Ok(None) => {}
            Ok(Some(_)) | Err(RunError::BrokeDownBefore { .. }) => return Ok(None),
            Err(other) => return Err(other),
        }
    }
    let part = Part { label, meshes: Vec::new(), is_beside: true };
    match run_locked(&mesh.case, &own, &part) {
        Ok(End::Finished(_)) | Err(RunError::Physics { .. }) => Ok(None),
        Ok(stopped @ End::Stopped(..)) => Ok(Some(stopped)),
        Err(other) => Err(other),
    }
}
