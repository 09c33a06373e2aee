//! The velocity of a rigid body.

use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::ops::{Add, AddAssign, Mul, Sub};

/// Velocity of a rigid body: of its reference point, and of rotation. Axes of space.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Twist {
    /// Velocity of the reference point [m/s].
    pub linear: DVec3,
    /// Angular velocity [rad/s].
    pub angular: DVec3,
}

impl Twist {
    /// No motion.
    pub const ZERO: Self = Self { linear: DVec3::ZERO, angular: DVec3::ZERO };

    /// Components of the velocity [m/s] and of the angular velocity [rad/s].
    #[must_use]
    pub fn components(&self) -> [f64; 6] {
        let ([vx, vy, vz], [wx, wy, wz]) = (self.linear.to_array(), self.angular.to_array());
        [vx, vy, vz, wx, wy, wz]
    }

    /// The twist of these components.
    #[must_use]
    pub fn of([vx, vy, vz, wx, wy, wz]: [f64; 6]) -> Self {
        Self { linear: DVec3::new(vx, vy, vz), angular: DVec3::new(wx, wy, wz) }
    }

    /// Velocity of the body's point at `arm` from the reference point [m/s].
    #[must_use]
    #[inline]
    pub fn at(&self, arm: DVec3) -> DVec3 {
        self.linear + self.angular.cross(arm)
    }
}

impl Add for Twist {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self { linear: self.linear + other.linear, angular: self.angular + other.angular }
    }
}

impl AddAssign for Twist {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Sub for Twist {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { linear: self.linear - other.linear, angular: self.angular - other.angular }
    }
}

impl Mul<Twist> for f64 {
    type Output = Twist;
    #[inline]
    fn mul(self, twist: Twist) -> Twist {
        Twist { linear: self * twist.linear, angular: self * twist.angular }
    }
}
