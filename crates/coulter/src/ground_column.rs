//! The soil in a column of cells: where its surface is, and what bodies have made of it.

use crate::domain::PlacedDomain;
use serde::{Deserialize, Serialize};
use solver::fields::PLASTIC_STRAIN;
use solver::material::Material;
use solver::precision::Precision;
use solver::state::State;

/// The soil in a column of cells, in heights [m], that is volumes per area.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct GroundColumn {
    /// Height z of the surface.
    pub z: f64,
    /// Height by which the soil is lower than it would be at the density of its start; negative where it is looser.
    pub compaction: f64,
    /// Height of the voids below the surface, less that of soil above it.
    pub void: f64,
    /// Height of disturbed soil (see [`GroundColumn::DISTURBED`]).
    pub disturbed: f64,
    /// Height of mixed soil (see [`GroundColumn::MIXED`]).
    pub mixed: f64,
    /// Height z down to which soil is disturbed; that of the surface where none is.
    pub disturbed_to: f64,
}

impl GroundColumn {
    /// Equivalent plastic strain above which soil counts as disturbed: sand has left its first state by then, clay has lost a part of its
    /// strength (chosen).
    pub const DISTURBED: f64 = 0.1;
    /// The same above which soil counts as mixed: layers have been sheared past each other by their own thickness (chosen).
    pub const MIXED: f64 = 1.0;

    /// The soil in column `(i, j)` of a domain, of these materials, each as dense at the start as at
    /// the height of the cell.
    pub(crate) fn of(
        domain: &PlacedDomain,
        state: &State<impl Precision>,
        materials: &[Material],
        [i, j]: [usize; 2],
    ) -> Self {
        let soil = &state.soil;
        let z = domain.surface_height(state, [i, j]);
        let mut column = Self { z, disturbed_to: z, ..Self::default() };
        let (mut content, mut as_at_start) = (0.0, 0.0);
        let area = domain.width(0, i) * domain.width(1, j);
        for k in (0..domain.cells()[2]).rev() {
            let cell = domain.index([i, j, k]);
            let fraction: f64 = soil.fraction[cell].into();
            if fraction <= 0.0 {
                continue;
            }
            let height = fraction * domain.width(2, k);
            let middle = domain.centre(2, k);
            let first = materials[0].density_at(middle);
            let others = soil.composition.iter().zip(&materials[1..]);
            let density = others.fold(first, |sum, (portion, material)| {
                let portion: f64 = portion[cell].into();
                sum + portion * (material.density_at(middle) - first)
            });
            let mass: f64 = soil.mass[cell].into();
            content += height;
            as_at_start += mass / (area * density);
            let strain: f64 = soil.history[PLASTIC_STRAIN][cell].into();
            if strain > Self::DISTURBED {
                column.disturbed += height;
                column.disturbed_to = column.disturbed_to.min(domain.faces[2][k]);
            }
            if strain > Self::MIXED {
                column.mixed += height;
            }
        }
        column.compaction = as_at_start - content;
        column.void = z - domain.faces[2][0] - content;
        column
    }

    /// The undisturbed ground in a column whose cells hold these fractions of soil.
    pub(crate) fn undisturbed(domain: &PlacedDomain, held: impl Fn(usize) -> f64) -> Self {
        let z = domain.height_of(&held);
        let content: f64 = (0..domain.cells()[2]).map(|k| held(k) * domain.width(2, k)).sum();
        Self { z, disturbed_to: z, void: z - domain.faces[2][0] - content, ..Self::default() }
    }
}
