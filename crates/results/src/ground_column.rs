//! The soil in a column of cells: where its surface is, and what bodies have made of it.

use crate::domain::PlacedDomain;
use serde::{Deserialize, Serialize};
use solver::fields::PLASTIC_STRAIN;
use solver::halo::Halo;
use solver::material::Material;
use solver::precision::Precision;
use solver::state::State;

/// The soil in a column of cells, in heights [m], that is volumes per area.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct GroundColumn {
    /// Height z of the surface.
    pub z: f64,
    /// Height by which the soil is lower than it would be at the density of its start; negative where it is
    /// looser.
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
    /// Equivalent plastic strain above which soil counts as disturbed: sand has left its first state by then,
    /// clay has lost a part of its strength (chosen).
    pub const DISTURBED: f64 = 0.1;
    /// Equivalent plastic strain above which soil counts as mixed: layers have been sheared past each other
    /// by their own thickness (chosen).
    pub const MIXED: f64 = 1.0;

    /// Number of numbers of a column.
    pub(crate) const NUMBERS: usize = 6;

    /// The numbers of the column.
    pub(crate) fn to_array(self) -> [f64; Self::NUMBERS] {
        let Self { z, compaction, void, disturbed, mixed, disturbed_to } = self;
        [z, compaction, void, disturbed, mixed, disturbed_to]
    }

    /// The column of these numbers.
    pub(crate) fn from_numbers(numbers: &[f64]) -> Self {
        let [z, compaction, void, disturbed, mixed, disturbed_to] = std::array::from_fn(|n| numbers[n]);
        Self { z, compaction, void, disturbed, mixed, disturbed_to }
    }

    /// The soil in columns `(i, j)` of a domain, of these materials, each as dense at the start as at the
    /// height of the cell. Where the grid is cut along z, what the blocks above have found is passed down,
    /// and only those at the bottom know the whole of their columns; the others return none.
    pub(crate) fn of_all(
        domain: &PlacedDomain,
        state: &State<impl Precision>,
        (materials, halo): (&[Material], &Halo),
        places: &[[usize; 2]],
    ) -> Vec<Self> {
        let numbers = vec![Column::default().to_array(); places.len()];
        let numbers = downwards(halo, numbers, |columns| {
            for (numbers, place) in columns.iter_mut().zip(places) {
                let mut column = Column::of(numbers);
                column.descend(domain, state, materials, *place);
                *numbers = column.to_array();
            }
        });
        let columns: Vec<Column> = numbers.iter().map(|numbers| Column::of(numbers)).collect();
        if !domain.reaches(2, 0) {
            return Vec::new();
        }
        let floor = domain.faces[2][0];
        columns.iter().map(|column| column.finish(floor)).collect()
    }

    /// The undisturbed ground in a column whose cells hold these fractions of soil.
    pub(crate) fn undisturbed(domain: &PlacedDomain, held: impl Fn(usize) -> f64) -> Self {
        let mut column = Column::default();
        (0..domain.cells()[2]).rev().for_each(|k| column.find_surface(domain, k, held(k)));
        let Self { z, .. } = column.finish(domain.faces[2][0]);
        let content: f64 = (0..domain.cells()[2]).map(|k| held(k) * domain.width(2, k)).sum();
        Self { z, disturbed_to: z, void: z - domain.faces[2][0] - content, ..Self::default() }
    }
}

/// Numbers of columns of cells after a block has gone down its own layers of them: what the blocks above have
/// found is passed down to it first, and only those at the bottom know the whole of their columns.
pub(crate) fn downwards<const N: usize>(
    halo: &Halo,
    mut columns: Vec<[f64; N]>,
    mut descend: impl FnMut(&mut [[f64; N]]),
) -> Vec<[f64; N]> {
    let [below, above] = halo.beyond(2);
    for turn in 0..=above + below {
        if turn == above {
            descend(&mut columns);
        }
        if turn < above + below {
            let own = columns.concat();
            let [_, from_above] = halo.exchange(2, [own.clone(), own]);
            if turn < above {
                let (numbers, _) = from_above.as_chunks::<N>();
                columns = numbers.to_vec();
            }
        }
    }
    columns
}

/// What is known of a column down to some layer.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Column {
    /// Height of the surface [m]; not a number as long as none is found.
    surface: f64,
    /// Height of the soil in the lowest layer so far [m].
    lowest: f64,
    /// Height of all soil so far [m].
    content: f64,
    /// Height that all soil so far would have at the density of its start [m].
    as_at_start: f64,
    disturbed: f64,
    mixed: f64,
    /// Lowest floor of a disturbed cell; infinite where there is none [m].
    disturbed_to: f64,
}

impl Default for Column {
    fn default() -> Self {
        Self::of(&[f64::NAN, 0.0, 0.0, 0.0, 0.0, 0.0, f64::INFINITY])
    }
}

impl Column {
    const NUMBERS: usize = 7;

    fn to_array(self) -> [f64; Self::NUMBERS] {
        let Self { surface, lowest, content, as_at_start, disturbed, mixed, disturbed_to } = self;
        [surface, lowest, content, as_at_start, disturbed, mixed, disturbed_to]
    }

    fn of(numbers: &[f64]) -> Self {
        let [surface, lowest, content, as_at_start, disturbed, mixed, disturbed_to] =
            std::array::from_fn(|n| numbers[n]);
        Self { surface, lowest, content, as_at_start, disturbed, mixed, disturbed_to }
    }

    /// Adds the layers of a domain, from above.
    fn descend(
        &mut self,
        domain: &PlacedDomain,
        state: &State<impl Precision>,
        materials: &[Material],
        [i, j]: [usize; 2],
    ) {
        let soil = &state.soil;
        let area = domain.width(0, i) * domain.width(1, j);
        for k in (0..domain.cells()[2]).rev() {
            let cell = domain.index([i, j, k]);
            let fraction: f64 = soil.fraction[cell].into();
            self.find_surface(domain, k, fraction);
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
            self.content += height;
            self.as_at_start += mass / (area * density);
            let strain: f64 = soil.history[PLASTIC_STRAIN][cell].into();
            if strain > GroundColumn::DISTURBED {
                self.disturbed += height;
                self.disturbed_to = self.disturbed_to.min(domain.faces[2][k]);
            }
            if strain > GroundColumn::MIXED {
                self.mixed += height;
            }
        }
    }

    /// The surface lies in the uppermost cell that is at least half full: the soil of this and of the cell
    /// above it, heaped on the floor of the former. Detached soil above and voids below do not count.
    fn find_surface(&mut self, domain: &PlacedDomain, k: usize, fraction: f64) {
        let fraction = fraction.clamp(0.0, 1.0);
        let height = fraction * domain.width(2, k);
        if self.surface.is_nan() && fraction >= 0.5 {
            self.surface = domain.faces[2][k] + height + self.lowest;
        }
        self.lowest = height;
    }

    /// The whole column, on its floor [m].
    fn finish(&self, floor: f64) -> GroundColumn {
        let z = if self.surface.is_nan() { floor + self.lowest } else { self.surface };
        GroundColumn {
            z,
            compaction: self.as_at_start - self.content,
            void: z - floor - self.content,
            disturbed: self.disturbed,
            mixed: self.mixed,
            disturbed_to: self.disturbed_to.min(z),
        }
    }
}
