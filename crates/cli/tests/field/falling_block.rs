//! A block of sand that fell on sand came to rest on a void.

use super::support::Desk;

/// A quarter of a block of sand, five cells high, with its base at a height over level sand.
const CASE: &str = r#"format = 2
soil = { law = "mohr-coulomb", friction_angle = "32 deg", unit_weight = "14.4 kN/m^3", young_modulus = "1 MPa" }
domain = { x = ["0 m", "0.048 m"], y = ["0 m", "0.048 m"], z = ["-0.03 m", "0.09 m"], symmetric = true, symmetric_x = true }
grid = { cell = "6 mm" }
run = { duration = "0.13 s" }
output = { field_interval = "1 h" }
[soil_body.block]
shape = "block"
size = ["48 mm", "48 mm", "30 mm"]
elevation = "45 mm"
law = "mohr-coulomb"
friction_angle = "32 deg"
unit_weight = "14.4 kN/m^3"
young_modulus = "1 MPa"
"#;

#[test]
fn no_void_is_left_under_sand_that_has_fallen() {
    let desk = Desk::with(&[("fall.toml", CASE)]);
    desk.coulter(&["run", "fall.toml", "-o", "fell"]);
    let (void, verdict) = desk.graded("fell", "void under soil").unwrap();
    assert!(void.unwrap() < 0.1 && verdict == "good", "{void:?} {verdict}");
}
