//! `summary.json`: the main results for scripts. The names are a contract.

use case::FORMAT;
use results::confidence::Confidence;
use results::fields::SurfaceFigures;
use results::files::{Inside, OutputError, SUMMARY, read_json, write_json};
use results::folder::{RunRecord, StageRecord};
use results::formats;
use results::history::quantities::{Figures, Quantity, Steady, finite};
use results::history::rim::{RimAverage, RimPlace, SlipReversal, shear_reversals, slip_reversals};
use results::history::steady::{Peak, SteadyWindow, peak};
use results::history::{EnergySample, ForceSample, History, RutSection};
use results::trust::body::Mesh;
use results::trust::{Setting, Trust};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::Path;

/// The main results of a run.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Summary {
    /// Version of the case-file format that the case was written in; 0 in summaries of format 1, which do not
    /// say.
    pub format: u32,
    /// Version of the format of the results folder.
    pub results_format: u32,
    /// Name of the case.
    pub case: String,
    /// Version of Coulter.
    pub version: String,
    /// Cells of the grid.
    pub cells: u64,
    /// Cells that contain soil at the end.
    pub filled_cells: u64,
    /// Steps taken.
    pub steps: u64,
    /// Wall-clock time [s].
    pub wall_s: f64,
    /// The soil.
    pub soil: SoilSummary,
    /// The energy balance at the end.
    pub energy: EnergySummary,
    /// The free surface at the end.
    pub surface: SurfaceFigures,
    /// What the bodies have left behind, by name: mean sections across their ruts.
    pub ruts: BTreeMap<String, RutSection>,
    /// The bodies by name.
    pub bodies: BTreeMap<String, BodySummary>,
    /// Steady means of the forces of the soil on all bodies together [N], but for obstacles that nothing
    /// moves beside bodies that move; `null` where that is one body.
    pub all_bodies: Option<Figures<Option<f64>>>,
    /// The parts by name of bodies that consist of several: the soil's force on each.
    pub parts: BTreeMap<String, ForceSummary>,
    /// The joints by name: the force of the first body on the second.
    pub joints: BTreeMap<String, ForceSummary>,
    /// Cut-off frequency of the filtered forces in `filtered.csv` [Hz].
    #[serde(rename = "filter_cutoff_Hz")]
    pub filter_cutoff: f64,
    /// The stages of the run; empty for one that has only one.
    pub stages: Vec<StageRecord>,
    /// Whether the results can be trusted.
    pub trust: Trust,
    /// Intervals from variations of the case; `null` without `--confidence` and `--meshes`.
    pub confidence: Option<Confidence>,
}

/// Results on the soil.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct SoilSummary {
    /// Volume at the end over the volume at the start.
    pub volume_ratio: Option<f64>,
    /// Soil inside the bodies at the end [m³].
    pub leaked_m3: f64,
}

/// The energy balance at the end [J].
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct EnergySummary {
    /// Work of loads, prescribed motions and gravity [J].
    #[serde(rename = "external_J")]
    pub external: Option<f64>,
    /// Kinetic energy [J].
    #[serde(rename = "kinetic_J")]
    pub kinetic: Option<f64>,
    /// Elastic energy, less that at the start [J].
    #[serde(rename = "elastic_J")]
    pub elastic: Option<f64>,
    /// Plastic dissipation [J].
    #[serde(rename = "plastic_J")]
    pub plastic: Option<f64>,
    /// Dissipation by friction on the bodies [J].
    #[serde(rename = "friction_J")]
    pub friction: Option<f64>,
    /// Energy that the contact method itself stores, dissipates or adds [J].
    #[serde(rename = "contact_J")]
    pub contact: Option<f64>,
    /// Dissipation by bulk viscosity [J].
    #[serde(rename = "viscous_J")]
    pub viscous: Option<f64>,
    /// Dissipation by hourglass viscosity [J].
    #[serde(rename = "hourglass_J")]
    pub hourglass: Option<f64>,
    /// Dissipation by pore water that seeps through the soil [J].
    #[serde(rename = "seepage_J")]
    pub seepage: Option<f64>,
    /// Kinetic and elastic energy lost in remaps [J].
    #[serde(rename = "remap_loss_J")]
    pub remap_loss: Option<f64>,
    /// Relative error of the energy balance: unexplained energy, beyond rounding, over the largest of
    /// external work, plastic dissipation and kinetic energy.
    pub closure: Option<f64>,
}

/// Results on a body.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct BodySummary {
    /// Averages over the steady window.
    pub steady: Steady,
    /// Largest values.
    pub peak: Peak,
    /// The rim of the body, averaged over the steady window.
    pub rim: RimSummary,
    /// How well the grid resolves the body.
    pub mesh: Mesh,
}

/// Force on a part of a body, or through a joint, averaged over the steady window of its body or of its
/// second body.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ForceSummary {
    /// Mean force along x, y, z [N].
    #[serde(rename = "force_N")]
    pub force: Option<[f64; 3]>,
    /// Mean moment about x, y, z [N m], through the reference point of the part or through the joint.
    #[serde(rename = "moment_Nm")]
    pub moment: Option<[f64; 3]>,
    /// Mean distance between the joint's points of the two bodies [m]; `null` of a part.
    #[serde(rename = "distance_m")]
    pub distance: Option<f64>,
    /// Largest force of the whole run [N].
    #[serde(rename = "peak_force_N")]
    pub peak_force: Option<f64>,
}

impl ForceSummary {
    /// Of all samples, the means over those of a time window [s].
    fn of(samples: &[ForceSample], [from, to]: [f64; 2]) -> Self {
        let inside: Vec<&ForceSample> = samples.iter().filter(|s| s.time > from && s.time <= to).collect();
        let mean = |value: fn(&ForceSample) -> f64| {
            let sum: f64 = inside.iter().map(|sample| value(sample)).sum();
            (!inside.is_empty() && sum.is_finite()).then(|| sum / inside.len() as f64)
        };
        let three = |[x, y, z]: [fn(&ForceSample) -> f64; 3]| Some([mean(x)?, mean(y)?, mean(z)?]);
        let peak = samples.iter().map(ForceSample::force).fold(f64::NEG_INFINITY, f64::max);
        Self {
            force: three([|s| s.force_x, |s| s.force_y, |s| s.force_z]),
            moment: three([|s| s.moment_x, |s| s.moment_y, |s| s.moment_z]),
            distance: mean(|s| s.distance),
            peak_force: peak.is_finite().then_some(peak),
        }
    }
}

/// Results on the rim of a body and on its flanks, averaged over the steady window; `null` in JSON where
/// there is nothing to average.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct RimSummary {
    /// Time at which the average begins [s].
    pub from_s: Option<f64>,
    /// Time at which the average ends [s].
    pub to_s: Option<f64>,
    /// Drag on the rim [N].
    #[serde(rename = "drag_N")]
    pub drag: Option<f64>,
    /// Vertical force on the rim [N].
    #[serde(rename = "vertical_N")]
    pub vertical: Option<f64>,
    /// Drag on the flanks [N].
    #[serde(rename = "flank_drag_N")]
    pub flank_drag: Option<f64>,
    /// Vertical force on the flanks [N].
    #[serde(rename = "flank_vertical_N")]
    pub flank_vertical: Option<f64>,
    /// Friction on the rim over its limit, whatever its direction; `null` on a rough body.
    pub mobilised_friction: Option<f64>,
    /// Where the slip along the rim changes its sign.
    pub slip_reversals: Vec<SlipReversal>,
    /// Where the shear stress along the rim changes its sign.
    pub shear_reversals: Vec<RimPlace>,
}

impl From<&RimAverage> for RimSummary {
    fn from(rim: &RimAverage) -> Self {
        Self {
            from_s: finite(rim.window[0]),
            to_s: finite(rim.window[1]),
            drag: finite(rim.drag[0]),
            vertical: finite(rim.vertical[0]),
            flank_drag: finite(rim.drag[1]),
            flank_vertical: finite(rim.vertical[1]),
            mobilised_friction: finite(rim.mobilised),
            slip_reversals: slip_reversals(&rim.lines),
            shear_reversals: shear_reversals(&rim.lines),
        }
    }
}

/// The rims of the bodies, each averaged over the steady window of its body; none where there is nothing to
/// average.
#[must_use]
pub(crate) fn rims(history: &History, record: &RunRecord) -> Vec<Option<RimAverage>> {
    let average = |(n, SteadyWindow { samples, range, .. }): (usize, SteadyWindow<'_>)| {
        // A sample is an average since the one before it.
        let from = samples.get(range.start.saturating_sub(1))?.time;
        let to = samples.get(range.end.checked_sub(1)?)?.time;
        history.rims.get(n)?.average([from, to])
    };
    record.steady_windows(history).enumerate().map(average).collect()
}

impl EnergySummary {
    /// The entries of a sample, in a case with these facts.
    fn of(e: &EnergySample, setting: &Setting) -> Self {
        Self {
            external: finite(e.external),
            kinetic: finite(e.kinetic),
            elastic: finite(e.elastic),
            plastic: finite(e.plastic),
            friction: finite(e.friction),
            contact: finite(e.contact),
            viscous: finite(e.viscous),
            hourglass: finite(e.hourglass),
            seepage: finite(e.seepage),
            remap_loss: finite(e.remap_loss),
            closure: finite(setting.closure(e)),
        }
    }
}

impl Summary {
    /// The summary of a run as far as its record determines it.
    #[must_use]
    pub fn of(record: &RunRecord) -> Self {
        Self {
            format: FORMAT,
            results_format: formats::RESULTS,
            case: record.case.clone(),
            version: record.version.clone(),
            cells: record.cells.iter().map(|n| *n as u64).product(),
            steps: record.statistics.steps,
            wall_s: record.statistics.wall_seconds,
            filter_cutoff: record.filter_cutoff,
            stages: record.statistics.stages.clone(),
            ..Self::default()
        }
    }

    /// Fills in what follows from the histories: bodies, energy balance, leakage, grade.
    pub fn fill(&mut self, history: &History, record: &RunRecord) {
        self.trust = record.trust(history);
        let rims = rims(history, record);
        self.bodies = record
            .steady_windows(history)
            .zip(&rims)
            .zip(&record.setting.bodies)
            .map(|((window, rim), setting)| {
                let mesh = Mesh::of(setting, &window);
                let SteadyWindow { samples, reference, mut steady, .. } = window;
                steady.is_steady = self.trust.is_steady(&reference.name);
                let rim = rim.as_ref().map(RimSummary::from).unwrap_or_default();
                (reference.name.clone(), BodySummary { steady, peak: peak(samples), rim, mesh })
            })
            .collect();
        let steady =
            record.moved_bodies().filter_map(|reference| Some(&self.bodies.get(&reference.name)?.steady));
        let steady: Vec<&Steady> = steady.collect();
        let sum = |force: Quantity| steady.iter().map(|body| force.mean(body)).sum();
        self.all_bodies = (steady.len() > 1).then(|| Figures::of_forces(sum));
        let window =
            |body: &str| match self.bodies.get(body).map(|body| (body.steady.from_s, body.steady.to_s)) {
                Some((Some(from), Some(to))) => [from, to],
                _ => [f64::NAN; 2],
            };
        let joints = record.joints.iter().zip(&history.joints);
        self.joints = joints
            .map(|(joint, samples)| (joint.name.clone(), ForceSummary::of(samples, window(&joint.bodies[1]))))
            .collect();
        let parts = record.parts.iter().zip(&history.parts);
        self.parts = parts
            .map(|(part, samples)| {
                let mean = ForceSummary::of(samples, window(&part.body));
                (part.name.clone(), ForceSummary { distance: None, ..mean })
            })
            .collect();
        let last = history.energy.last();
        self.energy = last.map(|e| EnergySummary::of(e, &record.setting)).unwrap_or_default();
        self.soil.volume_ratio = last.map(|e| e.volume_ratio).filter(|v| v.is_finite());
        let leaks = history.bodies.iter().filter_map(|samples| samples.last());
        self.soil.leaked_m3 = leaks.map(|s| s.leaked_volume).filter(|v| v.is_finite()).sum::<f64>() + 0.0;
    }

    /// Adds the intervals that follow from variations of the case, and their checks to the grade.
    pub(crate) fn set_confidence(&mut self, confidence: Confidence) {
        self.trust.set_confidence_checks(confidence.checks());
        self.confidence = Some(confidence);
    }

    /// Cells with soil times steps, per second of wall-clock time.
    #[must_use]
    pub fn cell_steps_per_second(&self) -> Option<f64> {
        (self.wall_s > 0.0).then(|| self.filled_cells as f64 * self.steps as f64 / self.wall_s)
    }

    /// Writes `summary.json` into a results folder.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn write(&self, dir: &Path) -> Result<(), OutputError> {
        write_json(&Inside::of(dir, SUMMARY), self)
    }

    /// Reads `summary.json` from a results folder.
    ///
    /// # Errors
    /// When the file cannot be read, is not a summary, or is of another version of the format.
    pub fn read(dir: &Path) -> Result<Self, OutputError> {
        read_json(&Inside::of(dir, SUMMARY), "results_format")
    }
}
