//! Body volume fraction: the part of each cell that the bodies take up.

use crate::grid::Grid;
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

/// Calls `each(cell, share)` for the cells that a body takes up a share of; measures the body's volume below the undisturbed
/// surface.
fn occupy(model: &Model, fixed: &BodyModel, body: &mut Body, mut each: impl FnMut(usize, f64)) {
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
    body.embedded_volume = 0.0;
    for k in ranges[2].clone() {
        let below = ((model.surface - grid.faces[2][k]) / grid.width(2, k)).clamp(0.0, 1.0);
        for j in ranges[1].clone() {
            for i in ranges[0].clone() {
                let share =
                    covered(grid, [i, j, k], |x| fixed.shape.signed_distance(turn * (x - body.position)));
                if share > 0.0 {
                    let (c, volume) = (grid.index(i, j, k), grid.volume(i, j, k));
                    each(c, share);
                    body.embedded_volume += share * below * volume;
                }
            }
        }
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
pub(crate) fn cut_out_bodies<R: Real>(model: &Model, soil: &mut Soil<R>, bodies: &mut [Body]) {
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
