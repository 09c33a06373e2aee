//! The predicted memory of a run agrees with that of the run.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod common;

use common::{below, dense_sand, sand, uniform};
use geometry::{Block, Disc, Shape};
use glam::DVec3;
use mechanics::{Inertia, Motion, Pose};
use solver::footprint::{footprint, surface_points};
use solver::grid::Grid;
use solver::initial::at_rest;
use solver::model::{BodyModel, Model};
use solver::precision::Precision;
use solver::step::step;
use solver::workspace::Workspace;

fn body(shape: Box<dyn Shape>, start: DVec3) -> BodyModel {
    BodyModel {
        name: "body".into(),
        shape,
        start: Pose::at(start),
        inertia: Inertia::principal(1.0, DVec3::splat(0.005)),
        friction: 0.3,
        adhesion_factor: f64::INFINITY,
        edge_inset: DVec3::splat(0.5),
        fluid: mechanics::Fluid::NONE,
        motion: [
            Motion::Prescribed { before: 0.0, speed: 0.3, start: 0.0, ramp: 0.01, end: f64::INFINITY },
            Motion::Fixed,
            Motion::Fixed,
            Motion::Fixed,
            Motion::Fixed,
            Motion::Fixed,
        ],
    }
}

fn model(lanes: usize, shape: Box<dyn Shape>) -> Model {
    let mut model = sand([uniform(-0.2, 0.24, 44), uniform(-0.16, 0.16, 32), uniform(-0.14, 0.06, 20)]);
    model.grid = Grid::padded(model.grid.faces, lanes);
    model.bodies.push(body(shape, DVec3::ZERO));
    model
}

#[track_caller]
fn near(predicted: f64, real: usize, tolerance: f64) {
    assert!((predicted / real as f64 - 1.0).abs() <= tolerance, "predicted {predicted}, in fact {real}");
}

fn assert_predicted<R: Precision>(threads: usize) {
    let shapes: [Box<dyn Shape>; 2] =
        [Box::new(Disc { diameter: 0.16, thickness: 0.08 }), Box::new(Block { size: DVec3::splat(0.12) })];
    for shape in shapes {
        let bare = sand([uniform(-0.2, 0.24, 44), uniform(-0.16, 0.16, 32), uniform(-0.14, 0.06, 20)]);
        let bare = Model { grid: Grid::padded(bare.grid.faces.clone(), R::LANES), ..bare };
        let mut state = at_rest::<R>(&bare, &below(0.0));
        let workspace = Workspace::new(&bare, &mut state, threads);
        let predicted = footprint::<R>(&bare, threads, &[]);
        near(predicted.fields, state.memory(), 1e-9);
        near(predicted.workspace, workspace.memory(), 1e-9);
        assert_eq!((predicted.contact, predicted.layout), (0.0, 0.0));

        let model = model(R::LANES, shape);
        let mut state = at_rest::<R>(&model, &below(0.0));
        let mut workspace = Workspace::new(&model, &mut state, threads);
        while state.remaps < 2 {
            step(&model, &mut state, &mut workspace).unwrap();
        }
        let predicted = footprint::<R>(&model, threads, &[]);
        let fields = state.memory() - size_of_val(state.contacts.as_slice());
        near(predicted.fields, fields, 1e-9);
        let contact = workspace.memory() + state.memory() - fields;
        // The memory of the contact law and temporary copies are predicted, but not counted here.
        let predicted = predicted.workspace + predicted.contact;
        assert!(
            (contact as f64..2.0 * contact as f64).contains(&predicted),
            "predicted {predicted}, kept {contact}"
        );
        let points = surface_points(&model, &model.bodies[0]);
        assert!(state.contacts.len() as f64 > 0.3 * points && state.contacts.len() as f64 <= points);
    }
}

#[test]
fn sand_with_a_characteristic_length_needs_more() {
    for length in [None, Some(0.03)] {
        let mut model = sand([uniform(-0.2, 0.24, 44), uniform(-0.16, 0.16, 32), uniform(-0.14, 0.06, 20)]);
        model.materials = vec![dense_sand(length)];
        let mut state = at_rest::<f64>(&model, &below(0.0));
        let workspace = Workspace::new(&model, &mut state, 2);
        let predicted = footprint::<f64>(&model, 2, &[]);
        near(predicted.fields, state.memory(), 1e-9);
        near(predicted.workspace, workspace.memory(), 1e-9);
    }
}

#[test]
fn predicted_memory_is_that_of_a_run() {
    assert_predicted::<f64>(1);
    assert_predicted::<f64>(2);
    assert_predicted::<f32>(3);
}
