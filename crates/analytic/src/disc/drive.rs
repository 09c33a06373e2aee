//! What holds or turns the axle.

use crate::error::{Answer, not_negative, within};

/// Slip at a turn ratio of 3, beyond which nothing here was ever compared with a measurement.
pub(crate) const MOST_SLIP: f64 = 1.0 - 1.0 / 3.0;

/// What happens at the axle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Drive {
    /// Free to turn: no torque about the axle.
    #[default]
    Free,
    /// Cannot turn: the rim slides with all its friction.
    Locked,
    /// A brake or a stiff bearing resists forward rolling with this torque [N m]; it locks the disc if it can.
    Braked(f64),
    /// An engine turns it forwards with this torque [N m]; it spins if the soil cannot hold it.
    Driven(f64),
    /// Turned at a given [`crate::slip`]: −1 is locked, 0 rolls, above 0 it is driven.
    Slip(f64),
}

impl Drive {
    /// Refuses a torque below zero and a slip outside −1 to 2/3, where the rim turns three times as fast as it rolls.
    ///
    /// # Errors
    /// As said.
    pub fn check(&self) -> Answer<()> {
        match *self {
            Self::Free | Self::Locked => Ok(()),
            Self::Braked(torque) | Self::Driven(torque) => {
                not_negative("axle torque [N m]", torque).map(|_| ())
            }
            Self::Slip(slip) => within("slip", slip, -1.0, MOST_SLIP).map(|_| ()),
        }
    }
}
