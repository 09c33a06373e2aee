//! How fast a solid of triangles answers.

use geometry::{Mesh, Polyhedron, Shape, Sphere, repaired};
use glam::DVec3;
use std::f64::consts::TAU;
use std::time::Instant;

/// A disc of as many segments, axle along y.
fn disc(segments: u32) -> Mesh {
    let mut points = vec![DVec3::new(0.0, -0.025, 0.0), DVec3::new(0.0, 0.025, 0.0)];
    let mut triangles = Vec::new();
    for n in 0..segments {
        let (sin, cos) = (TAU * f64::from(n) / f64::from(segments)).sin_cos();
        points.extend([-0.025, 0.025].map(|y| DVec3::new(0.1 * sin, y, 0.1 * cos)));
        let (a, b) = (2 + 2 * n, 2 + 2 * ((n + 1) % segments));
        triangles.extend([[0, b, a], [1, a + 1, b + 1], [a, b, a + 1], [b, b + 1, a + 1]]);
    }
    Mesh { points, triangles }
}

/// A ring of 2 n² triangles.
fn torus(n: u32) -> Mesh {
    let at = |i: u32, j: u32| (i % n) * n + j % n;
    let mut mesh = Mesh::default();
    for i in 0..n {
        for j in 0..n {
            let [u, v] = [i, j].map(|k| TAU * f64::from(k) / f64::from(n));
            let radius = 0.07 + 0.03 * v.cos();
            mesh.points.push(DVec3::new(radius * u.cos(), radius * u.sin(), 0.03 * v.sin()));
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            mesh.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    mesh
}

/// `cargo test --release -p coulter-physics --test polyhedron -- --ignored --nocapture`
#[test]
#[ignore = "a measurement"]
fn time_of_a_distance() {
    let meshes = [("disc", disc(2500)), ("sphere", Sphere { diameter: 0.2 }.mesh()), ("torus", torus(1000))];
    for (name, mesh) in meshes {
        let solid = Polyhedron::new(mesh.clone());
        let shift = DVec3::new(0.618_034, 0.414_214, 0.732_051);
        let spread = (1..800_000).map(|n| ((f64::from(n) * shift).fract() - DVec3::splat(0.5)) * 0.25);
        let points: Vec<DVec3> = spread.filter(|x| solid.signed_distance(*x).abs() < 0.01).collect();
        let began = Instant::now();
        let sum: f64 = points.iter().map(|x| solid.signed_distance(*x)).sum();
        let each = began.elapsed().as_secs_f64() / points.len() as f64;
        let began = Instant::now();
        assert!(repaired(&mesh).is_ok());
        let checked = began.elapsed().as_secs_f64();
        let triangles = solid.surface().triangles.len();
        println!(
            "{name}: {triangles} triangles, {each:.2e} s a query near the surface ({sum:.3}), checked in {checked:.2e} s"
        );
    }
}
