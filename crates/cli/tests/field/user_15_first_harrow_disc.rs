//! A first harrow disc, on cells as thick as itself, whose run breaks by leak.

use crate::support::Desk;

const HARROW: &str = r#"
format = 2
soil = { law = "mohr-coulomb", friction_angle = "30 deg", cohesion = "10 kPa", unit_weight = "16 kN/m^3", young_modulus = "5 MPa" }
grid = { cell = "25 mm", growth = 1.3, follow = { body = "blade", axes = "x" } }
run = { tow_distance = "0.45 m" }
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
fn its_leak_is_foretold() {
    let desk = Desk::with(&[("harrow.toml", HARROW)]);
    desk.expect(0, &["check", "harrow.toml"])
        .says(&["1.0 cells across the thickness of the dished disc: soil will leak into it"]);
    let finer = desk.expect(0, &["check", "harrow.toml", "--set", "grid.cell=15 mm"]);
    assert!(!finer.text().contains("soil will leak into it"), "{}", finer.text());
}
