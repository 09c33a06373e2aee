//! Cones on few cells: soil leaked into their tips, and fifteen of fifteen runs were broken.

use crate::support::Desk;

const CASE: &str = r#"format = 2
[soil]
law = "mohr-coulomb"
friction_angle = "37.7 deg"
cohesion = "140 Pa"
unit_weight = "17.4 kN/m^3"
young_modulus = "0.46 MPa"
[domain]
symmetric = true
[grid]
cell = "18 mm"
growth = 1.45
[body.thing]
shape = "cone"
diameter = "81.5 mm"
cone_angle = "60 deg"
length = "0.245 m"
friction = "rough"
heave = { speed = "-0.13 m/s", ramp = "0.11 s" }
[run]
duration = "0.45 s"
[output]
field_interval = "1 h"
"#;

#[test]
fn no_soil_is_left_in_a_cone_on_few_cells() {
    let desk = Desk::with(&[("cone.toml", CASE)]);
    desk.expect(0, &["run", "cone.toml", "-o", "cone"]);
    let (leak, verdict) = desk.graded("cone", "leak").unwrap();
    assert!(leak.unwrap() < 0.1 && verdict == "good", "{leak:?} {verdict}");
}
