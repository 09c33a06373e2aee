//! Transport along one axis: the soil that crosses the faces, and what it carries.
//!
//! All functions work on one plane of cells (or nodes) and read whole arrays; they write only the plane they are given.
//! "Low face" of a cell is the one towards smaller coordinates; face values are kept at the cell above it.

use crate::grid::Grid;
use physics::interface::Plane;
use physics::limiter::monotonised_central;

/// A sweep along one axis.
pub(crate) struct Sweep<'a> {
    pub(crate) grid: &'a Grid,
    /// The axis: 0, 1, 2.
    pub(crate) axis: usize,
    /// Nodal displacement along the axis since the last remap [m].
    pub(crate) displacement: &'a [f64],
    /// Volume fraction at the start of the sweep.
    pub(crate) fraction: &'a [f64],
    /// Soil volume in the (displaced) cell at the start of the sweep [m³].
    pub(crate) soil: &'a [f64],
    /// Volume of the displaced cell at the start of the sweep [m³].
    pub(crate) cell: &'a [f64],
    /// Rows that may hold soil now or after the sweep, by plane and row.
    pub(crate) row_active: &'a [bool],
}

/// Above this a cell counts as full: no interface is looked for.
const FULL: f64 = 1.0 - 1e-9;

impl Sweep<'_> {
    /// Distance in memory to the next cell along the axis.
    pub(crate) fn stride(&self) -> usize {
        self.grid.stride[self.axis]
    }

    /// Calls `job(cell, [i, j])` for the active cells (0-based layers along x and y) of a storage plane.
    fn each_cell(&self, plane: usize, mut job: impl FnMut(usize, [usize; 2])) {
        let [nx, ny, nz] = self.grid.cells();
        let [_, row, stride] = self.grid.stride;
        if plane > nz {
            return;
        }
        for j in 0..ny {
            if self.row_active[plane * (stride / row) + j + 1] {
                let start = plane * stride + (j + 1) * row + 1;
                for i in 0..nx {
                    job(start + i, [i, j]);
                }
            }
        }
    }

    /// Layer of a cell along the axis.
    fn layer(&self, plane: usize, [i, j]: [usize; 2]) -> usize {
        [i, j, plane - 1][self.axis]
    }

    /// Volume swept by the low face of a cell [m³]: face area times the mean displacement of its four nodes.
    fn swept(&self, c: usize, plane: usize, [i, j]: [usize; 2]) -> f64 {
        let [first, second] = [(self.axis + 1) % 3, (self.axis + 2) % 3];
        let layers = [i, j, plane - 1];
        let area = self.grid.width(first, layers[first]) * self.grid.width(second, layers[second]);
        let (a, b) = (self.grid.stride[first], self.grid.stride[second]);
        let u = self.displacement;
        0.25 * area * ((u[c] + u[c + a]) + (u[c + b] + u[c + a + b]))
    }

    /// Soil volume that crosses the low faces of a plane of cells [m³], and in `swept` the volume that they sweep.
    pub(crate) fn volume_fluxes(&self, plane: usize, flux: &mut [f64], swept: &mut [f64]) {
        let base = plane * self.grid.stride[2];
        flux.fill(0.0);
        swept.fill(0.0);
        let stride = self.stride();
        self.each_cell(plane, |c, place| {
            if self.layer(plane, place) == 0 {
                return;
            }
            let phi = self.swept(c, plane, place);
            swept[c - base] = phi;
            if phi == 0.0 {
                return;
            }
            let donor = if phi > 0.0 { c - stride } else { c };
            let fraction = self.fraction[donor];
            let through = if fraction >= FULL {
                phi.abs()
            } else if fraction <= 0.0 {
                0.0
            } else {
                let plane = Plane::new(self.normal(donor), fraction);
                let share = phi.abs() / self.cell[donor];
                plane.slab(self.axis, phi > 0.0, share) * self.cell[donor]
            };
            // The void must not be overdrawn either: these bounds keep the fraction between 0 and 1.
            let void = self.cell[donor] - self.soil[donor];
            let bounded = through.max(phi.abs() - void).max(0.0).min(self.soil[donor]).min(phi.abs());
            flux[c - base] = bounded.copysign(phi);
        });
    }

    /// Normal of the surface in a cell, from soil to void, in unit-cell coordinates: from the heights of the columns round
    /// it where the surface is a graph there, else from the smoothed gradient of the volume fraction.
    fn normal(&self, c: usize) -> [f64; 3] {
        let youngs = self.normal_from_gradient(c);
        self.normal_from_heights(c, youngs).unwrap_or(youngs)
    }

    /// Second-order normal from the heights of soil in the four columns beside the cell (Cummins, Francois & Kothe 2005);
    /// `None` where a column does not reach from full to void within three cells up and down.
    fn normal_from_heights(&self, c: usize, rough: [f64; 3]) -> Option<[f64; 3]> {
        const REACH: usize = 2;
        let size = rough.map(f64::abs);
        let up = if size[0] >= size[1] && size[0] >= size[2] {
            0
        } else if size[1] >= size[2] {
            1
        } else {
            2
        };
        let place = self.grid.place(c);
        let cells = self.grid.cells();
        let [first, second] = [(up + 1) % 3, (up + 2) % 3];
        let inside = |axis: usize, reach: usize| place[axis] >= reach && place[axis] + reach < cells[axis];
        if !inside(up, REACH) {
            return None;
        }
        let stride = self.grid.stride[up];
        let height = |middle: usize| {
            let low = middle - REACH * stride;
            let (bottom, top) = (self.fraction[low], self.fraction[low + 2 * REACH * stride]);
            let full_to_void = (bottom > FULL && top == 0.0) || (bottom == 0.0 && top > FULL);
            // From both ends to the middle: upside down the sum is the same to the bit.
            let pair =
                |n: usize| self.fraction[low + n * stride] + self.fraction[low + (2 * REACH - n) * stride];
            full_to_void.then_some((pair(0) + pair(1)) + self.fraction[middle])
        };
        let slope = |axis: usize| -> Option<f64> {
            if cells[axis] == 1 {
                return Some(0.0);
            }
            let s = self.grid.stride[axis];
            inside(axis, 1).then_some(())?;
            Some(0.5 * (height(c + s)? - height(c - s)?))
        };
        let mut normal = [0.0; 3];
        normal[up] = rough[up].signum();
        normal[first] = -slope(first)?;
        normal[second] = -slope(second)?;
        Some(normal)
    }

    /// Normal from the gradient of the volume fraction over 27 cells (Youngs 1984); neighbours outside the grid are taken
    /// equal to the cells inside.
    fn normal_from_gradient(&self, c: usize) -> [f64; 3] {
        let grid = self.grid;
        let place = grid.place(c);
        let cells = grid.cells();
        // Offsets to the neighbours, or 0 where there is none.
        let offset: [[isize; 3]; 3] = std::array::from_fn(|axis| {
            let s = grid.stride[axis].cast_signed();
            let low = if place[axis] > 0 { -s } else { 0 };
            let high = if place[axis] + 1 < cells[axis] { s } else { 0 };
            [low, 0, high]
        });
        const WEIGHT: [f64; 3] = [1.0, 2.0, 1.0];
        let mut gradient = [0.0; 3];
        for (z, dz) in offset[2].iter().enumerate() {
            for (x, dx) in offset[0].iter().enumerate() {
                // The two sides of y are added first: a mirror in y then changes no bit.
                let [low, middle, high] =
                    offset[1].map(|dy| self.fraction[c.wrapping_add_signed(dx + dy + dz)]);
                let sum = (low + high) + 2.0 * middle;
                gradient[0] += sum * WEIGHT[z] * (x as f64 - 1.0);
                gradient[1] += (high - low) * WEIGHT[x] * WEIGHT[z];
                gradient[2] += sum * WEIGHT[x] * (z as f64 - 1.0);
            }
        }
        gradient.map(|g| -g)
    }

    /// Value carried through the low face of cell `c` by soil flux `flux`: the donor's, moved by a limited slope where
    /// the donor is full and both its neighbours hold soil.
    #[inline(always)]
    fn carried(&self, c: usize, flux: f64, value: impl Fn(usize) -> f64) -> f64 {
        let s = self.stride();
        let (donor, up, side) = if flux > 0.0 { (c - s, c - 2 * s, 0.5) } else { (c, c + s, -0.5) };
        let down = if flux > 0.0 { c } else { c - s };
        let own = value(donor);
        let smooth = (self.fraction[donor] > 0.99) & (self.fraction[up] > 0.5) & (self.fraction[down] > 0.5);
        if !smooth {
            return own;
        }
        // Differences along the axis, from low to high.
        let (low, high) = if flux > 0.0 { (up, down) } else { (down, up) };
        let slope = monotonised_central(own - value(low), value(high) - own);
        let share = flux.abs() / self.soil[donor];
        own + side * (1.0 - share) * slope
    }

    /// Mass that crosses the low faces of a plane of cells [kg].
    pub(crate) fn mass_fluxes(&self, plane: usize, mass: &[f64], flux: &[f64], out: &mut [f64]) {
        let base = plane * self.grid.stride[2];
        out.fill(0.0);
        let density = |c: usize| if self.soil[c] > 0.0 { mass[c] / self.soil[c] } else { 0.0 };
        self.each_cell(plane, |c, _| {
            if flux[c] != 0.0 {
                out[c - base] = flux[c] * self.carried(c, flux[c], density);
            }
        });
    }

    /// New value of a carried field in a plane of cells.
    pub(crate) fn carry(&self, plane: usize, field: &[f64], flux: &[f64], out: &mut [f64]) {
        let base = plane * self.grid.stride[2];
        let s = self.stride();
        out.copy_from_slice(&field[base..base + out.len()]);
        self.each_cell(plane, |c, _| {
            let (low, high) = (flux[c], flux[c + s]);
            if low == 0.0 && high == 0.0 {
                return;
            }
            let left = self.soil[c] - (high - low);
            let into = if low == 0.0 { 0.0 } else { low * self.carried(c, low, |n| field[n]) };
            let out_of = if high == 0.0 { 0.0 } else { high * self.carried(c + s, high, |n| field[n]) };
            out[c - base] = if left > 0.0 { (field[c] * self.soil[c] - (out_of - into)) / left } else { 0.0 };
        });
    }
}

/// Mass that crosses the dual faces between node `n` and the next along the axis [kg], for a plane of nodes.
pub(crate) fn dual_fluxes(grid: &Grid, axis: usize, plane: usize, mass_flux: &[f64], out: &mut [f64]) {
    let [_, row, stride] = grid.stride;
    let base = plane * stride;
    let s = grid.stride[axis];
    let [a, b] = [grid.stride[(axis + 1) % 3], grid.stride[(axis + 2) % 3]];
    out.fill(0.0);
    for q in 1..=grid.cells()[1] + 1 {
        for i in 1..=grid.cells()[0] + 1 {
            let n = base + q * row + i;
            if [i, q, plane][axis] > grid.cells()[axis] {
                continue;
            }
            let at = |c: usize| mass_flux[c] + mass_flux[c + s];
            out[n - base] = 0.125 * ((at(n) + at(n - a)) + (at(n - b) + at(n - a - b)));
        }
    }
}

/// Calls `job(node, [low, high])` for every node of a plane with what flows in through the dual face below it and out
/// through that above; nothing flows beyond the ends of the grid.
fn each_node(grid: &Grid, axis: usize, plane: usize, flux: &[f64], mut job: impl FnMut(usize, [f64; 2])) {
    let [_, row, stride] = grid.stride;
    let s = grid.stride[axis];
    let cells = grid.cells();
    for q in 1..=cells[1] + 1 {
        for i in 1..=cells[0] + 1 {
            let n = plane * stride + q * row + i;
            let layer = [i, q, plane][axis] - 1;
            let high = if layer < cells[axis] { flux[n] } else { 0.0 };
            let low = if layer > 0 { flux[n - s] } else { 0.0 };
            job(n, [low, high]);
        }
    }
}

/// New masses of a plane of nodes after the dual fluxes.
pub(crate) fn carry_mass(grid: &Grid, axis: usize, plane: usize, flux: &[f64], out: &mut [f64]) {
    let base = plane * grid.stride[2];
    each_node(grid, axis, plane, flux, |n, [low, high]| out[n - base] -= high - low);
}

/// New velocity component of a plane of nodes after the dual fluxes have carried momentum.
pub(crate) fn carry_momentum(
    grid: &Grid,
    axis: usize,
    plane: usize,
    [velocity, mass, flux]: [&[f64]; 3],
    mass_moved: f64,
    out: &mut [f64],
) {
    let base = plane * grid.stride[2];
    let s = grid.stride[axis];
    out.copy_from_slice(&velocity[base..base + out.len()]);
    each_node(grid, axis, plane, flux, |n, [low, high]| {
        if high == 0.0 && low == 0.0 {
            return;
        }
        let through = |n: usize, flux: f64| carried_velocity([velocity, mass], n, s, flux, mass_moved);
        let into = if low == 0.0 { 0.0 } else { through(n - s, low) };
        let out_of = if high == 0.0 { 0.0 } else { through(n, high) };
        let left = mass[n] - (high - low);
        let old = velocity[n];
        let new = if left > 0.0 { (mass[n] * old - (high * out_of - low * into)) / left } else { 0.0 };
        // Where more flows out than there was, rounding decides: stay within what flowed in.
        let overdrawn = high.max(0.0) - low.min(0.0) > 0.5 * mass[n];
        let bounds = [old, if low > 0.0 { into } else { old }, if high < 0.0 { out_of } else { old }];
        let (least, most) = bounds.iter().fold((old, old), |(a, b), v| (a.min(*v), b.max(*v)));
        out[n - base] = if overdrawn { new.clamp(least, most) } else { new };
    });
}

/// Velocity carried over the dual face above node `n`.
fn carried_velocity([velocity, mass]: [&[f64]; 2], n: usize, s: usize, flux: f64, mass_moved: f64) -> f64 {
    let (donor, up, down, side) =
        if flux > 0.0 { (n, n - s, n + s, 0.5) } else { (n + s, n + 2 * s, n, -0.5) };
    let own = velocity[donor];
    let has_mass = |n: usize| mass.get(n).is_some_and(|m| *m > mass_moved);
    if !(has_mass(up) && has_mass(down)) {
        return own;
    }
    let (low, high) = if flux > 0.0 { (up, down) } else { (down, up) };
    let slope = monotonised_central(own - velocity[low], velocity[high] - own);
    own + side * (1.0 - (flux.abs() / mass[donor]).min(1.0)) * slope
}
