//! The fields of the soil.
//!
//! A history variable is one line of [`HISTORY`]: remaps and overlap removal transport it, field files and
//! checkpoints contain it.

use crate::grid::Grid;
pub use ::kernels::history::*;
use ::kernels::mixture;
use serde::{Deserialize, Serialize};

/// Names of the stress components, in the order of [`Soil::stress`].
pub const STRESS_NAMES: [&str; 6] = ["xx", "yy", "zz", "xy", "yz", "xz"];

/// Fields of the cells. Each array covers the grid with its ghosts (see [`Grid::index`]).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Soil<R = f64> {
    /// Eulerian volume fraction, 0 to 1.
    pub fraction: Vec<R>,
    /// Mass of soil in the cell [kg].
    pub mass: Vec<R>,
    /// Volume strain of the soil apart from that of its cell, since the last remap: positive where a void was
    /// lent to it, which must close before it can be compressed, negative where soil that overlapped a body
    /// was pressed. Not carried with the soil.
    pub apart: Vec<R>,
    /// Cauchy stress of the soil (not scaled by the fraction), tension positive: xx, yy, zz, xy, yz, xz [Pa].
    pub stress: [Vec<R>; 6],
    /// History variables, in the order of [`HISTORY`].
    pub history: [Vec<R>; HISTORY_COUNT],
    /// Fractions of the soil in the cell that are of the second material, the third, …; the rest is of the
    /// first.
    pub composition: Vec<Vec<R>>,
}

/// What is done with nodes that have been moved, and their velocities before [m/s].
pub type Known<'a, R> = dyn FnMut(&Nodes<R>, &[Vec<R>; 3]) + 'a;

/// Fields of the nodes. Each array covers the grid with its ghosts (see [`Grid::index`]).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Nodes<R = f64> {
    /// Velocity along x, y, z [m/s].
    pub velocity: [Vec<R>; 3],
    /// Displacement since the last remap along x, y, z [m].
    pub displacement: [Vec<R>; 3],
    /// Mass lumped from the eight cells around the node [kg].
    pub mass: Vec<R>,
}

impl<R> Soil<R> {
    /// Kinds of materials that the soil has arrays for.
    #[must_use]
    pub fn kinds(&self) -> Kinds {
        let has = |kind| {
            HISTORY
                .iter()
                .zip(&self.history)
                .any(|(variable, field)| variable.needed_by == kind && !field.is_empty())
        };
        Kinds { sand: has(Needing::Sand), clay: has(Needing::Clay), water: has(Needing::Water) }
    }

    /// Everything that is transported with the soil besides volume and mass: stress, composition, history.
    pub fn carried(&self) -> impl Iterator<Item = (Carrier, &Vec<R>)> {
        let history =
            HISTORY.iter().map(|h| h.carrier).zip(&self.history).filter(|(_, field)| !field.is_empty());
        self.stress.iter().chain(&self.composition).map(|field| (Carrier::Volume, field)).chain(history)
    }

    /// Mutable version of [`Soil::carried`].
    pub fn carried_mut(&mut self) -> impl Iterator<Item = (Carrier, &mut Vec<R>)> {
        let history =
            HISTORY.iter().map(|h| h.carrier).zip(&mut self.history).filter(|(_, field)| !field.is_empty());
        let rest = self.stress.iter_mut().chain(&mut self.composition);
        rest.map(|field| (Carrier::Volume, field)).chain(history)
    }

    /// All arrays of the soil.
    pub fn arrays(&self) -> impl Iterator<Item = &Vec<R>> {
        [&self.fraction, &self.mass, &self.apart].into_iter().chain(self.carried().map(|(_, field)| field))
    }

    /// The arrays that change as the soil is strained: stress and what there is of history.
    pub fn strained(&self) -> impl Iterator<Item = &Vec<R>> {
        self.stress.iter().chain(self.history.iter().filter(|field| !field.is_empty()))
    }

    /// The arrays that change as the soil is strained, mutable.
    pub fn strained_mut(&mut self) -> impl Iterator<Item = &mut Vec<R>> {
        self.stress.iter_mut().chain(self.history.iter_mut().filter(|field| !field.is_empty()))
    }

    /// All arrays of the soil, mutable.
    pub fn arrays_mut(&mut self) -> impl Iterator<Item = &mut Vec<R>> {
        let Self { fraction, mass, apart, stress, history, composition } = self;
        let history = history.iter_mut().filter(|field| !field.is_empty());
        [fraction, mass, apart].into_iter().chain(stress).chain(composition).chain(history)
    }
}

impl<R: Copy + Into<f64>> Soil<R> {
    /// Number of the main material of a cell: the one with the largest volume.
    #[must_use]
    pub fn main_material(&self, cell: usize) -> usize {
        main_material(&self.composition, cell)
    }

    /// Mean pressure in the soil of a cell [Pa], compression positive.
    #[must_use]
    pub fn pressure(&self, cell: usize) -> f64 {
        let [xx, yy, zz] = [0, 1, 2].map(|c| self.stress[c][cell].into());
        -((xx + yy) + zz) / 3.0
    }
}

/// Number of the main material of a cell, from the fractions of the second material, the third, ….
pub(crate) fn main_material<R: Copy + Into<f64>>(composition: &[Vec<R>], cell: usize) -> usize {
    mixture::main_material(composition.iter().map(|portion| portion[cell].into()))
}

/// Mass of a cell [kg] if all of its soil, as compressed as it is, were of its main material, from the mass
/// and the densities of the undeformed materials: a law knows densities of its own soil alone.
pub(crate) fn mass_as_main<R: Copy + Into<f64>>(
    composition: &[Vec<R>],
    densities: &[f64],
    mass: f64,
    cell: usize,
) -> f64 {
    let others = composition.iter().map(|portion| portion[cell].into());
    mixture::mass_as_main(densities, others, mass)
}

impl<R> Nodes<R> {
    /// All arrays of the nodes.
    pub fn arrays(&self) -> impl Iterator<Item = &Vec<R>> {
        self.velocity.iter().chain(&self.displacement).chain([&self.mass])
    }

    /// All arrays of the nodes, mutable.
    pub fn arrays_mut(&mut self) -> impl Iterator<Item = &mut Vec<R>> {
        self.velocity.iter_mut().chain(&mut self.displacement).chain([&mut self.mass])
    }
}

/// Number of arrays of a state of some materials.
#[must_use]
pub fn arrays(materials: usize, kinds: Kinds) -> usize {
    3 + 6 + HISTORY.iter().filter(|variable| kinds.need(variable)).count() + materials - 1 + 7
}

impl<R: Copy + Default> Soil<R> {
    /// Fields without soil, for a number of materials, of some kinds.
    #[must_use]
    pub fn empty(grid: &Grid, materials: usize, kinds: Kinds) -> Self {
        let zeros = || vec![R::default(); grid.entries];
        Self {
            fraction: zeros(),
            mass: zeros(),
            apart: zeros(),
            stress: std::array::from_fn(|_| zeros()),
            history: HISTORY.map(|h| if kinds.need(&h) { zeros() } else { Vec::new() }),
            composition: (1..materials).map(|_| zeros()).collect(),
        }
    }
}

impl<R: Copy + Into<f64>> Soil<R> {
    /// The fields of the soil in double precision.
    #[must_use]
    pub fn to_f64(&self) -> Soil {
        Soil {
            fraction: to_f64(&self.fraction),
            mass: to_f64(&self.mass),
            apart: to_f64(&self.apart),
            stress: self.stress.each_ref().map(|field| to_f64(field)),
            history: self.history.each_ref().map(|field| to_f64(field)),
            composition: self.composition.iter().map(|field| to_f64(field)).collect(),
        }
    }
}

impl<R: Copy + Default> Nodes<R> {
    /// Nodes at rest, without mass.
    #[must_use]
    pub fn at_rest(grid: &Grid) -> Self {
        let zeros = || vec![R::default(); grid.entries];
        Self {
            velocity: std::array::from_fn(|_| zeros()),
            displacement: std::array::from_fn(|_| zeros()),
            mass: zeros(),
        }
    }
}

impl<R: Copy + Into<f64>> Nodes<R> {
    /// The fields of the nodes in double precision.
    #[must_use]
    pub fn to_f64(&self) -> Nodes {
        Nodes {
            velocity: self.velocity.each_ref().map(|field| to_f64(field)),
            displacement: self.displacement.each_ref().map(|field| to_f64(field)),
            mass: to_f64(&self.mass),
        }
    }
}

fn to_f64<R: Copy + Into<f64>>(field: &[R]) -> Vec<f64> {
    field.iter().map(|value| (*value).into()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_law_sees_the_density_of_its_own_soil() {
        // Three cells with 0.3, 0.8 and none of a heavy second soil, all of them compressed by a fiftieth.
        let composition = [vec![0.3, 0.8, 0.0]];
        let densities = [1500.0, 1800.0];
        for (cell, (mixed, own)) in
            [(1590.0, 1500.0), (1740.0, 1800.0), (1500.0, 1500.0)].into_iter().enumerate()
        {
            let mass = mass_as_main(&composition, &densities, 1.02 * mixed, cell);
            assert!((mass - 1.02 * own).abs() < 1e-9, "cell {cell}: {mass}");
        }
    }
}
