//! The results folder of a run, and everything that is written into it.

use super::confidence;
use super::pictures::{Shown, write_pictures};
use super::report::{ReportText, ReportWishes, Summary, rims, write_report};
use case::resolved::MotionTable;
use case::{Case, FORMAT, with_files};
use input::mesh_file::hash_of;
use results::confidence::{Confidence, VariationResult};
use results::fields::{Rut, ruts};
use results::files::{
    BODIES, Inside, Named, OutputError, PICTURES, PLOTS, REPORT, RESOLVED, TYPED, make_folder, read_text,
    write_copy, write_whole,
};
use results::folder::{Log, Outcome, RunRecord, RunStatistics, clear, clear_beside, remove_parts};
use results::history::rim::RimLine;
use results::history::{History, RutSection};
use results::overlay::Overlay;
use results::tables::{HistoryFiles, read_rims, validate_history, write_filtered, write_ground, write_rims};
use solver::precision::Precision;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// An open results folder.
#[derive(Debug)]
pub struct Results {
    dir: PathBuf,
    /// The histories.
    pub tables: HistoryFiles,
    /// The log: what happened when.
    pub log: Log,
    /// The record of the run: what identifies the folder, and how far the run is.
    pub record: RunRecord,
}

impl Results {
    /// Creates the folder of a new run. An existing result is replaced only with `force`, and then only the
    /// files that a run writes are removed; a folder with other files in it is never touched.
    ///
    /// # Errors
    /// When the folder holds something else or cannot be written.
    pub fn create(dir: &Path, case: &Case, force: bool) -> Result<Self, OutputError> {
        clear(dir, force)?;
        make_folder(&Inside::of(dir, ""))?;
        // First of all: it identifies the folder, should the run be killed immediately.
        let record = RunRecord::of(case);
        record.write(dir)?;
        let resolved = toml::to_string(case).map_err(|e| OutputError::content(&dir.join(RESOLVED), e))?;
        let header = "# The case as it was understood: SI units, radians, every default filled in. Written by Coulter.\n";
        write_whole(&Inside::of(dir, RESOLVED), format!("{header}format = {FORMAT}\n{resolved}").as_bytes())?;
        Ok(Self {
            tables: HistoryFiles::create(dir, &record.bodies, &record.names())?,
            log: Log::create(dir)?,
            dir: dir.to_path_buf(),
            record,
        })
    }

    /// Opens the folder of a run that is resumed from a checkpoint with the history so far: rewrites the
    /// history files.
    ///
    /// # Errors
    /// When there is no result in the folder or it cannot be written.
    pub fn resume(dir: &Path, case: &Case, history: &History) -> Result<Self, OutputError> {
        let before = RunRecord::read(dir)?;
        remove_parts(dir)?;
        let statistics = RunStatistics { outcome: Outcome::Running, ..before.statistics };
        let record = RunRecord { overlays: before.overlays, statistics, ..RunRecord::of(case) };
        let mut results = Self {
            tables: HistoryFiles::create(dir, &record.bodies, &record.names())?,
            log: Log::append(dir)?,
            dir: dir.to_path_buf(),
            record,
        };
        results.tables.append(history)?;
        results.record.write(dir)?;
        Ok(results)
    }

    /// The folder.
    #[must_use]
    pub fn dir(&self) -> &Path {
        &self.dir
    }

    /// Overlays curves on the plots of the report: a forecast, a measurement.
    ///
    /// # Errors
    /// When `run.json` cannot be written.
    pub fn overlay(&mut self, mut overlays: Vec<Overlay>) -> Result<(), OutputError> {
        for overlay in &mut overlays {
            overlay.points.retain(|p| p.iter().all(|v| v.is_finite()));
        }
        self.record.overlays = overlays;
        self.record.write(&self.dir)
    }

    /// Writes the summary, the pictures and the report at the end of a run, also of one that broke down or
    /// was stopped, as the statistics say.
    ///
    /// # Errors
    /// When a file cannot be written.
    pub fn finish<R: Precision>(
        &mut self,
        case: &Case,
        shown: &Shown<R>,
        history: &History,
        statistics: &RunStatistics,
    ) -> Result<Summary, OutputError> {
        self.tables.append(history)?;
        let Shown { grid, state, map, filled_cells } = shown;
        let ruts = ruts(case, map, state, &history.bodies);
        let taken_out =
            history.bodies.iter().filter_map(|samples| samples.first()).map(|s| s.embedded_volume).sum();
        self.record.statistics = statistics.clone();
        let mut summary = Summary {
            filled_cells: *filled_cells,
            surface: map.figures(taken_out),
            ruts: means(&history.names, &ruts),
            ..Summary::of(&self.record)
        };
        summary.fill(history, &self.record);
        summary.write(&self.dir)?;
        write_pictures(&Inside::of(&self.dir, PICTURES), case, grid, state, map)?;
        let sections: Vec<_> = ruts.into_iter().map(|rut| rut.sections).collect();
        write_ground(&self.dir, &history.names, &map.points(), &sections)?;
        let rims: Vec<_> = rims(history, &self.record)
            .into_iter()
            .map(|rim| rim.map_or(Vec::new(), |rim| rim.lines))
            .collect();
        write_rims(&self.dir, &history.names, &rims)?;
        write_filtered(&self.dir, history, &self.record.bodies, self.record.filter_cutoff)?;
        // As written, so that a report that is rebuilt from the files is the same to the last digit.
        let written = (&self.record.history(&self.dir, true)?, &*read_rims(&self.dir, &history.names)?);
        report(&self.dir, &self.record, &summary, written, ReportWishes::default())?;
        // Last: until it says how the run ended, a resumed run repeats all this.
        self.record.write(&self.dir)?;
        Ok(summary)
    }
}

/// What bodies have left behind, by name; nothing of one that has not gone far enough.
fn means(names: &[String], ruts: &[Rut]) -> BTreeMap<String, RutSection> {
    names.iter().zip(ruts).filter_map(|(name, rut)| Some((name.clone(), rut.mean?))).collect()
}

/// Copies the files of tables that motions follow; returns the keys that lead to each, and its copy, relative
/// to the folder.
fn copy_tables(dir: &Path, case: &Case) -> Result<Vec<(Vec<String>, String)>, OutputError> {
    let mut copies = Vec::new();
    for MotionTable { keys, path } in &case.tables {
        make_folder(&Inside::of(dir, BODIES))?;
        let copy = format!("{BODIES}/{}.csv", keys.join("_"));
        write_copy(&Inside::of(dir, &copy), path)?;
        copies.push((keys.iter().cloned().chain(["table".to_owned()]).collect(), copy));
    }
    Ok(copies)
}

/// Stores a case file in a folder, as typed, and the files that it names: in the copy it names the copies.
///
/// # Errors
/// When a file cannot be written, or is not that which the case was read from any more.
pub fn write_case_file(dir: &Path, case: &Case, text: &str) -> Result<(), OutputError> {
    let mut copies = copy_meshes(dir, case)?;
    copies.extend(copy_tables(dir, case)?);
    copies.extend(copy_height_map(dir, case)?);
    write_whole(&Inside::of(dir, TYPED), with_files(text, &copies).as_bytes())
}

/// Copies the files that bodies and soil bodies were read from; returns the keys that lead to each, and its
/// copy, relative to the folder.
fn copy_meshes(dir: &Path, case: &Case) -> Result<Vec<(Vec<String>, String)>, OutputError> {
    let mut copies = Vec::new();
    let bodies = case.bodies.iter().map(|body| ("body", &body.name, &body.shape));
    let of_soil = case.soil_bodies.iter().map(|body| ("soil_body", &body.name, &body.shape));
    for (kind, name, shape) in bodies.chain(of_soil) {
        let Some(mesh) = shape.mesh() else { continue };
        let file = if kind == "body" { name.clone() } else { format!("{kind}.{name}") };
        let copy = copy_of(dir, mesh.path(), (&file, &mesh.hash))?;
        copies.push(([kind, name, "file"].map(str::to_owned).into(), copy));
    }
    Ok(copies)
}

/// Copies the file of a height map; returns the keys that lead to it, and its copy, relative to the folder.
fn copy_height_map(dir: &Path, case: &Case) -> Result<Option<(Vec<String>, String)>, OutputError> {
    let Some(map) = &case.relief.map else { return Ok(None) };
    let copy = copy_of(dir, map.path(), (HEIGHT_MAP, map.file_hash()))?;
    Ok(Some(([HEIGHT_MAP, "file"].map(str::to_owned).into(), copy)))
}

/// Section of a height map, and name of the copy of its file.
const HEIGHT_MAP: &str = "height_map";

/// Copies a file, whose content had this hash as the case was read, under this name into the folder of the
/// bodies; returns its place.
fn copy_of(dir: &Path, from: &Path, (name, hash): (&str, &str)) -> Result<String, OutputError> {
    let extension = from.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default();
    let copy = format!("{BODIES}/{name}.{extension}");
    make_folder(&Inside::of(dir, BODIES))?;
    let to = Inside::of(dir, &copy);
    write_copy(&to, from)?;
    if hash_of(&to.path()).named("read", &to.path())? != hash {
        return Err(OutputError::content(from, "the file has changed since the case was read; start again"));
    }
    Ok(copy)
}

/// Removes a whole result, runs of variations included; a folder with other files in it is never touched.
pub fn clear_all(dir: &Path) -> Result<(), OutputError> {
    clear_beside(dir)?;
    clear(dir, true)
}

/// Refuses a folder that holds a result or anything else.
pub fn require_nothing(dir: &Path) -> Result<(), OutputError> {
    clear(dir, false)
}

/// Gives a run that has finished the intervals that follow from these variations, in the summary, the report
/// and the log, unless it has them already. `confidence` says what was allowed and spent.
///
/// # Errors
/// When the folder holds no such result, or a file cannot be read or written.
pub fn add_confidence(
    dir: &Path,
    confidence: Confidence,
    variations: &[VariationResult],
) -> Result<Summary, OutputError> {
    let record = RunRecord::read(dir)?;
    let mut summary = Summary::read(dir)?;
    let known = summary.clone();
    confidence::attach(dir, &record, &mut summary, (confidence, variations))?;
    if known.confidence.is_some() && known.confidence == confidence::as_read_back(&summary) {
        return Ok(known);
    }
    Log::append(dir)?.line(&format!("intervals from {} variations", variations.len()))?;
    summary.write(dir)?;
    rebuild_report(dir)?;
    Ok(summary)
}

/// Rebuilds `report.html` from the other files of a results folder; for a killed run from those that exist.
///
/// # Errors
/// When the folder holds no result, or a file is broken.
pub fn rebuild_report(dir: &Path) -> Result<PathBuf, OutputError> {
    rebuild_report_with(dir, ReportWishes::default())
}

/// Builds the report anew as [`rebuild_report`] does, with what this report alone shows.
///
/// # Errors
/// As [`rebuild_report`].
pub fn rebuild_report_with(dir: &Path, wishes: ReportWishes) -> Result<PathBuf, OutputError> {
    let record = RunRecord::read(dir)?;
    let names = record.names();
    let is_whole = record.statistics.outcome.is_end();
    let history = record.history(dir, is_whole)?;
    if record.statistics.outcome == Outcome::Finished {
        validate_history(&history).map_err(|problem| OutputError::content(dir, problem))?;
    }
    let summary = if is_whole {
        Summary::read(dir)?
    } else {
        let mut summary = Summary::of(&record);
        summary.fill(&history, &record);
        summary
    };
    report(dir, &record, &summary, (&history, &read_rims(dir, &names.bodies)?), wishes)?;
    Ok(dir.join(REPORT))
}

fn report(
    dir: &Path,
    record: &RunRecord,
    summary: &Summary,
    (history, rims): (&History, &[Vec<RimLine>]),
    wishes: ReportWishes,
) -> Result<(), OutputError> {
    let optional = |name: &str| {
        let file = Inside::of(dir, name);
        if file.exists() { read_text(&file).map(Some) } else { Ok(None) }
    };
    let text = ReportText { resolved: optional(RESOLVED)?, typed: optional(TYPED)?, wishes };
    make_folder(&Inside::of(dir, PLOTS))?;
    write_report(dir, record, summary, (history, rims), &text)
}
