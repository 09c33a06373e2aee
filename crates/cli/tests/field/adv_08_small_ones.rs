//! Small ones: text that a spreadsheet would compute; weights in plane strain.

use super::strangers::{CASE, STUDY, snapshot};
use super::support::Desk;
use serde_json::Value;

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

/// A block that rests on stiff elastic ground under its weight.
const BLOCK: &str = r#"format = 2
[soil]
law = "elastic"
density = "2000 kg/m^3"
unit_weight = "0 N/m^3"
young_modulus = "20 MPa"
[domain]
plane_strain = true
x = ["-0.3 m", "0.3 m"]
z = ["-0.2 m", "0.2 m"]
[grid]
cell = "25 mm"
growth = 1
[body.b]
shape = "block"
size = ["0.1 m", "0.1 m"]
friction = 0.3
weight = "200 N"
heave = { load = "-100 N", ramp = "20 ms" }
[run]
duration = "60 ms"
[output]
field_interval = "1 h"
"#;

#[test]
fn in_plane_strain_a_weight_is_that_of_a_metre() {
    let desk = Desk::with(&[("block.toml", BLOCK)]);
    desk.expect(0, &["check", "block.toml"]).says(&["per metre of width"]);
    let mut sinkage = Vec::new();
    for set in ["grid.cell=25 mm", "grid.cell=12.5 mm", "domain.y=['0 m', '2 m']"] {
        desk.coulter(&["run", "block.toml", "--set", set, "-o", "results", "--force", "--threads", "1"]);
        let summary: Value = serde_json::from_str(&desk.read("results/summary.json")).unwrap();
        let steady = &summary["bodies"]["b"]["steady"];
        let force = steady["vertical_N"].as_f64().unwrap();
        assert!((force / 300.0 - 1.0).abs() < 0.1, "{set}: {force} N per metre");
        sinkage.push(steady["sinkage_m"].as_f64().unwrap());
        assert!(desk.read("results/report.html").contains("per metre of width"), "{set}");
    }
    assert!(
        (sinkage[2] / sinkage[0] - 1.0).abs() < 1e-3,
        "the thickness of the slab means nothing: {sinkage:?}"
    );
    assert!((sinkage[1] / sinkage[0] - 1.0).abs() < 0.25, "{sinkage:?}");
}
