//! Signals: the exit codes, and the signals after which a run continues.

use super::sandbox::Sandbox;

#[test]
fn each_signal_has_its_exit_code() {
    for (signal, code) in [("INT", 130), ("TERM", 143), ("HUP", 129)] {
        let sandbox = Sandbox::new();
        // Under nohup the tests themselves ignore SIGHUP, and what they start would inherit it.
        let mut run = sandbox.start_script_held("exec env --default-signal=HUP \"$@\"");
        run.signal(signal);
        run.end().is(code, &["stopped", "--resume", "last.checkpoint"]);
        let log = sandbox.text("run.log");
        assert!(log.contains(&format!("stopped by signal {} at t = ", code - 128)), "{log}");
        assert!(sandbox.is_tidy() && sandbox.out("report.html").is_file());
    }
}

#[test]
fn a_hangup_does_not_stop_a_run_under_nohup() {
    let sandbox = Sandbox::new();
    let mut run = sandbox.start_script_held("trap '' HUP; exec \"$@\"");
    run.signal("HUP");
    run.end().is(0, &["done"]);
    assert!(!sandbox.text("run.log").contains("stopped by signal"));
}

#[test]
fn a_checkpoint_can_be_asked_for() {
    let sandbox = Sandbox::new();
    let mut run = sandbox.start_held(&["--set", "output.checkpoint_interval=1 h"]);
    assert!(!sandbox.text("run.log").contains("checkpoint at"));
    run.signal("USR1");
    run.go_on();
    run.hold_at("the checkpoint", |sandbox| sandbox.text("run.log").contains("checkpoint at t = "));
    assert!(sandbox.has_checkpoints());
    run.end().is(0, &["done"]);
}

#[test]
fn a_second_stop_ends_at_once() {
    let sandbox = Sandbox::new();
    let mut run = sandbox.start_held(&[]);
    // Both signals are pending when it continues: it has no time to write anything between them.
    run.signal("TERM");
    run.signal("INT");
    let code = run.end().code;
    assert!(code == Some(130) || code == Some(143), "{code:?}");
    assert!(!sandbox.text("run.log").contains("stopped by signal"), "{}", sandbox.text("run.log"));
    sandbox
        .start(&["--resume"])
        .wait_for("the run to continue", |p| p.text("run.log").contains("resumed at"));
}

#[test]
fn nobody_needs_to_listen() {
    let sandbox = Sandbox::new();
    let script = "set -o pipefail; \"$@\" 2>&1 | head -1; exit ${PIPESTATUS[0]}";
    sandbox.script(script, &[]).is(0, &[]);
    for file in ["report.html", "summary.json", "forces.csv", "checkpoints/last.checkpoint"] {
        assert!(sandbox.out(file).is_file(), "{file} is missing");
    }
    assert!(sandbox.text("run.log").contains("finished after") && sandbox.is_tidy());
}
