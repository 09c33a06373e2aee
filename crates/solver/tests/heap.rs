//! A step between two remaps allocates no memory.
#![allow(unsafe_code, clippy::unwrap_used)] // an allocator is unsafe; helpers of tests are not known as tests

mod common;

use common::{below, sand, uniform};
use geometry::Disc;
use glam::DVec3;
use mechanics::{Inertia, Motion, Pose};
use solver::initial::at_rest;
use solver::model::{BodyModel, ContactMethod};
use solver::step::step;
use solver::workspace::Workspace;
use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering};

/// The system's allocator, counting allocations.
struct Counting;

static ASKED: AtomicUsize = AtomicUsize::new(0);

// SAFETY: everything is delegated to the system's allocator.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ASKED.fetch_add(1, Ordering::Relaxed);
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

#[test]
fn a_step_allocates_no_memory() {
    for method in [ContactMethod::Impulse, ContactMethod::Penalty] {
        let mut model = sand([uniform(-0.2, 0.24, 22), uniform(-0.16, 0.16, 16), uniform(-0.12, 0.06, 9)]);
        model.method.contact = method;
        model.bodies.push(BodyModel {
            name: "disc".into(),
            shape: Box::new(Disc { diameter: 0.2, thickness: 0.08 }),
            start: Pose::at(DVec3::new(0.0, 0.0, 0.09)),
            inertia: Inertia::principal(1.0, DVec3::splat(0.005)),
            friction: 0.3,
            adhesion_factor: f64::INFINITY,
            edge_inset: DVec3::splat(0.5),
            fluid: mechanics::Fluid::NONE,
            motion: [
                Motion::Prescribed { before: 0.0, speed: 0.3, start: 0.0, ramp: 0.01, end: f64::INFINITY },
                Motion::Fixed,
                Motion::Free { load: -20.0, support: 0.0, start: 0.0, ramp: 0.01 },
                Motion::Fixed,
                Motion::Fixed,
                Motion::Free { load: 0.0, support: 0.0, start: 0.0, ramp: 0.0 },
            ],
        });
        let mut state = at_rest::<f64>(&model, &below(0.0));
        let mut workspace = Workspace::new(&model, &mut state, 2);
        let (mut steps, mut greedy) = (0, 0);
        for _ in 0..600 {
            let (remaps, asked) = (state.remaps, ASKED.load(Ordering::Relaxed));
            step(&model, &mut state, &mut workspace).unwrap();
            // Memory kept between steps may grow while contact extends.
            if state.remaps == remaps && state.step > 200 {
                steps += 1;
                greedy += usize::from(ASKED.load(Ordering::Relaxed) > asked);
            }
        }
        assert!(state.remaps > 5 && steps > 300, "{} remaps, {steps} steps", state.remaps);
        assert!(state.contacts.len() > 50, "the disc touches the soil");
        assert!(greedy <= steps / 100, "{method:?}: {greedy} of {steps} steps asked for memory");
    }
}
