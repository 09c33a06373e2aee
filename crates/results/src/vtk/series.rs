//! The field files of a run over time: soil, free surface and bodies, with a time list of each.

use super::polygons::{write_body, write_surface};
use super::soil::{write_blocks, write_soil};
use super::time_list::{TimedFile, read_time_list, write_time_list};
use crate::domain::PlacedDomain;
use crate::fields::HeightMap;
use crate::files::{FIELDS, Inside, LISTS, OutputError, file_safe, make_folder};
use crate::history::History;
use case::Case;
use solver::grid::Grid;
use solver::halo::Halo;
use solver::precision::Precision;
use solver::state::State;
use std::path::{Path, PathBuf};

/// The field files of a run so far.
#[derive(Debug)]
pub struct FieldSeries {
    dir: PathBuf,
    /// Time lists of soil, free surface and bodies, as in [`LISTS`].
    frames: [Vec<TimedFile>; 3],
    next_frame: usize,
}

impl FieldSeries {
    /// A new series in a results folder.
    ///
    /// # Errors
    /// When its folder cannot be created.
    pub fn create(dir: &Path) -> Result<Self, OutputError> {
        make_folder(&Inside::of(dir, FIELDS))?;
        Ok(Self { dir: dir.to_path_buf(), frames: Default::default(), next_frame: 0 })
    }

    /// Continues a series at `time` [s]; files of later times are dropped from the lists, and written again.
    ///
    /// # Errors
    /// When a list cannot be read.
    pub fn resume(dir: &Path, time: f64) -> Result<Self, OutputError> {
        let mut series = Self::create(dir)?;
        for (list, name) in series.frames.iter_mut().zip(LISTS) {
            *list = read_time_list(&Inside::of(dir, name))?;
        }
        series.go_back(time);
        Ok(series)
    }

    /// Forgets the fields of times after this one [s].
    pub fn go_back(&mut self, time: f64) {
        for frames in &mut self.frames {
            // A checkpoint is taken between steps: field files of exactly its time are valid.
            frames.retain(|frame| frame.time <= time * (1.0 + 1e-12));
        }
        self.next_frame = self.frames[0].len();
    }

    /// Whether fields are due at `time` [s]: the first after every whole multiple of `interval` [s].
    #[must_use]
    pub fn is_due(&self, time: f64, interval: f64) -> bool {
        let Some(last) = self.frames[0].last() else { return true };
        // This depends only on the time of the last fields, so that a resumed run writes the same files.
        let next = ((last.time / interval + 1e-9).floor() + 1.0) * interval;
        time >= next * (1.0 - 1e-12)
    }

    /// Writes the current fields, unless files of exactly this time exist, and updates the time lists. The
    /// free surface includes that which a grid that travels has left behind. Of a grid in blocks each writes
    /// its own soil, and the first all else.
    ///
    /// # Errors
    /// When a file cannot be written.
    pub fn write(
        &mut self,
        case: &Case,
        (grid, halo): (&Grid, &Halo),
        state: &State<impl Precision>,
        history: &History,
    ) -> Result<(), OutputError> {
        let (time, n) = (state.time, self.next_frame);
        if self.frames[0].last().is_some_and(|frame| frame.time == time) {
            return Ok(());
        }
        let extension = if halo.is_alone() { "vtr" } else { "pvtr" };
        let soil = format!("{FIELDS}/soil_{n:04}.{extension}");
        let domain = PlacedDomain::of(grid, state.grid_position);
        let to = Inside::of(&self.dir, &soil);
        if halo.is_alone() {
            write_soil(&to, &domain, state)?;
        } else {
            write_blocks(&to, (&domain, halo), state)?;
        }
        self.frames[0].push(TimedFile { time, part: 0, file: soil });
        self.next_frame += 1;
        // The other blocks keep to the first list alone: it says when fields are due.
        let Some(map) = HeightMap::of(case, (grid, halo), state, &history.ground_left) else { return Ok(()) };
        let surface = format!("{FIELDS}/surface_{n:04}.vtp");
        write_surface(&Inside::of(&self.dir, &surface), &map, time)?;
        self.frames[1].push(TimedFile { time, part: 0, file: surface });
        for (number, described) in case.touching() {
            let body = &state.mechanism.bodies[number];
            let file = format!("{FIELDS}/body_{}_{n:04}.vtp", file_safe(&described.name));
            write_body(&Inside::of(&self.dir, &file), described.solid().as_ref(), body, time)?;
            self.frames[2].push(TimedFile { time, part: number, file });
        }
        for (frames, name) in self.frames.iter().zip(LISTS) {
            if !frames.is_empty() {
                write_time_list(&Inside::of(&self.dir, name), frames)?;
            }
        }
        Ok(())
    }
}
