//! Body volume fraction: the part of each cell that the bodies take up.

use crate::grid::Grid;
use crate::halo::{self, Halo};
use crate::model::{BodyModel, Model};
use crate::real::Real;
use crate::state::{Body, Soil};
use glam::DVec3;

/// Finds anew which share of each cell the bodies take up. It is noted in memory that is free only till [`locate`].
pub(crate) fn find_bodies<R: Real>(
    model: &Model,
    bodies: &mut [Body],
    occupied: &mut [R],
    body_cells: &mut Vec<BodyCell>,
) {
    body_cells.clear();
    for (n, (fixed, body)) in model.bodies.iter().zip(bodies).enumerate() {
        occupy(model, fixed, body, |cell, share| {
            let sum = occupied[cell].to_f64() + R::cast(share).to_f64();
            occupied[cell] = R::cast(sum.min(1.0));
            body_cells.push(BodyCell { body: n, cell, share });
        });
        body.located = (body.position, body.angle);
    }
}

/// A cell of which a body takes up a share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BodyCell {
    /// Which body.
    pub(crate) body: usize,
    /// Place in memory.
    pub(crate) cell: usize,
    /// Share of the cell.
    pub(crate) share: f64,
}

/// Calls `each(cell, share)` for the cells that a body takes up a share of.
fn occupy(model: &Model, fixed: &BodyModel, body: &Body, mut each: impl FnMut(usize, f64)) {
    let grid = &model.grid;
    let (low, high) = fixed.shape.bounds();
    let reach = if fixed.shape.is_revolved() { high } else { DVec3::splat(low.length().max(high.length())) };
    let ranges: [std::ops::Range<usize>; 3] = std::array::from_fn(|axis| {
        let faces = &grid.faces[axis];
        let first = faces.partition_point(|f| *f <= body.position[axis] - reach[axis]).saturating_sub(1);
        let last = faces.partition_point(|f| *f < body.position[axis] + reach[axis]);
        first..last.min(grid.cells()[axis])
    });
    let turn = glam::DQuat::from_rotation_y(if fixed.shape.is_revolved() { 0.0 } else { -body.angle });
    for k in ranges[2].clone() {
        for j in ranges[1].clone() {
            for i in ranges[0].clone() {
                let share =
                    covered(grid, [i, j, k], |x| fixed.shape.signed_distance(turn * (x - body.position)));
                if share > 0.0 {
                    each(grid.index(i, j, k), share);
                }
            }
        }
    }
}

/// Measures the volume of each body below the undisturbed surface, and the soil inside it: what is more than fits beside it
/// in its cells.
pub(super) fn measure_bodies<R: Real>(
    model: &Model,
    soil: &Soil<R>,
    bodies: &mut [Body],
    body_cells: &[BodyCell],
    halo: &mut dyn Halo,
) {
    let grid = &model.grid;
    let [nx, ny, nz] = grid.whole_cells();
    let terms = body_cells.iter().filter_map(|c| {
        let place = grid.place(c.cell);
        let whole @ [i, j, k] = grid.in_whole(place);
        let below = ((model.surface - grid.faces[2][place[2]]) / grid.width(2, place[2])).clamp(0.0, 1.0);
        let volume = grid.volume_of(c.cell);
        let leaked = (soil.fraction[c.cell].to_f64() + c.share - 1.0).max(0.0) * volume;
        let number = ((c.body * nz + k) * ny + j) * nx + i;
        grid.owns(whole).then_some((number, [c.share * below * volume, leaked]))
    });
    for body in bodies.iter_mut() {
        (body.embedded_volume, body.leaked_volume) = (0.0, 0.0);
    }
    for (number, [embedded, leaked]) in halo::in_order(halo, terms) {
        let body = &mut bodies[number / (nx * ny * nz)];
        body.embedded_volume += embedded;
        body.leaked_volume += leaked;
    }
}

/// Share of a cell with a negative distance, by 4³ samples; each counts in part when the surface is near it.
fn covered(grid: &Grid, cell: [usize; 3], distance: impl Fn(DVec3) -> f64) -> f64 {
    const SAMPLES: usize = 4;
    // Every place is found from both faces, and layers in y are added up in pairs: a mirror in y changes no bit.
    let at = |axis: usize, n: f64| {
        let (part, faces) = (n / SAMPLES as f64, &grid.faces[axis]);
        faces[cell[axis]] * (1.0 - part) + faces[cell[axis] + 1] * part
    };
    let width = DVec3::from_array(std::array::from_fn(|axis| grid.width(axis, cell[axis])));
    let middle = distance(DVec3::new(at(0, 2.0), at(1, 2.0), at(2, 2.0)));
    if middle.abs() > 0.5 * width.length() {
        return if middle < 0.0 { 1.0 } else { 0.0 };
    }
    let sample = width.min_element() / SAMPLES as f64;
    let mut layers = [0.0; SAMPLES];
    for n in 0..SAMPLES.pow(3) {
        let [x, y, z] = [n % SAMPLES, n / SAMPLES % SAMPLES, n / SAMPLES / SAMPLES];
        let place = |axis: usize, n: usize| at(axis, n as f64 + 0.5);
        let d = distance(DVec3::new(place(0, x), place(1, y), place(2, z)));
        layers[y] += (0.5 - d / sample).clamp(0.0, 1.0);
    }
    ((layers[0] + layers[3]) + (layers[1] + layers[2])) / SAMPLES.pow(3) as f64
}

/// Takes the soil out of the space that the bodies take up, before the run begins.
pub(crate) fn cut_out_bodies<R: Real>(model: &Model, soil: &mut Soil<R>, bodies: &[Body]) {
    let mut occupied = vec![0.0; model.grid.entries];
    for (fixed, body) in model.bodies.iter().zip(bodies) {
        occupy(model, fixed, body, |c, share| occupied[c] = (occupied[c] + share).min(1.0));
    }
    for (f, share) in soil.fraction.iter_mut().zip(&occupied) {
        let room = R::cast(1.0 - share);
        if *f > room {
            *f = room;
        }
    }
}
