//! What several commands share: printing to standard output, and checks of arguments.

use crate::failure::Failure;
use clap::builder::TypedValueParser as _;
use coulter::case::meshes::COUNTS;
use std::io::Write;
use std::path::Path;

/// The allowed numbers of threads.
pub(super) fn threads() -> clap::builder::RangedI64ValueParser<u16> {
    clap::value_parser!(u16).range(0..=solver::cpu::threads::MAX_WORKERS as i64)
}

/// The allowed numbers of meshes.
pub(super) fn meshes() -> impl clap::builder::TypedValueParser<Value = usize> {
    let (least, most) = (*COUNTS.start() as u64, *COUNTS.end() as u64);
    clap::value_parser!(u64).range(least..=most).map(|count| usize::try_from(count).unwrap_or(*COUNTS.end()))
}

/// Prints to standard output. A reader that has closed the pipe (`| head`) is not an error.
pub(super) fn say(text: &str) -> Result<(), Failure> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
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
