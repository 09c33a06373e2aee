//! No file of a surface, however broken, may cause a panic or take up memory: it is a body, repaired with a
//! report where need be, or it is refused with what is wrong.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

#[path = "hostile_meshes/files.rs"]
mod files;

use coulter::case::mesh_file::MeshFileProblem;
use coulter::case::shapes::MeshBody;
use cpu_time::ThreadTime;
use files::{ENCODINGS, Surface, bowl, cube, disc, klein_bottle, union};
use std::fs::File;
use std::path::Path;
use std::time::Duration;

fn load(folder: &Path, name: &str, bytes: &[u8], unit: &str) -> Result<MeshBody, MeshFileProblem> {
    std::fs::write(folder.join(name), bytes).unwrap();
    let began = ThreadTime::now();
    let loaded = MeshBody::load(folder, name, unit);
    assert!(began.elapsed() < Duration::from_secs(20), "{name}: {:?}", began.elapsed());
    if let Err(problem) = &loaded {
        assert!(
            !problem.message.is_empty() && !problem.cure.is_empty() && problem.message.len() < 400,
            "{problem}"
        );
    }
    loaded
}

#[track_caller]
fn refused(name: &str, bytes: &[u8], unit: &str, words: &str) {
    let folder = tempfile::tempdir().unwrap();
    match load(folder.path(), name, bytes, unit) {
        Ok(mesh) => panic!("{name} was accepted: {:?}", mesh.report()),
        Err(problem) => assert!(problem.to_string().contains(words), "`{words}` is not in: {problem}"),
    }
}

/// The surface in every encoding is refused.
#[track_caller]
fn refused_in_all(surface: &Surface, words: &str) {
    for (name, write) in ENCODINGS {
        refused(name, &write(surface), "mm", words);
    }
}

/// The surface in every encoding is repaired, and has this volume [mm³].
#[track_caller]
fn repaired_in_all(surface: &Surface, volume: f64, words: &str) {
    let folder = tempfile::tempdir().unwrap();
    for (name, write) in ENCODINGS {
        let mesh = load(folder.path(), name, &write(surface), "mm")
            .unwrap_or_else(|problem| panic!("{name}: {problem}"));
        let report = mesh.report();
        assert!(report.repairs.iter().any(|repair| repair.contains(words)), "{name}: {report:?}");
        assert!((1e9 * report.volume / volume - 1.0).abs() < 1e-5, "{name}: {report:?}");
    }
}

#[test]
fn a_sound_surface_is_read_in_every_encoding() {
    let folder = tempfile::tempdir().unwrap();
    let surface = disc(24, 200.0, 50.0);
    for (name, write) in ENCODINGS {
        let mesh = load(folder.path(), name, &write(&surface), "mm").unwrap();
        let report = mesh.report();
        assert_eq!((report.triangles, report.points, report.shells), (96, 50, 1), "{name}");
        assert!(report.repairs.is_empty() && report.centroid.length() < 1e-8, "{name}: {report:?}");
        assert!(
            (report.size.y - 0.05).abs() < 1e-9 && (report.volume - surface.volume() * 1e-9).abs() < 1e-9
        );
        let inches = load(folder.path(), name, &write(&disc(24, 8.0, 2.0)), "in").unwrap();
        assert!((inches.report().size.y - 0.0508).abs() < 1e-8, "{name}");
    }
    let named = b"solid\n facet normal 0 0 0\nouter loop\n".to_vec();
    refused("named.stl", &named, "mm", "ends without");
}

#[test]
fn faces_with_many_corners_and_odd_habits_are_read() {
    let folder = tempfile::tempdir().unwrap();
    let block = "# a block\r\nmtllib a.mtl\r\no block\r\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0 1.0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nv 9 9 9\n\
                 vn 0 0 1\nf -9//1 -6//1 -7//1 -8//1\nf 5 6 7 8\nf 1 2 6 5 # front\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    let mesh = load(folder.path(), "block.OBJ", block.as_bytes(), "cm").unwrap();
    assert!((mesh.report().volume - 1e-6).abs() < 1e-15 && mesh.report().points == 8, "{:?}", mesh.report());
    // The first corner sees none of the others past the notch; another one does.
    let arrow = "v 0 0 0\nv 2 2 0\nv 0 1 0\nv -2 2 0\nv 0 0 1\nv 2 2 1\nv 0 1 1\nv -2 2 1\n\
                 f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    let mesh = load(folder.path(), "arrow.obj", arrow.as_bytes(), "cm").unwrap();
    assert!((mesh.report().volume - 2e-6).abs() < 1e-15);
    let mut with_solid_header = files::binary_stl(&cube(100.0));
    with_solid_header[..10].copy_from_slice(b"solid cube");
    assert!(load(folder.path(), "header.stl", &with_solid_header, "mm").is_ok());
    let two = files::text_stl(&cube(100.0)) + &files::text_stl(&cube(100.0).moved([300.0, 0.0, 0.0]));
    assert_eq!(load(folder.path(), "two.stl", two.as_bytes(), "mm").unwrap().report().shells, 2);
}

#[test]
fn truncated_files_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let surface = disc(12, 200.0, 50.0);
    let mut count = 0;
    for (name, write) in ENCODINGS {
        let bytes = write(&surface);
        for cut in (0..bytes.len()).step_by(bytes.len() / 60 + 1) {
            count += 1;
            assert!(
                load(folder.path(), name, &bytes[..cut], "mm").is_err(),
                "{name} cut at {cut} of {}",
                bytes.len()
            );
        }
        // Whatever is left out at the end: it is whole, or refused.
        for cut in bytes.len() - 40..bytes.len() {
            count += 1;
            if let Ok(mesh) = load(folder.path(), name, &bytes[..cut], "mm") {
                assert!(
                    (1e9 * mesh.report().volume / surface.volume() - 1.0).abs() < 1e-5,
                    "{name} cut at {cut}"
                );
            }
        }
    }
    assert!(count > 400, "{count}");
}

#[test]
fn changed_bytes_and_noise_cause_no_panic() {
    let folder = tempfile::tempdir().unwrap();
    let mut seed = 1_u64;
    // Knuth's linear congruential generator (1998).
    let mut random = move || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) as usize
    };
    for (name, write) in ENCODINGS {
        let bytes = write(&disc(12, 200.0, 50.0));
        for _ in 0..150 {
            let mut changed = bytes.clone();
            for _ in 0..1 + random() % 3 {
                let place = random() % changed.len();
                changed[place] = random() as u8;
            }
            let _ = load(folder.path(), name, &changed, "mm");
        }
        for length in [1, 10, 83, 84, 85, 134, 1000, 20_000] {
            let noise: Vec<u8> = (0..length).map(|_| random() as u8).collect();
            assert!(load(folder.path(), name, &noise, "mm").is_err(), "{name}: {length}");
            let kept = bytes.len().min(60);
            let headed: Vec<u8> = bytes[..kept].iter().copied().chain(noise).collect();
            assert!(load(folder.path(), name, &headed, "mm").is_err(), "{name}: {length}");
        }
    }
}

#[test]
fn surfaces_that_bound_no_body_are_refused() {
    let whole = disc(12, 200.0, 50.0);
    let with = |change: &dyn Fn(&mut Surface)| {
        let mut surface = whole.clone();
        change(&mut surface);
        surface
    };
    refused_in_all(&with(&|s| s.triangles.truncate(47)), "not closed: 3 edges");
    refused_in_all(&with(&|s| s.triangles.truncate(20)), "not closed");
    refused_in_all(&with(&|s| s.points[5][1] = f64::NAN), "finite");
    refused_in_all(&with(&|s| s.points[5][1] = f64::INFINITY), "finite");
    refused_in_all(&with(&|s| s.points.iter_mut().for_each(|x| x[1] = 0.0)), "");
    refused_in_all(&with(&|s| s.points.iter_mut().for_each(|x| *x = [1.0; 3])), "");
    refused_in_all(&with(&|s| s.points[3][1] = 1e30), "unit is probably wrong");
    refused_in_all(&with(&|s| s.triangles.clear()), "");
    refused_in_all(&klein_bottle(80.0), "no inside");
    let one = cube(100.0);
    for at in [[30.0, 20.0, 10.0], [50.0, 0.0, 0.0], [50.0, 50.0, 0.0], [99.0, 0.0, 0.0], [50.0, 50.0, 50.0]]
    {
        refused_in_all(&union(&one, &one.moved(at)), "");
    }
    refused_in_all(&union(&one, &cube(50.0)), "inside another");
    // The bowl's bottom is pushed down through its foot.
    refused_in_all(&bowl(100.0, -30.0), "goes through itself at");
    refused_in_all(&union(&bowl(100.0, 30.0), &cube(60.0).moved([0.0, 0.0, 40.0])), "two parts overlap");
}

#[test]
fn what_can_be_repaired_is_repaired_with_a_report() {
    let whole = disc(12, 200.0, 50.0);
    let volume = whole.volume();
    let with = |change: &dyn Fn(&mut Surface)| {
        let mut surface = whole.clone();
        change(&mut surface);
        surface
    };
    repaired_in_all(&whole.inverted(), volume, "all triangles face inwards");
    repaired_in_all(
        &with(&|s| s.triangles.iter_mut().step_by(5).for_each(|t| t.swap(0, 1))),
        volume,
        "10 triangles",
    );
    repaired_in_all(&with(&|s| s.triangles.push([3, 3, 4])), volume, "1 triangles that join");
    repaired_in_all(
        &with(&|s| {
            // A corner in the middle of an edge of one triangle only.
            let [a, b, c] = s.triangles[0];
            let middle = [0, 1, 2].map(|n| 0.5 * (s.points[a as usize][n] + s.points[b as usize][n]));
            let new = s.points.len() as u32;
            s.points.push(middle);
            s.triangles[0] = [a, new, c];
            s.triangles.extend([[new, b, c], [a, b, new]]);
        }),
        volume,
        "without height",
    );
    let inner = cube(50.0);
    let folder = tempfile::tempdir().unwrap();
    for (name, write) in ENCODINGS {
        let hollow = write(&union(&cube(100.0), &inner.inverted()));
        let report = load(folder.path(), name, &hollow, "mm").unwrap().report().clone();
        assert!(report.cavities == 1 && (report.volume - 8.75e-4).abs() < 1e-9, "{name}: {report:?}");
    }
}

#[test]
fn what_people_have_is_repaired_with_its_place() {
    let whole = disc(12, 200.0, 50.0);
    let volume = whole.volume();
    let with = |change: &dyn Fn(&mut Surface)| {
        let mut surface = whole.clone();
        change(&mut surface);
        surface
    };
    // A facet there twice, one that hangs by an edge, a seam, a corner in the middle of another facet's edge.
    repaired_in_all(
        &with(&|s| s.triangles.push(s.triangles[0])),
        volume,
        "1 triangles that were there twice were dropped, at (",
    );
    repaired_in_all(
        &with(&|s| {
            let [a, b, _] = s.triangles[7];
            s.points.push([0.0, 40.0, 110.0]);
            s.triangles.push([a, b, s.points.len() as u32 - 1]);
        }),
        volume,
        "1 triangles of a flap",
    );
    let mut seam = whole.as_soup();
    for (x, t) in seam.points.iter_mut().zip((0..).map(|n| n / 3)) {
        x[1] += if t % 4 == 1 { 4e-4 } else { 0.0 };
    }
    repaired_in_all(&seam, volume, "a seam of 24 edges was closed, at (");
    repaired_in_all(
        &with(&|s| {
            let [a, b, c] = s.triangles[2];
            let middle = [0, 1, 2].map(|n| 0.5 * (s.points[a as usize][n] + s.points[b as usize][n]));
            s.points.push(middle);
            let new = s.points.len() as u32 - 1;
            s.triangles[2] = [a, new, c];
            s.triangles.push([new, b, c]);
        }),
        volume,
        "1 triangles were divided at corners",
    );
    // Points that differ by the rounding of a program that writes six digits.
    let mut rounded = whole.as_soup();
    rounded.points.iter_mut().enumerate().for_each(|(n, x)| x[0] += 1e-5 * f64::from(n as u32 % 5));
    repaired_in_all(&rounded, volume, "were merged");
}

#[test]
fn sizes_give_a_wrong_unit_away() {
    for (name, write) in ENCODINGS {
        let bytes = write(&disc(12, 200.0, 50.0));
        for unit in ["m", "ft"] {
            let words = format!("with unit = \"{unit}\"");
            if unit == "m" {
                refused(name, &bytes, unit, &words);
            }
        }
        refused(name, &write(&disc(12, 0.2, 0.05)), "mm", "unit is probably wrong");
        refused(name, &bytes, "kg", "a length is needed");
        refused(name, &bytes, "furlong", "unit");
    }
}

/// Names and texts of files that are refused, and words of the refusal.
const REFUSED: &[(&str, &str, &str)] = &[
    ("a.stl", "", "is empty"),
    ("a.stl", "solid a\nendsolid a\n", "no triangles"),
    ("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n", "line 4: expected three coordinates"),
    (
        "a.stl",
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 x\n",
        "line 4: `x` is not a finite number",
    ),
    ("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop\nendfacet\n", "line 6"),
    ("a.stl", "solid a\nvertex 0 0 0\n", "line 2: `vertex` is not expected"),
    ("a.stl", "<html><body>404</body></html>", "too short"),
    ("a.stl", "ply\nformat ascii 1.0\n", "is a PLY file"),
    ("a.ply", "solid a\n", "is not a PLY file"),
    ("a.obj", "ply\n", "is a PLY file"),
    ("a.step", "ISO-10303-21;", "extension is `step`"),
    ("mesh", "v 0 0 0", "extension is ``"),
    ("a.obj", "v 0 0\n", "line 1: expected three coordinates, found 2"),
    ("a.obj", "v 0 0 1e999\n", "line 1: `1e999` is not a finite number"),
    ("a.obj", "v 0 0 0\nf 1 2 3\n", "line 2: `2` is not one of the points so far"),
    ("a.obj", "v 0 0 0\nf 0 1 1\n", "line 2: `0`"),
    ("a.obj", "v 0 0 0\nf -2 1 1\n", "line 2: `-2`"),
    ("a.obj", "v 0 0 0\nf 1 1\n", "line 2: a face has 3 to"),
    ("a.obj", "v 0 0 0\nf 99999999999999999999 1 1\n", "line 2"),
    ("a.obj", "v 0 0 0\nf 1.5 1 1\n", "line 2"),
    ("a.obj", "curv 0 1\n", "line 1: `curv` belongs to a curved surface"),
    ("a.ply", "ply\n", "the header has no end"),
    ("a.ply", "ply\nformat xml 1.0\n", "line 2: the format `xml`"),
    ("a.ply", "ply\nend_header\n", "does not say the format"),
    ("a.ply", "ply\nformat ascii 1.0\nelement vertex -3\n", "line 3: `-3`"),
    ("a.ply", "ply\nformat ascii 1.0\nelement vertex 99999999999999999999\n", "line 3"),
    ("a.ply", "ply\nformat ascii 1.0\nelement vertex 4000000000\n", "declares 4000000000 points"),
    ("a.ply", "ply\nformat ascii 1.0\nelement face 10000000\n", "declares 10000000 triangles"),
    ("a.ply", "ply\nformat ascii 1.0\nproperty float x\n", "line 3: the property"),
    ("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\n", "line 4: the property `x`"),
    ("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty list float int x\n", "line 4"),
    (
        "a.ply",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n",
        "no properties x, y and z",
    ),
    ("a.ply", "ply\nformat ascii 1.0\nelement edge 4000000000\nend_header\n", "has no properties"),
    (
        "a.ply",
        "ply\nformat binary_little_endian 1.0\nelement edge 4000000000\nproperty int a\nend_header\n",
        "edge 1 is not complete",
    ),
    (
        "a.ply",
        "ply\nformat ascii 1.0\nelement face 1\nproperty float x\nend_header\n1\n",
        "no list vertex_indices",
    ),
    (
        "a.ply",
        "ply\nformat ascii 1.0\nelement face 1\nproperty list uint int vertex_indices\nend_header\n4000000000 1\n",
        "face 1",
    ),
    (
        "a.ply",
        "ply\nformat ascii 1.0\nelement face 1\nproperty list int int vertex_indices\nend_header\n-1 1\n",
        "face 1",
    ),
    (
        "a.ply",
        "ply\nformat ascii 1.0\nelement face 1\nproperty list int int vertex_indices\nend_header\n3 0 1 2\n",
        "face 1: 0 is not one of",
    ),
    (
        "a.ply",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n1 2 3 4\n",
        "more numbers",
    ),
    (
        "a.ply",
        "ply\nformat ascii 1.0\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n",
        "strips",
    ),
];

#[test]
fn what_no_file_may_hold_is_refused_by_line_or_number() {
    for (name, text, words) in REFUSED {
        refused(name, text.as_bytes(), "mm", words);
    }
}

#[test]
fn what_is_not_a_file_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    assert!(
        MeshBody::load(folder.path(), "missing.stl", "mm")
            .unwrap_err()
            .to_string()
            .contains("check the path")
    );
    std::fs::create_dir(folder.path().join("folder.stl")).unwrap();
    assert!(MeshBody::load(folder.path(), "folder.stl", "mm").unwrap_err().to_string().contains("a folder"));
    assert!(cfg!(not(unix)) || MeshBody::load(Path::new("/dev"), "zero.stl", "mm").is_err());
}

#[test]
fn faces_that_no_corner_sees_whole_are_divided_and_crossing_ones_refused() {
    // A star of 16 corners, 5 thick, its ends one face each; on lines that go on.
    let star = |z: f64| {
        (0..16_u32).map(move |n| {
            let (angle, radius) =
                (f64::from(n) * std::f64::consts::TAU / 16.0, if n % 2 == 0 { 10.0 } else { 4.0 });
            format!("v {} {} {z}\n", radius * angle.cos(), radius * angle.sin())
        })
    };
    let numbers = |n: Vec<u32>| n.iter().map(u32::to_string).collect::<Vec<_>>().join(" \\\n");
    let points: String = star(0.0).chain(star(5.0)).collect();
    let sides: String =
        (1..=16_u32).map(|n| format!("f {n} {} {} {}\n", n % 16 + 1, n % 16 + 17, n + 16)).collect();
    let text = |low: Vec<u32>| {
        let ends = format!("f {}\nf {}\n", numbers(low), numbers((17..=32).collect()));
        format!("# Units: mm\n{points}{ends}{sides}")
    };
    let folder = tempfile::tempdir().unwrap();
    let whole = text((1..=16).rev().collect());
    let mesh = load(folder.path(), "star.obj", whole.as_bytes(), "mm").unwrap();
    let area = 8.0 * 10.0 * 4.0 * (std::f64::consts::TAU / 16.0).sin();
    assert!((1e9 * mesh.report().volume / (5.0 * area) - 1.0).abs() < 1e-12, "{:?}", mesh.report());
    assert!(mesh.report().repairs.is_empty(), "{:?}", mesh.report());
    let mut crossed: Vec<u32> = (1..=16).rev().collect();
    crossed.swap(3, 9);
    refused(
        "star.obj",
        text(crossed).as_bytes(),
        "mm",
        "line 49: a face of 16 corners crosses itself: mend the face",
    );
    // One corner of it is lifted.
    let bent = whole.replacen("v 10 0 5\n", "v 10 0 5.1\n", 1);
    let mesh = load(folder.path(), "star.obj", bent.as_bytes(), "mm").unwrap();
    assert!(mesh.report().repairs[0].contains("faces are not plane, by up to"), "{:?}", mesh.report());
}

#[test]
fn the_unit_that_a_file_states_is_used_or_contradicted() {
    let folder = tempfile::tempdir().unwrap();
    let surface = disc(12, 8.0, 2.0);
    let binary = |header: &str| {
        let mut bytes = files::binary_stl(&surface);
        bytes[..80].fill(b' ');
        bytes[..header.len()].copy_from_slice(header.as_bytes());
        bytes
    };
    let of = |name: &str| ENCODINGS.iter().find(|(known, _)| *known == name).unwrap().1(&surface);
    let text = |name: &str, from: &str, to: &str| {
        String::from_utf8_lossy(&of(name)).replacen(from, to, 1).into_bytes()
    };
    let low = [b"ply\ncomment unit: inch\n", &of("low.ply")[4..]].concat();
    for (name, bytes, place) in [
        ("a.stl", binary("UNITS=in COLOR=abcd"), "in its header"),
        ("b.stl", text("text.stl", "solid part", "solid part units=IN"), "line 1"),
        ("a.obj", text("faces.obj", "# part", "# part\n# Units: inches"), "line 2"),
        ("a.ply", text("text.ply", "comment part", "obj_info unit of measure: inch"), "line 3"),
        ("b.ply", low, "line 2"),
    ] {
        let metres = load(folder.path(), name, &bytes, "in").unwrap().report().size.y;
        assert!((metres - 0.0508).abs() < 1e-9);
        let taken = MeshBody::load(folder.path(), name, None).unwrap();
        assert!(taken.unit == 0.0254 && (taken.report().size.y - 0.0508).abs() < 1e-9, "{name}");
        let problem = load(folder.path(), name, &bytes, "mm").unwrap_err().to_string();
        for words in [place, "unit = \"mm\"", "write unit = \"in\""] {
            assert!(problem.contains(words), "{name}: {problem}");
        }
    }
    for bytes in [binary(""), binary("COLOR=abcd,MATERIAL=efgh"), binary("unit 7 of the harrow")] {
        assert!(load(folder.path(), "c.stl", &bytes, "in").unwrap().report().repairs.is_empty());
        let problem = MeshBody::load(folder.path(), "c.stl", None).unwrap_err().to_string();
        assert!(problem.contains("does not state the unit") && problem.contains("add  unit ="), "{problem}");
    }
    let odd = load(folder.path(), "c.stl", &binary("units=furlong"), "in").unwrap();
    assert!(odd.report().repairs[0].contains("`units=furlong`"), "{:?}", odd.report());
}

#[test]
fn large_meshes_and_fans_are_read_and_laid_out_in_seconds() {
    let folder = tempfile::tempdir().unwrap();
    for segments in [4000, 12_000] {
        // Its ends are fans about the middle.
        let bytes = files::binary_stl(&disc(segments, 200.0, 50.0));
        let mesh = load(folder.path(), "fan.stl", &bytes, "mm").unwrap();
        let began = ThreadTime::now();
        let solid = coulter::case::shapes::CaseShape::solid(&mesh);
        let points = solid.surface_points(glam::DVec3::splat(2e-3), glam::DVec3::splat(2e-3));
        assert!(points.len() > 10_000 && began.elapsed() < Duration::from_secs(20), "{:?}", began.elapsed());
    }
}

/// Peak memory of this process [bytes].
#[cfg(target_os = "linux")]
fn peak_memory() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap();
    let line = status.lines().find(|line| line.starts_with("VmHWM")).unwrap();
    1024 * line.split_whitespace().nth(1).unwrap().parse::<u64>().unwrap()
}

#[test]
fn huge_files_are_refused_before_they_take_up_memory() {
    let folder = tempfile::tempdir().unwrap();
    let sparse = |name: &str, start: &[u8], length: u64| {
        std::fs::write(folder.path().join(name), start).unwrap();
        File::options().append(true).open(folder.path().join(name)).unwrap().set_len(length).unwrap();
        let began = ThreadTime::now();
        let problem = MeshBody::load(folder.path(), name, "mm").unwrap_err().to_string();
        assert!(began.elapsed() < Duration::from_secs(10), "{name}");
        problem
    };
    let declaring = |count: u32| [&[b' '; 80][..], &count.to_le_bytes()].concat();
    let ten_million = sparse("ten.stl", &declaring(10_000_000), 84 + 50 * 10_000_000);
    assert!(ten_million.contains("10000000 triangles, at most 2000000"), "{ten_million}");
    let lies = sparse("lies.stl", &declaring(u32::MAX), 1000);
    assert!(lies.contains("declares 4294967295 triangles") && lies.contains("it has 1000"), "{lies}");
    assert!(sparse("huge.obj", b"v 0 0 0\n", 1 << 40).contains("too large"));
    for (name, start) in
        [("line.stl", &b"solid "[..]), ("line.obj", b"v 0 0 "), ("line.ply", b"ply\nformat ")]
    {
        let problem = sparse(name, start, 300 << 20);
        assert!(problem.contains("longer than"), "{problem}");
    }
    let lists = b"ply\nformat binary_little_endian 1.0\nelement edge 9999999\nproperty list uint double a\nend_header\n\xff\xff\xff\xff";
    assert!(sparse("lists.ply", lists, 100 << 20).contains("edge 1 is not complete"));
    #[cfg(target_os = "linux")]
    assert!(peak_memory() < 400 << 20, "{} MB", peak_memory() >> 20);
}
