//! Bodies with a yaw, a tilt and a pitch: forces that turn and are mirrored with the body, motions that
//! steer, and what is refused.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use coulter::case::{Case, parse};
use coulter::forecast::outlook;
use coulter::history::BodySample;
use coulter::history::reference::Reference;
use coulter::simulation::Simulation;
use std::f64::consts::FRAC_PI_2;

/// A thick disc in a small box of sand on coarse cells, towed and pressed down.
const DISC: &str = "format = 2\n[soil]\nlaw = 'mohr-coulomb'\nfriction_angle = '35 deg'\nunit_weight = '16 kN/m^3'\nyoung_modulus = '5 MPa'\n\
     [domain]\nx = ['-0.24 m', '0.24 m']\ny = ['-0.24 m', '0.24 m']\nz = ['-0.16 m', '0.08 m']\n[grid]\ncell = '20 mm'\ngrowth = 1\n\
     fine_x = ['-0.24 m', '0.24 m']\nfine_y = ['-0.24 m', '0.24 m']\nfine_z = ['-0.16 m', '0.08 m']\n[body.disc]\nshape = 'disc'\n\
     diameter = '0.2 m'\nthickness = '80 mm'\nfriction = 0.3\naxle_inertia = '0.02 kg*m^2'\nsinkage = '15 mm'\n\
     heave = { speed = '-0.1 m/s', ramp = '2 ms' }\nforward = { speed = '0.3 m/s', ramp = '2 ms' }\nspin = 'free'\n\
     [run]\nduration = '0.2 s'\n[output]\nhistory_interval = '1 ms'\n";

fn case(overrides: &[&str]) -> Result<Case, String> {
    let overrides: Vec<String> = overrides.iter().map(|set| (*set).to_owned()).collect();
    parse(DISC, "disc.toml", &overrides).map_err(|error| format!("{error:?}"))
}

/// The samples over the first milliseconds, each of some six steps.
fn run(overrides: &[&str], samples: u32) -> Vec<BodySample> {
    let mut simulation = Simulation::<f64>::new(&case(overrides).unwrap());
    for _ in 0..samples {
        simulation.advance().unwrap();
    }
    simulation.history.bodies[0].clone()
}

/// Largest difference of forces, and of moments over 0.1 m, relative to the vertical force; `sign` is that of
/// the lateral force and of the moments about x and z.
fn difference(a: &[BodySample], b: &[BodySample], sign: f64) -> f64 {
    assert!(a.len() == b.len() && a.len() > 3, "{} and {} samples", a.len(), b.len());
    let one = |(a, b): (&BodySample, &BodySample)| {
        let forces = [a.drag - b.drag, a.vertical - b.vertical, a.lateral - sign * b.lateral];
        let moments =
            [a.moment_x - sign * b.moment_x, a.moment_y - b.moment_y, a.moment_z - sign * b.moment_z];
        let apart = |all: [f64; 3], lever: f64| all.map(|x| x.abs() / lever).into_iter().fold(0.0, f64::max);
        apart(forces, 1.0).max(apart(moments, 0.1))
    };
    let scale = a.iter().map(|s| s.vertical.abs()).fold(0.0, f64::max);
    a.iter().zip(b).map(one).fold(0.0, f64::max) / scale
}

#[test]
fn a_mirrored_attitude_gives_mirrored_forces() {
    for (yaw, tilt) in [(20.0, 0.0), (0.0, 15.0), (30.0, -10.0)] {
        let turned = |side: f64| {
            let sets =
                [format!("body.disc.yaw={} deg", side * yaw), format!("body.disc.tilt={} deg", side * tilt)];
            run(&[&sets[0], &sets[1]], 16)
        };
        let (left, right) = (turned(1.0), turned(-1.0));
        let apart = difference(&left, &right, -1.0);
        assert!(apart < 1e-12, "yaw {yaw}°, tilt {tilt}°: {apart:e}");
        let last = left.last().unwrap();
        assert!(last.lateral.abs() > 1e-2 * last.vertical, "{last:?}");
    }
}

#[test]
fn a_disc_that_is_turned_round_with_its_tow_has_the_same_forces() {
    let often = "numerics.remap_displacement=0.01";
    let ahead = run(&[often, "body.disc.yaw=20 deg", "body.disc.tilt=10 deg"], 16);
    let sideways = run(
        &[
            often,
            "body.disc.yaw=110 deg",
            "body.disc.tilt=10 deg",
            "body.disc.forward=fixed",
            "body.disc.lateral={ speed = '0.3 m/s', ramp = '2 ms' }",
        ],
        16,
    );
    // Forces are along and across the tow, moments about the axes of space.
    let in_its_frame = |s: &BodySample| BodySample { moment_x: s.moment_y, moment_y: -s.moment_x, ..*s };
    let turned: Vec<BodySample> = sideways.iter().map(in_its_frame).collect();
    let apart = difference(&ahead, &turned, 1.0);
    assert!(apart < 1e-12, "{apart:e}");
    let (last, turned) = (ahead.last().unwrap(), sideways.last().unwrap());
    assert!((turned.yaw - last.yaw - FRAC_PI_2).abs() < 1e-12);
    assert!((turned.rolling_speed - last.rolling_speed).abs() < 1e-12);
    assert!((turned.spin / last.spin - 1.0).abs() < 1e-9, "{} and {}", turned.spin, last.spin);
    assert!((turned.displacement - last.displacement).abs() < 1e-12);
}

#[test]
fn the_axle_torque_is_the_moment_about_the_axle() {
    let samples = run(&["body.disc.yaw=25 deg", "body.disc.tilt=10 deg"], 10);
    let (yaw, tilt) = (25_f64.to_radians(), 10_f64.to_radians());
    for s in &samples {
        assert!((s.yaw - yaw).abs() < 1e-12 && (s.tilt - tilt).abs() < 1e-12);
        let about = -yaw.sin() * tilt.cos() * s.moment_x
            + yaw.cos() * tilt.cos() * s.moment_y
            + tilt.sin() * s.moment_z;
        assert!((about - s.axle_torque).abs() < 1e-9 * (1.0 + s.axle_torque.abs()), "{s:?}");
        assert!((s.rolling_speed - yaw.cos() * s.speed).abs() < 1e-12);
    }
}

#[test]
fn yaw_and_tilt_can_be_prescribed_and_free() {
    let turning = run(&["body.disc.yaw_motion={ speed = '0.5 rad/s', ramp = '0 s' }"], 16);
    let last = turning.last().unwrap();
    assert!((last.yaw - 0.5 * last.time).abs() < 1e-3 * last.yaw, "{last:?}");
    let tipped = ["body.disc.tilt_motion={ load = '5 N*m', ramp = '0 s' }", "body.disc.mass=8 kg"];
    assert!(run(&tipped, 16).last().unwrap().tilt > 1e-4);
}

#[test]
fn a_slip_refers_to_the_rolling_speed() {
    let case = case(&["body.disc.yaw=60 deg", "body.disc.spin={ slip = -0.2 }"]).unwrap();
    let mut simulation = Simulation::<f64>::new(&case);
    for _ in 0..10 {
        simulation.advance().unwrap();
    }
    let reference = &Reference::all(&case)[0];
    let ratio = simulation.history.bodies[0].last().unwrap().turn_ratio(reference).unwrap();
    assert!((ratio - 0.8).abs() < 1e-9, "{ratio}");
}

/// 3D-RFT of the disc held at its depth, with these changes: lateral force, moments and slip.
fn forecast(overrides: &[&str]) -> (f64, [f64; 3], Option<f64>) {
    let held = ["body.disc.heave=fixed", "body.disc.sinkage=40 mm"];
    let all: Vec<&str> = held.iter().chain(overrides).copied().collect();
    let outlook = outlook(&case(&all).unwrap()).unwrap();
    let model = outlook.best().unwrap();
    let found = model.prediction.unwrap();
    (found.lateral.unwrap(), outlook.moment(model).unwrap(), found.slip)
}

#[test]
fn the_forecast_follows_the_attitude() {
    let left = forecast(&["body.disc.yaw=30 deg", "body.disc.tilt=5 deg"]);
    let right = forecast(&["body.disc.yaw=-30 deg", "body.disc.tilt=-5 deg"]);
    let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-6 * left.0.abs(), "{a} and {b}");
    assert!(left.0 > 1.0, "the soil pushes the disc to the side to which it steers: {left:?}");
    close(left.0, -right.0);
    for (axis, sign) in [(0, -1.0), (1, 1.0), (2, -1.0)] {
        close(left.1[axis], sign * right.1[axis]);
    }
    // Towed backwards, the disc turned the other way is its mirror image about x = 0, whose left is its
    // right.
    let back = ["body.disc.forward.speed=-0.3 m/s", "body.disc.yaw=-30 deg", "body.disc.tilt=5 deg"];
    let back = forecast(&back);
    close(left.0, -back.0);
    for (axis, sign) in [(0, 1.0), (1, -1.0), (2, -1.0)] {
        close(left.1[axis], sign * back.1[axis]);
    }
    let driven = forecast(&["body.disc.yaw=60 deg", "body.disc.spin={ slip = -0.2 }"]);
    assert!((driven.2.unwrap() + 0.2).abs() < 1e-9, "{driven:?}");
}

#[test]
fn a_turned_block_stands_on_its_lowest_point() {
    // Its bounds turn with it, and its lowest point starts at its sinkage.
    let block = ["body.disc.shape=block", "body.disc.size=['60 mm', '100 mm', '120 mm']"];
    let with = |more: &[&str]| {
        let sets: Vec<&str> = block.iter().chain(more).copied().collect();
        let text = DISC.replace("diameter = '0.2 m'\nthickness = '80 mm'\n", "");
        let sets: Vec<String> = sets.into_iter().map(str::to_owned).collect();
        parse(&text, "block.toml", &sets).unwrap()
    };
    let (low, high) = with(&["body.disc.pitch=30 deg"]).bodies[0].bounds();
    let height = 0.06 * 0.5 + 0.12 * 0.75_f64.sqrt();
    assert!((high.z - low.z - height).abs() < 1e-12 && (high.y - 0.05).abs() < 1e-12);
    let turned = with(&["body.disc.pitch=30 deg", "body.disc.yaw=90 deg"]);
    let (low, high) = turned.bodies[0].bounds();
    assert!((high.z - low.z - height).abs() < 1e-12 && (high.x - 0.05).abs() < 1e-12);
    assert!((turned.bodies[0].position.z + low.z + 0.015).abs() < 1e-12);
}

#[test]
fn what_cannot_be_turned_is_refused() {
    let half = "domain.symmetric=true";
    for (overrides, message) in [
        (
            &[half, "domain.y=['0 m', '0.24 m']", "grid.fine_y=['0 m', '0.24 m']", "body.disc.yaw=5 deg"][..],
            "without `yaw`",
        ),
        (
            &[
                half,
                "domain.y=['0 m', '0.24 m']",
                "grid.fine_y=['0 m', '0.24 m']",
                "body.disc.tilt_motion=free",
            ],
            "no tilt motion",
        ),
        (&["body.disc.tilt=91 deg"], "tilt"),
        (&["body.disc.yaw=20 m"], "yaw"),
        (&["body.disc.yaw_motion={ slip = 0.1 }"], "`slip` belongs to `spin`"),
        (&["body.disc.yaw_motion={ speed = '1 m/s' }"], "rate of turning"),
        (
            &[
                "body.disc.yaw=20 deg",
                "body.disc.lateral=free",
                "body.disc.mass=1 kg",
                "body.disc.spin={ slip = 0 }",
            ],
            "the slip of a body with a yaw",
        ),
    ] {
        let refusal = case(overrides).unwrap_err();
        assert!(refusal.contains(message), "{overrides:?}: {refusal}");
    }
    let free = DISC.replace("axle_inertia = '0.02 kg*m^2'\n", "");
    let refusal = parse(
        &free,
        "disc.toml",
        &["body.disc.yaw_motion=free".to_owned(), "body.disc.spin=locked".to_owned()],
    );
    assert!(format!("{:?}", refusal.unwrap_err()).contains("moment of inertia is not known"));
}
