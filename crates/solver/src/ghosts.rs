//! Ghost layers beyond open boundaries: what enters and leaves through these as the grid moves.
//!
//! A sweep of the remap treats the ghost layers as it does all cells, so that soil passes the boundary like
//! any face. After each sweep they are refilled: with undisturbed ground beyond an inflow boundary, with the
//! state of the next cell of the domain beyond an outflow boundary. Nodes on such a boundary and beyond it
//! are at rest; on a boundary at constant stress they move, and the first layer beyond it is strained like
//! any cell, but every step from its stress at rest.

use crate::boundary::Boundary;
use crate::contact::BodyCell;
use crate::device::Touched;
use crate::exact_sum::{ExactSum, over_blocks};
use crate::grid::Grid;
use crate::halo::Halo;
use crate::kernels::Kernels;
use crate::model::Model;
use crate::rest::Undisturbed;
use crate::state::{EnergyBalance, Nodes, Soil, State};
use glam::DVec3;
use std::ops::Range;

/// Moves the grid after the body that it follows; returns how far [m]. Displacements are relative to the
/// grid, and must then be less by as much.
pub(crate) fn follow<R: Kernels>(model: &Model, state: &mut State<R>) -> DVec3 {
    let Some(follow) = model.follow else { return DVec3::ZERO };
    let travelled = state.pose(follow.body).position - model.bodies[follow.body].start.position;
    let along =
        |axis: usize| if follow.axes[axis] { travelled[axis] - state.grid_position[axis] } else { 0.0 };
    let shift = DVec3::from_array(std::array::from_fn(along));
    state.grid_position += shift;
    shift
}

/// The cells and nodes of the ghost layers, and those beside them that these are filled from.
pub(crate) fn touched(grid: &Grid) -> Touched {
    let (mut cells, mut nodes) = (Vec::new(), Vec::new());
    for (face, outside) in open_faces(grid) {
        let inner = if face.end == 0 { 0..outside.end + 1 } else { outside.start - 1..outside.end };
        let [mut of_cells, mut of_nodes] = [grid.cells().map(|n| 0..n), grid.cells().map(|n| 0..n + 1)];
        (of_cells[face.axis], of_nodes[face.axis]) = (inner, outside.start..outside.end + 1);
        for_each_in(of_cells, |[i, j, k]| cells.push(grid.index(i, j, k)));
        for_each_in(of_nodes, |[i, j, k]| nodes.push(grid.index(i, j, k)));
    }
    Touched::of(nodes.into_iter(), cells.into_iter())
}

/// The ghost layers during a remap.
pub(crate) struct Ghosts<'a, R> {
    undisturbed: Undisturbed<R>,
    /// The cells that bodies occupied at the last contact search.
    bodies: &'a [BodyCell],
    /// Content of the ghost layers after they were filled last.
    held: Content,
}

/// Volume [m³], mass [kg] and elastic energy [J] of the soil in the ghost layers.
type Content = [f64; 3];

impl<'a, R: Kernels> Ghosts<'a, R> {
    /// The ghost layers of a grid with open faces, before the first sweep; `volume` is that of the soil in
    /// the displaced cells [m³].
    pub(crate) fn new(
        model: &Model,
        state: &State<R>,
        volume: &[R],
        bodies: &'a [BodyCell],
        halo: &Halo,
    ) -> Option<Self> {
        model.grid.has_open_faces().then(|| Self {
            undisturbed: Undisturbed::new(model, state.grid_position),
            bodies,
            held: content(model, &state.soil, volume, halo),
        })
    }

    /// Renews the ghost layers after a sweep: adds what has passed the boundaries to the balance and refills
    /// the layers, with the volumes of the soil in the displaced cells and of these [m³].
    pub(crate) fn renew(
        &mut self,
        model: &Model,
        state: &mut State<R>,
        [volume, cell]: [&mut Vec<R>; 2],
        halo: &Halo,
    ) {
        let left = content(model, &state.soil, volume, halo);
        let EnergyBalance { inflow_volume, inflow_mass, inflow_elastic, .. } = &mut state.energy_balance;
        let entered = [inflow_volume, inflow_mass, inflow_elastic].into_iter().zip(self.held).zip(left);
        entered.for_each(|((sum, before), after)| *sum += before - after);
        let grid = &model.grid;
        for_each_ghost(grid, |face, layers| {
            let [i, j, k] = layers;
            let (c, whole) = (grid.index(i, j, k), grid.volume(i, j, k));
            let fraction = match model.boundaries.0[face.axis][face.end] {
                Boundary::Outflow => copy_inner(grid, &mut state.soil, [volume, cell], face, layers),
                _ => self.enter(model, &mut state.soil, layers),
            };
            (volume[c], cell[c]) = (R::cast(fraction * whole), R::cast(whole));
        });
        self.cut_out(model, &mut state.soil, Some(volume));
        stop_nodes(model, &state.soil.mass, &mut state.nodes);
        self.held = content(model, &state.soil, volume, halo);
    }

    /// Fills the layers beyond inflow boundaries after the last sweep, when volume fractions are known again.
    pub(crate) fn finish(&self, model: &Model, soil: &mut Soil<R>) {
        for_each_ghost(&model.grid, |face, layers| {
            if model.boundaries.0[face.axis][face.end].lets_ground_in() {
                self.enter(model, soil, layers);
            }
        });
        self.cut_out(model, soil, None);
    }

    /// Makes room in the ghost layers for the bodies that cross a boundary at constant stress, such as a
    /// shaft through the lid.
    fn cut_out(&self, model: &Model, soil: &mut Soil<R>, mut volume: Option<&mut Vec<R>>) {
        if !model.boundaries.have_constant_stress() {
            return;
        }
        for own in self.bodies {
            let (c, space) = (own.cell, 1.0 - own.fraction);
            let fraction = soil.fraction[c].to_f64();
            if model.grid.is_in_domain(c) || fraction <= space {
                continue;
            }
            let kept = |value: R| R::cast(value.to_f64() * space / fraction);
            (soil.fraction[c], soil.mass[c]) = (R::cast(space), kept(soil.mass[c]));
            if let Some(volume) = volume.as_deref_mut() {
                volume[c] = kept(volume[c]);
            }
        }
    }

    /// Puts undisturbed ground into a cell; returns its volume fraction.
    fn enter(&self, model: &Model, soil: &mut Soil<R>, layers @ [i, j, k]: [usize; 3]) -> f64 {
        let (here, there) = (model.grid.index(i, j, k), self.undisturbed.index(model, layers));
        let undisturbed = &self.undisturbed.soil;
        soil.arrays_mut().zip(undisturbed.arrays()).for_each(|(to, from)| to[here] = from[there]);
        let fraction = undisturbed.fraction[there].to_f64();
        let density = self.undisturbed.density(model, there);
        soil.mass[here] = R::cast(density * fraction * model.grid.volume(i, j, k));
        fraction
    }
}

/// A face of the domain.
#[derive(Clone, Copy)]
struct Face {
    axis: usize,
    /// 0 at the low end, 1 at the high end.
    end: usize,
}

/// The open faces of a block, with the ghost layers beyond each.
fn open_faces(grid: &Grid) -> impl Iterator<Item = (Face, Range<usize>)> + '_ {
    let faces = (0..3).flat_map(|axis| [0, 1].map(|end| Face { axis, end }));
    faces.map(|face| (face, grid.outside(face.axis, face.end))).filter(|(_, outside)| !outside.is_empty())
}

/// Calls `each(layers)` for all cells or nodes in a box.
fn for_each_in([x, y, z]: [Range<usize>; 3], mut each: impl FnMut([usize; 3])) {
    for (j, k) in z.flat_map(|k| y.clone().map(move |j| (j, k))) {
        x.clone().for_each(|i| each([i, j, k]));
    }
}

/// Calls `each(face, layers)` for the cells beyond the open faces of a block; those beyond two faces come
/// twice.
fn for_each_ghost(grid: &Grid, mut each: impl FnMut(Face, [usize; 3])) {
    for (face, outside) in open_faces(grid) {
        let mut ranges = grid.cells().map(|n| 0..n);
        ranges[face.axis] = outside;
        for_each_in(ranges, |layers| each(face, layers));
    }
}

/// Copies the state of the next cell of the domain into one beyond a face; returns its volume fraction.
fn copy_inner<R: Kernels>(
    grid: &Grid,
    soil: &mut Soil<R>,
    [volume, cell]: [&[R]; 2],
    face: Face,
    layers: [usize; 3],
) -> f64 {
    let inside = grid.inside(face.axis);
    let mut inner = layers;
    inner[face.axis] = if face.end == 0 { inside.start } else { inside.end - 1 };
    let [to, from] = [layers, inner].map(|[i, j, k]| grid.index(i, j, k));
    soil.arrays_mut().for_each(|field| field[to] = field[from]);
    let volume_ratio = grid.volume(layers[0], layers[1], layers[2]) / cell[from].to_f64();
    soil.mass[to] = R::cast(soil.mass[from].to_f64() * volume_ratio);
    volume[from].to_f64() / cell[from].to_f64()
}

/// Stops the nodes on open faces, unless these yield, and beyond them, and gives the latter the masses of the
/// cells round them.
fn stop_nodes<R: Kernels>(model: &Model, cell_mass: &[R], nodes: &mut Nodes<R>) {
    let grid = &model.grid;
    let [x, y, z] = grid.stride;
    for (face, outside) in open_faces(grid) {
        let on_face = if face.end == 0 { outside.end } else { outside.start };
        let yields = model.boundaries.0[face.axis][face.end].yields();
        let mut ranges = grid.cells().map(|n| 0..n + 1);
        ranges[face.axis] = outside.start..outside.end + 1;
        for_each_in(ranges, |layers @ [i, j, k]| {
            if yields && layers[face.axis] == on_face {
                return;
            }
            let n = grid.index(i, j, k);
            nodes.velocity.iter_mut().for_each(|v| v[n] = R::default());
            if layers[face.axis] != on_face {
                let cells = [0, x, y, z, x + y, y + z, x + z, x + y + z];
                let sum: f64 = cells.iter().map(|offset| cell_mass[n - offset].to_f64()).sum();
                nodes.mass[n] = R::cast(0.125 * sum);
            }
        });
    }
}

/// The ground in the first layer beyond the boundaries at constant stress, from which it starts in every
/// step.
pub(crate) struct Beyond<R> {
    /// Index in memory and volume of each cell [m³]; none for those that another block accounts for.
    cells: Vec<(usize, f64)>,
    /// Stress and history of the ground at rest: one list for each array, in the order of the cells.
    at_rest: Vec<Vec<R>>,
}

impl<R: Kernels> Beyond<R> {
    /// The ground beyond a block whose grid has moved as far as in a state.
    pub(crate) fn new(model: &Model, state: &State<R>) -> Self {
        if !model.boundaries.have_constant_stress() {
            return Self { cells: Vec::new(), at_rest: Vec::new() };
        }
        let grid = &model.grid;
        let undisturbed = Undisturbed::<R>::new(model, state.grid_position);
        let (mut cells, mut from) = (Vec::new(), Vec::new());
        let ranges = [0, 1, 2].map(|axis| model.boundaries.strained(grid, axis));
        for_each_in(ranges, |layers @ [i, j, k]| {
            let c = grid.index(i, j, k);
            if !grid.is_in_domain(c) {
                let whole = grid.in_whole(layers);
                let is_own = (0..3).all(|axis| grid.accounts_for(axis, whole[axis]));
                cells.push((c, if is_own { grid.volume(i, j, k) } else { 0.0 }));
                from.push(undisturbed.index(model, layers));
            }
        });
        let strained = undisturbed.soil.strained();
        let at_rest = strained.map(|field| from.iter().map(|c| field[*c]).collect()).collect();
        Self { cells, at_rest }
    }

    /// Indices in memory of the cells.
    pub(crate) fn cells(&self) -> impl Iterator<Item = usize> {
        self.cells.iter().map(|(cell, _)| *cell)
    }

    /// Puts the ground beyond the boundaries back to rest.
    pub(crate) fn rest(&self, soil: &mut Soil<R>) {
        if self.cells.is_empty() {
            return;
        }
        for (field, at_rest) in soil.strained_mut().zip(&self.at_rest) {
            for ((c, _), value) in self.cells.iter().zip(at_rest) {
                field[*c] = *value;
            }
        }
    }

    /// Elastic energy that the ground has taken up since it was at rest [J].
    pub(crate) fn taken_up(&self, model: &Model, soil: &Soil<R>) -> ExactSum {
        let mut sum = ExactSum::default();
        for (n, (c, volume)) in self.cells.iter().enumerate() {
            let material = &model.materials[soil.main_material(*c)];
            let now = material.elastic_energy(soil.stress.each_ref().map(|field| field[*c].to_f64()));
            let at_rest = std::array::from_fn(|component| self.at_rest[component][n].to_f64());
            sum.add(volume * soil.fraction[*c].to_f64() * (now - material.elastic_energy(at_rest)));
        }
        sum
    }
}

/// What the ghost layers of all blocks hold.
fn content<R: Kernels>(model: &Model, soil: &Soil<R>, volume: &[R], halo: &Halo) -> Content {
    let grid = &model.grid;
    let [nx, ny, nz] = grid.cells();
    let rows = (0..nz).flat_map(|k| (0..ny).map(move |j| [j, k]));
    let mut sums = [ExactSum::default(); 3];
    for [j, k] in rows {
        let [_, y, z] = grid.in_whole([0, j, k]);
        if !(grid.accounts_for(1, y) && grid.accounts_for(2, z)) {
            continue;
        }
        let is_ghost = !(grid.inside(1).contains(&j) && grid.inside(2).contains(&k));
        let mut add = |columns: Range<usize>| {
            let held = content_of(model, soil, volume, columns.map(|i| [i, j, k]));
            sums.iter_mut().zip(held).for_each(|(sum, term)| sum.add(term));
        };
        if is_ghost {
            add(0..nx);
        } else {
            [0, 1].into_iter().for_each(|end| add(grid.outside(0, end)));
        }
    }
    over_blocks(halo, sums)
}

/// What some cells hold.
fn content_of<R: Kernels>(
    model: &Model,
    soil: &Soil<R>,
    volume: &[R],
    cells: impl Iterator<Item = [usize; 3]>,
) -> Content {
    cells.fold([0.0; 3], |[volumes, masses, elastic], [i, j, k]| {
        let c = model.grid.index(i, j, k);
        let own = volume[c].to_f64();
        let stress = soil.stress.each_ref().map(|component| component[c].to_f64());
        let energy = model.materials[soil.main_material(c)].elastic_energy(stress);
        [volumes + own, masses + soil.mass[c].to_f64(), elastic + own * energy]
    })
}
