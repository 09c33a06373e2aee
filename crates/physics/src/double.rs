//! The material point in double precision.

/// Floating-point type of the soil's fields.
pub type Real = f64;

/// Smallest norm of a stress deviator that has a direction [Pa]; its square does not underflow.
const NO_STRESS: Real = 1e-150;
/// Value of sin 3θ/√6 below which it is rounding error and the stress lies on a meridian.
const MERIDIAN: Real = 1e-14;

#[path = "brick.rs"]
pub mod brick;
#[path = "clay.rs"]
pub mod clay;
#[path = "elastic.rs"]
pub mod elastic;
#[path = "law.rs"]
pub mod law;
#[path = "limiter.rs"]
pub mod limiter;
#[path = "menetrey_willam.rs"]
pub mod menetrey_willam;
#[path = "mohr_coulomb.rs"]
pub mod mohr_coulomb;
#[path = "sand.rs"]
pub mod sand;
#[path = "select.rs"]
pub mod select;
#[path = "tensor.rs"]
pub mod tensor;
#[path = "viscosity.rs"]
pub mod viscosity;
#[path = "von_mises.rs"]
pub mod von_mises;
#[path = "yield_law.rs"]
pub mod yield_law;
