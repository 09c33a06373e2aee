//! The contact laws, and the interface they share.

use super::impulse::{self, Impulses};
use super::penalty::Penalty;
use super::scene::Scene;
use crate::model::{ContactMethod, Model};
use crate::state::Contact;

/// How soil and body act on each other at the contact points.
pub(crate) trait ContactLaw {
    /// Called for each point after a contact search; `gap` is the gap between body and soil [m], negative where they overlap,
    /// `travel` the distance the point has moved since the last search [m], if it was in contact with soil then.
    fn update(&self, contact: &mut Contact, gap: f64, travel: Option<f64>);
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

/// Memory of the contact law for each active constraint [bytes].
pub(crate) fn kept_per_constraint(model: &Model) -> f64 {
    match model.method.contact {
        ContactMethod::Penalty => 0.0,
        ContactMethod::Impulse => impulse::PER_CONSTRAINT,
    }
}
