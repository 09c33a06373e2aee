//! The state before the first step: soil at rest under its own weight, bodies where the case puts them.

use super::contact::carve_soil;
use super::remap::lagrange_mass;
use super::{Nodes, Real, Soil, State, energy};
use crate::grid::Grid;
pub use crate::model::Filling;
use crate::model::Model;
use crate::state::{Body, Ledger, Received};
use glam::DVec3;

/// The state at rest of a box of soil.
#[must_use]
pub fn start(model: &Model, filling: &Filling) -> State {
    start_under(model, filling, 0.0)
}

/// The state at rest under a lid that presses on the soil with `overburden` [Pa]. The soil reaches up to it, and the
/// lid of the box, which does not move, bears the pressure from then on.
#[must_use]
pub fn start_under(model: &Model, filling: &Filling, overburden: f64) -> State {
    let mut fraction: Vec<Real> = vec![0.0; model.grid.entries];
    fill(&model.grid, filling, &mut fraction);
    at_rest(model, fraction, overburden)
}

/// The state at rest of soil of any shape: its volume fraction in every cell (see [`Grid::index`]).
#[must_use]
pub fn start_filled(model: &Model, fraction: Vec<Real>) -> State {
    at_rest(model, fraction, 0.0)
}

fn at_rest(model: &Model, fraction: Vec<Real>, overburden: f64) -> State {
    let mut bodies: Vec<Body> = model
        .bodies
        .iter()
        .map(|b| Body {
            position: b.start,
            angle: 0.0,
            velocity: DVec3::ZERO,
            spin: 0.0,
            received: Received::default(),
            leaked_volume: 0.0,
            embedded_volume: 0.0,
            located: (b.start, 0.0),
        })
        .collect();
    let mut soil = Soil { fraction, ..Soil::empty(&model.grid) };
    weigh(model, &mut soil);
    rest_stress(model, &mut soil, overburden);
    carve_soil(model, &mut soil, &mut bodies);
    relieve_void(&mut soil);
    weigh(model, &mut soil);
    let mut nodes = Nodes::at_rest(&model.grid);
    lagrange_mass(&model.grid, &soil.mass, &mut nodes.mass);
    let ledger = Ledger {
        elastic_start: energy::elastic(model, &soil),
        volume_start: energy::soil_volume(&model.grid, &soil),
        ..Ledger::default()
    };
    State { time: 0.0, step: 0, soil, nodes, bodies, contacts: Vec::new(), remaps: 0, ledger }
}

/// Volume fractions of a box of soil.
fn fill(grid: &Grid, filling: &Filling, fraction: &mut [Real]) {
    let [nx, ny, nz] = grid.cells();
    let share = |axis: usize, n: usize| {
        let (low, high) =
            (grid.faces[axis][n].max(filling.low[axis]), grid.faces[axis][n + 1].min(filling.high[axis]));
        let share = ((high - low) / grid.width(axis, n)).clamp(0.0, 1.0);
        // A surface that lies on a face up to rounding lies on it.
        if share < 1e-9 {
            0.0
        } else if share > 1.0 - 1e-9 {
            1.0
        } else {
            share
        }
    };
    for k in 0..nz {
        for j in 0..ny {
            for i in 0..nx {
                fraction[grid.index(i, j, k)] = (share(0, i) * share(1, j) * share(2, k)) as Real;
            }
        }
    }
}

/// No stress where no soil is left.
fn relieve_void(soil: &mut Soil) {
    for (c, fraction) in soil.fraction.iter().enumerate() {
        if *fraction == 0.0 {
            soil.stress.iter_mut().for_each(|component| component[c] = 0.0);
        }
    }
}

fn weigh(model: &Model, soil: &mut Soil) {
    let grid = &model.grid;
    let [nx, ny, nz] = grid.cells();
    for k in 0..nz {
        for j in 0..ny {
            for i in 0..nx {
                let c = grid.index(i, j, k);
                soil.mass[c] = (model.density * f64::from(soil.fraction[c]) * grid.volume(i, j, k)) as Real;
            }
        }
    }
}

/// Stresses at rest: σ_z from the discrete balance of each node, from the top down, `f_k σ_k = f_{k+1} σ_{k+1} −
/// (m_k + m_{k+1}) g / 2A`, so that the first step moves nothing; σ_x = σ_y = K₀ σ_z. Taken before the bodies' space is
/// carved out: soil beside and under a body that starts in it bears what it bore before the body was there.
fn rest_stress(model: &Model, soil: &mut Soil, overburden: f64) {
    let grid = &model.grid;
    let [nx, ny, nz] = grid.cells();
    for j in 0..ny {
        for i in 0..nx {
            let area = grid.width(0, i) * grid.width(1, j);
            let (mut force, mut mass_above) = (0.0, 0.0);
            for k in (0..nz).rev() {
                let c = grid.index(i, j, k);
                let (mass, fraction) = (f64::from(soil.mass[c]), f64::from(soil.fraction[c]));
                force -= 0.5 * (mass + mass_above) * model.gravity;
                mass_above = mass;
                if fraction > 0.0 {
                    let vertical = force / (area * fraction) - overburden;
                    soil.stress[2][c] = vertical as Real;
                    soil.stress[0][c] = (model.rest_pressure_ratio * vertical) as Real;
                    soil.stress[1][c] = soil.stress[0][c];
                }
            }
        }
    }
}
