//! All that is known of a deck before the case is written.

use crate::bodies::Body;
use crate::eulerian::Eulerian;
use crate::gear::Gear;
use crate::gravity::Gravity;
use crate::masses::Inertia;
use crate::moves::StepMoves;
use crate::orient::Setup;
use crate::units::Units;
use crate::walls::Held;

/// What the deck says, in its own units and axes but for the setup.
pub(super) struct Facts<'a> {
    pub(super) units: Units,
    pub(super) gravity: Gravity,
    pub(super) mesh: &'a Eulerian,
    pub(super) bodies: &'a [Body],
    pub(super) inertias: Vec<Inertia>,
    pub(super) moves: Vec<StepMoves>,
    pub(super) held: Held,
    pub(super) setup: Setup,
    pub(super) gear: Gear,
    /// Number of the first step that is run: one that only lets gravity act is not.
    pub(super) first: usize,
}

impl Facts<'_> {
    /// By what masses and loads of the deck are multiplied: halves and quarters are wholes in a case, and
    /// plane strain counts a metre.
    pub(super) fn share(&self) -> f64 {
        let halves = self.setup.symmetric.iter().filter(|is| **is).count() as i32;
        let axis = self.setup.frame.axes[1].0;
        let planes = &self.mesh.faces[axis];
        let width = if self.setup.is_plane_strain {
            (planes[planes.len() - 1] - planes[0]) * self.units.length
        } else {
            1.0
        };
        2_f64.powi(halves) / width
    }

    /// Whether a motion of the case is ruled out by symmetry.
    pub(super) fn is_ruled_out(&self, number: usize) -> bool {
        let flat = self.setup.is_plane_strain || self.setup.symmetric[0];
        flat && [1, 3, 5].contains(&number) || self.setup.symmetric[1] && [0, 4, 5].contains(&number)
    }
}
