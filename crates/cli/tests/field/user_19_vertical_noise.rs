//! A spudcan pressed two diameters deep into clay: raw forces from 7 to 104 kN about 64 kN, and no check that
//! says so.

use super::support::Desk;

const CASE: &str = r#"format = 2
soil = { law = "tresca", shear_strength = "5 kPa", strength_gradient = "1.5 kPa/m", unit_weight = "6 kN/m^3", young_modulus = "2.5 MPa", poisson_ratio = 0.49, k0 = 1 }
domain = { symmetric = true, symmetric_x = true, x = ["0 m", "2 m"], y = ["0 m", "2 m"], z = ["-1.8 m", "1 m"] }
grid = { cell = "0.2 m", growth = 1.25 }
run = { duration = "0.6 s" }
output = { field_interval = "1 h" }
[body.spudcan]
shape = "cone"
diameter = "1 m"
cone_angle = "150 deg"
length = "2.6 m"
shaft_diameter = "0.5 m"
friction = "rough"
adhesion_factor = 0.5
heave = { speed = "-1 m/s", ramp = "0.1 s" }
"#;

#[test]
fn the_noise_of_a_vertical_force_is_graded() {
    let desk = Desk::with(&[("spudcan.toml", CASE)]);
    desk.coulter(&["run", "spudcan.toml", "-o", "pressed"]);
    let (noise, verdict) = desk.graded("pressed", "vertical noise").unwrap();
    assert!(noise.unwrap() > 10.0 && verdict == "doubtful", "{noise:?} {verdict}");
    // Of a body that is pressed the force is meant to grow, and it has no drag.
    assert_eq!(desk.graded("pressed", "steady vertical force"), None);
    assert_eq!(desk.graded("pressed", "drag noise"), None);
}
