//! A tray that carries sand above the ground: its leak was divided by the volume of the tray below the
//! ground, which is none.

use super::support::Desk;

/// An open tray of 200 by 160 by 140 mm with walls and floor of 20 mm.
fn tray() -> String {
    let ring = |[x, y, z]: [i32; 3]| [[-x, -y, z], [x, -y, z], [x, y, z], [-x, y, z]];
    let points =
        [ring([100, 80, -70]), ring([100, 80, 70]), ring([80, 60, -50]), ring([80, 60, 70])].concat();
    let vertices: String = points.iter().map(|[x, y, z]| format!("v {x} {y} {z}\n")).collect();
    let side = |n: usize| {
        let m = (n + 1) % 4;
        let [low, high, floor, rim] = [1, 5, 9, 13];
        format!(
            "f {} {} {} {}\nf {} {} {} {}\nf {} {} {} {}\n",
            low + n,
            low + m,
            high + m,
            high + n,
            rim + n,
            rim + m,
            floor + m,
            floor + n,
            high + n,
            high + m,
            rim + m,
            rim + n,
        )
    };
    let sides: String = (0..4).map(side).collect();
    format!("{vertices}{sides}f 4 3 2 1\nf 9 10 11 12\n")
}

const CASE: &str = r#"format = 2
soil = { law = "mohr-coulomb", friction_angle = "35 deg", unit_weight = "15 kN/m^3", young_modulus = "0.5 MPa" }
ground = { surface = "-0.15 m" }
domain = { x = ["-0.14 m", "0.16 m"], y = ["0 m", "0.12 m"], z = ["-0.18 m", "0.16 m"], symmetric = true }
grid = { cell = "20 mm" }
run = { duration = "0.2 s" }
output = { field_interval = "1 h" }
[soil_body.fill]
shape = "block"
size = ["0.16 m", "0.12 m", "0.08 m"]
elevation = "0.14 m"
law = "mohr-coulomb"
friction_angle = "35 deg"
unit_weight = "15 kN/m^3"
young_modulus = "0.5 MPa"
[body.tray]
shape = "mesh"
file = "tray.obj"
unit = "mm"
friction = 0.5
elevation = "0.15 m"
forward = { speed = "0.3 m/s", start = "0.1 s", ramp = "0.2 s" }
"#;

#[test]
fn the_leak_of_a_body_above_ground_has_a_figure() {
    let desk = Desk::with(&[("tray.obj", &tray()), ("tray.toml", CASE)]);
    desk.coulter(&["run", "tray.toml", "-o", "carried"]);
    let (leak, verdict) = desk.graded("carried", "leak").unwrap();
    // 4.2 % while remaps carried soil into the cells that its floor of one cell fills.
    assert!(leak.unwrap() > 0.0 && verdict != "broken", "{leak:?} {verdict}");
    // What is above the ground has no sinkage to be resolved.
    assert_eq!(desk.graded("carried", "cells over sinkage"), None);
}
