//! Folders that came from others: what they hold, and what must not be reached from them.

use super::support::Desk;
use std::collections::BTreeMap;
use std::fs;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A run of a few steps.
pub(crate) const CASE: &str = r#"format = 2
soil = { law = "mohr-coulomb", friction_angle = "35 deg", unit_weight = "16 kN/m^3", young_modulus = "1 MPa" }
domain = { plane_strain = true }
grid = { cell = "30 mm", growth = 1.4 }
run = { duration = "2 ms" }
output = { field_interval = "1 ms", checkpoint_interval = "1 ms" }
[body.b]
shape = "block"
size = ["0.12 m", "0.12 m"]
friction = 0.3
sinkage = "60 mm"
forward = { speed = "0.4 m/s" }
"#;

/// Its closed forms at two points.
pub(crate) const STUDY: &str = r#"format = 2
case = "c.toml"
[factor.a]
key = "soil.young_modulus"
values = ["1 MPa", "2 MPa"]
"#;

/// Every file below a folder, with its content; links are named and not followed.
pub(crate) fn snapshot(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() && !path.is_symlink() {
            found.insert(path.clone(), Vec::new());
            found.extend(snapshot(&path));
        } else {
            found.insert(
                path.clone(),
                if path.is_symlink() { vec![0] } else { fs::read(&path).unwrap_or_default() },
            );
        }
    }
    found
}

/// Moves an entry of a folder outside, and puts a link to it in its place.
pub(crate) fn lead_outside(folder: &Path, name: &str, outside: &Path) {
    let there = outside.join(name.replace('/', "_"));
    let entry = folder.join(name);
    if entry.exists() {
        fs::rename(&entry, &there).unwrap();
    } else {
        fs::write(&there, "keep").unwrap();
    }
    symlink(&there, &entry).unwrap();
}

/// A copy of a folder.
pub(crate) fn copied(from: &Path, to: &Path) {
    let _ = fs::remove_dir_all(to);
    let done = Command::new("cp").arg("-r").arg(from).arg(to).status().unwrap();
    assert!(done.success());
}

/// Runs a case into a folder. It is too short to be graded good, which does not matter here.
pub(crate) fn run(desk: &Desk, folder: &str) {
    let answer = desk.coulter(&["run", "c.toml", "-o", folder, "--threads", "1"]);
    assert!(desk.path().join(folder).join("report.html").exists(), "{}{}", answer.out, answer.error);
}

/// `sh -c SCRIPT` in a folder.
pub(crate) fn sh(desk: &Desk, script: &str) -> Output {
    Command::new("sh").arg("-c").arg(script).current_dir(desk.path()).output().unwrap()
}
