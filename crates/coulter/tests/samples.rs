//! What the samples of a body say of a run.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use coulter::case::{self, Case};
use coulter::simulation::Simulation;

/// The shipped tow.
fn tow(overrides: &[&str]) -> Case {
    let path = format!("{}/../../cases/light_disc.toml", env!("CARGO_MANIFEST_DIR"));
    let overrides: Vec<String> = overrides.iter().map(|o| (*o).to_owned()).collect();
    case::load(path.as_ref(), &overrides).unwrap()
}

/// Sinkage was measured from z = 0, wherever the surface was.
#[test]
fn sinkage_is_measured_from_the_soils_own_surface() {
    let shift = [
        "ground.surface=\"0.05 m\"",
        "domain.z=[\"-0.2 m\", \"0.125 m\"]",
        "grid.fine_z=[\"-0.15 m\", \"0.125 m\"]",
    ];
    let coarse = ["grid.cell=\"25 mm\"", "body.disc.sinkage=\"10 mm\""];
    let run = |more: &[&str]| {
        let mut simulation = Simulation::<f64>::new(&tow(&[&coarse, more].concat()));
        (0..5).for_each(|_| simulation.advance().unwrap());
        *simulation.history.bodies[0].last().unwrap()
    };
    let (level, raised) = (run(&[]), run(&shift));
    assert!((level.sinkage - 0.01).abs() < 2e-3, "{}", level.sinkage);
    assert!((raised.sinkage - level.sinkage).abs() < 1e-6, "{} and {}", raised.sinkage, level.sinkage);
    assert!((raised.embedded_volume / level.embedded_volume - 1.0).abs() < 1e-6);
}

/// The torques of both halves cancel where x = 0 is a plane of symmetry.
#[test]
fn a_plane_of_symmetry_across_the_tow_leaves_no_torque() {
    let case = "format = 2\n[soil]\nlaw = 'mohr-coulomb'\nfriction_angle = '30 deg'\nunit_weight = '16 kN/m^3'\n\
        young_modulus = '5 MPa'\n[domain]\nsymmetric = true\nsymmetric_x = true\n[grid]\ncell = '25 mm'\n\
        [body.disc]\nshape = 'disc'\ndiameter = '0.2 m'\nthickness = '0.1 m'\nfriction = 0.3\nsinkage = '10 mm'\n\
        heave = { speed = '-0.1 m/s' }\n[run]\nduration = '0.5 s'\n[output]\nhistory_interval = '4 ms'\n";
    let case = case::parse(case, "disc.toml", &[]).unwrap();
    let mut simulation = Simulation::<f64>::new(&case);
    (0..20).for_each(|_| simulation.advance().unwrap());
    let samples = &simulation.history.bodies[0];
    assert!(samples.iter().any(|s| s.vertical > 1.0), "the disc must stand on the soil");
    assert!(samples.iter().all(|s| s.axle_torque == 0.0 && s.drag == 0.0));
}
