//! The interface of a contact law.

use super::problem::ContactProblem;
use crate::state::Contact;

/// A contact law: how soil and body exchange momentum at the contact points.
pub(crate) trait ContactLaw: Send + Sync {
    /// Called for each point after a contact search; `gap` is the gap between body and soil [m], negative
    /// where they overlap, `travel` the distance the point has moved since the last search [m], if it was in
    /// contact with soil then.
    fn update(&self, contact: &mut Contact, gap: f64, travel: Option<f64>);
    /// Changes the velocities of nodes and bodies for one step.
    fn act(&mut self, problem: &mut ContactProblem);
}
