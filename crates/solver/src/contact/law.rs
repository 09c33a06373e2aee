//! What a contact law must be able to do.

use super::scene::Scene;
use crate::state::Contact;

/// How soil and body act on each other at the contact points.
pub(crate) trait ContactLaw {
    /// Called for each point after a contact search; `gap` is the gap between body and soil [m], negative where they overlap,
    /// `travel` the distance the point has moved since the last search [m], if it was in contact with soil then.
    fn update(&self, contact: &mut Contact, gap: f64, travel: Option<f64>);
    /// Changes the velocities of nodes and bodies for one step.
    fn act(&mut self, scene: &mut Scene);
}
