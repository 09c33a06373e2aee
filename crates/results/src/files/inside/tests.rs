#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use super::*;
use std::fs;
use std::os::unix::fs::symlink;

/// A folder with an entry of every kind, and beside it a file and a folder that nothing must reach.
fn hostile() -> (tempfile::TempDir, PathBuf) {
    let all = tempfile::tempdir().unwrap();
    let (outside, folder) = (all.path().join("outside"), all.path().join("results"));
    fs::create_dir_all(outside.join("deep")).unwrap();
    fs::create_dir_all(folder.join("fields")).unwrap();
    for file in ["victim", "deep/victim"] {
        fs::write(outside.join(file), "keep").unwrap();
    }
    symlink(outside.join("victim"), folder.join("link")).unwrap();
    symlink("../outside/none", folder.join("dangling")).unwrap();
    symlink("../outside", folder.join("linked")).unwrap();
    symlink("../../outside/victim", folder.join("fields/link")).unwrap();
    fs::hard_link(outside.join("victim"), folder.join("hard")).unwrap();
    rustix::fs::mknodat(
        rustix::fs::CWD,
        folder.join("pipe"),
        rustix::fs::FileType::Fifo,
        rustix::fs::Mode::from_raw_mode(0o600),
        0,
    )
    .unwrap();
    (all, folder)
}

/// Everything that lies outside the folder, with its content.
fn outside(all: &Path) -> Vec<(PathBuf, String)> {
    let top = all.join("outside");
    let mut found: Vec<_> = ["", "deep"]
        .iter()
        .flat_map(|below| fs::read_dir(top.join(below)).unwrap())
        .map(|entry| entry.unwrap().path())
        .map(|path| (path.clone(), fs::read_to_string(&path).unwrap_or_default()))
        .collect();
    found.sort();
    found
}

/// No name, whatever it leads to, and no way of using it reaches what lies outside.
#[test]
fn nothing_outside_is_reached() {
    let absolute = "ABSOLUTE";
    let names = [
        "link",
        "dangling",
        "linked",
        "linked/victim",
        "linked/new",
        "linked/deep/victim",
        "fields/link",
        "pipe",
        "pipe/x",
        "../outside/victim",
        "fields/../../outside/victim",
        "..",
        ".",
        "",
        absolute,
    ];
    for name in names {
        let (all, folder) = hostile();
        let before = outside(all.path());
        let victim = all.path().join("outside/victim");
        let entry = Inside::of(&folder, if name == absolute { &victim } else { Path::new(name) });
        let done = [
            entry.open().map(drop),
            entry.read(1 << 20).map(drop),
            entry.create().map(drop),
            entry.open_or_create().map(drop),
            entry.join("new").create().map(drop),
            entry.join("new").make_folder(),
            Inside::of(&folder, "own").create().and_then(|_| Inside::of(&folder, "own").rename(&entry)),
            entry.rename(&Inside::of(&folder, "moved")).and(Err(io::Error::other("a link may be moved"))),
        ];
        // The folder itself holds new entries.
        let expected = if name.is_empty() || name == "." { 6 } else { done.len() };
        let refused = done.iter().filter(|done| done.is_err()).count();
        assert!(refused >= expected, "{name}: {done:?}");
        let _ = entry.remove();
        assert_eq!(outside(all.path()), before, "{name}");
    }
}

#[test]
fn a_refusal_says_what_the_entry_is_and_what_to_do() {
    let (_all, folder) = hostile();
    let message = |name: &str| Inside::of(&folder, name).open().unwrap_err().to_string();
    assert!(
        message("link").contains("it is a link, which is not followed")
            && message("link").contains("remove it")
    );
    assert!(message("linked/victim").contains("its folder linked is a link"), "{}", message("linked/victim"));
    assert!(message("pipe").contains("a pipe or a device"));
    assert!(message("fields").contains("it is a folder; an ordinary file belongs here"));
    assert!(message("../x").contains("leads out of the folder"));
    assert!(Inside::of(&folder, "linked").names().unwrap_err().to_string().contains("is a link"));
    assert!(Inside::of(&folder, "linked").make_folder().unwrap_err().to_string().contains("is a link"));
}

#[test]
fn a_file_keeps_its_content_under_its_other_names() {
    let (all, folder) = hostile();
    let hard = Inside::of(&folder, "hard");
    assert!(hard.open_or_create().unwrap_err().to_string().contains("a hard link"));
    assert_eq!(hard.read(100).unwrap(), b"keep");
    drop(hard.create().unwrap());
    assert_eq!(hard.read(100).unwrap(), b"");
    assert_eq!(fs::read_to_string(all.path().join("outside/victim")).unwrap(), "keep");
}

#[test]
fn ordinary_entries_are_used_and_the_folder_itself_may_be_a_link() {
    let all = tempfile::tempdir().unwrap();
    fs::create_dir(all.path().join("true")).unwrap();
    symlink("true", all.path().join("named")).unwrap();
    let entry = Inside::of(&all.path().join("named"), "runs/a/file");
    assert_eq!(entry.kind().unwrap(), None);
    entry.beside("").make_folder().unwrap();
    io::Write::write_all(&mut entry.create().unwrap(), b"whole").unwrap();
    assert_eq!(entry.read(5).unwrap(), b"whole");
    assert!(entry.read(4).unwrap_err().to_string().contains("5 bytes"));
    assert_eq!(Inside::of(all.path(), "true/runs").names().unwrap(), ["a"]);
    entry.rename(&entry.beside("other")).unwrap();
    assert!(!entry.exists() && entry.beside("other").exists());
    entry.beside("other").remove().unwrap();
    entry.beside("").remove_folder().unwrap();
    assert!(!entry.beside("").is_folder());
    assert_eq!(Inside::of(all.path(), "nowhere").names().unwrap(), Vec::<OsString>::new());
}
