//! Data of the cell kernels: a row of cells, the constants of a material, and the scratch memory of a block
//! of cells.

use super::physics::elastic::{Elastic, Stiffening};
use super::physics::law::Law;
use super::physics::tensor::Symmetric;
use super::physics::viscosity::BulkViscosity;
use super::{LANES, Real};
use crate::history::HISTORY_COUNT;
use std::ops::Range;

/// The cells of a row.
pub struct CellRow<'a> {
    /// Volume fractions.
    pub fraction: &'a [Real],
    /// Masses [kg], as if all soil of a cell were of its main material.
    pub mass: &'a [Real],
    /// Stresses [Pa].
    pub stress: [&'a mut [Real]; 6],
    /// History variables; empty where no material needs them.
    pub history: [&'a mut [Real]; HISTORY_COUNT],
    /// Width along y [m].
    pub width_y: Real,
    /// Width along z [m].
    pub width_z: Real,
}

/// Some cells of a history variable; none of one that the materials do not need.
pub fn cells_of<'a>(history: &'a mut [Real], cells: &Range<usize>) -> &'a mut [Real] {
    if history.is_empty() { history } else { &mut history[cells.clone()] }
}

/// A material, in the precision of the kernels.
#[derive(Debug)]
pub struct MaterialConstants {
    /// Elastic moduli.
    pub elastic: Elastic,
    /// How the elastic moduli grow with the pressure, if they do.
    pub stiffening: Option<Stiffening>,
    /// How the soil yields, if it does.
    pub yield_law: Option<Law>,
    /// Critical density, below which soil no longer dilates [kg/m³]; 0 for none.
    pub critical_density: Real,
    /// Density of the soil in its densest state without pressure [kg/m³].
    pub densest: Real,
    /// Density below which the soil bears no pressure [kg/m³]; 0 for none.
    pub loosest: Real,
    /// Bulk viscosity.
    pub viscosity: BulkViscosity,
    /// ε ρ c / 4 [kg/(s m²)].
    pub hourglass: Real,
}

/// Constants of all cells of one material.
#[derive(Clone, Copy)]
pub struct RowConstants<'a> {
    /// The material.
    pub material: &'a MaterialConstants,
    /// Fraction of the hourglass viscosity that acts in yielding cells.
    pub hourglass_yielding: Real,
    /// Whether the cells of the fine zone are cubes.
    pub has_cubes: bool,
    /// Widths of the cells along x [m], 0 in ghosts.
    pub width_x: &'a [Real],
    /// ¼ of the inverse widths, 0 in ghosts [1/m].
    pub per_width_x: &'a [Real],
    /// Time step [s].
    pub dt: Real,
}

impl<'a> RowConstants<'a> {
    /// Whether the soil is strained. In a remap no time passes: a stress that mixing puts outside the yield
    /// surface is returned without plastic strain.
    pub fn strains(&self) -> bool {
        self.dt > 0.0
    }

    /// The constants of the row with another material.
    pub fn of(self, material: &'a MaterialConstants) -> Self {
        Self { material, ..self }
    }
}

/// Runs of cells of one material in some columns of a row, with the number of the material; `material` has
/// that of each cell, and is empty where there is one alone.
pub fn runs(material: &[u8], columns: Range<usize>) -> impl Iterator<Item = (Range<usize>, usize)> + '_ {
    let Range { mut start, end } = columns;
    std::iter::from_fn(move || {
        let first = start;
        let own = material.get(first).copied();
        start = own.map_or(end, |own| (first..end).find(|i| material[*i] != own).unwrap_or(end));
        (first < end).then(|| (first..start, own.map_or(0, usize::from)))
    })
}

/// Maximum number of cells in a block on the processor: its scratch memory must fit into a first-level cache
/// of 32 KiB.
const PROCESSOR_BLOCK: usize = 768 / size_of::<Real>();

/// Maximum number of cells in a block.
pub const BLOCK: usize = if LANES == 1 { 1 } else { PROCESSOR_BLOCK };

/// Number of cells in the blocks into which the processor divides a run: about equal, since a short one would
/// cost nearly as much as a long one. A device adds up its cells in the same blocks.
#[inline]
#[must_use]
pub fn block_size(run: usize) -> usize {
    run.div_ceil(run.div_ceil(PROCESSOR_BLOCK)).next_multiple_of(64 / size_of::<Real>())
}

/// One number for each cell of a block.
pub type Lane = [Real; BLOCK];

/// The tensor of one cell from arrays of its components. Written out, since a closure is not always inlined,
/// and then the loop does not vectorise.
#[inline(always)]
pub fn tensor<const N: usize>(components: &[[Real; N]; 6], i: usize) -> Symmetric {
    let [xx, yy, zz, xy, yz, xz] = components;
    [xx[i], yy[i], zz[i], xy[i], yz[i], xz[i]]
}

/// Scratch memory of a block of cells, in one piece, that begins on a cache line: vectors that cross lines
/// cost Intel's processors up to a third of the stage.
#[repr(align(64))]
pub struct Block {
    /// Index of the first cell in the row.
    pub start: usize,
    /// Number of cells in use, a multiple of the vector length.
    pub n: usize,
    /// Corner sums of the velocity [m/s].
    pub plain: [Lane; 3],
    /// Corner sums of the velocity signed by the side along x, y, z [m/s].
    pub side: [[Lane; 3]; 3],
    /// Sum over the hourglass patterns of the squares of the velocity [m²/s²].
    pub hourglass: Lane,
    /// Trial stress, later the stress at the end of the step [Pa].
    pub trial: [Lane; 6],
    /// Stress-free volumetric opening.
    pub gap_strain: Lane,
    /// Volumetric rate [1/s].
    pub rate: Lane,
    /// 1 where the soil bears stress; 0 in void and at an open gap.
    pub bears_stress: Lane,
    /// 1 where the trial stress may lie outside the yield surface.
    pub yields: Lane,
    /// Length for bulk viscosity [m]; unused for cubes.
    pub strained_width: Lane,
    /// Viscous stress [Pa].
    pub viscous: Lane,
    /// Coefficient of the hourglass force [kg/s].
    pub damping: Lane,
    /// −¼ of the stress-bearing areas across x, y, z [m²].
    pub area: [Lane; 3],
    /// Plastic work per volume [J/m³], later of the cell [J].
    pub work: Lane,
    /// Dissipation by bulk viscosity [W].
    pub viscous_power: Lane,
    /// Dissipation by hourglass viscosity [W].
    pub damped_power: Lane,
}

impl Default for Block {
    fn default() -> Self {
        Self::new()
    }
}

impl Block {
    /// Index of the first cell in the row, and number of cells: on a device constants, so that the block is
    /// kept in registers.
    #[inline(always)]
    #[must_use]
    pub fn span(&self) -> (usize, usize) {
        if LANES == 1 { (0, 1) } else { (self.start, self.n.min(BLOCK)) }
    }

    /// Scratch memory of no cells.
    #[must_use]
    pub fn new() -> Self {
        const ZERO: Lane = [0.0; BLOCK];
        Self {
            start: 0,
            n: 0,
            plain: [ZERO; 3],
            side: [[ZERO; 3]; 3],
            hourglass: ZERO,
            trial: [ZERO; 6],
            gap_strain: ZERO,
            rate: ZERO,
            bears_stress: ZERO,
            yields: ZERO,
            strained_width: ZERO,
            viscous: ZERO,
            damping: ZERO,
            area: [ZERO; 3],
            work: ZERO,
            viscous_power: ZERO,
            damped_power: ZERO,
        }
    }
}
