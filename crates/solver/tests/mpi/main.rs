//! The blocks of a grid in the processes of an MPI run give the same bits as the whole grid in one:
//! `cargo test -p coulter-solver --features mpi --test mpi --no-run`, and what it built under `mpirun -n 3`.
//! In more than four processes only their communication is tested.
#![allow(clippy::unwrap_used)]

#[path = "../common/mod.rs"]
mod common;
#[path = "../blocks/models.rs"]
mod models;

use models::{assert_same, go, impulse, penalty, softening, start, under_water};
use mpi::Threading;
use mpi::topology::SimpleCommunicator;
use mpi::traits::Communicator as _;
use solver::halo::decomposition::Decomposition;
use solver::halo::mpi::World;
use solver::halo::{Communicator as _, Halo};
use solver::model::Model;
use solver::precision::Precision;
use solver::workspace::Workspace;

/// Every process computes the whole grid and its own block, and compares.
fn block_is_the_whole<R: Precision>(model: fn(usize) -> Model, threads: usize) {
    let world = SimpleCommunicator::world();
    let whole = model(R::LANES);
    let mut state = start::<R>(&whole);
    let begin = start::<R>(&whole);
    let mut workspace = Workspace::new(&whole, &mut state, 1);
    go(&whole, &mut state, &mut workspace);
    let [_, ny, nz] = whole.grid.cells();
    // Soil lies low: the cuts are uneven.
    let cost: Vec<f64> = (0..ny * nz).map(|row| if row / ny < 2 * nz / 3 { 1.0 } else { 0.02 }).collect();
    let cut = Decomposition::by_cost(&whole.grid, world.size() as usize, &cost).expect("enough layers");
    let grid = whole.grid.block(cut.own(world.rank() as usize));
    let mut own = begin.of_block(&whole.grid, &grid);
    let model = Model { grid, ..model(R::LANES) };
    let mut workspace =
        Workspace::of_block(&model, &mut own, threads, Halo::of_block(&cut, Box::new(World::default())));
    go(&model, &mut own, &mut workspace);
    assert_same((&whole.grid, &state), (&model.grid, &own));
}

/// All get what each has, in exchanges, gathers and reductions that are under way at once. For so many
/// processes that a gather is left to MPI, too.
fn all_get_what_each_has() {
    let mut line = World::default();
    let (rank, size) = (line.rank(), line.size());
    let values = |rank: usize| vec![rank as f64; rank % 3];
    let counts: Vec<usize> = (0..size).map(|rank| values(rank).len()).collect();
    let others: Vec<usize> = (0..size).filter(|other| *other != rank).collect();
    for turn in 1..=3 {
        let added = rank * turn;
        line.begin_gather(values(rank), &counts);
        line.begin_exchange(
            others.iter().map(|other| (*other, vec![(rank * size + other) as f64])).collect(),
        );
        line.begin_reduction(vec![added as i64, -1], vec![added as f64]);
        let received = line.end_exchange();
        assert!(received.iter().zip(&others).all(|(one, other)| *one == [(other * size + rank) as f64]));
        assert_eq!(line.end_gather(), (0..size).flat_map(values).collect::<Vec<_>>());
        let all = (size - 1) * size / 2 * turn;
        let largest = ((size - 1) * turn) as f64;
        assert_eq!(line.end_reduction(), (vec![all as i64, -(size as i64)], vec![largest]));
    }
}

fn main() {
    let (_universe, _) = mpi::initialize_with_threading(Threading::Serialized).expect("MPI begins");
    std::panic::set_hook(Box::new(|panic| {
        eprintln!("{panic}");
        SimpleCommunicator::world().abort(1);
    }));
    all_get_what_each_has();
    if World::default().size() > 4 {
        return;
    }
    block_is_the_whole::<f64>(impulse, 1);
    block_is_the_whole::<f64>(penalty, 2);
    block_is_the_whole::<f64>(softening, 1);
    block_is_the_whole::<f64>(under_water, 1);
    block_is_the_whole::<f32>(impulse, 2);
    block_is_the_whole::<f32>(under_water, 1);
    if SimpleCommunicator::world().rank() == 0 {
        println!("{} processes: the same bits as one", SimpleCommunicator::world().size());
    }
}
