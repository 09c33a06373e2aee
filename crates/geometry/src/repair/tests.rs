use super::*;
use crate::{Block, Disc, Shape, Sphere};

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
        let found = repaired(&mesh).unwrap();
        assert_eq!((found.shells, found.cavities, found.turned, found.flattened), (1, 0, 0, 0));
        assert!(found.merged_within.is_none() && !found.partly_searched && found.dropped == 0);
    }
    assert_eq!(repaired(&soup(&disc)).unwrap().solid.surface().points.len(), disc.points.len());
}

#[test]
fn orientation_is_repaired() {
    let sphere = Sphere { diameter: 0.3 }.mesh();
    let expected = MassProperties::of_mesh(&sphere).volume;
    let all = repaired(&inverted(sphere.clone())).unwrap();
    assert!(all.inverted && all.turned == sphere.triangles.len());
    let mut mixed = sphere;
    mixed.triangles.iter_mut().step_by(3).for_each(|t| t.swap(0, 1));
    let some = repaired(&soup(&mixed)).unwrap();
    assert!(!some.inverted && some.turned == mixed.triangles.len().div_ceil(3));
    for found in [all, some] {
        assert!((volume(&found) / expected - 1.0).abs() < 1e-12);
    }
}

#[test]
fn shells_may_touch_and_be_hollow_but_not_overlap() {
    let (one, half) = (cube([0.0; 3], 1.0), cube([0.0; 3], 0.5));
    let hollow = repaired(&union(&[one.clone(), inverted(half.clone())])).unwrap();
    assert_eq!((hollow.shells, hollow.cavities, hollow.turned), (2, 1, 0));
    assert!((volume(&hollow) - 0.875).abs() < 1e-12);
    let inside_out = repaired(&inverted(union(&[one.clone(), inverted(half.clone())]))).unwrap();
    assert!(inside_out.inverted && (volume(&inside_out) - 0.875).abs() < 1e-12);
    assert!(matches!(repaired(&union(&[one.clone(), half])), Err(Defect::Nested { .. })));
    // Face on face, with points of their own; and so in STL, where their edges are the same.
    let touching = union(&[one.clone(), cube([1.0, 0.0, 0.0], 1.0)]);
    assert!((volume(&repaired(&touching).unwrap()) - 2.0).abs() < 1e-12);
    // The same as STL has it: the wall between them goes.
    let one_part = repaired(&soup(&touching)).unwrap();
    assert!(
        one_part.mends[0].kind == MendKind::InnerWall && one_part.mends[0].triangles == 4,
        "{one_part:?}"
    );
    assert!(one_part.shells == 1 && (volume(&one_part) - 2.0).abs() < 1e-12);
    let apart = repaired(&soup(&union(&[one.clone(), inverted(cube([3.0, 0.0, 0.0], 1.0))]))).unwrap();
    assert_eq!((apart.shells, apart.cavities, apart.turned), (2, 0, 12));
    for at in [[0.3, 0.2, 0.1], [0.5, 0.0, 0.0], [0.5, 0.5, 0.0], [0.999, 0.0, 0.0], [0.5; 3]] {
        let both = union(&[one.clone(), cube(at, 1.0)]);
        assert!(
            matches!(
                repaired(&both),
                Err(Defect::Overlap { .. } | Defect::Crossing { .. } | Defect::Nested { .. })
            ),
            "{at:?}"
        );
    }
}

#[test]
fn gaps_and_branches_are_refused_with_their_place() {
    let mut open = cube([0.0; 3], 1.0);
    open.triangles.pop();
    match repaired(&soup(&open)) {
        Err(Defect::Open { edges: 3, place }) => assert!((place.abs().max_element() - 0.5).abs() < 1e-12),
        other => panic!("{other:?}"),
    }
    let mut finned = cube([0.0; 3], 1.0);
    let [a, b, _] = finned.triangles[0];
    finned.points.push(DVec3::splat(2.0));
    finned.triangles.extend([[a, b, 8], [b, a, 8]]);
    assert!(matches!(repaired(&finned), Err(Defect::Sheet { triangles: 2, .. })));
    let edge_on_edge = union(&[cube([0.0; 3], 1.0), cube([1.0, 1.0, 0.0], 1.0)]);
    let found = repaired(&soup(&edge_on_edge));
    assert!(matches!(found, Err(Defect::NotManifold { triangles: 4, edges: 1, .. })), "{found:?}");
    assert!(matches!(repaired(&Mesh::default()), Err(Defect::Empty)));
    let flat = Mesh { points: vec![DVec3::ZERO, DVec3::X, DVec3::Y], triangles: vec![[0, 1, 2], [0, 2, 1]] };
    assert!(matches!(repaired(&flat), Err(Defect::NoVolume)));
    let mut broken = cube([0.0; 3], 1.0);
    broken.points[3].y = f64::NAN;
    assert!(matches!(repaired(&broken), Err(Defect::NotFinite { point: 3 })));
    let mut lost = cube([0.0; 3], 1.0);
    lost.triangles[5][1] = 99;
    assert!(matches!(repaired(&lost), Err(Defect::NoSuchPoint { triangle: 5 })));
}

#[test]
fn rounded_points_are_merged_and_said_so() {
    let mut rounded = soup(&Sphere { diameter: 0.3 }.mesh());
    for (n, x) in rounded.points.iter_mut().enumerate() {
        *x += DVec3::splat(1e-8 * f64::from(n as u32 % 7));
    }
    assert!(repaired(&rounded).unwrap().merged_within.is_some_and(|d| (d - 3e-7).abs() < 1e-8));
}

#[test]
fn points_may_lie_far_off() {
    let mut spare = soup(&cube([0.0; 3], 1.0));
    spare.points.push(DVec3::splat(1e86));
    assert!((volume(&repaired(&spare).unwrap()) - 1.0).abs() < 1e-12);
    // Far from the origin over the tolerance, within which points are merged.
    let found = repaired(&soup(&cube([1e17, 0.0, 0.0], 64.0))).unwrap();
    assert_eq!((found.shells, found.solid.mesh().points.len()), (1, 8));
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
    let found = repaired(&split).unwrap();
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
    let found = repaired(&Mesh { points: points.collect(), triangles });
    assert!(matches!(found, Err(Defect::OneSided { .. })), "{found:?}");
}

fn kinds(found: &Repaired) -> Vec<(MendKind, usize)> {
    found.mends.iter().map(|mend| (mend.kind, mend.triangles)).collect()
}

#[test]
fn what_has_one_safe_answer_is_mended_and_said() {
    let whole = Sphere { diameter: 0.3 }.mesh();
    let expected = MassProperties::of_mesh(&whole).volume;
    let mends = |mesh: &Mesh, tolerance: f64| {
        let found = repaired(&soup(mesh)).unwrap();
        assert!((volume(&found) / expected - 1.0).abs() < tolerance, "{found:?}");
        kinds(&found)
    };
    let with = |change: &dyn Fn(&mut Mesh)| {
        let mut mesh = whole.clone();
        change(&mut mesh);
        mesh
    };
    for number in [0, 77, whole.triangles.len() - 1] {
        let [a, b, c] = whole.triangles[number];
        // A facet there twice or three times, in either orientation, and two neighbours.
        for more in [&[[a, b, c]][..], &[[b, a, c]], &[[a, b, c], [c, a, b]]] {
            let doubled = with(&|m| m.triangles.extend(more));
            assert_eq!(mends(&doubled, 1e-12), [(MendKind::Doubled, more.len())]);
        }
        let two = with(&|m| m.triangles.extend_from_within(number.min(76)..number.min(76) + 2));
        assert_eq!(mends(&two, 1e-12), [(MendKind::Doubled, 2)]);
        // A facet that hangs by an edge, and two that hang together.
        let flap = with(&|m| {
            m.points.push(1.1 * m.points[a as usize]);
            m.triangles.push([a, b, m.points.len() as u32 - 1]);
        });
        assert_eq!(mends(&flap, 1e-12), [(MendKind::Flap, 1)]);
        let longer = with(&|m| {
            let n = m.points.len() as u32;
            m.points.extend([1.1 * m.points[a as usize], 1.1 * m.points[b as usize]]);
            m.triangles.extend([[a, b, n], [b, n + 1, n], [a, c, b]]);
        });
        assert_eq!(mends(&longer, 1e-12), [(MendKind::Flap, 2), (MendKind::Doubled, 1)]);
        // A corner in the middle of an edge of another facet.
        let junction = with(&|m| {
            let n = m.points.len() as u32;
            m.points.push(0.5 * (m.points[a as usize] + m.points[b as usize]));
            m.triangles[number] = [a, n, c];
            m.triangles.push([n, b, c]);
        });
        assert_eq!(mends(&junction, 1e-12), [(MendKind::Divided, 1)]);
    }
}

#[test]
fn a_seam_is_closed_where_it_is_narrow_and_measured_where_it_is_not() {
    // The upper half of a sphere, its points apart from those of the lower half.
    let apart = |gap: f64| {
        let mut mesh = Sphere { diameter: 0.3 }.mesh();
        let is_upper = |m: &Mesh, t: &[u32; 3]| t.iter().map(|n| m.points[*n as usize].z).sum::<f64>() > 0.0;
        let upper: Vec<bool> = mesh.triangles.iter().map(|t| is_upper(&mesh, t)).collect();
        let count = mesh.points.len() as u32;
        mesh.points.extend_from_within(..);
        mesh.points[count as usize..].iter_mut().for_each(|x| x.z += gap);
        mesh.triangles
            .iter_mut()
            .zip(upper)
            .filter(|(_, up)| *up)
            .for_each(|(t, _)| *t = t.map(|n| n + count));
        mesh
    };
    for gap in [1e-6, 1e-5, 2e-4] {
        let found = repaired(&apart(gap)).unwrap();
        assert!(found.merged_within.is_some_and(|d| d >= gap && d < 20.0 * gap), "{gap}: {found:?}");
        assert_eq!(kinds(&found).last().map(|(kind, _)| *kind), Some(MendKind::Seam));
        let expected = Sphere { diameter: 0.3 }.mass_properties().volume;
        assert!((volume(&found) / expected - 1.0).abs() < 5e-3);
    }
    let found = repaired(&apart(2e-3));
    assert!(
        matches!(found, Err(Defect::Seam { width, .. }) if (width / 2e-3 - 1.0).abs() < 0.01),
        "{found:?}"
    );
}

#[test]
fn broken_surfaces_cause_no_panic() {
    let mut seed = 3_u64;
    // Knuth's linear congruential generator (1998).
    let mut random = |most: usize| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) as usize % most
    };
    let mut closed = 0;
    for _ in 0..400 {
        let mut mesh =
            if random(2) == 0 { cube([0.0; 3], 1.0) } else { Disc { diameter: 0.2, thickness: 0.05 }.mesh() };
        for _ in 0..=random(3) {
            let (one, other) = (random(mesh.triangles.len()), random(mesh.triangles.len()));
            match random(5) {
                0 => mesh.triangles.push(mesh.triangles[one]),
                1 => drop(mesh.triangles.swap_remove(one)),
                2 => mesh.triangles[one][random(3)] = mesh.triangles[other][0],
                3 => mesh.triangles[one].swap(0, 1),
                _ => {
                    let point = random(mesh.points.len());
                    mesh.points[point] *= 1.0 + 1e-4 * random(3) as f64;
                }
            }
        }
        if let Ok(found) = repaired(&soup(&mesh)) {
            closed += 1;
            assert!(found.solid.mass_properties().volume > 0.0);
        }
    }
    assert!(closed > 50, "{closed}");
}
