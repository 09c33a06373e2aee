//! What kernels for a device share in both precisions: their names, how rows are flagged, and their sums.

use crate::exact_sum::{ExactSum, NUMBERS};
use crate::history::HISTORY_COUNT;

/// Flag of a row of cells that is strained.
pub const STRAINED: u8 = 1;
/// Flag of a row of nodes with soil round it.
pub const NODES: u8 = 2;
/// Flag of a row whose sums are those of this grid.
pub const OWNED: u8 = 4;
/// Flag of a row of cells in the domain.
pub const INSIDE: u8 = 8;
/// Flag of a row of cells of which this grid counts what is dissipated beyond boundaries.
pub const ACCOUNTED: u8 = 16;

/// Kinds of dissipation of a cell.
pub const POWERS: usize = 3;
/// Numbers measured at a node.
pub const MEASURED: usize = 4;
/// Sums over a row that are added up: plastic, viscous and hourglass dissipation, work of gravity, kinetic
/// energy, dissipation beyond boundaries.
pub const SUMS: usize = 6;
/// Sums over a row: those, and the largest displacements of heavy and of light nodes.
pub const ROW_SUMS: usize = SUMS + 2;

/// A sum over a plane.
#[derive(Clone, Copy, Debug, Default)]
#[repr(C)]
pub struct PlaneSum {
    /// The terms, added up.
    pub exact: ExactSum,
    /// The largest term, 0 if there is none.
    pub most: f64,
}

/// Sums over a grid.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Totals {
    /// [`ExactSum::numbers`] of the sums.
    pub numbers: [[i64; NUMBERS]; SUMS],
    /// Largest displacements of heavy and of light nodes [m].
    pub most: [f64; 2],
}

/// Most materials of soil that a device remaps.
pub const MATERIALS: usize = 8;
/// Most arrays of which a list takes or gives numbers: those of the cells, and volumes of soil and cells.
pub const LISTED: usize = 3 + 6 + HISTORY_COUNT + MATERIALS - 1 + 2;

/// Nodes or cells, and numbers of each.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct List<R> {
    /// How many nodes or cells there are.
    pub count: usize,
    /// Their indices in memory.
    pub entries: *const u32,
    /// The numbers, one array after the other.
    pub values: *mut R,
    /// How many arrays there are.
    pub numbers: usize,
    /// The arrays.
    pub arrays: [*mut R; LISTED],
}

/// Calls the macro `$use` with `$given` and the table of the kernels: variant and name of each, the type of
/// what its launch hands over besides the arrays, and what a thread does, with the arrays `a`, that `more`,
/// scratch memory for a cell, and its number `n`.
#[macro_export]
macro_rules! each_kernel {
    ($use:ident, $($given:tt)*) => {
        $use! { ($($given)*)
            StrainElastic strain_elastic(Material<()>): |a, more, block, n| strain::<_, PLAIN>(a, more, None, block, n);
            StrainMohrCoulomb strain_mohr_coulomb(Material<MohrCoulomb>): |a, more, block, n| strain::<_, PLAIN>(a, more, Some(mohr_coulomb), block, n);
            StrainMenetreyWillam strain_menetrey_willam(Material<MenetreyWillam>): |a, more, block, n| strain::<_, PLAIN>(a, more, Some(menetrey_willam), block, n);
            StrainVonMises strain_von_mises(Material<VonMises>): |a, more, block, n| strain::<_, PLAIN>(a, more, Some(von_mises), block, n);
            StrainSand strain_sand(Material<Sand>): |a, more, block, n| strain::<_, SAND>(a, more, Some(sand), block, n);
            StrainClay strain_clay(Material<Clay>): |a, more, block, n| strain::<_, CLAY>(a, more, Some(clay), block, n);
            MoveNodes move_nodes(u64): |a, _more, _block, n| move_node(a, n);
            SumLanes sum_lanes(u64): |a, _more, _block, n| sum_lane(a, n);
            SumRows sum_rows(u64): |a, _more, _block, n| sum_row(a, n);
            SumPlanes sum_planes(u64): |a, _more, _block, n| sum_plane(a, n);
            SumAll sum_all(u64): |a, _more, _block, n| total(a, n);
            Take take_listed(List<Real>): |_a, more, _block, n| take(more, n);
            Give give_listed(List<Real>): |_a, more, _block, n| give(more, n);
            DisplacedVolumes remap_displaced_volumes(Pass): |a, more, _block, n| displaced_volumes(a, more, n);
            VolumeFraction remap_volume_fraction(Pass): |a, more, _block, n| volume_fraction(a, more, n);
            VolumeFlux remap_volume_flux(Pass): |a, more, _block, n| volume_flux(a, more, n);
            UndoDisplacement remap_undo_displacement(Pass): |a, more, _block, n| undo_displacement(a, more, n);
            Reach remap_reach(Pass): |a, more, _block, n| reach(a, more, n);
            Carry remap_carry(Pass): |a, more, _block, n| carry(a, more, n);
            MassFlux remap_mass_flux(Pass): |a, more, _block, n| mass_flux(a, more, n);
            Difference remap_difference(Pass): |a, more, _block, n| difference(a, more, n);
            DualFlux remap_dual_flux(Pass): |a, more, _block, n| dual_flux(a, more, n);
            DualReach remap_dual_reach(Pass): |a, more, _block, n| dual_reach(a, more, n);
            CarryMomentum remap_carry_momentum(Pass): |a, more, _block, n| carry_momentum(a, more, n);
            CarryMass remap_carry_mass(Pass): |a, more, _block, n| carry_mass(a, more, n);
            NodalMass remap_nodal_mass(Pass): |a, more, _block, n| nodal_mass(a, more, n);
            StopMassless remap_stop_massless(Pass): |a, more, _block, n| stop_massless(a, more, n);
            TakeBack remap_take_back(Pass): |a, more, _block, n| take_back(a, more, n);
            Shift remap_shift(Pass): |a, more, _block, n| shift(a, more, n);
            NewFractions remap_new_fractions(Pass): |a, more, _block, n| new_fractions(a, more, n);
            Mix remap_mix(u64): |a, _more, _block, n| mix(a, n);
            Close remap_close(Closed): |_a, more, _block, n| close(more, n);
            CollectDensity collect_density_of(Averaging): |a, more, _block, n| collect_density(a, more, n);
            SpreadDensity spread_density_of(Averaging): |a, more, _block, n| spread_density(a, more, n);
            StoreDensity store_density_of(Averaging): |a, more, _block, n| store_density(a, more, n);
            RowEnergies row_energies_of(Elasticity): |a, more, _block, n| row_energies(a, more, n);
        }
    };
}

macro_rules! declare {
    (($($given:tt)*) $($variant:ident $name:ident($type:ty): |$a:ident, $more:ident, $block:ident, $n:ident| $does:expr;)*) => {
        /// A kernel: what each thread of a launch does.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Kernel {
            $(#[doc = concat!("The entry point `", stringify!($name), "`.")] $variant,)*
        }

        impl Kernel {
            /// All kernels.
            pub const ALL: &[Self] = &[$(Self::$variant,)*];

            /// Name of the entry point.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => stringify!($name),)*
                }
            }
        }
    };
}

each_kernel!(declare,);
