//! A rover's wheel, here a disc, that rolls without slip pulls nothing, and its noise was 847 % of that.

use super::support::Desk;

const CASE: &str = r#"format = 2
[soil]
law = "sand"
critical_friction_angle = "33 deg"
minimum_density = "1600 kg/m^3"
maximum_density = "1890 kg/m^3"
density = "1700 kg/m^3"
young_modulus = "10 MPa"
stiffness_limit = "10 kPa"
[domain]
symmetric = true
[grid]
cell = "30 mm"
growth = 1.4
[body.wheel]
shape = "disc"
diameter = "0.25 m"
thickness = "0.12 m"
friction = 0.5
weight = "100 N"
forward = { speed = "0.15 m/s", start = "0.2 s", ramp = "0.1 s" }
heave = { load = "0 N", start = "0 s", ramp = "0.1 s" }
spin = { slip = 0 }
[run]
tow_distance = "0.06 m"
[output]
field_interval = "1 h"
"#;

#[test]
fn noise_at_no_pull_is_relative_to_the_load() {
    let desk = Desk::with(&[("rover.toml", CASE)]);
    desk.coulter(&["run", "rover.toml", "-o", "rolled"]);
    let (noise, _) = desk.graded("rolled", "drag noise").unwrap();
    assert!(noise.unwrap() < 100.0, "{noise:?} %");
    assert!(desk.graded("rolled", "torque noise").unwrap().0.unwrap() < 100.0);
}
