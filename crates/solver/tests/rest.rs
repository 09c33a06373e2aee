//! Soil at rest stays at rest, wherever its surface lies within a cell, even with a remap every step.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod common;

use common::{below, sand, uniform};
use solver::initial::at_rest;
use solver::step::step;
use solver::workspace::Workspace;

fn largest_speed(surface: f64, threads: usize, every_step: bool) -> f64 {
    let mut x = uniform(0.0, 0.3, 6);
    x.extend([0.37, 0.45]);
    let mut model = sand([x, uniform(0.0, 0.2, 4), uniform(0.0, 0.5, 10)]);
    if every_step {
        model.method.remap_displacement = -1.0;
    }
    let mut state = at_rest::<f64>(&model, &below(surface));
    let mut workspace = Workspace::new(&model, &mut state, threads);
    for _ in 0..500 {
        step(&model, &mut state, &mut workspace).unwrap();
    }
    assert_eq!(state.remaps, if every_step { 500 } else { 0 });
    state.nodes.velocity.iter().flatten().fold(0.0, |a, v| v.abs().max(a))
}

#[test]
fn geostatic_soil_stays_at_rest() {
    for surface in [0.4, 0.425, 0.4005, 0.4495] {
        for every_step in [false, true] {
            for threads in [1, 2] {
                let speed = largest_speed(surface, threads, every_step);
                assert!(speed < 1e-12, "{speed:e} m/s with the surface at {surface} m, remap {every_step}");
            }
        }
    }
}
