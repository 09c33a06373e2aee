//! The results folder of a run, and everything that is written into it.

use super::csv::{HistoryFiles, file_safe, read_history};
use super::error::{OutputError, make_folder, read_text, write_whole};
use super::fields::{VOID, write_body, write_soil, write_surface};
use super::folder::{clear, remove_parts};
use super::log::Log;
use super::names::{FIELDS, LISTS, LOG, PICTURES, PLOTS, REPORT, RESOLVED, TYPED};
use super::overlay::Overlay;
use super::picture::write_pictures;
use super::report::{ReportText, write_report};
use super::run_record::{Outcome, RunRecord, RunStatistics};
use super::summary::Summary;
use super::surface::HeightMap;
use super::validate::validate_history;
use super::vtk::{Frame, read_time_list, write_time_list};
use crate::case::{Case, FORMAT};
use crate::history::History;
use solver::grid::Grid;
use solver::precision::Precision;
use solver::state::State;
use std::path::{Path, PathBuf};

/// An open results folder.
#[derive(Debug)]
pub struct Results {
    dir: PathBuf,
    record: RunRecord,
    histories: HistoryFiles,
    log: Log,
    frames: [Vec<Frame>; 3],
    next_frame: usize,
}

impl Results {
    /// Creates the folder of a new run. An existing result is replaced only with `force`, and then only the files that a
    /// run writes are removed; a folder with other files in it is never touched.
    ///
    /// # Errors
    /// When the folder holds something else or cannot be written.
    pub fn create(dir: &Path, case: &Case, force: bool) -> Result<Self, OutputError> {
        clear(dir, force)?;
        make_folder(dir)?;
        // First of all: it identifies the folder, should the run be killed immediately.
        let record = RunRecord::of(case);
        record.write(dir)?;
        make_folder(&dir.join(FIELDS))?;
        let resolved = toml::to_string(case).map_err(|e| OutputError::content(&dir.join(RESOLVED), e))?;
        let header = "# The case as it was understood: SI units, radians, every default filled in. Written by Coulter.\n";
        write_whole(&dir.join(RESOLVED), format!("{header}format = {FORMAT}\n{resolved}").as_bytes())?;
        Ok(Self {
            histories: HistoryFiles::create(dir, &record.bodies)?,
            log: Log::create(&dir.join(LOG))?,
            dir: dir.to_path_buf(),
            record,
            frames: Default::default(),
            next_frame: 0,
        })
    }

    /// Opens the folder of a run that is resumed from a checkpoint taken at `time` [s] with the history so far: rewrites
    /// the history files and drops the field files of later times.
    ///
    /// # Errors
    /// When there is no result in the folder or it cannot be written.
    pub fn resume(dir: &Path, case: &Case, history: &History, time: f64) -> Result<Self, OutputError> {
        let before = RunRecord::read(dir)?;
        remove_parts(dir)?;
        let statistics = RunStatistics { outcome: Outcome::Running, ..before.statistics };
        let record = RunRecord { overlays: before.overlays, statistics, ..RunRecord::of(case) };
        let mut frames: [Vec<Frame>; 3] = Default::default();
        for (list, name) in frames.iter_mut().zip(LISTS) {
            *list = read_time_list(&dir.join(name))?;
            // A checkpoint is taken between steps: field files of exactly its time are valid.
            list.retain(|frame| frame.time <= time * (1.0 + 1e-12));
        }
        let mut results = Self {
            histories: HistoryFiles::create(dir, &record.bodies)?,
            log: Log::append(&dir.join(LOG))?,
            dir: dir.to_path_buf(),
            record,
            next_frame: frames[0].len(),
            frames,
        };
        make_folder(&dir.join(FIELDS))?;
        results.append(history)?;
        results.record.write(dir)?;
        Ok(results)
    }

    /// The folder.
    #[must_use]
    pub fn dir(&self) -> &Path {
        &self.dir
    }

    /// Stores the case file with the results, as typed.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn write_case_file(&self, text: &str) -> Result<(), OutputError> {
        write_whole(&self.dir.join(TYPED), text.as_bytes())
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

    /// Writes a line with a time stamp into `run.log`.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn log(&mut self, line: &str) -> Result<(), OutputError> {
        self.log.line(line)
    }

    /// Adds the lines of the history that are not in the files yet.
    ///
    /// # Errors
    /// When a file cannot be written.
    pub fn append(&mut self, history: &History) -> Result<(), OutputError> {
        self.histories.append(history)
    }

    /// Updates the statistics in `run.json`.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn write_statistics(&mut self, statistics: &RunStatistics) -> Result<(), OutputError> {
        self.record.statistics = statistics.clone();
        self.record.write(&self.dir)
    }

    /// Whether fields are due at `time` [s]: the first after every whole multiple of `interval` [s].
    #[must_use]
    pub fn fields_are_due(&self, time: f64, interval: f64) -> bool {
        let Some(last) = self.frames[0].last() else { return true };
        // This depends only on the time of the last fields, so that a resumed run writes the same files.
        let next = ((last.time / interval + 1e-9).floor() + 1.0) * interval;
        time >= next * (1.0 - 1e-12)
    }

    /// Writes the current fields, unless files of exactly this time exist, and updates the time lists.
    ///
    /// # Errors
    /// When a file cannot be written.
    pub fn write_fields(
        &mut self,
        case: &Case,
        grid: &Grid,
        state: &State<impl Precision>,
    ) -> Result<(), OutputError> {
        let (time, n) = (state.time, self.next_frame);
        if self.frames[0].last().is_some_and(|frame| frame.time == time) {
            return Ok(());
        }
        let soil = format!("{FIELDS}/soil_{n:04}.vtr");
        write_soil(&self.dir.join(&soil), grid, state)?;
        self.frames[0].push(Frame { time, part: 0, file: soil });
        let surface = format!("{FIELDS}/surface_{n:04}.vtp");
        write_surface(&self.dir.join(&surface), &HeightMap::of(case, grid, state), time)?;
        self.frames[1].push(Frame { time, part: 0, file: surface });
        for (number, (body, described)) in state.mechanism.bodies.iter().zip(&case.bodies).enumerate() {
            let file = format!("{FIELDS}/body_{}_{n:04}.vtp", file_safe(&described.name));
            write_body(&self.dir.join(&file), described.shape.solid().as_ref(), body, time)?;
            self.frames[2].push(Frame { time, part: number, file });
        }
        self.next_frame += 1;
        for (frames, name) in self.frames.iter().zip(LISTS) {
            if !frames.is_empty() {
                write_time_list(&self.dir.join(name), frames)?;
            }
        }
        Ok(())
    }

    /// Writes the last fields, the summary, the pictures and the report at the end of a run, also of one that broke down or
    /// was stopped, as the statistics say. A stopped run leaves no fields of the time at which it was stopped.
    ///
    /// # Errors
    /// When a file cannot be written.
    pub fn finish(
        &mut self,
        case: &Case,
        grid: &Grid,
        state: &State<impl Precision>,
        history: &History,
        statistics: &RunStatistics,
    ) -> Result<Summary, OutputError> {
        self.append(history)?;
        if statistics.outcome != Outcome::Interrupted {
            self.write_fields(case, grid, state)?;
        }
        self.record.statistics = statistics.clone();
        let mut summary = Summary {
            filled_cells: filled_cells(grid, state),
            surface: HeightMap::of(case, grid, state).figures(),
            ..Summary::of(&self.record)
        };
        summary.fill(history, &self.record);
        summary.write(&self.dir)?;
        write_pictures(&self.dir.join(PICTURES), case, grid, state)?;
        report(&self.dir, &self.record, &summary, history)?;
        // Last: until it says how the run ended, a resumed run repeats all this.
        self.record.write(&self.dir)?;
        Ok(summary)
    }
}

/// Rebuilds `report.html` from the other files of a results folder; for a killed run from those that exist.
///
/// # Errors
/// When the folder holds no result, or a file is broken.
pub fn rebuild_report(dir: &Path) -> Result<PathBuf, OutputError> {
    let record = RunRecord::read(dir)?;
    let names: Vec<String> = record.bodies.iter().map(|b| b.name.clone()).collect();
    let is_whole = matches!(record.statistics.outcome, Outcome::Finished | Outcome::BrokeDown(_));
    let history = read_history(dir, &names, is_whole)?;
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
    report(dir, &record, &summary, &history)?;
    Ok(dir.join(REPORT))
}

fn report(dir: &Path, record: &RunRecord, summary: &Summary, history: &History) -> Result<(), OutputError> {
    let optional = |name: &str| {
        let path = dir.join(name);
        if path.is_file() { read_text(&path).map(Some) } else { Ok(None) }
    };
    let text = ReportText { resolved: optional(RESOLVED)?, typed: optional(TYPED)? };
    make_folder(&dir.join(PLOTS))?;
    write_report(dir, record, summary, history, &text)
}

fn filled_cells(grid: &Grid, state: &State<impl Precision>) -> u64 {
    let [columns, rows, layers] = grid.cells();
    let mut filled = 0;
    for (k, j) in (0..layers).flat_map(|k| (0..rows).map(move |j| (k, j))) {
        let start = grid.index(0, j, k);
        filled +=
            state.soil.fraction[start..start + columns].iter().filter(|f| (**f).into() > VOID).count() as u64;
    }
    filled
}
