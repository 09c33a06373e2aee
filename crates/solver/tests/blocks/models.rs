//! Models whose bodies lie across the cuts between blocks, and what of a block must be equal to the whole.
#![allow(dead_code, unreachable_pub, clippy::unwrap_used)]

use super::common::{below, dense_sand, sand, uniform};
use geometry::{Block, Disc, Shape};
use glam::DVec3;
use mechanics::{Inertia, Motion, Pose};
use solver::boundary::Boundary;
use solver::grid::Grid;
use solver::halo::Halo;
use solver::initial::{at_rest, set_in_motion};
use solver::model::{BodyModel, ContactMethod, Ground, Model, PoreWater};
use solver::precision::Precision;
use solver::state::State;
use solver::step::step;
use solver::workspace::Workspace;

pub const STEPS: usize = 160;

pub fn body(name: &str, shape: Box<dyn Shape>, start: DVec3) -> BodyModel {
    let free = |load| Motion::Free { load, support: 0.0, start: 0.0, ramp: 0.005 };
    BodyModel {
        name: name.into(),
        shape,
        start: Pose::at(start),
        inertia: Inertia::principal(2.0, DVec3::splat(0.01)),
        friction: 0.3,
        adhesion_factor: f64::INFINITY,
        edge_inset: DVec3::splat(0.5),
        fluid: mechanics::Fluid::NONE,
        motion: [
            Motion::Prescribed { before: 0.0, speed: 0.4, start: 0.0, ramp: 0.01, end: f64::INFINITY },
            Motion::Fixed,
            free(-30.0),
            Motion::Fixed,
            Motion::Fixed,
            free(0.0),
        ],
    }
}

/// A towed disc and a towed block in moving sand, both across the boundaries of grid blocks.
pub fn model(contact: ContactMethod, lanes: usize) -> Model {
    let mut model = sand([uniform(-0.2, 0.26, 23), uniform(-0.2, 0.2, 20), uniform(-0.16, 0.08, 12)]);
    model.grid = Grid::padded(model.grid.faces.clone(), lanes);
    model.method.contact = contact;
    model.method.remap_displacement = 0.02;
    let disc = Box::new(Disc { diameter: 0.2, thickness: 0.08 });
    model.bodies.push(body("disc", disc, DVec3::new(-0.04, -0.03, 0.08)));
    let block = Box::new(Block { size: DVec3::new(0.08, 0.1, 0.06) });
    model.bodies.push(body("block", block, DVec3::new(0.12, 0.11, 0.01)));
    model
}

pub fn impulse(lanes: usize) -> Model {
    model(ContactMethod::Impulse, lanes)
}

pub fn penalty(lanes: usize) -> Model {
    model(ContactMethod::Penalty, lanes)
}

/// The same with sides at constant stress.
pub fn yielding(lanes: usize) -> Model {
    let mut model = impulse(lanes);
    model.boundaries.0[0] = [Boundary::ConstantStress; 2];
    model.boundaries.0[1] = [Boundary::ConstantStress; 2];
    model.grid = Grid::with_open_faces(model.grid.faces.clone(), model.boundaries.open_faces(), lanes);
    model.ground = Ground { fillings: vec![below(0.0)], ..Ground::default() };
    model
}

/// The same in dense sand with a characteristic length of two cells and a half.
pub fn softening(lanes: usize) -> Model {
    let mut model = impulse(lanes);
    model.materials = vec![dense_sand(Some(0.05))];
    model
}

/// The same under water whose pressure is computed.
pub fn under_water(lanes: usize) -> Model {
    let mut model = softening(lanes);
    model.pore_water = Some(PoreWater { permeability: 2e-4, unit_weight: 1e4, level: 1.0 });
    model
}

pub fn start<R: Precision>(model: &Model) -> State<R> {
    let mut state = at_rest::<R>(model, &below(0.0));
    set_in_motion(model, &mut state, DVec3::new(0.05, 0.1, 0.02), &Halo::whole());
    state
}

pub fn go<R: Precision>(model: &Model, state: &mut State<R>, workspace: &mut Workspace<R>) {
    for _ in 0..STEPS {
        step(model, state, workspace).unwrap();
    }
}

/// Asserts that a block holds the same values as the whole grid where it owns cells and nodes.
pub fn assert_same<R: Precision>(whole: (&Grid, &State<R>), block: (&Grid, &State<R>)) {
    let (grid, own) = (block.0, block.1.soil.arrays().zip(whole.1.soil.arrays()));
    let nodes = block.1.nodes.arrays().zip(whole.1.nodes.arrays());
    let each = own.map(|pair| (0, pair)).chain(nodes.map(|pair| (1, pair)));
    for (number, (beyond, (part, all))) in each.enumerate() {
        for k in grid.own[2].start..grid.own[2].end + beyond {
            for j in grid.own[1].start..grid.own[1].end + beyond {
                for i in 0..grid.cells()[0] + beyond {
                    let here = grid.index(i, j - grid.first[1], k - grid.first[2]);
                    let there = whole.0.index(i, j, k);
                    assert_eq!(part[here], all[there], "array {number}, layers {i} {j} {k}");
                }
            }
        }
    }
    assert_eq!(block.1.bodies, whole.1.bodies);
    assert_eq!(block.1.contacts, whole.1.contacts);
    assert_eq!(block.1.energy_balance, whole.1.energy_balance);
    assert_eq!((block.1.remaps, block.1.time), (whole.1.remaps, whole.1.time));
}
