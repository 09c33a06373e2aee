//! The friction angle at which the plasticity models are evaluated where ψ < φ.

use super::{Body, Towing};
use crate::error::ModelResult;

/// The friction angle of the plasticity models, which are for associated flow, in soil with ψ < φ.
///
/// Neither is exact: the collapse load of such soil is not unique, and lies between the two. Which is nearer
/// was scored, class of bodies by class, on measurements and on runs of the solver (docs/how-to/forecast.md).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Strength {
    /// φ itself: discs, wheels and footings, under which the soil is confined.
    Full,
    /// Davis' operative angle φ*: the passive thrust on a block under tow, which a few slip planes decide.
    Davis,
}

impl Strength {
    /// The strength recommended for a case.
    #[must_use]
    pub fn recommended(towing: &Towing) -> Self {
        if matches!(towing.body, Body::Block(_)) && !towing.pressed { Self::Davis } else { Self::Full }
    }

    /// The other strength.
    #[must_use]
    pub fn other(self) -> Self {
        if self == Self::Full { Self::Davis } else { Self::Full }
    }

    /// The case with this strength, as the plasticity models take it.
    ///
    /// # Errors
    /// If φ or ψ is out of range.
    pub fn applied(self, towing: &Towing) -> ModelResult<Towing> {
        let soil = if self == Self::Davis { towing.soil.operative()? } else { towing.soil };
        Ok(Towing { soil, ..towing.clone() })
    }
}
