//! `run.json`: what a report needs in addition to the histories, the summary and the pictures. It also
//! identifies a folder as a result of Coulter.

use super::describe::describe;
use crate::files::{Inside, OutputError, read_json, write_json};
use crate::formats;
use crate::history::probes::places;
use crate::history::reference::Reference;
use crate::history::steady::{SteadyPart, SteadyWindow};
use crate::history::{ExchangeBalance, History};
use crate::overlay::Overlay;
use crate::tables::{HistoryNames, read_history};
use crate::trust::{Setting, Trust};
use case::Case;
use case::case_text;
use case::meshes::representative_width;
use case::resolved::{GROUND, Ground, Joint, Stage};
use serde::{Deserialize, Serialize};
use std::path::Path;
use xxhash_rust::xxh3::xxh3_64;

/// Name of the file.
pub(super) const RUN_RECORD: &str = "run.json";

/// How a run ended.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Outcome {
    /// The run is still going on.
    #[default]
    Running,
    /// The run reached its end.
    Finished,
    /// The run was stopped from outside and can be resumed.
    Interrupted,
    /// The physics failed; the message says how.
    BrokeDown(String),
}

impl Outcome {
    /// Whether nothing is left to be run.
    #[must_use]
    pub fn is_end(&self) -> bool {
        matches!(self, Self::Finished | Self::BrokeDown(_))
    }
}

/// Statistics of the run.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct RunStatistics {
    /// Steps taken.
    pub steps: u64,
    /// Wall-clock time of the time loop [s], over all restarts.
    pub wall_seconds: f64,
    /// Threads.
    pub threads: usize,
    /// How the run ended.
    pub outcome: Outcome,
    /// Warnings about the case from before the run.
    pub advice: Vec<String>,
    /// The stages so far; empty for a run that has only one.
    pub stages: Vec<StageRecord>,
    /// The energy that passed to and from another program that steers bodies.
    pub exchange: ExchangeBalance,
}

/// A stage of a run.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct StageRecord {
    /// Name of the stage.
    pub name: String,
    /// When the stage began [s].
    pub from_s: f64,
    /// When the stage ended [s]; the time of the last sample of a stage that is still on.
    pub to_s: f64,
}

impl StageRecord {
    /// The stages of a case that have begun, from the history of the run.
    #[must_use]
    pub fn all(case: &Case, history: &History) -> Vec<Self> {
        let record = |(number, stage): (usize, &Stage)| {
            let [from_s, to_s] = history.stage_times(number)?;
            Some(Self { name: stage.name.clone(), from_s, to_s })
        };
        case.stages.iter().enumerate().filter_map(record).collect()
    }
}

/// The record of a run.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct RunRecord {
    /// Version of the format of the results folder.
    pub format: u32,
    /// Version of Coulter.
    pub version: String,
    /// Name of the case.
    pub case: String,
    /// Hash of everything in the case that affects the physics.
    pub case_hash: String,
    /// Title of the case.
    pub title: String,
    /// Soil and bodies in words: name and description.
    pub facts: Vec<[String; 2]>,
    /// Cells along x, y, z.
    pub cells: [usize; 3],
    /// Smallest cell width [m].
    pub finest_cell: f64,
    /// Cell size in the fine zone, `grid.cell` [m].
    pub cell: f64,
    /// Representative cell width [m].
    pub cell_width: f64,
    /// Duration of the run [s].
    pub duration: f64,
    /// Fraction of the tow over which steady averages are taken.
    #[serde(alias = "steady_share")]
    pub steady_fraction: f64,
    /// Cut-off frequency of the filtered forces [Hz].
    pub filter_cutoff: f64,
    /// The stage over which averages are taken, by number; `None` for a run that has only one.
    pub steady_stage: Option<usize>,
    /// Whether only y ≥ 0 is modelled.
    pub symmetric: bool,
    /// Whether only x ≥ 0 is modelled.
    #[serde(default)]
    pub symmetric_x: bool,
    /// Whether the soil was heaped on a floor instead of lying level.
    pub heaped: bool,
    /// Whether the case is plane strain.
    pub plane_strain: bool,
    /// The bodies.
    pub bodies: Vec<Reference>,
    /// The parts of bodies that consist of several.
    pub parts: Vec<PartRecord>,
    /// The joints.
    pub joints: Vec<JointRecord>,
    /// Curves overlaid on the plots.
    pub overlays: Vec<Overlay>,
    /// Facts about the case that the checks need.
    pub setting: Setting,
    /// Statistics of the run.
    pub statistics: RunStatistics,
}

/// A part of a body that consists of several.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct PartRecord {
    /// Name of the part.
    pub name: String,
    /// Name of the body.
    pub body: String,
}

impl PartRecord {
    fn all(case: &Case) -> Vec<Self> {
        let record = |(name, (body, ..)): (String, (usize, usize, glam::DVec3))| Self {
            name,
            body: case.bodies[body].name.clone(),
        };
        places(case).into_iter().map(record).collect()
    }
}

/// A joint of a run.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct JointRecord {
    /// Name of the joint.
    pub name: String,
    /// Kind of the joint in one word.
    pub kind: String,
    /// Names of the two bodies.
    pub bodies: [String; 2],
}

impl JointRecord {
    fn of(case: &Case, joint: &Joint) -> Self {
        let name = |body: usize| case.bodies[body].name.clone();
        Self {
            name: joint.name.clone(),
            kind: joint.kind.word().to_owned(),
            bodies: [joint.first.map_or_else(|| GROUND.to_owned(), name), name(joint.second)],
        }
    }
}

/// Hash of everything in a case that affects the physics.
#[must_use]
pub fn hash_of(case: &Case) -> String {
    format!("{:016x}", xxh3_64(case_text(case).as_bytes()))
}

impl RunRecord {
    /// The record of a run that is about to start.
    #[must_use]
    pub fn of(case: &Case) -> Self {
        let faces = &case.grid.faces;
        let widths = faces.iter().flat_map(|f| f.windows(2).map(|w| w[1] - w[0]));
        Self {
            format: formats::RESULTS,
            version: env!("CARGO_PKG_VERSION").to_owned(),
            case: case.name.clone(),
            case_hash: hash_of(case),
            title: case.title.clone(),
            facts: describe(case),
            cells: std::array::from_fn(|axis| faces[axis].len().saturating_sub(1)),
            finest_cell: widths.reduce(f64::min).unwrap_or(case.grid.cell),
            cell: case.grid.cell,
            cell_width: representative_width(case),
            duration: case.duration,
            steady_fraction: case.output.steady_fraction,
            steady_stage: case.steady_stage(),
            filter_cutoff: case.output.filter_cutoff,
            symmetric: case.domain.symmetric,
            symmetric_x: case.domain.symmetric_x,
            heaped: matches!(case.ground, Ground::Column { .. }),
            plane_strain: case.domain.plane_strain,
            bodies: Reference::all(case),
            parts: PartRecord::all(case),
            joints: case.joints.iter().map(|joint| JointRecord::of(case, joint)).collect(),
            overlays: Vec::new(),
            setting: Setting::of(case),
            statistics: RunStatistics::default(),
        }
    }

    /// Names of what the run keeps a history of.
    #[must_use]
    pub fn names(&self) -> HistoryNames {
        HistoryNames {
            bodies: self.bodies.iter().map(|body| body.name.clone()).collect(),
            parts: self.parts.iter().map(|part| part.name.clone()).collect(),
            joints: self.joints.iter().map(|joint| joint.name.clone()).collect(),
        }
    }

    /// The history of the run, from the tables in its folder (see [`read_history`]).
    ///
    /// # Errors
    /// Where a table cannot be read.
    pub fn history(&self, dir: &Path, is_whole: bool) -> Result<History, OutputError> {
        let history = read_history(dir, &self.names(), is_whole)?;
        Ok(History { exchange: self.statistics.exchange.clone(), ..history })
    }

    /// The grade of the run with this history.
    #[must_use]
    pub fn trust(&self, history: &History) -> Trust {
        let failure = match &self.statistics.outcome {
            Outcome::BrokeDown(why) => Some(why.as_str()),
            Outcome::Running | Outcome::Finished | Outcome::Interrupted => None,
        };
        Trust::grade(&self.setting, history, &self.bodies, self.steady_part(), failure)
    }

    /// The steady windows of the bodies, in their order.
    pub fn steady_windows<'a>(&'a self, history: &'a History) -> impl Iterator<Item = SteadyWindow<'a>> {
        let bodies = history.bodies.iter().zip(&self.bodies);
        bodies.map(|(samples, reference)| SteadyWindow::of(samples, reference, self.steady_part()))
    }

    /// The bodies with a surface, without obstacles that nothing moves, unless nothing moves any of them.
    pub fn moved_bodies(&self) -> impl Iterator<Item = &Reference> {
        let touching = || self.bodies.iter().filter(|body| body.has_surface());
        let all_are_still = touching().all(|body| body.still);
        touching().filter(move |body| all_are_still || !body.still)
    }

    /// Which part of the run averages are taken over.
    #[must_use]
    pub fn steady_part(&self) -> SteadyPart {
        let stage = self.steady_stage.and_then(|number| self.statistics.stages.get(number));
        SteadyPart { fraction: self.steady_fraction, during: stage.map(|stage| [stage.from_s, stage.to_s]) }
    }

    /// Writes `run.json` into a results folder.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn write(&self, dir: &Path) -> Result<(), OutputError> {
        write_json(&Inside::of(dir, RUN_RECORD), self)
    }

    /// Writes `run.json` anew, with these statistics.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn update(&mut self, dir: &Path, statistics: RunStatistics) -> Result<(), OutputError> {
        self.statistics = statistics;
        self.write(dir)
    }

    /// Reads `run.json` from a results folder.
    ///
    /// # Errors
    /// When the file is missing, is not a record of a run, or that of another version of the format.
    pub fn read(dir: &Path) -> Result<Self, OutputError> {
        let file = Inside::of(dir, RUN_RECORD);
        if !file.exists() {
            return Err(OutputError::NoResult { path: dir.to_path_buf() });
        }
        read_json(&file, "format")
    }
}
