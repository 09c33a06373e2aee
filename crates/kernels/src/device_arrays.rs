//! The arrays of a grid on a device, as its kernels take them.

use super::Real;
use super::nodes::NodeConstants;
use crate::history::HISTORY_COUNT;
use crate::launch::{MATERIALS, MEASURED, POWERS, PlaneSum, ROW_SUMS, Totals};
use crate::sums::COEFFICIENTS;

/// Addresses of the arrays on the device, and constants of all cells and nodes.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Arrays {
    /// Numbers in an array with its ghosts.
    pub entries: usize,
    /// Numbers in a row, and in a plane.
    pub stride: [usize; 2],
    /// Planes of the memory.
    pub planes: usize,
    /// Number of cells along x, y, z.
    pub cells: [usize; 3],
    /// Positions of their faces [m].
    pub faces: [*const f64; 3],
    /// Columns of the domain.
    pub inside: [usize; 2],
    /// The cells or nodes that a launch strains or moves: the first, and the one after the last.
    pub range: [usize; 2],
    /// Rows that may hold soil during a remap.
    pub row_active: *const bool,
    /// Nodes of a row that move.
    pub nodes_in_row: usize,
    /// Columns that are strained, in three parts: of these the outer two lie beyond the domain.
    pub columns: [[usize; 2]; 3],
    /// Constants of the nodes.
    pub constants: NodeConstants,
    /// Fraction of the hourglass viscosity that acts in yielding cells.
    pub hourglass_yielding: Real,
    /// Whether the cells of the fine zone are cubes.
    pub has_cubes: bool,
    /// Whether velocities must still be set to zero where there is no soil.
    pub clears: bool,
    /// How a row is treated: [`STRAINED`] and the other flags.
    pub row_flags: *const u8,
    /// Number of a cell's material, from 1 on; 0 for a cell that is not strained.
    pub kind: *mut u8,
    /// Which components of a node's velocity boundaries hold: one bit for each.
    pub held: *const u8,
    /// Widths of the columns [m], 0 in ghosts, and ¼ of their inverses.
    pub width_x: [*const Real; 2],
    /// Widths of the rows of a plane, and of the planes [m].
    pub width_yz: [*const Real; 2],
    /// Volume fractions.
    pub fraction: *const Real,
    /// Masses of the cells [kg], as if all soil of a cell were of its main material.
    pub soil_mass: *mut Real,
    /// Number of materials.
    pub materials: usize,
    /// Densities of the undeformed materials [kg/m³].
    pub densities: [f64; MATERIALS],
    /// Masses of the cells [kg].
    pub cell_mass: *const Real,
    /// Fractions of the soil that are of the second material, the third, ….
    pub composition: [*const Real; MATERIALS - 1],
    /// Masses of the nodes [kg].
    pub mass: *const Real,
    /// Stresses [Pa].
    pub stress: [*mut Real; 6],
    /// History variables; null where no material needs them.
    pub history: [*mut Real; HISTORY_COUNT],
    /// Velocities half a step ahead, half a step ago [m/s].
    pub velocity: [[*mut Real; 3]; 2],
    /// Displacements since the last remap [m].
    pub displacement: [*mut Real; 3],
    /// Coefficients of the nodal forces; zero where a cell is not strained.
    pub coefficients: [*mut Real; COEFFICIENTS],
    /// Dissipation of the cells: plastic work [J], by bulk viscosity and by hourglass viscosity [W].
    pub powers: [*mut Real; POWERS],
    /// Work of gravity [J], kinetic energy [J] and largest displacements [m], heavy and light, of the nodes.
    pub measured: [*mut Real; MEASURED],
    /// Sums over the rows.
    pub row_sums: [*mut f64; ROW_SUMS],
    /// Sums over the rows of each plane.
    pub plane_sums: *mut PlaneSum,
    /// Sums over all rows.
    pub totals: *mut Totals,
}
