//! A case on several meshes: what is written, and what is done about a mesh that cannot be used.

use super::sandbox::Sandbox;
use serde_json::Value;

/// A wide disc, so that cells of 35 mm are still two across it.
const CASE: [&str; 6] =
    ["--set", "grid.cell=17.5 mm", "--set", "run.tow_distance=40 mm", "--set", "output.field_interval=0.2 s"];
const STUDY: [&str; 2] = ["--meshes", "4"];

fn with<'a>(arguments: &[&'a str]) -> Vec<&'a str> {
    [&CASE[..], arguments].concat()
}

fn study<'a>(arguments: &[&'a str]) -> Vec<&'a str> {
    [&CASE[..], &STUDY, arguments].concat()
}

/// The variations of a run, each with its name, what it examines and what became of it.
fn variations(summary: &Value) -> Vec<[String; 3]> {
    let text = |value: &Value| value.as_str().unwrap().to_owned();
    let all = summary["confidence"]["variations"].as_array().unwrap();
    all.iter().map(|v| [text(&v["name"]), text(&v["source"]), text(&v["status"])]).collect()
}

#[test]
fn a_study_has_the_results_of_the_case_and_intervals_from_other_meshes() {
    let (alone, sandbox) = (Sandbox::new(), Sandbox::new());
    alone.run(&with(&[])).is(0, &["done"]);
    sandbox.run(&study(&[])).is(0, &["variation 1, cells ", "variation 3, cells ", "90 % intervals of disc"]);
    assert!(sandbox.histories() == alone.histories(), "the case's own mesh must be that of the case");
    let summary = sandbox.summary();
    let found = variations(&summary);
    let meshes: Vec<_> = found.iter().filter(|[_, source, _]| source == "mesh").collect();
    assert_eq!(meshes.len(), 3, "{found:?}");
    assert!(meshes.iter().all(|[.., status]| status == "examined"), "{found:?}");
    assert!(found.iter().filter(|[.., status]| status == "not-asked-for").count() == 3, "{found:?}");
    let figures = &summary["confidence"]["bodies"]["disc"]["figures"];
    for key in ["drag_N", "sinkage_m"] {
        let convergence = &figures[key]["contributions"][0]["convergence"];
        assert_eq!(convergence["widths"].as_array().unwrap().len(), 4);
        assert!(convergence["half_width"].as_f64().unwrap() > 0.0);
        assert_eq!(figures[key]["is_complete"], true, "nobody asked for more");
    }
    let html = sandbox.text("report.html");
    for words in
        ["Intervals: how far", "Drag and cell width", "domain, speed and precision were not examined"]
    {
        assert!(html.contains(words), "{words}");
    }
    sandbox.report().is(0, &[]);
    assert!(sandbox.text("report.html") == html);
    // The same request by a scheduler changes nothing, and more can be asked for later.
    let before = sandbox.files();
    let json = sandbox.run(&study(&["--auto-resume", "--json"])).is(0, &[]).out;
    assert_eq!(serde_json::from_str::<Value>(&json).unwrap(), sandbox.summary());
    assert!(sandbox.files() == before, "a file has changed");
    let all = study(&["--confidence", "--without", "domain,speed", "--resume"]);
    sandbox.run(&all).is(0, &["single precision (precision): "]);
}

#[test]
fn a_case_that_breaks_down_has_no_intervals_and_a_thin_body_has_other_meshes() {
    let sandbox = Sandbox::new();
    let thin = ["--set", "body.disc.thickness=35 mm", "--set", "run.tow_distance=10 mm"];
    let text = sandbox.check(&study(&thin)).is(0, &[]).out;
    assert!(text.contains("varied   mesh: cells of"), "{text}");
    let heavy = ["--set", r#"body.disc.heave={ load = "-50000 N" }"#];
    let reply = sandbox.run(&study(&heavy));
    assert_eq!(reply.code, Some(1), "{}", reply.err);
    assert_eq!(sandbox.summary()["trust"]["verdict"], "broken");
    assert!(sandbox.summary()["confidence"].is_null());
    for count in ["1", "7"] {
        sandbox.run(&with(&["--meshes", count])).is(2, &["2..=6"]);
    }
}

/// Coarse cells come first, and the answer's own are those that promise what is wanted; a run that was killed
/// goes on.
#[test]
fn a_run_finds_cells_for_the_accuracy_that_is_wanted() {
    let sandbox = Sandbox::new();
    let wanted = with(&["--accuracy", "drag 60 %, sinkage 90 %", "--budget", "20x"]);
    let mut run = sandbox.start_held(&wanted);
    run.hold_at("variations/cells_35mm/forces.csv", |sandbox| {
        sandbox.text("variations/cells_35mm/forces.csv").lines().count() > 5
    });
    run.signal("KILL");
    run.end();
    let resumed = [&wanted[..], &["--resume"]].concat();
    let reply = sandbox.run(&resumed);
    assert!(matches!(reply.code, Some(0)), "{}", reply.err);
    for words in
        ["mesh 3, cells of ", "the answer, cells of ", "accuracy of the drag of disc: ±", "60.0 % wanted"]
    {
        assert!(reply.err.contains(words), "`{words}` is not in {}", reply.err);
    }
    let summary = sandbox.summary();
    assert!(variations(&summary).len() >= 3 && summary["confidence"]["wanted"]["drag_N"] == 0.6);
    let width = |value: &Value| value["width_m"].as_f64().unwrap();
    let all = summary["confidence"]["variations"].as_array().unwrap();
    let mut meshes = all.iter().filter(|variation| variation["source"] == "mesh");
    assert!(meshes.all(|mesh| width(mesh) > width(&summary["confidence"])), "the answer is the finest");
    for source in ["domain", "speed"] {
        let one = all.iter().find(|variation| variation["source"] == source).unwrap();
        let beside = one["beside"].as_str().unwrap_or_default();
        assert!(one["status"] == "examined" && beside.starts_with("cells_"), "on cells of a mesh: {one}");
    }
    let before = sandbox.files();
    sandbox.run(&resumed).is(0, &["accuracy of the sinkage"]);
    assert!(sandbox.files() == before, "a file has changed");
    sandbox.run(&with(&["--accuracy", "5"])).is(2, &["write such as"]);
    sandbox.run(&with(&["--accuracy", "5 %", "--meshes", "3"])).is(2, &["cannot be used with"]);
    sandbox.run(&with(&["--accuracy", "5 %", "--without", "mesh"])).is(2, &["accuracy chooses the cells"]);
}

/// The cells of a run that finds its own are those of a case that is read again, with its files.
#[test]
fn files_of_a_case_are_found_beside_it_by_every_mesh() {
    let sandbox = Sandbox::with_body_from_a_file();
    let short = ["--set", "run.tow_distance=2 mm", "--set", "grid.cell=25 mm", "--without", "domain,speed"];
    let wanted = [&short[..], &["--accuracy", "drag 95 %", "--budget", "3x"]].concat();
    let reply = sandbox.run(&wanted);
    assert!(variations(&sandbox.summary()).len() >= 2, "{}", reply.err);
}
