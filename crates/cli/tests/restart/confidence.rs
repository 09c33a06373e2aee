//! A case with its variations: what is written, and how it is killed and resumed.

use super::sandbox::Sandbox;
use serde_json::Value;
use std::fs;

/// A wide disc, so that cells of 39 mm are still two across it, and a short tow.
const CASE: [&str; 11] = [
    "--set",
    "grid.cell=17.5 mm",
    "--set",
    "run.tow_distance=12 mm",
    "--set",
    "output.field_interval=0.2 s",
    "--set",
    "output.checkpoint_interval=0.03 s",
    "--confidence",
    "--meshes",
    "3",
];
const NAMES: [&str; 5] = ["cells_19.69mm", "cells_35mm", "larger_domain", "half_speed", "single_precision"];

fn with<'a>(arguments: &[&'a str]) -> Vec<&'a str> {
    [&CASE[..], arguments].concat()
}

/// The intervals without wall-clock times, and the histories of all runs.
fn results(sandbox: &Sandbox) -> (Value, Vec<String>) {
    let mut confidence = sandbox.summary()["confidence"].clone();
    for key in ["budget_s", "spent_s"] {
        confidence[key] = Value::Null;
    }
    for variation in confidence["variations"].as_array_mut().unwrap() {
        for key in ["wall_s", "predicted_wall_s"] {
            variation[key] = Value::Null;
        }
    }
    let folders = NAMES.map(|name| format!("variations/{name}/")).into_iter().chain([String::new()]);
    (confidence, folders.map(|folder| sandbox.text(&format!("{folder}forces.csv"))).collect())
}

#[test]
fn intervals_of_a_run_that_was_killed_are_those_of_one_that_was_not() {
    let enough = ["--budget", "100x"];
    let whole = Sandbox::new();
    let reply =
        whole.run(&with(&enough)).is(0, &["variation 1, cells", "90 % intervals of disc", "variations took"]);
    assert!(reply.err.contains("dominated by"), "{}", reply.err);
    let summary = whole.summary();
    let variations = summary["confidence"]["variations"].as_array().unwrap();
    let names: Vec<&str> = variations.iter().map(|v| v["name"].as_str().unwrap()).collect();
    assert_eq!(names, NAMES);
    assert!(variations.iter().all(|v| v["status"] == "examined"), "{variations:#?}");
    let figures = &summary["confidence"]["bodies"]["disc"]["figures"];
    for key in ["drag_N", "vertical_N", "sinkage_m"] {
        let [low, high] = [0, 1].map(|end| figures[key]["interval"][end].as_f64().unwrap());
        let value = summary["bodies"]["disc"]["steady"][key].as_f64().unwrap();
        // Histories are read back from text.
        assert!((figures[key]["value"].as_f64().unwrap() / value - 1.0).abs() < 1e-6);
        assert!(low < value && value < high, "{key}: {low} {value} {high}");
    }
    let checks = summary["trust"]["checks"].as_array().unwrap();
    for name in ["effect of the mesh", "effect of the domain", "confidence interval", "missing variations"] {
        assert!(checks.iter().any(|check| check["name"] == name), "{name}");
    }
    assert!(whole.text("report.html").contains("Intervals: how far the results may be off"));

    // Killed in a variation, resumed, and the report rebuilt.
    let killed = Sandbox::new();
    let third = format!("variations/{}/forces.csv", NAMES[2]);
    let mut run = killed.start_held(&with(&enough));
    run.hold_at(&third, |sandbox| sandbox.text(&third).lines().count() > 5);
    run.signal("KILL");
    assert_eq!(run.end().code, None);
    assert!(killed.summary()["confidence"].is_null());
    let first = fs::metadata(killed.out(&format!("variations/{}/forces.csv", NAMES[0]))).unwrap();
    killed.run(&with(&["--budget", "100x", "--resume"])).is(0, &["90 % intervals of disc"]);
    let again = fs::metadata(killed.out(&format!("variations/{}/forces.csv", NAMES[0]))).unwrap();
    assert_eq!(first.modified().unwrap(), again.modified().unwrap(), "what was done is not done again");
    assert!(results(&killed) == results(&whole) && killed.is_tidy());
    let html = killed.text("report.html");
    killed.report().is(0, &[]);
    assert!(killed.text("report.html") == html);

    // Without --confidence nothing of it may stay.
    let alone: Vec<&str> = CASE[..8].iter().copied().chain(["--force"]).collect();
    killed.run(&alone).is(0, &["done"]);
    assert!(killed.summary()["confidence"].is_null() && !killed.out("variations").exists());
}

#[test]
fn what_the_budget_does_not_allow_is_not_examined_and_can_be_later() {
    let sandbox = Sandbox::new();
    let short = ["--set", "run.tow_distance=4 mm"];
    let none = [&short[..], &["--budget", "0 s"]].concat();
    sandbox.run(&with(&none)).is(0, &["not examined", "give more with --budget"]);
    let summary = sandbox.summary();
    let figure = &summary["confidence"]["bodies"]["disc"]["figures"]["drag_N"];
    assert_eq!(figure["is_complete"], false);
    for part in figure["contributions"].as_array().unwrap() {
        // The window of so short a tow has too few samples for statistics.
        let expected = if part["source"] == "statistics" { "not-comparable" } else { "not-examined" };
        assert_eq!(part["status"], expected, "{part}");
    }
    assert_eq!(summary["trust"]["verdict"], "doubtful");
    let some = [&short[..], &["--budget", "100x", "--without", "speed,precision", "--resume"]].concat();
    sandbox.run(&with(&some)).is(0, &["not asked for", "larger domain"]);
    let variations = sandbox.summary()["confidence"]["variations"].clone();
    let status: Vec<&str> =
        variations.as_array().unwrap().iter().map(|v| v["status"].as_str().unwrap()).collect();
    assert_eq!(status, ["examined", "examined", "examined", "not-asked-for", "not-asked-for"]);
}

#[test]
fn check_shows_what_the_variations_cost() {
    let sandbox = Sandbox::new();
    let text = sandbox.check(&CASE).is(0, &[]).out;
    for words in ["varied   mesh: cells of 35 mm", "half the speed, 2.0", "single precision", "together"] {
        assert!(text.contains(words), "`{words}` is not in {text}");
    }
    sandbox.run(&["--budget", "4x"]).is(2, &["--confidence"]);
}
