//! `coulter sweep` through the binary: studies that are killed, run by several engines, and of which some
//! cases have no results.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::Duration;

const CASE: &str = include_str!("../../../cases/light_disc.toml");

/// Closed forms over two factors, and two short runs of the solver on a coarse grid.
const STUDY: &str = r#"format = 2
case = "disc.toml"

[factor.phi]
key = "soil.friction_angle"
values = ["30 deg", "35 deg", "40 deg"]

[factor.weight]
key = "body.disc.weight"
values = ["20 N", "40 N", "60 N"]

[part.closed]

[part.runs]
models = "solver"
factors = ["phi"]
[part.runs.set]
"grid.cell" = "25 mm"
"run.tow_distance" = "0.01 m"
"body.disc.forward" = { speed = "0.2 m/s", ramp = "0.02 s" }
"output.checkpoint_interval" = "0.1 s"
"#;

struct Sandbox(tempfile::TempDir);

impl Sandbox {
    fn new(study: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("disc.toml"), CASE).unwrap();
        std::fs::write(folder.path().join("study.toml"), study).unwrap();
        Self(folder)
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// How many outcomes a study has so far.
    fn outcomes(&self, study: &str) -> usize {
        std::fs::read_dir(self.path(study).join("outcomes")).map_or(0, Iterator::count)
    }

    fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(assert_cmd::cargo::cargo_bin("coulter"));
        command.current_dir(self.0.path()).args(arguments).stdout(Stdio::piped()).stderr(Stdio::piped());
        command
    }

    #[track_caller]
    fn run(&self, arguments: &[&str], code: i32) -> String {
        let Output { status, stdout, stderr } = self.command(arguments).output().unwrap();
        let text = String::from_utf8_lossy(&stdout).into_owned() + &String::from_utf8_lossy(&stderr);
        assert_eq!(status.code(), Some(code), "{arguments:?}: {text}");
        assert!(!text.contains("panicked"), "{text}");
        text
    }
}

/// What must have the same bytes however a study came to its end.
fn results(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    for name in ["table.csv", "table.parquet", "without_results.csv", "cases.jsonl", "report.html"] {
        found.insert(name.to_owned(), std::fs::read(folder.join(name)).unwrap());
    }
    for entry in std::fs::read_dir(folder.join("outcomes")).unwrap() {
        let entry = entry.unwrap();
        // What a killed process had not written to its end.
        if entry.path().extension().is_some_and(|extension| extension == "part") {
            continue;
        }
        found.insert(entry.file_name().to_string_lossy().into_owned(), std::fs::read(entry.path()).unwrap());
    }
    found
}

#[track_caller]
fn same(a: &Path, b: &Path) {
    let (a, b) = (results(a), results(b));
    assert_eq!(a.keys().collect::<Vec<_>>(), b.keys().collect::<Vec<_>>());
    for (name, bytes) in &a {
        assert!(*bytes == b[name], "{name} differs");
    }
}

#[test]
fn a_study_that_is_killed_ends_with_the_same_bytes() {
    let sandbox = Sandbox::new(STUDY);
    let text = sandbox.run(&["sweep", "study.toml", "-o", "whole"], 0);
    assert!(text.contains("12 cases: 12 done"), "{text}");
    for outcomes in [1, 4, 10] {
        let mut child = sandbox.command(&["sweep", "study.toml", "-o", "killed"]).spawn().unwrap();
        while sandbox.outcomes("killed") < outcomes && child.try_wait().unwrap().is_none() {
            std::thread::sleep(Duration::from_millis(1));
        }
        child.kill().unwrap();
        child.wait().unwrap();
    }
    // The rest one by one, as another engine would start them; an id of an outcome costs nothing.
    sandbox.run(&["sweep", "expand", "study.toml", "-o", "killed"], 0);
    let ids = sandbox.run(&["sweep", "script", "killed", "--for", "ids"], 0);
    for id in ids.lines() {
        let told = sandbox.run(&["sweep", "run", "killed", "--id", id], 0);
        assert!(told.starts_with("point "), "{told}");
        sandbox.run(&["sweep", "run", "killed", "--id", id], 0);
    }
    assert_eq!(sandbox.run(&["sweep", "script", "killed", "--for", "ids"], 0), "");
    let text = sandbox.run(&["sweep", "script", "killed", "--for", "slurm"], 2);
    assert!(text.contains("no case is left to run"), "{text}");
    sandbox.run(&["sweep", "collect", "killed"], 0);
    same(&sandbox.path("whole"), &sandbox.path("killed"));
    // Without its outcomes a study is run again.
    std::fs::remove_dir_all(sandbox.path("killed/outcomes")).unwrap();
    sandbox.run(&["sweep", "run", "killed"], 0);
    sandbox.run(&["sweep", "collect", "killed"], 0);
    same(&sandbox.path("whole"), &sandbox.path("killed"));
    let header = std::fs::read_to_string(sandbox.path("whole/table.csv")).unwrap();
    let header = header.lines().next().unwrap();
    assert!(
        header.starts_with("point [-],part,id,model,closed_form,body,phi [deg],weight [N],drag [N]"),
        "{header}"
    );
}

#[test]
fn figures_show_runs_closed_forms_and_measured_points() {
    let figures = "[chart.drag]\nx = \"phi\"\ny = \"F_H_bar\"\nmeasured = [\"data/tests.csv\"]\nlegend = \"top left\"\n\
                   [chart.path]\npart = \"runs\"\nhistory = true\nx = \"time\"\ny = \"Z\"\nfamily = \"phi\"\n";
    let sandbox = Sandbox::new(&format!("{STUDY}{figures}"));
    std::fs::create_dir(sandbox.path("data")).unwrap();
    std::fs::write(sandbox.path("data/tests.csv"), "phi [deg],F_H_bar [-]\n31,1.5\n36,2\n").unwrap();
    sandbox.run(&["sweep", "study.toml", "-o", "out"], 0);
    let read = |name: &str| std::fs::read_to_string(sandbox.path("out/figures").join(name)).unwrap();
    let drag = read("drag.csv");
    for start in ["computed,,solver,30,", "line,,closed form,30,", "measured,,tests,31,,,1.5,"] {
        assert!(drag.lines().any(|line| line.starts_with(start)), "{start}: {drag}");
    }
    let path = read("path.csv");
    assert!(path.starts_with("kind,level,source,time [s],"), "{path}");
    for phi in [30, 35, 40] {
        let level = format!("line,phi = {phi} deg");
        assert!(path.lines().filter(|line| line.starts_with(&level)).count() > 3, "{path}");
    }
    let pdf = std::fs::read(sandbox.path("out/figures/path.pdf")).unwrap();
    assert!(pdf.starts_with(b"%PDF") && read("figures.py").contains("\"path\""));
    // The folder has a copy of what was measured: it is collected wherever the study lies.
    std::fs::remove_dir_all(sandbox.path("data")).unwrap();
    sandbox.run(&["sweep", "collect", "out"], 0);
    assert_eq!(read("drag.csv"), drag);
}

#[test]
fn what_has_no_results_is_listed_with_its_reason() {
    let refused = STUDY.replace("\"40 deg\"]", "\"40 deg\"]\n[set]\n\"soil.dilation_angle\" = \"33 deg\"\n");
    let closed = refused.split("[part.closed]").next().unwrap();
    let sandbox = Sandbox::new(closed);
    sandbox.run(&["sweep", "expand", "study.toml", "-o", "out"], 0);
    let missing = sandbox.run(&["sweep", "collect", "out"], 2);
    assert!(missing.contains("9 cases: 9 missing"), "{missing}");
    let text = sandbox.run(&["sweep", "study.toml", "-o", "out"], 1);
    assert!(text.contains("9 cases: 6 done, 3 refused"), "{text}");
    let lacking = std::fs::read_to_string(sandbox.path("out/without_results.csv")).unwrap();
    assert_eq!(lacking.lines().filter(|line| line.contains(",refused,")).count(), 3, "{lacking}");
    assert!(lacking.contains("dilation"), "{lacking}");
    let table = std::fs::read_to_string(sandbox.path("out/table.csv")).unwrap();
    assert_eq!(table.lines().count(), 10);
}

#[test]
fn wrong_requests_are_refused_with_a_cure() {
    let sandbox = Sandbox::new(STUDY);
    let text = sandbox.run(&["sweep", "run", "nowhere"], 2);
    assert!(text.contains("coulter sweep expand"), "{text}");
    sandbox.run(&["sweep", "expand", "study.toml", "-o", "out"], 0);
    let text = sandbox.run(&["sweep", "run", "out", "--id", "f0"], 2);
    assert!(text.contains("has the id f0") && text.contains("cases.jsonl"), "{text}");
    let text = sandbox.run(&["sweep", "script", "out", "--for", "pbs"], 2);
    assert!(text.contains("slurm"), "{text}");
    std::fs::create_dir(sandbox.path("foreign")).unwrap();
    std::fs::write(sandbox.path("foreign/letter.txt"), "mine").unwrap();
    let text = sandbox.run(&["sweep", "study.toml", "-o", "foreign"], 2);
    assert!(text.contains("-o DIR"), "{text}");
    // A list that was damaged, and a case that has changed since.
    let list = std::fs::read_to_string(sandbox.path("out/cases.jsonl")).unwrap();
    std::fs::write(sandbox.path("out/cases.jsonl"), &list[..list.len() - 40]).unwrap();
    let text = sandbox.run(&["sweep", "run", "out"], 2);
    assert!(text.contains("cases.jsonl") && text.contains("line 12"), "{text}");
    std::fs::write(sandbox.path("out/cases.jsonl"), &list).unwrap();
    let case = std::fs::read_to_string(sandbox.path("out/case.toml")).unwrap();
    std::fs::write(sandbox.path("out/case.toml"), case.replace("16 kN/m^3", "17 kN/m^3")).unwrap();
    let id = &list[7..24];
    let text = sandbox.run(&["sweep", "run", "out", "--id", id], 2);
    assert!(text.contains("expand the study anew"), "{text}");
    let text = sandbox.run(&["sweep", "collect", "out"], 2);
    assert!(text.contains("1 failed"), "{text}");
}

#[test]
fn a_folder_of_another_format_is_refused_with_what_to_do() {
    let sandbox = Sandbox::new(&STUDY[..STUDY.find("[part.closed]").unwrap()]);
    sandbox.run(&["sweep", "expand", "study.toml", "-o", "s"], 0);
    let origin = std::fs::read_to_string(sandbox.path("s/origin.json")).unwrap();
    for (format, words) in [
        ("\"format\": 3,", ["newer than this version", "install a newer version"]),
        ("\"format\": 0,", ["no longer read", "-o DIR"]),
        ("", ["does not say in which format", "-o DIR"]),
    ] {
        assert!(origin.contains("\"format\": 2,"), "{origin}");
        std::fs::write(sandbox.path("s/origin.json"), origin.replace("\"format\": 2,", format)).unwrap();
        for arguments in [&["sweep", "collect", "s"][..], &["sweep", "expand", "study.toml", "-o", "s"]] {
            let said = sandbox.run(arguments, 2);
            assert!(words.iter().all(|word| said.contains(word)), "{arguments:?}: {said}");
        }
    }
}

#[test]
fn scripts_name_every_case_that_is_left() {
    let sandbox = Sandbox::new(STUDY);
    sandbox.run(&["sweep", "expand", "study.toml", "-o", "out"], 0);
    let ids = sandbox.run(&["sweep", "script", "out", "--for", "ids"], 0);
    for engine in ["parallel", "slurm", "hyperqueue", "snakemake"] {
        let script = sandbox.run(&["sweep", "script", "out", "--for", engine, "--chunk", "5"], 0);
        assert!(ids.lines().all(|id| script.contains(id)), "{engine}: {script}");
        assert!(script.contains("sweep run"), "{script}");
    }
    let slurm = sandbox.run(&["sweep", "script", "out", "--for", "slurm", "--chunk", "5"], 0);
    assert!(slurm.contains("--array=0-2"), "{slurm}");
}

/// The script for GNU parallel does what it says; left out where it is not installed.
#[test]
fn gnu_parallel_runs_a_study() {
    if Command::new("parallel").arg("--version").output().is_err() {
        eprintln!("GNU parallel is not installed: not tested");
        return;
    }
    let sandbox = Sandbox::new(STUDY);
    sandbox.run(&["sweep", "study.toml", "-o", "whole"], 0);
    sandbox.run(&["sweep", "expand", "study.toml", "-o", "out"], 0);
    let script = sandbox.run(&["sweep", "script", "out", "--for", "parallel", "--chunk", "4"], 0);
    std::fs::write(sandbox.path("study.sh"), script).unwrap();
    let done = Command::new("sh").arg("study.sh").current_dir(sandbox.0.path()).output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    sandbox.run(&["sweep", "collect", "out"], 0);
    same(&sandbox.path("whole"), &sandbox.path("out"));
}

#[test]
fn a_point_without_a_recommended_closed_form_is_refused_with_the_reason() {
    let deep = r#"format = 2
case = "disc.toml"
[factor.weight]
key = "body.disc.weight"
values = ["40 N", "550 N"]
"#;
    let sandbox = Sandbox::new(deep);
    let text = sandbox.run(&["sweep", "study.toml", "-o", "deep"], 1);
    assert!(text.contains("1 refused") && text.contains("no closed form is recommended here"), "{text}");
    assert!(text.contains("digs in"), "{text}");
    let rows = std::fs::read_to_string(sandbox.path("deep/table.csv")).unwrap();
    assert_eq!(rows.lines().count(), 3, "{rows}");
    let all = deep.replace("[factor", "closed_forms = \"all\"\n[factor");
    std::fs::write(sandbox.path("study.toml"), all).unwrap();
    sandbox.run(&["sweep", "study.toml", "-o", "all"], 0);
    assert!(std::fs::read_to_string(sandbox.path("all/table.csv")).unwrap().lines().count() > 5);
}
