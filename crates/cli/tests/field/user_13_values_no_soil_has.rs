//! A prefix, a digit or a sign mistaken: a case that can be run, of soil that nobody has seen.

use crate::support::{Answer, Desk};

/// A disc of 200 × 50 mm that is towed through sand.
const DISC: &str = r#"
format = 2
soil = { law = "mohr-coulomb", friction_angle = "32 deg", unit_weight = "14.4 kN/m^3", young_modulus = "1 MPa" }
domain = { x = ["-0.36 m", "0.4 m"], y = ["0 m", "0.3 m"], z = ["-0.25 m", "0.1 m"], symmetric = true }
grid = { cell = "6 mm", aspect = [2, 2, 1], growth = 1.35, follow = { body = "disc", axes = "x" } }
run = { tow_distance = "0.36 m" }
[body.disc]
shape = "disc"
diameter = "0.2 m"
thickness = "50 mm"
friction = 0.3
weight = "100 N"
heave = { load = "0 N" }
spin = "free"
forward = { speed = "0.2 m/s", start = "0.3 s" }
"#;

const CLAY: &str = r#"soil = { law = "tresca", shear_strength = "5 kPa", unit_weight = "16 kN/m^3", young_modulus = "1 MPa" }"#;

/// What `check` says of the case with one text replaced.
fn checked(case: &str, old: &str, new: &str, code: i32) -> Answer {
    assert!(case.contains(old), "{old}");
    Desk::with(&[("case.toml", &case.replacen(old, new, 1))]).expect(code, &["check", "case.toml"])
}

#[test]
fn the_case_itself_raises_no_doubt() {
    let answer = checked(DISC, "100 N", "100 N", 0);
    assert!(!answer.out.contains("warning"), "{}", answer.out);
    answer.says(&["towed 0.36 m along +x from 0.3 to 2.15 s, 0.2 m/s"]);
}

#[test]
fn what_no_soil_no_body_and_no_tow_has_is_doubted() {
    for (old, new, words) in [
        ("\"14.4 kN/m^3\"", "\"1.44 kN/m^3\"", &["soil.unit_weight = 1440", "14400 N/m^3 meant"][..]),
        ("\"14.4 kN/m^3\"", "\"144 kN/m^3\"", &["soil.unit_weight = 144000", "14400 N/m^3 meant"]),
        ("friction = 0.3", "friction = 3", &["body.disc.friction = 3", "0 to 1"]),
        ("friction = 0.3", "friction = 30", &["body.disc.friction = 30"]),
        ("\"0.2 m/s\"", "\"-0.2 m/s\"", &["towed backwards, 0.36 m along −x", "towed 0.36 m along −x"]),
        ("\"0.2 m/s\"", "\"20 m/s\"", &["body.disc.forward.speed = 20 m/s", "speed of waves"]),
        ("\"1 MPa\"", "\"1 GPa\"", &["soil.young_modulus = 1000000000 Pa is 347222 times the stress"]),
        ("\"1 MPa\"", "\"40 kPa\"", &["soil.young_modulus = 40000 Pa is unusual: 50 kPa to 1 GPa"]),
        ("\"32 deg\"", "\"3.2 deg\"", &["soil.friction_angle = 3.2 deg is unusual"]),
        ("\"0.36 m\" }", "\"0.01 m\" }", &["towed 0.01 m only, 0.05 of its length"]),
        ("\"100 N\"", "\"100 MN\"", &["body.disc: it is pressed down with 1e8 N", "no soil bears that"]),
        ("\"50 mm\"", "\"50 cm\"", &["body.disc.thickness = 0.5 m is more than the diameter"]),
    ] {
        checked(DISC, old, new, 0).says(&["warning"]).says(words);
    }
    let soil = DISC.lines().find(|line| line.starts_with("soil")).unwrap();
    let clay = DISC.replace(soil, CLAY);
    assert!(!checked(&clay, "5 kPa", "5 kPa", 0).out.contains("unusual"));
    checked(&clay, "\"5 kPa\"", "\"5 MPa\"", 0)
        .says(&["soil.shear_strength = 5000000 Pa is unusual", "5000 Pa meant"]);
    checked(&clay, "\"5 kPa\"", "\"5 Pa\"", 0)
        .says(&["soil.shear_strength = 5 Pa is unusual", "5000 Pa meant"]);
    checked(&clay, "\"5 kPa\"", "\"100 kPa\"", 0).says(&["is 10 times the strength"]);
}

/// A table's speed was 0 to the checks.
#[test]
fn a_tow_by_a_table_is_as_fast_as_one_that_is_given() {
    let case = DISC
        .replace("forward = { speed = \"0.2 m/s\", start = \"0.3 s\" }", "forward = { table = \"tow.csv\" }")
        .replace("tow_distance = \"0.36 m\"", "duration = \"0.2 s\"");
    let desk = Desk::with(&[("case.toml", &case), ("tow.csv", "time [s],speed [m/s]\n0,0\n0.1,2\n0.2,2\n")]);
    desk.expect(0, &["check", "case.toml"]).says(&["v²/(gd) = 2.03", "Froude number", "bulk viscosity"]);
}

#[test]
fn soil_that_its_own_weight_would_flatten_is_refused() {
    for modulus in ["1 mPa", "1 Pa", "1 kPa", "1e-300 Pa"] {
        checked(DISC, "\"1 MPa\"", &format!("\"{modulus}\""), 2).says(&[
            "young_modulus",
            "flattened by its own weight",
            "1 mPa is 0.001 Pa",
        ]);
    }
}

#[test]
fn a_run_of_such_values_is_doubtful_for_them() {
    let block = r#"
format = 2
soil = { law = "mohr-coulomb", friction_angle = "32 deg", unit_weight = "1.44 kN/m^3", young_modulus = "1 MPa" }
domain = { x = ["-0.2 m", "0.2 m"], y = ["0 m", "0.2 m"], z = ["-0.2 m", "0.1 m"], symmetric = true }
grid = { cell = "25 mm" }
run = { duration = "20 ms" }
[body.block]
shape = "block"
size = ["0.1 m", "0.1 m", "0.1 m"]
friction = 0.3
sinkage = "50 mm"
forward = { speed = "0.2 m/s" }
"#;
    let desk = Desk::with(&[("case.toml", block)]);
    let answer = desk.coulter(&["run", "case.toml", "--threads", "1"]);
    answer.says(&["unusual values", "soil.unit_weight = 1440"]);
    let summary = desk.read("results/case/summary.json");
    assert!(summary.contains("unusual values"), "{summary}");
    desk.expect(0, &["compare", "results/case", "results/case"])
        .says(&["note: results/case: the run is graded", "doubtful"]);
}
