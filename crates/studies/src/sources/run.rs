//! The history of a finished or stopped run as a record.

use crate::measured::{Quantity, Record};
use coulter::history::BodySample;
use coulter::history::blocks::{STUDENT_90, block_averages, standard_error};
use coulter::history::reference::Reference;
use coulter::history::steady::SteadyWindow;
use coulter::output::folder::{Contents, Outcome, RunRecord, inspect};
use coulter::output::tables::read_history;
use std::ops::Range;
use std::path::Path;

/// A run: its history and its steady window.
#[derive(Clone, Debug)]
pub struct RunSource {
    /// The history of one body.
    pub record: Record,
    /// The lines of the steady window.
    pub steady: Range<usize>,
    /// The folder's record of the run.
    pub run: RunRecord,
}

/// The samples of one body of a run.
#[derive(Clone, Debug)]
pub struct BodySamples {
    /// The folder's record of the run.
    pub run: RunRecord,
    /// Reference quantities of the body.
    pub reference: Reference,
    /// The samples.
    pub samples: Vec<BodySample>,
}

/// Reads the samples of a body from a results folder; of the first body with a surface unless one is named.
///
/// # Errors
/// What keeps them from being read, with a cure.
pub fn read_samples(folder: &Path, body: Option<&str>) -> Result<BodySamples, String> {
    let shown = folder.display();
    let run = match inspect(folder).map_err(|error| error.to_string())? {
        Contents::Run(run) => *run,
        Contents::Nothing | Contents::Foreign => {
            return Err(format!(
                "{shown} holds no results of a run; name the folder that `coulter run` wrote"
            ));
        }
    };
    let number = match body {
        Some(name) => run.bodies.iter().position(|reference| reference.name == name).ok_or_else(|| {
            let names: Vec<&str> = run.bodies.iter().map(|reference| reference.name.as_str()).collect();
            format!("{shown}: no body is called `{name}`; its bodies are {}", names.join(", "))
        })?,
        None => run.bodies.iter().position(Reference::has_surface).unwrap_or(0),
    };
    let is_whole = run.statistics.outcome == Outcome::Finished;
    let mut history = read_history(folder, &run.names(), is_whole).map_err(|error| error.to_string())?;
    let Some(reference) = run.bodies.get(number).filter(|_| number < history.bodies.len()).cloned() else {
        return Err(format!("{shown}: the run has no body"));
    };
    Ok(BodySamples { samples: history.bodies.swap_remove(number), reference, run })
}

/// Reads the history of a body from a results folder; the first body with a surface unless one is named.
///
/// # Errors
/// What keeps it from being read, with a cure.
pub fn read_run(folder: &Path, body: Option<&str>) -> Result<RunSource, String> {
    let BodySamples { run, reference, samples } = read_samples(folder, body)?;
    let steady = SteadyWindow::of(&samples, &reference, run.steady_part()).range;
    Ok(RunSource { record: record(&folder.display().to_string(), &samples, &reference), steady, run })
}

/// A quantity and where a sample has it.
type Column = (Quantity, fn(&BodySample) -> f64);

/// The columns of a history that curves use.
fn record(name: &str, samples: &[BodySample], reference: &Reference) -> Record {
    let mut record = Record { name: name.to_owned(), ..Record::default() };
    let columns: [Column; 12] = [
        (Quantity::Time, |s| s.time),
        (Quantity::Displacement, |s| s.displacement),
        (Quantity::Sinkage, |s| s.sinkage),
        (Quantity::Drag, |s| s.drag),
        (Quantity::Vertical, |s| s.vertical),
        (Quantity::Lateral, |s| s.lateral),
        (Quantity::Speed, |s| s.speed),
        (Quantity::Rotation, |s| s.rotation),
        (Quantity::Spin, |s| s.spin),
        (Quantity::MomentX, |s| s.moment_x),
        (Quantity::MomentY, |s| s.moment_y),
        (Quantity::MomentZ, |s| s.moment_z),
    ];
    for (quantity, value) in columns {
        record.push(quantity, samples.iter().map(value).collect());
    }
    let torque = |s: &BodySample| match reference.yaw_drive {
        0.0 => s.axle_torque,
        sign => 0.0 - sign * s.moment_z,
    };
    record.push(Quantity::Torque, samples.iter().map(torque).collect());
    if let Some(area) = base_area(reference) {
        record.push(Quantity::Pressure, samples.iter().map(|s| s.vertical / area).collect());
    }
    record
}

/// The area of a round base [m²].
fn base_area(reference: &Reference) -> Option<f64> {
    let is_round = matches!(reference.kind.as_str(), "cone" | "cylinder") && !reference.towed;
    is_round.then_some(0.25 * std::f64::consts::PI * reference.length * reference.length)
}

impl RunSource {
    /// The mean of a quantity over the steady window, and half of its 90 % interval from averages over
    /// blocks, where there are enough samples for one.
    #[must_use]
    pub fn steady_mean(&self, quantity: Quantity) -> Option<(f64, Option<f64>)> {
        let values = self.record.values(quantity)?.get(self.steady.clone()).filter(|v| !v.is_empty())?;
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        let half = block_averages(values).map(|blocks| STUDENT_90 * standard_error(&blocks));
        mean.is_finite().then_some((mean, half))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_torque_of_a_body_driven_in_yaw_is_that_about_z() {
        let samples = [BodySample { moment_z: -18.0, axle_torque: 0.1, ..BodySample::default() }; 2];
        let vane = |yaw_drive: f64| {
            let reference = Reference { kind: "cylinder".into(), yaw_drive, ..Reference::default() };
            record("run", &samples, &reference).values(Quantity::Torque).unwrap()[0]
        };
        assert_eq!([vane(1.0), vane(-1.0), vane(0.0)], [18.0, -18.0, 0.1]);
        let record = record("run", &samples, &Reference::default());
        assert_eq!(record.values(Quantity::MomentZ), Some(&[-18.0, -18.0][..]));
    }
}
