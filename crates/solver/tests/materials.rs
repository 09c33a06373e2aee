//! Soil of several materials.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod common;

use common::{sand, uniform};
use geometry::Block;
use glam::DVec3;
use mechanics::{Inertia, Motion, Pose};
use physics::law::Law;
use physics::von_mises::VonMises;
use solver::initial::{Filling, at_rest_on};
use solver::model::{BodyModel, Ground, Model};
use solver::state::State;
use solver::step::step;
use solver::workspace::Workspace;

const FAR: f64 = 1e9;

/// A block pushed into a bank of sand.
fn bank(materials: usize) -> Model {
    let mut model = sand([uniform(-0.2, 0.2, 20), uniform(0.0, 0.06, 3), uniform(-0.1, 0.06, 16)]);
    model.materials = vec![model.materials[0]; materials];
    model.method.remap_displacement = 0.02;
    model.bodies.push(BodyModel {
        name: "block".into(),
        shape: Box::new(Block { size: DVec3::new(0.08, 0.2, 0.06) }),
        start: Pose::at(DVec3::new(-0.02, 0.03, 0.02)),
        inertia: Inertia::principal(1.0, DVec3::splat(0.01)),
        friction: 0.3,
        adhesion_factor: f64::INFINITY,
        edge_inset: DVec3::splat(0.5),
        fluid: mechanics::Fluid::NONE,
        motion: [
            Motion::Prescribed { before: 0.0, speed: 0.3, start: 0.0, ramp: 0.01, end: f64::INFINITY },
            Motion::Fixed,
            Motion::Fixed,
            Motion::Fixed,
            Motion::Fixed,
            Motion::Fixed,
        ],
    });
    model
}

/// Soil below z = 0 m: of the first material up to `at` along an axis, of the second beyond.
fn halves(axis: usize, at: f64) -> [Filling; 2] {
    let mut high = DVec3::new(FAR, FAR, 0.0);
    let whole = Filling { material: 1, ..Filling::between(DVec3::splat(-FAR), high) };
    high[axis] = at;
    [Filling::between(DVec3::splat(-FAR), high), whole]
}

fn run(model: &Model, fillings: &[Filling]) -> State {
    let mut state = at_rest_on::<f64>(model, &Ground { fillings: fillings.to_vec(), ..Ground::default() });
    let mut workspace = Workspace::new(model, &mut state, 2);
    for _ in 0..600 {
        step(model, &mut state, &mut workspace).unwrap();
    }
    assert!(state.remaps > 10);
    state
}

#[test]
fn two_materials_that_are_alike_are_one() {
    let one = run(&bank(1), &halves(2, -0.016).map(|filling| Filling { material: 0, ..filling }));
    for (axis, at) in [(0, 0.03), (2, -0.016)] {
        let two = run(&bank(2), &halves(axis, at));
        assert_eq!(one.soil.stress, two.soil.stress, "split along axis {axis}");
        assert_eq!(one.nodes, two.nodes, "split along axis {axis}");
        assert_eq!(one.bodies, two.bodies, "split along axis {axis}");
        let portions = &two.soil.composition[0];
        assert!(portions.iter().all(|p| (-1e-12..=1.0 + 1e-12).contains(p)));
        assert!(portions.iter().any(|p| *p > 1e-3 && *p < 0.999), "nothing was mixed");
    }
}

#[test]
fn layers_of_different_density_stay_at_rest() {
    let mut model = bank(2);
    model.bodies.clear();
    (model.materials[1].density, model.materials[1].k0) = (1200.0, 0.7);
    let mut state =
        at_rest_on::<f64>(&model, &Ground { fillings: halves(2, -0.043).to_vec(), ..Ground::default() });
    let mut workspace = Workspace::new(&model, &mut state, 1);
    for _ in 0..200 {
        step(&model, &mut state, &mut workspace).unwrap();
    }
    let speed = state.nodes.velocity.iter().flatten().fold(0.0, |most: f64, v| most.max(v.abs()));
    assert!(speed < 1e-12, "{speed} m/s");
    // By hand: 0.043 m of 1200 kg/m³ and 0.052 m of 1600 kg/m³ down to the centre of the lowest layer.
    let lowest = model.grid.index(3, 1, 0);
    let vertical = -9.81 * (1200.0 * 0.043 + 1600.0 * 0.052);
    assert!((state.soil.stress[2][lowest] / vertical - 1.0).abs() < 1e-9);
    assert!((state.soil.stress[0][lowest] / vertical - 0.43).abs() < 1e-9);
    let upper = model.grid.index(3, 1, 8);
    assert!((state.soil.stress[0][upper] / state.soil.stress[2][upper] - 0.7).abs() < 1e-9);
}

#[test]
fn each_half_yields_at_its_own_stress() {
    let mut model = bank(2);
    let yield_stress = [500.0, 2000.0];
    for (material, stress) in model.materials.iter_mut().zip(yield_stress) {
        material.yield_law = Some(Law::VonMises(VonMises::new(material.elastic, stress, 0.0)));
    }
    let state = run(&model, &halves(0, 0.03));
    let mut most = [0.0_f64; 2];
    for (c, portion) in state.soil.composition[0].iter().enumerate() {
        let number = usize::from(*portion > 0.5);
        if state.soil.fraction[c] > 0.5 {
            let [xx, yy, zz, xy, yz, xz] = state.soil.stress.each_ref().map(|s| s[c]);
            let normal = (xx - yy).powi(2) + (yy - zz).powi(2) + (zz - xx).powi(2);
            let mises = (0.5 * normal + 3.0 * (xy * xy + yz * yz + xz * xz)).sqrt();
            most[number] = most[number].max(mises);
        }
    }
    for (most, limit) in most.into_iter().zip(yield_stress) {
        assert!(most <= limit * (1.0 + 1e-9) && most > 0.9 * limit, "{most} Pa of {limit} Pa");
    }
}
