//! Slope limiter for second-order transport without new extrema.

use super::Real;
use super::select::min;

/// Monotonised central slope (van Leer 1977) from the differences to the left and right neighbours, in their
/// unit.
#[inline(always)]
#[must_use]
pub fn monotonised_central(left: Real, right: Real) -> Real {
    let central = 0.5 * (left + right);
    let bound = 2.0 * min(left.abs(), right.abs());
    let size = min(central.abs(), bound);
    let limited = if central < 0.0 { -size } else { size };
    if left * right > 0.0 { limited } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::monotonised_central;

    #[test]
    fn is_central_where_smooth_and_flat_at_an_extremum() {
        assert_eq!(monotonised_central(1.0, 1.5), 1.25);
        assert_eq!(monotonised_central(1.0, -1.5), 0.0);
        assert_eq!(monotonised_central(0.1, 10.0), 0.2);
        assert_eq!(monotonised_central(-0.1, -10.0), -0.2);
    }
}
