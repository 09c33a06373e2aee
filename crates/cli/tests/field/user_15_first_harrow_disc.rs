//! A first harrow disc, on cells as thick as itself, whose run was broken by leak.

use crate::support::Desk;

const HARROW: &str = r#"
format = 2
soil = { law = "mohr-coulomb", friction_angle = "30 deg", cohesion = "10 kPa", unit_weight = "16 kN/m^3", young_modulus = "5 MPa" }
grid = { cell = "25 mm", growth = 1.3, follow = { body = "blade", axes = "x" } }
run = { tow_distance = "0.2 m" }
output = { field_interval = "1 h" }
[body.blade]
shape = "disc"
diameter = "560 mm"
thickness = "25 mm"
concavity = "70 mm"
hollow = "right"
yaw = "20 deg"
tilt = "15 deg"
friction = 0.5
mass = "20 kg"
sinkage = "100 mm"
forward = { speed = "1.5 m/s", ramp = "0.1 s" }
spin = "free"
"#;

#[test]
fn soil_that_finds_no_space_beside_it_is_pressed_away() {
    let desk = Desk::with(&[("harrow.toml", HARROW)]);
    desk.expect(0, &["run", "harrow.toml", "-o", "harrow"]);
    let (leak, verdict) = desk.graded("harrow", "leak").unwrap();
    assert!(leak.unwrap() < 0.1 && verdict == "good", "{leak:?} {verdict}");
}
