//! No soil becomes denser than its densest state, however it is thrown about.

#![allow(missing_docs, clippy::unwrap_used, unreachable_pub)]
mod common;

use common::{below, dense_sand, sand, uniform};
use glam::DVec3;
use solver::boundary::Boundary;
use solver::energy::overdense_portion;
use solver::fields::GAP_STRAIN;
use solver::halo::Halo;
use solver::initial::{Filling, at_rest};
use solver::model::Model;
use solver::remap::remap;
use solver::step::step;
use solver::workspace::Workspace;

#[test]
fn a_column_of_sand_collapses_without_losing_volume() {
    let mut model = sand([uniform(0.0, 0.5, 50), uniform(0.0, 0.01, 1), uniform(0.0, 0.24, 24)]);
    model.materials = vec![dense_sand(Some(0.02))];
    model.boundaries.0[2][0] = Boundary::RoughWall;
    let mut state = at_rest::<f64>(&model, &Filling::between(DVec3::splat(-1.0), DVec3::new(0.1, 1.0, 0.2)));
    let mut workspace = Workspace::new(&model, &mut state, 2);
    let mut most: f64 = 0.0;
    while state.time < 0.8 {
        step(&model, &mut state, &mut workspace).unwrap();
        if state.step.is_multiple_of(50) {
            most = most.max(overdense_portion(&model, &state.soil, &Halo::whole()));
        }
    }
    assert!(most < 1e-3, "{most}");
}

/// The gap of a cell half full of soil of `density` times the usual one and with a `gap`, after a remap
/// without a displacement.
fn remapped(density: f64, gap: f64) -> f64 {
    let mut model: Model = sand(std::array::from_fn(|_| uniform(0.0, 0.1, 10)));
    (model.gravity, model.soil_gravity) = (0.0, 0.0);
    let mut state = at_rest::<f64>(&model, &below(0.03));
    let c = model.grid.index(5, 5, 8);
    state.soil.fraction[c] = 0.5;
    state.soil.mass[c] = density * model.material().density * 0.5 * model.grid.volume_of(c);
    state.soil.history[GAP_STRAIN][c] = gap;
    let mut workspace = Workspace::new(&model, &mut state, 1);
    remap(&model, &mut state, &mut workspace);
    state.soil.history[GAP_STRAIN][c]
}

#[test]
fn a_veil_on_the_surface_lies_still() {
    let mut model = sand([uniform(0.0, 0.04, 4), uniform(0.0, 0.01, 1), uniform(0.0, 0.06, 6)]);
    model.method.remap_displacement = 0.01;
    let mut state = at_rest::<f64>(&model, &below(0.03 + 5e-6));
    let mut workspace = Workspace::new(&model, &mut state, 1);
    while state.time < 0.3 {
        step(&model, &mut state, &mut workspace).unwrap();
    }
    let fastest = state.nodes.velocity[2].iter().fold(0.0, |most: f64, v| most.max(v.abs()));
    // In free fall it would be 3 m/s.
    assert!(fastest < 0.02, "{fastest} m/s");
}

#[test]
fn a_gap_closes_no_further_than_to_the_density_without_it() {
    for (density, gap, kept) in [(0.5, 2.0, 1.0), (1.0, 2.0, 0.0), (0.5, 0.6, 0.6)] {
        let found = remapped(density, gap);
        assert!((found - kept).abs() < 1e-9, "{gap} at {density}: {found}");
    }
}
