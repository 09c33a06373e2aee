//! What the targets share: a folder for readers that take a path, a small run, and how errors are shown.

use coulter::case::{self, Case, CaseError};
use coulter::history::History;
use coulter::interrupts::Interrupts;
use coulter::run::{End, Follower, NoFollower, RunError, RunOptions, Start, run_followed};
use coulter::simulation::Next;
use miette::GraphicalReportHandler;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

/// The folder of this process, which `scripts/fuzz` makes; the files that cases and studies may name are
/// copied into it.
pub fn folder() -> &'static Path {
    static FOLDER: OnceLock<PathBuf> = OnceLock::new();
    FOLDER.get_or_init(|| {
        let top = std::env::var_os("COULTER_FUZZ_FOLDER").map_or_else(std::env::temp_dir, PathBuf::from);
        let own = top.join(format!("own-{}", std::process::id()));
        fs::create_dir_all(&own).expect("the folder can be made");
        for entry in fs::read_dir(top.join("files")).into_iter().flatten().flatten() {
            fs::copy(entry.path(), own.join(entry.file_name())).expect("the file can be copied");
        }
        own
    })
}

/// A file with these bytes in the folder.
pub fn file(name: &str, bytes: &[u8]) -> PathBuf {
    let path = folder().join(name);
    fs::write(&path, bytes).expect("the file can be written");
    path
}

/// A sound input from which the fuzzer is to begin, if it has not begun yet.
pub fn seed(name: &str, bytes: &[u8]) {
    if let Some(folder) = std::env::var_os("COULTER_FUZZ_SEEDS") {
        fs::write(Path::new(&folder).join(name), bytes).expect("the seed can be written");
    }
}

/// Shows an error as the command does.
pub fn show(error: &CaseError) {
    assert!(!error.problems.is_empty(), "refused without a reason");
    for problem in &error.problems {
        let mut shown = String::new();
        GraphicalReportHandler::new().render_report(&mut shown, problem).expect("it can be shown");
    }
}

/// A small case: a block that is pressed into a box of soil.
pub const CASE: &str = include_str!("small.toml");

/// Runs the small case in a folder, or resumes it from there; with `stops` to its first sample.
pub fn run_small(top: &Path, start: Start, stops: bool) -> Result<End, RunError> {
    static SMALL: OnceLock<Case> = OnceLock::new();
    let case = SMALL.get_or_init(|| case::parse(CASE, "small.toml", &[]).expect("the case is valid"));
    let interrupts = Interrupts::default();
    let options = RunOptions::quiet(top, start, CASE, "small.toml", &interrupts);
    if stops { run_followed(case, &options, &mut Stopping) } else { run_followed(case, &options, &mut NoFollower) }
}

struct Stopping;

impl Follower for Stopping {
    fn sampled(&mut self, _: &History) -> Next {
        Next::Stop("as the target asks".to_owned())
    }
}

/// Files by their names in a folder.
pub type Files = BTreeMap<String, Vec<u8>>;

/// Those of a folder, but for pictures and pages.
pub fn files(top: &Path) -> Files {
    let mut found = Files::new();
    let mut folders = vec![String::new()];
    while let Some(inner) = folders.pop() {
        for entry in fs::read_dir(top.join(&inner)).expect("the folder can be read").flatten() {
            let name = format!("{inner}{}", entry.file_name().to_string_lossy());
            match entry.path().is_dir() {
                _ if ["pictures", "plots", "report.html"].contains(&name.as_str()) => {}
                true => folders.push(format!("{name}/")),
                false => drop(found.insert(name, fs::read(entry.path()).expect("it can be read"))),
            }
        }
    }
    found
}

/// Makes a folder of these files alone, one of them with another content.
pub fn lay(top: &Path, files: &Files, (changed, other): (&str, &[u8])) {
    let _ = fs::remove_dir_all(top);
    for (name, content) in files {
        let path = top.join(name);
        fs::create_dir_all(path.parent().expect("it is in a folder")).expect("the folder can be made");
        fs::write(path, if name == changed { other } else { content }).expect("it can be written");
    }
}
