//! The columns of the history files, in the documentation as in the program.

use coulter::history::columns::{
    BOUNDARIES, Column, ENERGY, FILTERED, FORCES, GROUND_LEFT, HEIGHT_MAP, JOINTS, PARTS, RIM, RUT,
};

/// The columns of a file as a table in Markdown.
fn table<S: Copy>(columns: &[Column<S>]) -> String {
    let lines = columns.iter().map(|c| format!("| `{}` | {} |\n", c.header(), c.meaning));
    format!("\n| column | meaning |\n|---|---|\n{}\n", lines.collect::<String>())
}

/// The text with what stands between the marks of a file replaced.
fn replaced(text: &str, file: &str, new: &str) -> String {
    let begin =
        format!("<!-- {file}: from the table of columns, written by a test with COULTER_UPDATE=1. -->\n");
    let (before, rest) = text.split_once(&begin).unwrap();
    let (_, after) = rest.split_once("<!-- end -->\n").unwrap();
    format!("{before}{begin}{new}<!-- end -->\n{after}")
}

#[test]
fn columns_are_documented() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/reference/results.md");
    let shipped = std::fs::read_to_string(path).unwrap();
    let expected = replaced(&shipped, "forces.csv", &table(FORCES));
    let expected = replaced(&expected, "part_NAME.csv", &table(PARTS));
    let expected = replaced(&expected, "joint_NAME.csv", &table(JOINTS));
    let expected = replaced(&expected, "energy.csv", &table(ENERGY));
    let expected = replaced(&expected, "boundaries.csv", &table(BOUNDARIES));
    let expected = replaced(&expected, "ground_left.csv", &table(GROUND_LEFT));
    let expected = replaced(&expected, "height_map.csv", &table(HEIGHT_MAP));
    let expected = replaced(&expected, "rut.csv", &table(RUT));
    let expected = replaced(&expected, "filtered.csv", &table(FILTERED));
    let expected = replaced(&expected, "rim.csv", &table(RIM));
    if std::env::var_os("COULTER_UPDATE").is_some() {
        std::fs::write(path, &expected).unwrap();
    } else {
        assert_eq!(shipped, expected, "docs/reference/results.md: run the tests with COULTER_UPDATE=1");
    }
}

#[test]
fn names_are_used_once() {
    fn check<S: Copy>(columns: &[Column<S>]) {
        let names: std::collections::BTreeSet<_> = columns.iter().map(|c| c.name).collect();
        assert_eq!(names.len(), columns.len());
    }
    check(FORCES);
    check(PARTS);
    check(JOINTS);
    check(ENERGY);
    check(BOUNDARIES);
    check(GROUND_LEFT);
    check(RUT);
    check(FILTERED);
    check(RIM);
}
