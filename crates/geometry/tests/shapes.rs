//! Tests of every shape: points lie on the surface, normals point outwards, areas and volumes are exact.

#![allow(missing_docs, clippy::unwrap_used)]

use geometry::{Axis, Block, Cylinder, Disc, MassProperties, Rotated, Shape, Sphere};
use glam::DVec3;
use std::f64::consts::PI;

/// Every shape with the area of its surface [m²].
fn shapes() -> Vec<(Box<dyn Shape>, f64)> {
    let disc = Disc { diameter: 0.2, thickness: 0.05 };
    let block = Block { size: DVec3::new(0.3, 0.2, 0.1) };
    let cylinder = |axis| Cylinder { diameter: 0.2, length: 0.05, axis };
    let (round, edged) = (PI * 0.2 * 0.05 + 2.0 * PI * 0.01, 2.0 * (0.3 * 0.2 + 0.2 * 0.1 + 0.3 * 0.1));
    vec![
        (Box::new(disc), round),
        (Box::new(cylinder(Axis::X)), round),
        (Box::new(cylinder(Axis::Y)), round),
        (Box::new(cylinder(Axis::Z)), round),
        (Box::new(block), edged),
        (Box::new(Rotated::new(Box::new(block), 0.6)), edged),
        (Box::new(Sphere { diameter: 0.2 }), PI * 0.04),
    ]
}

#[test]
fn contact_points_cover_the_surface() {
    for (shape, area) in shapes() {
        let points = shape.surface_points(DVec3::splat(0.006), DVec3::ZERO);
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
fn an_inset_keeps_points_away_from_sharp_edges() {
    let inset = 0.004;
    for (shape, area) in shapes() {
        let points = shape.surface_points(DVec3::splat(0.006), DVec3::splat(inset));
        let sum: f64 = points.iter().map(|p| p.area).sum();
        // A sphere, whose area is π d², has no edges.
        assert!(sum < area || (area - PI * 0.04).abs() < 1e-12, "{shape:?}");
        let (_, high) = shape.bounds();
        for p in &points {
            let near = |axis: usize| high[axis] - p.position[axis].abs() < inset * 0.999;
            // Points of the end faces lie at the bound; along y all others keep the inset.
            assert!(p.normal.y.abs() > 0.5 || !near(1), "{shape:?} {p:?}");
        }
    }
}

#[test]
fn points_are_counted_without_laying_them_out() {
    for (shape, _) in shapes() {
        for (spacing, inset) in [(0.006, 0.0), (0.007, 0.003), (0.0021, 0.026), (0.3, 0.01), (0.011, 0.2)] {
            let laid_out = shape.surface_points(DVec3::splat(spacing), DVec3::splat(inset)).len();
            let counted = shape.surface_point_count(DVec3::splat(spacing), DVec3::splat(inset));
            assert_eq!(counted, laid_out as f64, "{shape:?} {spacing} {inset}");
        }
        // Without delay for any number: 10¹⁸ for a metre.
        let many = shape.surface_point_count(DVec3::splat(1e-9), DVec3::ZERO);
        assert!((1e15..1e18).contains(&many), "{shape:?} {many}");
    }
}

#[test]
fn mirror_images_are_adjacent() {
    let flip = |v: DVec3| DVec3::new(v.x, -v.y, v.z);
    for (shape, _) in shapes() {
        let points = shape.surface_points(DVec3::splat(0.007), DVec3::splat(0.003));
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
fn the_mesh_is_closed_and_encloses_the_volume() {
    for (shape, _) in shapes() {
        let mesh = shape.mesh();
        let (exact, of_mesh) = (shape.mass_properties(), MassProperties::of_mesh(&mesh));
        let (volume, inertia) = (of_mesh.volume, of_mesh.inertia);
        assert!((volume / exact.volume - 1.0).abs() < 2e-3, "{shape:?}: {volume} of {}", exact.volume);
        assert!(of_mesh.centroid.distance(exact.centroid) < 1e-12, "{shape:?}");
        let size = exact.inertia.y_axis.y;
        assert!(inertia.abs_diff_eq(exact.inertia, 4e-3 * size), "{shape:?}: {inertia} of {}", exact.inertia);
        let (low, high) = shape.bounds();
        assert!(mesh.points.iter().all(|p| p.cmpge(low - 1e-12).all() && p.cmple(high + 1e-12).all()));
    }
}

#[test]
fn inertia_about_the_axle_is_that_of_a_homogeneous_solid() {
    let disc = Disc { diameter: 0.2, thickness: 0.05 };
    assert!((disc.mass_properties().about_axle() - 0.5 * 0.01).abs() < 1e-15);
    let block = Block { size: DVec3::new(0.3, 0.2, 0.1) };
    assert!((block.mass_properties().about_axle() - (0.09 + 0.01) / 12.0).abs() < 1e-15);
    let inertia = |axis| Cylinder { diameter: 0.2, length: 0.06, axis }.mass_properties().about_axle();
    assert_eq!(inertia(Axis::Y), disc.mass_properties().about_axle());
    assert!(
        (inertia(Axis::Z) - (0.01 / 4.0 + 0.0036 / 12.0)).abs() < 1e-15
            && inertia(Axis::X) == inertia(Axis::Z)
    );
    assert!((Sphere { diameter: 0.2 }.mass_properties().about_axle() - 0.4 * 0.01).abs() < 1e-15);
}

#[test]
fn a_quarter_of_a_symmetric_body_has_a_quarter_of_its_points() {
    let upright = Cylinder { diameter: 0.2, length: 0.05, axis: Axis::Z };
    let round: [Box<dyn Shape>; 2] = [Box::new(upright), Box::new(Sphere { diameter: 0.2 })];
    for shape in round {
        let points = shape.surface_points(DVec3::splat(0.007), DVec3::splat(0.003));
        let quarter = points.iter().filter(|p| p.position.x > 0.0 && p.position.y > 0.0);
        assert_eq!(4 * quarter.count(), points.len(), "{shape:?}");
    }
}

#[test]
fn a_rotated_block_leans_forward() {
    let plate = Rotated::new(Box::new(Block { size: DVec3::new(0.02, 0.2, 0.4) }), 0.5);
    let top = DVec3::new(0.2 * f64::sin(0.5), 0.0, 0.2 * f64::cos(0.5));
    assert!(plate.signed_distance(top).abs() < 1e-12 && plate.signed_distance(0.99 * top) < 0.0);
    let (low, high) = plate.bounds();
    assert!((high.z - (0.2 * f64::cos(0.5) + 0.01 * f64::sin(0.5))).abs() < 1e-12 && low == -high);
}
