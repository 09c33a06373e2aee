//! One run at a time in a folder.

use super::sandbox::{Sandbox, TINY};
use std::fs;

#[test]
fn a_run_at_work_is_not_disturbed() {
    let (alone, sandbox) = (Sandbox::new(), Sandbox::new());
    alone.run(&[]).is(0, &[]);
    let run = sandbox.start_held(&[]);
    for start in [&[][..], &["--force"], &["--resume"]] {
        let before = sandbox.files();
        sandbox.run(start).is(2, &["another run is using out (process ", "-o DIR"]);
        assert!(sandbox.files() == before, "{start:?} has changed a file");
    }
    run.end().is(0, &["done"]);
    assert!(sandbox.histories() == alone.histories() && sandbox.is_tidy());
}

#[test]
fn a_scheduler_waits_for_the_run_before_unless_it_is_stopped() {
    let sandbox = Sandbox::new();
    let run = sandbox.start_held(&[]);
    let mut stopped = sandbox.start(&["--auto-resume"]);
    stopped.wait_until_it_listens();
    stopped.signal("TERM");
    stopped.end().is(143, &["another run is using"]);
    let waiting = sandbox.start(&["--auto-resume", "--json"]);
    run.end().is(0, &["done"]);
    assert!(waiting.end().is(0, &[]).out.contains("\"trust\""));
    assert!(sandbox.is_tidy());
}

#[test]
fn the_lock_of_a_dead_process_is_none() {
    let sandbox = Sandbox::new();
    sandbox.killed(&[]);
    assert!(sandbox.out("run.lock").is_file(), "a killed run cannot remove it");
    sandbox.run(&["--resume"]).is(0, &["done"]);
    assert!(!sandbox.out("run.lock").exists());
    let other = Sandbox::new();
    fs::create_dir(other.out("")).unwrap();
    fs::write(other.out("run.lock"), "").unwrap();
    other.run(&TINY).is(0, &["done"]);
    assert!(other.is_tidy());
}
