//! How a body moves that another program steers.

use crate::mobility::Mobility;
use crate::twist::Twist;
use crate::wrench::Wrench;

/// How another program steers a body, until its next exchange with this one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Steering {
    /// A load on the body [N, N m] beside those of its degrees of freedom, about its reference point.
    Loaded(Wrench),
    /// The twist of the body, whatever acts on it.
    Prescribed(Twist),
    /// The body is one of a mechanism that the other program moves: contact changes its twist as that
    /// mechanism lets it, and its mass is there.
    Coupled {
        /// Mobility of the body in its mechanism.
        mobility: Mobility,
        /// Change of the twist without contact [m/s², rad/s²].
        acceleration: Twist,
    },
}

impl Steering {
    /// Whether the body moves as the other program says, and its own mass and degrees of freedom are of no
    /// effect.
    #[must_use]
    pub fn replaces_motion(&self) -> bool {
        !matches!(self, Self::Loaded(_))
    }
}
