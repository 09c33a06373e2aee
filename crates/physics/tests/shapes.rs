//! One battery of tests for every shape: points lie on the surface, normals point out, areas and volumes are right.

#![allow(missing_docs, clippy::unwrap_used)]

use glam::DVec3;
use physics::shape::{Block, Disc, Shape};
use std::f64::consts::PI;

/// Every shape with the area of its surface [m²].
fn shapes() -> Vec<(Box<dyn Shape>, f64)> {
    let disc = Disc { diameter: 0.2, thickness: 0.05 };
    let block = Block { size: DVec3::new(0.3, 0.2, 0.1) };
    vec![
        (Box::new(disc), PI * 0.2 * 0.05 + 2.0 * PI * 0.01),
        (Box::new(block), 2.0 * (0.3 * 0.2 + 0.2 * 0.1 + 0.3 * 0.1)),
    ]
}

#[test]
fn contact_points_cover_the_surface() {
    for (shape, area) in shapes() {
        let points = shape.surface_points(0.006, DVec3::ZERO);
        let sum: f64 = points.iter().map(|p| p.area).sum();
        assert!((sum / area - 1.0).abs() < 1e-9, "{shape:?}: {sum} of {area}");
        for p in &points {
            assert!(shape.signed_distance(p.position).abs() < 1e-12);
            assert!((p.normal.length() - 1.0).abs() < 1e-12);
            assert!(shape.signed_distance(p.position + 1e-4 * p.normal) > 0.0);
            assert!(shape.signed_distance(p.position - 1e-4 * p.normal) < 0.0);
        }
    }
}

#[test]
fn an_inset_keeps_points_from_sharp_edges() {
    let inset = 0.004;
    for (shape, area) in shapes() {
        let points = shape.surface_points(0.006, DVec3::splat(inset));
        assert!(points.iter().map(|p| p.area).sum::<f64>() < area);
        let (_, high) = shape.bounds();
        for p in &points {
            let near = |axis: usize| high[axis] - p.position[axis].abs() < inset * 0.999;
            // On a face of its own a point may be at the bound; along y no point of another face is nearer than the inset.
            assert!(p.normal.y.abs() > 0.5 || !near(1), "{shape:?} {p:?}");
        }
    }
}

#[test]
fn mirror_images_stand_side_by_side() {
    let flip = |v: DVec3| DVec3::new(v.x, -v.y, v.z);
    for (shape, _) in shapes() {
        let points = shape.surface_points(0.007, DVec3::splat(0.003));
        let mut n = 0;
        while n < points.len() {
            let is_own_image = points[n].position.y == 0.0 && points[n].normal.y == 0.0;
            if !is_own_image {
                assert_eq!(flip(points[n].position), points[n + 1].position, "{shape:?}");
                assert_eq!(flip(points[n].normal), points[n + 1].normal);
            }
            n += if is_own_image { 1 } else { 2 };
        }
    }
}

#[test]
fn the_mesh_is_closed_and_holds_the_volume() {
    for (shape, _) in shapes() {
        let mesh = shape.mesh();
        let volume: f64 = mesh
            .triangles
            .iter()
            .map(|t| {
                let [a, b, c] = t.map(|n| mesh.points[n as usize]);
                a.dot(b.cross(c)) / 6.0
            })
            .sum();
        assert!((volume / shape.volume() - 1.0).abs() < 2e-3, "{shape:?}: {volume} of {}", shape.volume());
        let (low, high) = shape.bounds();
        assert!(mesh.points.iter().all(|p| p.cmpge(low - 1e-12).all() && p.cmple(high + 1e-12).all()));
    }
}

#[test]
fn inertia_about_the_axle_is_that_of_a_solid() {
    let disc = Disc { diameter: 0.2, thickness: 0.05 };
    assert!((disc.axle_inertia_per_mass() - 0.5 * 0.01).abs() < 1e-15);
    let block = Block { size: DVec3::new(0.3, 0.2, 0.1) };
    assert!((block.axle_inertia_per_mass() - (0.09 + 0.01) / 12.0).abs() < 1e-15);
}
