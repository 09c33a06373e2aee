//! The forecast: all models for a disc, their limits and their uncertainty.

use analytic::disc::{
    Assembly, Disc, Drive, Equilibrium, Mechanism, Model, Passive, Setting, assembly_forces, disc_forces,
    equilibrium,
};
use analytic::earth_pressure::{PressureTable, TableRange};
use analytic::forecast::{Candidate, Parameter, Strength, curve, predict};
use analytic::uncertainty::{Distribution, propagate, propagate_towing, sweep_table};
use analytic::wheel::TERRAINS;
use analytic::{Load, Soil, Towing, forecast};
use std::time::Instant;

const DISC: Disc = Disc { diameter: 0.2, thickness: 0.05 };

fn towing(degrees: f64, load: Load, drive: Drive) -> Towing {
    let angle = degrees.to_radians();
    let soil = Soil {
        friction_angle: angle,
        dilation_angle: angle,
        cohesion: 0.0,
        unit_weight: 16e3,
        body_friction: 0.3,
        adhesion_factor: 1.0,
        strength_gradient: 0.0,
    };
    Towing::new(soil, DISC, load, drive)
}

#[test]
fn a_free_disc_under_weight_is_forecast_by_every_model_it_suits() {
    let mut case = towing(35.0, Load::Weight(50.0), Drive::Free);
    case.terrain = Some(TERRAINS[0].soil);
    case.cone_index = Some(300e3);
    case.elastic_modulus = Some(10e6);
    let start = Instant::now();
    let found = forecast(&case).unwrap();
    println!("{:.1} ms", start.elapsed().as_secs_f64() * 1e3);
    for model in &found.models {
        println!("{:24} {:5} {:?} {}", model.name, model.applicable, model.prediction, model.note);
        assert!(model.applicable || !model.note.is_empty());
    }
    println!("{:?}\n{:?}\n{:?}\n{}", found.groups, found.scatter, found.side_faces, found.recommendation);
    let bearing = found.models[1].prediction.unwrap();
    assert!((bearing.sinkage.unwrap() / 0.2 - 0.050).abs() < 6e-4 && (bearing.drag - 10.8).abs() < 0.06);
    assert_eq!(found.models.iter().filter(|model| model.applicable).count(), 8);
    for found in found.models.iter().filter_map(|model| model.prediction) {
        assert!((found.vertical / 50.0 - 1.0).abs() < 1e-4, "{found:?}");
    }
    assert!(found.models_other_strength.is_empty());
    assert!((found.groups.weight.unwrap() - 1.5625).abs() < 1e-12);
    assert!(found.models[11].note.contains("overhangs"));
}

#[test]
fn non_associated_soil_is_shown_at_both_angles() {
    let mut case = towing(35.0, Load::Sinkage(0.04), Drive::Free);
    case.soil.dilation_angle = 0.0;
    let found = forecast(&case).unwrap();
    assert!((found.operative_friction_angle.to_degrees() - 29.8).abs() < 0.06);
    assert_eq!(found.strength, Strength::Full);
    let (weak, strong) =
        (found.models_other_strength[1].prediction.unwrap(), found.models[1].prediction.unwrap());
    assert!((weak.vertical - 70.7).abs() < 0.1 && (strong.vertical - 154.6).abs() < 0.1);
    assert!(found.recommendation.contains("Davis"));
}

#[test]
fn a_locked_disc_that_is_too_heavy_has_no_equilibrium() {
    let found = forecast(&towing(30.0, Load::Weight(200.0), Drive::Locked)).unwrap();
    println!("{:#?}", found.models.iter().map(|m| (m.name, m.applicable, &m.note)).collect::<Vec<_>>());
    assert!(
        found.models[0].note.contains("no equilibrium") && found.recommendation.contains("no equilibrium")
    );
    assert!(forecast(&towing(60.0, Load::Weight(200.0), Drive::Free)).is_err());
    assert!(forecast(&towing(35.0, Load::Weight(f64::NAN), Drive::Free)).is_err());
}

#[test]
fn thin_discs_fail_sideways_and_thick_ones_forwards() {
    let case = towing(35.0, Load::Sinkage(0.04), Drive::Free);
    // F̄_V of BC and PW at Z = 0.2; they cross at t/d ≈ 0.35.
    let rows =
        [(0.05, 3.22, 25.5), (0.1, 3.36, 13.6), (0.25, 4.83, 6.44), (0.5, 7.19, 4.05), (1.0, 6.30, 2.86)];
    for (thickness, bearing, wedge) in rows {
        let disc = *case.with(Parameter::Thickness, 0.2 * thickness).body.disc().unwrap();
        let setting = Setting::new(case.soil, disc, Drive::Free);
        let scale = disc.force_scale(16e3);
        let lift = |model| disc_forces(model, &setting, 0.04).unwrap().vertical / scale;
        let (bc, pw) = (lift(Model::Bearing), lift(Model::Wedge));
        println!("t/d={thickness}: BC {bc:.3} for {bearing}, PW {pw:.3} for {wedge}");
        assert!((bc / bearing - 1.0).abs() < 3e-3 && (pw / wedge - 1.0).abs() < 5e-3);
        let governing = disc_forces(Model::Governing, &setting, 0.04).unwrap();
        assert_eq!(
            governing.mechanism,
            if thickness < 0.34 { Mechanism::Sideways } else { Mechanism::Forwards }
        );
    }
}

/// Where the vertical forces of BC and PW cross, their drags differ by half; the prediction must be
/// continuous there.
#[test]
fn sinkage_and_drag_are_continuous_where_the_mechanisms_cross() {
    let cases = [
        (29.84, Drive::Free, 160),
        (35.0, Drive::Free, 160),
        (40.0, Drive::Free, 160),
        (35.0, Drive::Locked, 24),
    ];
    for (degrees, drive, count) in cases {
        let case = towing(degrees, Load::Weight(1.0), drive);
        let phi = degrees.to_radians();
        let table = PressureTable::new(TableRange {
            friction_angle: (phi, phi),
            wall_friction_ratio: (0.0, 0.0),
            surface: (0.0, 1.36),
            backfill: 0.0,
        })
        .unwrap();
        for thickness in [0.02, 0.05, 0.08, 0.15] {
            let mut setting = Setting::new(case.soil, Disc { diameter: 0.2, thickness }, drive);
            setting.passive = Passive::Table(&table);
            let rest = |weight: f64| match equilibrium(Model::Governing, &setting, weight).unwrap() {
                Equilibrium::At { sinkage, forces } => [sinkage, forces.drag],
                Equilibrium::None { .. } => [f64::NAN; 2],
            };
            let step = 1.02_f64;
            let mut last = rest(10.0);
            for n in 1..=count {
                let here = rest(10.0 * step.powi(n));
                if here[0].is_nan() {
                    break;
                }
                // Two per cent more weight: a smooth answer moves by a few per cent.
                for (now, before) in here.iter().zip(last) {
                    let change = now / before;
                    assert!(
                        (1.0..1.08).contains(&change),
                        "φ = {degrees}°, t = {thickness} m: {last:?} to {here:?}"
                    );
                }
                last = here;
            }
        }
    }
}

/// The forces of the governing mechanism never exceed those of BC or PW alone, and reach both limits.
#[test]
fn the_governing_mechanism_is_a_lower_envelope() {
    for thickness in [1e-4, 0.05, 0.07, 100.0] {
        let case = towing(35.0, Load::Sinkage(0.04), Drive::Free);
        let setting = Setting::new(case.soil, Disc { diameter: 0.2, thickness }, Drive::Free);
        let of = |model| disc_forces(model, &setting, 0.04).unwrap();
        let (bearing, wedge, governing) = (of(Model::Bearing), of(Model::Wedge), of(Model::Governing));
        assert!(governing.vertical <= bearing.vertical.min(wedge.vertical) * (1.0 + 1e-12));
        assert!(governing.normal <= bearing.normal.min(wedge.normal) * (1.0 + 1e-12));
        let limit = if thickness < 1e-3 {
            Some(bearing)
        } else if thickness > 1.0 {
            Some(wedge)
        } else {
            None
        };
        if let Some(limit) = limit {
            assert!((governing.vertical / limit.vertical - 1.0).abs() < 1e-3);
            assert!((governing.drag / limit.drag - 1.0).abs() < 1e-3);
        }
    }
}

#[test]
fn braked_and_driven_discs_lie_between_free_and_locked() {
    let case = towing(35.0, Load::Sinkage(0.03), Drive::Free);
    let at = |drive| disc_forces(Model::Bearing, &Setting::new(case.soil, DISC, drive), 0.03).unwrap();
    let (free, locked) = (at(Drive::Free), at(Drive::Locked));
    let braked = at(Drive::Braked(0.5 * locked.rim_torque));
    assert!((braked.rim_torque / locked.rim_torque - 0.5).abs() < 1e-9);
    let ratio = |f: &analytic::disc::DiscForces| f.drag / f.vertical;
    assert!(ratio(&free) < ratio(&braked) && ratio(&braked) < ratio(&locked));
    assert!(free.slip > braked.slip && braked.slip > locked.slip && locked.slip == -1.0);
    assert_eq!(at(Drive::Braked(1e6)).slip, -1.0);
    let driven = at(Drive::Driven(0.5));
    assert!(driven.drag < free.drag && (driven.rim_torque + 0.5).abs() < 1e-9 && driven.slip > free.slip);
    // The slip of the free disc, prescribed, is the free disc again.
    let rolled = at(Drive::Slip(free.slip));
    assert!((rolled.drag / free.drag - 1.0).abs() < 1e-9);
    assert!((at(Drive::Slip(-1.0)).drag / locked.drag - 1.0).abs() < 1e-12);
}

#[test]
fn assemblies_join_their_two_limits() {
    let case = towing(35.0, Load::Sinkage(0.03), Drive::Free);
    let setting = Setting::new(case.soil, DISC, Drive::Free);
    let group = |count, spacing| {
        assembly_forces(Model::Governing, &setting, &Assembly { count, spacing }, 0.03).unwrap()
    };
    let alone = disc_forces(Model::Governing, &setting, 0.03).unwrap();
    let wide = Setting { disc: Disc { thickness: 0.15, ..DISC }, ..setting };
    let joined = disc_forces(Model::Governing, &wide, 0.03).unwrap();
    assert!((group(3, 0.05).drag / joined.drag - 1.0).abs() < 1e-12);
    assert!((group(3, 2.0).drag / (3.0 * alone.drag) - 1.0).abs() < 1e-12);
    assert!((group(1, 0.05).drag / alone.drag - 1.0).abs() < 1e-12);
    let middle = group(3, 0.2).drag;
    assert!((middle - joined.drag) * (middle - 3.0 * alone.drag) < 0.0);
    assert!(
        assembly_forces(Model::Governing, &setting, &Assembly { count: 2, spacing: 0.01 }, 0.03).is_err()
    );
    let mut case = towing(35.0, Load::Weight(150.0), Drive::Free);
    case.assembly = Some(Assembly { count: 3, spacing: 0.2 });
    let found = forecast(&case).unwrap();
    assert!((found.models[0].prediction.unwrap().vertical / 150.0 - 1.0).abs() < 1e-9);
}

#[test]
fn the_measured_wheel_is_forecast_as_tabulated() {
    let wheel = Disc { diameter: 0.116, thickness: 0.05 };
    for (phi, z, drag) in [(30., 0.172, 9.7), (32., 0.133, 8.5), (33., 0.116, 8.0), (34., 0.101, 7.4)] {
        let mut case = towing(phi, Load::Weight(24.0), Drive::Free);
        (case.body, case.soil.unit_weight) = (wheel.into(), 13.03e3);
        let found = equilibrium(Model::Bearing, &Setting::new(case.soil, wheel, case.drive), 24.0).unwrap();
        let Equilibrium::At { sinkage, forces } = found else { panic!("no equilibrium") };
        assert!(
            (sinkage / 0.116 - z).abs() < 1e-3 && (forces.drag - drag).abs() < 0.06,
            "{sinkage} {}",
            forces.drag
        );
    }
}

#[test]
fn curves_rise_with_sinkage_and_give_reasons_for_gaps() {
    let case = towing(35.0, Load::Weight(50.0), Drive::Free);
    let depths: Vec<f64> = (1..=20).map(|n| 0.004 * f64::from(n)).collect();
    let found =
        curve(&case, Parameter::Sinkage, &depths, &[Candidate::Governing, Candidate::SpatialResistive])
            .unwrap();
    for pair in found.windows(2) {
        for (low, high) in pair[0].models.iter().zip(&pair[1].models) {
            assert!(low.prediction.unwrap().vertical < high.prediction.unwrap().vertical);
        }
    }
    let angles: Vec<f64> = [30.0_f64, 38.0, 42.0, 49.0].map(f64::to_radians).to_vec();
    let found = curve(&case, Parameter::FrictionAngle, &angles, &[]).unwrap();
    let spatial = |n: usize| &found[n].models[5];
    assert!(spatial(0).applicable && !spatial(3).applicable && spatial(3).note.contains("3D-RFT"));
    let drag = |n: usize| found[n].models[0].prediction.unwrap().drag;
    assert!(drag(0) > drag(1) && drag(1) > drag(2) && drag(2) > drag(3));
}

#[test]
fn ishigamis_indices_are_found() {
    let pi = std::f64::consts::PI;
    let input = Distribution::Uniform { low: -pi, high: pi };
    let model = |x: &[f64]| Some([x[0].sin() + 7.0 * x[1].sin().powi(2) + 0.1 * x[2].powi(4) * x[0].sin()]);
    let [found] = propagate(&[input; 3], 100_000, 3, model).unwrap();
    println!("{found:?}");
    assert!((found.mean - 3.5).abs() < 0.01);
    for (got, want) in found.first_order.iter().zip([0.3139, 0.4424, 0.0]) {
        assert!((got - want).abs() < 0.01);
    }
    for (got, want) in found.total.iter().zip([0.5576, 0.4424, 0.2437]) {
        assert!((got - want).abs() < 0.01);
    }
}

#[test]
fn the_friction_angle_dominates_the_uncertainty() {
    let mut case = towing(35.0, Load::Sinkage(0.03), Drive::Free);
    case.soil.dilation_angle = 5_f64.to_radians();
    let inputs = [
        (
            Parameter::FrictionAngle,
            Distribution::Normal { mean: 35_f64.to_radians(), deviation: 2_f64.to_radians() },
        ),
        (Parameter::UnitWeight, Distribution::Normal { mean: 16e3, deviation: 500.0 }),
        (Parameter::Thickness, Distribution::Uniform { low: 0.045, high: 0.055 }),
    ];
    let table = sweep_table(&case, &inputs);
    assert!(table.is_some());
    let governing = |case: &Towing, count| {
        propagate_towing(case, &inputs, Candidate::Governing, count, 1, table.as_ref()).unwrap()
    };
    let found = governing(&case, 50_000).drag;
    assert!(found.first_order[0] > 0.7 && found.first_order.iter().sum::<f64>() < 1.02);
    assert!(found.quantiles[0] < found.quantiles[1] && found.quantiles[1] < found.quantiles[2]);
    assert_eq!(found.failed, 0.0);
    assert_eq!(found, governing(&case, 50_000).drag);
}

/// Every model with a prediction has a distribution, which the table does not change noticeably.
#[test]
fn every_model_has_its_uncertainty() {
    let mut case = towing(35.0, Load::Weight(50.0), Drive::Free);
    case.terrain = Some(TERRAINS[0].soil);
    case.cone_index = Some(300e3);
    let inputs = [
        (
            Parameter::FrictionAngle,
            Distribution::Normal { mean: 35_f64.to_radians(), deviation: 2_f64.to_radians() },
        ),
        (Parameter::Weight, Distribution::Normal { mean: 50.0, deviation: 4.0 }),
    ];
    let table = sweep_table(&case, &inputs);
    for model in Candidate::ALL {
        let Ok(answer) = predict(model, &case, None) else { continue };
        let start = Instant::now();
        let found = propagate_towing(&case, &inputs, model, 400, 1, table.as_ref()).unwrap();
        println!("{:24} {:.2} µs", model.name(), start.elapsed().as_secs_f64() * 1e6 / 400.0);
        let [low, middle, high] = found.drag.quantiles;
        assert!(
            low < middle && middle < high && low < answer.drag && answer.drag < high,
            "{model:?}: {found:?}"
        );
        assert_eq!(found.sinkage.is_some(), answer.sinkage.is_some());
        if matches!(model, Candidate::Governing | Candidate::Wedge) {
            let solved = propagate_towing(&case, &inputs, model, 64, 1, None).unwrap();
            let looked_up = propagate_towing(&case, &inputs, model, 64, 1, table.as_ref()).unwrap();
            let (one, other) = (solved.drag.quantiles[1], looked_up.drag.quantiles[1]);
            assert!((one / other - 1.0).abs() < 1e-4, "{model:?}: {one} {other}");
        }
    }
}

/// The forces on a disc at a held sinkage, `[drag, vertical]` [N].
fn held(model: Candidate, degrees: f64, sinkage: f64, drive: Drive) -> [f64; 2] {
    let phi = degrees.to_radians();
    let soil = Soil {
        friction_angle: phi,
        dilation_angle: phi,
        cohesion: 0.0,
        unit_weight: 13_030.0,
        body_friction: 0.4,
        adhesion_factor: 1.0,
        strength_gradient: 0.0,
    };
    let disc = Disc { diameter: 0.116, thickness: 0.05 };
    let case = Towing::new(soil, disc, Load::Sinkage(sinkage), drive);
    predict(model, &case, None).map_or([f64::INFINITY; 2], |found| [found.drag, found.vertical])
}

/// Between `low` and `high` the largest step of either force shrinks with the steps of the variable: at a
/// jump it would not.
fn has_no_jump(what: &str, (low, high, count): (f64, f64, u32), forces: impl Fn(f64) -> [f64; 2]) {
    let largest_step = |count: u32| {
        let at = |n: u32| forces(low + (high - low) * f64::from(n) / f64::from(count));
        let step = |n: u32| {
            let (one, other) = (at(n - 1), at(n));
            assert!(one.iter().chain(&other).all(|force| force.is_finite()), "{what}: no answer");
            let size = other[0].hypot(other[1]);
            (one[0] - other[0]).abs().max((one[1] - other[1]).abs()) / size
        };
        (1..=count).map(step).fold(0.0, f64::max)
    };
    let (coarse, fine) = (largest_step(count), largest_step(5 * count));
    assert!(fine < 0.4 * coarse + 1e-3, "{what}: steps of {coarse:.4} and {fine:.4} of the force");
}

/// Drag and vertical force at a held sinkage are continuous in friction angle, sinkage and slip. (They were
/// not: the wedge that a locked disc drags along has no field below φ = 1.5 atan μ = 32.7°, where the drag
/// jumped from 28 to 9 N.)
#[test]
fn forces_at_a_held_sinkage_do_not_jump() {
    let drives = [Drive::Locked, Drive::Free, Drive::Slip(-0.3), Drive::Slip(0.0)];
    for drive in drives {
        for sinkage in [0.005, 0.0503] {
            has_no_jump(&format!("{drive:?}, z = {sinkage}, φ"), (24.0, 44.0, 16), |phi| {
                held(Candidate::Governing, phi, sinkage, drive)
            });
        }
        for phi in [26.0, 33.0] {
            has_no_jump(&format!("{drive:?}, φ = {phi}°, ln z"), (0.002_f64.ln(), 0.1_f64.ln(), 16), |z| {
                held(Candidate::Governing, phi, z.exp(), drive)
            });
        }
    }
    for phi in [26.0, 33.0] {
        for sinkage in [0.005, 0.0503] {
            has_no_jump(&format!("φ = {phi}°, z = {sinkage}, s"), (-1.0, 0.7, 60), |slip| {
                held(Candidate::Governing, phi, sinkage, Drive::Slip(slip))
            });
        }
    }
}
