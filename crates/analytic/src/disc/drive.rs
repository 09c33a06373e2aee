//! What holds or turns the axle.

use crate::error::{Answer, not_negative, within};

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
    /// Turned at a given slip s = ω r / v − 1: −1 is locked, 0 rolls, more spins.
    Slip(f64),
}

impl Drive {
    /// Refuses a torque below zero and a slip outside −1 to 2.
    ///
    /// # Errors
    /// As said.
    pub fn check(&self) -> Answer<()> {
        match *self {
            Self::Free | Self::Locked => Ok(()),
            Self::Braked(torque) | Self::Driven(torque) => {
                not_negative("axle torque [N m]", torque).map(|_| ())
            }
            Self::Slip(slip) => within("slip", slip, -1.0, 2.0).map(|_| ()),
        }
    }
}
