//! The invariants of ARCHITECTURE.md that can be checked: who may do what, and that neither threads nor a
//! restart change a bit.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use coulter::case::{self, Case};
use coulter::output::checkpoint::Checkpoint;
use coulter::simulation::Simulation;
use solver::precision::Precision;
use std::path::{Path, PathBuf};

const FILES: [&str; 3] = ["std::fs", "fs::", "File::"];
const THREADS: [&str; 2] = ["std::thread", "thread::"];
/// The crates that compute and know no case.
const FORMULAS: [&str; 7] = ["numerics", "geometry", "physics", "kernels", "mechanics", "solver", "analytic"];
const PRINTING: [&str; 6] = ["println!", "print!(", "dbg!(", "io::stdout", "io::stderr", "io::Write"];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Every source file of a crate: its path below `src`, with slashes, and its text without comments.
fn sources(name: &str) -> Vec<(String, String)> {
    let top = root().join("crates").join(name).join("src");
    let mut found = Vec::new();
    let mut folders = vec![top.clone()];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "rs") {
                let below = path.strip_prefix(&top).unwrap().to_string_lossy().replace('\\', "/");
                let text = std::fs::read_to_string(&path).unwrap();
                let code = text.lines().filter(|l| !l.trim_start().starts_with("//")).collect::<Vec<_>>();
                found.push((below, code.join("\n")));
            }
        }
    }
    assert!(!found.is_empty(), "{name} has no sources");
    found
}

/// The files of a crate that use one of these words, except those that may.
fn offenders(name: &str, words: &[&str], may: impl Fn(&str) -> bool) -> Vec<String> {
    // A word is none within a longer one, such as `TableFile::`.
    let stands = |code: &str, word: &str| {
        code.match_indices(word)
            .any(|(at, _)| !code[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_'))
    };
    let uses = |code: &str| words.iter().find(|word| stands(code, word)).copied();
    sources(name)
        .iter()
        .filter(|(path, _)| !may(path))
        .filter_map(|(path, code)| uses(code).map(|word| format!("crates/{name}/src/{path}: {word}")))
        .collect()
}

fn nobody(_: &str) -> bool {
    false
}

/// Names of the packages that a crate depends on, tests and build included.
fn dependencies(name: &str) -> Vec<String> {
    let text = std::fs::read_to_string(root().join("crates").join(name).join("Cargo.toml")).unwrap();
    let manifest: toml::Table = text.parse().unwrap();
    ["dependencies", "dev-dependencies", "build-dependencies"]
        .iter()
        .filter_map(|table| manifest.get(*table)?.as_table())
        .flat_map(|table| table.keys().map(|key| key.trim_start_matches("coulter-").to_owned()))
        .collect()
}

/// Every crate of the workspace, those below first, with those that it may depend on.
const ARROWS: [(&str, &[&str]); 20] = [
    ("machine", &[]),
    ("numerics", &[]),
    ("geometry", &[]),
    ("physics", &[]),
    ("kernels", &["physics"]),
    ("mechanics", &["numerics"]),
    ("solver", &["geometry", "physics", "kernels", "mechanics"]),
    ("analytic", &["numerics"]),
    ("deck", &[]),
    ("input", &["geometry", "mechanics"]),
    ("case", &["machine", "geometry", "physics", "mechanics", "solver", "analytic", "input"]),
    ("results", &["geometry", "physics", "mechanics", "solver", "analytic", "input", "case"]),
    ("report", &["geometry", "mechanics", "solver", "input", "case", "results"]),
    (
        "coulter",
        &["geometry", "physics", "mechanics", "solver", "analytic", "input", "case", "results", "report"],
    ),
    ("studies", &["numerics", "analytic", "coulter"]),
    ("verification", &["geometry", "physics", "mechanics", "solver", "analytic", "coulter"]),
    ("fmu", &["coulter"]),
    ("import", &["deck", "coulter"]),
    ("cli", &["solver", "analytic", "deck", "coulter", "studies", "verification", "fmu", "import"]),
    ("python", &["analytic", "coulter", "studies", "cli"]),
];

#[test]
fn the_arrows_between_the_crates_hold() {
    for (place, (name, allowed)) in ARROWS.into_iter().enumerate() {
        let is_below = |other: &&str| ARROWS[..place].iter().any(|(below, _)| below == other);
        assert!(allowed.iter().all(is_below), "an arrow of {name} leads upwards");
        for other in dependencies(name).iter().filter(|other| ARROWS.iter().any(|(name, _)| name == other)) {
            assert!(allowed.contains(&other.as_str()), "{name} must not depend on {other}");
        }
    }
}

#[test]
fn no_crate_is_left_out() {
    let folders = std::fs::read_dir(root().join("crates")).unwrap();
    let names = folders.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned());
    let unknown: Vec<String> = names.filter(|name| ARROWS.iter().all(|(known, _)| known != name)).collect();
    assert!(unknown.is_empty(), "{unknown:?}");
}

#[test]
fn below_the_public_api_nothing_touches_files_or_prints() {
    for name in FORMULAS {
        let found = offenders(name, &[&FILES[..], &PRINTING].concat(), nobody);
        assert!(found.is_empty(), "{found:#?}");
    }
}

#[test]
fn one_file_starts_threads_and_few_are_unsafe() {
    for name in FORMULAS {
        let threads = |path: &str| name == "solver" && path == "cpu/threads.rs";
        let found = offenders(name, &THREADS, threads);
        assert!(found.is_empty(), "{found:#?}");
        // MPI reads and writes memory while a process computes; a device knows arrays by their addresses.
        let may = |path: &str| match name {
            "solver" => {
                threads(path)
                    || path.starts_with("device/")
                    || matches!(path, "halo/mpi.rs" | "cpu/kernels/addresses.rs")
            }
            "kernels" => matches!(path, "device.rs" | "device_remap.rs" | "device_run.rs"),
            _ => false,
        };
        let found = offenders(name, &["unsafe"], may);
        assert!(found.is_empty(), "{found:#?}");
    }
    for name in [
        "deck",
        "input",
        "case",
        "results",
        "report",
        "coulter",
        "studies",
        "verification",
        "fmu",
        "import",
        "cli",
        "python",
    ] {
        let may = |path: &str| match name {
            "coulter" => path == "session.rs",
            "studies" => path == "sweep/pool.rs",
            // The functions of the interface take pointers.
            "fmu" => path == "c_api.rs",
            // What an allocator and a signal handler must do is unsafe.
            "cli" => matches!(path, "allocator.rs" | "signals.rs"),
            "python" => matches!(path, "attend.rs" | "pool.rs"),
            _ => false,
        };
        let found = offenders(name, &["thread::spawn", "thread::scope", "unsafe"], may);
        assert!(found.is_empty(), "{found:#?}");
    }
}

#[test]
fn above_the_solver_few_touch_files_and_fewer_print() {
    // `repeat` removes its checkpoint; `signals` reads what the system ignores.
    let may_touch: [(&str, &[&str]); 13] = [
        ("deck", &["folder.rs"]),
        ("import", &[]),
        ("input", &["data_file.rs", "motion_table.rs", "mesh_file/mod.rs", "height_file/tests.rs"]),
        ("machine", &["cores.rs", "memory.rs"]),
        ("case", &["documentation.rs", "load.rs"]),
        // Tests of checkpoints write some of their own.
        ("results", &["checkpoint/layout.rs", "checkpoint/read.rs", "files/", "folder/", "tables/csv.rs"]),
        ("report", &[]),
        ("coulter", &[]),
        ("studies", &["files.rs"]),
        ("verification", &["cache.rs", "document.rs", "repeat.rs"]),
        ("fmu", &["package.rs"]),
        ("cli", &["import.rs", "new.rs", "signals.rs"]),
        ("python", &[]),
    ];
    for (name, places) in may_touch {
        let found = offenders(name, &FILES, |path| places.iter().any(|place| path.starts_with(place)));
        assert!(found.is_empty(), "{found:#?}");
    }
    let found = offenders("results", &PRINTING[..5], |path| path == "progress.rs");
    assert!(found.is_empty(), "{found:#?}");
    for name in
        ["deck", "input", "case", "report", "coulter", "studies", "verification", "fmu", "import", "python"]
    {
        let found = offenders(name, &PRINTING[..5], nobody);
        assert!(found.is_empty(), "{found:#?}");
    }
    // Of the command these alone print, and show what would act on a terminal.
    let may = |path: &str| matches!(path, "common.rs" | "failure.rs" | "allocator.rs");
    let found = offenders("cli", &PRINTING[..5], may);
    assert!(found.is_empty(), "{found:#?}");
}

/// Words that open, make, move or remove an entry of a folder by its path, and follow a link there.
const CHANGES: [&str; 9] = [
    "File::create",
    "File::options",
    "OpenOptions",
    "fs::write",
    "fs::rename",
    "fs::remove",
    "fs::copy",
    "fs::hard_link",
    "create_dir",
];
const LOOKS: [&str; 6] = ["File::open", "fs::read", "read_dir", "fs::metadata", "canonicalize", "is_symlink"];

/// Folders of results and studies come from others: what is in them is reached through `Inside` alone, which
/// follows no link.
#[test]
fn one_place_opens_what_is_in_a_folder() {
    let here = |path: &str| path.starts_with("files/inside/");
    for name in
        ["deck", "input", "case", "results", "report", "coulter", "studies", "import", "cli", "python"]
    {
        // `new` and `import` write the files that their user names.
        let may = |path: &str| {
            name == "results" && here(path) || name == "cli" && ["import.rs", "new.rs"].contains(&path)
        };
        let found = used_by(name, &CHANGES, may);
        assert!(found.is_empty(), "{found:#?}");
    }
    // `io` copies the files that a case names, `files` reads those that the command line names.
    let of_results = |path: &str| here(path) || path == "files/io.rs";
    assert_eq!(used_by("results", &LOOKS, of_results), Vec::<String>::new());
    assert_eq!(used_by("report", &LOOKS, nobody), Vec::<String>::new());
    assert_eq!(used_by("studies", &LOOKS, |path| path == "files.rs"), Vec::<String>::new());
}

/// As [`offenders`], without what only tests do.
fn used_by(name: &str, words: &[&str], may: impl Fn(&str) -> bool) -> Vec<String> {
    let own = |code: &str| code.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default().to_owned();
    let code = sources(name).into_iter().map(|(path, code)| (path, own(&code)));
    let is_test = |path: &str| path.ends_with("/tests.rs") || path.ends_with("documentation.rs");
    code.filter(|(path, _)| !may(path) && !is_test(path))
        .filter_map(|(path, code)| {
            let is_whole = |at: usize| !code[..at].ends_with(char::is_alphanumeric);
            let is_used = |word: &str| code.match_indices(word).any(|(at, _)| is_whole(at));
            let word = words.iter().find(|word| is_used(word))?;
            Some(format!("crates/{name}/src/{path}: {word}"))
        })
        .collect()
}

/// The towed disc on a coarse grid, in the soil from the start, for a few hundred steps.
fn short_tow(contact: &str, threads: usize) -> Case {
    let overrides = [
        "grid.cell=\"25 mm\"",
        "body.disc.sinkage=\"10 mm\"",
        "body.disc.forward={ speed = \"0.2 m/s\", ramp = \"0.02 s\" }",
        "body.disc.heave={ load = \"0 N\", ramp = \"0.02 s\" }",
        "run.tow_distance=\"8 mm\"",
        "output.history_interval=\"5 ms\"",
    ];
    let mut overrides: Vec<String> = overrides.iter().map(|o| (*o).to_owned()).collect();
    overrides.push(format!("numerics.contact=\"{contact}\""));
    let mut case = case::load(&root().join("cases/light_disc.toml"), &overrides).unwrap();
    case.numerics.threads = threads;
    case
}

/// State and history to the bit.
fn bits(simulation: &Simulation<impl Precision>) -> Vec<u8> {
    postcard::to_stdvec(&(&simulation.state, &simulation.history)).unwrap()
}

fn to_the_end<R: Precision>(mut simulation: Simulation<R>) -> Simulation<R> {
    while !simulation.is_done() {
        simulation.advance().unwrap();
    }
    assert!(simulation.state.remaps > 1, "the soil must have been remapped");
    simulation
}

fn threads_change_no_bit<R: Precision>(contact: &str) {
    let alone = bits(&to_the_end(Simulation::<R>::new(&short_tow(contact, 1))));
    for threads in [2, 3] {
        let team = to_the_end(Simulation::<R>::new(&short_tow(contact, threads)));
        assert_eq!(team.threads(), threads);
        assert!(bits(&team) == alone, "{contact}: {threads} threads differ from one");
    }
}

/// So many threads that each has the least number of rows.
#[test]
fn many_threads_change_no_bit() {
    let [few, many] = [1, 64].map(|n| to_the_end(Simulation::<f64>::new(&short_tow("impulse", n))));
    assert!((4..64).contains(&many.threads()), "{} threads", many.threads());
    assert!(bits(&many) == bits(&few), "{} threads differ from one", many.threads());
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    threads_change_no_bit::<f64>("penalty");
    threads_change_no_bit::<f64>("impulse");
    threads_change_no_bit::<f32>("impulse");
}

/// A run, stopped and resumed; leaves its checkpoint in the folder.
fn restart_changes_no_bit<R: Precision>(contact: &str, folder: &Path) {
    let case = short_tow(contact, 1);
    let mut whole = Simulation::<R>::new(&case);
    for _ in 0..5 {
        whole.advance().unwrap();
    }
    whole.checkpoint().write(folder).unwrap();
    let whole = to_the_end(whole);
    let resumed = Simulation::<R>::resume(&case, Checkpoint::read(folder, &whole.model.grid).unwrap().0, 0.0);
    assert!(resumed.state.step > 0 && resumed.state.step < whole.state.step);
    assert!(bits(&to_the_end(resumed)) == bits(&whole), "{contact}: the resumed run differs");
}

#[test]
fn a_restart_changes_no_bit() {
    let folder = tempfile::tempdir().unwrap();
    restart_changes_no_bit::<f64>("penalty", folder.path());
    restart_changes_no_bit::<f64>("impulse", folder.path());
    restart_changes_no_bit::<f32>("impulse", folder.path());
    coulter::output::checkpoint::forget_previous(folder.path()).unwrap();
    let grid = Simulation::<f64>::new(&short_tow("impulse", 1)).model.grid;
    let other = Checkpoint::<f64>::read(folder.path(), &grid).map(|_| ()).unwrap_err().to_string();
    assert!(other.contains("in single precision, the case asks for double"), "{other}");
}

/// A library's functions may differ in their last bit from one system to the next: what changes a field in a
/// step or a remap does so by arithmetic and square roots. Of the laws, whose constructors call some,
/// `scripts/ptx` shows it.
#[test]
fn fields_come_from_arithmetic_alone() {
    const FUNCTIONS: [&str; 14] = [
        "sin(", "cos(", "sin_cos(", "tan(", "acos(", "asin(", "atan(", "atan2(", "exp(", "ln(", "powf(",
        "powi(", "cbrt(", "hypot(",
    ];
    const LAWS: [&str; 4] = ["clay.rs", "menetrey_willam.rs", "mohr_coulomb.rs", "sand.rs"];
    for (name, below) in [("kernels", ""), ("solver", "cpu/kernels/"), ("physics", "")] {
        let changes_fields =
            |path: &str| path.starts_with(below) && path != "exact_sum.rs" && !LAWS.contains(&path);
        for (path, code) in sources(name).iter().filter(|(path, _)| changes_fields(path)) {
            let code = &code[..code.find("#[cfg(test)]").unwrap_or(code.len())];
            let calls =
                |word: &&&str| code.match_indices(**word).any(|(at, _)| code[..at].ends_with(['.', ':']));
            let called = FUNCTIONS.iter().find(calls);
            assert!(called.is_none(), "crates/{name}/src/{path}: {called:?}");
        }
    }
}
