//! A rigid body's degrees of freedom: fixed, prescribed, or free under a load.

use serde::{Deserialize, Serialize};

/// What one degree of freedom does.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Freedom {
    /// No motion.
    Fixed,
    /// A given speed [m/s or rad/s], reached by a smooth ramp.
    Prescribed {
        /// Speed after the ramp [m/s or rad/s].
        speed: f64,
        /// When the ramp begins [s].
        start: f64,
        /// How long it lasts [s].
        ramp: f64,
        /// When the ramp back to rest begins (it takes as long) [s]; infinite for never.
        end: f64,
    },
    /// Moves as the forces on it say. `load` [N or N m] acts besides the soil (a weight is negative along z) and is
    /// brought on by a smooth ramp of `ramp` [s] from `start` [s].
    Free {
        /// Load [N or N m].
        load: f64,
        /// When the load begins to act [s].
        start: f64,
        /// How long it takes to come on [s].
        ramp: f64,
    },
}

impl Freedom {
    /// Whether the forces on the body decide this motion.
    #[must_use]
    pub fn is_free(&self) -> bool {
        matches!(self, Self::Free { .. })
    }

    /// Speed at a time [m/s or rad/s]; 0 for a free one.
    #[must_use]
    pub fn speed(&self, time: f64) -> f64 {
        match *self {
            Self::Prescribed { speed, start, ramp, end } => {
                speed * (rise(time, start, ramp) - rise(time, end, ramp))
            }
            _ => 0.0,
        }
    }

    /// Load at a time [N or N m]; 0 for one that is not free.
    #[must_use]
    pub fn load(&self, time: f64) -> f64 {
        match *self {
            Self::Free { load, start, ramp } => load * rise(time, start, ramp),
            _ => 0.0,
        }
    }
}

/// Smooth rise from 0 at `start` to 1 at `start + ramp` (3τ² − 2τ³).
fn rise(time: f64, start: f64, ramp: f64) -> f64 {
    if time <= start {
        0.0
    } else if time >= start + ramp {
        1.0
    } else {
        let tau = (time - start) / ramp;
        tau * tau * (3.0 - 2.0 * tau)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_prescribed_speed_rises_holds_and_ends() {
        let f = Freedom::Prescribed { speed: 2.0, start: 1.0, ramp: 0.5, end: 2.5 };
        let speeds = [0.9, 1.25, 1.5, 2.4, 2.75, 3.1].map(|t| f.speed(t));
        assert_eq!(speeds, [0.0, 1.0, 2.0, 2.0, 1.0, 0.0]);
        assert_eq!(
            Freedom::Prescribed { speed: 2.0, start: 0.0, ramp: 0.0, end: f64::INFINITY }.speed(9.0),
            2.0
        );
    }
}
