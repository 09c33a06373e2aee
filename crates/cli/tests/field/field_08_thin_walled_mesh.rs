//! The thinnest wall of a body from a file, in cells: refused below one, warned of below four; tips and edges
//! are no walls.

use crate::support::Desk;
use std::f64::consts::TAU;

const CASE: &str = "format = 2
soil = { law = 'tresca', shear_strength = '5 kPa', unit_weight = '16 kN/m^3', young_modulus = '1 MPa', poisson_ratio = 0.49, k0 = 1 }
domain = { x = ['0 m', '0.35 m'], y = ['0 m', '0.35 m'], z = ['-0.3 m', '0.13 m'], symmetric = true, symmetric_x = true }
grid = { cell = '10 mm', growth = 1.3, fine_x = ['0 m', '0.12 m'], fine_y = ['0 m', '0.12 m'], fine_z = ['-0.1 m', '0.04 m'] }
run = { duration = '0.2 s' }
[body.bucket]
shape = 'mesh'
file = 'bucket.obj'
unit = 'mm'
friction = 0
heave = { speed = '-0.2 m/s', ramp = '0.05 s' }
";

/// A solid of revolution about z, from the radii [mm] and heights [mm] of its outline, which begins and ends
/// on the axis.
fn revolved(outline: &[[f64; 2]]) -> String {
    const SEGMENTS: usize = 48;
    let mut text = String::new();
    for [r, z] in outline {
        for n in 0..SEGMENTS {
            let (sin, cos) = (TAU * n as f64 / SEGMENTS as f64).sin_cos();
            text += &format!("v {} {} {z}\n", r * cos, r * sin);
        }
    }
    for n in 0..outline.len() - 1 {
        for m in 0..SEGMENTS {
            let [a, b] = [m, (m + 1) % SEGMENTS].map(|m| SEGMENTS * n + m + 1);
            let [c, d] = [b + SEGMENTS, a + SEGMENTS];
            text += &format!("f {a} {b} {c}\nf {a} {c} {d}\n");
        }
    }
    text
}

/// A bucket, open below: radius 100 mm, skirt 150 mm, and a lid of half a cell, which does not come down to
/// the soil.
fn bucket(wall: f64) -> String {
    let inner = 100.0 - wall;
    revolved(&[[0.0, 0.0], [inner, 0.0], [inner, -150.0], [100.0, -150.0], [100.0, 5.0], [0.0, 5.0]])
}

#[test]
fn a_wall_thinner_than_a_cell_is_refused_before_the_run() {
    let desk = Desk::with(&[("case.toml", CASE), ("bucket.obj", &bucket(2.0))]);
    for command in ["check", "run"] {
        // The facets are nearer to each other than the circles.
        desk.expect(2, &[command, "case.toml"]).says(&[
            "0.20 cells across body.bucket.file where it is thinnest, 1.99",
            "grid.cell at most 1.99",
        ]);
    }
    desk.write("bucket.obj", bucket(9.0).as_bytes());
    desk.expect(2, &["check", "case.toml"]).says(&["0.90 cells across"]);
}

#[test]
fn a_wall_of_few_cells_is_warned_of() {
    let desk = Desk::with(&[("case.toml", CASE), ("bucket.obj", &bucket(20.0))]);
    desk.expect(0, &["check", "case.toml"]).says(&[
        "bucket: 2.0 cells across where it is thinnest, 19.95",
        "two thirds as wide",
        "changed by 18 % in the median",
    ]);
    desk.write("bucket.obj", bucket(60.0).as_bytes());
    let thick = desk.expect(0, &["check", "case.toml"]);
    assert!(!thick.text().contains("thinnest"), "{}", thick.text());
    // Pressed down to its lid.
    let deep = [
        "check",
        "case.toml",
        "--set",
        "body.bucket.sinkage=130 mm",
        "--set",
        "body.bucket.heave.speed=-0.15 m/s",
    ];
    desk.expect(2, &deep).says(&["0.50 cells across body.bucket.file", "5.0000 mm at ("]);
}

#[test]
fn tips_and_edges_are_no_walls() {
    let tip = revolved(&[[0.0, -150.0], [60.0, 0.0], [60.0, 60.0], [0.0, 60.0]]);
    let desk = Desk::with(&[("case.toml", CASE), ("bucket.obj", &tip)]);
    let answer = desk.expect(0, &["check", "case.toml"]);
    assert!(!answer.text().contains("thinnest"), "{}", answer.text());
}

#[test]
fn grousers_of_a_wheel_count_by_their_thickness() {
    let case = "format = 2\nsoil = { law = 'mohr-coulomb', friction_angle = '32 deg', cohesion = '0.3 kPa', unit_weight = '15 kN/m^3', \
                young_modulus = '1 MPa' }\ngrid = { cell = '10 mm' }\nrun = { duration = '1 ms' }\n[body.wheel]\nshape = 'wheel'\n\
                diameter = '0.35 m'\nthickness = '0.15 m'\ngrousers = 12\ngrouser_height = '25 mm'\ngrouser_thickness = '15 mm'\n\
                friction = 0.3\nsinkage = '10 mm'\n";
    let desk = Desk::with(&[("case.toml", case)]);
    desk.expect(0, &["check", "case.toml"]).says(&["1.5 cells across body.wheel.grouser_thickness"]);
    let thin = ["check", "case.toml", "--set", "body.wheel.grouser_thickness=9 mm"];
    desk.expect(2, &thin).says(&["0.90 cells across"]);
}
