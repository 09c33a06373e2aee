//! Small ones: text that a spreadsheet would compute.

use super::strangers::{CASE, STUDY, snapshot};
use super::support::Desk;

#[test]
fn no_table_holds_a_formula() {
    let study = STUDY
        .replace("soil.young_modulus", "title")
        .replace("\"1 MPa\", \"2 MPa\"", "\"=HYPERLINK(1)\", \"@SUM(1)\", \"-2+3\"");
    let desk = Desk::with(&[("c.toml", CASE), ("s.toml", &study)]);
    desk.expect(0, &["sweep", "s.toml", "-o", "so"]);
    let table = desk.read("so/table.csv");
    for text in ["=HYPERLINK(1)", "@SUM(1)", "-2+3"] {
        assert!(table.contains(&format!(",'{text},")), "{table}");
    }
    for (path, content) in snapshot(&desk.path().join("so")) {
        if path.extension().is_some_and(|extension| extension == "csv") {
            let mut lines = String::from_utf8(content).unwrap();
            lines = lines.replace('\n', ",");
            let formulas: Vec<&str> = lines
                .split(',')
                .map(|cell| cell.trim_matches('"'))
                .filter(|cell| cell.starts_with(['=', '+', '-', '@']) && cell.parse::<f64>().is_err())
                .collect();
            assert!(formulas.is_empty(), "{}: {formulas:?}", path.display());
        }
    }
}
