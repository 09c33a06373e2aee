//! Footings on undrained clay whose strength grows with depth.

use crate::error::{ModelResult, within};
use std::f64::consts::PI;

/// Pressure over the strength at the base of a smooth strip for k B/s_u = 8 (n/16)², n = 0 to 16, by
/// [`crate::exact::strip_on_growing_strength`].
const STRIP: [f64; 17] = [
    2.0 + PI,
    5.17260,
    5.26290,
    5.40572,
    5.59295,
    5.81722,
    6.07266,
    6.35488,
    6.66073,
    6.98794,
    7.33487,
    7.70031,
    8.08340,
    8.48347,
    8.90004,
    9.33275,
    9.78131,
];
/// Growth of the factor of a circle with k B/s_u. Source: Houlsby & Martin (2003), N₂ of a flat base at the
/// surface.
const CIRCLE: f64 = 0.5;

/// What the growth k of the strength adds to N_c of a footing of the breadth over length B/L, from k B/s_u
/// with the strength at its base.
///
/// A strip after Davis & Booker (1973), smooth: for a rough one it is on the safe side; a circle, and a
/// square as it, after Houlsby & Martin (2003); between them in proportion to B/L (chosen).
///
/// # Errors
/// Unless k B/s_u is within 0 to 8, of what is no strip within 0 to 5, and B/L within 0 to 1.
pub fn growth_of_factor(growth: f64, slenderness: f64) -> ModelResult<f64> {
    let square = within("B/L", slenderness, 0.0, 1.0)?;
    let growth = within("k B/s_u", growth, 0.0, if square > 0.01 { 5.0 } else { 8.0 })?;
    let place = 16.0 * (growth / 8.0).sqrt();
    let first = (place.floor() as usize).saturating_sub(1).min(13);
    let x = place - first as f64;
    // Cubic Lagrange interpolation through the four nearest values.
    let strip: f64 = (0..4)
        .map(|i| {
            let others = (0..4).filter(|j| *j != i);
            let weight: f64 = others.map(|j| (x - j as f64) / (i as f64 - j as f64)).product();
            weight * STRIP[first + i]
        })
        .sum();
    Ok((1.0 - square) * (strip - STRIP[0]) + square * CIRCLE * growth)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::strip_on_growing_strength;

    #[test]
    fn strips_are_exact_and_circles_gain_less() {
        for growth in [0.0, 0.1, 1.0, 2.7, 8.0] {
            let exact = strip_on_growing_strength(growth).unwrap() - STRIP[0];
            assert!((growth_of_factor(growth, 0.0).unwrap() - exact).abs() < 2e-3, "{growth}");
        }
        // Davis & Booker's F = q/((2 + π) s_u + k B/4) rises from 1 to about 1.4.
        let factor = (STRIP[0] + growth_of_factor(8.0, 0.0).unwrap()) / (STRIP[0] + 2.0);
        assert!((1.3..1.45).contains(&factor), "{factor}");
        assert!(growth_of_factor(2.0, 1.0).unwrap() < growth_of_factor(2.0, 0.0).unwrap());
        assert!(growth_of_factor(6.0, 1.0).is_err() && growth_of_factor(9.0, 0.0).is_err());
    }
}
