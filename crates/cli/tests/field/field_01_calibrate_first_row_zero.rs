//! Rows at which no model has a value by construction are left out and said, by every command that reads
//! measured curves.

use crate::support::Desk;

pub(crate) const PLATE: &str = r#"
format = 2
soil = { law = "mohr-coulomb", friction_angle = "32 deg", unit_weight = "14 kN/m^3", young_modulus = "2 MPa" }
domain = { x = ["0 m", "0.3 m"], y = ["0 m", "0.3 m"], z = ["-0.25 m", "0.06 m"], symmetric = true, symmetric_x = true }
grid = { cell = "8 mm", growth = 1.25 }
run = { duration = "0.4 s" }
[body.plate]
shape = "cylinder"
axis = "z"
diameter = "90 mm"
length = "50 mm"
friction = 0.4
heave = { speed = "-0.08 m/s", ramp = "0.02 s" }
"#;

const ROWS: [&str; 6] = ["4,21", "8,46", "12,75", "16,108", "20,146", "24,190"];
const PRIOR: &str = "soil.friction_angle=28 deg..40 deg";

fn curve(rows: &[&str]) -> String {
    format!("sinkage [mm],force [N]\n{}\n", rows.join("\n"))
}

/// Best value and interval of the friction angle [deg], and what was said.
fn calibrated(rows: &[&str], more: &[&str]) -> ([f64; 3], String) {
    let desk = Desk::with(&[("plate.toml", PLATE), ("curve.csv", &curve(rows))]);
    let usual =
        ["calibrate", "plate.toml", "curve.csv", "--parameter", PRIOR, "--noise", "10%", "--samples", "500"];
    let answer = desk.expect(0, &[&usual[..], more].concat());
    let document: serde_json::Value =
        serde_json::from_str(&desk.read("results/plate-calibration/calibration.json")).unwrap();
    let found = &document["closed_form"]["parameters"][0];
    let number = |value: &serde_json::Value| value.as_f64().unwrap();
    let interval = &found["interval_90"];
    ([number(&found["best"]), number(&interval[0]), number(&interval[1])], answer.text())
}

#[test]
fn a_row_without_a_value_changes_nothing_and_is_said() {
    let (known, text) = calibrated(&ROWS, &[]);
    assert!((known[0] - 29.0).abs() < 0.1 && (known[1] - 28.5).abs() < 0.2 && (known[2] - 29.5).abs() < 0.2);
    assert!(!text.contains("left out"));
    let first = [&["0,0"][..], &ROWS].concat();
    let lifted = [&ROWS[..3], &["13,0", "16,108"], &ROWS[4..]].concat();
    let paused = [&ROWS[..3], &["12,75", "12,74"], &ROWS[3..]].concat();
    let windowed: &[&str] = &["--window", "0 mm..30 mm"];
    for (rows, more, line) in
        [(&first, &[][..], "line 2"), (&first, windowed, "line 2"), (&lifted, &[], "line 5")]
    {
        let (found, text) = calibrated(rows, more);
        assert_eq!(found, known, "{rows:?}");
        assert!(text.contains("1 point is left out") && text.contains(line), "{text}");
    }
    assert_eq!(calibrated(&paused, &[]).0, known);
}

#[test]
fn where_no_point_is_left_the_file_and_its_lines_are_named() {
    let desk = Desk::with(&[("plate.toml", PLATE), ("deep.csv", &curve(&["0,0", "1900,900", "2100,990"]))]);
    for command in ["calibrate", "compare"] {
        let more: &[&str] = if command == "calibrate" { &["--parameter", PRIOR] } else { &[] };
        let answer = desk.expect(2, &[&[command, "plate.toml", "deep.csv"][..], more].concat());
        answer.says(&["deep.csv", "lines"]);
        assert!(!answer.text().contains("priors"), "{}", answer.text());
    }
}
