//! Force and moment on a rigid body, or their impulses.

use crate::twist::Twist;
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::ops::{Add, AddAssign, Mul, Sub};

/// Force and moment about the reference point, or impulse and angular impulse. Axes of space.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Wrench {
    /// Force [N] or impulse [N s].
    pub force: DVec3,
    /// Moment about the reference point [N m] or angular impulse [N m s].
    pub moment: DVec3,
}

impl Wrench {
    /// No force.
    pub const ZERO: Self = Self { force: DVec3::ZERO, moment: DVec3::ZERO };

    /// Wrench of a force or an impulse at `arm` from the reference point [m].
    #[must_use]
    #[inline]
    pub fn at(arm: DVec3, force: DVec3) -> Self {
        Self { force, moment: arm.cross(force) }
    }

    /// Wrench of a moment or an angular impulse alone.
    #[must_use]
    pub fn couple(moment: DVec3) -> Self {
        Self { force: DVec3::ZERO, moment }
    }

    /// Moment about the point at `arm` from the reference point [N m or N m s].
    #[must_use]
    pub fn moment_about(&self, arm: DVec3) -> DVec3 {
        self.moment - arm.cross(self.force)
    }

    /// Power [W] at a twist; for impulses, work [J].
    #[must_use]
    pub fn dot(&self, twist: &Twist) -> f64 {
        self.force.dot(twist.linear) + self.moment.dot(twist.angular)
    }
}

impl Add for Wrench {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self { force: self.force + other.force, moment: self.moment + other.moment }
    }
}

impl AddAssign for Wrench {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Sub for Wrench {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { force: self.force - other.force, moment: self.moment - other.moment }
    }
}

impl Mul<Wrench> for f64 {
    type Output = Wrench;
    #[inline]
    fn mul(self, wrench: Wrench) -> Wrench {
        Wrench { force: self * wrench.force, moment: self * wrench.moment }
    }
}
