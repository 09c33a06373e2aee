//! The soil volume that crosses the faces of cells in a sweep along one axis, from the surface that is
//! reconstructed in each partly filled cell.

use super::transport::Sweep;
use super::{FULL, Real};
use crate::layout::Part;
use ::physics::double::select::{max, min};
use ::physics::interface::Plane;

/// What the fluxes follow from, at the start of a sweep.
#[derive(Clone, Copy, Debug)]
pub struct FluxInputs<'a> {
    /// The sweep.
    pub sweep: Sweep<'a>,
    /// Nodal displacement along the axis since the last remap [m].
    pub displacement: &'a [Real],
    /// Volume fraction.
    pub fraction: &'a [Real],
    /// Soil volume in the (displaced) cell [m³].
    pub soil: &'a [Real],
    /// Volume of the displaced cell [m³].
    pub cell: &'a [Real],
}

impl FluxInputs<'_> {
    /// Soil volume that crosses the low faces of a part of a row of cells [m³].
    #[inline(always)]
    pub fn volume_fluxes(&self, part: Part, flux: &mut [Real]) {
        flux.fill(0.0);
        self.sweep.each_cell(part, |c, layers| flux[c - part.start] = self.volume_flux(c, layers));
    }

    /// Soil volume that crosses the low face of a cell [m³].
    #[inline(always)]
    fn volume_flux(&self, c: usize, layers: [usize; 3]) -> Real {
        let Sweep { layout, axis, .. } = self.sweep;
        if layers[axis] == 0 {
            return 0.0;
        }
        let phi = self.sweep.swept(self.displacement, c, layers);
        if phi == 0.0 {
            return 0.0;
        }
        let donor = if phi > 0.0 { c - layout.stride[axis] } else { c };
        let fraction = f64::from(self.fraction[donor]);
        let (soil, cell) = (f64::from(self.soil[donor]), f64::from(self.cell[donor]));
        let through = if fraction >= FULL {
            phi.abs()
        } else if fraction <= 0.0 {
            0.0
        } else {
            let plane = Plane::new(self.normal(donor), fraction);
            plane.slab(axis, phi > 0.0, phi.abs() / cell) * cell
        };
        // The void must not be overdrawn either: these bounds keep the fraction between 0 and 1.
        let void = cell - soil;
        let bounded = min(min(max(max(through, phi.abs() - void), 0.0), soil), phi.abs());
        bounded.copysign(phi) as Real
    }

    /// Normal of the surface in a cell, from soil to void, in unit-cell coordinates: from the heights of the
    /// columns round it where the surface is a graph there, else from the smoothed gradient of the volume
    /// fraction.
    fn normal(&self, c: usize) -> [f64; 3] {
        let youngs = self.normal_from_gradient(c);
        self.normal_from_heights(c, youngs).unwrap_or(youngs)
    }

    /// Second-order normal from the heights of soil in the four columns beside the cell (Cummins, Francois &
    /// Kothe 2005); `None` where a column does not reach from full to void within two cells up and down.
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
        let layout = self.sweep.layout;
        let (layers, cells) = (layout.layers_of(c), layout.cells);
        let [first, second] = [(up + 1) % 3, (up + 2) % 3];
        let inside = |axis: usize, reach: usize| layers[axis] >= reach && layers[axis] + reach < cells[axis];
        if !inside(up, REACH) {
            return None;
        }
        let stride = layout.stride[up];
        let height = |middle: usize| {
            let low = middle - REACH * stride;
            let fraction = |n: usize| f64::from(self.fraction[low + n * stride]);
            let (bottom, top) = (fraction(0), fraction(2 * REACH));
            let full_to_void = (bottom > FULL && top == 0.0) || (bottom == 0.0 && top > FULL);
            // From both ends to the middle: upside down the sum is the same to the bit.
            let pair = |n: usize| fraction(n) + fraction(2 * REACH - n);
            full_to_void.then_some((pair(0) + pair(1)) + fraction(REACH))
        };
        let slope = |axis: usize| -> Option<f64> {
            if cells[axis] == 1 {
                return Some(0.0);
            }
            let s = layout.stride[axis];
            inside(axis, 1).then_some(())?;
            Some(0.5 * (height(c + s)? - height(c - s)?))
        };
        let mut normal = [0.0; 3];
        normal[up] = rough[up].signum();
        normal[first] = -slope(first)?;
        normal[second] = -slope(second)?;
        Some(normal)
    }

    /// Normal from the gradient of the volume fraction over 27 cells (Youngs 1984); neighbours outside the
    /// grid are taken equal to the cells inside.
    fn normal_from_gradient(&self, c: usize) -> [f64; 3] {
        let layout = self.sweep.layout;
        let layers = layout.layers_of(c);
        let cells = layout.cells;
        // Offsets to the neighbours, or 0 where there is none.
        let offset: [[usize; 3]; 3] = std::array::from_fn(|axis| {
            let s = layout.stride[axis];
            let low = if layers[axis] > 0 { s.wrapping_neg() } else { 0 };
            let high = if layers[axis] + 1 < cells[axis] { s } else { 0 };
            [low, 0, high]
        });
        const WEIGHT: [f64; 3] = [1.0, 2.0, 1.0];
        let mut gradient = [0.0; 3];
        for (z, dz) in offset[2].iter().enumerate() {
            for (x, dx) in offset[0].iter().enumerate() {
                // The two sides of y are added first: a mirror in y then changes no bit.
                let [low, middle, high] = offset[1].map(|dy| {
                    f64::from(self.fraction[c.wrapping_add(*dx).wrapping_add(dy).wrapping_add(*dz)])
                });
                let sum = (low + high) + 2.0 * middle;
                gradient[0] += sum * WEIGHT[z] * (x as f64 - 1.0);
                gradient[1] += (high - low) * WEIGHT[x] * WEIGHT[z];
                gradient[2] += sum * WEIGHT[x] * (z as f64 - 1.0);
            }
        }
        gradient.map(|g| -g)
    }
}

/// Lets nothing flow through a face towards the cell above it, if `side` is positive, or else below it.
#[inline(always)]
pub fn close_face(flux: &mut Real, side: Real) {
    if *flux * side > 0.0 {
        *flux = 0.0;
    }
}
