//! `forces.csv`, `part_NAME.csv`, `joint_NAME.csv`, `energy.csv`, `boundaries.csv` and, of a grid that
//! travels, `ground_left.csv`: the histories as tables with units in the header; and `filtered.csv`,
//! `rim.csv`, `rut.csv` and `height_map.csv`, written at the end of a run.
//!
//! The files are kept open during the run and flushed after every block, so that a killed run leaves whole
//! lines; a resumed run rewrites them from the history of the checkpoint.

use super::table::{Table, push_line};
use crate::files::{Inside, Named, OutputError, file_safe, write_whole};
use crate::history::columns::{
    self, Column, FILTERED, FORCES, GROUND_LEFT, HEIGHT_MAP, JOINTS, PARTS, RIM, RUT, Source, header,
};
use crate::history::filter::filtered;
use crate::history::reference::Reference;
use crate::history::rim::RimLine;
use crate::history::{ExchangeBalance, History, RutSection, SurfacePoint};
use std::fs::File;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Name of the file about the energy.
pub(crate) const ENERGY_FILE: &str = "energy.csv";
/// Name of the file about the faces of the box.
pub(crate) const BOUNDARIES_FILE: &str = "boundaries.csv";
/// Name of the file about the ground that the grid has left behind.
pub(crate) const GROUND_LEFT_FILE: &str = "ground_left.csv";

/// Name of the file with the surface of the ground at the end.
pub(crate) const HEIGHT_MAP_FILE: &str = "height_map.csv";

/// Name of the file that holds a body's history: `forces.csv`, or `forces_NAME.csv` when there are several
/// bodies.
#[must_use]
pub fn forces_name(names: &[String], body: usize) -> String {
    name_of("forces", names, body)
}

/// Name of the file that holds the history of a part of a body: `part_NAME.csv`.
#[must_use]
pub fn part_name(name: &str) -> String {
    format!("part_{}.csv", file_safe(name))
}

/// Names of what a run keeps a history of.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct HistoryNames {
    /// The bodies.
    pub bodies: Vec<String>,
    /// The parts of bodies that consist of several.
    pub parts: Vec<String>,
    /// The joints.
    pub joints: Vec<String>,
}

impl HistoryNames {
    /// Names of bodies, parts and joints of a history.
    #[must_use]
    pub fn of(history: &History) -> Self {
        Self {
            bodies: history.names.clone(),
            parts: history.part_names.clone(),
            joints: history.joint_names.clone(),
        }
    }
}

/// Name of the file that holds a joint's history: `joint_NAME.csv`.
#[must_use]
pub fn joint_name(name: &str) -> String {
    format!("joint_{}.csv", file_safe(name))
}

/// Name of the file about the rim of a body: `rim.csv`, or `rim_NAME.csv` when there are several bodies.
#[must_use]
pub fn rim_name(names: &[String], body: usize) -> String {
    name_of("rim", names, body)
}

/// Name of the file of a body's filtered forces: `filtered.csv`, or `filtered_NAME.csv` when there are
/// several bodies.
#[must_use]
pub fn filtered_name(names: &[String], body: usize) -> String {
    name_of("filtered", names, body)
}

fn name_of(kind: &str, names: &[String], body: usize) -> String {
    match names.get(body) {
        Some(name) if names.len() > 1 => format!("{kind}_{}.csv", file_safe(name)),
        _ => format!("{kind}.csv"),
    }
}

/// Writes the forces of the bodies, filtered with a cut-off frequency [Hz].
///
/// # Errors
/// When a file cannot be written.
pub fn write_filtered(
    dir: &Path,
    history: &History,
    references: &[Reference],
    cutoff: f64,
) -> Result<(), OutputError> {
    for (body, (samples, reference)) in history.bodies.iter().zip(references).enumerate() {
        let mut text = format!("{}\n", header(FILTERED));
        push_lines(&mut text, &filtered(samples, cutoff), FILTERED, reference);
        write_whole(&Inside::of(dir, filtered_name(&history.names, body)), text.as_bytes())?;
    }
    Ok(())
}

/// Writes the rims of the bodies, averaged.
///
/// # Errors
/// When a file cannot be written.
pub fn write_rims(dir: &Path, names: &[String], rims: &[Vec<RimLine>]) -> Result<(), OutputError> {
    for (body, lines) in rims.iter().enumerate() {
        let mut text = format!("{}\n", header(RIM));
        push_lines(&mut text, lines, RIM, &Reference::default());
        write_whole(&Inside::of(dir, rim_name(names, body)), text.as_bytes())?;
    }
    Ok(())
}

/// Name of the file about the rut of a body: `rut.csv`, or `rut_NAME.csv` when there are several bodies.
pub(crate) fn rut_name(names: &[String], body: usize) -> String {
    name_of("rut", names, body)
}

/// Writes the ground at the end of a run: its height map, and the rut of every body that has one.
///
/// # Errors
/// When a file cannot be written.
pub fn write_ground(
    dir: &Path,
    names: &[String],
    map: &[SurfacePoint],
    ruts: &[Vec<RutSection>],
) -> Result<(), OutputError> {
    let write = |name: &str, text: &str| write_whole(&Inside::of(dir, name), text.as_bytes());
    let mut text = format!("{}\n", header(HEIGHT_MAP));
    push_lines(&mut text, map, HEIGHT_MAP, &Reference::default());
    write(HEIGHT_MAP_FILE, &text)?;
    for (body, sections) in ruts.iter().enumerate().filter(|(_, sections)| !sections.is_empty()) {
        let mut text = format!("{}\n", header(RUT));
        push_lines(&mut text, sections, RUT, &Reference::default());
        write(&rut_name(names, body), &text)?;
    }
    Ok(())
}

/// Reads the rims of the bodies back; nothing of one whose file does not exist, as of a run that was killed.
///
/// # Errors
/// When a file is broken.
pub fn read_rims(dir: &Path, names: &[String]) -> Result<Vec<Vec<RimLine>>, OutputError> {
    let files = (0..names.len()).map(|body| Inside::of(dir, rim_name(names, body)));
    files.map(|file| if file.exists() { read(&file, RIM, true) } else { Ok(Vec::new()) }).collect()
}

fn push_lines<S: Copy>(text: &mut String, samples: &[S], columns: &[Column<S>], reference: &Reference) {
    for sample in samples {
        let values: Vec<f64> = columns.iter().map(|column| column.value(sample, reference)).collect();
        push_line(text, &values);
    }
}

/// The open history files of a run.
#[derive(Debug)]
pub struct HistoryFiles {
    bodies: Vec<HistoryFile>,
    parts: Vec<HistoryFile>,
    joints: Vec<HistoryFile>,
    energy: HistoryFile,
    boundaries: HistoryFile,
    /// History file of the ground that the grid has left; only of a grid that travels, from its first line
    /// on.
    ground_left: Option<HistoryFile>,
    dir: PathBuf,
    references: Vec<Reference>,
}

#[derive(Debug)]
struct HistoryFile {
    path: PathBuf,
    file: File,
    written: usize,
}

impl HistoryFiles {
    /// Creates the files in `dir`, with the header only.
    ///
    /// # Errors
    /// When a file cannot be written.
    pub fn create(dir: &Path, references: &[Reference], names: &HistoryNames) -> Result<Self, OutputError> {
        let HistoryNames { bodies: names, parts, joints } = names;
        let bodies = (0..names.len())
            .map(|n| HistoryFile::create(Inside::of(dir, forces_name(names, n)), FORCES))
            .collect::<Result<_, _>>()?;
        let parts = parts.iter().map(|name| HistoryFile::create(Inside::of(dir, part_name(name)), PARTS));
        let parts = parts.collect::<Result<_, _>>()?;
        let joints = joints.iter().map(|name| HistoryFile::create(Inside::of(dir, joint_name(name)), JOINTS));
        let joints = joints.collect::<Result<_, _>>()?;
        let energy = HistoryFile::create(Inside::of(dir, ENERGY_FILE), columns::ENERGY)?;
        let boundaries = HistoryFile::create(Inside::of(dir, BOUNDARIES_FILE), columns::BOUNDARIES)?;
        let (dir, references) = (dir.to_path_buf(), references.to_vec());
        Ok(Self { bodies, parts, joints, energy, boundaries, ground_left: None, dir, references })
    }

    /// Writes the files anew with a history that does not go on from what they hold.
    ///
    /// # Errors
    /// As [`HistoryFiles::append`].
    pub fn begin_again(&mut self, history: &History) -> Result<(), OutputError> {
        *self = Self::create(&self.dir, &self.references, &HistoryNames::of(history))?;
        self.append(history)
    }

    /// Adds the lines of `history` that are not in the files yet.
    ///
    /// # Errors
    /// When a file cannot be written.
    pub fn append(&mut self, history: &History) -> Result<(), OutputError> {
        for ((file, samples), reference) in self.bodies.iter_mut().zip(&history.bodies).zip(&self.references)
        {
            file.append(samples, FORCES, reference)?;
        }
        // None of these has columns that need the quantities of a body.
        let none = Reference::default();
        for (file, samples) in self.parts.iter_mut().zip(&history.parts) {
            file.append(samples, PARTS, &none)?;
        }
        for (file, samples) in self.joints.iter_mut().zip(&history.joints) {
            file.append(samples, JOINTS, &none)?;
        }
        self.energy.append(&history.energy, columns::ENERGY, &none)?;
        self.boundaries.append(&history.boundaries, columns::BOUNDARIES, &none)?;
        if self.ground_left.is_none() && !history.ground_left.is_empty() {
            self.ground_left =
                Some(HistoryFile::create(Inside::of(&self.dir, GROUND_LEFT_FILE), GROUND_LEFT)?);
        }
        let file = self.ground_left.as_mut();
        file.map_or(Ok(()), |file| file.append(&history.ground_left, GROUND_LEFT, &none))
    }
}

impl HistoryFile {
    fn create<S: Copy>(at: Inside, columns: &[Column<S>]) -> Result<Self, OutputError> {
        let path = at.path();
        let mut file = at.create().named("create", &path)?;
        writeln!(file, "{}", header(columns)).named("write", &path)?;
        Ok(Self { path, file, written: 0 })
    }

    fn append<S: Copy>(
        &mut self,
        samples: &[S],
        columns: &[Column<S>],
        reference: &Reference,
    ) -> Result<(), OutputError> {
        let mut block = String::new();
        push_lines(&mut block, samples.get(self.written..).unwrap_or_default(), columns, reference);
        // One write for the whole block, so that a kill leaves whole lines.
        self.file.write_all(block.as_bytes()).named("write", &self.path)?;
        self.file.flush().named("write", &self.path)?;
        self.written = self.written.max(samples.len());
        Ok(())
    }
}

/// Reads the samples of a history file back.
fn read<S: Copy + Default>(
    file: &Inside,
    columns: &[Column<S>],
    is_whole: bool,
) -> Result<Vec<S>, OutputError> {
    let table = Table::read_history(file, is_whole)?;
    let mut samples = vec![S::default(); table.rows()];
    for column in columns {
        let Source::Sampled(number) = column.source else { continue };
        let name = column.header();
        let values = table
            .column(&name)
            .ok_or_else(|| OutputError::content(&file.path(), format!("column `{name}` is missing")))?;
        samples.iter_mut().zip(values).for_each(|(sample, value)| *number(sample) = *value);
    }
    Ok(samples)
}

/// Reads all histories of a results folder back. Those of a killed run may end in the middle of a line, and
/// one file may have more lines than another: `is_whole` says that this cannot be.
///
/// # Errors
/// When a file is missing or broken.
pub fn read_history(dir: &Path, names: &HistoryNames, is_whole: bool) -> Result<History, OutputError> {
    let HistoryNames { bodies: names, parts: part_names, joints: joint_names } = names;
    let bodies = (0..names.len())
        .map(|n| read(&Inside::of(dir, forces_name(names, n)), FORCES, is_whole))
        .collect::<Result<_, _>>()?;
    let parts = part_names.iter().map(|name| read(&Inside::of(dir, part_name(name)), PARTS, is_whole));
    let joints = joint_names.iter().map(|name| read(&Inside::of(dir, joint_name(name)), JOINTS, is_whole));
    let left = Inside::of(dir, GROUND_LEFT_FILE);
    let mut history = History {
        part_names: part_names.clone(),
        parts: parts.collect::<Result<_, _>>()?,
        joint_names: joint_names.clone(),
        joints: joints.collect::<Result<_, _>>()?,
        names: names.clone(),
        bodies,
        rims: Vec::new(),
        // The record of the run has them.
        stages: Vec::new(),
        stages_ended: None,
        energy: read(&Inside::of(dir, ENERGY_FILE), columns::ENERGY, is_whole)?,
        boundaries: read(&Inside::of(dir, BOUNDARIES_FILE), columns::BOUNDARIES, is_whole)?,
        // The record of the run has it.
        exchange: ExchangeBalance::default(),
        ground_left: if left.exists() { read(&left, GROUND_LEFT, is_whole)? } else { Vec::new() },
    };
    if !is_whole {
        let others = [history.energy.len(), history.boundaries.len()];
        let forces = history.parts.iter().chain(&history.joints).map(Vec::len);
        let lines = history.bodies.iter().map(Vec::len).chain(forces).chain(others).min().unwrap_or(0);
        history.parts.iter_mut().chain(&mut history.joints).for_each(|samples| samples.truncate(lines));
        history.bodies.iter_mut().for_each(|samples| samples.truncate(lines));
        history.energy.truncate(lines);
        history.boundaries.truncate(lines);
    }
    Ok(history)
}
