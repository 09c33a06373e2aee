//! A study folder from a stranger: neither an id nor a link leads out of it.

use super::adv_02_ids_in_scripts::study_with;
use super::strangers::{CASE, STUDY, snapshot};
use super::support::Desk;
use std::fs;
use std::os::unix::fs::symlink;

#[test]
fn an_id_is_no_path() {
    for id in ["../../evil", "/elsewhere/evil", "..", "a/b"] {
        let desk = study_with(id);
        let before = snapshot(desk.path());
        desk.expect(2, &["sweep", "run", "so"]);
        desk.expect(2, &["sweep", "run", "so", "--id", id]);
        assert_eq!(snapshot(desk.path()), before, "{id}");
    }
}

#[test]
fn linked_folders_of_a_study_are_refused() {
    for name in ["outcomes", "runs", "charts", "figures", "tables"] {
        let desk = Desk::with(&[("c.toml", CASE), ("s.toml", STUDY)]);
        desk.expect(0, &["sweep", "expand", "s.toml", "-o", "so"]);
        let (outside, there) = (desk.path().join("outside"), desk.path().join("so").join(name));
        fs::create_dir(&outside).unwrap();
        let _ = fs::remove_dir_all(&there);
        symlink(&outside, &there).unwrap();
        for step in
            [&["sweep", "run", "so"][..], &["sweep", "collect", "so"], &["sweep", "s.toml", "-o", "so"]]
        {
            let answer = desk.coulter(step);
            assert!(fs::read_dir(&outside).unwrap().next().is_none(), "{name}: {step:?}");
            // Charts and tables are written at the end only.
            if ["outcomes", "runs"].contains(&name) {
                assert_eq!(answer.code, 2, "{name}: {step:?}");
                answer.says(&[name, "is a link"]);
            }
        }
    }
}

#[test]
fn linked_files_of_a_study_are_refused() {
    for name in ["table.csv", "report.html", "table.parquet", "cases.jsonl", "origin.json", "case.toml"] {
        let desk = Desk::with(&[("c.toml", CASE), ("s.toml", STUDY)]);
        desk.expect(0, &["sweep", "expand", "s.toml", "-o", "so"]);
        let (outside, there) = (desk.path().join("victim"), desk.path().join("so").join(name));
        if there.exists() {
            fs::rename(&there, &outside).unwrap();
        } else {
            fs::write(&outside, "keep").unwrap();
        }
        let before = fs::read(&outside).unwrap();
        symlink("../victim", &there).unwrap();
        desk.expect(2, &["sweep", "collect", "so"]).says(&[name, "is a link"]);
        assert_eq!(fs::read(&outside).unwrap(), before, "{name}");
    }
}
