//! Soil at rest under its own weight, cut out where bodies are.

use crate::boundary::Boundary;
use crate::contact::cut_out_bodies;
use crate::energy;
use crate::fields::{INTACT_STRENGTH, PRECONSOLIDATION};
use crate::grid::Grid;
use crate::halo::Halo;
use crate::kernels::Kernels;
use crate::material::Material;
use crate::model::{Filling, Ground, Model};
use crate::scalar::Scalar;
use crate::state::{Body, EnergyBalance, Nodes, Pose, Soil, State, Twist};
use crate::uneven;
use glam::DVec3;
use std::ops::Range;

/// The state at rest of any ground (see [`at_rest_on`](crate::initial::at_rest_on)).
pub(crate) fn of_ground<R: Kernels>(model: &Model, ground: &Ground) -> State<R> {
    of_soil(model, filled(&model.grid, ground, model), ground.overburden)
}

/// No soil of the model's materials.
fn empty<R: Scalar>(grid: &Grid, model: &Model) -> Soil<R> {
    Soil::empty(grid, model.materials.len(), model.kinds())
}

/// Volume fractions and materials of the ground.
fn filled<R: Scalar>(grid: &Grid, ground: &Ground, model: &Model) -> Soil<R> {
    let mut soil = empty(grid, model);
    if !ground.is_even() {
        let bodies = ground.bodies.iter().map(|body| body.material);
        let materials: Vec<usize> = bodies.chain(ground.fillings.iter().map(|f| f.material)).collect();
        uneven::portions(grid, ground, |cell, portions| {
            for (own, material) in portions.iter().zip(&materials) {
                add_to(&mut soil, cell, *own, *material);
            }
        });
        return soil;
    }
    for filling in &ground.fillings {
        let mut own = vec![R::default(); grid.entries];
        fill(grid, filling, &mut own);
        add(&mut soil, &own, filling.material);
    }
    soil
}

/// Gives the soil of every cell what its materials remember at the height of the cell's centre.
fn remember<R: Scalar>(model: &Model, grid: &Grid, soil: &mut Soil<R>) {
    let strength = |material: &Material, z| material.strength.map_or(0.0, |profile| profile.at(z));
    remember_one(model, grid, soil, INTACT_STRENGTH, strength);
    remember_one(model, grid, soil, PRECONSOLIDATION, |material, _| material.preconsolidation);
}

fn remember_one<R: Scalar>(
    model: &Model,
    grid: &Grid,
    soil: &mut Soil<R>,
    variable: usize,
    of: impl Fn(&Material, f64) -> f64,
) {
    if soil.history[variable].is_empty() {
        return;
    }
    for c in 0..grid.entries {
        if soil.fraction[c] > R::default() {
            let [_, _, k] = grid.layers_of(c);
            let z = 0.5 * (grid.faces[2][k] + grid.faces[2][k + 1]);
            let own = |material: &Material| of(material, z);
            let first = own(model.material());
            let others = model.materials[1..].iter().zip(&soil.composition);
            let mean = others
                .fold(first, |sum, (material, portion)| sum + portion[c].to_f64() * (own(material) - first));
            soil.history[variable][c] = R::cast(mean);
        }
    }
}

/// The undisturbed ground in the cells of a grid that has moved: in one column only along an axis along which
/// it is uniform, beyond the open boundary only where there is one alone.
pub(crate) struct Undisturbed<R> {
    /// Grid of the cells in coordinates of the ground.
    grid: Grid,
    /// Layers of the whole grid that are the first here.
    first: [usize; 3],
    /// State of the cells; their masses are those of the grid here.
    pub(crate) soil: Soil<R>,
}

impl<R: Scalar> Undisturbed<R> {
    /// The ground of a model where the grid is now, `position` from where it started [m].
    pub(crate) fn new(model: &Model, position: DVec3) -> Self {
        let ground = &model.ground;
        // Of the whole grid: upwards all of it, for stresses at rest come from the weight above.
        let needed: [_; 3] = std::array::from_fn(|axis| {
            let first = model.grid.first[axis];
            let in_whole = |layers: Range<usize>| layers.start + first..layers.end + first;
            let is_one = axis < 2 && ground.is_uniform_along(axis);
            let all = if axis == 2 {
                0..model.grid.whole_cells()[2]
            } else {
                in_whole(0..model.grid.cells()[axis])
            };
            // The same layer in every block, for the same bits.
            if is_one { 0..1 } else { entered(model, axis).map_or(all, in_whole) }
        });
        let grid = Grid::new(std::array::from_fn(|axis| {
            let layers = &needed[axis];
            model.grid.whole[axis][layers.start..=layers.end].iter().map(|x| x + position[axis]).collect()
        }));
        let mut soil = filled(&grid, ground, model);
        weigh(model, &grid, &mut soil);
        remember(model, &grid, &mut soil);
        rest_stress(model, &grid, &mut soil, ground.overburden);
        Self { grid, first: needed.map(|layers| layers.start), soil }
    }

    /// Index here of a cell of the model's grid.
    pub(crate) fn index(&self, model: &Model, layers: [usize; 3]) -> usize {
        let cells = self.grid.cells();
        let whole = model.grid.in_whole(layers);
        let here = |axis: usize| whole[axis].saturating_sub(self.first[axis]).min(cells[axis] - 1);
        let [i, j, k] = std::array::from_fn(here);
        self.grid.index(i, j, k)
    }

    /// Density of the soil in a cell here [kg/m³].
    pub(crate) fn density(&self, model: &Model, cell: usize) -> f64 {
        density(model, &self.grid, &self.soil, cell)
    }
}

/// The layers beyond the inflow boundary across an axis, where no other boundary lets in ground.
fn entered(model: &Model, axis: usize) -> Option<Range<usize>> {
    let faces = (0..3).flat_map(|axis| [(axis, 0), (axis, 1)]);
    let mut inflow = faces.filter(|(axis, end)| model.boundaries.0[*axis][*end].lets_ground_in());
    match (inflow.next(), inflow.next()) {
        (Some((only, end)), None) if only == axis => {
            Some(model.grid.outside(axis, end)).filter(|layers| !layers.is_empty())
        }
        _ => None,
    }
}

/// The state at rest of soil of any shape, of the first material.
pub(crate) fn of_fractions<R: Kernels>(model: &Model, fraction: Vec<R>) -> State<R> {
    of_soil(model, Soil { fraction, ..empty(&model.grid, model) }, 0.0)
}

/// Adds soil of a material where there is still room for it.
fn add<R: Scalar>(soil: &mut Soil<R>, fraction: &[R], material: usize) {
    for (c, own) in fraction.iter().enumerate() {
        add_to(soil, c, own.to_f64(), material);
    }
}

/// Adds soil of a material to a cell, where there is still room for it.
fn add_to<R: Scalar>(soil: &mut Soil<R>, c: usize, fraction: f64, material: usize) {
    let held = soil.fraction[c].to_f64();
    let added = fraction.min(1.0 - held);
    if added > 0.0 {
        let all = held + added;
        for (n, portion) in soil.composition.iter_mut().enumerate() {
            let own = if n + 1 == material { added } else { 0.0 };
            portion[c] = R::cast((portion[c].to_f64() * held + own) / all);
        }
        soil.fraction[c] = R::cast(all);
    }
}

fn of_soil<R: Kernels>(model: &Model, mut soil: Soil<R>, overburden: f64) -> State<R> {
    let poses: Vec<Pose> = model.bodies.iter().map(|body| body.start).collect();
    let bodies = poses.iter().map(|pose| Body { searched_at: *pose, ..Body::default() }).collect();
    let at_rest: Vec<_> = poses.iter().map(|pose| (*pose, Twist::ZERO)).collect();
    let mechanism = model.mechanism().state(&at_rest);
    weigh(model, &model.grid, &mut soil);
    remember(model, &model.grid, &mut soil);
    rest_stress(model, &model.grid, &mut soil, overburden);
    cut_out_bodies(model, &mut soil, &poses);
    relieve_void(&mut soil);
    weigh(model, &model.grid, &mut soil);
    let mut nodes = Nodes::at_rest(&model.grid);
    let rows = nodes.mass.chunks_exact_mut(model.grid.stride[1]).enumerate();
    for (n, row) in rows.skip(model.grid.rows()) {
        R::nodal_masses(&model.grid, n, &soil.mass, row);
    }
    let energy_balance = EnergyBalance {
        elastic_start: energy::elastic(model, &soil, &Halo::whole()),
        volume_start: energy::soil_volume(&model.grid, &soil, &Halo::whole()),
        ..EnergyBalance::default()
    };
    let contacts = Vec::new();
    State {
        time: 0.0,
        step: 0,
        grid_position: DVec3::ZERO,
        soil,
        nodes,
        bodies,
        mechanism,
        contacts,
        remaps: 0,
        energy_balance,
    }
}

/// Volume fractions of a box of soil, or of the round column inside it.
fn fill<R: Scalar>(grid: &Grid, filling: &Filling, fraction: &mut [R]) {
    let [nx, ny, nz] = grid.cells();
    let range = |axis: usize, n: usize| {
        [grid.faces[axis][n].max(filling.low[axis]), grid.faces[axis][n + 1].min(filling.high[axis])]
    };
    // A surface that lies on a face up to rounding lies on it.
    let snapped = |portion: f64| {
        if portion < 1e-9 {
            0.0
        } else if portion > 1.0 - 1e-9 {
            1.0
        } else {
            portion
        }
    };
    let portion = |axis: usize, n: usize| {
        let [low, high] = range(axis, n);
        snapped(((high - low) / grid.width(axis, n)).clamp(0.0, 1.0))
    };
    for j in 0..ny {
        for i in 0..nx {
            let round = |radius: f64| {
                let area = area_in_disc(radius, range(0, i), range(1, j));
                snapped(area / (grid.width(0, i) * grid.width(1, j)))
            };
            let plan = filling.radius.map_or_else(|| portion(0, i) * portion(1, j), round);
            for k in 0..nz {
                fraction[grid.index(i, j, k)] = R::cast(plan * portion(2, k));
            }
        }
    }
}

/// Area [m²] of the intersection of a rectangle with a disc round the origin. The two sides along each axis
/// come in as a difference, so that a mirror changes no bit.
fn area_in_disc(radius: f64, [x0, x1]: [f64; 2], [y0, y1]: [f64; 2]) -> f64 {
    if x1 <= x0 || y1 <= y0 {
        return 0.0;
    }
    // ∫ √(r² − x²) from 0 to x.
    let under = |x: f64| {
        0.5 * (x * (radius * radius - x * x).max(0.0).sqrt() + radius * radius * (x / radius).asin())
    };
    // From the axes to a corner, with the sign of its quadrant.
    let corner = |x: f64, y: f64| {
        let (a, b) = (x.abs().min(radius), y.abs().min(radius));
        let flat = (radius * radius - b * b).sqrt().min(a);
        (b * flat + (under(a) - under(flat))) * x.signum() * y.signum()
    };
    let below = |y: f64| corner(x1, y) - corner(x0, y);
    below(y1) - below(y0)
}

/// No stress where no soil is left.
fn relieve_void<R: Scalar>(soil: &mut Soil<R>) {
    for (c, fraction) in soil.fraction.iter().enumerate() {
        if *fraction == R::default() {
            soil.stress.iter_mut().for_each(|component| component[c] = R::default());
        }
    }
}

/// Density of the undeformed soil in a cell [kg/m³]: that at the height of its centre.
fn density<R: Scalar>(model: &Model, grid: &Grid, soil: &Soil<R>, c: usize) -> f64 {
    let [_, _, k] = grid.layers_of(c);
    let z = 0.5 * (grid.faces[2][k] + grid.faces[2][k + 1]);
    let first = model.material().density_at(z);
    let others = model.materials[1..].iter().zip(&soil.composition);
    others
        .fold(first, |sum, (material, portion)| sum + portion[c].to_f64() * (material.density_at(z) - first))
}

fn weigh<R: Scalar>(model: &Model, grid: &Grid, soil: &mut Soil<R>) {
    let [nx, ny, nz] = grid.cells();
    for k in 0..nz {
        for j in 0..ny {
            for i in 0..nx {
                let c = grid.index(i, j, k);
                soil.mass[c] =
                    R::cast(density(model, grid, soil, c) * soil.fraction[c].to_f64() * grid.volume(i, j, k));
            }
        }
    }
}

/// Stresses at rest: σ_z from the discrete balance of each node, from the top down,
/// `f_k σ_k = f_{k+1} σ_{k+1} − (m_k + m_{k+1}) g / 2A`, so that the first step moves nothing; σ_x = σ_y = K₀
/// σ_z, and on a slope τ_xz and τ_yz likewise from g_x and g_y, for ground that is uniform along them. Taken
/// before the bodies' space is cut out: soil beside and under a body that starts in it bears what it bore
/// before the body was there.
///
/// Where a boundary at constant stress is the lid, the overburden acts on it, not on the top of the ghost
/// layers above it.
fn rest_stress<R: Scalar>(model: &Model, grid: &Grid, soil: &mut Soil<R>, overburden: f64) {
    let [nx, ny, nz] = grid.cells();
    let gravity = model.soil_gravity * model.down;
    for j in 0..ny {
        for i in 0..nx {
            let area = grid.width(0, i) * grid.width(1, j);
            let (mut force, mut mass_above) = (-weight_above(model, grid, soil, [i, j]), 0.0);
            for k in (0..nz).rev() {
                let c = grid.index(i, j, k);
                let (mass, fraction): (f64, f64) = (soil.mass[c].to_f64(), soil.fraction[c].to_f64());
                force += 0.5 * (mass + mass_above) * gravity;
                mass_above = mass;
                if fraction > 0.0 {
                    let [xz, yz, vertical] = (force / (area * fraction)).to_array();
                    let vertical = vertical - overburden;
                    (soil.stress[4][c], soil.stress[5][c]) = (R::cast(yz), R::cast(xz));
                    soil.stress[2][c] = R::cast(vertical);
                    soil.stress[0][c] = R::cast(model.materials[soil.main_material(c)].k0 * vertical);
                    soil.stress[1][c] = soil.stress[0][c];
                }
            }
        }
    }
}

/// Weight of the ground in the ghost layers above a lid at constant stress, in a column of cells [N].
fn weight_above<R: Scalar>(model: &Model, grid: &Grid, soil: &Soil<R>, [i, j]: [usize; 2]) -> DVec3 {
    if model.boundaries.0[2][1] != Boundary::ConstantStress {
        return DVec3::ZERO;
    }
    let layers = model.grid.whole_cells()[2] - model.grid.domain[2].end;
    let nz = grid.cells()[2];
    let mass: f64 = (nz - layers..nz).map(|k| soil.mass[grid.index(i, j, k)].to_f64()).sum();
    mass * model.soil_gravity * model.down
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn a_disc_is_cut_into_cells_whose_areas_add_up() {
        let radius = 3.2;
        let cell = |i: i32, j: i32| {
            let range = |n: i32| [f64::from(n) * 0.5, f64::from(n + 1) * 0.5];
            area_in_disc(radius, range(i), range(j))
        };
        let all: f64 = (-8..8).flat_map(|i| (-8..8).map(move |j| cell(i, j))).sum();
        assert!((all - PI * radius * radius).abs() < 1e-12 * all, "{all}");
        for (i, j) in (0..8).flat_map(|i| (0..8).map(move |j| (i, j))) {
            let one = cell(i, j);
            assert!((-1e-14..=0.25 + 1e-14).contains(&one), "{i} {j} {one}");
            // Mirror images in either axis: the same bits.
            assert_eq!([one; 3], [cell(-1 - i, j), cell(i, -1 - j), cell(-1 - i, -1 - j)]);
        }
        // A single rectangle, by hand: the quarter disc to the right of x = r/2 is r² (π/6 − √3/8).
        let right = area_in_disc(radius, [0.5 * radius, 9.0], [0.0, 9.0]);
        assert!((right - radius * radius * (PI / 6.0 - 3_f64.sqrt() / 8.0)).abs() < 1e-13);
    }
}
