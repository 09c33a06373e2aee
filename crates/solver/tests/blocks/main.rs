//! A grid partitioned into blocks, each on its own thread, gives the same bits as the whole grid.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

#[path = "../common/mod.rs"]
mod common;
mod models;

use common::below;
use models::{assert_same, go, impulse, penalty, softening, start, under_water, yielding};
use solver::fields::Nodes;
use solver::grid::Grid;
use solver::halo::decomposition::Decomposition;
use solver::halo::in_process::partition;
use solver::initial::{Filling, at_rest_in_block, at_rest_on};
use solver::material::Material;
use solver::model::{Ground, Model};
use solver::precision::Precision;
use solver::workspace::Workspace;

fn blocks_are_the_whole<R: Precision>(model: fn(usize) -> Model, before: [&[usize]; 2], threads: usize) {
    let whole = model(R::LANES);
    let mut state = start::<R>(&whole);
    let mut workspace = Workspace::new(&whole, &mut state, 1);
    let begin = start::<R>(&whole);
    go(&whole, &mut state, &mut workspace);
    assert!(state.remaps > 10 && state.contacts.len() > 100, "{} remaps", state.remaps);
    let still: Nodes<R> = Nodes::at_rest(&whole.grid);
    assert!(state.nodes.velocity != still.velocity);
    let blocks = partition(&whole.grid, before);
    assert_eq!(blocks.len(), (before[0].len() + 1) * (before[1].len() + 1));
    std::thread::scope(|scope| {
        let mut running = Vec::new();
        for (grid, halo) in blocks {
            let (begin, state, whole) = (&begin, &state, &whole.grid);
            let block = scope.spawn(move || {
                let mut own = begin.of_block(whole, &grid);
                let model = Model { grid, ..model(R::LANES) };
                let mut workspace = Workspace::of_block(&model, &mut own, threads, halo);
                go(&model, &mut own, &mut workspace);
                assert_same((whole, state), (&model.grid, &own));
                workspace.moves_contact_first()
            });
            running.push(block);
        }
        // In portions of the rows for several threads there may be too few of them.
        let mut each = running.into_iter().map(|block| block.join().unwrap());
        assert!(each.any(|moves_first| moves_first) || threads > 1);
    });
}

/// A grid that is cut anew in the midst of a run.
fn blocks_may_be_recut<R: Precision>(model: fn(usize) -> Model, cuts: [[&[usize]; 2]; 2]) {
    let whole = model(R::LANES);
    let mut state = start::<R>(&whole);
    let mut workspace = Workspace::new(&whole, &mut state, 1);
    let begin = start::<R>(&whole);
    go(&whole, &mut state, &mut workspace);
    go(&whole, &mut state, &mut workspace);
    let after = Decomposition::cut(&whole.grid, cuts[1]);
    std::thread::scope(|scope| {
        for (grid, halo) in partition(&whole.grid, cuts[0]) {
            let (begin, state, whole, after) = (&begin, &state, &whole.grid, &after);
            scope.spawn(move || {
                let mut own = begin.of_block(whole, &grid);
                let mut model = Model { grid, ..model(R::LANES) };
                let mut workspace = Workspace::of_block(&model, &mut own, 1, halo);
                go(&model, &mut own, &mut workspace);
                workspace.recut(&mut model, &mut own, after);
                assert_eq!(model.grid.own, after.own(workspace.halo().rank()));
                go(&model, &mut own, &mut workspace);
                assert_same((whole, state), (&model.grid, &own));
            });
        }
    });
}

#[test]
fn blocks_that_are_recut_on_the_way() {
    blocks_may_be_recut::<f64>(impulse, [[&[9], &[]], [&[], &[7]]]);
    blocks_may_be_recut::<f32>(softening, [[&[5, 11], &[]], [&[8, 13], &[]]]);
    blocks_may_be_recut::<f64>(under_water, [[&[9], &[6]], [&[6], &[8]]]);
}

#[test]
fn two_blocks_side_by_side() {
    blocks_are_the_whole::<f64>(impulse, [&[9], &[]], 1);
}

#[test]
fn blocks_with_pore_water_side_by_side_and_above_each_other() {
    blocks_are_the_whole::<f64>(under_water, [&[9], &[6]], 2);
    // Contact points above the surface press on water below the cut.
    blocks_are_the_whole::<f64>(under_water, [&[], &[8]], 1);
    blocks_are_the_whole::<f32>(under_water, [&[4, 13], &[]], 1);
}

#[test]
fn three_uneven_blocks_side_by_side() {
    blocks_are_the_whole::<f64>(impulse, [&[4, 13], &[]], 2);
}

#[test]
fn two_blocks_one_above_the_other() {
    blocks_are_the_whole::<f64>(impulse, [&[], &[7]], 1);
}

#[test]
fn six_blocks_that_meet_at_edges() {
    blocks_are_the_whole::<f64>(impulse, [&[5, 11], &[7]], 1);
}

#[test]
fn blocks_with_sides_at_constant_stress() {
    blocks_are_the_whole::<f64>(yielding, [&[9], &[7]], 2);
    blocks_are_the_whole::<f32>(yielding, [&[5, 11], &[]], 1);
}

#[test]
fn blocks_with_penalty_contact() {
    blocks_are_the_whole::<f64>(penalty, [&[8], &[6]], 1);
}

#[test]
fn blocks_in_single_precision() {
    blocks_are_the_whole::<f32>(impulse, [&[6, 12], &[]], 1);
}

#[test]
fn blocks_of_softening_sand() {
    blocks_are_the_whole::<f64>(softening, [&[7, 12], &[6]], 1);
    blocks_are_the_whole::<f32>(softening, [&[9], &[]], 2);
}

/// The state at rest of each block, found without the rest of the grid.
fn blocks_at_rest_are_the_whole<R: Precision>(model: fn(usize) -> Model, before: [&[usize]; 2]) {
    let whole = model(R::LANES);
    let state = at_rest_on::<R>(&whole, &whole.ground);
    let cut = Decomposition::cut(&whole.grid, before);
    for number in 0..cut.count() {
        let mut model = model(R::LANES);
        let mut own = at_rest_in_block::<R>(&mut model, cut.own(number));
        own.energy_balance = state.energy_balance;
        assert_same((&whole.grid, &state), (&model.grid, &own));
    }
}

#[test]
fn a_block_finds_its_state_at_rest_alone() {
    /// Heaps under an overburden of other soil, in a grid with open faces.
    fn uneven(lanes: usize) -> Model {
        let mut model = softening(lanes);
        let open = [[true, true], [true, true], [false, false]];
        model.grid = Grid::with_open_faces(model.grid.faces.clone(), open, lanes);
        let stiff = Material { k0: 0.6, density: 2100.0, ..*model.material() };
        model.materials.push(stiff);
        let below = Filling { material: 1, ..below(-0.1) };
        model.ground =
            Ground { fillings: vec![below, common::below(-0.02)], overburden: 100.0, ..Ground::default() };
        model
    }
    blocks_at_rest_are_the_whole::<f64>(uneven, [&[], &[4]]);
    blocks_at_rest_are_the_whole::<f64>(uneven, [&[4, 9, 14], &[4]]);
    blocks_at_rest_are_the_whole::<f32>(uneven, [&[7], &[8]]);
    blocks_at_rest_are_the_whole::<f64>(uneven, [&[7], &[]]);
}
