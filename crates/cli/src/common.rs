//! What several commands share: printing to standard output, and checks of arguments.

use crate::failure::Failure;
use clap::builder::TypedValueParser as _;
use coulter::case::cores;
use coulter::case::quantity::{TIME, parse};
use coulter::confidence::variations::{Asked, ErrorSource, MESHES};
use coulter::printed::plain;
use coulter::run::{Budget, Device, RunError};
use std::fmt::Display;
use std::io::Write;
use std::ops::RangeInclusive;
use std::path::Path;
use std::str::FromStr;
use studies::measured::ColumnChoice;

/// The option that says what strains the soil.
#[derive(Clone, Copy, Debug, clap::Args)]
#[group(skip)]
pub(super) struct DeviceOption {
    /// What strains the soil: cpu, gpu (a graphics card of NVIDIA, which cases share; gpu:1 for the second)
    /// or stand-in (the kernels of the card on the processor, for comparison); all give the same bits
    #[arg(long, value_name = "DEVICE", default_value = "cpu", value_parser = Device::from_str)]
    pub(super) device: Device,
}

/// Refuses a device that is not there, before anything is written.
pub(super) fn require_device(device: Device) -> Result<(), Failure> {
    device.open().map(drop).map_err(|error| Failure::Request(RunError::Device(error).to_string()))
}

/// The allowed numbers of threads.
pub(super) fn threads() -> clap::builder::RangedI64ValueParser<u16> {
    clap::value_parser!(u16).range(0..=MOST_THREADS as i64)
}

/// Threads of a run, as asked for, or for 0 as many as it has by default; says what was not granted.
pub(super) fn default_threads(asked: usize) -> usize {
    if asked > 0 {
        return asked;
    }
    let by_default = cores::threads_by_default();
    warn(&by_default.notes);
    by_default.count
}

/// Prints a line to standard error. Where it cannot be written the command does its work all the same.
pub(super) fn tell(line: &str) {
    let _ = writeln!(std::io::stderr().lock(), "{}", plain(line));
}

/// Prints warnings to standard error.
pub(super) fn warn(warnings: &[String]) {
    for warning in warnings {
        tell(&format!("warning: {warning}"));
    }
}

/// What `--column` says of the columns of measured files.
pub(super) fn choices(typed: &[String]) -> Result<Vec<ColumnChoice>, Failure> {
    typed.iter().map(|typed| ColumnChoice::parse(typed).map_err(Failure::Request)).collect()
}

/// Most threads of a run.
pub(super) const MOST_THREADS: usize = solver::cpu::threads::MAX_WORKERS;
/// The allowed numbers of cases of a study that run at the same time.
pub(super) const WORKERS: RangeInclusive<u16> = 1..=1024;
/// The allowed numbers of threads of each run of a study.
pub(super) const STUDY_THREADS: RangeInclusive<u16> = 1..=64;

/// The allowed numbers of cases that run at the same time.
pub(super) fn workers() -> clap::builder::RangedI64ValueParser<u16> {
    clap::value_parser!(u16).range(i64::from(*WORKERS.start())..=i64::from(*WORKERS.end()))
}

/// The allowed numbers of threads of each run of a study.
pub(super) fn study_threads() -> clap::builder::RangedI64ValueParser<u16> {
    clap::value_parser!(u16).range(i64::from(*STUDY_THREADS.start())..=i64::from(*STUDY_THREADS.end()))
}

/// Which variations `--meshes` and `--confidence` ask for; `None` without either.
#[must_use]
pub fn asked(meshes: Option<usize>, confidence: bool, without: &[ErrorSource]) -> Option<Asked> {
    match (meshes, confidence) {
        (None, false) => None,
        (Some(meshes), false) => Some(Asked::meshes_alone(meshes)),
        (meshes, true) => {
            let usual = Asked::default();
            Some(Asked { meshes: meshes.unwrap_or(usual.meshes), without: without.to_vec() })
        }
    }
}

/// The allowed numbers of meshes.
pub(super) fn meshes() -> impl clap::builder::TypedValueParser<Value = usize> {
    let (least, most) = (*MESHES.start() as u64, *MESHES.end() as u64);
    clap::value_parser!(u64).range(least..=most).map(|count| usize::try_from(count).unwrap_or(*MESHES.end()))
}

/// A budget: a time with its unit, or how many times the case's own run.
///
/// # Errors
/// What to write instead.
pub fn budget(text: &str) -> Result<Budget, String> {
    let times = text.strip_suffix("times").or_else(|| text.strip_suffix('x')).unwrap_or(text).trim();
    let (budget, size) = match (times.parse::<f64>(), parse(text, &TIME)) {
        (Ok(times), _) => (Budget::Times(times), times),
        (_, Ok(seconds)) => (Budget::Seconds(seconds), seconds),
        _ => {
            return Err(
                "write a time, such as \"20 min\", or a multiple of the run itself, such as 4x".to_owned()
            );
        }
    };
    if size.is_finite() && size >= 0.0 { Ok(budget) } else { Err("a budget is a positive number".to_owned()) }
}

/// A source of uncertainty that variations examine.
///
/// # Errors
/// The words for them.
pub fn error_source(text: &str) -> Result<ErrorSource, String> {
    let examined = ErrorSource::ALL.into_iter().filter(|source| *source != ErrorSource::Statistics);
    let words: Vec<&str> = examined.clone().map(ErrorSource::word).collect();
    let found = examined.into_iter().find(|source| source.word() == text.trim());
    found.ok_or_else(|| format!("one of {}", words.join(", ")))
}

/// The folder of a run, as an argument names it.
pub(super) fn results_folder(path: &Path) -> Result<&Path, Failure> {
    let problem = || format!("{} is not a folder; name the one that `coulter run` wrote", path.display());
    if path.is_dir() { Ok(path) } else { Err(Failure::Request(problem())) }
}

/// Prints to standard output, as everything of this command that is for people, shells or programs. A reader
/// that has closed the pipe (`| head`) is not an error.
pub(super) fn say(text: &str) -> Result<(), Failure> {
    let mut out = std::io::stdout().lock();
    match out.write_all(plain(text).as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(Failure::Request(format!("cannot write to standard output: {error}")))
        }
        _ => Ok(()),
    }
}

/// The overrides of a case, with the one that `--accept-drained` stands for.
pub(super) fn overrides(given: &[String], accept_drained: bool) -> Vec<String> {
    let accepted = accept_drained.then(|| "water.accept_drained=true".to_owned());
    given.iter().cloned().chain(accepted).collect()
}

/// Refuses a number outside the range that the command line allows for it, whoever asks.
pub(super) fn require_range<N: PartialOrd + Display>(
    name: &str,
    number: Option<N>,
    allowed: RangeInclusive<N>,
) -> Result<(), Failure> {
    match number {
        Some(number) if !allowed.contains(&number) => {
            let (least, most) = allowed.into_inner();
            Err(Failure::Request(format!("{name} = {number}: it must be from {least} to {most}")))
        }
        _ => Ok(()),
    }
}

/// Refuses a file where a results folder is expected.
pub(super) fn refuse_file(folder: &Path) -> Result<(), Failure> {
    if !folder.exists() || folder.is_dir() {
        return Ok(());
    }
    let shown = folder.display();
    Err(Failure::Request(format!(
        "{shown} is a file, not a folder; name a folder for the results with -o DIR"
    )))
}

/// Prints one JSON document.
pub(super) fn say_json(value: &impl serde::Serialize) -> Result<(), Failure> {
    let text = serde_json::to_string_pretty(value).map_err(|e| Failure::Request(e.to_string()))?;
    say(&format!("{text}\n"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_budget_is_a_time_or_a_multiple() {
        assert_eq!(budget("20 min"), Ok(Budget::Seconds(1200.0)));
        assert_eq!(budget("30min"), Ok(Budget::Seconds(1800.0)));
        for text in ["4", "4x", "4 times"] {
            assert_eq!(budget(text), Ok(Budget::Times(4.0)), "{text}");
        }
        assert!(budget("-1 s").is_err() && budget("soon").unwrap_err().contains("20 min"));
        assert_eq!(error_source("domain"), Ok(ErrorSource::Domain));
        assert!(error_source("statistics").unwrap_err().contains("mesh, domain, speed, precision"));
    }
}
