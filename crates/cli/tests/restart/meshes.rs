//! A case on several meshes: what is written, and how it is stopped and resumed.

use super::sandbox::{Reply, Sandbox};
use serde_json::Value;
use std::fs;
use std::sync::OnceLock;

/// A wide disc, so that cells of 39 mm are still two across it.
const CASE: [&str; 8] = [
    "--set",
    "grid.cell=17.5 mm",
    "--set",
    "run.tow_distance=40 mm",
    "--set",
    "output.field_interval=0.2 s",
    "--set",
    "output.checkpoint_interval=0.03 s",
];
const STUDY: [&str; 2] = ["--meshes", "3"];
const COARSE: [&str; 2] = ["39.375mm", "26.25mm"];

fn with<'a>(arguments: &[&'a str]) -> Vec<&'a str> {
    [&CASE[..], arguments].concat()
}

fn study<'a>(arguments: &[&'a str]) -> Vec<&'a str> {
    [&CASE[..], &STUDY, arguments].concat()
}

fn names(folder: &str) -> Vec<String> {
    COARSE.iter().map(|mesh| format!("meshes/{mesh}/{folder}")).collect()
}

/// The results of a study that was never stopped.
fn whole() -> &'static (Vec<String>, Value) {
    static RESULTS: OnceLock<(Vec<String>, Value)> = OnceLock::new();
    RESULTS.get_or_init(|| {
        let sandbox = Sandbox::new();
        sandbox.run(&study(&[])).is(0, &[]);
        results(&sandbox)
    })
}

/// Histories of all meshes, and the summary without wall-clock times.
fn results(sandbox: &Sandbox) -> (Vec<String>, Value) {
    let tables = ["forces.csv", "energy.csv", "boundaries.csv", "soil.pvd", "body.pvd"];
    let folders = names("").into_iter().chain([String::new()]);
    let texts = folders
        .flat_map(|folder| tables.map(|table| sandbox.text(&format!("{folder}{table}"))))
        .inspect(|text| assert!(!text.is_empty(), "a file is missing"));
    let mut summary = sandbox.summary();
    summary["wall_s"] = Value::Null;
    for mesh in summary["mesh_study"]["meshes"].as_array_mut().unwrap() {
        mesh["wall_s"] = Value::Null;
    }
    (texts.collect(), summary)
}

/// Whether a study is in all places where it should be.
#[track_caller]
fn is_complete(sandbox: &Sandbox) {
    let summary = sandbox.summary();
    let meshes = summary["mesh_study"]["meshes"].as_array().unwrap();
    let cells: Vec<f64> = meshes.iter().map(|mesh| mesh["cell_m"].as_f64().unwrap()).collect();
    assert_eq!(cells, [0.039375, 0.02625, 0.0175]);
    assert_eq!(summary["mesh_study"]["meshes"][2]["bodies"]["disc"].as_object().unwrap().len(), 5);
    for folder in names("") {
        for file in ["report.html", "summary.json", "case.toml", "checkpoints/last.checkpoint"] {
            assert!(sandbox.out(&format!("{folder}{file}")).is_file(), "{folder}{file} is missing");
        }
        let own: Value = serde_json::from_str(&sandbox.text(&format!("{folder}summary.json"))).unwrap();
        assert!(own["mesh_study"].is_null(), "a coarser mesh has no study of its own");
    }
    assert!(sandbox.text("report.html").contains("disc: mesh study") && sandbox.is_tidy());
}

fn stopped(sandbox: &Sandbox, arguments: &[&str], watched: &str) -> Reply {
    let mut run = sandbox.start_held(arguments);
    run.hold_at(watched, |sandbox| sandbox.text(watched).lines().count() > 5);
    run.signal("INT");
    run.end()
}

#[test]
fn a_study_has_the_results_of_the_case_and_those_of_coarser_meshes() {
    let (alone, sandbox) = (Sandbox::new(), Sandbox::new());
    alone.run(&with(&[])).is(0, &["done"]);
    let reply = sandbox.run(&study(&[])).is(
        0,
        &["mesh 1 of 3", "mesh 2 of 3", "mesh 3 of 3: done", "mesh study of disc", "39.375 mm", "26.25 mm"],
    );
    assert!(!reply.err.contains("started again"), "{}", reply.err);
    assert!(sandbox.histories() == alone.histories(), "the finest mesh must be that of the case");
    is_complete(&sandbox);
    // The intervals are in the grade, and where there are none the reason is said.
    let summary = sandbox.summary();
    let (steady, body) = (&summary["bodies"]["disc"]["steady"], &summary["mesh_study"]["bodies"]["disc"]);
    for figure in ["drag_N", "vertical_N", "sinkage_m", "turn_ratio"] {
        let interval = &steady[&format!("{figure}_interval")];
        if body["no_interval_because"].is_null() {
            let [low, high] = [0, 1].map(|end| interval[end].as_f64().unwrap());
            assert!(low < steady[figure].as_f64().unwrap() && steady[figure].as_f64().unwrap() < high);
            assert_eq!(*interval, body[figure]["interval"]);
        } else {
            assert!(interval.is_null() && body[figure].is_null());
        }
    }
    let checks = summary["trust"]["checks"].as_array().unwrap();
    for name in ["interval of the drag", "interval of the sinkage", "broken coarser meshes"] {
        assert!(checks.iter().any(|check| check["name"] == name), "{name}");
    }
    assert!(alone.summary()["mesh_study"].is_null());
    assert!(alone.summary()["bodies"]["disc"]["steady"]["drag_N_interval"].is_null());
    // The report can be rebuilt, and the same request by a scheduler changes nothing.
    let html = sandbox.text("report.html");
    sandbox.report().is(0, &[]);
    assert!(sandbox.text("report.html") == html);
    let before = sandbox.files();
    let json = sandbox.run(&study(&["--auto-resume", "--json"])).is(0, &[]).out;
    assert_eq!(serde_json::from_str::<Value>(&json).unwrap(), sandbox.summary());
    assert!(sandbox.files() == before, "a file has changed");
    sandbox.run(&study(&[])).is(2, &["already holds a result", "--force"]);
    let other = sandbox.run(&study(&["--resume", "--set", "soil.friction_angle=34 deg"]));
    other.is(2, &["another case file"]);
    assert!(sandbox.files() == before, "a file has changed");
}

#[test]
fn a_study_that_was_stopped_anywhere_goes_on_to_the_same_results() {
    let sandbox = Sandbox::new();
    let (first, second) =
        (format!("meshes/{}/forces.csv", COARSE[0]), format!("meshes/{}/forces.csv", COARSE[1]));
    let hint = "--meshes 3 --resume continues from";
    stopped(&sandbox, &study(&[]), &first).is(130, &[hint, COARSE[0]]);
    assert!(!sandbox.out(&second).exists() && sandbox.is_tidy());
    sandbox.run(&study(&[])).is(2, &["stopped before its end", "--resume"]);
    stopped(&sandbox, &study(&["--resume"]), &second).is(130, &[hint, COARSE[1]]);
    let done = sandbox.text(&first);
    stopped(&sandbox, &study(&["--auto-resume"]), "forces.csv").is(130, &[hint]);
    assert!(sandbox.text(&first) == done);
    sandbox.run(&study(&["--resume"])).is(0, &["mesh study of disc"]);
    is_complete(&sandbox);
    assert!(results(&sandbox) == *whole());
    let log = |mesh: &str| sandbox.text(&format!("meshes/{mesh}/run.log"));
    assert!(COARSE.iter().all(|mesh| log(mesh).matches("resumed at").count() == 1));
}

#[test]
fn a_killed_study_goes_on_too() {
    let sandbox = Sandbox::new();
    for file in [format!("meshes/{}/forces.csv", COARSE[1]), "forces.csv".to_owned()] {
        let mut run = sandbox.start_held(&study(&["--auto-resume"]));
        run.hold_at(&file, |sandbox| sandbox.text(&file).lines().count() > 5);
        run.signal("KILL");
        run.end();
    }
    sandbox.run(&study(&["--auto-resume"])).is(0, &["mesh study of disc"]);
    is_complete(&sandbox);
    assert!(results(&sandbox) == *whole());
}

#[test]
fn a_finished_run_can_be_given_a_study_and_one_can_be_replaced() {
    let sandbox = Sandbox::new();
    sandbox.run(&with(&[])).is(0, &[]);
    let forces = fs::metadata(sandbox.out("forces.csv")).unwrap().modified().unwrap();
    let reply = sandbox.run(&study(&["--resume"])).is(0, &["mesh 2 of 3", "mesh study of disc"]);
    assert!(!reply.err.contains("mesh 3 of 3"), "{}", reply.err);
    assert!(fs::metadata(sandbox.out("forces.csv")).unwrap().modified().unwrap() == forces);
    is_complete(&sandbox);
    let (given, usual) = (results(&sandbox), whole());
    assert!(given.0 == usual.0);
    assert_eq!(given.1["mesh_study"]["bodies"], usual.1["mesh_study"]["bodies"]);
    // Without a study nothing of it may stay, and files of others do.
    let notes = ["notes.txt", "meshes/notes.txt"];
    for name in notes {
        fs::write(sandbox.out(name), "mine").unwrap();
    }
    sandbox.run(&with(&["--force"])).is(0, &["done"]);
    assert!(COARSE.iter().all(|mesh| !sandbox.out(&format!("meshes/{mesh}")).exists()));
    assert!(sandbox.summary()["mesh_study"].is_null());
    sandbox.run(&study(&["--force"])).is(0, &["mesh study of disc"]);
    is_complete(&sandbox);
    assert_eq!(notes.map(|name| sandbox.text(name)), ["mine"; 2]);
}

#[test]
fn a_mesh_that_cannot_be_had_is_refused_before_anything_runs() {
    let sandbox = Sandbox::new();
    let thin = ["--set", "body.disc.thickness=35 mm"];
    let cures = ["mesh 1 of 3", "39.375 mm", "too few to resolve contact", "--meshes 2"];
    sandbox.run(&study(&thin)).is(2, &cures);
    assert!(!sandbox.out("").exists());
    sandbox.run(&with(&["--meshes", "1"])).is(2, &["2..=4"]);
    sandbox.run(&with(&["--meshes", "5"])).is(2, &["2..=4"]);
}

#[test]
fn a_coarser_mesh_that_breaks_down_leaves_the_others_and_is_the_grade() {
    let sandbox = Sandbox::new();
    let heavy = ["--set", r#"body.disc.heave={ load = "-50000 N" }"#];
    let reply = sandbox.run(&study(&heavy));
    assert_eq!(reply.code, Some(1), "{}", reply.err);
    for mesh in ["mesh 1 of 3", "mesh 2 of 3", "mesh 3 of 3"] {
        assert!(reply.err.contains(mesh), "{mesh} was not run: {}", reply.err);
    }
    let study = &sandbox.summary()["mesh_study"];
    assert_eq!(study["meshes"].as_array().unwrap().len(), 3);
    assert!(study["bodies"]["disc"]["no_interval_because"].as_str().unwrap().contains("is broken"));
    assert_eq!(sandbox.summary()["trust"]["verdict"], "broken");
}

#[test]
fn check_shows_what_the_meshes_cost() {
    let sandbox = Sandbox::new();
    let reply = sandbox.check(&study(&["--json"]));
    let document: Value = serde_json::from_str(&reply.is(0, &[]).out).unwrap();
    let meshes = document["meshes"].as_array().unwrap();
    let cells: Vec<f64> = meshes.iter().map(|mesh| mesh["cell_m"].as_f64().unwrap()).collect();
    assert_eq!(cells, [0.039375, 0.02625, 0.0175]);
    assert!(meshes[0]["cost"]["steps"].as_f64() < meshes[2]["cost"]["steps"].as_f64());
    let text = sandbox.check(&study(&[])).is(0, &[]).out;
    assert!(
        text.contains("mesh 3   cells of 17.5 mm") && text.contains("times the work of the finest"),
        "{text}"
    );
    assert!(sandbox.check(&with(&["--json"])).out.contains("\"cost\""));
}
