//! Cones and thin discs on few cells broke by leak, and with it went the force.

use super::support::Desk;

const CONE: &str = r#"format = 2
soil = { law = "mohr-coulomb", friction_angle = "37.74 deg", cohesion = "138 Pa", unit_weight = "17.42 kN/m^3", young_modulus = "465 kPa" }
domain = { symmetric = true }
grid = { cell = "17.763 mm", growth = 1.45 }
run = { duration = "0.56886 s" }
output = { field_interval = "1 h" }
[body.thing]
shape = "cone"
diameter = "81.519 mm"
cone_angle = "60 deg"
length = "0.24456 m"
friction = "rough"
heave = { speed = "-0.12998 m/s", ramp = "0.10975 s" }
"#;

const DISC: &str = r#"format = 2
soil = { law = "mohr-coulomb", friction_angle = "35 deg", unit_weight = "16 kN/m^3", young_modulus = "5 MPa" }
domain = { x = ["-0.22 m", "0.22 m"], y = ["0 m", "0.12 m"], z = ["-0.14 m", "0.06 m"], symmetric = true }
grid = { cell = "12.5 mm", growth = 1.2, fine_x = ["-0.14 m", "0.16 m"], fine_y = ["0 m", "0.04 m"], fine_z = ["-0.07 m", "0.04 m"], follow = { body = "thing", axes = "x" } }
run = { tow_distance = "0.15 m" }
output = { field_interval = "1 h" }
[body.thing]
shape = "disc"
diameter = "0.2 m"
thickness = "12.5 mm"
friction = 0.3
mass = "1 kg"
sinkage = "40 mm"
forward = { speed = "0.5 m/s", ramp = "0.02 s" }
spin = "free"
"#;

/// Runs a case on cells of a size; a force of the steady part [N]. The leak must not break it.
fn force(desk: &Desk, cell: &str, component: &str) -> f64 {
    desk.expect(0, &["run", "case.toml", "-o", "out", "--force", "--set", &format!("grid.cell={cell}")]);
    let (leak, verdict) = desk.graded("out", "leak").unwrap();
    assert!(verdict != "broken", "{cell}: leak {leak:?} %");
    let summary: serde_json::Value = serde_json::from_str(&desk.read("out/summary.json")).unwrap();
    summary["bodies"]["thing"]["steady"][component].as_f64().unwrap()
}

/// 2.2 and 1.2 % of leak, and 110.6 and 106.4 N, beside 117.5 N on 13 cells.
#[test]
fn a_cone_on_five_cells_meets_the_force_on_thirteen() {
    let desk = Desk::with(&[("case.toml", CONE)]);
    for cell in ["17.763 mm", "10.4 mm"] {
        let force = force(&desk, cell, "vertical_N");
        assert!((force / 121.0 - 1.0).abs() < 0.05, "{cell}: {force} N");
    }
}

/// 5 % of leak and 4.2 N, beside 11 N on four cells.
#[test]
fn a_disc_of_one_cell_has_its_drag_on_four() {
    let drag = force(&Desk::with(&[("case.toml", DISC)]), "12.5 mm", "drag_N");
    assert!((drag / 11.0 - 1.0).abs() < 0.15, "{drag} N");
}
