//! The mesh study of a results folder: it lies on the case's finest mesh, and the runs on coarser ones in
//! folders below it.
//!
//! Histories are read back from their files, so that a study that is made later is the same to the bit.

use super::report::Summary;
use results::files::{Inside, MESHES, Named, OutputError, make_folder};
use results::folder::{Contents, RunRecord, inspect};
use results::history::History;
use results::history::steady::is_tow;
use results::mesh_study::{MeshResult, MeshRun, MeshStudy, evaluate};
use results::tables::read_history;
use std::path::{Path, PathBuf};

/// Folder of the run on a coarser mesh, which is named by its cell size.
///
/// # Errors
/// When it, or that of all of them, is a link, or the name leads elsewhere.
pub fn mesh_folder(dir: &Path, name: &str) -> Result<PathBuf, OutputError> {
    let folder = Inside::of(dir, MESHES).join(name);
    folder.as_folder().named("use the folder", &folder.path())
}

/// Creates the folder that holds those of the coarser meshes.
///
/// # Errors
/// When it is a link, or cannot be created.
pub fn make_meshes_folder(dir: &Path) -> Result<(), OutputError> {
    make_folder(&Inside::of(dir, MESHES))
}

/// A run on one mesh that has come to its end.
struct Ended {
    result: MeshResult,
    summary: Summary,
    history: History,
}

impl Ended {
    fn read(dir: &Path, name: &str, record: &RunRecord, summary: Summary) -> Result<Self, OutputError> {
        let folder = if name.is_empty() { String::new() } else { format!("{MESHES}/{name}") };
        let result = MeshResult {
            folder,
            cell_m: record.cell,
            width_m: record.cell_width,
            cells: summary.cells,
            steps: summary.steps,
            wall_s: summary.wall_s,
            verdict: summary.trust.verdict,
            ..MeshResult::default()
        };
        Ok(Self { result, history: read_history(dir, &record.names(), true)?, summary })
    }

    /// The run on a coarser mesh; `None` where it has not come to its end.
    fn coarser(dir: &Path, name: &str) -> Result<Option<Self>, OutputError> {
        let folder = mesh_folder(dir, name)?;
        match inspect(&folder)? {
            Contents::Run(record) if record.statistics.outcome.is_end() => {
                Self::read(&folder, name, &record, Summary::read(&folder)?).map(Some)
            }
            _ => Ok(None),
        }
    }
}

/// Gives the summary of a run that has come to its end the study of the meshes that its record names, if
/// there are any and all of them have come to their ends.
pub(super) fn attach(dir: &Path, record: &RunRecord, summary: &mut Summary) -> Result<(), OutputError> {
    summary.remove_mesh_study();
    if record.meshes.is_empty() || !record.statistics.outcome.is_end() {
        return Ok(());
    }
    let mut ended = Vec::new();
    for name in &record.meshes {
        match Ended::coarser(dir, name)? {
            Some(mesh) => ended.push(mesh),
            None => return Ok(()),
        }
    }
    ended.push(Ended::read(dir, "", record, summary.clone())?);
    let runs: Vec<MeshRun> = ended
        .iter()
        .map(|mesh| MeshRun { result: &mesh.result, trust: &mesh.summary.trust, history: &mesh.history })
        .collect();
    let mut study = evaluate(&runs, &record.bodies, record.steady_part());
    study.leave_out_prescribed(&record.setting.bodies);
    let own = runs.last().map_or(&[][..], |run| &run.history.bodies);
    let towed: Vec<&str> = record
        .bodies
        .iter()
        .zip(own)
        .filter(|(reference, samples)| is_tow(samples, reference))
        .map(|(reference, _)| reference.name.as_str())
        .collect();
    let checks = study.checks(&record.setting.bodies, |name| towed.contains(&name));
    summary.set_mesh_study(study, checks);
    Ok(())
}

/// The study as it is read back from a file, in which a number may differ in its last bit.
pub(super) fn as_read_back(study: &MeshStudy) -> Option<MeshStudy> {
    serde_json::from_str(&serde_json::to_string(study).ok()?).ok()
}
