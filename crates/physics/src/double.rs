//! What happens at one point of soil, in double precision.

/// The precision of the numbers.
pub type Real = f64;

/// A stress below this [Pa] has no direction; its square is still a number.
const NO_STRESS: Real = 1e-150;
/// Below this sin 3θ/√6 is rounding: the stress lies on a meridian.
const MERIDIAN: Real = 1e-14;

#[path = "brick.rs"]
pub mod brick;
#[path = "elastic.rs"]
pub mod elastic;
#[path = "limiter.rs"]
pub mod limiter;
#[path = "menetrey_willam.rs"]
pub mod menetrey_willam;
#[path = "mohr_coulomb.rs"]
pub mod mohr_coulomb;
#[path = "strength.rs"]
pub mod strength;
#[path = "tensor.rs"]
pub mod tensor;
#[path = "viscosity.rs"]
pub mod viscosity;
#[path = "von_mises.rs"]
pub mod von_mises;
