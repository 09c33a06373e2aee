//! Bodies whose surface is in a file: the same forces as those of the shape itself, and cases that stay with
//! their files.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

#[path = "hostile_meshes/files.rs"]
#[allow(dead_code)] // each test uses some
mod files;

use coulter::case::{Case, advice, case_text, load};
use coulter::history::BodySample;
use coulter::interrupts::Interrupts;
use coulter::output::folder::hash_of;
use coulter::run::{self, RunOptions, Start};
use coulter::simulation::Simulation;
use files::{ENCODINGS, Surface, binary_stl, cube, disc, text_stl, union};
use std::path::{Path, PathBuf};

/// A thick disc in a small box of sand on coarse cells, towed and pressed down.
const TOW: &str = "format = 2\n[soil]\nlaw = 'mohr-coulomb'\nfriction_angle = '35 deg'\nunit_weight = '16 kN/m^3'\nyoung_modulus = '5 MPa'\n\
     [domain]\nx = ['-0.24 m', '0.24 m']\ny = ['-0.24 m', '0.24 m']\nz = ['-0.16 m', '0.08 m']\n[grid]\ncell = '20 mm'\ngrowth = 1\n\
     fine_x = ['-0.24 m', '0.24 m']\nfine_y = ['-0.24 m', '0.24 m']\nfine_z = ['-0.16 m', '0.08 m']\n\
     [run]\nduration = '0.2 s'\n[output]\nhistory_interval = '1 ms'\n[body.tool]\nfriction = 0.3\nsinkage = '15 mm'\nmass = '8 kg'\n\
     heave = { speed = '-0.1 m/s', ramp = '2 ms' }\nforward = { speed = '0.3 m/s', ramp = '2 ms' }\nspin = 'free'\n";
const DISC: &str = "shape = 'disc'\ndiameter = '200 mm'\nthickness = '80 mm'\n";
const MESH: &str = "shape = 'mesh'\nfile = 'tool.stl'\nunit = 'mm'\n";

/// The case with a body, its file beside it.
fn write(folder: &Path, body: &str, surface: &[u8]) -> PathBuf {
    std::fs::write(folder.join("tool.stl"), surface).unwrap();
    std::fs::write(folder.join("tow.toml"), format!("{TOW}{body}")).unwrap();
    folder.join("tow.toml")
}

fn case(surface: &Surface, overrides: &[&str]) -> Result<Case, String> {
    let folder = tempfile::tempdir().unwrap();
    let overrides: Vec<String> = overrides.iter().map(|set| (*set).to_owned()).collect();
    let file = write(folder.path(), MESH, &binary_stl(surface));
    load(&file, &overrides).map_err(|error| format!("{:?}", error.problems))
}

#[test]
fn a_disc_from_a_file_is_towed_like_a_disc() {
    let folder = tempfile::tempdir().unwrap();
    let impulses = |body: &str, segments: u32| {
        let file = write(folder.path(), body, &binary_stl(&disc(segments, 200.0, 80.0)));
        let case = load(&file, &["grid.cell=16 mm".to_owned()]).unwrap();
        let mut simulation = Simulation::<f64>::new(&case);
        for _ in 0..16 {
            simulation.advance().unwrap();
        }
        let samples = simulation.history.bodies[0].clone();
        // Forces are means over a sample: their sum is the impulse.
        let sum = |of: fn(&BodySample) -> f64| samples.iter().map(of).sum::<f64>();
        ([sum(|s| s.drag), sum(|s| s.vertical), sum(|s| s.axle_torque) / 0.1], simulation.state.step)
    };
    let (exact, steps) = impulses(DISC, 12);
    assert!(steps > 100, "{steps}");
    // The contact points lie elsewhere than on the disc, which on cells this coarse makes a difference of
    // some per cent over so few steps; over four times as many it is below 2 % with 96 segments, too.
    for (segments, tolerance) in [(96, 0.06), (384, 0.02)] {
        let (meshed, _) = impulses(MESH, segments);
        let apart = [0, 1, 2].map(|n| (meshed[n] - exact[n]).abs() / exact[1].abs());
        assert!(apart.iter().all(|x| *x < tolerance), "{segments} segments: {meshed:?}, not {exact:?}");
    }
}

#[test]
fn a_case_is_known_by_the_content_of_its_file() {
    let surface = disc(48, 200.0, 80.0);
    let one = case(&surface, &[]).unwrap();
    assert_eq!(case_text(&one), case_text(&case(&surface, &[]).unwrap()), "the folder makes no difference");
    let other = case(&disc(50, 200.0, 80.0), &[]).unwrap();
    assert_ne!(hash_of(&one), hash_of(&other));
    assert!(case_text(&one).contains(&one.bodies[0].shape.mesh().unwrap().hash));
    let words = one.bodies[0].shape.describe(&|x| format!("{x:.3} m"));
    assert_eq!(words, "mesh tool.stl, 0.200 m × 0.080 m × 0.200 m, 192 triangles");
}

#[test]
fn a_results_folder_holds_the_files_of_its_case() {
    let folder = tempfile::tempdir().unwrap();
    let file = write(folder.path(), MESH, &binary_stl(&disc(24, 200.0, 80.0)));
    let typed = std::fs::read_to_string(&file).unwrap();
    let case = load(&file, &["run.duration=2 ms".to_owned()]).unwrap();
    let results = folder.path().join("results");
    let interrupts = Interrupts::default();
    let options = |start| RunOptions::quiet(&results, start, &typed, "case.toml", &interrupts);
    run::run(&case, &options(Start::Anew)).unwrap();
    assert!(results.join("bodies/tool.stl").is_file());
    let copy =
        load(&results.join("case.toml"), &["run.duration=2 ms".to_owned(), "name=tow".to_owned()]).unwrap();
    assert_eq!(case_text(&copy).replace("tow", ""), case_text(&case).replace("tow", ""));
    // The copy is replaced with the result, and a run with another file is not resumed.
    let other = write(folder.path(), MESH, &binary_stl(&disc(26, 200.0, 80.0)));
    let other = load(&other, &["run.duration=2 ms".to_owned()]).unwrap();
    let refusal = run::run(&other, &options(Start::Resume)).unwrap_err().to_string();
    assert!(refusal.contains("another case file"), "{refusal}");
    let stale = run::run(&case, &options(Start::Replace)).unwrap_err().to_string();
    assert!(stale.contains("has changed since the case was read"), "{stale}");
    run::run(&other, &options(Start::Replace)).unwrap();
}

#[test]
fn only_mirrored_bodies_are_cut_by_a_plane_of_symmetry() {
    let half = ["domain.symmetric=true", "domain.y=['0 m', '0.24 m']", "grid.fine_y=['0 m', '0.24 m']"];
    assert!(case(&disc(48, 200.0, 80.0), &half).is_ok());
    let refusal = case(&disc(48, 200.0, 80.0).moved([0.0, 1.0, 0.0]), &half).unwrap_err();
    assert!(refusal.contains("not its own mirror image in y = 0"), "{refusal}");
}

#[test]
fn what_was_repaired_is_a_warning_and_what_is_wrong_has_its_line() {
    let inverted = case(&disc(48, 200.0, 80.0).inverted(), &[]).unwrap();
    assert!(advice(&inverted).iter().any(|note| note.contains("all triangles face inwards")));
    let refusal = case(&union(&cube(100.0), &cube(100.0).moved([30.0, 20.0, 10.0])), &[]).unwrap_err();
    assert!(
        refusal.contains("body.tool.file")
            && refusal.contains("two parts overlap: one goes through the other at"),
        "{refusal}"
    );
    for (set, words) in [
        ("body.tool.unit=km", "possible"),
        ("body.tool.unit=m", "unit is probably wrong"),
        ("body.tool.file=other.stl", "cannot be read"),
        ("body.tool.diameter=1 m", "`diameter` does not apply"),
        ("domain.plane_strain=true", "cannot be combined with plane_strain"),
        ("grid.cell=100 mm", "cells across body.tool.file"),
        ("body.tool.spin={ slip = 0.1 }", "slip"),
    ] {
        let refusal = case(&disc(48, 200.0, 80.0), &[set]).unwrap_err();
        assert!(refusal.contains(words), "{set}: {refusal}");
    }
}

#[test]
fn every_encoding_is_the_same_body_turned_as_one_likes() {
    let folder = tempfile::tempdir().unwrap();
    let surface = cube(100.0).moved([20.0, 0.0, 10.0]);
    let mut bounds = Vec::new();
    for (name, write_as) in ENCODINGS {
        let file = write(folder.path(), &MESH.replace("tool.stl", name), text_stl(&surface).as_bytes());
        std::fs::write(folder.path().join(name), write_as(&surface)).unwrap();
        let case =
            load(&file, &["body.tool.yaw=30 deg".to_owned(), "body.tool.pitch=20 deg".to_owned()]).unwrap();
        bounds.push(case.bodies[0].bounds());
    }
    assert!(
        bounds.iter().all(|(low, high)| (low.distance(bounds[0].0)).max(high.distance(bounds[0].1)) < 1e-8)
    );
    // Its origin is the reference point, its lowest point at the sinkage.
    let (low, high) = bounds[0];
    assert!(high.z - low.z > 0.12 && (low.z + high.z) > 0.005, "{low} {high}");
}
