//! Which cells have a pore pressure of their own, and how well water flows between them. Found anew when soil
//! and bodies have moved.

use super::SeepageWorkspace;
use crate::fields::Soil;
use crate::grid::Grid;
use crate::model::Model;
use crate::scalar::Scalar;

/// Portion of the room outside the bodies that soil fills in a cell with a pore pressure of its own; with
/// less, it is open water.
const LEAST_FILLED: f64 = 0.5;

/// Portion of a cell outside the bodies up to which it is no open water, whatever soil fills of it: a void in
/// so thin a slice beside a body is an error of the volume fractions. The pressure must act in all of its
/// soil, as the contact impulses do.
const SLICE: f64 = 0.25;

/// Least distance between the middle of a cell and open water, in cell widths. A cell that is half full has
/// its middle in the surface; a distance of zero would be no worse an approximation, but could not be divided
/// by.
const LEAST_DISTANCE: f64 = 0.1;

/// Density over that of the undeformed soil below which grains float in open water: they hold no pressure,
/// which would accelerate so little mass without bound.
const LEAST_DENSITY: f64 = 0.5;

/// Finds the conductances from volume fractions and masses of the soil, with the volume fractions of bodies
/// in `workspace.body_fraction`.
pub(crate) fn find<R: Scalar>(model: &Model, soil: &Soil<R>, workspace: &mut SeepageWorkspace) {
    let SeepageWorkspace { conductance, diagonal, body_fraction, .. } = workspace;
    let Soil { fraction, mass, .. } = soil;
    let grid = &model.grid;
    let cells =
        Cells { grid, fraction, mass, least_density: LEAST_DENSITY * model.least_density(), body_fraction };
    conductance.iter_mut().for_each(|field| field.fill(0.0));
    diagonal.fill(0.0);
    let inside = [0, 1, 2].map(|axis| grid.inside(axis));
    for (k, j) in inside[2].clone().flat_map(|k| inside[1].clone().map(move |j| (k, j))) {
        for layers in inside[0].clone().map(|i| [i, j, k]) {
            let cell = grid.index(layers[0], layers[1], layers[2]);
            if !cells.is_saturated(cell) {
                continue;
            }
            for axis in 0..3 {
                for end in [0, 1] {
                    let Some(flow) = cells.flow(layers, axis, end) else { continue };
                    diagonal[cell] += flow.conductance;
                    if flow.to_soil && end == 1 {
                        conductance[axis][cell] = flow.conductance;
                    }
                }
            }
        }
    }
}

/// How water flows through a face of a cell.
struct Flow {
    /// Area over distance [m].
    conductance: f64,
    /// Whether to soil with a pore pressure of its own; else to open water.
    to_soil: bool,
}

struct Cells<'a, R> {
    grid: &'a Grid,
    fraction: &'a [R],
    mass: &'a [R],
    /// Density of soil that holds a pressure [kg/m³].
    least_density: f64,
    body_fraction: &'a [f64],
}

impl<R: Scalar> Cells<'_, R> {
    /// Portion of a cell outside the bodies.
    fn open(&self, cell: usize) -> f64 {
        (1.0 - self.body_fraction[cell]).max(0.0)
    }

    /// Portion of that which soil fills.
    fn filled(&self, cell: usize) -> f64 {
        let (own, open) = (self.fraction[cell].to_f64(), self.open(cell));
        if own < open { own / open } else { 1.0 }
    }

    fn is_saturated(&self, cell: usize) -> bool {
        let fraction = self.fraction[cell].to_f64();
        let holds = self.mass[cell].to_f64() > self.least_density * fraction * self.grid.volume_of(cell);
        fraction > 0.0 && holds && (self.open(cell) <= SLICE || self.filled(cell) >= LEAST_FILLED)
    }

    /// Flow between a saturated cell and its neighbour along an axis, at the low end (0) or the high end (1);
    /// `None` where a wall, a plane of symmetry or a body lies between. Beyond open boundaries lies ground
    /// without excess pore pressure.
    fn flow(&self, layers: [usize; 3], axis: usize, end: usize) -> Option<Flow> {
        let mut beyond = layers;
        beyond[axis] = if end == 1 { layers[axis] + 1 } else { layers[axis].checked_sub(1)? };
        if beyond[axis] >= self.grid.cells()[axis] {
            return None;
        }
        let [own, other] = [layers, beyond].map(|[i, j, k]| self.grid.index(i, j, k));
        let [width, next] = [layers, beyond].map(|at| self.grid.width(axis, at[axis]));
        let area = self.grid.volume(layers[0], layers[1], layers[2]) / width;
        let middles = 0.5 * (width + next);
        if !self.grid.inside(axis).contains(&beyond[axis]) {
            return Some(Flow { conductance: area / middles, to_soil: false });
        }
        let to_soil = self.is_saturated(other);
        if !to_soil && self.open(other) <= SLICE {
            return None;
        }
        let open = 0.5 * (self.open(own) + self.open(other));
        let to_surface = (self.filled(own) - 0.5) * width + self.filled(other) * next;
        let distance = if to_soil { middles } else { to_surface.max(LEAST_DISTANCE * width) };
        Some(Flow { conductance: open * area / distance, to_soil })
    }
}
