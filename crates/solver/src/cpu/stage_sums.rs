//! What the Lagrangian stage adds up: by row, and over the grid.

use crate::exact_sum::{ExactSum, begin_over_blocks, end_over_blocks};
use crate::halo::Halo;
use ::kernels::launch::SUMS;
use ::kernels::sums::Measured;

/// Sums over a row, or over the whole grid.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct RowSums {
    /// Plastic dissipation [J].
    pub plastic: f64,
    /// Dissipation by bulk viscosity [J].
    pub viscous: f64,
    /// Dissipation by hourglass viscosity [J].
    pub hourglass: f64,
    /// Dissipation by seepage: work done on the pore water [J].
    pub seepage: f64,
    /// Work of gravity [J].
    pub gravity: f64,
    /// Work done on the soil that was pressed out of bodies [J].
    pub pressing: f64,
    /// Work done on the ground beyond boundaries at constant stress [J].
    pub beyond: f64,
    /// Kinetic energy of the nodes [J].
    pub kinetic: f64,
    /// Largest component of a nodal displacement since the last remap, each divided by the aspect of the
    /// cells [m].
    pub displacement: f64,
    /// Largest component of the displacement of light nodes, next to only a few grains of soil [m].
    pub displacement_light: f64,
    /// Number of cells whose stress was returned to the yield surface.
    pub yields: u32,
}

/// Sums over several rows, exact.
#[derive(Clone, Copy, Debug, Default)]
pub struct StageSums {
    /// Plastic, viscous, hourglass and seepage dissipation, work of gravity, kinetic energy, work of
    /// pressing, and on the ground beyond boundaries at constant stress.
    energies: [ExactSum; 8],
    /// Largest displacements, of all nodes and of light ones.
    farthest: [f64; 2],
    yields: u32,
}

impl RowSums {
    /// Takes over what a row of nodes adds.
    pub(crate) fn measured(&mut self, row: &Measured) {
        let Measured { gravity, kinetic, displacement, displacement_light } = *row;
        (self.gravity, self.kinetic) = (gravity, kinetic);
        (self.displacement, self.displacement_light) = (displacement, displacement_light);
    }

    /// Total dissipation [J].
    pub(crate) fn dissipated(&self) -> f64 {
        self.plastic + self.viscous + self.hourglass + self.seepage
    }
}

impl StageSums {
    /// Sums over some rows.
    pub(crate) fn of<'a>(rows: impl Iterator<Item = &'a RowSums>) -> Self {
        let mut sums = Self::default();
        for own in rows {
            let dissipated = [own.plastic, own.viscous, own.hourglass, own.seepage];
            let terms = dissipated.into_iter().chain([own.gravity, own.kinetic]);
            sums.energies.iter_mut().zip(terms).for_each(|(sum, term)| sum.add(term));
            sums.reach([own.displacement, own.displacement_light], own.yields);
        }
        sums
    }

    /// The sums that a device has found: those of its rows, and the largest displacements.
    pub(crate) fn of_device(sums: [ExactSum; SUMS], farthest: [f64; 2]) -> Self {
        let [plastic, viscous, hourglass, gravity, kinetic, beyond] = sums;
        let none = ExactSum::default();
        let energies = [plastic, viscous, hourglass, none, gravity, kinetic, none, beyond];
        Self { energies, farthest, yields: 0 }
    }

    fn reach(&mut self, [all, light]: [f64; 2], yields: u32) {
        self.farthest = [self.farthest[0].max(all), self.farthest[1].max(light)];
        self.yields += yields;
    }

    /// Adds the work of pressing.
    pub(crate) fn add_pressing(&mut self, work: ExactSum) {
        self.energies[6].merge(work);
    }

    /// Adds work on the ground beyond boundaries at constant stress.
    pub(crate) fn add_beyond(&mut self, work: ExactSum) {
        self.energies[7].merge(work);
    }

    pub(crate) fn merge(mut self, other: &Self) -> Self {
        self.energies.iter_mut().zip(other.energies).for_each(|(sum, other)| sum.merge(other));
        self.reach(other.farthest, other.yields);
        self
    }

    /// Begins to find the sums over the whole grid.
    pub(crate) fn begin_total(&self, halo: &Halo) {
        begin_over_blocks(halo, self.energies, &self.farthest);
    }

    /// Sums over the whole grid, from those of the block.
    pub(crate) fn total(self, halo: &Halo) -> RowSums {
        let Self { energies, mut farthest, yields } = self;
        let ([plastic, viscous, hourglass, seepage, gravity, kinetic, pressing, beyond], largest) =
            end_over_blocks(halo, energies);
        farthest.iter_mut().zip(largest).for_each(|(own, largest)| *own = largest);
        let [displacement, displacement_light] = farthest;
        RowSums {
            plastic,
            viscous,
            hourglass,
            seepage,
            gravity,
            kinetic,
            pressing,
            beyond,
            displacement,
            displacement_light,
            yields,
        }
    }
}
