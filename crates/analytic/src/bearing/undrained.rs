//! Undrained clay (φ = 0): the bearing capacity factor N_c with shape, depth and sliding.

use super::Footing;
use crate::error::{ModelResult, non_negative, positive, within};
use numerics::search::root;
use std::f64::consts::{FRAC_PI_2, PI};

/// N_c of a strip under a vertical load: 2 + π, exact. Source: Prandtl (1920).
const STRIP: f64 = 2.0 + PI;
/// N_c of a smooth and of a rough circle at the surface, exact. Source: Shield (1955); Eason & Shield (1960)
/// (recalled).
const CIRCLE: (f64, f64) = (5.69, 6.05);
/// Depth over width from which the depth factor no longer grows.
const DEEP: f64 = 2.5;

/// N_c of a rectangular footing of breadth over length B/L at the depth over width D/B, under a vertical
/// load: (2 + π)(1 + 0.2 B/L)(1 + 0.2 D/B), D/B at most 2.5: from 5.14 to 7.7 for a strip, from 6.17 to 9.25
/// for a square.
///
/// Source: Skempton (1951), Building Research Congress, with 5.14 and 6.2 at the surface and 7.5 and 9 at
/// depth (recalled).
///
/// # Errors
/// If the footing is out of range.
pub fn undrained_factor(footing: &Footing) -> ModelResult<f64> {
    let width = positive("footing width [m]", footing.width)?;
    let slenderness = width / within("footing length [m]", footing.length, width, f64::MAX)?;
    let depth = non_negative("footing depth [m]", footing.depth)? / width;
    Ok(STRIP * (1.0 + 0.2 * slenderness) * (1.0 + 0.2 * depth.min(DEEP)))
}

/// N_c of a round footing at the surface relative to that of a square one, for a base between smooth (0) and
/// rough (1).
pub(crate) fn round_over_square(roughness: f64) -> f64 {
    (CIRCLE.0 + (CIRCLE.1 - CIRCLE.0) * roughness) / (1.2 * STRIP)
}

/// N_c of a strip that a shear stress τ = h s_u drags sideways, over that without:
/// [1 + π/2 + acos h + √(1 − h²)]/(2 + π), 0 ≤ h ≤ 1; exact. Source: Green (1954), J. Mech. Phys. Solids 2,
/// 197–211 (recalled).
fn sliding(h: f64) -> f64 {
    (1.0 + FRAC_PI_2 + h.acos() + (1.0 - h * h).max(0.0).sqrt()) / STRIP
}

/// The fraction τ/s_u of the shear strength that friction μ mobilises under such a footing: τ = μ p, at most
/// s_u.
fn mobilised_shear(friction: f64, vertical_factor: f64) -> f64 {
    let excess = |h: f64| h - friction * vertical_factor * sliding(h);
    if excess(1.0) <= 0.0 { 1.0 } else { root(0.0, 1.0, 1e-13, excess).unwrap_or(0.0) }
}

/// The pressure s_u N_c [Pa] under a footing on clay of undrained shear strength s_u [Pa]; its load, inclined
/// by δ to the normal, shears the clay by p tan δ, at most by s_u.
///
/// # Errors
/// If the strength or the footing is out of range.
pub fn undrained_pressure(shear_strength: f64, footing: &Footing) -> ModelResult<f64> {
    let strength = positive("undrained shear strength [Pa]", shear_strength)?;
    let load = within("load inclination [rad]", footing.load_inclination, 0.0, FRAC_PI_2 - 1e-9)?;
    let vertical_factor = undrained_factor(footing)?;
    Ok(strength * vertical_factor * sliding(mobilised_shear(load.tan(), vertical_factor)))
}

/// The largest friction μ = τ/p that such a footing on clay can transfer: there τ = α s_u, with the adhesion
/// factor α of 0 to 1.
///
/// # Errors
/// If the footing or α is out of range.
pub fn undrained_friction_limit(footing: &Footing, adhesion_factor: f64) -> ModelResult<f64> {
    let fraction = within("adhesion factor", adhesion_factor, 0.0, 1.0)?;
    Ok(fraction / (undrained_factor(footing)? * sliding(fraction)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn skemptons_factors_are_met() {
        let footing = |length: f64, depth: f64| Footing { width: 1.0, length, depth, load_inclination: 0.0 };
        for (length, depth, expected, allowed) in
            [(1e9, 0.0, 5.14, 0.01), (1.0, 0.0, 6.2, 0.01), (1e9, 4.0, 7.5, 0.04), (1.0, 4.0, 9.0, 0.04)]
        {
            let found = undrained_factor(&footing(length, depth)).unwrap();
            assert!((found / expected - 1.0).abs() < allowed, "{found} for {expected}");
        }
        assert!((1.2 * STRIP * round_over_square(0.0) - 5.69).abs() < 1e-9);
    }

    #[test]
    fn sliding_halves_the_factor() {
        assert!((sliding(0.0) - 1.0).abs() < 1e-15);
        assert!((sliding(1.0) * STRIP - (1.0 + FRAC_PI_2)).abs() < 1e-12);
        let strip = Footing { width: 1.0, length: 1e9, depth: 0.0, load_inclination: 0.0 };
        let limit = undrained_friction_limit(&strip, 1.0).unwrap();
        assert!((limit - 1.0 / (1.0 + FRAC_PI_2)).abs() < 1e-6);
        assert!(undrained_friction_limit(&strip, 0.5).unwrap() < limit);
        // Friction beyond the limit changes nothing: the clay shears.
        let at = |friction: f64| {
            undrained_pressure(1.0, &Footing { load_inclination: friction.atan(), ..strip }).unwrap()
        };
        assert!((at(limit) - at(1.0)).abs() < 1e-6 && at(0.5 * limit) > at(limit));
    }
}
