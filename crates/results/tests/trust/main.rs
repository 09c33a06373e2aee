//! The grade of a run: each check reports a problem when, and only when, it should.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod figures;

use case::Case;
use results::history::reference::Reference;
use results::history::{BodySample, BoundarySample, EnergySample, History};
use results::trust::{Check, Setting, Trust, Verdict, documentation};

/// The shipped tow on cells fine enough for its sinkage.
fn tow(overrides: &[&str]) -> Case {
    let path = format!("{}/../../cases/light_disc.toml", env!("CARGO_MANIFEST_DIR"));
    let overrides: Vec<String> = overrides.iter().map(|o| (*o).to_owned()).collect();
    case::load(path.as_ref(), &overrides).unwrap()
}

/// A history without faults: 40 N on a disc that is 60 mm deep, towed 0.3 m.
fn history() -> History {
    let time = |n: i32| f64::from(n) * 0.004;
    let body = (0..400).map(|n| BodySample {
        time: time(n),
        displacement: 0.2 * time(n),
        sinkage: 0.06,
        drag: 15.0,
        vertical: 40.0,
        speed: 0.2,
        rolling_speed: 0.2,
        spin: 1.4,
        embedded_volume: 1e-4,
        ..BodySample::default()
    });
    let energy = (0..400).map(|n| EnergySample {
        time: time(n),
        external: time(n),
        plastic: 0.99 * time(n),
        hourglass: 0.01 * time(n),
        volume_ratio: 1.0,
        ..EnergySample::default()
    });
    let boundaries = (0..400).map(|n| BoundarySample { time: time(n), ..BoundarySample::default() });
    History {
        names: vec!["disc".into()],
        bodies: vec![body.collect()],
        energy: energy.collect(),
        boundaries: boundaries.collect(),
        ..History::default()
    }
}

fn grade(case: &Case, history: &History) -> Trust {
    Trust::grade(&Setting::of(case), history, &Reference::all(case), case.output.steady_fraction, None)
}

/// The verdict on one check of a history in which one thing is wrong; all others must be good.
fn only(name: &str, damage: impl Fn(&mut History)) -> Verdict {
    let mut damaged = history();
    damage(&mut damaged);
    let trust = grade(&tow(&[]), &damaged);
    let concerns: Vec<&str> = trust.concerns().iter().map(|c| c.name.as_str()).collect();
    assert_eq!(concerns, [name]);
    assert!(!trust.concerns()[0].advice.is_empty(), "{name}: no advice");
    trust.verdict
}

#[test]
fn a_run_without_fault_is_good() {
    let trust = grade(&tow(&[]), &history());
    assert_eq!(trust.verdict, Verdict::Good, "{:#?}", trust.concerns());
    assert_eq!(trust.is_steady("disc"), Some(true));
    assert!(trust.checks.iter().all(|c| c.advice.is_empty()));
    assert!(trust.checks.len() > 15, "{} checks", trust.checks.len());
}

#[test]
fn energy_volume_and_leak_are_judged_relatively() {
    for (fraction, verdict) in [(0.03, Verdict::Doubtful), (0.2, Verdict::Broken)] {
        let off = only("energy balance", |h| {
            h.energy.last_mut().unwrap().plastic = 0.99 * 1.596 * (1.0 - fraction)
        });
        assert_eq!(off, verdict);
    }
    let hourglass = |fraction: f64| {
        only("hourglass energy", |h| {
            let e = h.energy.last_mut().unwrap();
            (e.hourglass, e.plastic) = (fraction * e.external, (1.0 - fraction) * e.external);
        })
    };
    assert_eq!([hourglass(0.05), hourglass(0.2)], [Verdict::Doubtful, Verdict::Broken]);
    let volume = |ratio: f64| only("soil volume", |h| h.energy.last_mut().unwrap().volume_ratio = ratio);
    assert_eq!([volume(0.99), volume(1.03)], [Verdict::Doubtful, Verdict::Broken]);
    // At any time, not at the end alone.
    let overdense = |portion: f64| only("overdense soil", |h| h.energy[1].overdense = portion);
    assert_eq!([overdense(0.01), overdense(0.06)], [Verdict::Doubtful, Verdict::Broken]);
    let leak =
        |fraction: f64| only("leak", |h| h.bodies[0].last_mut().unwrap().leaked_volume = fraction * 1e-4);
    assert_eq!([leak(0.007), leak(0.05)], [Verdict::Doubtful, Verdict::Broken]);
    // A third of the README's disc leaked in mid-run, and little at the end: graded good.
    let before_the_end = only("leak", |h| {
        h.bodies[0].iter_mut().rev().skip(1).for_each(|sample| sample.leaked_volume = 2e-6);
    });
    assert_eq!(before_the_end, Verdict::Broken);
}

/// The checks of this name of a history with these facts.
fn check(setting: &Setting, history: &History, name: &str) -> Vec<Check> {
    let case = tow(&[]);
    let trust = Trust::grade(setting, history, &Reference::all(&case), case.output.steady_fraction, None);
    trust.checks.into_iter().filter(|check| check.name == name).collect()
}

/// A tray of sand above the ground leaked out of a volume of nothing: "not available", and broken.
#[test]
fn leak_is_relative_to_what_soil_surrounds() {
    let mut setting = Setting::of(&tow(&[]));
    let disc = std::f64::consts::PI * 0.01 * setting.bodies[0].extent[1].unwrap();
    assert!((setting.bodies[0].volume / disc - 1.0).abs() < 0.02, "{}", setting.bodies[0].volume);
    setting.bodies[0].volume = 1e-3;
    let leak = |setting: &Setting, embedded: f64, leaked: f64| {
        let mut history = history();
        for sample in &mut history.bodies[0] {
            (sample.embedded_volume, sample.leaked_volume) = (embedded, leaked);
            sample.sinkage = if embedded > 0.0 { 1e-5 } else { -0.05 };
        }
        check(setting, &history, "leak").pop().unwrap()
    };
    let above = leak(&setting, 0.0, 7e-6);
    assert!((above.value.unwrap() - 0.7).abs() < 1e-9 && above.verdict == Verdict::Doubtful, "{above:?}");
    assert_eq!(leak(&setting, 0.0, 4e-6).verdict, Verdict::Good);
    assert_eq!(leak(&setting, 0.0, 2e-4).verdict, Verdict::Broken);
    // A body that has sunk by a hair: a layer of one cell over its base counts.
    let [length, width] = [0.2, setting.bodies[0].extent[1].unwrap()];
    setting.bodies[0].diameter = None;
    let layer = length * width * setting.cell[2];
    let hair = leak(&setting, 1e-9, 0.004 * layer);
    assert!((hair.value.unwrap() - 0.4).abs() < 1e-6 && hair.verdict == Verdict::Good, "{hair:?}");
    assert_eq!(leak(&setting, 1e-9, 0.02 * layer).verdict, Verdict::Broken);
}

#[test]
fn compression_that_the_pressure_demands_is_no_lost_volume() {
    let compressed = |compression: f64| {
        let mut history = history();
        let end = history.energy.last_mut().unwrap();
        (end.volume_ratio, end.compression) = (0.97, compression);
        check(&Setting::of(&tow(&[])), &history, "soil volume")[0].clone()
    };
    assert_eq!(compressed(0.0).verdict, Verdict::Broken);
    assert_eq!(compressed(0.03).verdict, Verdict::Good);
    assert!((compressed(0.02).value.unwrap() - 1.0).abs() < 1e-9, "{:?}", compressed(0.02));
    // What there was from the start is no change.
    let mut history = history();
    history.energy.iter_mut().for_each(|sample| sample.compression = 0.05);
    assert_eq!(check(&Setting::of(&tow(&[])), &history, "soil volume")[0].value, Some(0.0));
}

#[test]
fn voids_under_soil_are_reported() {
    assert_eq!(only("void under soil", |h| h.energy.last_mut().unwrap().void = 0.2), Verdict::Doubtful);
}

/// A plate that is pulled out of the soil, with 0 N throughout, was good.
#[test]
fn a_body_without_soil_and_a_run_without_motion_are_not_good() {
    let silent = |from: usize| {
        let mut damaged = history();
        for sample in damaged.bodies[0].iter_mut().skip(from) {
            (sample.drag, sample.vertical) = (0.0, 1e-9);
        }
        let trust = grade(&tow(&[]), &damaged);
        let concerns: Vec<&str> = trust.concerns().iter().map(|c| c.name.as_str()).collect();
        assert_eq!(concerns, ["contact"]);
        (trust.verdict, trust.concerns()[0].advice.clone())
    };
    assert!(silent(0).1.contains("has not met the soil"), "{:?}", silent(0));
    assert!(silent(200).1.contains("has left the soil"), "{:?}", silent(200));
    assert_eq!(silent(0).0, Verdict::Doubtful);
    let stands = |h: &mut History| {
        h.bodies[0].iter_mut().for_each(|s| s.displacement *= 1e-5);
    };
    assert_eq!(only("motion", stands), Verdict::Doubtful);
}

/// A spacer between discs that stays above the sand was doubtful.
#[test]
fn a_body_that_a_joint_carries_may_hang_clear_of_the_soil() {
    let (case, mut history) = (tow(&[]), history());
    let mut setting = Setting::of(&case);
    let (mut spacer, mut samples) = (setting.bodies[0].clone(), history.bodies[0].clone());
    spacer.name = "spacer".to_owned();
    samples.iter_mut().for_each(|s| (s.drag, s.vertical, s.sinkage) = (0.0, 0.0, -0.02));
    setting.bodies.push(spacer);
    history.bodies.push(samples);
    let references = [Reference::all(&case), Reference::all(&case)].concat();
    let mut concerns = |gears: [usize; 2], disc_is_clear: bool| {
        setting.bodies.iter_mut().zip(gears).for_each(|(body, gear)| body.gear = Some(gear));
        let mut history = history.clone();
        if disc_is_clear {
            history.bodies[0] = history.bodies[1].clone();
        }
        let trust = Trust::grade(&setting, &history, &references, 0.3, None);
        trust.concerns().iter().filter(|c| c.name == "contact").count()
    };
    assert_eq!([concerns([0, 1], false), concerns([0, 0], false), concerns([0, 0], true)], [1, 0, 2]);
}

/// A scoop that is lifted out with its load was said to have no cells over its sinkage.
#[test]
fn cells_over_sinkage_are_not_asked_for_of_a_body_that_is_held_above_the_ground() {
    let mut history = history();
    for sample in history.bodies[0].iter_mut().skip(200) {
        (sample.sinkage, sample.embedded_volume) = (-0.05, 0.0);
    }
    let asked = |case: &Case| check(&Setting::of(case), &history, "cells over sinkage").len();
    assert_eq!([asked(&tow(&["body.disc.heave=fixed"])), asked(&tow(&[]))], [0, 1]);
}

/// "166 552 045 394 %", "847 %": quotients of nearly nothing.
#[test]
fn figures_of_nearly_nothing_have_a_floor() {
    let setting = Setting::of(&tow(&[]));
    // A driven wheel whose thrust is its resistance: a pull of nothing, and noise of some newtons.
    let mut rover = history();
    for (n, sample) in rover.bodies[0].iter_mut().enumerate() {
        sample.drag = -0.01 + if n % 2 == 0 { 0.3 } else { -0.3 };
        sample.axle_torque = -1.0;
    }
    let noise = |history: &History| check(&setting, history, "drag noise")[0].value.unwrap();
    assert!((2.2..3.2).contains(&noise(&rover)), "{}: 0.3 N over 1 N m/0.1 m", noise(&rover));
    rover.bodies[0].iter_mut().for_each(|s| s.axle_torque = 0.0);
    assert!((5.5..8.0).contains(&noise(&rover)), "{}: 0.3 N over a tenth of 40 N", noise(&rover));
    // Nothing acts: the stress of the soil itself is the scale, and the lid has no body to be compared with.
    let mut nothing = history();
    nothing.bodies[0].iter_mut().for_each(|s| (s.drag, s.vertical) = (1e-9, 1e-9));
    nothing.boundaries.iter_mut().for_each(|b| {
        (b.stress_rise, b.lid_area, b.lid_force) = (0.02 * setting.floor_pressure, 1e-4, 1.0);
    });
    let value = |name: &str| check(&setting, &nothing, name)[0].value.unwrap();
    assert!((value("stress at the boundaries") - 20.0).abs() < 1e-6);
    assert_eq!(value("soil at the lid"), 1.0);
    assert!(value("drag noise") < 1.0 && value("steady drag") < 1.0);
    assert!(check(&setting, &nothing, "inertia (Froude number)").is_empty());
    // Energies of a run in which nothing happens.
    let last = nothing.energy.last_mut().unwrap();
    *last = EnergySample { external: 1e-20, hourglass: 1e-15, volume_ratio: 1.0, ..*last };
    (last.plastic, last.kinetic) = (0.0, 0.0);
    assert!(check(&setting, &nothing, "hourglass energy")[0].value.unwrap() < 1e-3);
}

/// In single precision the elastic energy of the soil at rest changes by its last digits, which is no error
/// of the balance.
#[test]
fn rounding_of_the_elastic_energy_is_not_unexplained() {
    let closure = |precision: &str, part: f64| {
        let setting = Setting::of(&tow(&[&format!("numerics.precision={precision}")]));
        let rounding = 16.0 * f64::from(f32::EPSILON) * setting.elastic_at_rest;
        let sample = EnergySample { external: 1e-9, elastic: -part * rounding, ..EnergySample::default() };
        setting.closure(&sample)
    };
    assert_eq!(closure("single", 0.5), 0.0);
    assert!(closure("single", 50.0) > 0.01, "{}", closure("single", 50.0));
    assert!(closure("double", 0.5) > 0.0);
}

#[test]
fn what_is_not_a_number_is_broken() {
    let mut damaged = history();
    damaged.energy.last_mut().unwrap().plastic = f64::NAN;
    assert_eq!(grade(&tow(&[]), &damaged).verdict, Verdict::Broken);
    let nothing = f64::NAN;
    *damaged.energy.last_mut().unwrap() = EnergySample {
        external: nothing,
        plastic: nothing,
        kinetic: nothing,
        volume_ratio: 1.0,
        ..EnergySample::default()
    };
    assert_eq!(grade(&tow(&[]), &damaged).verdict, Verdict::Broken);
}

#[test]
fn soil_at_lid_and_walls_is_reported() {
    let lid = |force: f64| {
        only("soil at the lid", |h| {
            h.boundaries[200] = BoundarySample { lid_force: force, lid_area: 1e-3, ..h.boundaries[200] }
        })
    };
    assert_eq!([lid(0.4), lid(10.0)], [Verdict::Doubtful, Verdict::Broken]);
    assert_eq!(only("soil at bare walls", |h| h.boundaries[100].wall_area = 1e-4), Verdict::Doubtful);
    let pressed = |h: &mut History| h.boundaries.iter_mut().for_each(|b| b.stress_rise = 20e3);
    assert_eq!(only("stress at the boundaries", pressed), Verdict::Doubtful);
}

#[test]
fn a_drag_that_still_changes_is_not_steady() {
    let rises = |h: &mut History| h.bodies[0].iter_mut().for_each(|s| s.drag = 15.0 * (1.0 + s.displacement));
    let mut rising = history();
    rises(&mut rising);
    assert_eq!(grade(&tow(&[]), &rising).is_steady("disc"), Some(true), "7 % over the window");
    let climbs = |h: &mut History| h.bodies[0].iter_mut().for_each(|s| s.drag = 15.0 + 60.0 * s.displacement);
    assert_eq!(only("steady drag", climbs), Verdict::Doubtful);
    let sinks = |h: &mut History| {
        h.bodies[0].iter_mut().for_each(|s| s.sinkage = 0.06 * (1.0 + 3.0 * s.displacement))
    };
    assert_eq!(only("steady sinkage", sinks), Verdict::Doubtful);
}

#[test]
fn motion_that_is_impossible_for_a_free_body_is_reported() {
    let backwards = |h: &mut History| h.bodies[0].iter_mut().for_each(|s| s.spin = -2.0);
    assert_eq!(only("turn ratio of a free wheel", backwards), Verdict::Broken);
    let mut lifted = history();
    lifted.bodies[0].iter_mut().for_each(|s| s.sinkage = -0.017);
    let trust = grade(&tow(&[]), &lifted);
    assert!(trust.concerns().iter().any(|c| c.name == "riding height"), "{:#?}", trust.concerns());
    assert_eq!(only("clearance from the floor", |h| h.bodies[0][30].sinkage = 0.22), Verdict::Doubtful);
}

#[test]
fn noise_and_step_size_are_reported() {
    let noisy = |h: &mut History| {
        h.bodies[0].iter_mut().enumerate().for_each(|(n, s)| s.drag = if n % 2 == 0 { 12.0 } else { 18.0 });
    };
    assert_eq!(only("drag noise", noisy), Verdict::Doubtful);
    for (courant, verdict) in [("0.7", Verdict::Doubtful), ("0.95", Verdict::Broken)] {
        let case = tow(&[&format!("numerics.courant={courant}")]);
        assert_eq!(grade(&case, &history()).verdict, verdict);
    }
}

/// Every force that a report shows is graded like the drag.
#[test]
fn vertical_and_lateral_forces_and_torques_are_graded() {
    let free = Setting::of(&tow(&[]));
    let mut held = free.clone();
    (held.bodies[0].heaves, held.bodies[0].heaves_freely) = (false, false);
    let pressed = |setting: &Setting| {
        let mut setting = setting.clone();
        setting.bodies[0].heaves = true;
        setting
    };
    let history_of = |change: fn(usize, &mut BodySample)| {
        let mut history = history();
        history.bodies[0].iter_mut().enumerate().for_each(|(n, sample)| change(n, sample));
        history
    };
    let verdict = |setting: &Setting, history: &History, name: &str| {
        check(setting, history, name).first().map(|check| check.verdict)
    };
    let noisy = history_of(|n, s| s.vertical = if n % 2 == 0 { 30.0 } else { 50.0 });
    assert_eq!(verdict(&held, &noisy, "vertical noise"), Some(Verdict::Doubtful));
    assert_eq!(verdict(&pressed(&held), &noisy, "vertical noise"), Some(Verdict::Doubtful));
    assert_eq!(verdict(&held, &history(), "vertical noise"), Some(Verdict::Good));
    assert_eq!(verdict(&free, &noisy, "vertical noise"), None, "a free body bears its weight");
    let rising = history_of(|n, s| s.vertical = 20.0 + 0.1 * n as f64);
    assert_eq!(verdict(&held, &rising, "steady vertical force"), Some(Verdict::Doubtful));
    assert_eq!(verdict(&pressed(&held), &rising, "steady vertical force"), None, "it grows with the depth");
    let cells = |setting: &Setting| verdict(setting, &history(), "cells for the vertical force");
    assert_eq!([cells(&held), cells(&free)], [Some(Verdict::Doubtful), None], "60 mm on cells of 12.5 mm");
    let small = history_of(|n, s| s.vertical = if n % 2 == 0 { 0.2 } else { -0.2 });
    assert_eq!(verdict(&held, &small, "vertical noise"), Some(Verdict::Good), "of a drag of 15 N");
    let sideways = history_of(|n, s| s.lateral = if n % 2 == 0 { 30.0 } else { 50.0 });
    assert_eq!(verdict(&free, &sideways, "lateral noise"), Some(Verdict::Doubtful));
    assert_eq!(verdict(&free, &history(), "lateral noise"), None);
    let mut turned = free.clone();
    turned.bodies[0].turned_about = Some(2);
    let torque = history_of(|n, s| s.moment_z = if n % 2 == 0 { 5.0 } else { 8.0 });
    assert_eq!(verdict(&turned, &torque, "torque noise"), Some(Verdict::Doubtful));
    assert_eq!(verdict(&turned, &torque, "steady torque"), Some(Verdict::Good));
    assert_eq!(verdict(&free, &torque, "torque noise"), None);
    let turns = Setting::of(&tow(&["body.disc.spin={ speed = '3 rad/s' }"]));
    assert_eq!(turns.bodies[0].turned_about, Some(1));
}

#[test]
fn soil_that_does_not_drain_is_reported() {
    let number = |permeability: &str, accepted: bool| {
        let mut case = tow(&[
            "water.level=1 m",
            "soil.unit_weight=9 kN/m^3",
            "water.volume_strain=0.05",
            &format!("water.permeability={permeability}"),
            "water.accept_drained=true",
        ]);
        case.water.as_mut().unwrap().accept_drained = accepted;
        let trust = grade(&case, &history());
        let check = trust.checks.iter().find(|check| check.name == "drainage number").unwrap().clone();
        (check.value.unwrap(), check.verdict)
    };
    // N_s = (9.81/9) 0.2 m/s × 0.05/k
    let (value, verdict) = number("30 mm/s", false);
    assert!((value - 9.81 / 9.0 * 0.2 * 0.05 / 0.03).abs() < 1e-9, "{value}");
    assert_eq!(verdict, Verdict::Good);
    assert_eq!(number("10 mm/s", false).1, Verdict::Doubtful);
    assert_eq!([number("1 mm/s", false).1, number("1 mm/s", true).1], [Verdict::Broken, Verdict::Doubtful]);
    assert!(grade(&tow(&[]), &history()).checks.iter().all(|check| check.name != "drainage number"));
}

#[test]
fn a_run_that_was_stopped_is_broken_and_says_why() {
    let case = tow(&[]);
    let why = "12 % of the energy is unexplained";
    let trust = Trust::grade(
        &Setting::of(&case),
        &history(),
        &Reference::all(&case),
        case.output.steady_fraction,
        Some(why),
    );
    assert_eq!(trust.verdict, Verdict::Broken);
    assert!(trust.concerns()[0].line().contains("completed") && trust.concerns()[0].advice.contains(why));
}

/// Without a tow nothing else asks how many samples the steady means rest on.
#[test]
fn too_few_samples_are_doubted_of_a_pressed_body_as_of_a_towed_one() {
    let few = |displacement: f64| {
        let mut all = history();
        all.bodies[0].iter_mut().for_each(|sample| sample.displacement *= displacement);
        all.bodies[0].retain(|sample| (250.0 * sample.time).round() % 40.0 == 0.0);
        check(&Setting::of(&tow(&[])), &all, "samples")
    };
    for displacement in [0.0, 1.0] {
        let found = few(displacement);
        assert_eq!(found.len(), 1, "{displacement}");
        assert_eq!(found[0].verdict, Verdict::Doubtful);
        assert!(found[0].advice.contains("output.history_interval"));
    }
    assert_eq!(check(&Setting::of(&tow(&[])), &history(), "samples"), []);
}

/// The table of limits in the documentation is that of the program; with `COULTER_UPDATE=1` it is written
/// instead.
#[test]
fn the_documented_limits_are_up_to_date() {
    const BEGIN: &str = "<!-- limits:begin (written by a test with COULTER_UPDATE=1) -->\n";
    const END: &str = "<!-- limits:end -->";
    let path = format!("{}/../../docs/reference/reliability.md", env!("CARGO_MANIFEST_DIR"));
    let shipped = std::fs::read_to_string(&path).unwrap();
    let (before, rest) = shipped.split_once(BEGIN).expect("the mark is gone");
    let (_, after) = rest.split_once(END).expect("the mark is gone");
    let expected = format!("{before}{BEGIN}{}{END}{after}", documentation::table());
    if std::env::var_os("COULTER_UPDATE").is_some() {
        std::fs::write(&path, &expected).unwrap();
    }
    let shipped = std::fs::read_to_string(&path).unwrap();
    assert!(shipped == expected, "run the tests with COULTER_UPDATE=1");
}
