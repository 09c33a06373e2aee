//! `coulter calibrate`: soil and contact parameters from measured curves.

use crate::common::{default_threads, refuse_file, require_device, say, say_json};
use crate::failure::Failure;
use crate::signals;
use coulter::case;
use coulter::interrupts::Interrupts;
use coulter::output::Inside;
use std::path::{Path, PathBuf};
use studies::calibration::{
    Calibration, CalibrationError, ModelChoice, Request, calibrate, document, page, runs_csv, samples_csv,
    text,
};
use studies::files;

mod options;

pub(super) use options::{Arguments, quantity_named, window};

/// The file that holds the result.
const RESULT: &str = "calibration.json";

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let interrupts = signals::listen();
    let folder = arguments.output.clone().unwrap_or_else(|| default_folder(&arguments.case));
    refuse_file(&folder)?;
    require_device(arguments.on.device)?;
    let runs = files::folder(&Inside::of(&folder, "runs"));
    let runs = runs.map_err(|error| Failure::Request(error.to_string()))?;
    let request = arguments.request(&runs)?;
    let identity = arguments.identity(&request)?;
    refuse_other(arguments, &folder, &identity)?;
    if !matches!(request.model, ModelChoice::ClosedForm) {
        default_threads(request.threads.unwrap_or_default());
    }
    let mut tell = |line: &str| {
        if !arguments.json {
            crate::common::tell(line);
        }
    };
    let calibration = calibrated(&request, &interrupts, &mut tell, &folder)?;
    let mut value = document(&request, &calibration);
    value["request"] = serde_json::Value::String(identity);
    let written = write(arguments, &request, &calibration, &value, &folder)?;
    if arguments.json {
        return say_json(&value);
    }
    let list: Vec<String> = written.iter().map(|path| path.display().to_string()).collect();
    say(&format!("{}\nwrote {}\n", text(&calibration), list.join("\n      ")))
}

fn calibrated(
    request: &Request<'_>,
    interrupts: &Interrupts,
    tell: &mut dyn FnMut(&str),
    folder: &Path,
) -> Result<Calibration, Failure> {
    calibrate(request, interrupts, tell).map_err(|error| match error {
        CalibrationError::Case(error) => Failure::Case(error),
        CalibrationError::Request(why) => Failure::Request(why),
        CalibrationError::Stopped(signal) => Failure::Stopped {
            signal,
            message: format!("stopped; the same command goes on from the runs in {}", folder.display()),
        },
    })
}

fn default_folder(case: &Path) -> PathBuf {
    let stem = case.file_stem().map_or_else(|| "case".into(), |stem| stem.to_string_lossy().into_owned());
    PathBuf::from("results").join(format!("{stem}-calibration"))
}

/// Refuses a folder that holds the calibration of another request.
fn refuse_other(arguments: &Arguments, folder: &Path, identity: &str) -> Result<(), Failure> {
    let result = Inside::of(folder, RESULT);
    if arguments.force || !result.exists() {
        return Ok(());
    }
    let content =
        files::read_inside(&result, 1 << 28).map_err(|error| Failure::Request(error.to_string()))?;
    let known: Option<serde_json::Value> = serde_json::from_slice(&content).ok();
    if known.is_some_and(|value| value["request"] == identity) {
        return Ok(());
    }
    Err(Failure::Request(format!(
        "{} holds the calibration of another request; use --force to replace it (runs stay), or another folder with -o DIR",
        folder.display()
    )))
}

fn write(
    arguments: &Arguments,
    request: &Request<'_>,
    calibration: &Calibration,
    document: &serde_json::Value,
    folder: &Path,
) -> Result<Vec<PathBuf>, Failure> {
    let fail = |error: &dyn std::fmt::Display| Failure::Request(error.to_string());
    let mut contents = vec![
        (RESULT, serde_json::to_string_pretty(document).map_err(|error| fail(&error))? + "\n"),
        ("calibration.html", page(request, calibration).map_err(|error| fail(&error))?),
    ];
    if let Some(stage) = calibration.last() {
        let found = request.space.overrides(&stage.best).map_err(|error| fail(&error))?;
        let all = [&arguments.overrides[..], &found].concat();
        let typed = case::text(&arguments.case)?;
        let name = arguments.case.display().to_string();
        contents.push(("calibrated.toml", case::overridden(&typed, &name, &all)?));
        contents.push(("samples.csv", samples_csv(stage)));
    }
    if let Some(solver) = &calibration.solver {
        contents.push(("runs.csv", runs_csv(request, &solver.points)));
    }
    files::make_folder(&Inside::of(folder, "")).map_err(|error| fail(&error))?;
    let mut written = Vec::new();
    for (name, content) in contents {
        let file = Inside::of(folder, name);
        files::write(&file, content.as_bytes()).map_err(|error| fail(&error))?;
        written.push(file.path());
    }
    Ok(written)
}
