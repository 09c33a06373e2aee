//! Starting in folders that an earlier run left in every possible state.

use super::sandbox::{Sandbox, TINY};
use std::fs;

fn with<'a>(start: &'a [&'a str]) -> Vec<&'a str> {
    [start, &TINY[..]].concat()
}

#[test]
fn resume_starts_where_there_is_nothing() {
    for start in ["--resume", "--auto-resume"] {
        let sandbox = Sandbox::new();
        fs::create_dir(sandbox.out("")).unwrap();
        sandbox.run(&with(&[start])).is(0, &["done"]);
        assert!(sandbox.out("report.html").is_file() && sandbox.is_tidy());
    }
}

#[test]
fn a_finished_run_is_left_as_it_is_by_a_scheduler() {
    let sandbox = Sandbox::new();
    sandbox.run(&TINY).is(0, &[]);
    let before = sandbox.files();
    let reply = sandbox.run(&with(&["--auto-resume", "--json"])).is(0, &[]);
    let summary: serde_json::Value = serde_json::from_str(&reply.out).unwrap();
    assert_eq!(summary, sandbox.summary());
    assert!(sandbox.files() == before, "a file has changed");
    sandbox.run(&TINY).is(2, &["already holds a result", "--force"]);
    assert!(sandbox.files() == before, "a file has changed");
}

/// The leftovers of a run killed before its first checkpoint: only the lock, half a run.json, or all of it.
fn killed_at_once(leftover: &str, record: &str) -> Sandbox {
    let sandbox = Sandbox::new();
    fs::create_dir(sandbox.out("")).unwrap();
    fs::write(sandbox.out("run.lock"), "process 1, since long ago\n").unwrap();
    match leftover {
        "half a run.json" => fs::write(sandbox.out("run.json.part"), &record[..record.len() / 2]).unwrap(),
        "a run.json" => fs::write(sandbox.out("run.json"), record).unwrap(),
        _ => {}
    }
    sandbox
}

#[test]
fn a_run_killed_before_its_first_checkpoint_can_be_started_again() {
    let first = Sandbox::new();
    let mut run = first.start_held(&TINY);
    let record = first.text("run.json");
    run.signal("KILL");
    run.end();
    for leftover in ["a lock", "half a run.json", "a run.json"] {
        for start in ["--resume", "--auto-resume", "--force"] {
            let sandbox = killed_at_once(leftover, &record);
            sandbox.start_held(&with(&[start]));
            assert!(!sandbox.out("run.json.part").exists(), "{leftover}, {start}");
        }
    }
    killed_at_once("a lock", &record).start_held(&TINY);
    let refusal = killed_at_once("a run.json", &record).run(&TINY);
    refusal.is(2, &["stopped before its end", "--resume", "--force"]);
}

#[test]
fn a_stopped_run_wants_a_word_and_the_same_case() {
    let sandbox = Sandbox::new();
    let mut run = sandbox.start_held(&[]);
    run.signal("INT");
    run.end().is(130, &["--resume continues from"]);
    let before = sandbox.files();
    sandbox.run(&[]).is(2, &["stopped before its end", "--resume", "--force"]);
    for start in ["--resume", "--auto-resume"] {
        let other = sandbox.run(&[start, "--set", "soil.friction_angle=34 deg"]);
        other.is(2, &["another case file (or of other values of its keys)", "--force", "-o DIR"]);
    }
    assert!(sandbox.files() == before, "a file has changed");
    sandbox
        .start(&["--force"])
        .wait_for("a new run", |p| p.lines() > 5 && !p.text("run.log").contains("stopped"));
}

#[test]
fn a_killed_run_goes_on_to_the_same_result() {
    let (whole, sandbox) = (Sandbox::new(), Sandbox::new());
    whole.run(&[]).is(0, &["done"]);
    sandbox.killed(&[]);
    sandbox.run(&["--auto-resume"]).is(0, &["done"]);
    assert!(sandbox.text("run.log").contains("resumed at t = "), "{}", sandbox.text("run.log"));
    assert!(sandbox.histories() == whole.histories() && sandbox.is_tidy());
}

#[test]
fn no_home_and_a_dumb_terminal_are_no_trouble() {
    let sandbox = Sandbox::new();
    let reply = sandbox.script("env -i LANG=C TERM=dumb \"$@\"", &TINY).is(0, &["done"]);
    assert!(!reply.err.contains('\u{1b}') && !reply.out.contains('\u{1b}'));
    let wrong = sandbox.script("env -i LANG=C TERM=dumb \"$@\"", &["--set", "soil.nonsense=1"]);
    assert!(!wrong.is(2, &["nonsense"]).err.contains('\u{1b}'));
}
