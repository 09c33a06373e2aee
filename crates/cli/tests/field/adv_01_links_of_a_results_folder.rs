//! A results folder from a stranger: its links must lead nowhere, whatever they are called and however the
//! folder is used.

use super::strangers::{CASE, copied, lead_outside, run, sh, snapshot};
use super::support::Desk;
use std::fs;

/// A finished run that claims to have been stopped, so that it can be resumed, in the folder `whole`; and a
/// folder `outside`.
fn stopped() -> Desk {
    let desk = Desk::with(&[("c.toml", CASE)]);
    run(&desk, "whole");
    let record = desk.read("whole/run.json");
    assert!(record.contains("\"outcome\": \"finished\""), "{record}");
    desk.write("whole/run.json", record.replace("\"finished\"", "\"interrupted\"").as_bytes());
    fs::create_dir(desk.path().join("outside")).unwrap();
    desk
}

#[test]
fn no_link_is_followed_when_a_run_is_resumed() {
    let desk = stopped();
    let (whole, taken, outside) =
        (desk.path().join("whole"), desk.path().join("taken"), desk.path().join("outside"));
    let names = [
        "run.lock",
        "run.json",
        "run.log",
        "forces.csv",
        "boundaries.csv",
        "report.html",
        "checkpoints/last.checkpoint",
        "fields",
        "checkpoints",
        "pictures",
    ];
    for name in names {
        copied(&whole, &taken);
        lead_outside(&taken, name, &outside);
        let before = snapshot(&outside);
        let answer = desk.coulter(&["run", "c.toml", "-o", "taken", "--resume", "--threads", "1"]);
        assert_eq!(snapshot(&outside), before, "{name}");
        let last = name.rsplit('/').next().unwrap();
        assert_eq!(answer.code, 2, "{name}: {}{}", answer.out, answer.error);
        answer.says(&[last, "is a link"]);
    }
}

#[test]
fn no_mode_follows_the_link_of_a_lock() {
    let desk = stopped();
    for mode in [None, Some("--force"), Some("--resume"), Some("--auto-resume")] {
        for dangling in [true, false] {
            copied(&desk.path().join("whole"), &desk.path().join("taken"));
            desk.write("outside/victim", b"keep");
            let target = if dangling { "../outside/none" } else { "../outside/victim" };
            std::os::unix::fs::symlink(target, desk.path().join("taken/run.lock")).unwrap();
            let mut arguments = vec!["run", "c.toml", "-o", "taken", "--threads", "1"];
            arguments.extend(mode);
            desk.expect(2, &arguments).says(&["run.lock", "is a link"]);
            assert_eq!(desk.read("outside/victim"), "keep");
            assert!(!desk.path().join("outside/none").exists());
        }
    }
}

/// `--force` empties the folder of a run, and nothing behind a link of one of its folders.
#[test]
fn what_is_replaced_lies_in_the_folder() {
    let desk = stopped();
    let (whole, taken, outside) =
        (desk.path().join("whole"), desk.path().join("taken"), desk.path().join("outside"));
    for name in ["fields", "variations"] {
        copied(&whole, &taken);
        if name == "variations" {
            copied(&whole, &outside.join("run"));
            std::os::unix::fs::symlink(&outside, taken.join(name)).unwrap();
        } else {
            lead_outside(&taken, name, &outside);
        }
        let before = snapshot(&outside);
        desk.coulter(&["run", "c.toml", "-o", "taken", "--force", "--threads", "1"]);
        assert_eq!(snapshot(&outside), before, "{name}");
    }
    // A pipe does not make it wait.
    copied(&whole, &taken);
    let made = sh(&desk, "rm taken/run.log && mkfifo taken/run.log");
    assert!(made.status.success());
    desk.expect(2, &["run", "c.toml", "-o", "taken", "--resume"]).says(&["run.log", "a pipe or a device"]);
}

/// A report shows nothing that lies outside: it may be passed on.
#[test]
fn a_report_reads_no_link() {
    let desk = stopped();
    desk.write("secret", b"SECRET = 1\n");
    for name in ["case.toml", "resolved.toml", "pictures/profile.svg", "forces.csv"] {
        copied(&desk.path().join("whole"), &desk.path().join("taken"));
        fs::remove_file(desk.path().join("taken").join(name)).unwrap();
        std::os::unix::fs::symlink(desk.path().join("secret"), desk.path().join("taken").join(name)).unwrap();
        desk.expect(2, &["report", "taken"]).says(&["is a link"]);
        assert!(!desk.read("taken/report.html").contains("SECRET"));
    }
    let listed = desk.read("whole/surface.pvd");
    copied(&desk.path().join("whole"), &desk.path().join("taken"));
    desk.write(
        "taken/surface.pvd",
        listed.replace("fields/surface_0000", "../whole/fields/surface_0000").as_bytes(),
    );
    desk.expect(2, &["render", "taken"]).says(&["leads out of the folder"]);
}

#[test]
fn the_folder_itself_may_be_a_link() {
    let desk = Desk::with(&[("c.toml", CASE)]);
    fs::create_dir(desk.path().join("disk")).unwrap();
    std::os::unix::fs::symlink("disk", desk.path().join("o")).unwrap();
    run(&desk, "o/");
    assert!(desk.path().join("disk/report.html").exists());
}
