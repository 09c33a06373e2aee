//! Contact points from a shape's mesh serve like those that the shape lays out itself.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod common;

use common::{below, sand, uniform};
use geometry::{Block, Disc, Mesh, Shape};
use glam::DVec3;
use mechanics::{Inertia, Motion, Pose};
use solver::initial::at_rest;
use solver::model::BodyModel;
use solver::step::step;
use solver::workspace::Workspace;

/// A shape of which only the distance and the mesh are known.
#[derive(Debug)]
struct Sampled<S>(S);

impl<S: Shape> Shape for Sampled<S> {
    fn signed_distance(&self, x: DVec3) -> f64 {
        self.0.signed_distance(x)
    }

    fn is_revolved(&self) -> bool {
        self.0.is_revolved()
    }

    fn mesh(&self) -> Mesh {
        self.0.mesh()
    }
}

/// Impulses of pressure and of friction on a body that is pressed into sand and towed.
fn towed(shape: Box<dyn Shape>) -> [DVec3; 2] {
    let mut model = sand([uniform(-0.2, 0.24, 22), uniform(-0.16, 0.16, 16), uniform(-0.12, 0.06, 9)]);
    let moving =
        |speed: f64| Motion::Prescribed { before: 0.0, speed, start: 0.0, ramp: 0.002, end: f64::INFINITY };
    let start = Pose::at(DVec3::new(0.0, 0.0, shape.bounds().1.z - 0.015));
    model.bodies.push(BodyModel {
        name: "body".into(),
        shape,
        start,
        inertia: Inertia::principal(1.0, DVec3::splat(0.005)),
        friction: 0.3,
        adhesion_factor: f64::INFINITY,
        edge_inset: DVec3::splat(0.5),
        fluid: mechanics::Fluid::NONE,
        motion: [moving(0.3), Motion::Fixed, moving(-0.15), Motion::Fixed, Motion::Fixed, Motion::FREE],
    });
    let mut state = at_rest::<f64>(&model, &below(0.0));
    let mut workspace = Workspace::new(&model, &mut state, 1);
    for _ in 0..500 {
        step(&model, &mut state, &mut workspace).unwrap();
    }
    let impulse = state.bodies[0].contact_impulse;
    [impulse.normal, impulse.friction]
}

#[test]
fn contact_points_from_the_mesh_serve_as_well() {
    let disc = Disc { diameter: 0.2, thickness: 0.08 };
    let block = Block { size: DVec3::new(0.16, 0.08, 0.12) };
    let pairs: [[Box<dyn Shape>; 2]; 2] =
        [[Box::new(disc), Box::new(Sampled(disc))], [Box::new(block), Box::new(Sampled(block))]];
    for [own, sampled] in pairs {
        let name = format!("{own:?}");
        let ([normal, friction], [as_normal, as_friction]) = (towed(own), towed(sampled));
        let apart = [(normal - as_normal).length(), (friction - as_friction).length()];
        let relative = apart.map(|x| x / normal.length());
        assert!(relative.iter().all(|x| *x < 0.02), "{name}: {relative:?}");
    }
}
