//! What the sections of a case have in common.

use super::clearance::SoilConditions;
use crate::resolved::{Body, Law, Water};
use crate::rigid_body::planes_forbid;
use crate::shapes::slab::Slab;
use crate::slope::Slope;
use geometry::Shape as Solid;
use glam::DVec3;
use input::problem::Problems;

/// What the sections of a case have in common.
pub(super) struct Context {
    /// Acceleration of gravity [m/s²].
    pub(super) gravity: f64,
    /// The water over it.
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

    /// Mass of the water that a solid displaces [kg].
    pub(super) fn displaced_by(&self, solid: &dyn Solid) -> f64 {
        self.water.map_or(0.0, |water| water.displaced_by(solid, self.slab.is_some()).0)
    }

    /// Mass of a body with its parts less that of the water that it displaces [kg].
    pub(super) fn submerged_mass(&self, body: &Body) -> f64 {
        let displaced = self.water.map_or(0.0, |water| water.displaced(body, self.slab.is_some()).0);
        body.whole_mass() - displaced
    }

    /// Force along x, y, z that holds a mass [kg] against gravity [N].
    pub(super) fn support(&self, mass: f64) -> DVec3 {
        // Adding zero makes −0 a plain one.
        -mass * self.gravity * self.slope.down() + DVec3::ZERO
    }

    /// Whether a plane of symmetry or of strain forbids a motion, by its number in
    /// [`crate::resolved::MOTIONS`].
    pub(super) fn planes_forbid(&self, motion: usize) -> bool {
        planes_forbid(self.symmetric || self.slab.is_some(), self.symmetric_x, motion)
    }

    /// What the clearance round a body depends on.
    pub(super) fn soil_conditions(&self) -> SoilConditions {
        SoilConditions {
            law: self.law.unwrap_or(Law::Elastic),
            surface: self.surface,
            floor: f64::NEG_INFINITY,
            velocity: self.velocity,
            gravity: self.gravity,
            plane_strain: self.slab.is_some(),
            confined: false,
        }
    }
}

/// A part of the case, or `None` if `check` finds something wrong with it: what follows from it would be
/// wrong, too.
pub(super) fn checked<T>(
    part: T,
    problems: &mut Problems,
    check: impl FnOnce(&T, &mut Problems),
) -> Option<T> {
    let before = problems.len();
    check(&part, problems);
    (problems.len() == before).then_some(part)
}
