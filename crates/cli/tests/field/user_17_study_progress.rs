//! A study whose runs of the solver all broke, of which nothing was said for twelve minutes: closed forms
//! come first, every case that ends is told at once wherever the output goes, and what a broken run gave
//! stays in the table, marked.

use crate::support::Desk;

/// A plate that is pressed into a soil of few cells.
const PLATE: &str = r#"
format = 2
[soil]
law = "tresca"
shear_strength = "1 kPa"
unit_weight = "0 N/m^3"
density = "2000 kg/m^3"
young_modulus = "1 MPa"
poisson_ratio = 0.3
[domain]
x = ["-1 m", "1 m"]
z = ["-0.75 m", "0.25 m"]
plane_strain = true
[grid]
cell = "0.125 m"
[body.plate]
shape = "block"
size = ["0.5 m", "0.25 m"]
friction = 0
heave = { speed = "-0.2 m/s", ramp = "0.02 s" }
[run]
duration = "0.05 s"
"#;

const STUDY: &str = r#"
format = 2
case = "plate.toml"
title = "Plates"
models = ["closed-form", "solver"]
responses = ["vertical", "pull", "turn_ratio", "efficiency"]
[factor.strength]
key = "soil.shear_strength"
values = ["1 kPa", "2 kPa"]
"#;

#[test]
fn every_case_is_told_as_it_ends_and_closed_forms_come_first() {
    let desk = Desk::with(&[("plate.toml", PLATE), ("study.toml", STUDY)]);
    let answer = desk.coulter(&["sweep", "study.toml", "-o", "out", "--workers", "1"]);
    let told: Vec<&str> = answer.out.lines().filter(|line| line.starts_with('[')).collect();
    assert_eq!(told.len(), 4, "{}{}", answer.out, answer.error);
    for (n, line) in told.iter().enumerate() {
        let model = if n < 2 { "closed form" } else { "solver" };
        assert!(
            line.starts_with(&format!("[{}/4", n + 1)) && line.contains(&format!(", {model}, strength = ")),
            "{line}"
        );
        assert!(line.contains("gone"), "{line}");
    }
    assert!(told[0].contains("F_V") && told[2].contains(" left"), "{told:?}");
    // With --json standard output is one document.
    let again = desk.coulter(&["sweep", "study.toml", "-o", "json", "--workers", "1", "--json"]);
    assert!(serde_json::from_str::<serde_json::Value>(&again.out).is_ok(), "{}", again.out);
    assert_eq!(again.error.lines().filter(|line| line.starts_with('[')).count(), 4, "{}", again.error);
}

#[test]
fn a_broken_run_keeps_its_figures_and_is_in_no_chart() {
    // Steps longer than is stable: nothing that may be used.
    let broken = format!("{PLATE}\n[numerics]\ncourant = 0.95\n");
    let desk = Desk::with(&[("plate.toml", &broken), ("study.toml", STUDY)]);
    let answer = desk.expect(1, &["sweep", "study.toml", "-o", "out", "--workers", "1"]);
    let told: Vec<&str> = answer.out.lines().filter(|line| line.contains("BROKEN")).collect();
    assert_eq!(told.len(), 2, "{}{}", answer.out, answer.error);
    assert!(told[0].contains("it gave F_H") && !told[0].contains("doubtful:"), "{}", told[0]);
    let table = desk.read("out/table.csv");
    let head: Vec<&str> = table.lines().next().unwrap().split(',').collect();
    let at = |name: &str| head.iter().position(|column| column.starts_with(name)).unwrap();
    for line in table.lines().filter(|line| line.contains(",broken,")) {
        let cells: Vec<&str> = line.split(',').collect();
        assert!(!cells[at("vertical")].is_empty(), "{line}");
        assert_eq!(cells[at("grade")], "broken", "{line}");
    }
    assert_eq!(table.matches(",broken,broken,").count(), 2, "{table}");
    let html = desk.read("out/report.html");
    let unused = table.lines().skip(1).filter(|line| !line.contains(",done,")).count();
    assert_eq!(html.matches("<tr class=\"unused\">").count(), unused);
    assert!(unused >= 2 && html.contains(&format!("{unused} of 4 rows are not used")));
}
