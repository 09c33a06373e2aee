//! Checkpoints that are damaged: the one before, or words that say what to do.

use super::place::Place;
use std::fs;

/// A way to harm the bytes of a checkpoint.
type Damage = fn(&mut Vec<u8>);

const FLIPPED: Damage = |bytes| {
    let middle = bytes.len() / 2;
    bytes[middle] ^= 1;
};
const CUT: Damage = |bytes| bytes.truncate(bytes.len() / 3);
const EMPTY: Damage = Vec::clear;
/// As a later version would have it.
const OTHER_VERSION: Damage = |bytes| bytes[7] = b'~';

fn damage(place: &Place, name: &str, harm: Damage) {
    let path = place.out(&format!("checkpoints/{name}.checkpoint"));
    let mut bytes = fs::read(&path).unwrap();
    harm(&mut bytes);
    fs::write(path, bytes).unwrap();
}

#[test]
fn a_damaged_checkpoint_gives_way_to_the_one_before() {
    let whole = Place::new();
    whole.run(&[]).is(0, &[]);
    for (harm, word) in [(FLIPPED, "damaged"), (CUT, "damaged"), (EMPTY, "not a Coulter checkpoint")] {
        let place = Place::new();
        place.killed(&[]);
        damage(&place, "last", harm);
        place.run(&["--resume"]).is(0, &["done"]);
        let log = place.text("run.log");
        let line = log.lines().find(|line| line.contains("fell back to the previous checkpoint"));
        assert!(line.is_some_and(|l| l.contains(word) && l.contains("last.checkpoint")), "{log}");
        assert!(log.contains("resumed at t = ") && place.histories() == whole.histories());
    }
}

#[test]
fn a_damaged_checkpoint_never_takes_the_place_of_a_good_one() {
    let place = Place::new();
    place.killed(&[]);
    damage(&place, "last", FLIPPED);
    let mut run = place.start(&["--resume"]);
    run.wait_for("the run to go on", |place| place.text("run.log").contains("resumed at"));
    run.signal("TERM");
    run.end().is(143, &[]);
    // One checkpoint was written at the stop, or two: whichever is the one before the last now is whole.
    damage(&place, "last", CUT);
    let goes_on = |p: &Place| p.text("run.log").matches("resumed at").count() == 2;
    place.start(&["--resume"]).wait_for("the run to go on", goes_on);
}

#[test]
fn without_a_whole_checkpoint_a_person_is_asked_and_a_scheduler_starts_again() {
    let place = Place::new();
    place.killed(&[]);
    damage(&place, "last", FLIPPED);
    damage(&place, "previous", CUT);
    place.run(&["--resume"]).is(2, &["checkpoint", "damaged", "use --force to start again"]);
    place
        .start(&["--auto-resume"])
        .wait_for("a new run", |p| p.text("run.log").contains("started again") && p.lines() > 5);
    let log = place.text("run.log");
    assert!(log.contains("started again, because ") && log.contains("damaged"), "{log}");
}

#[test]
fn a_checkpoint_of_another_version_is_called_so() {
    let place = Place::new();
    place.killed(&[]);
    damage(&place, "last", OTHER_VERSION);
    damage(&place, "previous", OTHER_VERSION);
    place.run(&["--resume"]).is(2, &["written by another version of Coulter", "--force"]);
}

#[test]
fn a_breakdown_leaves_what_failed_and_what_was_good() {
    let place = Place::new();
    let soft = ["--set", "soil.young_modulus=100 Pa"];
    let told = place.run(&soft).is(1, &["t = ", "step", "failed.checkpoint"]);
    assert!(place.out("checkpoints/failed.checkpoint").is_file());
    assert!(place.out("checkpoints/last.checkpoint").is_file());
    let cause = told.err.lines().find_map(|line| line.strip_prefix("error: ")).unwrap().to_owned();
    let before = place.files();
    let again = place.run(&[&soft[..], &["--auto-resume"]].concat());
    again.is(1, &["broke down before", &cause, "--force"]);
    assert!(place.files() == before, "a file has changed");
    // From the good one it comes to the same end.
    place.run(&[&soft[..], &["--resume"]].concat()).is(1, &[&cause]);
    assert!(place.text("run.log").contains("resumed at"));
    place
        .start(&["--force"])
        .wait_for("a new run", |p| !p.text("run.log").contains("broke down") && p.lines() > 5);
    assert!(!place.out("checkpoints/failed.checkpoint").exists());
}
