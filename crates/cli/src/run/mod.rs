//! `coulter run`: runs a case.

mod request;

use crate::common::{DeviceOption, say_json, warn};
use crate::failure::Failure;
use crate::processes::World;
use crate::signals;
use clap::ArgGroup;
use coulter::case;
use coulter::confidence::Wanted;
use coulter::confidence::variations::ErrorSource;
use coulter::run::{Accuracy, Budget, NoFollower, Start};
use std::path::PathBuf;

pub use request::{PreparedRun, RunRequest, graded};

#[derive(Debug, clap::Args)]
#[command(group(ArgGroup::new("narrowed").args(["confidence", "accuracy"])))]
pub(super) struct Arguments {
    /// The case file
    case: PathBuf,
    /// Where to write the results [default: results/NAME]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Overwrite existing results
    #[arg(long, conflicts_with_all = ["resume", "auto_resume"])]
    force: bool,
    /// Threads of each process [default: those of the case]; 0 for as many as `SLURM_CPUS_PER_TASK` says, or
    /// else `OMP_NUM_THREADS`, or else one per core that it may use by affinity and control groups (processes
    /// on one machine share its cores)
    #[arg(long, value_name = "N", value_parser = crate::common::threads())]
    threads: Option<u16>,
    #[command(flatten)]
    on: DeviceOption,
    /// Sets a key, such as soil.friction_angle="38 deg"; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
    /// Take soil under water for drained, whatever its drainage number
    #[arg(long)]
    accept_drained: bool,
    /// Resume from the last checkpoint; start if there is none yet
    #[arg(long)]
    resume: bool,
    /// For schedulers: start, resume, or leave a finished run unchanged
    #[arg(long, conflicts_with = "resume")]
    auto_resume: bool,
    /// Run the case on N meshes, 2 to 6, the coarsest with cells twice as wide as the case's own, to get the
    /// interval (90 %) of each force and sinkage on account of the cells; with 4 or more, trend and scatter
    /// are told apart. `check --meshes N` shows what they cost. With --confidence: on how many meshes
    #[arg(long, value_name = "N", value_parser = crate::common::meshes())]
    meshes: Option<usize>,
    /// Run variations of the case as well (coarser meshes, a larger domain, half the speed, the other
    /// precision) to get one interval (90 %) for each force and sinkage, and what dominates it.
    /// `check --confidence` shows what they cost
    #[arg(long)]
    confidence: bool,
    /// Choose the cells: coarse ones first, and then those on which the intervals (90 %) become as narrow as
    /// wanted: "5 %", or "drag 5 %, sinkage 8 %". The effects of domain and speed are examined on coarse ones
    #[arg(long, value_name = "WANTED", conflicts_with_all = ["meshes", "confidence"], value_parser = Wanted::parse)]
    accuracy: Option<Wanted>,
    /// How long the variations may take together: "20 min", or a multiple of the case's own run such as 4x.
    /// What does not fit is reported as not examined [default: 8x]
    #[arg(long, value_name = "TIME", requires = "narrowed", value_parser = crate::common::budget)]
    budget: Option<Budget>,
    /// What the intervals leave out, because it is a part of the problem: domain (real walls), speed (a fast
    /// tow that is meant), mesh, precision; may be repeated
    #[arg(long, value_name = "SOURCE", requires = "narrowed", value_delimiter = ',', value_parser = crate::common::error_source)]
    without: Vec<ErrorSource>,
    /// Print summary.json at the end
    #[arg(long)]
    json: bool,
}

impl Arguments {
    fn request(&self) -> Result<RunRequest, Failure> {
        let variations = crate::common::asked(self.meshes, self.confidence, &self.without)
            .map(|asked| (asked, self.confidence.then(|| self.budget.unwrap_or_default())));
        Ok(RunRequest {
            text: case::text(&self.case)?,
            source_name: self.case.display().to_string(),
            overrides: crate::common::overrides(&self.overrides, self.accept_drained),
            output: self.output.clone(),
            start: self.start(),
            threads: self.threads,
            variations,
            accuracy: self.accuracy.clone().map(|wanted| Accuracy {
                wanted,
                budget: self.budget.unwrap_or_default(),
                without: self.without.clone(),
            }),
            quiet: self.json,
            device: self.on.device,
        })
    }

    fn start(&self) -> Start {
        match (self.force, self.resume, self.auto_resume) {
            (true, ..) => Start::Replace,
            (_, true, _) => Start::Resume,
            (.., true) => Start::AutoResume,
            _ => Start::Anew,
        }
    }
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let world = World::begin()?;
    let beside = [
        (arguments.meshes.is_some(), "--meshes"),
        (arguments.confidence, "--confidence"),
        (arguments.accuracy.is_some(), "--accuracy"),
    ];
    if let Some((_, option)) = beside.iter().find(|(is_asked, _)| *is_asked && world.size() > 1) {
        let why = format!(
            "{option} starts one run after the other, each in one process; leave out mpirun, or run the cases one by one"
        );
        return world.conclude(Err(Failure::Request(why)));
    }
    world.conclude(run_one(arguments, &world))
}

fn run_one(arguments: &Arguments, world: &World) -> Result<(), Failure> {
    // Before anything else: a signal during the start must be handled like a later one.
    let interrupts = signals::listen();
    let prepared = arguments.request()?.prepare()?;
    if world.is_first() {
        warn(&prepared.warnings);
    }
    let summary = prepared.run(&interrupts, &mut NoFollower)?;
    if arguments.json && world.is_first() {
        say_json(&*summary)?;
    }
    graded(&summary)
}
