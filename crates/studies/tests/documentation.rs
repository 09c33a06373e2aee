//! What is shipped of study files follows from the tables of keys.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use std::path::Path;
use studies::study::schema;

const MARK: &str = "<!-- Below: from the table of keys, written by a test with COULTER_UPDATE=1. -->\n";

/// Compares a shipped file with the tables of keys; with `COULTER_UPDATE=1` it is written instead.
fn same(path: &str, expected: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path);
    if std::env::var_os("COULTER_UPDATE").is_some() {
        std::fs::write(&path, expected).unwrap();
    }
    let shipped = std::fs::read_to_string(&path).unwrap();
    assert_eq!(shipped, expected, "{}: run the tests with COULTER_UPDATE=1", path.display());
}

#[test]
fn shipped_schema_is_up_to_date() {
    same("cases/study.schema.json", &schema::text());
}

#[test]
fn documentation_is_up_to_date() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/reference/study-file.md");
    let shipped = std::fs::read_to_string(path).unwrap();
    let (by_hand, _) = shipped.split_once(MARK).expect("the mark is gone");
    same("docs/reference/study-file.md", &format!("{by_hand}{MARK}\n{}", schema::tables()));
}
