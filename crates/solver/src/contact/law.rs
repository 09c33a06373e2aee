//! The contact laws, and what they have in common.

use super::impulse::{self, Impulses};
use super::penalty::Penalty;
use super::scene::Scene;
use crate::model::{ContactMethod, Model};
use crate::state::Contact;

/// How soil and body act on each other at the contact points.
pub(crate) trait ContactLaw {
    /// Called for each point when it has been located anew; `gap` is the void between body and soil [m], negative when
    /// they overlap, `travel` how far the point has come since the last time [m], if it had soil to act on then.
    fn relocate(&self, contact: &mut Contact, gap: f64, travel: Option<f64>);
    /// Changes the velocities of nodes and bodies for one step.
    fn act(&mut self, scene: &mut Scene);
}

/// The contact law of a model.
pub(crate) fn law(model: &Model) -> Box<dyn ContactLaw> {
    match model.method.contact {
        ContactMethod::Penalty => Box::new(Penalty::new(model)),
        ContactMethod::Impulse => Box::new(Impulses::default()),
    }
}

/// What the contact law of a model keeps for each patch of points that touch [bytes].
pub(crate) fn kept_per_patch(model: &Model) -> f64 {
    match model.method.contact {
        ContactMethod::Penalty => 0.0,
        ContactMethod::Impulse => impulse::PER_PATCH,
    }
}
