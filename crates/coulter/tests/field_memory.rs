//! Field files are written as a stream: the memory for them does not grow with the grid.
#![allow(unsafe_code, clippy::unwrap_used)] // an allocator is unsafe; helpers of tests are not known as tests

use coulter::case;
use coulter::output::vtk::FieldSeries;
use coulter::simulation::Simulation;
use solver::halo::Halo;
use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering};

/// The system's allocator, counting what is in use [bytes], and the most that was.
struct Counting;

static IN_USE: AtomicUsize = AtomicUsize::new(0);
static MOST: AtomicUsize = AtomicUsize::new(0);

// SAFETY: everything is delegated to the system's allocator.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let now = IN_USE.fetch_add(layout.size(), Ordering::Relaxed) + layout.size();
        MOST.fetch_max(now, Ordering::Relaxed);
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        IN_USE.fetch_sub(layout.size(), Ordering::Relaxed);
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Cells of the towed disc on cells of this size, and the memory that its field files take to be written
/// [bytes].
fn writing(cell: &str) -> (usize, usize) {
    let text = include_str!("../../../cases/light_disc.toml");
    let case = case::parse(text, "case.toml", &[format!("grid.cell={cell}")]).unwrap();
    let Simulation { model, state, history, .. } = Simulation::<f64>::new(&case);
    let folder = tempfile::tempdir().unwrap();
    let mut series = FieldSeries::create(folder.path()).unwrap();
    let before = IN_USE.load(Ordering::Relaxed);
    MOST.store(before, Ordering::Relaxed);
    series.write(&case, (&model.grid, &Halo::whole()), &state, &history).unwrap();
    (model.grid.cells().iter().product(), MOST.load(Ordering::Relaxed) - before)
}

#[test]
fn the_memory_to_write_fields_does_not_grow_with_the_grid() {
    let (few, small) = writing("25 mm");
    let (many, large) = writing("8 mm");
    println!("{few} cells: {small} bytes, {many} cells: {large} bytes");
    assert!(many > 15 * few, "{few} and {many} cells");
    // The free surface is a number for each column of cells.
    assert!(large < 2 * small && large < many * size_of::<f64>(), "{large} bytes after {small}");
}
