//! F1: friction on faces that slide along sand.

use crate::error::VerifyError;
use crate::runner::Runner;
use geometry::{Axis, Block, Cylinder, Shape};
use glam::{DQuat, DVec3};
use mechanics::{Inertia, Motion, Pose};
use physics::elastic::Elastic;
use physics::law::Law;
use physics::mohr_coulomb::MohrCoulomb;
use solver::grid::Grid;
use solver::initial::{Filling, at_rest};
use solver::material::Material;
use solver::model::{BodyModel, Model};
use solver::state::State;
use solver::step::step;
use solver::workspace::Workspace;
use std::time::Instant;

const FRICTION: f64 = 0.3;
/// Speed of the face along itself [m/s].
const SPEED: f64 = 0.1;
/// Speed into the soil over that along the face.
const PUSH: f64 = 0.1;
/// Time at which all of the face slides, and end of the run [s].
const READ: [f64; 2] = [0.15, 0.25];
/// Radius of the drum [m].
const RADIUS: f64 = 0.2;

/// The face, with the slope of a flat one to the vertical [°].
#[derive(Clone, Copy)]
enum Face {
    Flat(f64),
    Drum,
}

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    let faces = [
        ("flat, 30°", Face::Flat(30.0)),
        ("flat, 45°", Face::Flat(45.0)),
        ("flat, 60°", Face::Flat(60.0)),
        ("drum", Face::Drum),
    ];
    for (name, face) in faces {
        for cell in [25.0, 12.5, 6.25] {
            let variant = format!("{name}, h = {cell} mm");
            if runner.wants("F1", &variant)? {
                slide(runner, &variant, face, 1e-3 * cell)?;
            }
        }
    }
    Ok(())
}

fn slide(runner: &mut Runner, variant: &str, face: Face, cell: f64) -> Result<(), VerifyError> {
    let clock = Instant::now();
    let model = model(face, cell);
    let below = Filling::between(DVec3::splat(f64::NEG_INFINITY), DVec3::INFINITY.with_z(0.0));
    let mut state = at_rest::<f64>(&model, &below);
    let mut workspace = Workspace::new(&model, &mut state, 1);
    let mut sums = [0.0; 3];
    while state.time < runner.lasting(READ[1]) {
        step(&model, &mut state, &mut workspace)?;
        if state.time > READ[0] {
            for (sum, now) in sums.iter_mut().zip(impulses(&state)) {
                *sum += now;
            }
        }
    }
    let seconds = clock.elapsed().as_secs_f64();
    runner.report_progress(&format!("F1: {variant}, {} steps in {seconds:.1} s", state.step));
    let [_, friction, against] = sums.map(|sum| sum / sums[0] / FRICTION);
    let figures = [("friction over μ N", friction), ("friction against the motion over μ N", against)];
    runner.put("F1", variant, seconds, &figures)
}

/// Of the last step, summed over the contact points: normal impulse, tangential impulse, and its component
/// against the motion.
fn impulses(state: &State) -> [f64; 3] {
    let twist = state.twist(0);
    let each = state.contacts.iter().map(|contact| {
        let normal = contact.normal.dot(contact.impulse);
        let tangential = contact.impulse - normal * contact.normal;
        let velocity = twist.at(contact.arm);
        let along = (velocity - velocity.dot(contact.normal) * contact.normal).normalize_or_zero();
        [normal.abs(), tangential.length(), tangential.dot(along).abs()]
    });
    each.fold([0.0; 3], |sum, one| std::array::from_fn(|n| sum[n] + one[n]))
}

/// A slab of sand one cell thick, and the body with the face.
fn model(face: Face, cell: f64) -> Model {
    let elastic = Elastic::new(5e6, 0.3);
    let law = MohrCoulomb::new(elastic, 35_f64.to_radians(), 0.0, 0.0, 0.0);
    let material = Material {
        yield_law: Some(Law::MohrCoulomb(law)),
        k0: 0.43,
        strength: None,
        density_profile: None,
        ..Material::linear_elastic(elastic, 1600.0)
    };
    let faces = |low: f64, high: f64| {
        let cells = ((high - low) / cell).round() as i32;
        (0..=cells).map(|n| low + cell * f64::from(n)).collect::<Vec<_>>()
    };
    let grid = Grid::new([faces(-0.3, 0.6), vec![0.0, cell], faces(-0.4, 0.15)]);
    let mut model = Model { gravity: 9.81, soil_gravity: 9.81, ..Model::bare(grid, material) };
    model.bodies.push(body(face, 0.5 * cell));
    model
}

/// The body, in the middle `y` of the slab [m]: a block of which one face slides along itself, everything
/// beyond it filled by the block; or a drum that turns in its place.
fn body(face: Face, y: f64) -> BodyModel {
    let moving =
        |speed: f64| Motion::Prescribed { before: 0.0, speed, start: 0.0, ramp: 0.05, end: f64::INFINITY };
    let (shape, start, velocity, spin): (Box<dyn Shape>, _, _, _) = match face {
        Face::Flat(slope) => {
            let (sin, cos) = slope.to_radians().sin_cos();
            let (normal, along) = (DVec3::new(cos, 0.0, -sin), DVec3::new(sin, 0.0, cos));
            let size = DVec3::new(1.5, 1.0, 4.0);
            let position = DVec3::new(0.0, y, -0.15) - 0.5 * size.x * normal;
            let start = Pose { position, rotation: DQuat::from_rotation_y(slope.to_radians()) };
            (Box::new(Block { size }), start, SPEED * (along + PUSH * normal), Motion::Fixed)
        }
        Face::Drum => {
            let start = Pose::at(DVec3::new(0.1, y, 0.5 * RADIUS));
            let shape = Cylinder { diameter: 2.0 * RADIUS, length: 1.0, axis: Axis::Y };
            (Box::new(shape), start, -PUSH * SPEED * DVec3::Z, moving(SPEED / RADIUS))
        }
    };
    let [x, z] = [velocity.x, velocity.z].map(moving);
    BodyModel {
        name: "body".into(),
        shape,
        start,
        inertia: Inertia::NONE,
        motion: [x, Motion::Fixed, z, Motion::Fixed, Motion::Fixed, spin],
        friction: FRICTION,
        adhesion_factor: f64::INFINITY,
        edge_inset: DVec3::splat(0.5),
        fluid: mechanics::Fluid::NONE,
    }
}
