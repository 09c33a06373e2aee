//! Runs of every kind on a grid in blocks, each on its own thread: the same bits, and the same history in
//! each block.

use super::quantities;
use super::set_ups::{SET_UPS, SetUp};
use coulter::blocks::TooManyBlocks;
use coulter::history::History;
use coulter::simulation::Simulation;
use solver::grid::Grid;
use solver::halo::in_process::communicators;
use solver::precision::Precision;
use solver::state::State;

/// What is left of a block: its grid, its state, the history, and heights of the ground.
type Block<R> = (Grid, State<R>, History, Vec<Option<f64>>);

/// Heights of the ground at places in the grid and beyond it.
fn ground<R: Precision>(simulation: &Simulation<R>) -> Vec<Option<f64>> {
    let steps = || (-8..=8).map(|n| 0.03 * f64::from(n));
    let places: Vec<[f64; 2]> = steps().flat_map(|x| steps().map(move |y| [x, y])).collect();
    simulation.ground(&places)
}

/// Runs a set-up to so many steps, with a sample of the history before the last.
fn run<R: Precision>(simulation: &mut Simulation<R>, steps: u32) {
    let first = (steps / 2).max(1);
    simulation.steps(first).unwrap();
    simulation.advance().unwrap();
    simulation.steps(steps - first).unwrap();
}

fn in_blocks<R: Precision>(set_up: &SetUp, count: usize) -> Result<Vec<Block<R>>, TooManyBlocks> {
    std::thread::scope(|scope| {
        let threads: Vec<_> = communicators(count)
            .into_iter()
            .map(|communicator| {
                scope.spawn(move || {
                    let mut own = Simulation::<R>::of_block(&set_up.read(), Box::new(communicator))?;
                    run(&mut own, set_up.steps);
                    let ground = ground(&own);
                    Ok((own.model.grid, own.state, own.history, ground))
                })
            })
            .collect();
        threads.into_iter().map(|thread| thread.join().expect("no block fails")).collect()
    })
}

/// Compares a run with one in blocks; returns whether the grid has layers enough for these.
fn is_same<R: Precision>(set_up: &SetUp, counts: &[usize]) -> Vec<bool> {
    let mut whole = Simulation::<R>::new(&set_up.read());
    run(&mut whole, set_up.steps);
    let grid = &whole.model.grid;
    let expected = quantities(&whole.model, grid, &whole.state);
    let compare = |count: &usize| {
        let Ok(blocks) = in_blocks::<R>(set_up, *count) else { return false };
        let mut joined = blocks[0].1.without_soil(grid);
        for (own, state, history, heights) in &blocks {
            joined.take_over(grid, state, own);
            assert_eq!(history, &whole.history, "{}: {count} blocks", set_up.name);
            assert_eq!(heights, &ground(&whole), "{}: {count} blocks", set_up.name);
        }
        let found = quantities(&whole.model, grid, &joined);
        let differ: Vec<_> = found.iter().zip(&expected).filter(|(a, b)| a != b).map(|(a, _)| &a.0).collect();
        assert!(differ.is_empty(), "{}, {count} blocks: {differ:?}", set_up.name);
        true
    };
    counts.iter().map(compare).collect()
}

/// Every set-up in 2, 3 or 4 blocks, in turn; with `COULTER_ALL_BLOCKS=1` in each of these numbers.
#[test]
fn blocks_change_no_bit() {
    let counts = [2, 3, 4];
    let all = std::env::var_os("COULTER_ALL_BLOCKS").is_some();
    let mut compared = 0;
    for (n, set_up) in SET_UPS.iter().enumerate() {
        let counts = if all { &counts[..] } else { &counts[n % 3..=n % 3] };
        let done =
            if set_up.is_single() { is_same::<f32>(set_up, counts) } else { is_same::<f64>(set_up, counts) };
        compared += done.iter().filter(|done| **done).count();
    }
    // Grids of plane strain have one layer along y and, coarse as they are here, few along z.
    assert!(compared >= if all { 60 } else { 20 }, "{compared}");
}
