//! `coulter bench` through the binary: its output, and ratios within one run that no change may spoil.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use assert_cmd::Command;
use serde_json::Value;

fn measured(arguments: &[&str]) -> Value {
    let output =
        Command::cargo_bin("coulter").unwrap().args(["bench", "--json"]).args(arguments).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

/// Loops that are no longer vectorised, or a stage that has become several times slower than the others, show
/// in ratios within one run, on any machine and at any load.
#[test]
fn the_stages_keep_their_proportions() {
    let m = measured(&["--warm-up", "200", "--steps", "400", "--threads", "2"]);
    let number = |path: &str| m.pointer(path).and_then(Value::as_f64).unwrap_or(f64::NAN);
    let share = |stage: &str| number(&format!("/split/{stage}"));
    let sum: f64 = ["lagrange", "plasticity", "nodes", "remap", "contact", "other"].map(share).iter().sum();
    assert!((sum - 1.0).abs() < 1e-9, "{m:#}");
    assert!(number("/filled_cells") > 20e3 && number("/million_cell_steps_per_core_second") > 0.0, "{m:#}");
    // Measured: 232 on this small grid, where ghosts and the body's surface weigh most.
    assert!(number("/bytes_per_cell") < 240.0, "{m:#}");
    // Measured: 7 to 20 % of the multiply-adds that the machine can do; 2 % without vectors.
    assert!(number("/achieved_GFLOP_per_s/lagrange") > 0.03 * number("/fma_GFLOP_per_s"), "{m:#}");
    // Measured: 0.4 to 0.5, 0.6 to 0.8 and 0.3 to 0.5 of the Lagrangian stage.
    for (stage, bound) in [("plasticity", 1.0), ("nodes", 1.5), ("remap", 1.0)] {
        assert!(share(stage) < bound * share("lagrange"), "{stage}: {m:#}");
    }
}

#[test]
fn a_bench_of_nonsense_is_refused() {
    let refused = |arguments: &[&str]| {
        Command::cargo_bin("coulter").unwrap().arg("bench").args(arguments).assert().code(2);
    };
    refused(&["no_such_case.toml"]);
    refused(&["--steps", "0"]);
    refused(&["--set", "grid.cell=0 mm"]);
}
