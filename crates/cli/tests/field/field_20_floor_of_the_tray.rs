//! A tray of soil, in part: `check` says that its floor is one cell thick.

use crate::support::Desk;

const CASE: &str = "format = 2
soil = { law = 'mohr-coulomb', friction_angle = '35 deg', unit_weight = '15 kN/m^3', young_modulus = '0.5 MPa' }
ground = { surface = '-0.15 m' }
domain = { x = ['-0.2 m', '0.3 m'], y = ['0 m', '0.18 m'], z = ['-0.2 m', '0.24 m'], symmetric = true }
grid = { cell = '20 mm', fine_x = ['-0.15 m', '0.25 m'], fine_y = ['0 m', '0.12 m'], fine_z = ['-0.1 m', '0.2 m'] }
run = { duration = '0.6 s' }
[soil_body.fill]
shape = 'block'
size = ['0.16 m', '0.12 m', '0.08 m']
elevation = '0.14 m'
law = 'mohr-coulomb'
friction_angle = '35 deg'
unit_weight = '15 kN/m^3'
young_modulus = '0.5 MPa'
[body.tray]
shape = 'mesh'
file = 'tray.obj'
unit = 'mm'
friction = 0.5
elevation = '0.15 m'
forward = { speed = '0.3 m/s', start = '0.1 s', ramp = '0.2 s' }
";

/// An open tray, outside 200 × 160 × 140 mm, with walls and floor so thick [mm].
fn tray(walls: f64, floor: f64) -> String {
    let mut text = String::new();
    for (inset, z) in [(0.0, -70.0), (0.0, 70.0), (walls, 70.0), (walls, floor - 70.0)] {
        let [x, y] = [100.0 - inset, 80.0 - inset];
        for [a, b] in [[-x, -y], [x, -y], [x, y], [-x, y]] {
            text += &format!("v {a} {b} {z}\n");
        }
    }
    for ring in [0, 4, 8] {
        for n in 0..4 {
            let [a, b] = [n, (n + 1) % 4].map(|n| ring + n + 1);
            text += &format!("f {a} {b} {} {}\n", b + 4, a + 4);
        }
    }
    text + "f 4 3 2 1\nf 13 14 15 16\n"
}

#[test]
fn the_thickness_of_its_floor_counts() {
    let desk = Desk::with(&[("tray.toml", CASE), ("tray.obj", &tray(20.0, 20.0))]);
    desk.expect(0, &["check", "tray.toml"])
        .says(&["tray: 1.0 cells across where it is thinnest, 20.0000 mm at (", "and soil leaks through it"]);
    desk.write("tray.obj", tray(30.0, 15.0).as_bytes());
    desk.expect(2, &["check", "tray.toml"]).says(&[
        "0.75 cells across body.tray.file",
        "15.0000 mm at (",
        "at most 15.0000 mm",
    ]);
}
