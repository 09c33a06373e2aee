//! A full disk, a limit on the size of files, folders that cannot be written: clear messages, and nothing is
//! lost.

use super::sandbox::{Sandbox, TINY};
use std::fs;
use std::os::unix::fs::symlink;

/// Runs with files of 100 KiB at most; checkpoints and fields grow beyond that soon after the start.
fn limited(sandbox: &Sandbox, trap: &str, arguments: &[&str]) -> String {
    let reply = sandbox.script(&format!("ulimit -f 100; {trap} exec \"$@\""), arguments);
    reply.is(2, &["cannot write", "File too large", "--resume continues"]).err
}

/// Whether every history is a prefix of that of the whole run, and the resumed run reaches the same end.
#[track_caller]
fn reaches_the_end_of(sandbox: &Sandbox, whole: &Sandbox, arguments: &[&str]) {
    assert!(sandbox.is_tidy(), "half a file is left");
    for (so_far, all) in sandbox.histories().iter().zip(&whole.histories()).take(3) {
        // How far it came is up to the wall clock, by which checkpoints are written.
        assert!(so_far.lines().count() > 1 && all.starts_with(so_far.as_str()));
    }
    sandbox.report().is(0, &[]);
    sandbox.run(&[arguments, &["--resume"]].concat()).is(0, &["done"]);
    assert!(sandbox.text("run.log").contains("resumed at t = "), "{}", sandbox.text("run.log"));
    assert!(sandbox.histories() == whole.histories() && sandbox.is_tidy());
}

#[test]
fn a_checkpoint_that_does_not_fit_leaves_the_one_before() {
    let whole = Sandbox::new();
    let rare = ["--set", "output.field_interval=1 h"];
    whole.run(&rare).is(0, &[]);
    // With SIGXFSZ ignored by the parent process, and not ignored.
    for trap in ["trap '' XFSZ;", ""] {
        let sandbox = Sandbox::new();
        let reply = limited(&sandbox, trap, &rare);
        assert!(reply.contains("checkpoints/last.checkpoint.part: File too large"), "{reply}");
        assert!(sandbox.out("checkpoints/last.checkpoint").is_file());
        reaches_the_end_of(&sandbox, &whole, &rare);
    }
}

#[test]
fn fields_that_do_not_fit_leave_the_run_to_go_on_with() {
    let whole = Sandbox::new();
    let rare = ["--set", "output.checkpoint_interval=1 h"];
    whole.run(&rare).is(0, &[]);
    let sandbox = Sandbox::new();
    let reply = limited(&sandbox, "", &rare);
    assert!(reply.contains("fields/soil_0001.vtr: File too large"), "{reply}");
    reaches_the_end_of(&sandbox, &whole, &rare);
}

#[test]
fn a_disk_that_is_full_when_a_run_goes_on_costs_nothing() {
    let (whole, sandbox) = (Sandbox::new(), Sandbox::new());
    whole.run(&[]).is(0, &[]);
    sandbox.killed(&[]);
    // Less than its history takes already.
    let full = sandbox.script("ulimit -f 4; exec \"$@\"", &["--resume"]);
    full.is(2, &["cannot write", "File too large", "--resume continues"]);
    // A link to a full device is none of its files.
    for name in ["forces.csv", "run.log"] {
        let (path, aside) = (sandbox.out(name), sandbox.out("").with_file_name(name));
        fs::rename(&path, &aside).unwrap();
        symlink("/dev/full", &path).unwrap();
        sandbox.run(&["--resume"]).is(2, &[name, "it is a link", "--resume continues"]);
        fs::rename(&aside, &path).unwrap();
    }
    sandbox.run(&["--resume"]).is(0, &["done"]);
    assert!(sandbox.histories() == whole.histories() && sandbox.is_tidy());
}

#[test]
fn a_folder_that_cannot_be_made_is_named() {
    let sandbox = Sandbox::new();
    let below_a_file = sandbox.out("").with_file_name("case.toml").join("out");
    for folder in [below_a_file.to_str().unwrap(), "/proc/coulter/out", "/proc/coulter"] {
        // A second `-o` would be refused: the script has its own command line.
        let reply = sandbox.script("\"$1\" run case.toml -o \"${@: -1}\"", &[folder]);
        reply.is(2, &["cannot create the folder", folder]);
    }
    let file = sandbox.out("").with_file_name("case.toml");
    sandbox.script("\"$1\" run case.toml -o case.toml", &TINY).is(2, &["is a file, not a folder", "-o DIR"]);
    assert!(file.is_file());
}

#[test]
fn other_commands_survive_a_limit_as_well() {
    let sandbox = Sandbox::new();
    sandbox.run(&TINY).is(0, &[]);
    let before = sandbox.text("report.html");
    let report = sandbox.script("ulimit -f 100; exec \"$1\" report out", &[]);
    report.is(2, &["report.html: File too large"]);
    assert!(sandbox.text("report.html") == before && sandbox.is_tidy());
}
