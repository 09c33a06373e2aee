//! `--device` through the binary: the same bits of whatever is run, and refusals that leave nothing behind.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use assert_cmd::Command;
use serde_json::Value;
use std::path::{Path, PathBuf};

fn case() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/column_collapse.toml")
}

fn run(folder: &Path, arguments: &[&str]) -> assert_cmd::assert::Assert {
    let mut command = Command::cargo_bin("coulter").unwrap();
    command.arg("run").arg(case()).arg("-o").arg(folder).args(["--set", "grid.cell=30 mm"]);
    command.args(["--set", "run.duration=0.3 s"]).args(arguments).assert()
}

#[test]
fn a_checkpoint_is_the_same_wherever_the_soil_was_strained() {
    let folder = tempfile::tempdir().unwrap();
    let checkpoint = |name: &str, device: &str| {
        let folder = folder.path().join(name);
        run(&folder, &["--device", device]).success();
        std::fs::read(folder.join("checkpoints/last.checkpoint")).unwrap()
    };
    assert!(checkpoint("there", "stand-in") == checkpoint("here", "cpu"));
}

/// A disc on a few cells, that is towed for a moment.
const MOMENT: [&str; 5] = [
    "grid.cell=25 mm",
    "run.tow_distance=6 mm",
    "body.disc.forward={ speed = \"0.2 m/s\", start = \"0 s\", ramp = \"0.02 s\" }",
    "body.disc.heave={ load = \"0 N\", start = \"0 s\", ramp = \"0.02 s\" }",
    "output.history_interval=1 ms",
];

/// Short runs of the disc.
const STUDY: &str = r#"format = 2
case = "disc.toml"
[factor.phi]
key = "soil.friction_angle"
values = ["30 deg", "35 deg"]
[part.runs]
models = "solver"
[part.runs.set]
"grid.cell" = "25 mm"
"run.tow_distance" = "6 mm"
"body.disc.forward" = { speed = "0.2 m/s", start = "0 s", ramp = "0.02 s" }
"output.history_interval" = "1 ms"
"#;

/// A folder with a disc, a study of it, and a measured curve; and what commands do there.
struct Desk(tempfile::TempDir);

impl Desk {
    fn new() -> Self {
        let desk = tempfile::tempdir().unwrap();
        let write = |name: &str, text: &str| std::fs::write(desk.path().join(name), text).unwrap();
        write("disc.toml", include_str!("../../../cases/light_disc.toml"));
        write("study.toml", STUDY);
        write("measured.csv", "displacement [mm],drag [N]\n3,5\n4,6\n5,7\n");
        Self(desk)
    }

    /// Exit code, and what was printed on either output.
    fn coulter(&self, arguments: &[&str]) -> (Option<i32>, String) {
        let mut command = Command::cargo_bin("coulter").unwrap();
        let output = command.current_dir(self.0.path()).args(arguments).output().unwrap();
        let said = [output.stdout, output.stderr].concat();
        (output.status.code(), String::from_utf8_lossy(&said).into_owned())
    }

    /// With the disc that is towed for a moment.
    fn moment(&self, arguments: &[&str]) {
        let set = MOMENT.iter().flat_map(|key| ["--set", key]);
        let (code, said) = self.coulter(&arguments.iter().copied().chain(set).collect::<Vec<_>>());
        assert_eq!(code, Some(0), "{said}");
    }

    fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.0.path().join(name)).unwrap()
    }

    /// Whether the log of a run says that the stand-in strained the soil.
    fn is_on_stand_in(&self, run: &str) -> bool {
        self.read(&format!("{run}/run.log")).contains("in place of a graphics card")
    }

    fn names(&self, folder: &str) -> Vec<String> {
        let entries = std::fs::read_dir(self.0.path().join(folder)).unwrap();
        let mut names: Vec<String> =
            entries.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }
}

#[test]
fn a_study_is_the_same_wherever_the_soil_was_strained() {
    let desk = Desk::new();
    for (folder, device) in [("here", "cpu"), ("there", "stand-in")] {
        let arguments = ["sweep", "study.toml", "-o", folder, "--workers", "2", "--device", device];
        let (code, said) = desk.coulter(&arguments);
        assert_eq!(code, Some(0), "{said}");
        let runs = desk.names(&format!("{folder}/runs"));
        assert_eq!(runs.len(), 2, "{runs:?}");
        let on_stand_in = |run: &String| desk.is_on_stand_in(&format!("{folder}/runs/{run}"));
        assert!(runs.iter().all(|run| on_stand_in(run) == (device == "stand-in")));
    }
    assert_eq!(desk.read("here/table.csv"), desk.read("there/table.csv"));
    desk.coulter(&["sweep", "expand", "study.toml", "-o", "left"]);
    for engine in ["parallel", "slurm", "hyperqueue", "snakemake"] {
        let (code, said) = desk.coulter(&["sweep", "script", "left", "--for", engine, "--device", "gpu:1"]);
        assert!(code == Some(0) && said.contains("--threads 1 --device gpu:1 --id"), "{said}");
        // A job counts the cards that it sees from 0.
        assert_eq!(said.contains("#SBATCH --gres=gpu:2\n"), engine == "slurm", "{said}");
    }
}

#[test]
fn intervals_and_calibrations_are_the_same_wherever_the_soil_was_strained() {
    let desk = Desk::new();
    let found = |device: &str| {
        let run = format!("{device}-run");
        desk.moment(&["run", "disc.toml", "-o", &run, "--meshes", "2", "--device", device]);
        let variations = desk.names(&format!("{run}/variations"));
        let variations = variations.iter().map(|name| format!("{run}/variations/{name}"));
        let runs: Vec<String> = variations.chain([run.clone()]).collect();
        assert!(runs.len() > 1 && runs.iter().all(|run| desk.is_on_stand_in(run) == (device == "stand-in")));
        let words = "disc.toml measured.csv --model solver --budget 8 --samples 100 --device";
        let words: Vec<&str> = ["calibrate"].into_iter().chain(words.split(' ')).collect();
        let calibration = format!("{device}-calibration");
        let more = [device, "-o", &calibration, "--parameter", "soil.friction_angle=28..42 deg"];
        desk.moment(&[words, more.to_vec()].concat());
        for run in desk.names(&format!("{calibration}/runs")) {
            assert_eq!(desk.is_on_stand_in(&format!("{calibration}/runs/{run}")), device == "stand-in");
        }
        let summary: Value = serde_json::from_str(&desk.read(&format!("{run}/summary.json"))).unwrap();
        (summary["confidence"]["bodies"].clone(), desk.read(&format!("{calibration}/calibrated.toml")))
    };
    assert_eq!(found("stand-in"), found("cpu"));
}

#[test]
fn a_device_that_is_not_there_is_refused_before_anything_is_written() {
    let desk = Desk::new();
    let before = desk.names("");
    let commands = [
        "run disc.toml",
        "run disc.toml --confidence",
        "run disc.toml --accuracy 5%",
        "sweep study.toml",
        "calibrate disc.toml measured.csv --parameter soil.friction_angle=28..42deg",
        "bench",
    ];
    for command in commands {
        // No machine has so many cards.
        let words = command.split(' ').chain(["--device", "gpu:4000000000"]);
        let (code, said) = desk.coulter(&words.collect::<Vec<_>>());
        assert!(code == Some(2) && said.contains("--device: "), "{command}: {said}");
        let words = command.split(' ').chain(["--device", "card"]);
        let (code, said) = desk.coulter(&words.collect::<Vec<_>>());
        assert!(code == Some(2) && said.contains("gpu:N"), "{command}: {said}");
        assert_eq!(desk.names(""), before, "{command}");
    }
}

#[test]
fn a_check_says_what_a_case_takes_on_a_device() {
    let desk = Desk::new();
    let check = |more: &[&str]| {
        let (_, said) = desk.coulter(&[&["check", "disc.toml", "--untimed", "--json"], more].concat());
        serde_json::from_str::<Value>(&said).unwrap_or_else(|_| panic!("{said}"))["device"].clone()
    };
    assert_eq!(check(&[]), Value::Null);
    let on_stand_in = check(&["--device", "stand-in"]);
    assert_eq!(on_stand_in["runs"], true, "{on_stand_in}");
    assert!(on_stand_in["memory_bytes"].as_f64().unwrap() > 1e6);
    assert_eq!(check(&["--device", "gpu:4000000000"])["runs"], false);
}

#[test]
fn the_bench_of_a_device_compares_all_bits() {
    let arguments = ["bench", "--device", "stand-in", "--warm-up", "100", "--steps", "50", "--json"];
    let output = Command::cargo_bin("coulter").unwrap().args(arguments).output().unwrap();
    let measured: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(measured["same_bits"], true, "{measured:#}");
    assert!(measured["million_cell_steps_per_second"].as_f64().unwrap() > 0.0);
}

#[test]
fn what_a_device_cannot_do_is_refused_and_leaves_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let results = folder.path().join("results");
    let water = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation/W2_wall_under_water/case.toml");
    let mut command = Command::cargo_bin("coulter").unwrap();
    command.arg("run").arg(water).arg("-o").arg(&results).args(["--device", "stand-in"]);
    let refused = command.assert().failure();
    let said = String::from_utf8_lossy(&refused.get_output().stderr).into_owned();
    assert!(said.contains("pore water"), "{said}");
    assert!(!results.exists());
}
