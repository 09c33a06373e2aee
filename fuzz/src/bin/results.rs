//! The folder of a run, and of a study in it: a sound one, but for the file whose number is the first byte
//! of an input; the rest is its content.
#![no_main]

use coulter::output::folder::{Contents, clear, inspect};
use coulter::output::tables::{read_history, validate_history};
use coulter::output::{Summary, rebuild_report};
use coulter::run::Start;
use coulter_fuzz::{CASE, Files, file, files, folder, lay, run_small, seed};
use libfuzzer_sys::fuzz_target;
use std::fs;
use std::path::Path;
use std::sync::OnceLock;
use studies::comparison::read_item;
use studies::study;
use studies::sweep::{collect::collect, expand::expand, store::Store};

const STUDY: &str = "format = 2\ncase = \"small.toml\"\n[factor.phi]\nkey = \"soil.friction_angle\"\n\
                     values = [\"30 deg\", \"35 deg\"]\n";

/// The sound folder.
fn sound() -> &'static Files {
    static FILES: OnceLock<Files> = OnceLock::new();
    FILES.get_or_init(|| {
        let top = folder().join("run");
        run_small(&top, Start::Anew, false).expect("it runs");
        file("small.toml", CASE.as_bytes());
        let study = study::read(&file("study.toml", STUDY.as_bytes()), false).expect("the study is valid");
        let lines = expand(&study).expect("it can be expanded");
        Store::create(&top.join("study"), &study, STUDY, &lines).expect("it can be written");
        let mut files = files(&top);
        files.retain(|name, _| !name.starts_with("checkpoints"));
        for (n, content) in files.values().enumerate() {
            seed(&n.to_string(), &[&[n as u8], &content[..]].concat());
        }
        files
    })
}

fn read_run(top: &Path) {
    if let Ok(Contents::Run(record)) = inspect(top) {
        for is_whole in [false, true] {
            if let Ok(history) = read_history(top, &record.names(), is_whole) {
                let _ = (validate_history(&history), record.trust(&history));
            }
        }
    }
    let _ = (Summary::read(top), read_item(top, None, &[]), rebuild_report(top));
}

fn read_study(folder: &Path) {
    if let Ok(store) = Store::open(folder)
        && let (Ok(origin), Ok(lines)) = (store.origin(), store.lines())
        && let version = (origin.study.as_str(), origin.quick)
        && let Ok(study) = study::read_expanded(&store.study_file(), version, origin.cases)
    {
        let _ = collect(&store, &study, &lines);
    }
}

fuzz_target!(init: { sound(); }, |data: &[u8]| {
    let top = folder().join("run");
    let Some((number, content)) = data.split_first() else { return };
    let Some(name) = sound().keys().nth(usize::from(*number)) else { return };
    lay(&top, sound(), (name, content));
    let count = || fs::read_dir(folder()).into_iter().flatten().count();
    let before = count();
    read_run(&top);
    read_study(&top.join("study"));
    let _ = clear(&top, true);
    assert_eq!(count(), before, "something was written or removed outside");
});
