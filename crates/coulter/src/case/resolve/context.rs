//! What the sections of a case have in common.

use super::clearance::SoilConditions;
use crate::case::resolved::Law;
use glam::DVec3;

/// What the sections of a case have in common.
pub(super) struct Context {
    /// Acceleration of gravity [m/s²].
    pub(super) gravity: f64,
    /// Cell size in the fine zone [m].
    pub(super) cell: f64,
    /// Height of the soil's surface [m].
    pub(super) surface: f64,
    pub(super) symmetric: bool,
    /// Whether x = 0 is a plane of symmetry.
    pub(super) symmetric_x: bool,
    /// Yield law of the soil, if it could be read.
    pub(super) law: Option<Law>,
    /// Initial velocity of the soil [m/s], as typed.
    pub(super) velocity: DVec3,
    /// The slab of a plane strain case.
    pub(super) slab: Option<Slab>,
}

impl Context {
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

/// The slab of a plane strain case.
#[derive(Clone, Copy)]
pub(super) struct Slab {
    /// Its width along y [m].
    pub(super) width: f64,
    /// Its middle [m].
    pub(super) middle: f64,
    /// Distance of contact points from sharp edges [m].
    pub(super) inset: f64,
}

impl Slab {
    /// Width of a body [m]: that of the slab plus the inset of the contact points at both edges, so that the points cover
    /// the slab exactly.
    pub(super) fn covering_width(&self) -> f64 {
        self.width + 2.0 * self.inset
    }
}
