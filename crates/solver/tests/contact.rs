//! A disc pushed into sand and towed: no soil remains inside it, none is lost, and its mirror image behaves
//! alike.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod common;

use common::{below, sand, uniform};
use geometry::Disc;
use glam::DVec3;
use mechanics::{Inertia, Motion, Pose};
use solver::energy::soil_mass;
use solver::grid::Grid;
use solver::halo::Halo;
use solver::initial::at_rest;
use solver::model::{BodyModel, ContactMethod, Model};
use solver::state::{RimSums, State};
use solver::step::step;
use solver::workspace::Workspace;

fn moving(speed: f64) -> Motion {
    Motion::Prescribed { before: 0.0, speed, start: 0.0, ramp: 0.01, end: f64::INFINITY }
}

/// The state after a number of steps, with the disc's centre at `y` [m].
fn towed(method: ContactMethod, y: f64, steps: usize) -> (Model, State) {
    // Mirror-symmetric faces, to the bit.
    let across = (-8..=8).map(|n| 0.02 * f64::from(n)).collect();
    let mut model = sand([uniform(-0.2, 0.24, 22), across, uniform(-0.12, 0.06, 9)]);
    model.method.contact = method;
    let disc = Disc { diameter: 0.2, thickness: 0.08 };
    model.bodies.push(BodyModel {
        name: "disc".into(),
        shape: Box::new(disc),
        start: Pose::at(DVec3::new(0.0, y, 0.1)),
        inertia: Inertia::principal(1.0, DVec3::splat(0.005)),
        friction: 0.3,
        adhesion_factor: f64::INFINITY,
        edge_inset: DVec3::splat(0.5),
        fluid: mechanics::Fluid::NONE,
        motion: [
            moving(0.3),
            Motion::Fixed,
            moving(-0.15),
            Motion::Fixed,
            Motion::Fixed,
            Motion::Free { load: 0.0, support: 0.0, start: 0.0, ramp: 0.0 },
        ],
    });
    let mut state = at_rest(&model, &below(0.0));
    let mut workspace = Workspace::new(&model, &mut state, 1);
    for _ in 0..steps {
        step(&model, &mut state, &mut workspace).unwrap();
    }
    (model, state)
}

#[test]
fn no_soil_remains_in_the_body_and_none_is_lost() {
    for method in [ContactMethod::Impulse, ContactMethod::Penalty] {
        let (model, state) = towed(method, 0.0, 800);
        let body = &state.bodies[0];
        assert!(body.embedded_volume > 5e-5, "{method:?}: the disc is in the sand");
        let leak = body.leaked_volume / body.embedded_volume;
        assert!(leak < 1e-3, "{method:?}: {leak:e} of the embedded volume is soil");
        let before = model.material().density * state.energy_balance.volume_start;
        let mass = soil_mass(&model.grid, &state.soil, &Halo::whole()) + state.energy_balance.debris_mass;
        assert!((mass / before - 1.0).abs() < 1e-12, "{method:?}: {mass} kg of {before} kg");
    }
}

#[test]
fn a_mirrored_case_gives_mirrored_results() {
    let (left, right) =
        (towed(ContactMethod::Impulse, -0.007, 300), towed(ContactMethod::Impulse, 0.007, 300));
    let grid: &Grid = &left.0.grid;
    let [nx, ny, nz] = grid.cells();
    for (i, j, k) in (0..nx * ny * nz).map(|n| (n % nx, n / nx % ny, n / nx / ny)) {
        let (cell, image) = (grid.index(i, j, k), grid.index(i, ny - 1 - j, k));
        assert_eq!(left.1.soil.fraction[cell], right.1.soil.fraction[image], "cell {i} {j} {k}");
    }
    assert_eq!(left.1.twist(0).angular.y, right.1.twist(0).angular.y);
}

#[test]
fn stresses_along_the_rim_add_up_to_the_force() {
    for method in [ContactMethod::Impulse, ContactMethod::Penalty] {
        let (model, mut state) = towed(method, 0.0, 400);
        let workspace = Workspace::new(&model, &mut state, 1);
        let bins = workspace.rims().next().unwrap();
        let body = &state.bodies[0];
        let (flanks, rim) = body.rim.split_last().unwrap();
        assert_eq!(rim.len(), bins.len());
        let force = body.contact_impulse.normal + body.contact_impulse.friction;
        let of_rim: DVec3 = rim.iter().map(|sums| sums.impulse).sum();
        let error = (of_rim + flanks.impulse - force).length() / force.length();
        assert!(error < 1e-12, "{method:?}: rim and flanks miss {error:e} of the force");
        // Normal stress and shear stress along the outline, with the directions of each bin.
        let from_stress = rim.iter().zip(bins).map(|(sums, bin)| {
            let (sin, cos) = bin.middle.angle.sin_cos();
            DVec3::new(cos, 0.0, sin) * sums.shear[0] - DVec3::new(sin, 0.0, -cos) * sums.normal
        });
        let error = (from_stress.sum::<DVec3>() - of_rim.with_y(0.0)).length() / of_rim.length();
        assert!(error < 0.01, "{method:?}: stresses miss {error} of the force on the rim");
        let [normal, friction, limit] =
            [|s: &RimSums| s.normal, |s: &RimSums| s.friction, |s: &RimSums| s.friction_limit]
                .map(|of| rim.iter().map(of).sum::<f64>());
        assert!((limit / (0.3 * normal) - 1.0).abs() < 1e-9 && friction <= limit * (1.0 + 1e-9));
        // The disc is towed forwards: pressed in front and below, not behind.
        let behind: f64 =
            rim.iter().zip(bins).filter(|(_, b)| b.middle.angle < -0.6).map(|(s, _)| s.normal).sum();
        assert!(behind < 0.02 * normal, "{method:?}: {behind} of {normal} N s acts behind");
        let area: f64 = bins.iter().map(|bin| bin.area).sum();
        assert!((area / (std::f64::consts::PI * 0.2 * 0.08) - 1.0).abs() < 1e-9, "{area}");
    }
}
