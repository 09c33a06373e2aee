//! Damaged checkpoints: fallback to the previous one, or a message that says what to do.

use super::sandbox::Sandbox;
use std::fs;

/// A way to damage the bytes of a checkpoint.
type Damage = fn(&mut Vec<u8>);

const FLIPPED: Damage = |bytes| {
    let middle = bytes.len() / 2;
    bytes[middle] ^= 1;
};
const CUT: Damage = |bytes| bytes.truncate(bytes.len() / 3);
const EMPTY: Damage = Vec::clear;
/// The version of a later and of an earlier format.
const LATER: Damage = |bytes| bytes[7] = b'~';
const EARLIER: Damage = |bytes| bytes[7] = b'A';

fn damage(sandbox: &Sandbox, name: &str, harm: Damage) {
    let path = sandbox.out(&format!("checkpoints/{name}.checkpoint"));
    let mut bytes = fs::read(&path).unwrap();
    harm(&mut bytes);
    fs::write(path, bytes).unwrap();
}

#[test]
fn a_damaged_checkpoint_gives_way_to_the_one_before() {
    let whole = Sandbox::new();
    whole.run(&[]).is(0, &[]);
    for (harm, word) in [(FLIPPED, "damaged"), (CUT, "damaged"), (EMPTY, "not a Coulter checkpoint")] {
        let sandbox = Sandbox::new();
        sandbox.killed(&[]);
        damage(&sandbox, "last", harm);
        sandbox.run(&["--resume"]).is(0, &["done"]);
        let log = sandbox.text("run.log");
        let line = log.lines().find(|line| line.contains("fell back to the previous checkpoint"));
        assert!(line.is_some_and(|l| l.contains(word) && l.contains("last.checkpoint")), "{log}");
        assert!(log.contains("resumed at t = ") && sandbox.histories() == whole.histories());
    }
}

#[test]
fn a_damaged_checkpoint_never_takes_the_place_of_a_good_one() {
    let sandbox = Sandbox::new();
    sandbox.killed(&[]);
    damage(&sandbox, "last", FLIPPED);
    let mut run = sandbox.start_held(&["--resume"]);
    assert!(sandbox.text("run.log").contains("resumed at"));
    run.signal("TERM");
    run.end().is(143, &[]);
    // One or two checkpoints were written at the stop: in either case the previous one is intact.
    damage(&sandbox, "last", CUT);
    let goes_on = |p: &Sandbox| p.text("run.log").matches("resumed at").count() == 2;
    sandbox.start(&["--resume"]).wait_for("the run to continue", goes_on);
}

#[test]
fn without_a_whole_checkpoint_a_person_is_asked_and_a_scheduler_starts_again() {
    let sandbox = Sandbox::new();
    sandbox.killed(&[]);
    damage(&sandbox, "last", FLIPPED);
    damage(&sandbox, "previous", CUT);
    sandbox.run(&["--resume"]).is(2, &["checkpoint", "damaged", "use --force to start again"]);
    sandbox
        .start(&["--auto-resume"])
        .wait_for("a new run", |p| p.text("run.log").contains("started again") && p.lines() > 5);
    let log = sandbox.text("run.log");
    assert!(log.contains("started again, because ") && log.contains("damaged"), "{log}");
}

#[test]
fn a_checkpoint_of_another_version_is_called_so() {
    let sandbox = Sandbox::new();
    sandbox.killed(&[]);
    for (harm, words) in [
        (LATER, ["written by a newer version of Coulter", "install", "--force"]),
        (EARLIER, ["written by an older version of Coulter", "finish the run with that one", "--force"]),
    ] {
        damage(&sandbox, "last", harm);
        damage(&sandbox, "previous", harm);
        sandbox.run(&["--resume"]).is(2, &words);
    }
}

#[test]
fn a_breakdown_leaves_what_failed_and_what_was_good() {
    let sandbox = Sandbox::new();
    let heavy = ["--set", r#"body.disc.heave={ load = "-50000 N" }"#];
    let reply = sandbox.run(&heavy).is(1, &["t = ", "step", "failed.checkpoint"]);
    assert!(sandbox.out("checkpoints/failed.checkpoint").is_file());
    assert!(sandbox.out("checkpoints/last.checkpoint").is_file());
    let cause = reply.err.lines().find_map(|line| line.strip_prefix("error: ")).unwrap().to_owned();
    let before = sandbox.files();
    let again = sandbox.run(&[&heavy[..], &["--auto-resume"]].concat());
    again.is(1, &["broke down before", &cause, "--force"]);
    assert!(sandbox.files() == before, "a file has changed");
    // Resumed from the good one it fails in the same way.
    sandbox.run(&[&heavy[..], &["--resume"]].concat()).is(1, &[&cause]);
    assert!(sandbox.text("run.log").contains("resumed at"));
    sandbox
        .start(&["--force"])
        .wait_for("a new run", |p| !p.text("run.log").contains("broke down") && p.lines() > 5);
    assert!(!sandbox.out("checkpoints/failed.checkpoint").exists());
}
