//! Cells that are not cubes: a linear velocity field has no hourglass forces, waves keep their speed along
//! every axis and are damped as in cubes of the same width along it, sand stays at rest, and a step of the
//! longer length is stable.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod common;

use common::{below, sand, uniform};
use glam::DVec3;
use physics::elastic::Elastic;
use solver::grid::Grid;
use solver::initial::at_rest;
use solver::material::Material;
use solver::model::{Method, Model};
use solver::state::State;
use solver::step::step;
use solver::workspace::Workspace;

const ASPECTS: [DVec3; 4] =
    [DVec3::ONE, DVec3::new(3.0, 3.0, 1.0), DVec3::new(1.0, 1.0, 3.0), DVec3::new(3.0, 1.0, 2.0)];

/// Cells of an aspect with the smallest width `h` [m], graded in addition where `growth` is above 1.
fn faces(cells: [usize; 3], aspect: DVec3, h: f64, growth: f64) -> [Vec<f64>; 3] {
    std::array::from_fn(|axis| {
        let mut faces = vec![0.0];
        let mut width = h * aspect[axis];
        for _ in 0..cells[axis] {
            faces.push(faces[faces.len() - 1] + width);
            width *= growth;
        }
        faces
    })
}

#[test]
fn a_linear_velocity_field_on_graded_flat_cells_has_no_hourglass_force() {
    for aspect in ASPECTS {
        let grid = Grid::new(faces([8, 7, 6], aspect, 0.01, 1.2)).with_aspect(aspect);
        let method = Method { hourglass: 1.0, bulk_viscosity: [0.0; 2], ..Method::default() };
        let model =
            Model { method, ..Model::bare(grid, Material::linear_elastic(Elastic::new(5e6, 0.3), 1600.0)) };
        let mut state = at_rest::<f64>(&model, &below(1e3));
        let gradient =
            [[3.0, -1.0, 2.0], [0.5, -2.0, 1.0], [-1.0, 4.0, 1.5]].map(|row| row.map(|g| 1e-3 * g));
        let field = |[i, j, k]: [usize; 3], q: usize| {
            let x = [model.grid.faces[0][i], model.grid.faces[1][j], model.grid.faces[2][k]];
            (0..3).map(|axis| gradient[q][axis] * x[axis]).sum::<f64>()
        };
        let nodes = || (0..9 * 8 * 7).map(|n| [n % 9, n / 9 % 8, n / 72]);
        for [i, j, k] in nodes() {
            for q in 0..3 {
                state.nodes.velocity[q][model.grid.index(i, j, k)] = field([i, j, k], q);
            }
        }
        let mut workspace = Workspace::new(&model, &mut state, 1);
        step(&model, &mut state, &mut workspace).unwrap();
        // The stress is uniform: inside nothing is accelerated but by hourglass forces.
        let inner = nodes().filter(|n| (0..3).all(|a| n[a] > 1 && n[a] + 2 < [9, 8, 7][a]));
        for node in inner {
            for q in 0..3 {
                let v = state.nodes.velocity[q][model.grid.index(node[0], node[1], node[2])];
                assert!((v - field(node, q)).abs() < 1e-12, "{aspect}: {v} at {node:?}");
            }
        }
    }
}

/// Speed of a pulse along an axis over √(M/ρ), and its energy at the end over that at the start.
fn pulse(aspect: DVec3, axis: usize, bulk_viscosity: [f64; 2]) -> [f64; 2] {
    const CELLS: usize = 120;
    let mut cells = [1; 3];
    cells[axis] = CELLS;
    let grid = Grid::new(faces(cells, aspect, 0.01, 1.0)).with_aspect(aspect);
    let method = Method { hourglass: 0.0, bulk_viscosity, ..Method::default() };
    let material = Material::linear_elastic(Elastic::new(20e6, 0.3), 1600.0);
    let model = Model { method, ..Model::bare(grid, material) };
    let mut state = at_rest::<f64>(&model, &below(1e3));
    let (along, width) = (model.grid.faces[axis].clone(), 0.01 * aspect[axis]);
    let (c, dt, elastic) = (model.wave_speed(), model.time_step(), model.material().elastic);
    let shape = |x: f64| 1e-6 * (-0.5 * ((x / width - 30.0) / 6.0).powi(2)).exp();
    let [a, b] = [(axis + 1) % 3, (axis + 2) % 3];
    let at = |n: usize, p: usize, q: usize| {
        let mut layers = [0; 3];
        (layers[axis], layers[a], layers[b]) = (n, p, q);
        model.grid.index(layers[0], layers[1], layers[2])
    };
    for n in 0..=CELLS {
        for (p, q) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
            state.nodes.velocity[axis][at(n, p, q)] = shape(along[n] - 0.5 * c * dt);
        }
        if n < CELLS {
            let stress = -1600.0 * c * shape(model.grid.centre(axis, n));
            let lateral = stress * (elastic.bulk - 2.0 / 3.0 * elastic.shear) / elastic.constrained();
            for q in 0..3 {
                state.soil.stress[q][at(n, 0, 0)] = if q == axis { stress } else { lateral };
            }
        }
    }
    let measure = |state: &State| {
        let energy = |n: usize| state.nodes.velocity[axis][at(n, 0, 0)].powi(2);
        let all = (0..=CELLS).map(energy).sum::<f64>();
        [(0..=CELLS).map(|n| energy(n) * along[n]).sum::<f64>() / all, all]
    };
    let [begin, energy] = measure(&state);
    let mut workspace = Workspace::new(&model, &mut state, 1);
    let steps = (60.0 * width / (c * dt)).round();
    for _ in 0..steps as usize {
        step(&model, &mut state, &mut workspace).unwrap();
    }
    let [end, left] = measure(&state);
    [(end - begin) / (steps * dt) / c, left / energy]
}

#[test]
fn waves_along_the_short_and_the_long_side_keep_their_speed_and_damping() {
    let in_cubes = pulse(DVec3::ONE, 0, [0.02, 1.2]);
    for aspect in ASPECTS {
        for axis in 0..3 {
            let [speed, energy] = pulse(aspect, axis, [0.02, 1.2]);
            println!("{aspect} axis {axis}: speed {speed:.5}, energy {energy:.5}, in cubes {in_cubes:?}");
            assert!((speed - 1.0).abs() < 5e-3, "{aspect}, axis {axis}: {speed}");
            assert!((energy - in_cubes[1]).abs() < 5e-3, "{aspect}, axis {axis}: {energy}, {in_cubes:?}");
        }
    }
}

#[test]
fn sand_stays_at_rest_in_flat_cells() {
    for aspect in ASPECTS {
        for surface in [0.4, 0.425, 0.4005] {
            for every_step in [false, true] {
                let across = |axis: usize| uniform(0.0, 0.05 * 5.0 * aspect[axis], 5);
                let mut model = sand([across(0), across(1), uniform(0.0, 0.05 * aspect.z * 10.0, 10)]);
                model.grid = model.grid.with_aspect(aspect);
                if every_step {
                    model.method.remap_displacement = -1.0;
                }
                let mut state = at_rest::<f64>(&model, &below(surface));
                let mut workspace = Workspace::new(&model, &mut state, 1);
                for _ in 0..500 {
                    step(&model, &mut state, &mut workspace).unwrap();
                }
                let speed = state.nodes.velocity.iter().flatten().fold(0.0, |a: f64, v| v.abs().max(a));
                assert!(speed < 1e-12, "{aspect}: {speed:e} m/s, surface {surface} m, remap {every_step}");
            }
        }
    }
}

/// Energy of random velocities after many steps over that at the start, without any viscosity.
fn energy_kept(aspect: DVec3, courant: f64) -> f64 {
    let grid = Grid::new(faces([8, 8, 8], aspect, 0.01, 1.0)).with_aspect(aspect);
    let method = Method { courant, hourglass: 0.0, bulk_viscosity: [0.0; 2], ..Method::default() };
    let material = Material::linear_elastic(Elastic::new(20e6, 0.45), 1600.0);
    let model = Model { method, ..Model::bare(grid, material) };
    let mut state = at_rest::<f64>(&model, &below(1e3));
    let mut seed = 1_u32;
    for v in state.nodes.velocity.iter_mut().flatten() {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        *v = 1e-9 * (f64::from(seed >> 8) / 2.0_f64.powi(24) - 0.5);
    }
    let mut workspace = Workspace::new(&model, &mut state, 1);
    let energy = |state: &State| state.nodes.velocity.iter().flatten().map(|v| v * v).sum::<f64>();
    step(&model, &mut state, &mut workspace).unwrap();
    let before = energy(&state);
    for _ in 0..2000 {
        step(&model, &mut state, &mut workspace).unwrap();
    }
    energy(&state) / before
}

#[test]
fn the_longer_step_of_flat_cells_is_stable() {
    for aspect in ASPECTS {
        let kept = energy_kept(aspect, 0.5);
        println!("{aspect}: {kept}");
        assert!(kept < 1.5, "{aspect}: {kept}");
    }
}
