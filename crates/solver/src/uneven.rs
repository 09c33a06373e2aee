//! Volume fractions of ground that is not made of boxes: with an uneven surface, and with bodies of other
//! soil in it. They follow from samples of the surface and of the distances to the bodies.

use crate::grid::Grid;
use crate::model::{Ground, SoilBody};
use glam::DVec3;

/// Samples along each axis of a cell (chosen: a plane through a cube cuts its volume to 0.5 %).
const SAMPLES: usize = 6;
/// Portions of a cell that count as none or all of it: a surface that lies on a face up to rounding lies on
/// it.
const ROUNDING: f64 = 1e-9;

/// Calls `each(cell, portions)` for every cell with soil in it: the portions of its volume that each soil
/// body takes, and then each filling.
pub(crate) fn portions(grid: &Grid, ground: &Ground, mut each: impl FnMut(usize, &[f64])) {
    let [nx, ny, nz] = grid.cells();
    let mut found = vec![0.0; ground.bodies.len() + ground.fillings.len()];
    for j in 0..ny {
        for i in 0..nx {
            let rises = rises(grid, ground, [i, j]);
            for k in 0..nz {
                let cell = Cell::of(grid, [i, j, k]);
                let near: Vec<_> =
                    ground.bodies.iter().enumerate().filter(|(_, b)| cell.is_near(b)).collect();
                found.fill(0.0);
                if near.is_empty() {
                    cell.between_levels(ground, &rises, &mut found);
                } else {
                    cell.sampled(ground, &near, &mut found);
                }
                if found.iter().any(|portion| *portion > 0.0) {
                    each(grid.index(i, j, k), &found);
                }
            }
        }
    }
}

/// How far the surface lies above the level one over a column of cells [m], at points spread evenly over it;
/// at one where it is level.
fn rises(grid: &Grid, ground: &Ground, [i, j]: [usize; 2]) -> Vec<f64> {
    if ground.relief.is_level() {
        return vec![0.0];
    }
    let at = |axis: usize, layer: usize, n: usize| {
        grid.faces[axis][layer] + grid.width(axis, layer) * (n as f64 + 0.5) / SAMPLES as f64
    };
    let places = (0..SAMPLES).flat_map(|m| (0..SAMPLES).map(move |n| [n, m]));
    places.map(|[n, m]| ground.relief.at([at(0, i, n), at(1, j, m)])).collect()
}

/// Height of the ground's surface that lies so far above the level one, and of the top of a filling below
/// it [m].
fn top(ground: &Ground, filling: usize, rise: f64) -> f64 {
    let surface = ground.fillings[0].high.z + rise;
    if filling == 0 { surface } else { ground.fillings[filling].high.z.min(surface) }
}

/// A cell of a grid.
struct Cell {
    low: DVec3,
    width: DVec3,
}

impl Cell {
    fn of(grid: &Grid, at: [usize; 3]) -> Self {
        let along = |each: &dyn Fn(usize) -> f64| DVec3::from_array([each(0), each(1), each(2)]);
        Self {
            low: along(&|axis| grid.faces[axis][at[axis]]),
            width: along(&|axis| grid.width(axis, at[axis])),
        }
    }

    /// Whether a soil body may reach into the cell.
    fn is_near(&self, body: &SoilBody) -> bool {
        let [low, high] = body.bounds;
        let inside = self.low.cmplt(high).all() && (self.low + self.width).cmpgt(low).all();
        inside && body.distance(self.low + 0.5 * self.width) < 0.5 * self.width.length()
    }

    /// Portion of the height of the cell, or of a layer in it, between two levels [m].
    fn portion_of(&self, [low, high]: [f64; 2], [from, to]: [f64; 2]) -> f64 {
        let portion = (to.min(high) - from.max(low)) / (high - low);
        if portion < ROUNDING {
            0.0
        } else if portion > 1.0 - ROUNDING {
            1.0
        } else {
            portion
        }
    }

    /// The portions of the fillings where no body is near.
    fn between_levels(&self, ground: &Ground, rises: &[f64], found: &mut [f64]) {
        let ends = [self.low.z, self.low.z + self.width.z];
        for (n, filling) in ground.fillings.iter().enumerate() {
            let over = |rise: f64| self.portion_of(ends, [filling.low.z, top(ground, n, rise)]);
            let mean = rises.iter().map(|rise| over(*rise)).sum::<f64>() / rises.len() as f64;
            found[ground.bodies.len() + n] = mean;
        }
    }

    /// The portions of the bodies, the first of which takes what it covers, and of the fillings in what they
    /// leave. Samples are as nearly cubes as the cell allows, so that those at the surface of a body can be
    /// weighted.
    fn sampled(&self, ground: &Ground, near: &[(usize, &SoilBody)], found: &mut [f64]) {
        let (first, body) = near[0];
        if body.distance(self.low + 0.5 * self.width) <= -0.5 * self.width.length() {
            found[first] = 1.0;
            return;
        }
        let along = |width: f64| (SAMPLES as f64 * width / self.width.max_element()).ceil().max(2.0);
        let counts = self.width.to_array().map(along);
        let sample = self.width / DVec3::from_array(counts);
        let part = 1.0 / (counts[0] * counts[1] * counts[2]);
        let [nx, ny, nz] = counts.map(|count| count as usize);
        for n in 0..nx * ny * nz {
            let number = DVec3::new((n % nx) as f64, (n / nx % ny) as f64, (n / nx / ny) as f64);
            let middle = self.low + sample * (number + 0.5);
            let mut left = 1.0;
            for (body, soil) in near {
                let covered = left * (0.5 - soil.distance(middle) / sample.max_element()).clamp(0.0, 1.0);
                found[*body] += part * covered;
                left -= covered;
            }
            let rise = ground.relief.at([middle.x, middle.y]);
            let ends = [middle.z - 0.5 * sample.z, middle.z + 0.5 * sample.z];
            for (n, filling) in ground.fillings.iter().enumerate() {
                let portion = self.portion_of(ends, [filling.low.z, top(ground, n, rise)]);
                found[ground.bodies.len() + n] += part * left * portion;
            }
        }
        let rounded = |portion: &f64| if *portion < ROUNDING { 0.0 } else { portion.min(1.0) };
        found.iter_mut().for_each(|portion| *portion = rounded(portion));
    }
}
