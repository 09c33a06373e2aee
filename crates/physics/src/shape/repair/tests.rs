use super::*;
use crate::shape::{Block, Disc, Shape, Sphere};

fn cube(at: [f64; 3], edge: f64) -> Mesh {
    let mesh = Block { size: DVec3::splat(edge) }.mesh();
    Mesh { points: mesh.points.iter().map(|x| *x + DVec3::from(at)).collect(), ..mesh }
}

fn union(parts: &[Mesh]) -> Mesh {
    let mut all = Mesh::default();
    for part in parts {
        let first = all.points.len() as u32;
        all.points.extend(&part.points);
        all.triangles.extend(part.triangles.iter().map(|t| t.map(|n| n + first)));
    }
    all
}

fn inverted(mut mesh: Mesh) -> Mesh {
    mesh.triangles.iter_mut().for_each(|t| t.swap(0, 1));
    mesh
}

/// Every triangle with its own points, as in STL.
fn soup(mesh: &Mesh) -> Mesh {
    let points: Vec<DVec3> = mesh.triangles.iter().flatten().map(|n| mesh.points[*n as usize]).collect();
    let triangles = (0..mesh.triangles.len() as u32).map(|n| [3 * n, 3 * n + 1, 3 * n + 2]).collect();
    Mesh { points, triangles }
}

fn volume(repaired: &Repaired) -> f64 {
    repaired.solid.mass_properties().volume
}

#[test]
fn a_sound_surface_stays_as_it_is() {
    let disc = Disc { diameter: 0.2, thickness: 0.05 }.mesh();
    for mesh in [disc.clone(), soup(&disc), Sphere { diameter: 0.3 }.mesh(), cube([1e3, 0.0, 0.0], 1.0)] {
        let found = repaired(mesh).unwrap();
        assert_eq!((found.shells, found.cavities, found.turned, found.flattened), (1, 0, 0, 0));
        assert!(found.merged_within.is_none() && !found.partly_searched && found.dropped == 0);
    }
    assert_eq!(repaired(soup(&disc)).unwrap().solid.surface().points.len(), disc.points.len());
}

#[test]
fn orientation_is_repaired() {
    let sphere = Sphere { diameter: 0.3 }.mesh();
    let expected = MassProperties::of_mesh(&sphere).volume;
    let all = repaired(inverted(sphere.clone())).unwrap();
    assert!(all.inverted && all.turned == sphere.triangles.len());
    let mut mixed = sphere;
    mixed.triangles.iter_mut().step_by(3).for_each(|t| t.swap(0, 1));
    let some = repaired(soup(&mixed)).unwrap();
    assert!(!some.inverted && some.turned == mixed.triangles.len().div_ceil(3));
    for found in [all, some] {
        assert!((volume(&found) / expected - 1.0).abs() < 1e-12);
    }
}

#[test]
fn shells_may_touch_and_be_hollow_but_not_overlap() {
    let (one, half) = (cube([0.0; 3], 1.0), cube([0.0; 3], 0.5));
    let hollow = repaired(union(&[one.clone(), inverted(half.clone())])).unwrap();
    assert_eq!((hollow.shells, hollow.cavities, hollow.turned), (2, 1, 0));
    assert!((volume(&hollow) - 0.875).abs() < 1e-12);
    let inside_out = repaired(inverted(union(&[one.clone(), inverted(half.clone())]))).unwrap();
    assert!(inside_out.inverted && (volume(&inside_out) - 0.875).abs() < 1e-12);
    assert!(matches!(repaired(union(&[one.clone(), half])), Err(Defect::Nested { .. })));
    // Face on face, with points of their own; and so in STL, where their edges are the same.
    let touching = union(&[one.clone(), cube([1.0, 0.0, 0.0], 1.0)]);
    assert!((volume(&repaired(touching.clone()).unwrap()) - 2.0).abs() < 1e-12);
    assert!(matches!(repaired(soup(&touching)), Err(Defect::NotManifold { .. })));
    let apart = repaired(soup(&union(&[one.clone(), inverted(cube([3.0, 0.0, 0.0], 1.0))]))).unwrap();
    assert_eq!((apart.shells, apart.cavities, apart.turned), (2, 0, 12));
    for at in [[0.3, 0.2, 0.1], [0.5, 0.0, 0.0], [0.5, 0.5, 0.0], [0.999, 0.0, 0.0], [0.5; 3]] {
        let both = union(&[one.clone(), cube(at, 1.0)]);
        assert!(matches!(repaired(both), Err(Defect::Crossing { .. } | Defect::Nested { .. })), "{at:?}");
    }
}

#[test]
fn gaps_and_branches_are_refused_with_their_place() {
    let mut open = cube([0.0; 3], 1.0);
    open.triangles.pop();
    match repaired(soup(&open)) {
        Err(Defect::Open { edges: 3, place }) => assert!((place.abs().max_element() - 0.5).abs() < 1e-12),
        other => panic!("{other:?}"),
    }
    let mut finned = cube([0.0; 3], 1.0);
    let [a, b, _] = finned.triangles[0];
    finned.points.push(DVec3::splat(2.0));
    finned.triangles.extend([[a, b, 8], [b, a, 8]]);
    assert!(matches!(repaired(finned), Err(Defect::NotManifold { triangles: 4, edges: 1, .. })));
    assert!(matches!(repaired(Mesh::default()), Err(Defect::Empty)));
    let flat = Mesh { points: vec![DVec3::ZERO, DVec3::X, DVec3::Y], triangles: vec![[0, 1, 2], [0, 2, 1]] };
    assert!(matches!(repaired(flat), Err(Defect::NoVolume)));
    let mut broken = cube([0.0; 3], 1.0);
    broken.points[3].y = f64::NAN;
    assert!(matches!(repaired(broken), Err(Defect::NotFinite { point: 3 })));
    let mut lost = cube([0.0; 3], 1.0);
    lost.triangles[5][1] = 99;
    assert!(matches!(repaired(lost), Err(Defect::NoSuchPoint { triangle: 5 })));
}

#[test]
fn rounded_points_are_merged_and_said_so() {
    let mut rounded = soup(&Sphere { diameter: 0.3 }.mesh());
    for (n, x) in rounded.points.iter_mut().enumerate() {
        *x += DVec3::splat(1e-8 * f64::from(n as u32 % 7));
    }
    assert!(repaired(rounded).unwrap().merged_within.is_some_and(|d| (d - 3e-7).abs() < 1e-8));
}

#[test]
fn a_sliver_becomes_part_of_its_neighbour() {
    // An edge of a cube is split on one side only, and the gap closed by a triangle without height.
    let mut split = cube([0.0; 3], 1.0);
    let [a, b, c] = split.triangles[0];
    let middle = 0.5 * (split.points[a as usize] + split.points[b as usize]);
    split.points.push(middle);
    split.triangles[0] = [a, 8, c];
    split.triangles.extend([[8, b, c], [a, b, 8]]);
    let found = repaired(split).unwrap();
    assert_eq!((found.flattened, found.solid.surface().triangles.len()), (1, 14));
    assert!((volume(&found) - 1.0).abs() < 1e-12);
    let block = Block { size: DVec3::ONE };
    for n in 0..1000 {
        let x =
            DVec3::new(0.618 * f64::from(n), 0.414 * f64::from(n), 0.732 * f64::from(n)).fract() * 2.0 - 1.0;
        assert!((found.solid.signed_distance(x) - block.signed_distance(x)).abs() < 1e-12, "{x}");
    }
}

#[test]
fn a_one_sided_surface_is_refused() {
    // A torus glued with its ends the wrong way round: Klein's bottle, of 6 × 6 squares.
    let point = |i: u32, j: u32| {
        let (i, j) = if i == 6 { (0, (6 - j % 6) % 6) } else { (i, j % 6) };
        6 * i + j
    };
    let mut triangles = Vec::new();
    for i in 0..6 {
        for j in 0..6 {
            let [a, b, c, d] = [point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    let points = (0..36_u32).map(|n| {
        let (u, v) = (f64::from(n / 6), f64::from(n % 6) * std::f64::consts::TAU / 6.0);
        DVec3::new((2.0 + v.cos()) * u.cos(), (2.0 + v.cos()) * u.sin(), v.sin())
    });
    let found = repaired(Mesh { points: points.collect(), triangles });
    assert!(matches!(found, Err(Defect::OneSided { .. })), "{found:?}");
}
