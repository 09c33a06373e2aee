//! A full disk, a limit on the size of files, folders that cannot be written: clear words, and nothing is lost.

use super::place::{Place, TINY};
use std::fs;
use std::os::unix::fs::symlink;

/// Runs with files of 100 KiB at most; checkpoints and fields grow beyond that soon after the start.
fn limited(place: &Place, trap: &str, arguments: &[&str]) -> String {
    let told = place.script(&format!("ulimit -f 100; {trap} exec \"$@\""), arguments);
    told.is(2, &["cannot write", "File too large", "--resume continues"]).err
}

/// Whether every history is how that of the whole run begins, and the run goes on to the same end.
#[track_caller]
fn goes_on_to(place: &Place, whole: &Place, arguments: &[&str]) {
    assert!(place.is_tidy(), "half a file is left");
    for (so_far, all) in place.histories().iter().zip(&whole.histories()).take(3) {
        assert!(so_far.lines().count() > 5 && all.starts_with(so_far.as_str()));
    }
    place.report().is(0, &[]);
    place.run(&[arguments, &["--resume"]].concat()).is(0, &["done"]);
    assert!(place.text("run.log").contains("resumed at t = "), "{}", place.text("run.log"));
    assert!(place.histories() == whole.histories() && place.is_tidy());
}

#[test]
fn a_checkpoint_that_does_not_fit_leaves_the_one_before() {
    let whole = Place::new();
    let rare = ["--set", "output.field_interval=1 h"];
    whole.run(&rare).is(0, &[]);
    // With the signal ignored by whoever started it, and not.
    for trap in ["trap '' XFSZ;", ""] {
        let place = Place::new();
        let told = limited(&place, trap, &rare);
        assert!(told.contains("checkpoints/last.checkpoint.part: File too large"), "{told}");
        assert!(place.out("checkpoints/last.checkpoint").is_file());
        goes_on_to(&place, &whole, &rare);
    }
}

#[test]
fn fields_that_do_not_fit_leave_the_run_to_go_on_with() {
    let whole = Place::new();
    let rare = ["--set", "output.checkpoint_interval=1 h"];
    whole.run(&rare).is(0, &[]);
    let place = Place::new();
    let told = limited(&place, "", &rare);
    assert!(told.contains("fields/soil_0001.vtr: File too large"), "{told}");
    goes_on_to(&place, &whole, &rare);
}

#[test]
fn a_disk_that_is_full_when_a_run_goes_on_costs_nothing() {
    let (whole, place) = (Place::new(), Place::new());
    whole.run(&[]).is(0, &[]);
    place.killed(&[]);
    for name in ["forces.csv", "run.log"] {
        let (path, aside) = (place.out(name), place.out("").with_file_name(name));
        fs::rename(&path, &aside).unwrap();
        symlink("/dev/full", &path).unwrap();
        place
            .run(&["--resume"])
            .is(2, &["cannot write", name, "No space left on device", "--resume continues"]);
        fs::rename(&aside, &path).unwrap();
    }
    place.run(&["--resume"]).is(0, &["done"]);
    assert!(place.histories() == whole.histories() && place.is_tidy());
}

#[test]
fn a_folder_that_cannot_be_made_is_named() {
    let place = Place::new();
    let below_a_file = place.out("").with_file_name("case.toml").join("out");
    for folder in [below_a_file.to_str().unwrap(), "/proc/coulter/out", "/proc/coulter"] {
        // The last `-o` would be refused as a second one: the whole line is the script's.
        let told = place.script("\"$1\" run case.toml -o \"${@: -1}\"", &[folder]);
        told.is(2, &["cannot create the folder", folder]);
    }
    let file = place.out("").with_file_name("case.toml");
    place.script("\"$1\" run case.toml -o case.toml", &TINY).is(2, &["is a file, not a folder", "-o DIR"]);
    assert!(file.is_file());
}

#[test]
fn other_commands_survive_a_limit_as_well() {
    let place = Place::new();
    place.run(&TINY).is(0, &[]);
    let before = place.text("report.html");
    let report = place.script("ulimit -f 20; exec \"$1\" report out", &[]);
    report.is(2, &["report.html: File too large"]);
    assert!(place.text("report.html") == before && place.is_tidy());
}
