//! Torque or slip prescribed at the axle.

use crate::error::{ModelResult, non_negative, within};

/// Largest slip, a turn ratio of 4: the models have not been compared with measurements beyond it.
pub(crate) const MAX_SLIP: f64 = 0.75;

/// How the axle is driven.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Drive {
    /// Free to rotate: no torque about the axle.
    #[default]
    Free,
    /// Locked: the rim slides with fully mobilised friction.
    Locked,
    /// A brake or a stiff bearing resists forward rolling with this torque [N m]; it locks the disc where friction does not
    /// overcome it.
    Braked(f64),
    /// A motor drives it forwards with this torque [N m]; the disc spins where friction does not balance it.
    Driven(f64),
    /// Rotation at a given [`crate::slip`]: −1 is locked, 0 free rolling, above 0 driven.
    Slip(f64),
}

impl Drive {
    /// Checks the torque or the slip.
    ///
    /// # Errors
    /// If the torque is negative or the slip is not within −1 to ¾ (the turn ratio 4).
    pub fn check(&self) -> ModelResult<()> {
        match *self {
            Self::Free | Self::Locked => Ok(()),
            Self::Braked(torque) | Self::Driven(torque) => {
                non_negative("axle torque [N m]", torque).map(|_| ())
            }
            Self::Slip(slip) => within("slip", slip, -1.0, MAX_SLIP).map(|_| ()),
        }
    }
}
