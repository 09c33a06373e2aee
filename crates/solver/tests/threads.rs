//! Many more threads than cores: the same bits.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod common;

use common::{below, sand, uniform};
use glam::DVec3;
use solver::halo::Halo;
use solver::initial::{at_rest, set_in_motion};
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

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let one = after(1);
    assert!(one.remaps > 1, "{} remaps", one.remaps);
    assert!(after(THREADS) == one);
}
