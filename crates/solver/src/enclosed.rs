//! Voids between soil and soil: they close before the soil round them is compressed.
//!
//! The Lagrangian stage strains the soil of a partly filled cell by the strain of the whole cell, and lets it
//! bear the stress (the mean strain rate of Benson 1992). At a free surface nothing lies above that could
//! rest on it. Between soil and soil such a cell would carry what lies above, and its void would stay for
//! ever. There the void is lent to the soil as gap strain after each remap, so that it bears no stress until
//! the void is closed; at the next remap what the void has taken up is not taken from the soil's volume. Soil
//! that bears tension (clay, metal, elastic soil) spans the void of its cell and is left as it is.

use crate::boundary::Boundary;
use crate::cpu::fields_on_device::DeviceRemap;
use crate::cpu::workspace::SoilWorkspace;
use crate::device::Touched;
use crate::fields::GAP_STRAIN;
use crate::grid::GHOSTS;
use crate::kernels::Kernels;
use crate::model::Model;
use crate::scalar::Scalar;
use crate::state::{Soil, State};

/// Volume fraction from which on soil can bear what lies above it (chosen).
const BEARS: f64 = 0.9;
/// Volume fraction from which on a cell has no void to close: remaps leave that of soil that shears a little
/// below 1 (chosen).
const CLOSED: f64 = 0.98;
/// Volume fraction of the cell above, over that of a cell, from which on soil lies on top of it (chosen):
/// above a free surface there is less, and a column that falls through a slot is about as full everywhere.
const LOAD: f64 = 0.5;
/// How many cells away, on both sides, there must be soil that can bear. One less than there are ghost
/// layers: the first of these then has the same voids as in the block that owns it.
const REACH: usize = GHOSTS - 1;

/// Lends voids between soil and soil to the soil of their cells, after a remap. Bodies occupy `body_fraction`
/// of the cells; a void beside a body is the body's to close.
pub(crate) fn lend<R: Kernels>(model: &Model, state: &mut State<R>, workspace: &mut SoilWorkspace<R>) {
    let cells = enclosed(model, &mut state.soil, workspace);
    if let Some(device) = &mut workspace.device {
        device.clear_apart(model);
        let own = cells.iter().map(|(cell, _)| *cell);
        device.take_region(model, state, Touched::of(std::iter::empty(), own));
    }
    cells.iter().for_each(|(cell, void)| lend_one(model, &mut state.soil, *cell, *void));
    if let Some(device) = &mut workspace.device {
        device.give_region(model, state);
    }
}

/// Lends a cell its void, over the volume of the cell.
fn lend_one<R: Scalar>(model: &Model, soil: &mut Soil<R>, cell: usize, void: f64) {
    let material = &model.materials[soil.main_material(cell)];
    if !material.opens() {
        return;
    }
    let pressure = soil.pressure(cell);
    // Soil that no longer bears stress takes the volume that it has without.
    let expansion =
        (pressure / material.bulk_modulus(pressure) * soil.fraction[cell].to_f64()).clamp(0.0, void);
    soil.fraction[cell] = R::cast(soil.fraction[cell].to_f64() + expansion);
    let void = R::cast(void - expansion);
    soil.apart[cell] = void;
    soil.history[GAP_STRAIN][cell] = R::cast(soil.history[GAP_STRAIN][cell].to_f64() + void.to_f64());
    soil.stress.iter_mut().for_each(|s| s[cell] = R::default());
}

/// The cells with a void between soil and soil, with their voids over their volumes. What was apart before is
/// forgotten.
fn enclosed<R: Scalar>(model: &Model, soil: &mut Soil<R>, workspace: &SoilWorkspace<R>) -> Vec<(usize, f64)> {
    soil.apart.fill(R::default());
    let rows: Vec<usize> =
        (0..workspace.row_has_soil.len()).filter(|row| workspace.row_has_soil[*row]).collect();
    /// Rows that a thread takes at once.
    const AT_ONCE: usize = 64;
    let round =
        Surroundings { model, fraction: &soil.fraction, body_fraction: &workspace.velocity_before[0] };
    let each = workspace.crew().collect(rows.len(), AT_ONCE, |range| {
        rows[range].iter().flat_map(|row| round.enclosed_in(*row)).collect::<Vec<_>>()
    });
    each.concat()
}

/// What decides whether soil encloses a cell.
struct Surroundings<'a, R> {
    model: &'a Model,
    fraction: &'a [R],
    body_fraction: &'a [R],
}

impl<R: Scalar> Surroundings<'_, R> {
    /// The enclosed cells of a row of the memory, with their voids over their volumes.
    fn enclosed_in(&self, row: usize) -> Vec<(usize, f64)> {
        let grid = &self.model.grid;
        if !grid.is_inside(grid.row_and_plane(row)) {
            return Vec::new();
        }
        let start = row * grid.stride[1] + 1;
        let cells = grid.inside(0).map(|i| start + i);
        cells.filter(|c| self.is_enclosed(*c)).map(|c| (c, 1.0 - self.fraction[c].to_f64())).collect()
    }

    /// Whether soil lies on both sides of a cell along some axis; beside it only where soil lies on top of it
    /// as well, for the soil at a free surface has nothing else that holds it.
    fn is_enclosed(&self, cell: usize) -> bool {
        let fraction = self.fraction[cell].to_f64();
        if fraction <= 0.0 || fraction >= CLOSED || self.body_fraction[cell] > R::default() {
            return false;
        }
        let between = |axis: usize| [0, 1].into_iter().all(|end| self.bears(cell, axis, end));
        let has_load = || self.fraction[cell + self.model.grid.stride[2]].to_f64() >= LOAD * fraction;
        between(2) || (has_load() && (between(0) || between(1)))
    }

    /// Whether soil that can bear, or a wall, is near a cell towards an end of an axis, with no body between.
    /// A plane of symmetry shows what is on this side.
    fn bears(&self, cell: usize, axis: usize, end: usize) -> bool {
        let grid = &self.model.grid;
        let (inside, stride) = (grid.inside(axis), grid.stride[axis]);
        let own = grid.layers_of(cell)[axis];
        let room = if end == 0 { own - inside.start } else { inside.end - 1 - own };
        for distance in 1..=REACH {
            let next = if distance <= room {
                if end == 0 { cell - distance * stride } else { cell + distance * stride }
            } else {
                match self.model.boundaries.of_block(grid, axis, end) {
                    Boundary::Symmetry if distance - room <= inside.len() => {
                        let back = distance - room - 1;
                        if end == 0 {
                            cell - room * stride + back * stride
                        } else {
                            cell + room * stride - back * stride
                        }
                    }
                    Boundary::SmoothWall | Boundary::RoughWall => return axis < 2 || end == 0,
                    _ => return false,
                }
            };
            if self.body_fraction[next] > R::default() {
                return false;
            }
            if self.fraction[next].to_f64() >= BEARS {
                return true;
            }
        }
        false
    }
}
