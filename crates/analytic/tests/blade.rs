//! Blocks and faceted bodies in the forecast, against worked examples and closed forms.
#![allow(clippy::unwrap_used)] // clippy does not recognise test helpers

use analytic::cutting::{Blade, mckyes_ali};
use analytic::disc::{Disc, Drive};
use analytic::forecast::{Block, Body, Candidate, FacetedBody, ModelForecast, Parameter, Prediction, curve};
use analytic::resistive::{Axle, Facet, SpatialLaw, Traction, at_depth};
use analytic::uncertainty::{Distribution, propagate_towing, sweep_table};
use analytic::{Load, Soil, Towing, forecast};
use std::f64::consts::{FRAC_PI_2, PI};

fn soil(degrees: f64, friction: f64) -> Soil {
    let angle = degrees.to_radians();
    Soil {
        friction_angle: angle,
        dilation_angle: angle,
        cohesion: 0.0,
        unit_weight: 16e3,
        body_friction: friction,
        adhesion_factor: 1.0,
        strength_gradient: 0.0,
    }
}

/// A block 0.06 m long, 0.25 m high.
fn block(width: f64, orientation: f64) -> Block {
    Block {
        size: [0.06, width, 0.25],
        orientation: orientation.to_radians(),
        plane_strain: false,
        has_base: true,
    }
}

fn held(soil: Soil, body: impl Into<Body>, z: f64) -> Towing {
    Towing::new(soil, body, Load::Sinkage(z), Drive::Locked)
}

fn entry(towing: &Towing, model: Candidate) -> ModelForecast {
    forecast(towing).unwrap().models.into_iter().find(|m| m.model == model).unwrap()
}

fn found(towing: &Towing, model: Candidate) -> Prediction {
    let entry = entry(towing, model);
    entry.prediction.unwrap_or_else(|| panic!("{}: {}", entry.name, entry.note))
}

/// The end factors of the derivation (φ = 35°, δ = ⅔φ), times the thrusts in plane strain: 7.773 exact, 9.962
/// Coulomb.
#[test]
fn upright_blades_reproduce_the_table_of_end_factors() {
    let delta = 70_f64.to_radians() / 3.0;
    let z = 0.1;
    // w/d, McKyes–Ali, PW with crescents, Godwin–Spoor, Brinch Hansen
    let rows = [
        (0.25, [9.29, 8.19, 9.53, 3.73]),
        (1.0, [3.16, 2.80, 3.13, 2.02]),
        (5.0, [1.47, 1.36, 1.43, 1.24]),
        (10.0, [1.24, 1.18, 1.21, 1.12]),
    ];
    let models = [Candidate::McKyesAli, Candidate::Wedge, Candidate::GodwinSpoor, Candidate::BrinchHansen];
    for (ratio, row) in rows {
        let case = held(soil(35.0, delta.tan()), block(ratio * z, 0.0), z);
        let plane = 0.5 * 16e3 * z * z * ratio * z * delta.cos();
        for (model, end) in models.into_iter().zip(row) {
            let thrust = if model == Candidate::McKyesAli { 9.962 } else { 7.773 };
            let force = found(&case, model);
            let want = plane * thrust * end;
            assert!(
                (force.drag / want - 1.0).abs() < 7e-3,
                "w/d={ratio} {model:?}: {} for {want}",
                force.drag
            );
            assert!((force.vertical / force.drag - delta.tan()).abs() < 1e-9, "{model:?}");
        }
    }
}

/// A wall in plane strain: Rankine's, Coulomb's and the exact thrust.
#[test]
fn a_wall_in_plane_strain_has_the_exact_thrust() {
    let wall = Block { plane_strain: true, ..block(0.5, 0.0) };
    let case = held(soil(30.0, 0.0), wall, 0.2);
    let rankine = 0.5 * 16e3 * 0.2 * 0.2 * 0.5 * 3.0;
    for model in [Candidate::PlaneStrain, Candidate::McKyesAli] {
        assert!((found(&case, model).drag / rankine - 1.0).abs() < 1e-4, "{model:?}");
    }
    assert!(entry(&case, Candidate::Wedge).note.contains("no ends"));
    assert_eq!(forecast(&case).unwrap().recommended, Some(Candidate::PlaneStrain));
    // Rough: the exact K_p = 6.548 of the derivation, against Coulomb's 10.095.
    let rough = held(soil(30.0, 2.0), wall, 0.2);
    let exact = found(&rough, Candidate::PlaneStrain);
    assert!((exact.drag.hypot(exact.vertical) / rankine * 3.0 - 6.548).abs() < 1e-3);
    let coulomb = entry(&rough, Candidate::McKyesAli);
    assert!(!coulomb.applicable && coulomb.note.contains("1.15"));
    let coulomb = coulomb.prediction.unwrap();
    assert!((coulomb.drag.hypot(coulomb.vertical) / rankine * 3.0 - 10.095).abs() < 2e-2);
}

/// A rotated plate whose front overhangs the soil has the K_n of its inclination (derivation: φ = 35°, α =
/// 70°, δ = 0).
#[test]
fn an_overhanging_front_is_pressed_up_and_a_raked_one_drawn_down() {
    let plate = Block { plane_strain: true, ..block(0.4, 20.0) };
    let case = held(soil(35.0, 0.0), plate, 0.1);
    let exact = found(&case, Candidate::PlaneStrain);
    let length = 0.1 / 70_f64.to_radians().sin();
    let thrust = 0.5 * 16e3 * length * length * 0.4 * 5.96;
    assert!((exact.drag.hypot(exact.vertical) / thrust - 1.0).abs() < 1e-3);
    assert!((exact.vertical / exact.drag - 20_f64.to_radians().tan()).abs() < 1e-9);
    // Leaning back 30° it is a blade of rake 60°, whose lower front edge is higher than the lowest one.
    let raked = block(0.4, -30.0);
    assert!((raked.front().rake.to_degrees() - 60.0).abs() < 1e-9);
    assert!((raked.front().lower_edge - 0.03).abs() < 1e-12);
    let soil = soil(35.0, 0.2);
    let case = held(soil, raked, 0.16);
    let seen = found(&case, Candidate::McKyesAli);
    let blade = Blade { width: 0.4, depth: 0.13, rake: 60_f64.to_radians(), surcharge: 0.0 };
    let want = mckyes_ali(&soil, &blade).unwrap();
    assert!((seen.drag / want.drag - 1.0).abs() < 1e-9 && seen.vertical < 0.0);
    for model in [Candidate::Wedge, Candidate::GodwinSpoor, Candidate::BrinchHansen] {
        assert!(entry(&case, model).note.contains("60.0°"), "{model:?}");
    }
    assert_eq!(forecast(&case).unwrap().recommended, Some(Candidate::McKyesAli));
    let shallow = entry(&held(soil, raked, 0.02), Candidate::McKyesAli);
    assert!(shallow.note.contains("30.0000 mm") || shallow.note.contains("30 mm"), "{}", shallow.note);
}

/// A plate rotated by 90° is a low block: the front is the face of the largest height.
#[test]
fn the_front_is_the_face_with_the_largest_height() {
    let lying = block(0.3, 90.0);
    let front = lying.front();
    assert!((front.rake - FRAC_PI_2).abs() < 1e-9 && (front.upper_edge - 0.06).abs() < 1e-9);
    assert!((front.length_behind - 0.25).abs() < 1e-9 && (lying.height() - 0.06).abs() < 1e-9);
    let steep = block(0.3, -60.0).front();
    assert!((steep.rake.to_degrees() - 30.0).abs() < 1e-9);
}

/// 3D-RFT and 2-D RFT of a block: the sum of the tractions on its front and its base.
#[test]
fn resistive_force_theory_sums_front_and_base() {
    let (soil, z) = (soil(35.0, 0.4), 0.1);
    let law = SpatialLaw::new(soil.friction_angle, 16e3, 0.4).unwrap();
    let forwards = [1.0, 0.0, 0.0];
    let front = law.traction(0.5 * z, forwards, forwards).map(|t| t * 0.3 * z);
    let base = law.traction(z, [0.0, 0.0, -1.0], forwards).map(|t| t * 0.3 * 0.06);
    let seen = found(&held(soil, block(0.3, 0.0), z), Candidate::SpatialResistive);
    assert!((seen.drag + front[0] + base[0]).abs() < 1e-9 * seen.drag);
    assert!((seen.vertical - front[2] - base[2]).abs() < 1e-9 * seen.drag);
    assert!(found(&held(soil, block(0.3, 0.0), z), Candidate::PlanarResistive).drag > 0.0);
}

/// A faceted body with the facets of a disc's rim has the forces of the disc, locked and free.
#[test]
fn a_faceted_disc_has_the_forces_of_the_disc() {
    let disc = Disc { diameter: 0.2, thickness: 0.05 };
    let count = 720;
    let facets = (0..count).map(|n| {
        let angle = 2.0 * PI * (f64::from(n) + 0.5) / f64::from(count);
        let normal = [angle.cos(), 0.0, angle.sin()];
        let area = 0.05 * 0.2 * PI / f64::from(count);
        let half_height = 0.5 * (area / 0.05) * normal[0].abs();
        Facet { centroid: normal.map(|n| 0.1 * n), normal, area, half_height }
    });
    let round = FacetedBody {
        length: 0.2,
        width: 0.05,
        breadth: 0.05,
        plane_strain: false,
        height: 0.2,
        below: 0.1,
        axle: Axle::across(0.1),
        facets: facets.collect(),
    };
    let soil = soil(35.0, 0.3);
    let law = SpatialLaw::new(soil.friction_angle, 16e3, 0.3).unwrap();
    for drive in [Drive::Locked, Drive::Slip(-0.3), Drive::Free] {
        let exact = at_depth(&law, &disc, 0.04, drive).unwrap();
        let towing = Towing::new(soil, Body::Faceted(round.clone()), Load::Sinkage(0.04), drive);
        let seen = found(&towing, Candidate::SpatialResistive);
        for (a, b) in [(seen.drag, exact.drag), (seen.vertical, exact.vertical)] {
            assert!((a / b - 1.0).abs() < 4e-3, "{drive:?}: {a} for {b}");
        }
        assert!(seen.slip.is_none_or(|slip| (slip - exact.slip).abs() < 5e-3));
    }
    let weighed = Towing::new(soil, Body::Faceted(round), Load::Weight(40.0), Drive::Locked);
    let all = forecast(&weighed).unwrap();
    assert_eq!(all.recommended, Some(Candidate::SpatialResistive));
    assert!((found(&weighed, Candidate::SpatialResistive).vertical / 40.0 - 1.0).abs() < 1e-4);
    for model in all.models.iter().filter(|m| !m.applicable) {
        assert!(!model.note.is_empty(), "{}", model.name);
    }
}

/// A block that is free to sink is in equilibrium where front and base carry it; sinkage and drag increase
/// with weight.
#[test]
fn a_block_sinks_to_its_equilibrium() {
    let at = |weight: f64, model| {
        let case = Towing::new(soil(32.0, 0.3), block(0.3, 0.0), Load::Weight(weight), Drive::Locked);
        found(&case, model)
    };
    let light = at(1.0, Candidate::Wedge);
    assert!(light.sinkage.unwrap() < 1e-6 && (light.drag - 0.3).abs() < 1e-6);
    for model in [Candidate::Wedge, Candidate::McKyesAli, Candidate::SpatialResistive] {
        let mut last = (0.0, 0.0);
        for weight in [150.0, 300.0, 600.0] {
            let found = at(weight, model);
            assert!((found.vertical / weight - 1.0).abs() < 1e-4, "{model:?}");
            assert!(found.sinkage.unwrap() > last.0 && found.drag > last.1, "{model:?} under {weight}");
            last = (found.sinkage.unwrap(), found.drag);
        }
    }
    let heavy = Towing::new(soil(32.0, 0.3), block(0.3, 0.0), Load::Weight(1e6), Drive::Locked);
    assert!(entry(&heavy, Candidate::Wedge).note.contains("at most"));
}

/// Predictions are finite for all orientations, sinkages and frictions.
#[test]
fn no_prediction_is_not_a_number() {
    for orientation in [-170.0, -80.0, -45.0, -10.0, 0.0, 0.5, 15.0, 40.0, 89.0, 180.0] {
        for (z, friction) in [(1e-6, 0.0), (0.03, 0.7), (0.055, 2.0)] {
            let case = held(soil(38.0, friction), block(0.2, orientation), z);
            for model in forecast(&case).unwrap().models {
                match model.prediction {
                    Some(p) => {
                        assert!(p.drag.is_finite() && p.vertical.is_finite() && p.drag > 0.0, "{model:?}")
                    }
                    None => assert!(!model.note.is_empty(), "{}", model.name),
                }
            }
        }
    }
    let deep = held(soil(38.0, 0.3), block(0.2, 0.0), 0.26);
    let message = forecast(&deep).unwrap_err().to_string();
    assert!(message.contains("above 0 and at most 0.25 m"), "{message}");
}

/// A table over the range of the friction angle gives the result of the field itself; curves exist for all
/// models.
#[test]
fn blades_have_curves_and_uncertainty() {
    let case = held(soil(35.0, 0.4), block(0.3, 0.0), 0.1);
    let deviation = 2_f64.to_radians();
    let inputs = [(Parameter::FrictionAngle, Distribution::Normal { mean: 35_f64.to_radians(), deviation })];
    let table = sweep_table(&case, &inputs);
    assert!(table.is_some());
    let with =
        propagate_towing(&case, &inputs, Candidate::Wedge, 256, 1, table.as_ref()).unwrap().drag.quantiles;
    let without = propagate_towing(&case, &inputs, Candidate::Wedge, 256, 1, None).unwrap().drag.quantiles;
    for (a, b) in with.into_iter().zip(without) {
        assert!((a / b - 1.0).abs() < 1e-4, "{a} for {b}");
    }
    let points = curve(&case, Parameter::Sinkage, &[0.02, 0.05, 0.1, 0.2], &[]).unwrap();
    for model in [Candidate::Wedge, Candidate::McKyesAli, Candidate::GodwinSpoor, Candidate::BrinchHansen] {
        let of =
            |n: usize| points[n].models.iter().find(|m| m.model == model).unwrap().prediction.unwrap().drag;
        assert!(of(0) < of(1) && of(1) < of(2) && of(2) < of(3), "{model:?}");
    }
    let rotated = curve(&case, Parameter::Orientation, &[-0.3, 0.0, 0.3], &[Candidate::McKyesAli]).unwrap();
    assert!(rotated[0].models[0].prediction.is_some() && rotated[2].models[0].prediction.is_none());
}
