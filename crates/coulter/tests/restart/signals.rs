//! Signals: which code a run ends with, and which it goes on after.

use super::place::Place;

#[test]
fn each_signal_has_its_exit_code() {
    for (signal, code) in [("INT", 130), ("TERM", 143), ("HUP", 129)] {
        let place = Place::new();
        let mut run = place.start(&[]);
        run.wait_until_under_way();
        run.signal(signal);
        run.end().is(code, &["stopped", "--resume", "last.checkpoint"]);
        let log = place.text("run.log");
        assert!(log.contains(&format!("stopped by signal {} at t = ", code - 128)), "{log}");
        assert!(place.is_tidy() && place.out("report.html").is_file());
    }
}

#[test]
fn a_hangup_does_not_stop_a_run_under_nohup() {
    let place = Place::new();
    let script = "trap '' HUP; \"$@\" & run=$!; until [ $(wc -l <out/forces.csv) -gt 5 ]; do kill -0 $run || exit 9; sleep 0.01; done 2>/dev/null; \
        kill -s HUP $run && wait $run";
    place.script(script, &[]).is(0, &["done"]);
    assert!(!place.text("run.log").contains("stopped by signal"));
}

#[test]
fn a_checkpoint_can_be_asked_for() {
    let place = Place::new();
    let mut run = place.start(&["--set", "output.checkpoint_interval=1 h"]);
    run.wait_until_under_way();
    assert!(!place.text("run.log").contains("checkpoint at"));
    run.signal("USR1");
    run.wait_for("the checkpoint", |place| place.text("run.log").contains("checkpoint at t = "));
    assert!(place.has_checkpoints());
    run.end().is(0, &["done"]);
}

#[test]
fn a_second_stop_ends_at_once() {
    let place = Place::new();
    let mut run = place.start(&[]);
    run.wait_until_under_way();
    // Both wait for it: it has no time to write anything between them.
    run.hold();
    run.signal("TERM");
    run.signal("INT");
    run.go_on();
    let code = run.end().code;
    assert!(code == Some(130) || code == Some(143), "{code:?}");
    assert!(!place.text("run.log").contains("stopped by signal"), "{}", place.text("run.log"));
    place.start(&["--resume"]).wait_for("the run to go on", |p| p.text("run.log").contains("resumed at"));
}

#[test]
fn nobody_needs_to_listen() {
    let place = Place::new();
    let script = "set -o pipefail; \"$@\" 2>&1 | head -1; exit ${PIPESTATUS[0]}";
    place.script(script, &[]).is(0, &[]);
    for file in ["report.html", "summary.json", "forces.csv", "checkpoints/last.checkpoint"] {
        assert!(place.out(file).is_file(), "{file} is missing");
    }
    assert!(place.text("run.log").contains("finished after") && place.is_tidy());
}
