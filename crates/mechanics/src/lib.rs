//! How rigid bodies and joints move.
//!
//! A [`Mechanism`] holds bodies and joints. Each step `predict` finds the velocities without contact, contact
//! changes them through [`Step`], and `advance` moves the bodies. This crate knows no soil and no grid. Units
//! are SI, axes those of space unless stated. Equations and sources: `docs/theory/rigid-bodies.md`.

mod advance;
mod body;
pub mod cayley;
mod configuration;
mod course;
mod error;
mod fluid;
mod freedom;
mod gimbal;
mod impulses;
mod inertia;
pub mod joint;
mod mechanism;
mod midpoint;
mod mobility;
mod motion;
mod moving;
mod pose;
mod predict;
mod settle;
mod spatial;
mod start;
mod steering;
mod step;
mod system;
mod touch;
mod touching;
mod twist;
mod wrench;

pub use body::{Body, BodyState, Momentum};
pub use configuration::Configuration;
pub use course::Course;
pub use error::Invalid;
pub use fluid::Fluid;
pub use impulses::{Impulses, Work};
pub use inertia::Inertia;
pub use mechanism::{JointState, Mechanism, MechanismState};
pub use mobility::Mobility;
pub use motion::Motion;
pub use pose::Pose;
pub use steering::Steering;
pub use step::{Conditions, Step, StruckBody};
pub use touch::{Pair, Surfaces, Touch};
pub use twist::Twist;
pub use wrench::Wrench;
