//! One degree of freedom of a rigid body: fixed, prescribed, or free under a load.

use crate::course::Course;
use serde::{Deserialize, Serialize};

/// How a body moves in one degree of freedom.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Motion {
    /// Held fixed.
    Fixed,
    /// A prescribed speed [m/s or rad/s], reached by a smooth ramp.
    Prescribed {
        /// Speed before the ramp [m/s or rad/s].
        before: f64,
        /// Speed after the ramp [m/s or rad/s].
        speed: f64,
        /// Start of the ramp [s].
        start: f64,
        /// Duration of the ramp [s].
        ramp: f64,
        /// Start of the ramp back to rest, of the same duration [s]; infinite for none.
        end: f64,
    },
    /// A prescribed displacement [m or rad] over time.
    Course(Course),
    /// Free to move under the forces on the body and a load, a force or torque along the axis of the freedom,
    /// which replaces a support by a smooth ramp.
    Free {
        /// Load after the ramp [N or N m].
        load: f64,
        /// Load before the ramp [N or N m], such as the force that carries a body until it is released.
        support: f64,
        /// Start of the ramp [s].
        start: f64,
        /// Duration of the ramp [s].
        ramp: f64,
    },
}

impl Motion {
    /// Free, without a load.
    pub const FREE: Self = Self::Free { load: 0.0, support: 0.0, start: 0.0, ramp: 0.0 };

    /// A prescribed speed [m/s or rad/s] from the start on, without a ramp.
    #[must_use]
    pub fn prescribed(speed: f64) -> Self {
        Self::Prescribed { before: 0.0, speed, start: f64::NEG_INFINITY, ramp: 0.0, end: f64::INFINITY }
    }

    /// A constant load [N or N m] on a free motion.
    #[must_use]
    pub fn loaded(load: f64) -> Self {
        Self::Free { load, support: load, start: f64::NEG_INFINITY, ramp: 0.0 }
    }

    /// Whether the body does not move in this degree of freedom.
    #[must_use]
    pub fn is_fixed(&self) -> bool {
        matches!(self, Self::Fixed)
    }

    /// Whether the motion follows from the forces on the body.
    #[must_use]
    pub fn is_free(&self) -> bool {
        matches!(self, Self::Free { .. })
    }

    /// Whether the motion is other than rest, or a halt.
    #[must_use]
    pub fn may_move(&self) -> bool {
        match self {
            Self::Fixed => false,
            Self::Prescribed { speed, .. } => *speed != 0.0,
            Self::Course(course) => course.fastest() > 0.0,
            Self::Free { .. } => true,
        }
    }

    /// Whether a motion that was read from a checkpoint has what it takes.
    #[must_use]
    pub fn is_sound(&self) -> bool {
        if let Self::Course(course) = self { course.is_sound() } else { true }
    }

    /// Prescribed speed at a time [s], in [m/s or rad/s]; 0 unless prescribed.
    #[must_use]
    pub fn speed(&self, time: f64) -> f64 {
        match self {
            &Self::Prescribed { before, speed, start, ramp, end } => {
                let risen = smooth_step(time, start, ramp);
                before * (1.0 - risen) + speed * (risen - smooth_step(time, end, ramp))
            }
            Self::Course(course) => course.speed(time),
            _ => 0.0,
        }
    }

    /// The motion that takes over at a time [s], to which its own times refer, from this speed [m/s or rad/s]
    /// under this load [N or N m].
    #[must_use]
    pub fn taking_over(&self, at: f64, speed_now: f64, load_now: f64) -> Self {
        match self {
            Self::Fixed => Self::Fixed,
            &Self::Prescribed { speed, start, ramp, end, .. } => {
                Self::Prescribed { before: speed_now, speed, start: start + at, ramp, end: end + at }
            }
            Self::Course(course) => Self::Course(course.later(at)),
            &Self::Free { load, start, ramp, .. } => {
                Self::Free { load, support: load_now, start: start + at, ramp }
            }
        }
    }

    /// Load at a time [s], in [N or N m]; 0 unless free.
    #[must_use]
    pub fn load(&self, time: f64) -> f64 {
        match *self {
            Self::Free { load, support, start, ramp } => {
                support + (load - support) * smooth_step(time, start, ramp)
            }
            _ => 0.0,
        }
    }
}

/// Smooth step from 0 at `start` to 1 at `start + ramp`: 3τ² − 2τ³.
fn smooth_step(time: f64, start: f64, ramp: f64) -> f64 {
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
    fn a_load_replaces_the_support() {
        let f = Motion::Free { load: -2.0, support: 6.0, start: 1.0, ramp: 0.5 };
        assert_eq!([0.9, 1.25, 1.5].map(|t| f.load(t)), [6.0, 2.0, -2.0]);
    }

    #[test]
    fn a_prescribed_speed_rises_holds_and_ends() {
        let f = Motion::Prescribed { before: 0.0, speed: 2.0, start: 1.0, ramp: 0.5, end: 2.5 };
        let speeds = [0.9, 1.25, 1.5, 2.4, 2.75, 3.1].map(|t| f.speed(t));
        assert_eq!(speeds, [0.0, 1.0, 2.0, 2.0, 1.0, 0.0]);
        let at_once =
            Motion::Prescribed { before: 0.0, speed: 2.0, start: 0.0, ramp: 0.0, end: f64::INFINITY };
        assert_eq!(at_once.speed(9.0), 2.0);
    }

    #[test]
    fn a_motion_that_takes_over_starts_from_the_present_speed_and_load() {
        let slower =
            Motion::Prescribed { before: 0.0, speed: 0.5, start: 0.0, ramp: 1.0, end: f64::INFINITY };
        let slower = slower.taking_over(10.0, 2.0, 7.0);
        assert_eq!([10.0, 10.5, 11.0, 20.0].map(|t| slower.speed(t)), [2.0, 1.25, 0.5, 0.5]);
        let released =
            Motion::Free { load: -2.0, support: 0.0, start: 0.0, ramp: 1.0 }.taking_over(10.0, 2.0, 6.0);
        assert_eq!([10.0, 10.5, 12.0].map(|t| released.load(t)), [6.0, 2.0, -2.0]);
    }
}
