//! Soil that overlaps a body and finds no space beside it: it is compressed into the space that its cell has.
//!
//! The nodal velocities cannot follow an edge or a tip within a cell, so that remaps carry soil to where the
//! body is. Overlap removal moves it to space near by. Where soil is confined there is none: what is left
//! means that the soil of the cell has been compressed by more than its nodes know. It is strained by the
//! rest, evenly over some travel of the body; its pressure rises, presses on the body, and drives the soil
//! out of the cell. It would also drive it on into the body: no remap carries soil into cells that a body
//! fills.

use super::body_fraction::{BodyCell, FILLED, by_cell};
use crate::exact_sum::ExactSum;
use crate::fields::GAP_STRAIN;
use crate::grid::Grid;
use crate::model::Model;
use crate::scalar::Scalar;
use crate::state::{Soil, State};
use glam::DVec3;

/// Travel of the body, in cell widths, within which confined soil is compressed (chosen: that between two
/// remaps).
const PRESSED_WITHIN: f64 = 0.1;

/// A cell with confined soil.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Confined {
    /// Index in memory.
    pub(super) cell: usize,
    /// The body that occupies most of the cell.
    body: usize,
    /// Compression after which soil and bodies fill the cell.
    strain: f64,
}

/// The cells with confined soil after a remap, in the order of the memory.
pub(crate) fn find<R: Scalar>(grid: &Grid, soil: &Soil<R>, body_cells: &[BodyCell]) -> Vec<Confined> {
    let in_domain = by_cell(body_cells).into_iter().filter(|(cell, _)| grid.is_in_domain(*cell));
    let confined = in_domain.filter_map(|(cell, (bodies, most))| {
        let soil = soil.fraction[cell].to_f64();
        let overlap = soil + bodies - 1.0;
        (overlap > R::ROUND_OFF && bodies < FILLED).then(|| Confined {
            cell,
            body: most.body,
            strain: overlap / soil,
        })
    });
    confined.collect()
}

/// Compression of a cell's soil in a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pressed {
    /// Index in memory.
    pub(crate) cell: usize,
    /// Compression of the soil, with its gap.
    strain: f64,
    /// Portion of the compression that closes the gap.
    closed: f64,
    /// Pressure before the step [Pa].
    before: f64,
}

impl Pressed {
    /// Volume by which the soil of the cell is compressed [m³].
    pub(crate) fn volume<R: Scalar>(&self, grid: &Grid, soil: &Soil<R>) -> f64 {
        self.strain * soil.fraction[self.cell].to_f64() * grid.volume_of(self.cell)
    }
}

/// Compresses confined soil by what the travel of its body asks for, before it is strained.
pub(crate) fn press<R: Scalar>(model: &Model, state: &mut State<R>, confined: &[Confined]) -> Vec<Pressed> {
    let mut pressed = Vec::new();
    for own in confined {
        let cell = own.cell;
        let portion = (travel(model, state, own) / PRESSED_WITHIN).min(1.0);
        let soil = &mut state.soil;
        let so_far = -soil.apart[cell].to_f64();
        let strain = own.strain * portion - so_far;
        if strain <= 0.0 {
            continue;
        }
        soil.apart[cell] = R::cast(-(so_far + strain));
        // A gap closes before pressure builds up.
        let gap = soil.history[GAP_STRAIN][cell].to_f64();
        let closed = gap.min(strain);
        soil.history[GAP_STRAIN][cell] = R::cast(gap - closed);
        let before = soil.pressure(cell);
        let rise = (strain - closed) * model.materials[soil.main_material(cell)].bulk_modulus(before);
        for s in &mut soil.stress[..3] {
            s[cell] = R::cast(s[cell].to_f64() - rise);
        }
        pressed.push(Pressed { cell, strain, closed, before });
    }
    pressed
}

/// Work of pressing done on the soil of the block's own cells [J], once this has been strained: with the mean
/// of the pressures before and after the step, as nodal forces do theirs.
pub(crate) fn work<R: Scalar>(model: &Model, soil: &Soil<R>, pressed: &[Pressed]) -> ExactSum {
    let (grid, mut work) = (&model.grid, ExactSum::default());
    for own in pressed.iter().filter(|own| grid.owns(grid.in_whole(grid.layers_of(own.cell)))) {
        let pressure = 0.5 * (own.before + soil.pressure(own.cell));
        work.add(pressure * (1.0 - own.closed / own.strain) * own.volume(grid, soil));
    }
    work
}

/// How far the surface of the body has moved at a cell since the last contact search, in cell widths.
fn travel<R>(model: &Model, state: &State<R>, confined: &Confined) -> f64 {
    let (grid, fixed) = (&model.grid, &model.bodies[confined.body]);
    let [before, now] = [&state.bodies[confined.body].searched_at, state.pose(confined.body)];
    let layers = grid.layers_of(confined.cell);
    let middle = DVec3::from_array(std::array::from_fn(|axis| {
        let faces = &grid.faces[axis];
        0.5 * (faces[layers[axis]] + faces[layers[axis] + 1])
    }));
    let arm = middle + state.grid_position - before.position;
    let turned = fixed.attitude(now) * (fixed.attitude(before).inverse() * arm);
    let moved = (now.position - before.position) + (turned - arm);
    (moved / grid.aspect()).length() / grid.finest()
}
