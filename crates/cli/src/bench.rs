//! `coulter bench`: how fast the solver is on this machine.

use crate::common::{DeviceOption, default_threads, say, say_json};
use crate::failure::Failure;
use crate::processes::{self, World};
use coulter::bench::{self, Network, Options, RankError, RankMeasurement, TOWED_DISC};
use coulter::case::{self, cores};
use coulter::run::Device;
use std::path::PathBuf;
use std::process::{Command, Stdio};

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The case file [default: the towed disc, 20 mm deep and moving]
    case: Option<PathBuf>,
    /// Sets a key, such as grid.cell="5 mm"; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
    /// Threads to compare with one; 0 for as many as a run has by default (`coulter run --help`)
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = crate::common::threads())]
    threads: u16,
    /// Steps before the measurement
    #[arg(long, value_name = "N", default_value_t = 500)]
    warm_up: u32,
    /// Steps to measure
    #[arg(long, value_name = "N", default_value_t = 1500, value_parser = clap::value_parser!(u32).range(1..))]
    steps: u32,
    #[command(flatten)]
    on: DeviceOption,
    /// Measure in these numbers of MPI processes, each with one thread unless --threads says otherwise, and
    /// predict more
    #[arg(long, value_name = "N,N", conflicts_with = "device", value_delimiter = ',', value_parser = clap::value_parser!(u16).range(1..))]
    ranks: Vec<u16>,
    /// How processes are started; their number follows
    #[arg(long, value_name = "COMMAND", default_value = "mpirun -n")]
    launcher: String,
    /// Latency of a message for the prediction, in place of the measured one [µs]
    #[arg(long, value_name = "NUMBER", requires = "ranks", value_parser = positive)]
    latency: Option<f64>,
    /// Bandwidth of a message for the prediction, in place of the measured one [GB/s]
    #[arg(long, value_name = "NUMBER", requires = "ranks", value_parser = positive)]
    bandwidth: Option<f64>,
    /// Measure as one of the processes
    #[arg(long, hide = true)]
    as_rank: bool,
    /// Print one JSON document
    #[arg(long)]
    json: bool,
}

fn positive(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok().filter(|number| number.is_finite() && *number > 0.0);
    number.ok_or_else(|| "expected a positive number".to_owned())
}

pub(super) fn bench(arguments: &Arguments) -> Result<(), Failure> {
    let world = World::begin()?;
    world.conclude(bench_in(arguments, &world))
}

fn bench_in(arguments: &Arguments, world: &World) -> Result<(), Failure> {
    let is_rank = world.size() > 1 || arguments.as_rank;
    let options = options(arguments, is_rank || !arguments.ranks.is_empty())?;
    if is_rank {
        if arguments.on.device != Device::Processor {
            let why = "--device measures one process; leave out mpirun";
            return Err(Failure::Request(why.to_owned()));
        }
        let measured = as_rank(&options)?;
        return if world.is_first() { say_scaling(arguments, vec![measured]) } else { Ok(()) };
    }
    if !arguments.ranks.is_empty() {
        let counts = arguments.ranks.iter();
        let measured = counts.map(|ranks| on_ranks(arguments, &options, *ranks)).collect::<Result<_, _>>()?;
        return say_scaling(arguments, measured);
    }
    if arguments.on.device != Device::Processor {
        let measured = bench::measure_on_device(&options, arguments.on.device)
            .map_err(|error| Failure::Request(error.to_string()))?;
        return if arguments.json { say_json(&measured) } else { say(&bench::device_table(&measured)) };
    }
    let measured = bench::measure(&options).map_err(|cause| Failure::Physics(cause.to_string()))?;
    if arguments.json {
        return say_json(&measured);
    }
    say(&bench::table(&measured))
}

/// What to measure; several processes have one thread each unless more are asked for.
fn options(arguments: &Arguments, in_processes: bool) -> Result<Options, Failure> {
    let case = match &arguments.case {
        Some(path) => case::load(path, &arguments.overrides)?,
        None => {
            let (text, moving) = TOWED_DISC;
            let overrides: Vec<String> =
                moving.iter().map(ToString::to_string).chain(arguments.overrides.iter().cloned()).collect();
            case::parse(text, "light_disc.toml", &overrides)?
        }
    };
    let threads = match arguments.threads {
        0 if in_processes => 1,
        asked => default_threads(usize::from(asked)),
    };
    Ok(Options { case, threads, warm_up: arguments.warm_up, steps: arguments.steps })
}

/// Measures as one of the processes.
fn as_rank(options: &Options) -> Result<RankMeasurement, Failure> {
    bench::measure_ranks(options, processes::communicator()).map_err(|error| match error {
        RankError::Blocks(error) => Failure::Request(error.to_string()),
        RankError::Physics(cause) => Failure::Physics(cause.to_string()),
    })
}

/// Measures in a number of processes, which this one starts unless it is only one.
fn on_ranks(arguments: &Arguments, options: &Options, ranks: u16) -> Result<RankMeasurement, Failure> {
    if ranks == 1 {
        return as_rank(options);
    }
    let failed = |why: String| Failure::Request(format!("{} {ranks}: {why}", arguments.launcher));
    let program = std::env::current_exe().map_err(|error| failed(error.to_string()))?;
    let mut words = arguments.launcher.split_whitespace();
    let mut command = Command::new(words.next().unwrap_or("mpirun"));
    command.args(words).arg(ranks.to_string()).arg(program).args(["bench", "--as-rank", "--json"]);
    command.args(&arguments.case).args(["--threads", &options.threads.to_string()]);
    command.args(["--warm-up", &arguments.warm_up.to_string(), "--steps", &arguments.steps.to_string()]);
    command.args(arguments.overrides.iter().flat_map(|key| ["--set", key]));
    let output = command.stderr(Stdio::inherit()).output().map_err(|error| failed(error.to_string()))?;
    if !output.status.success() {
        return Err(failed(format!("ended with {}", output.status)));
    }
    // One process says it as the only measurement of a scaling.
    let said: Result<Said, _> = serde_json::from_slice(&output.stdout);
    let measured = said.ok().and_then(|said| said.measured.into_iter().next());
    measured.ok_or_else(|| failed("no measurement came back".to_owned()))
}

#[derive(serde::Deserialize)]
struct Said {
    measured: Vec<RankMeasurement>,
}

fn say_scaling(arguments: &Arguments, measured: Vec<RankMeasurement>) -> Result<(), Failure> {
    let known = measured.iter().filter_map(|own| own.network).next_back();
    let network = known.map(|known| Network {
        latency_s: arguments.latency.map_or(known.latency_s, |latency| 1e-6 * latency),
        bandwidth: arguments.bandwidth.map_or(known.bandwidth, |bandwidth| 1e9 * bandwidth),
        collective_s: arguments.latency.map_or(known.collective_s, |latency| 1e-6 * latency),
    });
    let scaling = bench::scaling(measured, network);
    if arguments.json {
        return say_json(&scaling);
    }
    // A process of several may be bound to a core.
    let processors = if arguments.ranks.is_empty() { usize::MAX } else { cores::cores().count };
    say(&bench::scaling_table(&scaling, processors))
}
