//! Reductions over a row, in vector lanes.

use super::{LANES, Real};

/// Sum in eight lanes that are added at the end, so that the result does not depend on the processor's vector
/// width.
#[inline(always)]
pub fn lane_sum(values: &[Real]) -> f64 {
    let mut lanes: [Real; 8] = [0.0; 8];
    for chunk in values.chunks_exact(8) {
        for (lane, value) in lanes.iter_mut().zip(chunk) {
            *lane += value;
        }
    }
    total_of_lanes(lanes, values.chunks_exact(8).remainder())
}

/// [`lane_sum`] from the sums of the eight lanes, and the values beyond the last whole vector.
#[inline(always)]
#[must_use]
pub fn total_of_lanes(lanes: [Real; 8], tail: &[Real]) -> f64 {
    let tail: Real = tail.iter().sum();
    let (lanes, tail) = (lanes.map(f64::from), f64::from(tail));
    ((lanes[0] + lanes[4]) + (lanes[1] + lanes[5])) + ((lanes[2] + lanes[6]) + (lanes[3] + lanes[7])) + tail
}

/// Largest of some non-negative values; 0 for none.
#[inline(always)]
pub fn lane_max(values: &[Real]) -> Real {
    let mut lanes = [0.0; LANES];
    for chunk in values.chunks_exact(LANES) {
        for (lane, value) in lanes.iter_mut().zip(chunk) {
            *lane = if *value > *lane { *value } else { *lane };
        }
    }
    let tail = values.chunks_exact(LANES).remainder();
    lanes.iter().chain(tail).fold(0.0, |a, b| if *b > a { *b } else { a })
}
