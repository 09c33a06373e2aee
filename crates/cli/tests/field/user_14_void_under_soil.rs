//! Sand without cohesion hung over an empty slot behind a disc.

use super::support::Desk;

const CASE: &str = r#"format = 2
soil = { law = "mohr-coulomb", friction_angle = "32 deg", unit_weight = "14.4 kN/m^3", young_modulus = "1 MPa" }
domain = { x = ["-0.15 m", "0.25 m"], y = ["0 m", "0.1 m"], z = ["-0.12 m", "0.05 m"], symmetric = true }
grid = { cell = "8 mm", aspect = [2, 2, 1], growth = 1.4 }
run = { tow_distance = "0.13 m" }
output = { field_interval = "1 h" }
[body.disc]
shape = "disc"
diameter = "0.2 m"
thickness = "50 mm"
friction = 0.3
sinkage = "50 mm"
spin = { speed = "0.8 rad/s" }
forward = { speed = "0.25 m/s", ramp = "0.05 s" }
"#;

#[test]
fn no_sand_hangs_behind_a_disc() {
    let desk = Desk::with(&[("disc.toml", CASE)]);
    desk.coulter(&["run", "disc.toml", "-o", "towed"]);
    let (void, verdict) = desk.graded("towed", "void under soil").unwrap();
    assert!(void.unwrap() < 0.2 && verdict == "good", "{void:?} {verdict}");
}
