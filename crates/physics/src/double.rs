//! The material point in double precision.

/// Floating-point type of the soil's fields.
pub type Real = f64;

/// Smallest norm of a stress deviator that has a direction [Pa]; its square does not underflow.
const NO_STRESS: Real = 1e-150;
/// Value of sin 3θ/√6 below which it is rounding error and the stress lies on a meridian.
const MERIDIAN: Real = 1e-14;

include!("modules.rs");
