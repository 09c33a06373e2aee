//! Data of the cell kernels: a row of cells, the constants of a material, and the scratch memory of a block
//! of cells.

use super::Real;
use super::physics::brick::hourglass_coefficient;
use super::physics::elastic::{Elastic, Stiffening};
use super::physics::law::Law;
use super::physics::tensor::Symmetric;
use super::physics::viscosity::BulkViscosity;
use crate::fields::HISTORY_COUNT;
use crate::material::Material;
use crate::model::{Method, Model};
use std::ops::Range;

/// The cells of a row.
pub(crate) struct CellRow<'a> {
    pub(crate) fraction: &'a [Real],
    /// Masses [kg], as if all soil of a cell were of its main material.
    pub(crate) mass: &'a [Real],
    pub(crate) stress: [&'a mut [Real]; 6],
    pub(crate) history: [&'a mut [Real]; HISTORY_COUNT],
    /// Widths along y and z [m].
    pub(crate) width_y: Real,
    pub(crate) width_z: Real,
}

/// Some cells of a history variable; none of one that the materials do not need.
pub(crate) fn cells_of<'a>(history: &'a mut [Real], cells: &Range<usize>) -> &'a mut [Real] {
    if history.is_empty() { history } else { &mut history[cells.clone()] }
}

/// A material, in the precision of the kernels.
#[derive(Debug)]
pub struct MaterialConstants {
    pub(super) elastic: Elastic,
    /// How the elastic moduli grow with the pressure, if they do.
    pub(super) stiffening: Option<Stiffening>,
    pub(super) yield_law: Option<Law>,
    /// Critical density, below which soil no longer dilates [kg/m³]; 0 for none.
    pub(super) critical_density: Real,
    /// Density of the soil in its densest state without pressure [kg/m³].
    pub(super) densest: Real,
    /// Density below which the soil bears no pressure [kg/m³]; 0 for none.
    pub(super) loosest: Real,
    pub(super) viscosity: BulkViscosity,
    /// ε ρ c / 4 [kg/(s m²)].
    pub(super) hourglass: Real,
}

impl MaterialConstants {
    fn new(material: &Material, method: &Method) -> Self {
        let hourglass = hourglass_coefficient(
            method.hourglass as Real,
            material.density as Real,
            material.wave_speed() as Real,
            1.0,
        );
        Self {
            elastic: Elastic::cast(&material.elastic),
            stiffening: material.stiffening().as_ref().map(Stiffening::cast),
            yield_law: material.yield_law.as_ref().map(Law::cast),
            critical_density: material.critical_density.unwrap_or(0.0) as Real,
            densest: material.densest() as Real,
            loosest: material.loosest() as Real,
            viscosity: BulkViscosity::cast(&material.viscosity(method.bulk_viscosity)),
            hourglass,
        }
    }
}

/// The materials of a model.
pub(crate) fn materials(model: &Model) -> Vec<MaterialConstants> {
    model.materials.iter().map(|material| MaterialConstants::new(material, &model.method)).collect()
}

/// Constants of all cells of one material.
#[derive(Clone, Copy)]
pub(crate) struct RowConstants<'a> {
    pub(crate) material: &'a MaterialConstants,
    /// Fraction of the hourglass viscosity that acts in yielding cells.
    pub(crate) hourglass_yielding: Real,
    /// Whether the cells of the fine zone are cubes.
    pub(crate) has_cubes: bool,
    /// Widths of the cells along x [m], 0 in ghosts.
    pub(crate) width_x: &'a [Real],
    /// ¼ of the inverse widths, 0 in ghosts [1/m].
    pub(crate) per_width_x: &'a [Real],
    /// Time step [s].
    pub(crate) dt: Real,
}

impl<'a> RowConstants<'a> {
    /// Constants of the first material; `width_x` holds the widths of the columns, and ¼ of their inverses.
    pub(crate) fn new(
        model: &Model,
        materials: &'a [MaterialConstants],
        width_x: &'a [Vec<Real>; 2],
        dt: f64,
    ) -> Self {
        let [width_x, per_width_x] = width_x.each_ref().map(|w| &w[1..]);
        let hourglass_yielding = model.method.hourglass_yielding as Real;
        let has_cubes = model.grid.has_cubes();
        Self { material: &materials[0], hourglass_yielding, has_cubes, width_x, per_width_x, dt: dt as Real }
    }

    /// Whether the soil is strained. In a remap no time passes: a stress that mixing puts outside the yield
    /// surface is returned without plastic strain.
    pub(super) fn strains(&self) -> bool {
        self.dt > 0.0
    }

    /// The constants of the row with another material.
    pub(crate) fn of(self, material: &'a MaterialConstants) -> Self {
        Self { material, ..self }
    }
}

/// Runs of cells of one material in some columns of a row, with the number of the material; `material` has
/// that of each cell, and is empty where there is one alone.
pub(crate) fn runs(
    material: &[u8],
    columns: Range<usize>,
) -> impl Iterator<Item = (Range<usize>, usize)> + '_ {
    let Range { mut start, end } = columns;
    std::iter::from_fn(move || {
        let first = start;
        let own = material.get(first).copied();
        start = own.map_or(end, |own| (first..end).find(|i| material[*i] != own).unwrap_or(end));
        (first < end).then(|| (first..start, own.map_or(0, usize::from)))
    })
}

/// Maximum number of cells in a block: its scratch memory must fit into a first-level cache of 32 KiB.
pub(super) const BLOCK: usize = 768 / size_of::<Real>();

pub(super) type Lane = [Real; BLOCK];

/// The tensor of one cell from arrays of its components. Written out, since a closure is not always inlined,
/// and then the loop does not vectorise.
#[inline(always)]
pub(super) fn tensor<const N: usize>(components: &[[Real; N]; 6], i: usize) -> Symmetric {
    let [xx, yy, zz, xy, yz, xz] = components;
    [xx[i], yy[i], zz[i], xy[i], yz[i], xz[i]]
}

/// Scratch memory of a block of cells, in one piece, that begins on a cache line: vectors that cross lines
/// cost Intel's processors up to a third of the stage.
#[repr(align(64))]
pub struct Block {
    /// Index of the first cell in the row.
    pub(super) start: usize,
    /// Number of cells in use, a multiple of the vector length.
    pub(super) n: usize,
    /// Corner sums of the velocity: plain, and signed by the side x, y, z.
    pub(super) plain: [Lane; 3],
    pub(super) side: [[Lane; 3]; 3],
    pub(super) hourglass: Lane,
    /// Trial stress, later the stress at the end of the step [Pa].
    pub(super) trial: [Lane; 6],
    pub(super) gap_strain: Lane,
    /// Volumetric rate [1/s].
    pub(super) rate: Lane,
    /// 1 where the soil bears stress; 0 in void and at an open gap.
    pub(super) bears_stress: Lane,
    /// 1 where the trial stress may lie outside the yield surface.
    pub(super) yields: Lane,
    /// Length for bulk viscosity [m]; unused for cubes.
    pub(super) strained_width: Lane,
    /// Viscous stress [Pa].
    pub(super) viscous: Lane,
    /// Coefficient of the hourglass force [kg/s].
    pub(super) damping: Lane,
    /// −¼ of the stress-bearing areas across x, y, z [m²].
    pub(super) area: [Lane; 3],
    /// Plastic work per volume [J/m³], later of the cell [J].
    pub(super) work: Lane,
    /// Dissipation by viscosity and hourglass [W].
    pub(super) viscous_power: Lane,
    pub(super) damped_power: Lane,
}

impl Block {
    pub(crate) fn new() -> Box<Self> {
        const ZERO: Lane = [0.0; BLOCK];
        Box::new(Self {
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
        })
    }
}
