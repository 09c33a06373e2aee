//! `--device` through the binary: the same bits, and refusals that leave nothing behind.
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
    run(&results, &["--device", "card"]).code(2);
    // No machine has so many cards.
    let refused = run(&results, &["--device", "gpu:4000000000"]).failure();
    let said = String::from_utf8_lossy(&refused.get_output().stderr).into_owned();
    assert!(said.contains("--device: "), "{said}");
    let water = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation/W2_wall_under_water/case.toml");
    let mut command = Command::cargo_bin("coulter").unwrap();
    command.arg("run").arg(water).arg("-o").arg(&results).args(["--device", "stand-in"]);
    let refused = command.assert().failure();
    let said = String::from_utf8_lossy(&refused.get_output().stderr).into_owned();
    assert!(said.contains("pore water"), "{said}");
    assert!(!results.exists());
}
