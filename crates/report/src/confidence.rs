//! The intervals of a results folder: the runs of the variations lie in folders below it.
//!
//! Histories are read back from their files, so that intervals that are made later are the same to the bit.

use super::report::Summary;
use results::confidence::variations::ErrorSource;
use results::confidence::{Confidence, Status, VariationResult, VariedRun, evaluate};
use results::files::{Inside, Named, OutputError, VARIATIONS, make_folder};
use results::folder::{Contents, RunRecord, inspect};
use results::history::History;
use results::trust::Verdict;
use std::path::{Path, PathBuf};

/// Folder of the run of a variation.
///
/// # Errors
/// When it, or that of all of them, is a link.
pub fn variation_folder(dir: &Path, name: &str) -> Result<PathBuf, OutputError> {
    let folder = Inside::of(dir, VARIATIONS).join(name);
    folder.as_folder().named("use the folder", &folder.path())
}

/// Creates the folder that holds those of the variations.
pub fn make_variations_folder(dir: &Path) -> Result<(), OutputError> {
    make_folder(&Inside::of(dir, VARIATIONS))
}

/// The wall-clock time [s] and the summary of a variation's run that has finished.
pub fn finished(dir: &Path, name: &str) -> Result<Option<(f64, Summary)>, OutputError> {
    let folder = variation_folder(dir, name)?;
    match inspect(&folder)? {
        Contents::Run(record) if record.statistics.outcome.is_end() => {
            Ok(Some((record.statistics.wall_seconds, Summary::read(&folder)?)))
        }
        _ => Ok(None),
    }
}

/// Gives a summary the intervals that follow from variations. Those that count as examined, but whose run is
/// broken, are told to be so.
pub(super) fn attach(
    dir: &Path,
    record: &RunRecord,
    summary: &mut Summary,
    (confidence, variations): (Confidence, &[VariationResult]),
) -> Result<(), OutputError> {
    let verdict = summary.trust.verdict_without_confidence();
    summary.set_confidence(intervals(dir, (dir, record, verdict), confidence, variations)?);
    Ok(())
}

/// The intervals of a run in a folder of its own, with this verdict, from variations whose runs lie below
/// `dir`.
fn intervals(
    dir: &Path,
    (own, record, verdict): (&Path, &RunRecord, Verdict),
    confidence: Confidence,
    variations: &[VariationResult],
) -> Result<Confidence, OutputError> {
    let mut results = variations.to_vec();
    let mut histories: Vec<Option<History>> = Vec::new();
    for result in &mut results {
        histories.push(read(dir, result)?);
    }
    let runs: Vec<VariedRun> = results
        .iter()
        .zip(&histories)
        .map(|(result, history)| VariedRun { result, history: history.as_ref() })
        .collect();
    let history = record.history(own, true)?;
    let confidence = Confidence { width_m: record.cell_width, ..confidence };
    let bodies = (&record.bodies[..], &record.setting.bodies[..]);
    Ok(evaluate(confidence, (&history, verdict), &runs, bodies, record.steady_part()))
}

/// The intervals of the finest mesh among variations whose runs lie below a folder; `None` where none can be
/// used.
///
/// # Errors
/// When a file cannot be read.
pub fn explored(dir: &Path, results: &[VariationResult]) -> Result<Option<Confidence>, OutputError> {
    let mut finest: Option<(usize, RunRecord)> = None;
    for (n, mesh) in results.iter().enumerate() {
        if mesh.source != ErrorSource::Mesh {
            continue;
        }
        let folder = variation_folder(dir, &mesh.name)?;
        let record = RunRecord::read(&folder)?;
        let is_finer = finest.as_ref().is_none_or(|(_, other)| record.cell_width < other.cell_width);
        if is_finer && Summary::read(&folder)?.trust.verdict != Verdict::Broken {
            finest = Some((n, record));
        }
    }
    let Some((n, record)) = finest else { return Ok(None) };
    let own = variation_folder(dir, &results[n].name)?;
    let others: Vec<VariationResult> =
        results.iter().enumerate().filter(|(other, _)| *other != n).map(|(_, mesh)| mesh.clone()).collect();
    let verdict = Summary::read(&own)?.trust.verdict;
    intervals(dir, (&own, &record, verdict), Confidence::default(), &others).map(Some)
}

/// Hash of the case whose run a folder holds; `None` where it holds none.
///
/// # Errors
/// When it holds something else.
pub fn run_of(dir: &Path) -> Result<Option<String>, OutputError> {
    match inspect(dir)? {
        Contents::Run(record) => Ok(Some(record.case_hash)),
        Contents::Nothing => Ok(None),
        Contents::Foreign => Err(OutputError::Foreign { path: dir.to_path_buf() }),
    }
}

/// The history of a variation that was examined; what is known of its run is filled in.
fn read(dir: &Path, result: &mut VariationResult) -> Result<Option<History>, OutputError> {
    if result.status != Status::Examined {
        return Ok(None);
    }
    let folder = variation_folder(dir, &result.name)?;
    let record = RunRecord::read(&folder)?;
    let summary = Summary::read(&folder)?;
    result.folder = format!("{VARIATIONS}/{}", result.name);
    result.width_m = record.cell_width;
    result.wall_s = Some(record.statistics.wall_seconds);
    result.verdict = Some(summary.trust.verdict);
    if summary.trust.verdict == Verdict::Broken {
        let check = summary.trust.checks.iter().find(|check| check.verdict == Verdict::Broken);
        result.status = Status::Broken;
        result.because = Some(check.map_or_else(|| "its run is broken".to_owned(), |check| check.line()));
        return Ok(None);
    }
    record.history(&folder, true).map(Some)
}

/// The intervals as they are read back from a file, in which a number may differ in its last bit.
pub(super) fn as_read_back(summary: &Summary) -> Option<Confidence> {
    serde_json::from_str(&serde_json::to_string(summary.confidence.as_ref()?).ok()?).ok()
}
