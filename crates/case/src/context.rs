//! What the sections of a case have in common.

use super::shapes::FineCells;
use super::shapes::slab::Slab;
use super::slope::Slope;
use super::soil::Law;
use super::water::Water;
use geometry::Shape as Solid;
use glam::DVec3;

/// What the sections of a case have in common.
pub(super) struct Context {
    /// Acceleration of gravity [m/s²].
    pub(super) gravity: f64,
    /// The water over the soil.
    pub(super) water: Option<Water>,
    /// Slope of the ground.
    pub(super) slope: Slope,
    /// Cell size in the fine zone [m].
    pub(super) cell: f64,
    /// Widths of the cells in the fine zone along x, y, z over it.
    pub(super) aspect: DVec3,
    /// Height of the soil's surface [m]; of uneven ground that over which it rises and falls.
    pub(super) surface: f64,
    /// Heights between which the surface of the ground lies at the start [m].
    pub(super) between: [f64; 2],
    pub(super) symmetric: bool,
    /// Whether x = 0 is a plane of symmetry.
    pub(super) symmetric_x: bool,
    /// Yield law of the soil, if it could be read.
    pub(super) law: Option<Law>,
    /// Whether the uppermost soil or a layer has an undrained shear strength.
    pub(super) has_undrained_soil: bool,
    /// Initial velocity of the soil [m/s], as typed.
    pub(super) velocity: DVec3,
    /// The slab of a plane strain case.
    pub(super) slab: Option<Slab>,
}

impl Context {
    /// Widths along x, y, z of the cells in the fine zone [m].
    pub(super) fn fine_cell(&self) -> DVec3 {
        self.cell * self.aspect
    }

    /// The cells in the fine zone of the grid.
    pub(super) fn fine_cells(&self) -> FineCells {
        FineCells { widths: self.fine_cell(), plane_strain: self.slab.is_some() }
    }

    /// Mass of the water that a solid displaces [kg].
    pub(super) fn displaced_by(&self, solid: &dyn Solid) -> f64 {
        self.water.map_or(0.0, |water| water.displaced_by(solid, self.slab.is_some()).0)
    }

    /// Force along x, y, z that holds a mass [kg] against gravity [N].
    pub(super) fn support(&self, mass: f64) -> DVec3 {
        // Adding zero makes −0 a plain one.
        -mass * self.gravity * self.slope.down() + DVec3::ZERO
    }
}
