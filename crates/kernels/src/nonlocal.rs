//! The passes by which the relative density of sand with a characteristic length is averaged.

use super::Real;
use super::physics::sand::Sand;
use crate::layout::{Layout, Part};

/// Weight of the average in the nonlocal value. Above 1 it limits the width of bands from below (Vermeer &
/// Brinkgreve 1994).
pub const OVERWEIGHT: Real = 1.5;

/// The sand that is averaged, and the grid.
#[derive(Clone, Copy, Debug)]
pub struct Averaged<'a> {
    /// The grid.
    pub layout: Layout<'a>,
    /// Widths of the columns [m], 0 in ghosts.
    pub width_x: &'a [Real],
    /// The law of the sand.
    pub law: &'a Sand,
    /// Volume fractions.
    pub fraction: &'a [Real],
    /// Masses of the cells [kg], as if all soil of a cell were of its main material.
    pub mass: &'a [Real],
    /// The main material of each cell; empty where there is only one.
    pub material: &'a [u8],
    /// The number of the sand.
    pub number: u8,
}

impl Averaged<'_> {
    /// Calls `job(index in the part, cell, relative density)` for the cells of a part of a row with this
    /// sand.
    #[inline(always)]
    fn each_cell(&self, part: Part, mut job: impl FnMut(usize, usize, Real)) {
        self.layout.each_cell(part, |c, [i, j, k]| {
            let area = (self.layout.width(1, j) * self.layout.width(2, k)) as Real;
            let is_own = self.material.is_empty() || self.material[c] == self.number;
            if self.fraction[c] > 0.0 && is_own {
                let volume = self.width_x[i + 1] * area;
                let density = self.law.relative_density(self.mass[c] / (self.fraction[c] * volume));
                job(c - part.start, c, density);
            }
        });
    }

    /// Volume fraction of the sand in a part of a row, and its relative density times that; 0 elsewhere.
    #[inline(always)]
    pub fn collect(&self, part: Part, [fractions, densities]: [&mut [Real]; 2]) {
        fractions.fill(0.0);
        densities.fill(0.0);
        self.each_cell(part, |own, c, density| {
            (fractions[own], densities[own]) = (self.fraction[c], self.fraction[c] * density);
        });
    }

    /// The difference between the average and the own relative density of the cells of a part of a row, from
    /// the averages of what was collected.
    #[inline(always)]
    pub fn store(&self, part: Part, [fractions, densities]: [&[Real]; 2], out: &mut [Real]) {
        out.fill(0.0);
        self.each_cell(part, |own, c, density| {
            out[own] = OVERWEIGHT * (densities[c] / fractions[c] - density);
        });
    }
}

/// A pass along an axis: what a cell takes over of the differences to its lower and its higher neighbour, for
/// each layer.
#[derive(Clone, Copy, Debug)]
pub struct Spread<'a> {
    /// The grid.
    pub layout: Layout<'a>,
    /// The axis.
    pub axis: usize,
    /// Weights of the lower and of the higher neighbour.
    pub weights: &'a [[Real; 2]],
}

impl Spread<'_> {
    /// The pass over a part of a row of one field.
    #[inline(always)]
    pub fn pass(&self, part: Part, from: &[Real], to: &mut [Real]) {
        let Self { layout, axis, weights } = *self;
        let ([_, row, _], columns) = (layout.stride, layout.columns(part));
        let Some([j, k]) = layout.layers_of_row(part.start / row).filter(|_| !columns.is_empty()) else {
            return;
        };
        let (first, n, s) =
            (part.start - part.start % row + columns.start, columns.len(), layout.stride[axis]);
        let [low, own, high] = [first - s, first, first + s].map(|first| &from[first..first + n]);
        let to = &mut to[first - part.start..first - part.start + n];
        if axis == 0 {
            let weights = &weights[columns.start - 1..columns.start - 1 + n];
            for i in 0..n {
                let [down, up] = weights[i];
                to[i] = own[i] + down * (low[i] - own[i]) + up * (high[i] - own[i]);
            }
        } else {
            let [down, up] = weights[[j, k][axis - 1]];
            for i in 0..n {
                to[i] = own[i] + down * (low[i] - own[i]) + up * (high[i] - own[i]);
            }
        }
    }
}
