//! The figures of the checks, and the facts that they rest on, worked out by hand.

use super::*;
use results::trust::limits;

fn is_close(found: f64, exact: f64) -> bool {
    (found - exact).abs() <= 1e-9 * exact.abs()
}

/// The figure of a check of a history with these facts.
fn figure(setting: &Setting, history: &History, name: &str) -> f64 {
    check(setting, history, name)[0].value.unwrap()
}

/// Facts of the shipped tow.
fn facts() -> Setting {
    Setting::of(&tow(&[]))
}

/// The history with another course of the body: `change` is told how many samples came before.
fn moved(change: impl Fn(f64, &mut BodySample)) -> History {
    let mut history = history();
    history.bodies[0].iter_mut().enumerate().for_each(|(n, sample)| change(n as f64, sample));
    history
}

#[test]
fn facts_of_a_disc_in_a_box() {
    // 1.1 m by 0.3 m by 0.325 m, with 0.25 m of soil of 16 kN/m³ on cells of 12.5 mm.
    let setting = Setting::of(&tow(&["soil.cohesion=2 kPa", "numerics.precision=single"]));
    let Setting { cell, bodies, changes_volume, .. } = &setting;
    assert!(is_close(setting.gravity, 9.81) && is_close(setting.density, 16e3 / 9.81));
    assert!(is_close(setting.mass, 16e3 / 9.81 * 1.1 * 0.3 * 0.325) && setting.cohesion == 2e3);
    assert!(is_close(setting.floor_pressure, 4e3) && is_close(setting.floor_depth, 0.25));
    assert!(cell.iter().all(|width| is_close(*width, 0.0125)) && *changes_volume == [false; 2]);
    assert!(is_close(setting.least_force(), (16e3 * 0.0125 + 2e3) * 0.0125 * 0.0125));
    assert!(is_close(setting.energy_floor, 1e-3 * (16e3 * 0.0125 + 2e3) * 0.0125_f64.powi(3)));
    // σ²/2E, on average a third of that at the floor, where E is a fifth of 5 MPa.
    assert!(is_close(setting.elastic_at_rest, 0.5 * 4e3 * 4e3 / 3.0 / 1e6 * 1.1 * 0.3 * 0.25));
    assert!(is_close(setting.rounding, 16.0 * f64::from(f32::EPSILON)));
    assert!(setting.drainage_per_speed.is_none() && setting.pumped_per_volume.is_none());
    assert!(!setting.heaped && !setting.accepts_drained);
    let disc = &bodies[0];
    assert!(disc.extent.iter().zip([0.2, 0.05, 0.2]).all(|(found, exact)| is_close(found.unwrap(), exact)));
    assert!(is_close(disc.thickness.unwrap(), 0.05) && is_close(disc.diameter.unwrap(), 0.2));
    assert!(disc.heaves && disc.heaves_freely && disc.turns_freely && disc.turned_about.is_none());
    let dilating = Setting::of(&tow(&["soil.dilation_angle=5 deg", "body.disc.heave=fixed"]));
    assert_eq!(dilating.changes_volume, [false, true]);
    assert!(!dilating.bodies[0].heaves && !dilating.bodies[0].heaves_freely);
}

#[test]
fn facts_of_a_wall_in_plane_strain_are_those_of_a_metre() {
    let path = format!("{}/../../validation/B5_passive_wall/case.toml", env!("CARGO_MANIFEST_DIR"));
    let setting = Setting::of(&case::load(path.as_ref(), &[]).unwrap());
    let wall = &setting.bodies[0];
    assert!(is_close(setting.cell[1], 1.0) && is_close(wall.cell[1], 1.0) && wall.extent[1].is_none());
    assert!(is_close(setting.mass, setting.density * 4.5 * 1.5) && is_close(wall.volume, 0.25 * 1.5));
    assert!(wall.thickness.is_none() && wall.diameter.is_none() && !wall.turns_freely);
    assert!(is_close(setting.elastic_at_rest, 0.5 * 16e3 * 16e3 / 3.0 / (5e6 * 0.16_f64.sqrt()) * 4.5));
}

#[test]
fn energies_and_volumes_are_in_per_cent() {
    type Place = fn(&mut EnergySample) -> &mut f64;
    let energies: [(&str, Place); 5] = [
        ("energy balance", |e| &mut e.seepage),
        ("hourglass energy", |e| &mut e.hourglass),
        ("viscous energy", |e| &mut e.viscous),
        ("remap loss", |e| &mut e.remap_loss),
        ("contact energy", |e| &mut e.contact),
    ];
    for (name, place) in energies {
        let mut history = history();
        *place(&mut history.energy[399]) = -0.05 * 1.596;
        assert!(is_close(figure(&facts(), &history, name), 5.0), "{name}");
        // Of less than the least energy that means anything.
        history.energy[399] = EnergySample { volume_ratio: 1.0, ..EnergySample::default() };
        *place(&mut history.energy[399]) = 1e-9;
        assert!(is_close(figure(&facts(), &history, name), 100.0 * 1e-9 / facts().energy_floor), "{name}");
    }
    for (ratio, expected, change) in [
        (0.98, [false, false], 2.0),
        (1.02, [false, false], 2.0),
        (0.98, [true, false], 0.0),
        (1.02, [true, false], 2.0),
        (0.98, [false, true], 2.0),
        (1.02, [false, true], 0.0),
    ] {
        let mut history = history();
        history.energy[399].volume_ratio = ratio;
        let setting = Setting { changes_volume: expected, ..facts() };
        assert!((figure(&setting, &history, "soil volume") - change).abs() < 1e-9, "{ratio} {expected:?}");
    }
    let mut history = history();
    (history.energy[100].overdense, history.energy[399].void) = (0.03, 0.02);
    assert!(is_close(figure(&facts(), &history, "overdense soil"), 3.0));
    assert!(is_close(figure(&facts(), &history, "void under soil"), 2.0));
    history.bodies[0][200].embedded_volume = 3e-4;
    let closed = Setting { pumped_per_volume: Some(1e3), ..facts() };
    assert!(is_close(figure(&closed, &history, "pressure of displaced volume"), 100.0 * 1e3 * 2e-4));
}

#[test]
fn the_way_of_a_body_and_of_soil_is_in_cells() {
    // 3, 4 → 5, with 12 → 13, and 84 on the circumference → 85; angles of 2, 3 and 6 are 7 together.
    let way = moved(|n, s| {
        (s.displacement, s.lateral_displacement, s.sinkage) = (3e-5 * n, 4e-5 * n, 0.05 + 12e-5 * n);
        (s.rotation, s.yaw, s.tilt) = (240e-5 * n, 360e-5 * n, 720e-5 * n);
    });
    assert!(is_close(figure(&facts(), &way, "motion"), 399.0 * 85e-5 / 0.0125));
    let drained = Setting { drainage_per_speed: Some(2.0), ..facts() };
    assert!(is_close(figure(&drained, &way, "drainage number"), 2.0 * 13e-5 / 0.004));
    // Soil that falls from rest, v = t.
    let mut falls = moved(|_, s| s.displacement = 0.0);
    falls.energy.iter_mut().for_each(|e| e.kinetic = 0.5 * facts().mass * e.time * e.time);
    assert!(is_close(figure(&facts(), &falls, "motion"), 0.5 * 1.596 * 1.596 / 0.0125));
}

#[test]
fn force_and_stress_are_compared_with_those_on_the_body() {
    let force = 15_f64.hypot(40.0);
    let setting = facts();
    assert!(is_close(figure(&setting, &history(), "contact"), force / (16e3 * 0.0125_f64.powi(3))));
    // 2 ρ v² on 60 mm by 50 mm.
    let inertia = 2.0 * setting.density * 0.2 * 0.2 * 0.06 * 0.05;
    assert!(is_close(figure(&setting, &history(), "inertia (Froude number)"), 100.0 * inertia / force));
    let mut touched = history();
    touched.boundaries[10] = BoundarySample { lid_force: 0.4, wall_area: 2e-4, ..touched.boundaries[10] };
    touched.boundaries[265].stress_rise = 1e6;
    touched.boundaries.iter_mut().skip(266).for_each(|b| b.stress_rise = 1e3);
    assert!(is_close(figure(&setting, &touched, "soil at the lid"), 100.0 * 0.4 / force));
    assert!(is_close(figure(&setting, &touched, "soil at bare walls"), 2.0));
    // The embedded front, and the chord of 60 mm of a disc of 200 mm.
    let base = 2.0 * (0.06_f64 * 0.14).sqrt() * 0.05;
    let pressure = f64::hypot(15.0 / (0.06 * 0.05), 40.0 / base);
    assert!(is_close(figure(&setting, &touched, "stress at the boundaries"), 100.0 * 1e3 / pressure));
    // A torque of 50 N m about each axis, on a drum of 0.2 m by 0.05 m, 0.2 m high.
    let torques: [fn(&mut BodySample) -> &mut f64; 3] =
        [|s| &mut s.moment_x, |s| &mut s.axle_torque, |s| &mut s.moment_z];
    for (axis, torque) in torques.into_iter().enumerate() {
        let (mut setting, mut turned) = (setting.clone(), touched.clone());
        setting.bodies[0].turned_about = Some(axis);
        turned.bodies[0].iter_mut().for_each(|s| *torque(s) = -50.0);
        let sheared = 50.0 / (0.0625 * 0.5 * std::f64::consts::PI * 0.25 * 0.2);
        assert!(is_close(figure(&setting, &turned, "stress at the boundaries"), 100.0 * 1e3 / sheared));
    }
}

#[test]
fn resolution_is_in_cells() {
    let (names, setting) = (["cells over sinkage", "cells over contact chord", "cells over width"], facts());
    let cells = |setting: &Setting, history: &History| {
        names.map(|name| check(setting, history, name).first().and_then(|check| check.value))
    };
    let chord = 2.0 * (0.06_f64 * 0.14).sqrt() / 0.0125;
    let found = cells(&setting, &history()).map(Option::unwrap);
    assert!(
        found.into_iter().zip([4.8, chord, 4.0]).all(|(found, exact)| is_close(found, exact)),
        "{found:?}"
    );
    // Below its axle a disc is as long as its diameter.
    assert!(is_close(cells(&setting, &moved(|_, s| s.sinkage = 0.15))[1].unwrap(), 16.0));
    // Of a block that is pressed the length counts, of one that is towed the sinkage.
    let mut block = setting.clone();
    (block.bodies[0].diameter, block.bodies[0].thickness) = (None, None);
    let pressed = cells(&block, &moved(|_, s| s.displacement = 0.0));
    assert!(
        pressed[0].is_none() && is_close(pressed[1].unwrap(), 16.0) && is_close(pressed[2].unwrap(), 4.0)
    );
    let towed = cells(&block, &history());
    assert!(is_close(towed[0].unwrap(), 4.8) && towed[1].is_none());
    // Above the ground there is nothing to resolve.
    let above = moved(|_, s| (s.sinkage, s.embedded_volume) = (-0.01, 0.0));
    assert_eq!(cells(&setting, &above)[..2], [None, None]);
    let surrounded = moved(|_, s| s.sinkage = -0.01);
    assert_eq!(cells(&setting, &surrounded)[0], Some(0.0));
}

#[test]
fn leak_and_limits_of_motion_have_their_figures() {
    let setting = facts();
    let leaked = moved(|n, s| s.leaked_volume = if n == 399.0 { 1e-6 } else { 2e-6 });
    let inside = (400.0 * tow(&[]).output.steady_fraction).round();
    let chord = |depth: f64| 2.0 * (depth * (0.2 - depth)).sqrt();
    let layer = chord(0.06) * 0.05 * 0.0125;
    let mean = 1e-6 * (2.0 * (inside - 1.0) + 1.0) / inside;
    assert!((figure(&setting, &leaked, "leak") - 100.0 * mean / layer).abs() < 0.01);
    // A hair below the surface a layer of one cell over the chord at its height.
    let hair = moved(|_, s| (s.sinkage, s.embedded_volume, s.leaked_volume) = (1e-5, 1e-9, 1e-6));
    let layer = chord(0.0125) * 0.05 * 0.0125;
    assert!(is_close(figure(&setting, &hair, "leak"), 100.0 * 1e-6 / layer));
    let speck = moved(|_, s| s.leaked_volume = 0.9e-3 * 0.0125_f64.powi(3));
    assert_eq!(figure(&setting, &speck, "leak"), 0.0);
    for (sinkage, height) in [(-0.017, 8.5), (0.01, 0.0)] {
        let found = figure(&setting, &moved(|_, s| s.sinkage = sinkage), "riding height");
        assert!((found - height).abs() < 1e-9, "{found}");
    }
    let deep = moved(|n, s| s.sinkage = if n == 30.0 { 0.22 } else { 0.06 });
    assert!(is_close(figure(&setting, &deep, "clearance from the floor"), 0.03 / 0.0125));
    for (spin, outside) in [(-2.0, 1.0), (1.0, 0.0), (2.6, 0.3)] {
        let found = figure(&setting, &moved(|_, s| s.spin = spin), "turn ratio of a free wheel");
        assert!((found - outside).abs() < 1e-9, "{spin} rad/s: {found}");
    }
    // Sampled evenly, in eight blocks of the window: 7/8 of the change are between the first and the last.
    let part = tow(&[]).output.steady_fraction;
    let climbs = moved(|n, s| (s.drag, s.sinkage) = (15.0 + 0.03 * n, 0.06 + 1e-4 * n));
    let [drag, sinkage] = ["steady drag", "steady sinkage"].map(|name| figure(&setting, &climbs, name));
    let window = 400.0 * part;
    assert!((drag / (100.0 * 0.03 * window / (15.0 + 0.03 * (400.0 - 0.5 * window))) - 1.0).abs() < 0.02);
    assert!((sinkage / (100.0 * 1e-4 * window / (0.06 + 1e-4 * (400.0 - 0.5 * window))) - 1.0).abs() < 0.02);
}

/// Up and down from sample to sample.
fn saw(n: f64) -> f64 {
    if n % 2.0 == 0.0 { 1.0 } else { -1.0 }
}

#[test]
fn noise_and_trend_are_relative_to_the_force() {
    let (mut held, whole) = (facts(), 15_f64.hypot(40.0));
    (held.bodies[0].heaves, held.bodies[0].heaves_freely, held.bodies[0].turned_about) =
        (false, false, Some(2));
    type Course = fn(f64, &mut BodySample);
    let noisy: [(&str, Course, f64); 5] = [
        ("vertical noise", |n, s| s.vertical = 40.0 + 10.0 * saw(n), 10.0 / 40.0),
        ("vertical noise", |n, s| s.vertical = saw(n), 1.0 / (0.3 * 15.0)),
        ("lateral noise", |n, s| s.lateral = 40.0 + 10.0 * saw(n), 10.0 / 40.0),
        ("torque noise", |n, s| s.moment_z = 6.5 + 1.5 * saw(n), 1.5 / 6.5),
        // A tenth of the force on an arm of half the diameter.
        ("torque noise", |n, s| s.moment_z = 0.1 * saw(n), 0.1 / (0.1 * 0.1 * whole)),
    ];
    for (name, course, exact) in noisy {
        // Fifteen samples lie within a cell: of a saw their mean is a fifteenth, on the other side.
        let found = figure(&held, &moved(course), name) / (100.0 * exact * 16.0 / 15.0);
        assert!((found - 1.0).abs() < 0.02, "{name}: {found}");
    }
    let rising: [(&str, Course); 3] = [
        ("steady vertical force", |n, s| s.vertical = 40.0 + 0.03 * n),
        ("steady lateral force", |n, s| s.lateral = 40.0 + 0.03 * n),
        ("steady torque", |n, s| s.moment_z = 40.0 + 0.03 * n),
    ];
    let window = 400.0 * tow(&[]).output.steady_fraction;
    for (name, course) in rising {
        let found = figure(&held, &moved(course), name) / (3.0 * window / (52.0 - 0.015 * window));
        assert!((found - 1.0).abs() < 0.02, "{name}: {found}");
    }
}

#[test]
fn a_check_says_its_figure_and_its_limits() {
    for (check, line) in [
        (Check::of(&limits::LEAK, Some("disc"), 0.7), "leak (disc): 0.7 % (good to 0.5 %, doubtful to 1 %)"),
        (Check::of(&limits::MOTION, None, 25.5361), "motion: 25.5 cells (good to 0.01 cells)"),
        (Check::of(&limits::MOTION, None, 0.0), "motion: 0 cells (good to 0.01 cells)"),
        (Check::of(&limits::CONTACT, None, 12345.6), "contact: 12346 (good to 1)"),
        (Check::of(&limits::CONTACT, None, -0.012345), "contact: -0.0123 (good to 1)"),
        (Check::unavailable(&limits::CONTACT, None, "why"), "contact: not available (good to 1)"),
    ] {
        assert_eq!(check.line(), line);
    }
    assert_eq!(Check::unavailable(&limits::CONTACT, None, "why").verdict, Verdict::Doubtful);
    let words = [Verdict::Good, Verdict::Doubtful, Verdict::Broken].map(Verdict::name);
    assert_eq!(words, ["good", "doubtful", "broken"]);
    // On a limit a figure is within it, but for rounding.
    for (limit, value, verdict) in [
        (&limits::LEAK, 0.5 * (1.0 + 1e-10), Verdict::Good),
        (&limits::LEAK, 0.5 * (1.0 + 1e-8), Verdict::Doubtful),
        (&limits::BODY_IN_BOX, 4.0 * (1.0 - 1e-10), Verdict::Good),
        (&limits::BODY_IN_BOX, 4.0 * (1.0 - 1e-8), Verdict::Doubtful),
        (&limits::BODY_IN_BOX, -1.0, Verdict::Broken),
        (&limits::NOISE, 1e9, Verdict::Doubtful),
    ] {
        assert_eq!(limit.verdict(value), verdict, "{} {value}", limit.name);
    }
}

#[test]
fn checks_of_variations_replace_earlier_ones_and_unusual_values_are_doubted() {
    let mut trust = grade(&tow(&[]), &history());
    let count = trust.checks.len();
    let of = |value: f64| vec![Check::of(&limits::CONFIDENCE, Some("disc"), value)];
    for (value, verdict) in [(20.0, Verdict::Doubtful), (10.0, Verdict::Good), (f64::NAN, Verdict::Broken)] {
        trust.set_confidence_checks(of(value));
        assert_eq!((trust.checks.len(), trust.verdict), (count + 1, verdict));
        assert_eq!(trust.verdict_without_confidence(), Verdict::Good);
    }
    let odd = Setting { unusual: vec!["Heavy.".into(), "Fast.".into()], courant: 0.95, ..facts() };
    let case = tow(&[]);
    let trust = Trust::grade(&odd, &history(), &Reference::all(&case), case.output.steady_fraction, None);
    let concerns: Vec<_> = trust.concerns().iter().map(|c| (c.name.as_str(), c.verdict)).collect();
    assert_eq!(concerns, [("step size", Verdict::Broken), ("unusual values", Verdict::Doubtful)]);
    let unusual = trust.concerns()[1];
    assert_eq!((unusual.value, unusual.advice.as_str()), (Some(2.0), "Heavy. Fast."));
    assert!(check(&facts(), &history(), "unusual values").is_empty());
    assert_eq!(trust.is_steady("plough"), None);
    let climbs = moved(|n, s| s.drag = 15.0 + 0.1 * n);
    assert_eq!(grade(&case, &climbs).is_steady("disc"), Some(false));
}
