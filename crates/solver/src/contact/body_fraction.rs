//! Body volume fraction: the fraction of each cell that bodies occupy.

use super::problem::corners;
use crate::cpu::threads::Crew;
use crate::cpu::workspace::SoilWorkspace;
use crate::device::Touched;
use crate::exact_sum::{ExactSum, over_blocks};
use crate::grid::Grid;
use crate::halo::Halo;
use crate::model::{BodyModel, Model};
use crate::scalar::Scalar;
use crate::state::{Pose, Soil, State};
use geometry::Shape;
use glam::DVec3;
use std::collections::{BTreeMap, BTreeSet};

/// Layers above the highest soil of which bodies are known: the contact search looks two cells away from a
/// point's own.
const LAYERS_ABOVE_SOIL: usize = 3;

/// Updates the body volume fractions of all cells near the soil, in scratch memory that is unused until the
/// contact search.
pub(crate) fn find_bodies<R: Scalar>(
    model: &Model,
    state: &mut State<R>,
    soil: &mut SoilWorkspace<R>,
    body_cells: &mut Vec<BodyCell>,
) {
    for n in 0..state.bodies.len() {
        state.bodies[n].searched_at = *state.pose(n);
    }
    *body_cells = bodies_at_search(model, state, soil.crew());
    let body_fraction = &mut soil.velocity_before[0];
    for own in body_cells {
        let sum = body_fraction[own.cell].to_f64() + R::cast(own.fraction).to_f64();
        body_fraction[own.cell] = R::cast(sum.min(1.0));
    }
}

/// The cells near the soil that bodies occupied at the last contact search.
pub(crate) fn bodies_at_search<R: Scalar>(model: &Model, state: &State<R>, crew: Crew) -> Vec<BodyCell> {
    /// Cells that a thread takes at once.
    const AT_ONCE: usize = 64;
    // The part of a body high above the soil does not matter, and is most of a wheel.
    let top = top_of_soil(&model.grid, &state.soil).max(model.top_of_ground() - state.grid_position.z);
    let mut found = Vec::new();
    for (n, (fixed, body)) in model.bodies.iter().zip(&state.bodies).enumerate() {
        let pose = body.searched_at;
        let in_grid = Pose { position: pose.position - state.grid_position, ..pose };
        let cells = cells_near(model, top, fixed, &in_grid);
        let each = crew.collect(cells.len(), AT_ONCE, |range| {
            let occupied = occupied(model, fixed, &in_grid, &cells[range]);
            occupied.map(|(cell, fraction)| BodyCell { body: n, cell, fraction }).collect::<Vec<_>>()
        });
        found.extend(each.into_iter().flatten());
    }
    found
}

/// A cell that a body occupies, wholly or in part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BodyCell {
    /// Index of the body.
    pub(crate) body: usize,
    /// Index in memory.
    pub(crate) cell: usize,
    /// Volume fraction of the body in the cell.
    pub(crate) fraction: f64,
}

/// Volume fraction of bodies from which on they fill a cell: it has no space for soil to flow or to be
/// compressed into (chosen).
pub(super) const FILLED: f64 = 0.95;

/// The cells that bodies filled at the last contact search, in the order of the memory.
pub(crate) fn filled(body_cells: &[BodyCell]) -> Vec<usize> {
    let filled = by_cell(body_cells).into_iter().filter(|(_, (bodies, _))| *bodies >= FILLED);
    filled.map(|(cell, _)| cell).collect()
}

/// The volume fraction of all bodies in each cell that they occupy, and what occupies most of it.
pub(super) fn by_cell(body_cells: &[BodyCell]) -> BTreeMap<usize, (f64, &BodyCell)> {
    let mut occupied: BTreeMap<usize, (f64, &BodyCell)> = BTreeMap::new();
    for own in body_cells {
        let (sum, most) = occupied.entry(own.cell).or_insert((0.0, own));
        *sum += own.fraction;
        *most = if own.fraction > most.fraction { own } else { most };
    }
    occupied
}

/// The cells that bodies occupy and those near them, with their nodes: all that moving soil out of the
/// bodies, carrying remnants and searching for contacts look at besides volume fractions and masses.
pub(super) fn near(grid: &Grid, body_cells: &[BodyCell]) -> Touched {
    /// Layers of neighbours: overlapping soil moves by one, the search looks at the next cell of a point's.
    const LAYERS: usize = 2;
    let mut cells: Vec<[usize; 3]> = body_cells.iter().map(|own| grid.layers_of(own.cell)).collect();
    for axis in 0..3 {
        let along = |layers: [usize; 3]| {
            let n = layers[axis];
            (n.saturating_sub(LAYERS)..(n + LAYERS + 1).min(grid.cells()[axis])).map(move |n| {
                let mut near = layers;
                near[axis] = n;
                near
            })
        };
        cells = cells.into_iter().flat_map(along).collect();
        cells.sort_unstable();
        cells.dedup();
    }
    let cells: Vec<usize> = cells.into_iter().map(|[i, j, k]| grid.index(i, j, k)).collect();
    let nodes = cells.iter().flat_map(|c| corners(grid.stride).map(|offset| c + offset));
    Touched::of(nodes, cells.iter().copied())
}

/// Height [m] in the grid up to which bodies can concern the soil.
fn top_of_soil<R: Scalar>(grid: &Grid, soil: &Soil<R>) -> f64 {
    let mut planes = soil.fraction.chunks_exact(grid.stride[2]);
    let highest = planes.rposition(|plane| plane.iter().any(|f| *f > R::default())).unwrap_or(0);
    // Plane 0 is a layer of ghosts below the cells, so that the number of the plane is that of the face
    // above.
    let faces = &grid.faces[2];
    faces[(highest + LAYERS_ABOVE_SOIL).min(faces.len() - 1)]
}

/// The cells among some that a body occupies, wholly or in part: their indices in memory, and the volume
/// fractions of the body.
fn occupied<'a>(
    model: &'a Model,
    fixed: &'a BodyModel,
    pose: &Pose,
    cells: &'a [[usize; 3]],
) -> impl Iterator<Item = (usize, f64)> + 'a {
    let grid = &model.grid;
    let (position, rotation) = (pose.position, fixed.attitude(pose).inverse());
    let own = move |x: DVec3| rotation * (x - position);
    let each = cells.iter().map(move |cell| (*cell, covered(grid, *cell, fixed.shape.as_ref(), own)));
    each.filter(|(_, fraction)| *fraction > 0.0).map(|([i, j, k], fraction)| (grid.index(i, j, k), fraction))
}

/// The cells below a height [m] that the boxes around a body touch, i fastest.
fn cells_near(model: &Model, top: f64, fixed: &BodyModel, pose: &Pose) -> Vec<[usize; 3]> {
    let grid = &model.grid;
    let mut boxes = fixed.boxes(pose);
    boxes.iter_mut().for_each(|(_, high)| high.z = high.z.min(top));
    if let [whole] = boxes[..] {
        return cells_in(grid, whole).collect();
    }
    // Boxes of several parts may share cells.
    let cells: BTreeSet<[usize; 3]> =
        boxes.into_iter().flat_map(|part| cells_in(grid, part).map(|[i, j, k]| [k, j, i])).collect();
    cells.into_iter().map(|[k, j, i]| [i, j, k]).collect()
}

/// The cells that a box touches, i fastest.
fn cells_in(grid: &Grid, (low, high): (DVec3, DVec3)) -> impl Iterator<Item = [usize; 3]> {
    let ranges: [std::ops::Range<usize>; 3] = std::array::from_fn(|axis| {
        let faces = &grid.faces[axis];
        let first = faces.partition_point(|f| *f <= low[axis]).saturating_sub(1);
        let last = faces.partition_point(|f| *f < high[axis]);
        first..last.min(grid.cells()[axis])
    });
    let [x, y, z] = ranges;
    z.flat_map(move |k| {
        let x = x.clone();
        y.clone().flat_map(move |j| x.clone().map(move |i| [i, j, k]))
    })
}

/// Compression of the soil in a cut cell up to which overlap is no leak: as the body moves on it is
/// compressed by so much before the next remap (chosen: two random cases on four and six cells with 2.5 and
/// 3.0 % of the embedded volume in such overlaps were within 13 % of cells half as wide).
const PENDING: f64 = 0.1;

/// Measures the embedded volume of each body, and the leak into it: the volume of soil in the cells that
/// bodies fill, and of what finds no space in those that they cut [m³].
pub(super) fn measure_bodies<R: Scalar>(
    model: &Model,
    state: &mut State<R>,
    body_cells: &[BodyCell],
    halo: &Halo,
) {
    let State { soil, bodies, grid_position, .. } = state;
    let surface = model.surface - grid_position.z;
    let grid = &model.grid;
    let filled = filled(body_cells);
    let mut sums = vec![[ExactSum::default(); 2]; bodies.len()];
    for c in body_cells {
        let layers = grid.layers_of(c.cell);
        if !grid.owns(grid.in_whole(layers)) {
            continue;
        }
        let rise = local_rise(model, grid, layers, *grid_position);
        let below = ((surface + rise - grid.faces[2][layers[2]]) / grid.width(2, layers[2])).clamp(0.0, 1.0);
        let volume = grid.volume_of(c.cell);
        let held = soil.fraction[c.cell].to_f64();
        let pending = if filled.binary_search(&c.cell).is_ok() { 0.0 } else { PENDING * held };
        let leaked = (held + c.fraction - 1.0 - pending).max(0.0) * volume;
        let [embedded, all_leaked] = &mut sums[c.body];
        embedded.add(c.fraction * below * volume);
        all_leaked.add(leaked);
    }
    for (body, sums) in bodies.iter_mut().zip(sums) {
        [body.embedded_volume, body.leaked_volume] = over_blocks(halo, sums);
    }
}

/// How far the undisturbed surface over a cell lies above the level one [m].
fn local_rise(model: &Model, grid: &Grid, [i, j, _]: [usize; 3], position: DVec3) -> f64 {
    if model.ground.relief.is_level() {
        return 0.0;
    }
    let middle =
        |axis: usize, n: usize| 0.5 * (grid.faces[axis][n] + grid.faces[axis][n + 1]) + position[axis];
    model.ground.relief.at([middle(0, i), middle(1, j)])
}

/// Fraction of a cell that a shape covers, from 4³ samples; samples near the surface are weighted. `own`
/// takes a position to the frame of the shape.
fn covered(grid: &Grid, cell: [usize; 3], shape: &dyn Shape, own: impl Fn(DVec3) -> DVec3) -> f64 {
    const SAMPLES: usize = 4;
    // Positions are interpolated from both faces and layers in y summed in pairs, so that mirroring in y
    // changes no bit.
    let at = |axis: usize, n: f64| {
        let (local, faces) = (n / SAMPLES as f64, &grid.faces[axis]);
        faces[cell[axis]] * (1.0 - local) + faces[cell[axis] + 1] * local
    };
    let width = DVec3::from_array(std::array::from_fn(|axis| grid.width(axis, cell[axis])));
    let middle = DVec3::new(at(0, 2.0), at(1, 2.0), at(2, 2.0));
    let distance = |x: DVec3| shape.signed_distance(own(x));
    let centre = distance(middle);
    if centre.abs() > 0.5 * width.length() {
        return if centre < 0.0 { 1.0 } else { 0.0 };
    }
    // In cubes the depth does not depend on the normal.
    let depth = if grid.has_cubes() { 1.0 } else { grid.depth_along(normal(middle, 1e-3 * width, distance)) };
    let sample = grid.smallest_width(width) * depth / SAMPLES as f64;
    let mut layers = [0.0; SAMPLES];
    for n in 0..SAMPLES.pow(3) {
        let [x, y, z] = [n % SAMPLES, n / SAMPLES % SAMPLES, n / SAMPLES / SAMPLES];
        let coordinate = |axis: usize, n: usize| at(axis, n as f64 + 0.5);
        let at = DVec3::new(coordinate(0, x), coordinate(1, y), coordinate(2, z));
        layers[y] += shape.coverage(own(at), sample);
    }
    ((layers[0] + layers[3]) + (layers[1] + layers[2])) / SAMPLES.pow(3) as f64
}

/// Unit normal of the surface nearest to `x`, from differences of the distance over `step` [m] to both sides.
fn normal(x: DVec3, step: DVec3, distance: impl Fn(DVec3) -> f64) -> DVec3 {
    let along = |axis: DVec3| (distance(x + axis * step) - distance(x - axis * step)) / axis.dot(step);
    DVec3::from_array(DVec3::AXES.map(along)).normalize_or_zero()
}

/// Cuts the bodies out of the soil before the run begins.
pub(crate) fn cut_out_bodies<R: Scalar>(model: &Model, soil: &mut Soil<R>, poses: &[Pose]) {
    let mut body_fraction = vec![0.0; model.grid.entries];
    for (fixed, pose) in model.bodies.iter().zip(poses) {
        let cells = cells_near(model, f64::INFINITY, fixed, pose);
        for (c, fraction) in occupied(model, fixed, pose, &cells) {
            body_fraction[c] = (body_fraction[c] + fraction).min(1.0);
        }
    }
    for (f, fraction) in soil.fraction.iter_mut().zip(&body_fraction) {
        let space = R::cast(1.0 - fraction);
        if *f > space {
            *f = space;
        }
    }
}
