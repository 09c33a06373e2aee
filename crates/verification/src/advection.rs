//! Advection of a shape through the unit box by a prescribed motion of the nodes, remap by remap.

use glam::DVec3;
use physics::elastic::Elastic;
use solver::grid::Grid;
use solver::initial::{Filling, at_rest};
use solver::material::Material;
use solver::model::Model;
use solver::remap::remap;
use solver::state::State;
use solver::workspace::Workspace;
use std::f64::consts::PI;
use std::time::Instant;

/// A motion of the unit box (or of a slab of it).
pub(crate) struct Flow {
    pub(crate) box_cells: [usize; 3],
    /// Duration.
    pub(crate) period: f64,
    /// Whether the flow is multiplied by cos(πt/T), so that everything returns to where it started.
    pub(crate) returns: bool,
    pub(crate) velocity: fn(DVec3) -> DVec3,
    /// Largest displacement between two remaps, in cells.
    pub(crate) cells_per_remap: f64,
}

/// The result of an advection.
pub(crate) struct Advected {
    pub(crate) model: Model,
    state: State,
    /// Soil volume before and after [m³], and that of the VOF debris that was removed.
    pub(crate) before: f64,
    after: f64,
    pub(crate) debris: f64,
    /// Largest excess of a volume fraction beyond 0 or 1.
    pub(crate) beyond: f64,
    pub(crate) seconds: f64,
}

impl Advected {
    pub(crate) fn volume_change(&self) -> f64 {
        ((self.after + self.debris) - self.before).abs() / self.before
    }

    /// Σ|f − f_shape| V [m³].
    pub(crate) fn distance(&self, inside: impl Fn(DVec3) -> bool) -> f64 {
        let mut exact = vec![0.0; self.model.grid.entries];
        fill(&self.model.grid, inside, &mut exact);
        let of = |c: usize, volume: f64| (self.state.soil.fraction[c] - exact[c]).abs() * volume;
        over_cells(&self.model.grid, of)
    }
}

/// Advects a shape with a flow.
pub(crate) fn advect(flow: &Flow, inside: impl Fn(DVec3) -> bool) -> Advected {
    let clock = Instant::now();
    let model = unit_box(flow.box_cells);
    let grid = &model.grid;
    let mut state = at_rest(&model, &Filling::between(DVec3::ZERO, DVec3::ZERO));
    fill(grid, inside, &mut state.soil.fraction);
    for c in 0..grid.entries {
        state.soil.mass[c] = model.material().density * state.soil.fraction[c] * grid.finest().powi(3);
    }
    let mut workspace = Workspace::new(&model, &mut state, 1);
    let volume = |state: &State| over_cells(grid, |c, volume| state.soil.fraction[c] * volume);
    let before = volume(&state);
    let mut beyond = 0.0_f64;
    let steps = (flow.period * fastest(flow, grid) / (flow.cells_per_remap * grid.finest())).ceil();
    let dt = flow.period / steps;
    for n in 0..steps as usize {
        let middle = (n as f64 + 0.5) * dt;
        let factor = if flow.returns { (PI * middle / flow.period).cos() } else { 1.0 };
        displace(flow, grid, &mut state, dt * factor);
        remap(&model, &mut state, &mut workspace);
        let off = |f: f64| (-f).max(f - 1.0);
        beyond = state.soil.fraction.iter().map(|f| off(*f)).fold(beyond, f64::max);
    }
    let after = volume(&state);
    let seconds = clock.elapsed().as_secs_f64();
    Advected { before, after, debris: state.energy_balance.debris_volume, beyond, seconds, state, model }
}

/// Largest component of a velocity at the nodes.
fn fastest(flow: &Flow, grid: &Grid) -> f64 {
    let mut most: f64 = 0.0;
    each_node(grid, |_, x| most = most.max((flow.velocity)(x).abs().max_element()));
    most
}

fn displace(flow: &Flow, grid: &Grid, state: &mut State, dt: f64) {
    each_node(grid, |n, x| {
        let u = (flow.velocity)(x) * dt;
        for axis in 0..3 {
            state.nodes.displacement[axis][n] = u[axis];
        }
    });
}

pub(crate) fn each_node(grid: &Grid, mut job: impl FnMut(usize, DVec3)) {
    let [nx, ny, nz] = grid.cells();
    for k in 0..=nz {
        for j in 0..=ny {
            for i in 0..=nx {
                let x = DVec3::new(grid.faces[0][i], grid.faces[1][j], grid.faces[2][k]);
                job(grid.index(i, j, k), x);
            }
        }
    }
}

/// Sum of a figure over the cells.
pub(crate) fn over_cells(grid: &Grid, value: impl Fn(usize, f64) -> f64) -> f64 {
    let [nx, ny, nz] = grid.cells();
    let mut sum = 0.0;
    for k in 0..nz {
        for j in 0..ny {
            for i in 0..nx {
                sum += value(grid.index(i, j, k), grid.volume(i, j, k));
            }
        }
    }
    sum
}

/// Volume fractions of a shape, by sampling the cells that its surface may cross.
pub(crate) fn fill(grid: &Grid, inside: impl Fn(DVec3) -> bool, fraction: &mut [f64]) {
    let [nx, ny, nz] = grid.cells();
    let flat = nz == 1;
    let samples: [usize; 3] = if flat { [64, 64, 1] } else { [16, 16, 16] };
    for k in 0..nz {
        for j in 0..ny {
            for i in 0..nx {
                let at = |n: [f64; 3]| {
                    let coordinate = |axis: usize, layer: usize| {
                        grid.faces[axis][layer] + n[axis] * grid.width(axis, layer)
                    };
                    DVec3::new(coordinate(0, i), coordinate(1, j), coordinate(2, k))
                };
                let fraction_inside = |samples: [usize; 3]| {
                    let count = samples.iter().product::<usize>();
                    let each = (0..count).map(|n| {
                        let sample =
                            [n % samples[0], n / samples[0] % samples[1], n / samples[0] / samples[1]];
                        at(std::array::from_fn(|axis| (sample[axis] as f64 + 0.5) / samples[axis] as f64))
                    });
                    each.filter(|x| inside(*x)).count() as f64 / count as f64
                };
                let rough = fraction_inside(samples.map(|n| n.min(8)));
                fraction[grid.index(i, j, k)] =
                    if rough > 0.0 && rough < 1.0 { fraction_inside(samples) } else { rough };
            }
        }
    }
}

/// A model of the unit box, or of a slab of it one cell thick; without gravity and without a yield law.
fn unit_box([nx, ny, nz]: [usize; 3]) -> Model {
    let h = 1.0 / nx as f64;
    let faces = |n: usize| (0..=n).map(|i| i as f64 * h).collect::<Vec<f64>>();
    Model::bare(
        Grid::new([faces(nx), faces(ny), faces(nz)]),
        Material::linear_elastic(Elastic::new(1e6, 0.3), 1000.0),
    )
}
