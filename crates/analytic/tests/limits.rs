//! General properties: finite, monotone, independent of scale, errors outside the valid range.

use analytic::bearing::Method;
use analytic::disc::{Assembly, Disc, Drive, Equilibrium, Model, Setting, disc_forces, equilibrium};
use analytic::forecast::{Body, Candidate, Outline, Plate, predict};
use analytic::wheel::TERRAINS;
use analytic::{Load, Soil, Towing, forecast};
use proptest::prelude::*;

fn soil(degrees: f64, friction: f64, cohesion: f64) -> Soil {
    let angle = degrees.to_radians();
    Soil {
        friction_angle: angle,
        dilation_angle: angle,
        cohesion,
        unit_weight: 16e3,
        body_friction: friction,
        adhesion_factor: 1.0,
        strength_gradient: 0.0,
    }
}

fn disc(thickness: f64) -> Disc {
    Disc { diameter: 0.2, thickness: 0.2 * thickness }
}

fn vertical(model: Model, phi: f64, thickness: f64, z: f64) -> f64 {
    let setting = Setting::new(soil(phi, 0.3, 0.0), disc(thickness), Drive::Free);
    disc_forces(model, &setting, 0.2 * z).expect("a force").vertical
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn free_forces_rise_with_friction_depth_and_thickness(
        phi in 15.0..49.0_f64, thickness in 0.03..1.5_f64, z in 0.01..0.27_f64,
    ) {
        prop_assert!(vertical(Model::Bearing, phi, thickness, 2.2 * z) > vertical(Model::Bearing, phi, thickness, 2.1 * z));
        for model in [Model::Bearing, Model::Wedge, Model::PlaneStrain, Model::Governing] {
            let here = vertical(model, phi, thickness, z);
            prop_assert!(here > 0.0);
            prop_assert!(vertical(model, phi + 0.5, thickness, z) > here, "{model:?} in φ");
            prop_assert!(vertical(model, phi, thickness, 1.03 * z) > here, "{model:?} in Z");
            prop_assert!(vertical(model, phi, 1.03 * thickness, z) > here, "{model:?} in t");
        }
    }

    #[test]
    fn heavier_discs_sink_deeper_and_have_more_drag(
        phi in 20.0..48.0_f64, thickness in 0.05..1.0_f64, weight in 0.01..2.0_f64,
    ) {
        let setting = Setting::new(soil(phi, 0.3, 0.0), disc(thickness), Drive::Free);
        let weight = weight * setting.disc.force_scale(16e3);
        let rest = |weight: f64| match equilibrium(Model::Bearing, &setting, weight) {
            Ok(Equilibrium::At { sinkage, forces }) => Some((sinkage, forces.drag, forces.vertical)),
            _ => None,
        };
        if let (Some(light), Some(heavy)) = (rest(weight), rest(1.1 * weight)) {
            prop_assert!(heavy.0 > light.0 && heavy.1 > light.1);
            prop_assert!((light.2 / weight - 1.0).abs() < 1e-9);
        }
    }

    #[test]
    fn nothing_depends_on_the_scale(
        phi in 20.0..45.0_f64, thickness in 0.05..1.0_f64, z in 0.02..0.5_f64, c in 0.0..0.05_f64, size in 0.01..100.0_f64,
    ) {
        for (model, drive) in [(Model::Bearing, Drive::Free), (Model::Wedge, Drive::Free), (Model::Bearing, Drive::Locked), (Model::Governing, Drive::Free), (Model::Governing, Drive::Locked)] {
            let groups = |size: f64, gamma: f64| {
                let body = Disc { diameter: size, thickness: thickness * size };
                let ground = Soil { unit_weight: gamma, ..soil(phi, 0.3, c * gamma * size) };
                let found = disc_forces(model, &Setting::new(ground, body, drive), z * size).unwrap();
                let scale = body.force_scale(gamma);
                (found.drag / scale, found.vertical / scale)
            };
            let (one, other) = (groups(1.0, 16e3), groups(size, 9e3));
            prop_assert!((one.0 / other.0 - 1.0).abs() < 1e-12 && (one.1 / other.1 - 1.0).abs() < 1e-12);
        }
        let rest = |size: f64| {
            let setting = Setting::new(soil(phi, 0.3, 0.0), Disc { diameter: size, thickness: thickness * size }, Drive::Free);
            match equilibrium(Model::Bearing, &setting, z * setting.disc.force_scale(16e3)) {
                Ok(Equilibrium::At { sinkage, .. }) => sinkage / size,
                _ => 0.0,
            }
        };
        prop_assert!((rest(1.0) - rest(size)).abs() <= 1e-12 * rest(1.0));
    }

    #[test]
    fn every_answer_is_finite(
        phi in 5.0..55.0_f64, psi in -10.0..55.0_f64, c in -10.0..1e4_f64, gamma in -1e3..3e4_f64, mu in -0.1..1.5_f64,
        diameter in -0.1..3.0_f64, thickness in 0.001..2.0_f64, load in -10.0..1e5_f64, held in 0.0..1.2_f64,
        choice in 0..10_usize, extra in -1.5..2.5_f64,
    ) {
        let drive = [Drive::Free, Drive::Locked, Drive::Slip(extra), Drive::Braked(extra), Drive::Driven(extra)][choice % 5];
        let ground = Soil {
            friction_angle: phi.to_radians(),
            dilation_angle: psi.to_radians(),
            cohesion: c,
            unit_weight: gamma,
            body_friction: mu,
            adhesion_factor: 1.0,
            strength_gradient: 0.0,
        };
        let load = if choice < 5 { Load::Weight(load) } else { Load::Sinkage(held * diameter) };
        let ground = if choice == 7 { Soil { friction_angle: 0.0, dilation_angle: 0.0, ..ground } } else { ground };
        let body = match choice {
            3 | 7 if extra > 0.5 => Plate { outline: Outline::Rectangle, width: diameter, length: thickness, height: thickness }.into(),
            6 if extra > 0.5 => Plate { outline: Outline::Circle, width: diameter, length: diameter, height: thickness }.into(),
            _ => Disc { diameter, thickness }.into(),
        };
        let is_plate = matches!(body, Body::Plate(_));
        let mut case = Towing::new(ground, body, load, drive);
        case.pressed = is_plate || choice % 3 == 2;
        case.terrain = Some(TERRAINS[choice].soil);
        case.cone_index = Some(200e3);
        case.bow_wave_fraction = (0.1 * extra).max(0.0);
        case.method = [Method::Meyerhof, Method::HansenVesic, Method::Lyamin][choice % 3];
        case.backfill = 0.05 * extra;
        if choice % 4 == 1 {
            case.assembly = Some(Assembly { count: 3, spacing: 1.5 * thickness });
        }
        if let Ok(found) = forecast(&case) {
            for model in found.models.iter().chain(&found.models_other_strength) {
                prop_assert!(model.prediction.is_some() || !model.note.is_empty());
                if let Some(p) = model.prediction {
                    if let Load::Weight(weight) = load {
                        prop_assert!((p.vertical / weight - 1.0).abs() < 1e-3, "{model:?} under {weight} N");
                    }
                    for x in [Some(p.drag), Some(p.vertical), p.sinkage, p.contact_angle, Some(p.force_inclination), p.slip] {
                        prop_assert!(x.is_none_or(f64::is_finite), "{model:?}");
                    }
                }
            }
        }
    }
}

#[test]
fn a_wide_disc_is_in_plane_strain() {
    let setting = Setting::new(soil(35.0, 0.3, 0.0), Disc { diameter: 0.2, thickness: 2e4 }, Drive::Free);
    let plane = disc_forces(Model::PlaneStrain, &setting, 0.04).unwrap();
    let ends = disc_forces(Model::Wedge, &setting, 0.04).unwrap();
    assert!((ends.vertical / plane.vertical - 1.0).abs() < 2e-5);
}

#[test]
fn the_wedge_forms_match_their_closed_integrals() {
    for z in [0.01_f64, 0.1, 0.3, 0.6] {
        let setting = Setting::new(soil(33.0, 0.3, 0.0), disc(0.3), Drive::Free);
        let found = disc_forces(Model::PlaneStrain, &setting, 0.2 * z).unwrap();
        let alpha = z.sqrt().asin();
        let (sin, cos) = alpha.sin_cos();
        let ratio = (sin + sin.powi(3) - alpha * cos) / (sin * sin * cos + alpha * sin);
        assert!((found.drag / found.vertical / ratio - 1.0).abs() < 1e-11);
    }
}

#[test]
fn inputs_out_of_range_are_errors_with_the_range() {
    let good = Towing::new(soil(35.0, 0.3, 0.0), disc(0.25), Load::Weight(50.0), Drive::Free);
    let refuse = |change: &dyn Fn(&mut Towing), word: &str| {
        let mut case = good.clone();
        change(&mut case);
        let message = forecast(&case).unwrap_err().to_string();
        assert!(
            message.contains(word) && message.contains("it must be") | message.contains("valid range"),
            "{message}"
        );
        assert!(predict(Candidate::Bearing, &case, None).is_err());
    };
    refuse(
        &|case| case.soil.friction_angle = 1.0,
        "friction angle = 57.29578° is out of range: the valid range is 10° to 50°",
    );
    refuse(&|case| case.soil.dilation_angle = 0.7, "dilation angle");
    refuse(&|case| case.soil.unit_weight = 0.0, "unit weight");
    refuse(&|case| case.soil.cohesion = f64::NAN, "cohesion");
    refuse(&|case| case.body = Disc { thickness: f64::INFINITY, ..disc(0.25) }.into(), "thickness");
    refuse(&|case| case.load = Load::Sinkage(0.3), "sinkage");
    refuse(&|case| case.drive = Drive::Slip(-2.0), "slip");
    refuse(&|case| case.gravity = -1.0, "gravity");
}

/// F_V of the wedge has a maximum, shallower in stronger sand, beyond which a heavier disc digs in.
#[test]
fn the_maxima_of_the_vertical_force_are_where_the_documentation_says() {
    let rows = [(30., 72, 82), (35., 60, 72), (40., 48, 59), (45., 36, 46)];
    for (phi, plane, ends) in rows {
        let maximum = |model| {
            let lift = |n: i32| vertical(model, phi, 0.25, 0.01 * f64::from(n));
            (1..94).find(|n| lift(n + 1) <= lift(*n)).unwrap_or(94)
        };
        assert_eq!((maximum(Model::PlaneStrain), maximum(Model::Wedge)), (plane, ends));
        assert!(maximum(Model::Bearing) >= 80);
    }
}
