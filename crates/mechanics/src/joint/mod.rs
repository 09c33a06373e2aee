//! Joints between two bodies, or between a body and the ground. A joint is one file that
//! implements [`Joint`].
//!
//! A joint is a few rows J of a condition on the velocities of a step, J u = bias. Written with mean arms and
//! mean axes it keeps points and axes together exactly, since with the Cayley map displacements within a step
//! are linear in them.

mod ball;
mod hinge;
mod slider;
mod spring;

pub use ball::Ball;
pub use hinge::Hinge;
pub use slider::Slider;
pub use spring::Spring;

use crate::configuration::Configuration;
use crate::wrench::Wrench;
use glam::DVec3;
use std::fmt::Debug;

/// Fraction of a remaining gap that a joint closes within a step; chosen: small enough to do no noticeable
/// work, large enough to undo round-off (Baumgarte 1972).
pub const CLOSURE: f64 = 0.1;

/// A joint.
pub trait Joint: Debug + Send + Sync {
    /// Numbers of the bodies that the joint connects; `None` for the ground.
    fn bodies(&self) -> [Option<usize>; 2];

    /// Conditions of the joint on the velocities of a step of `dt` [s], from the attitudes of both bodies.
    fn rows(&self, bodies: [&Configuration; 2], dt: f64) -> Rows;

    /// Energy that the joint stores [J], from the attitudes of both bodies at the start of a step.
    fn energy(&self, _bodies: [&Configuration; 2]) -> f64 {
        0.0
    }
}

/// One condition on the velocities of two bodies: Σ wrench · twist + compliance · impulse = bias.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Row {
    /// Wrench on each body, about its reference point, per unit impulse of the joint.
    pub wrench: [Wrench; 2],
    /// Velocity that the joint asks for [m/s or rad/s].
    pub bias: f64,
    /// Velocity per impulse by which the joint yields [1/kg or 1/(kg m²)]; 0 for a rigid joint. The impulse
    /// meant is half that of the step: a spring of stiffness k and damping d has 2/(Δt (½ k Δt + d)).
    pub compliance: f64,
}

/// The rows of a joint, six at most.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rows {
    rows: [Row; 6],
    number: usize,
}

impl Rows {
    /// Adds a row; a seventh is ignored, since two bodies have six relative motions.
    pub fn push(&mut self, row: Row) {
        if self.number < self.rows.len() {
            self.rows[self.number] = row;
            self.number += 1;
        }
    }

    /// The rows.
    #[must_use]
    pub fn as_slice(&self) -> &[Row] {
        &self.rows[..self.number]
    }
}

/// Rows that keep pairs of directions perpendicular, a · b = 0, the first of each carried by the first body
/// and the second by the second: the change of a · b in a step is Δt (ω₁ − ω₂) · (ā × b̄) exactly.
fn couples<const N: usize>(
    pairs: [[DVec3; 2]; N],
    [first, second]: [&Configuration; 2],
    dt: f64,
    rows: &mut Rows,
) {
    for [a, b] in pairs {
        let couple = Wrench::couple(first.mean(a).cross(second.mean(b)));
        let gap = (first.start * a).dot(second.start * b);
        rows.push(Row { wrench: [couple, -1.0 * couple], bias: -CLOSURE * gap / dt, compliance: 0.0 });
    }
}
