//! Any number of threads gives the same bits, also with many more threads than cores.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod common;

use common::{below, sand, uniform};
use geometry::Disc;
use glam::DVec3;
use mechanics::{Inertia, Motion, Pose};
use solver::halo::Halo;
use solver::initial::{at_rest, set_in_motion};
use solver::model::BodyModel;
use solver::state::State;
use solver::step::step;
use solver::workspace::Workspace;

const THREADS: usize = 128;

/// A tall column of sand that is set in motion, after some steps and remaps.
fn after(threads: usize) -> State {
    let mut model = sand([uniform(0.0, 0.4, 16), uniform(0.0, 0.1, 4), uniform(0.0, 4.0, 160)]);
    model.method.remap_displacement = 0.02;
    let mut state = at_rest(&model, &below(3.6));
    set_in_motion(&model, &mut state, DVec3::new(0.4, 0.1, -0.2), &Halo::whole());
    let mut workspace = Workspace::new(&model, &mut state, threads);
    assert_eq!(workspace.threads(), threads);
    (0..60).for_each(|_| step(&model, &mut state, &mut workspace).unwrap());
    state
}

/// Four discs that roll through sand, two of them so close that they share cells, after some steps and
/// remaps.
fn discs_after(threads: usize) -> State {
    let mut model = sand([uniform(-0.2, 0.24, 44), uniform(-0.16, 0.16, 32), uniform(-0.14, 0.06, 20)]);
    let moving =
        |speed| Motion::Prescribed { before: 0.0, speed, start: 0.0, ramp: 0.01, end: f64::INFINITY };
    for (name, y) in [("a", -0.11), ("b", 0.0), ("c", -0.078), ("d", 0.1)] {
        model.bodies.push(BodyModel {
            name: name.into(),
            shape: Box::new(Disc { diameter: 0.08, thickness: 0.03 }),
            start: Pose::at(DVec3::new(10.0 * y * y, y, 0.02)),
            inertia: Inertia::principal(0.3, DVec3::splat(0.0005)),
            friction: 0.3,
            adhesion_factor: f64::INFINITY,
            edge_inset: DVec3::splat(0.5),
            fluid: mechanics::Fluid::NONE,
            motion: [
                moving(0.3 + y),
                Motion::Fixed,
                moving(-0.1),
                Motion::Fixed,
                Motion::Fixed,
                Motion::Free { load: 0.0, support: 0.0, start: 0.0, ramp: 0.0 },
            ],
        });
    }
    let mut state = at_rest(&model, &below(0.0));
    let mut workspace = Workspace::new(&model, &mut state, threads);
    while state.remaps < 3 {
        step(&model, &mut state, &mut workspace).unwrap();
    }
    state
}

#[test]
fn threads_share_the_contact_of_several_bodies() {
    let one = discs_after(1);
    let touched = one.bodies.iter().filter(|body| body.contact_impulse.normal.z > 0.0).count();
    assert_eq!(touched, 4);
    for threads in [2, 3, 7] {
        assert!(discs_after(threads) == one, "{threads} threads");
    }
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let one = after(1);
    assert!(one.remaps > 1, "{} remaps", one.remaps);
    assert!(after(THREADS) == one);
}
