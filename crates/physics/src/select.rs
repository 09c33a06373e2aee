//! The larger and the smaller of two numbers by comparison: the methods of floats treat what is not a number
//! with care, which does not vectorise, and leave the sign of a zero to the processor.

use super::Real;

/// The first number if it is larger, else the second.
#[inline(always)]
#[must_use]
pub fn max(a: Real, b: Real) -> Real {
    if a > b { a } else { b }
}

/// The first number if it is smaller, else the second.
#[inline(always)]
#[must_use]
pub fn min(a: Real, b: Real) -> Real {
    if a < b { a } else { b }
}

/// The nearest number to `a` between `low` and `high`.
#[inline(always)]
#[must_use]
pub fn clamp(a: Real, low: Real, high: Real) -> Real {
    min(max(a, low), high)
}
