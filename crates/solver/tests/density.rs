//! No soil becomes denser than its densest state, however it is thrown about.

#![allow(missing_docs, clippy::unwrap_used, unreachable_pub)]
mod common;

use common::{below, dense_sand, sand, uniform};
use glam::DVec3;
use solver::boundary::Boundary;
use solver::energy::overdense_portion;
use solver::fields::GAP_STRAIN;
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
    let mut state =
        at_rest::<f64>(&model, &Filling::between(DVec3::splat(-1.0), DVec3::new(0.1, 1.0, 0.2)));
    let mut workspace = Workspace::new(&model, &mut state, 2);
    let mut most: f64 = 0.0;
    while state.time < 0.8 {
        step(&model, &mut state, &mut workspace).unwrap();
        if state.step.is_multiple_of(50) {
            most = most.max(overdense_portion(&model, &state.soil));
        }
    }
    assert!(most < 1e-3, "{most}");
}

/// A still box of soil, one cell of which has a portion `fraction` of its volume filled with soil of `density` times the usual one
/// and a gap, after a remap without a displacement: its volume fraction and its gap.
fn remapped(fraction: f64, density: f64, gap: f64) -> [f64; 2] {
    let mut model: Model = sand(std::array::from_fn(|_| uniform(0.0, 0.1, 10)));
    (model.gravity, model.soil_gravity) = (0.0, 0.0);
    let mut state = at_rest::<f64>(&model, &below(0.03));
    let c = model.grid.index(5, 5, 8);
    state.soil.fraction[c] = fraction;
    state.soil.mass[c] = density * model.material().density * fraction * model.grid.volume_of(c);
    state.soil.history[GAP_STRAIN][c] = gap;
    let mut workspace = Workspace::new(&model, &mut state, 1);
    remap(&model, &mut state, &mut workspace);
    [state.soil.fraction[c], state.soil.history[GAP_STRAIN][c]]
}

#[test]
fn squeezed_dust_takes_up_the_volume_of_its_mass_again() {
    let [fraction, _] = remapped(5e-4, 4.0, 0.0);
    assert!((fraction - 2e-3).abs() < 1e-9, "{fraction}");
    // Thin dust keeps its volume, and so does soil that bears stress.
    for (fraction, density) in [(5e-4, 0.5), (0.1, 1.05)] {
        let [kept, _] = remapped(fraction, density, 0.0);
        assert!((kept - fraction).abs() < 1e-12, "{fraction} at {density}: {kept}");
    }
}

#[test]
fn a_gap_closes_no_further_than_to_the_density_without_it() {
    let [_, gap] = remapped(0.5, 0.5, 2.0);
    assert!((gap - 1.0).abs() < 1e-9, "{gap}");
    let [_, none] = remapped(0.5, 1.0, 2.0);
    assert!(none.abs() < 1e-9, "{none}");
    let [_, kept] = remapped(0.5, 0.5, 0.6);
    assert!((kept - 0.6).abs() < 1e-12, "{kept}");
}
