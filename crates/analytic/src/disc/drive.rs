//! Torque or slip prescribed at the axle.

use crate::error::{ModelResult, non_negative, within};

/// How the axle is driven.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Drive {
    /// Free to rotate: no torque about the axle.
    #[default]
    Free,
    /// Locked: the rim slides with fully mobilised friction.
    Locked,
    /// A brake or a stiff bearing resists forward rolling with this torque [N m]; it locks the disc where
    /// friction does not overcome it.
    Braked(f64),
    /// A motor drives the axle forwards with this torque [N m]; the disc spins where friction does not
    /// balance it.
    Driven(f64),
    /// Rotation at a given [`crate::slip`]: −1 is locked, 0 free rolling, above 0 driven.
    Slip(f64),
}

impl Drive {
    /// Whether the motor drives the body forwards: its drag is then the difference of a resistance and a
    /// thrust.
    #[must_use]
    pub fn drives(&self) -> bool {
        match *self {
            Self::Driven(torque) => torque > 0.0,
            Self::Slip(slip) => slip > 0.0,
            Self::Free | Self::Locked | Self::Braked(_) => false,
        }
    }

    /// Checks the torque or the slip.
    ///
    /// # Errors
    /// If the torque is negative or the slip is not within −1 (locked) to 1 (spinning on the spot).
    pub fn check(&self) -> ModelResult<()> {
        match *self {
            Self::Free | Self::Locked => Ok(()),
            Self::Braked(torque) | Self::Driven(torque) => {
                non_negative("axle torque [N m]", torque).map(|_| ())
            }
            Self::Slip(slip) => within("slip", slip, -1.0, 1.0).map(|_| ()),
        }
    }
}
