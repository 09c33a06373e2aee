//! Ten decks: what each becomes, in values of the case that is read back.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use coulter::case::Case;
use coulter::case::resolved::Motion;
use coulter_import::{Imported, import};
use deck::Outcome;
use std::path::{Path, PathBuf};

fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("decks").join(format!("{name}.inp"))
}

/// A deck as it is imported, and the case as it is read back.
fn imported(name: &str) -> (Imported, Case) {
    let deck = deck::read(&path(name)).unwrap();
    let imported = import(&deck, None, name).unwrap_or_else(|refused| panic!("{name}: {refused:?}"));
    let folder = tempfile::tempdir().unwrap();
    for (file, bytes) in &imported.files {
        std::fs::write(folder.path().join(file), bytes).unwrap();
    }
    let file = folder.path().join(format!("{name}.toml"));
    std::fs::write(&file, &imported.case).unwrap();
    let case = coulter::case::load(&file, &[]).unwrap_or_else(|error| panic!("{name}: {error:?}"));
    assert_eq!(imported.entries.len(), deck.blocks.len(), "{name}: an entry for each block");
    assert!(imported.case.lines().filter(|line| line.contains(".inp:")).count() > 10, "{}", imported.case);
    (imported, case)
}

fn near(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 1e-6 * expected.abs().max(1e-9), "{found} instead of {expected}");
}

fn approximated(imported: &Imported, words: &str) -> bool {
    imported.entries.iter().any(|e| matches!(&e.outcome, Outcome::Approximated(text) if text.contains(words)))
}

/// Low and high of the box along an axis [m].
fn ends(case: &Case, axis: usize) -> [f64; 2] {
    let faces = &case.grid.faces[axis];
    [faces[0], faces[faces.len() - 1]]
}

#[test]
fn plate_in_kilonewtons_and_plane_strain() {
    let (imported, case) = imported("plate");
    assert!(case.domain.plane_strain && case.domain.symmetric_x);
    near(case.soil.density, 1800.0);
    near(case.soil.young_modulus, 25e6);
    near(case.soil.k0, 1.0);
    near(case.gravity, 9.81);
    assert!(imported.case.contains("shear_strength = \"50000 Pa\""), "{}", imported.case);
    assert!(imported.case.contains("size = [\"1 m\", \"0.5 m\"]"), "{}", imported.case);
    assert_eq!([0, 1, 2].map(|axis| case.grid.faces[axis].len() - 1), imported.cells);
}

#[test]
fn pipe_in_millimetres_is_a_cylinder_and_has_two_stages() {
    let (imported, case) = imported("pipe");
    near(case.soil.density, 1600.0);
    assert!(imported.case.contains("shear_strength = \"5000 Pa\""));
    assert!(imported.case.contains("diameter = \"0.2 m\"") && approximated(&imported, "circle around them"));
    assert_eq!(case.stages.iter().map(|stage| stage.name.as_str()).collect::<Vec<_>>(), ["press", "sweep"]);
    near(ends(&case, 0)[0], -1.0);
}

#[test]
fn cone_and_spudcan_are_native_cones_in_a_quarter() {
    for (name, diameter, angle) in [("cone", 0.036, 60.0), ("spudcan", 6.0, 150.0)] {
        let (imported, case) = imported(name);
        assert!(case.domain.symmetric && case.domain.symmetric_x, "{name}");
        let key = |key: &str| {
            let line = imported.case.lines().find(|line| line.starts_with(key)).unwrap();
            line.split('"').nth(1).unwrap().split(' ').next().unwrap().parse::<f64>().unwrap()
        };
        near(key("diameter"), diameter);
        assert!((key("cone_angle") - angle).abs() < 1e-3);
        near(case.bodies[0].position[2], 0.5 * key("length"));
    }
}

#[test]
fn plough_turns_the_axes_and_matches_drucker_prager() {
    let (imported, case) = imported("plough");
    assert!(case.domain.plane_strain && approximated(&imported, "plane strain without dilation"));
    assert!(imported.report.contains("z along y of the deck"), "{}", imported.report);
    let angle = imported.case.lines().find_map(|line| line.strip_prefix("friction_angle = \"")).unwrap();
    let angle: f64 = angle.split(' ').next().unwrap().parse().unwrap();
    // The deck states the angle β in six decimals.
    assert!((angle - 32.0).abs() < 1e-5 && imported.case.contains("flow_potential"), "{angle}");
    let [x, z] = [0, 2].map(|axis| ends(&case, axis));
    assert_eq!([x, z].map(|range| range.map(|v| (v * 1e6).round() / 1e6)), [[-0.5, 1.8], [-0.4, 0.2]]);
    let ignored = imported.entries.iter().find(|entry| entry.keyword == "FIXED MASS SCALING").unwrap();
    assert!(matches!(&ignored.outcome, Outcome::Ignored(effect) if effect.contains("inertia")));
}

#[test]
fn pile_and_anchor_begin_in_the_ground() {
    let (_, case) = imported("pile");
    near(case.bodies[0].position[2], -0.5);
    let (_, case) = imported("anchor");
    near(case.bodies[0].position[2], -5.03125);
    assert!(case.domain.plane_strain && case.domain.symmetric_x);
}

#[test]
fn wheel_and_disc_have_the_mass_of_the_whole_and_follow_their_steps() {
    for (name, mass, inertia) in [("wheel", 14.0, 0.1), ("disc", 6.0, 0.04)] {
        let (_, case) = imported(name);
        let body = &case.bodies[0];
        near(body.mass, mass);
        near(body.axle_inertia, inertia);
        assert!(matches!(body.translation[2], Motion::Free { .. }), "{name}");
        assert!(case.domain.symmetric && case.stages.len() == 2 && case.stages[0].name == "sink");
    }
}

#[test]
fn column_in_centimetres_has_no_body() {
    let (imported, case) = imported("column");
    assert!(case.bodies.is_empty() && case.domain.plane_strain);
    near(case.soil.density, 1600.0);
    near(case.soil.young_modulus, 3e6);
    assert!(
        imported.case.contains("x = [\"0 m\", \"0.1 m\"]") && imported.case.contains("surface = \"0.1 m\"")
    );
    near(ends(&case, 0)[1], 0.4);
}

/// Whatever followed the fault was said to be unknown, too.
#[test]
fn a_misspelt_keyword_alone_is_named() {
    let text = std::fs::read_to_string(path("plough")).unwrap().replacen("*Density", "*Densety", 1);
    let deck = deck::read_with(&text, "plough.inp", |_| Err(String::new()));
    let refused = import(&deck, None, "plough").unwrap_err();
    let named: Vec<&str> = refused
        .entries
        .iter()
        .filter(|entry| matches!(entry.outcome, Outcome::Refused(_)))
        .map(|entry| entry.keyword.as_str())
        .collect();
    assert_eq!(named, ["DENSETY"], "{refused:?}");
}

#[test]
fn sums_that_cancel_are_written_as_zero() {
    assert!(!imported("plough").0.case.contains("0.0000000000"));
}
