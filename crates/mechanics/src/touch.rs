//! Bodies that touch each other: pairs that may, and where they do.

use crate::pose::Pose;
use crate::twist::Twist;
use glam::DVec3;
use std::fmt::Debug;

/// A place where two bodies touch, or may touch within a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Touch {
    /// From the reference point of each body to the place [m].
    pub arms: [DVec3; 2],
    /// Unit normal, from the first body to the second.
    pub normal: DVec3,
    /// Gap between their surfaces there [m]; negative where they overlap.
    pub gap: f64,
}

/// How two surfaces answer each other.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Surfaces {
    /// Coefficient of friction.
    pub friction: f64,
    /// Coefficient of restitution: velocity of separation after an impact over that of approach before it, 0
    /// to 1.
    pub restitution: f64,
}

/// Two bodies that may touch.
pub trait Pair: Debug + Send + Sync {
    /// Their numbers.
    fn bodies(&self) -> [usize; 2];

    /// How their surfaces answer each other.
    fn surfaces(&self) -> Surfaces;

    /// Adds where they touch, or may within a step of `dt` [s], at these poses and about these twists.
    fn touches(&self, poses: [&Pose; 2], twists: [&Twist; 2], dt: f64, found: &mut Vec<Touch>);
}
