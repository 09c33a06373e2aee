//! Solids of revolution and prisms: distances, contact points, mass properties and meshes agree with each
//! other.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use geometry::{
    Axis, Bevel, DiscRim, Dish, Extruded, Grousers, MassProperties, Mesh, Revolved, Shape, SurfacePoint,
    blade, cone, disc, wedge, wheel,
};
use glam::DVec3;
use std::collections::BTreeMap;
use std::f64::consts::PI;

const HOLLOW: Option<Dish> = Some(Dish { depth: 0.03, hollow_is_left: true });

fn bevelled(edge: f64, bevel: Bevel) -> DiscRim {
    DiscRim::Bevelled { angle: 0.6, edge, bevel }
}

fn round(thickness: f64, rim: DiscRim, dish: Option<Dish>) -> Box<dyn Shape> {
    Box::new(Revolved::new(disc(0.2, thickness, rim, dish).unwrap(), Axis::Y))
}

fn pointed(axis: Axis) -> Box<dyn Shape> {
    Box::new(Revolved::new(cone(0.08, 60_f64.to_radians(), 0.06, 0.2).unwrap(), axis))
}

fn spiked(number: u32) -> Box<dyn Shape> {
    let grousers = Grousers { number, height: 0.015, thickness: 0.008 };
    Box::new(Extruded::new(wheel(0.2, grousers).unwrap(), 0.08))
}

fn shapes() -> Vec<(&'static str, Box<dyn Shape>)> {
    let sharp = |edge, bevel| blade([0.02, 0.15], Some((0.5, edge, bevel))).unwrap();
    let right = Some(Dish { depth: 0.03, hollow_is_left: false });
    vec![
        ("square", round(0.05, DiscRim::Square, None)),
        ("rounded", round(0.05, DiscRim::Rounded { radius: 0.01 }, None)),
        ("fully rounded", round(0.05, DiscRim::Rounded { radius: 0.025 }, None)),
        ("bevelled", round(0.05, bevelled(0.02, Bevel::Both), None)),
        ("knife edge", round(0.05, bevelled(0.0, Bevel::Both), None)),
        ("bevelled on the left", round(0.05, bevelled(0.0, Bevel::High), None)),
        ("bevelled on the right", round(0.05, bevelled(0.01, Bevel::Low), None)),
        ("dished", round(0.02, DiscRim::Square, HOLLOW)),
        ("dished, bevelled behind", round(0.02, bevelled(0.005, Bevel::Low), HOLLOW)),
        ("dished, bevelled inside", round(0.02, bevelled(0.0, Bevel::High), HOLLOW)),
        ("dished to the right", round(0.02, bevelled(0.005, Bevel::Both), right)),
        ("cone", pointed(Axis::Z)),
        ("cone along x", pointed(Axis::X)),
        ("wheel", spiked(11)),
        ("blade", Box::new(Extruded::new(sharp(0.005, Bevel::Low), 0.1))),
        ("chisel", Box::new(Extruded::new(sharp(0.0, Bevel::Both), 0.1))),
        ("wedge", Box::new(Extruded::new(wedge(0.2, 0.1), 0.08))),
    ]
}

fn area(mesh: &Mesh) -> f64 {
    let of = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|n| mesh.points[n as usize]);
        0.5 * (b - a).cross(c - a).length()
    };
    mesh.triangles.iter().map(of).sum()
}

/// Positions in and around a shape, without a pattern.
fn scattered() -> impl Iterator<Item = DVec3> {
    let fraction = |x: f64| x - x.floor() - 0.5;
    (0..4000).map(move |n| {
        let n = f64::from(n);
        0.4 * DVec3::new(fraction(0.8192 * n), fraction(0.6711 * n), fraction(0.5497 * n))
    })
}

#[test]
fn points_cover_the_surface() {
    for (name, shape) in shapes() {
        let spacing = DVec3::splat(0.003);
        let points = shape.surface_points(spacing, DVec3::ZERO);
        let covered: f64 = points.iter().map(|p| p.area).sum();
        assert!((covered / area(&shape.mesh()) - 1.0).abs() < 2e-3, "{name}: {covered}");
        // With an inset what has no points is shared out among the rest of each face, but for arcs that it
        // takes away.
        let inset = shape.surface_points(spacing, DVec3::splat(0.001));
        let represented: f64 = inset.iter().map(|p| p.represents).sum();
        assert!((represented / covered - 1.0).abs() < 5e-3, "{name}: {represented} of {covered}");
        let resultant: DVec3 = points.iter().map(|p| p.area * p.normal).sum();
        assert!(resultant.length() < 1e-3 * covered, "{name}: {resultant}");
        let volume = points.iter().map(|p| p.area * p.normal.dot(p.position)).sum::<f64>() / 3.0;
        let exact = shape.mass_properties().volume;
        assert!((volume / exact - 1.0).abs() < 2e-3, "{name}: {volume} of {exact}");
        for p in &points {
            assert!(p.area > 0.0, "{name}: {p:?}");
            assert!(shape.signed_distance(p.position).abs() < 1e-9, "{name}: {p:?}");
            assert!((p.normal.length() - 1.0).abs() < 1e-12, "{name}: {p:?}");
            let outside = shape.signed_distance(p.position + 1e-4 * p.normal);
            assert!((outside - 1e-4).abs() < 1e-6, "{name}: {p:?}: {outside}");
        }
        let estimate = shape.surface_point_count(spacing, DVec3::ZERO);
        assert!((estimate / points.len() as f64 - 1.0).abs() < 0.25, "{name}: {estimate}, {}", points.len());
    }
}

#[test]
fn distances_are_exact() {
    for (name, shape) in shapes() {
        let mesh = shape.mesh();
        for x in &mesh.points {
            assert!(shape.signed_distance(*x).abs() < 1e-12, "{name}: {x}");
        }
        let points = shape.surface_points(DVec3::splat(0.004), DVec3::ZERO);
        let nearest = |x: DVec3| points.iter().map(|p| p.position.distance(x)).fold(f64::INFINITY, f64::min);
        let mut last = DVec3::ZERO;
        for (n, x) in scattered().enumerate() {
            let (here, there) = (shape.signed_distance(x), shape.signed_distance(last));
            assert!((here - there).abs() <= x.distance(last) + 1e-12, "{name}: {x} {last}");
            let near = x + 1e-4 * (last - x).normalize_or_zero();
            assert!((here - shape.signed_distance(near)).abs() <= 1e-4 + 1e-12, "{name}: {x}");
            if n % 20 == 0 {
                let distance = nearest(x);
                assert!(
                    here.abs() <= distance + 1e-9 && here.abs() > distance - 0.004,
                    "{name}: {x} {here} {distance}"
                );
            }
            last = x;
        }
    }
}

#[test]
fn the_sign_says_what_is_inside() {
    // Winding of the mesh round a point by the solid angles of its triangles (van Oosterom & Strackee 1983).
    for (name, shape) in shapes() {
        let mesh = shape.mesh();
        for x in scattered().step_by(40) {
            let angle = |t: &[u32; 3]| {
                let [a, b, c] = t.map(|n| mesh.points[n as usize] - x);
                let volume = a.dot(b.cross(c));
                let [la, lb, lc] = [a, b, c].map(DVec3::length);
                2.0 * volume.atan2(la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb)
            };
            let winding = mesh.triangles.iter().map(angle).sum::<f64>() / (4.0 * PI);
            let distance = shape.signed_distance(x);
            // The mesh lies a little within what is round.
            if distance.abs() > 2e-4 {
                let expected = if distance < 0.0 { 1.0 } else { 0.0 };
                assert!((winding - expected).abs() < 1e-6, "{name}: {x} {distance} {winding}");
            }
        }
    }
}

#[test]
fn meshes_are_closed() {
    for (name, shape) in shapes() {
        let mesh = shape.mesh();
        let mut edges: BTreeMap<[u32; 2], i32> = BTreeMap::new();
        for [a, b, c] in &mesh.triangles {
            for [from, to] in [[a, b], [b, c], [c, a]] {
                *edges.entry([*from, *to]).or_default() += 1;
                *edges.entry([*to, *from]).or_default() -= 1;
            }
        }
        assert!(edges.values().all(|sum| *sum == 0), "{name}");
    }
}

#[test]
fn mass_properties_are_those_of_the_mesh() {
    for (name, shape) in shapes() {
        let (exact, mesh) = (shape.mass_properties(), MassProperties::of_mesh(&shape.mesh()));
        // Chords of 3.75° lie within a circle: 0.07 % of its area, twice that of its second moment, and more
        // of a thin dish.
        let tolerance = if name.starts_with("dished") { 6e-3 } else { 1e-3 };
        assert!((mesh.volume / exact.volume - 1.0).abs() < tolerance, "{name}: {exact:?} {mesh:?}");
        assert!(mesh.centroid.distance(exact.centroid) < 1e-4, "{name}: {exact:?} {mesh:?}");
        let size = exact.inertia.y_axis.y;
        let difference = (exact.inertia - mesh.inertia).to_cols_array();
        assert!(difference.iter().all(|d| d.abs() < 3.0 * tolerance * size), "{name}: {exact:?} {mesh:?}");
        for direction in [DVec3::X, DVec3::Y, DVec3::Z, -DVec3::Z, DVec3::new(0.6, 0.64, -0.48)] {
            let of_mesh =
                shape.mesh().points.iter().map(|x| x.dot(direction)).fold(f64::NEG_INFINITY, f64::max);
            let extent = shape.extent(direction);
            assert!(
                extent > of_mesh - 1e-12 && extent < of_mesh + 2e-4,
                "{name}: {direction} {extent} {of_mesh}"
            );
        }
    }
}

#[test]
fn volumes_are_those_of_the_textbook() {
    let volume = |shape: Box<dyn Shape>| shape.mass_properties().volume;
    let close = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-12, "{a} {b}");
    close(volume(round(0.05, DiscRim::Square, None)), PI * 0.01 * 0.05);
    // A cylinder and half a torus (Pappus).
    let (inner, h) = (0.075, 0.025);
    let half_torus = 0.5 * PI * h * h * 2.0 * PI * (inner + 4.0 * h / (3.0 * PI));
    close(
        volume(round(0.05, DiscRim::Rounded { radius: h }, None)),
        PI * inner * inner * 2.0 * h + half_torus,
    );
    let tip = 0.04 / 30_f64.to_radians().tan();
    close(volume(pointed(Axis::Z)), PI * (0.04 * 0.04 * tip / 3.0 + 0.03 * 0.03 * (0.2 - tip)));
    close(volume(Box::new(Extruded::new(wedge(0.2, 0.1), 0.08))), 0.5 * 0.2 * 0.1 * 0.08);
    // Each grouser adds its rectangle down to the chord of its foot, less the segment of the circle above
    // that.
    let half_foot = 0.04_f64.asin();
    let segment = 0.01 * (half_foot - half_foot.sin() * half_foot.cos());
    let grouser = 0.008 * (0.115 - 0.1 * half_foot.cos()) - segment;
    close(volume(spiked(11)), 0.08 * (PI * 0.01 + 11.0 * grouser));
    // Between the caps of two spheres about one centre, cut by a cylinder.
    let sphere = (0.1_f64.powi(2) + 0.03_f64.powi(2)) / 0.06;
    let below = |r: f64| 2.0 / 3.0 * PI * (r.powi(3) - (r * r - 0.01).powf(1.5));
    close(volume(round(0.02, DiscRim::Square, HOLLOW)), below(sphere + 0.02) - below(sphere));
}

#[test]
fn a_square_rim_is_that_of_the_disc() {
    let revolved = round(0.05, DiscRim::Square, None);
    let plain = geometry::Disc { diameter: 0.2, thickness: 0.05 };
    for x in scattered() {
        assert!((revolved.signed_distance(x) - plain.signed_distance(x)).abs() < 1e-15, "{x}");
    }
    let sum = |points: &[SurfacePoint]| points.iter().map(|p| p.area).sum::<f64>();
    for inset in [DVec3::splat(0.008), DVec3::new(0.004, 0.008, 0.012)] {
        let [own, other] = [&plain as &dyn Shape, revolved.as_ref()]
            .map(|shape| sum(&shape.surface_points(DVec3::splat(0.004), inset)));
        assert!((own / other - 1.0).abs() < 2e-2, "{own} {other}");
    }
    let (a, b) = (revolved.mass_properties(), plain.mass_properties());
    assert!((a.volume / b.volume - 1.0).abs() < 1e-14 && a.inertia.abs_diff_eq(b.inertia, 1e-16));
}

#[test]
fn points_of_mirrored_shapes_come_in_pairs() {
    let mirrored =
        ["square", "rounded", "fully rounded", "bevelled", "knife edge", "cone", "wheel", "blade", "wedge"];
    for (name, shape) in shapes().into_iter().filter(|(name, _)| mirrored.contains(name)) {
        let points = shape.surface_points(DVec3::new(0.005, 0.004, 0.003), DVec3::splat(0.002));
        assert!(points.len() % 2 == 0 && points.len() > 100, "{name}");
        for pair in points.chunks(2) {
            let flip = |v: DVec3| DVec3::new(v.x, -v.y, v.z);
            assert_eq!(flip(pair[0].position), pair[1].position, "{name}");
            assert_eq!(flip(pair[0].normal), pair[1].normal, "{name}");
            assert_eq!(pair[0].area.to_bits(), pair[1].area.to_bits(), "{name}");
        }
    }
}

#[test]
fn only_what_is_round_about_the_axle_need_not_turn_with_it() {
    let turns = |shape: Box<dyn Shape>| !shape.is_revolved();
    assert!(!turns(round(0.05, bevelled(0.0, Bevel::Low), HOLLOW)));
    assert!(turns(pointed(Axis::Z)) && turns(spiked(11)));
}

#[test]
fn lengths_that_exclude_each_other_make_no_shape() {
    let rim = |thickness: f64, rim, dish| disc(0.2, thickness, rim, dish).is_none();
    assert!(rim(0.05, DiscRim::Rounded { radius: 0.026 }, None));
    assert!(rim(0.05, DiscRim::Rounded { radius: 0.01 }, HOLLOW));
    assert!(rim(0.05, bevelled(0.05, Bevel::Both), None));
    assert!(rim(0.05, DiscRim::Bevelled { angle: 0.2, edge: 0.0, bevel: Bevel::Low }, None));
    assert!(rim(0.02, DiscRim::Square, Some(Dish { depth: 0.1, hollow_is_left: true })));
    assert!(cone(0.08, 0.5, 0.09, 0.5).is_none() && cone(0.08, 0.5, 0.08, 0.1).is_none());
    let spikes = |number, thickness| wheel(0.2, Grousers { number, height: 0.01, thickness });
    assert!(spikes(20, 0.04).is_none() && spikes(2, 0.3).is_none() && spikes(1, 0.01).is_some());
    assert!(blade([0.02, 0.15], Some((0.1, 0.0, Bevel::Low))).is_none());
    assert!(blade([0.02, 0.15], Some((0.5, 0.02, Bevel::Low))).is_none());
    assert!(blade([0.02, 0.15], None).is_some());
}

/// A rounding that the grid cannot resolve must not widen a body beyond what its square corner would.
#[test]
fn a_rounding_within_the_inset_is_a_corner() {
    let inset = DVec3::new(0.006, 0.004, 0.005);
    let laid_out = |rim| round(0.05, rim, None).surface_points(DVec3::splat(0.003), inset);
    let sum = |points: &[SurfacePoint]| points.iter().map(|p| p.area).sum::<f64>();
    let square = sum(&laid_out(DiscRim::Square));
    let mut last = square;
    for (radius, most) in [(1e-6, 1e-5), (0.002, 1e-2), (0.004, 2e-2)] {
        let rounded = sum(&laid_out(DiscRim::Rounded { radius }));
        assert!((rounded / square - 1.0).abs() < most, "{radius}: {rounded} {square}");
    }
    // The portion that is kept grows steadily with the radius.
    for n in 1..25 {
        let rounded = sum(&laid_out(DiscRim::Rounded { radius: 0.001 * f64::from(n) }));
        assert!((rounded / last - 1.0).abs() < 0.06, "{n} mm: {last} {rounded}");
        last = rounded;
    }
    // A bevel within the inset.
    let bevelled = sum(&laid_out(DiscRim::Bevelled { angle: 1.55, edge: 0.0499, bevel: Bevel::Both }));
    assert!((bevelled / square - 1.0).abs() < 2e-3, "{bevelled} {square}");
}
