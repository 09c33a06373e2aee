//! Why a mechanism cannot be computed.

use std::fmt;

/// What is wrong with a body or a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Invalid {
    /// A body that moves freely needs a positive, finite mass.
    Mass,
    /// A body that rotates freely needs a symmetric, positive inertia tensor.
    Tensor,
    /// The principal moments of inertia violate the triangle inequality: no solid has them.
    Triangle,
    /// The modelled fraction of a body must lie above 0 and not above 1.
    ModelledFraction,
    /// What the fluid does to a body is not a number.
    Fluid,
    /// A joint names a body that is not there, or connects a body with itself.
    Joint,
}

impl fmt::Display for Invalid {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self {
            Self::Mass => "a body that moves freely needs a positive, finite mass",
            Self::Tensor => "a body that rotates freely needs a symmetric, positive inertia tensor",
            Self::Triangle => "the largest principal moment of inertia exceeds the sum of the other two",
            Self::ModelledFraction => "the modelled fraction of a body must lie above 0 and not above 1",
            Self::Fluid => "buoyancy and drag of a body must be finite",
            Self::Joint => {
                "a joint must connect two different bodies of the mechanism, or one with the ground"
            }
        })
    }
}

impl std::error::Error for Invalid {}
