//! `forces.csv`, `energy.csv` and `boundaries.csv`: the histories as tables with units in the header.
//!
//! The files are kept open during the run and flushed after every block, so that a killed run leaves whole lines; a
//! resumed run rewrites them from the history of the checkpoint.

use super::error::{Named, OutputError};
use super::table::{Table, push_line};
use crate::history::reference::Reference;
use crate::history::{BodySample, BoundarySample, EnergySample, History};
use std::fs::File;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Header of a body's file.
pub const FORCES_HEADER: &str = "time [s],displacement u [m],sinkage z [m],drag F_H [N],vertical F_V [N],\
lateral [N],axle torque [N m],rotation [rad],spin [rad/s],turn ratio [-],normal drag [N],friction drag [N],\
normal vertical [N],friction vertical [N],leak [m^3],embedded [m^3],speed v [m/s],heave speed [m/s],Z [-],u_bar [-],\
F_H_bar [-],F_V_bar [-]";

/// Header of the energy balance's file.
pub const ENERGY_HEADER: &str = "time [s],external [J],kinetic [J],elastic [J],plastic [J],friction [J],contact method [J],viscous [J],\
hourglass [J],remap loss [J],closure [-],volume ratio [-]";

/// Header of the file about the faces of the box.
pub const BOUNDARIES_HEADER: &str =
    "time [s],lid area [m^2],lid force [N],bare wall area [m^2],stress rise [Pa]";

/// Name of the file about the energy.
pub(super) const ENERGY: &str = "energy.csv";
/// Name of the file about the faces of the box.
pub(super) const BOUNDARIES: &str = "boundaries.csv";

/// Name of the file that holds a body's history: `forces.csv`, or `forces_NAME.csv` when there are several bodies.
#[must_use]
pub fn forces_name(names: &[String], body: usize) -> String {
    match names.get(body) {
        Some(name) if names.len() > 1 => format!("forces_{}.csv", file_safe(name)),
        _ => "forces.csv".to_owned(),
    }
}

/// A body's name in a form that is safe in file names.
pub(super) fn file_safe(name: &str) -> String {
    name.chars().map(|c| if c.is_alphanumeric() || "-_".contains(c) { c } else { '_' }).collect()
}

/// The open history files of a run.
#[derive(Debug)]
pub struct HistoryFiles {
    bodies: Vec<HistoryFile>,
    energy: HistoryFile,
    boundaries: HistoryFile,
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
    pub fn create(dir: &Path, references: &[Reference]) -> Result<Self, OutputError> {
        let names: Vec<String> = references.iter().map(|r| r.name.clone()).collect();
        let bodies = (0..names.len())
            .map(|n| HistoryFile::create(dir.join(forces_name(&names, n)), FORCES_HEADER))
            .collect::<Result<_, _>>()?;
        let energy = HistoryFile::create(dir.join(ENERGY), ENERGY_HEADER)?;
        let boundaries = HistoryFile::create(dir.join(BOUNDARIES), BOUNDARIES_HEADER)?;
        Ok(Self { bodies, energy, boundaries, references: references.to_vec() })
    }

    /// Adds the lines of `history` that are not in the files yet.
    ///
    /// # Errors
    /// When a file cannot be written.
    pub fn append(&mut self, history: &History) -> Result<(), OutputError> {
        for ((file, samples), reference) in self.bodies.iter_mut().zip(&history.bodies).zip(&self.references)
        {
            file.append(samples, |sample| forces_line(sample, reference).to_vec())?;
        }
        self.energy.append(&history.energy, |sample| energy_line(sample).to_vec())?;
        self.boundaries.append(&history.boundaries, |sample| boundary_line(sample).to_vec())
    }
}

impl HistoryFile {
    fn create(path: PathBuf, header: &str) -> Result<Self, OutputError> {
        let mut file = File::create(&path).named("create", &path)?;
        writeln!(file, "{header}").named("write", &path)?;
        Ok(Self { path, file, written: 0 })
    }

    fn append<S>(&mut self, samples: &[S], line: impl Fn(&S) -> Vec<f64>) -> Result<(), OutputError> {
        let mut block = String::new();
        for sample in samples.iter().skip(self.written) {
            push_line(&mut block, &line(sample));
        }
        // One write for the whole block, so that a kill leaves whole lines.
        self.file.write_all(block.as_bytes()).named("write", &self.path)?;
        self.file.flush().named("write", &self.path)?;
        self.written = self.written.max(samples.len());
        Ok(())
    }
}

fn forces_line(s: &BodySample, reference: &Reference) -> [f64; 22] {
    let none = f64::NAN;
    [
        s.time,
        s.displacement,
        s.sinkage,
        s.drag,
        s.vertical,
        s.lateral,
        s.axle_torque,
        s.rotation,
        s.spin,
        reference.turn_ratio_of(s).unwrap_or(none),
        s.drag_normal,
        s.drag - s.drag_normal,
        s.vertical_normal,
        s.vertical - s.vertical_normal,
        s.leaked_volume,
        s.embedded_volume,
        s.speed,
        s.heave_speed,
        reference.length_group(s.sinkage).unwrap_or(none),
        reference.length_group(s.displacement).unwrap_or(none),
        reference.force_group(s.drag).unwrap_or(none),
        reference.force_group(s.vertical).unwrap_or(none),
    ]
}

fn energy_line(s: &EnergySample) -> [f64; 12] {
    [
        s.time,
        s.external,
        s.kinetic,
        s.elastic,
        s.plastic,
        s.friction,
        s.contact,
        s.viscous,
        s.hourglass,
        s.remap_loss,
        s.closure(),
        s.volume_ratio,
    ]
}

fn boundary_line(s: &BoundarySample) -> [f64; 5] {
    [s.time, s.lid_area, s.lid_force, s.wall_area, s.stress_rise]
}

/// Reads a body's file back.
///
/// # Errors
/// When the file cannot be read or a column is missing.
pub fn read_forces(path: &Path, is_whole: bool) -> Result<Vec<BodySample>, OutputError> {
    let table = Table::read_history(path, is_whole)?;
    let cell = cells(&table, path);
    let line = |n: usize| -> Result<BodySample, OutputError> {
        Ok(BodySample {
            time: cell("time [s]", n)?,
            displacement: cell("displacement u [m]", n)?,
            sinkage: cell("sinkage z [m]", n)?,
            drag: cell("drag F_H [N]", n)?,
            vertical: cell("vertical F_V [N]", n)?,
            lateral: cell("lateral [N]", n)?,
            axle_torque: cell("axle torque [N m]", n)?,
            rotation: cell("rotation [rad]", n)?,
            spin: cell("spin [rad/s]", n)?,
            drag_normal: cell("normal drag [N]", n)?,
            vertical_normal: cell("normal vertical [N]", n)?,
            leaked_volume: cell("leak [m^3]", n)?,
            embedded_volume: cell("embedded [m^3]", n)?,
            speed: cell("speed v [m/s]", n)?,
            heave_speed: cell("heave speed [m/s]", n)?,
        })
    };
    (0..table.rows()).map(line).collect()
}

/// Reads the energy balance back.
///
/// # Errors
/// When the file cannot be read or a column is missing.
pub fn read_energy(path: &Path, is_whole: bool) -> Result<Vec<EnergySample>, OutputError> {
    let table = Table::read_history(path, is_whole)?;
    let cell = cells(&table, path);
    let line = |n: usize| -> Result<EnergySample, OutputError> {
        Ok(EnergySample {
            time: cell("time [s]", n)?,
            external: cell("external [J]", n)?,
            kinetic: cell("kinetic [J]", n)?,
            elastic: cell("elastic [J]", n)?,
            plastic: cell("plastic [J]", n)?,
            friction: cell("friction [J]", n)?,
            contact: cell("contact method [J]", n)?,
            viscous: cell("viscous [J]", n)?,
            hourglass: cell("hourglass [J]", n)?,
            remap_loss: cell("remap loss [J]", n)?,
            volume_ratio: cell("volume ratio [-]", n)?,
        })
    };
    (0..table.rows()).map(line).collect()
}

/// Reads the samples of the faces of the box back.
///
/// # Errors
/// When the file cannot be read or a column is missing.
pub fn read_boundaries(path: &Path, is_whole: bool) -> Result<Vec<BoundarySample>, OutputError> {
    let table = Table::read_history(path, is_whole)?;
    let cell = cells(&table, path);
    let line = |n: usize| -> Result<BoundarySample, OutputError> {
        Ok(BoundarySample {
            time: cell("time [s]", n)?,
            lid_area: cell("lid area [m^2]", n)?,
            lid_force: cell("lid force [N]", n)?,
            wall_area: cell("bare wall area [m^2]", n)?,
            stress_rise: cell("stress rise [Pa]", n)?,
        })
    };
    (0..table.rows()).map(line).collect()
}

fn cells<'a>(table: &'a Table, path: &'a Path) -> impl Fn(&str, usize) -> Result<f64, OutputError> + 'a {
    move |name, n| {
        let column = table.column(name);
        column
            .and_then(|values| values.get(n).copied())
            .ok_or_else(|| OutputError::content(path, format!("column `{name}` is missing")))
    }
}

/// Reads all histories of a results folder back. Those of a killed run may end in the middle of a line, and one file may
/// have more lines than another: `is_whole` says that this cannot be.
///
/// # Errors
/// When a file is missing or broken.
pub fn read_history(dir: &Path, names: &[String], is_whole: bool) -> Result<History, OutputError> {
    let bodies = (0..names.len())
        .map(|n| read_forces(&dir.join(forces_name(names, n)), is_whole))
        .collect::<Result<_, _>>()?;
    let mut history = History {
        names: names.to_vec(),
        bodies,
        energy: read_energy(&dir.join(ENERGY), is_whole)?,
        boundaries: read_boundaries(&dir.join(BOUNDARIES), is_whole)?,
    };
    if !is_whole {
        let lines =
            history.bodies.iter().map(Vec::len).chain([history.energy.len(), history.boundaries.len()]);
        let lines = lines.min().unwrap_or(0);
        history.bodies.iter_mut().for_each(|samples| samples.truncate(lines));
        history.energy.truncate(lines);
        history.boundaries.truncate(lines);
    }
    Ok(history)
}
