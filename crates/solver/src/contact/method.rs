//! The contact law of each contact method.

use super::impulse::{self, Impulses};
use super::law::ContactLaw;
use super::penalty::Penalty;
use crate::model::{ContactMethod, Model};

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
