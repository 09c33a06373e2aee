//! Folders in which a run was, in every state, and the ways to start in them.

use super::place::{Place, TINY};
use std::fs;

fn with<'a>(start: &'a [&'a str]) -> Vec<&'a str> {
    [start, &TINY[..]].concat()
}

#[test]
fn resume_starts_where_there_is_nothing() {
    for start in ["--resume", "--auto-resume"] {
        let place = Place::new();
        fs::create_dir(place.out("")).unwrap();
        place.run(&with(&[start])).is(0, &["done"]);
        assert!(place.out("report.html").is_file() && place.is_tidy());
    }
}

#[test]
fn a_finished_run_is_left_as_it_is_by_a_scheduler() {
    let place = Place::new();
    place.run(&TINY).is(0, &[]);
    let before = place.files();
    let told = place.run(&with(&["--auto-resume", "--json"])).is(0, &[]);
    let summary: serde_json::Value = serde_json::from_str(&told.out).unwrap();
    assert_eq!(summary, place.summary());
    assert!(place.files() == before, "a file has changed");
    place.run(&TINY).is(2, &["already holds a result", "--force"]);
    assert!(place.files() == before, "a file has changed");
}

/// What a run leaves that is killed before its first checkpoint: the lock alone, half a run.json, all of it.
fn killed_at_once(leftover: &str, record: &str) -> Place {
    let place = Place::new();
    fs::create_dir(place.out("")).unwrap();
    fs::write(place.out("run.lock"), "process 1, since long ago\n").unwrap();
    match leftover {
        "half a run.json" => fs::write(place.out("run.json.part"), &record[..record.len() / 2]).unwrap(),
        "a run.json" => fs::write(place.out("run.json"), record).unwrap(),
        _ => {}
    }
    place
}

#[test]
fn a_run_killed_before_its_first_checkpoint_can_be_started_again() {
    let first = Place::new();
    let mut run = first.start(&TINY);
    run.wait_for("a run.json", |place| place.out("run.json").is_file());
    let record = first.text("run.json");
    run.signal("KILL");
    run.end();
    for leftover in ["a lock", "half a run.json", "a run.json"] {
        for start in ["--resume", "--auto-resume", "--force"] {
            let place = killed_at_once(leftover, &record);
            place.start(&with(&[start])).wait_until_under_way();
            assert!(!place.out("run.json.part").exists(), "{leftover}, {start}");
        }
    }
    killed_at_once("a lock", &record).start(&TINY).wait_until_under_way();
    let refusal = killed_at_once("a run.json", &record).run(&TINY);
    refusal.is(2, &["stopped before its end", "--resume", "--force"]);
}

#[test]
fn a_stopped_run_wants_a_word_and_the_same_case() {
    let place = Place::new();
    let mut run = place.start(&[]);
    run.wait_until_under_way();
    run.signal("INT");
    run.end().is(130, &["--resume continues from"]);
    let before = place.files();
    place.run(&[]).is(2, &["stopped before its end", "--resume", "--force"]);
    for start in ["--resume", "--auto-resume"] {
        let other = place.run(&[start, "--set", "soil.friction_angle=34 deg"]);
        other.is(2, &["another case file (or of other values of its keys)", "--force", "-o DIR"]);
    }
    assert!(place.files() == before, "a file has changed");
    place
        .start(&["--force"])
        .wait_for("a new run", |p| p.lines() > 5 && !p.text("run.log").contains("stopped"));
}

#[test]
fn a_killed_run_goes_on_to_the_same_result() {
    let (whole, place) = (Place::new(), Place::new());
    whole.run(&[]).is(0, &["done"]);
    place.killed(&[]);
    place.run(&["--auto-resume"]).is(0, &["done"]);
    assert!(place.text("run.log").contains("resumed at t = "), "{}", place.text("run.log"));
    assert!(place.histories() == whole.histories() && place.is_tidy());
}

#[test]
fn no_home_and_a_dumb_terminal_are_no_trouble() {
    let place = Place::new();
    let told = place.script("env -i LANG=C TERM=dumb \"$@\"", &TINY).is(0, &["done"]);
    assert!(!told.err.contains('\u{1b}') && !told.out.contains('\u{1b}'));
    let wrong = place.script("env -i LANG=C TERM=dumb \"$@\"", &["--set", "soil.nonsense=1"]);
    assert!(!wrong.is(2, &["nonsense"]).err.contains('\u{1b}'));
}
