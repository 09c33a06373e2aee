//! Meshes of many thin triangles that meet at a point are checked in seconds, as are fine ones.

use crate::support::Desk;
use std::f64::consts::TAU;

const CASE: &str = "format = 2
soil = { law = 'mohr-coulomb', friction_angle = '35 deg', unit_weight = '16 kN/m^3', young_modulus = '2 MPa' }
grid = { cell = '20 mm' }
[body.b]
shape = 'mesh'
file = 'b.stl'
unit = 'm'
friction = 0.3
sinkage = '50 mm'
[run]
duration = '0.05 s'
";

fn stl(triangles: &[[[f64; 3]; 3]]) -> Vec<u8> {
    let mut bytes = vec![b' '; 80];
    bytes.extend((triangles.len() as u32).to_le_bytes());
    for triangle in triangles {
        bytes.extend([0; 12]);
        bytes.extend(triangle.iter().flatten().flat_map(|x| (*x as f32).to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

#[track_caller]
fn checked(mesh: &[u8], words: &[&str]) {
    let desk = Desk::with(&[("c.toml", CASE)]);
    desk.write("b.stl", mesh);
    // Seconds; it was minutes.
    desk.expect_within("60", 0, &["check", "c.toml"]).says(words);
}

#[test]
fn a_cone_of_thousands_of_triangles() {
    // 1 m high and 0.2 m across, tip down.
    const COUNT: usize = 2000;
    let rim = |n: usize| {
        let (sin, cos) = (TAU * (n % COUNT) as f64 / COUNT as f64).sin_cos();
        [0.1 * cos, 0.1 * sin, 1.0]
    };
    let both = |n: usize| [[rim(n), [0.0; 3], rim(n + 1)], [[0.0, 0.0, 1.0], rim(n), rim(n + 1)]];
    checked(&stl(&(0..COUNT).flat_map(both).collect::<Vec<_>>()), &["4000 triangles", "surface closed"]);
}

#[test]
fn a_fine_sphere() {
    const RINGS: usize = 200;
    let at = |i: usize, j: usize| {
        let (sin, cos) = (TAU * (j % (2 * RINGS)) as f64 / (2 * RINGS) as f64).sin_cos();
        let r = if i.is_multiple_of(RINGS) { 0.0 } else { (0.5 * TAU * i as f64 / RINGS as f64).sin() };
        [0.2 * r * cos, 0.2 * r * sin, 0.2 * (0.5 * TAU * i as f64 / RINGS as f64).cos()]
    };
    let square = |n: usize| {
        let (i, j) = (n / (2 * RINGS), n % (2 * RINGS));
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        [[a, b, c], [a, c, d]]
    };
    let all = (0..2 * RINGS * RINGS).flat_map(square);
    let whole: Vec<_> = all.filter(|[a, b, c]| a != b && b != c && c != a).collect();
    checked(&stl(&whole), &["159200 triangles"]);
}
