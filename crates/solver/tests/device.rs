//! What crosses to a device and back in a step, and what becomes of a run whose device fails.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod common;

use common::{below, sand, uniform};
use geometry::Disc;
use glam::DVec3;
use mechanics::{Inertia, Motion, Pose};
use solver::device::replay::Replay;
use solver::error::Breakdown;
use solver::initial::at_rest;
use solver::model::{BodyModel, Model};
use solver::state::State;
use solver::step::step;
use solver::workspace::Workspace;

/// A disc that is pushed down into sand.
fn disc() -> Model {
    let mut model = sand([uniform(-0.1, 0.1, 20), uniform(-0.08, 0.08, 16), uniform(-0.1, 0.06, 16)]);
    let down = Motion::Prescribed { before: 0.0, speed: -0.1, start: 0.0, ramp: 0.01, end: f64::INFINITY };
    model.bodies.push(BodyModel {
        name: "disc".into(),
        shape: Box::new(Disc { diameter: 0.08, thickness: 0.03 }),
        start: Pose::at(DVec3::new(0.0, 0.0, 0.03)),
        inertia: Inertia::principal(0.3, DVec3::splat(0.0005)),
        friction: 0.3,
        adhesion_factor: f64::INFINITY,
        edge_inset: DVec3::splat(0.5),
        fluid: mechanics::Fluid::NONE,
        motion: [Motion::Fixed, Motion::Fixed, down, Motion::Fixed, Motion::Fixed, Motion::Fixed],
    });
    model
}

fn start(model: &Model, driver: Replay) -> (State, Workspace) {
    let mut state = at_rest(model, &below(0.0));
    let mut workspace = Workspace::new(model, &mut state, 1);
    workspace.use_device(model, &state, Box::new(driver)).unwrap();
    (state, workspace)
}

/// Between two remaps only contact nodes and sums cross: the first step hands over the fields, others less
/// than a twentieth of that. In a remap volume fractions and masses cross, and what lies round the body.
#[test]
fn no_field_crosses_in_a_step() {
    let model = disc();
    let (mut state, mut workspace) = start(&model, Replay::default());
    let mut crossed = workspace.crossed_to_device().unwrap();
    let (mut fields, mut most, mut in_steps, mut in_remaps) = (0, 0, 0, 0);
    while state.step < 300 {
        let remaps = state.remaps;
        step(&model, &mut state, &mut workspace).unwrap();
        let so_far = workspace.crossed_to_device().unwrap();
        let own = so_far - crossed;
        crossed = so_far;
        if state.step == 1 {
            fields = own;
        } else if state.remaps > remaps {
            in_remaps = in_remaps.max(own);
        } else {
            (most, in_steps) = (most.max(own), in_steps + 1);
        }
    }
    assert!(state.bodies[0].contact_impulse.normal.z > 0.0 && in_steps > 200, "{in_steps}");
    println!("{most} in a step, {in_remaps} in a remap, {fields} all fields");
    assert!(most < fields / 20 && most < 1_000_000, "{most} of {fields} bytes");
    assert!(state.remaps > 2 && in_remaps < fields, "{in_remaps} of {fields} bytes");
}

#[test]
fn a_device_without_memory_is_refused() {
    let model = disc();
    let mut state: State = at_rest(&model, &below(0.0));
    let mut workspace = Workspace::new(&model, &mut state, 1);
    let mut small = Replay::default();
    small.limit = Some(1_000_000);
    let refused = workspace.use_device(&model, &state, Box::new(small)).unwrap_err();
    assert!(refused.0.contains("bytes are not free"), "{refused}");
    step(&model, &mut state, &mut workspace).unwrap();
}

#[test]
fn more_materials_than_a_device_remaps_are_refused() {
    let mut model = disc();
    let soil = model.materials[0];
    model.materials.resize(9, soil);
    let mut state: State = at_rest(&model, &below(0.0));
    let mut workspace = Workspace::new(&model, &mut state, 1);
    let refused = workspace.use_device(&model, &state, Box::<Replay>::default()).unwrap_err();
    assert!(refused.0.contains("more than 8 materials"), "{refused}");
}

#[test]
fn a_run_whose_device_is_lost_breaks_down() {
    let model = disc();
    let mut driver = Replay::default();
    driver.lost_after = Some(100);
    let (mut state, mut workspace) = start(&model, driver);
    let end = (0..100).find_map(|_| step(&model, &mut state, &mut workspace).err()).unwrap();
    assert!(matches!(&end, Breakdown::Device { why, .. } if why.contains("lost")), "{end}");
}
