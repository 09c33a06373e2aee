//! Pipes in clay: pressed in from the surface, and the limit of flow around them.

use crate::error::{ModelResult, within};
use crate::soil::Soil;
use std::f64::consts::{FRAC_PI_4, PI};

/// a and b of a smooth and of a rough pipe.
const POWER: [(f64, f64); 2] = [(4.97, 0.23), (6.73, 0.29)];

/// Vertical force [N/m] on a pipe of the diameter d [m] pressed z [m] into clay from its surface: s_u d a
/// (z/d)^b + γ A, with s_u at the lowest point, between a = 4.97, b = 0.23 for a smooth and 6.73, 0.29 for a
/// rough one, and A the section below the ground.
///
/// Source: Aubeny, Shi & Murff (2005), Int. J. Geomech. 5(4), 320–325, finite elements for depths up to d/2.
/// At d/2 a rough pipe is within 7 % of a strip as wide, with the depth factor of its middle.
///
/// # Errors
/// Unless 0 < z ≤ d/2 and the roughness is within 0 to 1.
pub fn pipe_penetration(soil: &Soil, diameter: f64, z: f64, roughness: f64) -> ModelResult<f64> {
    let depth = within("depth over the diameter of the pipe", z / diameter, f64::MIN_POSITIVE, 0.5)?;
    let alpha = within("roughness", roughness, 0.0, 1.0)?;
    let [smooth, rough] = POWER.map(|(a, b)| a * depth.powf(b));
    let strength = soil.cohesion + soil.strength_gradient * z;
    let angle = (1.0 - 2.0 * depth).acos();
    let section = 0.25 * diameter * diameter * (angle - angle.sin() * angle.cos());
    Ok(strength * diameter * (smooth + alpha * (rough - smooth)) + soil.unit_weight * section)
}

/// Force over s_u d at which clay flows around a deep cylinder: π + 2Δ + 4 cos(π/4 − Δ/2)(√2 + sin(π/4 −
/// Δ/2)), sin Δ = α: 9.14 for a smooth and 11.94 for a rough one.
///
/// Source: Randolph & Houlsby (1984), Géotechnique 34(4), 613–623; exact for a rough, close to it for a
/// smooth cylinder.
///
/// # Errors
/// Unless the roughness is within 0 to 1.
pub fn flow_round_factor(roughness: f64) -> ModelResult<f64> {
    let delta = within("roughness", roughness, 0.0, 1.0)?.asin();
    let angle = FRAC_PI_4 - 0.5 * delta;
    Ok(PI + 2.0 * delta + 4.0 * angle.cos() * (2_f64.sqrt() + angle.sin()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn clay(unit_weight: f64, strength_gradient: f64) -> Soil {
        Soil {
            friction_angle: 0.0,
            dilation_angle: 0.0,
            cohesion: 1e3,
            unit_weight,
            body_friction: 1.0,
            adhesion_factor: 1.0,
            strength_gradient,
        }
    }

    #[test]
    fn pipes_are_between_smooth_and_rough() {
        let at = |z: f64, alpha: f64| pipe_penetration(&clay(0.0, 0.0), 1.0, z, alpha).unwrap() / 1e3;
        assert!((at(0.5, 0.0) - 4.24).abs() < 0.01 && (at(0.5, 1.0) - 5.50).abs() < 0.01);
        // White & Randolph's 6 (z/d)^0.25 lies between them.
        for z in [0.1, 0.3, 0.5_f64] {
            let usual = 6.0 * z.powf(0.25);
            assert!(at(z, 0.0) < usual && usual < 1.05 * at(z, 1.0), "{z}");
        }
        // Half a section floats; growing strength counts at the lowest point.
        let more = pipe_penetration(&clay(8e3, 2e3), 1.0, 0.5, 0.0).unwrap();
        assert!((more - (2.0 * 1e3 * at(0.5, 0.0) + 8e3 * PI / 8.0)).abs() < 1e-6);
        assert!(pipe_penetration(&clay(0.0, 0.0), 1.0, 0.6, 0.0).is_err());
    }

    #[test]
    fn flow_round_is_that_of_randolph_and_houlsby() {
        assert!((flow_round_factor(0.0).unwrap() - 9.142).abs() < 1e-3);
        assert!((flow_round_factor(1.0).unwrap() - 11.940).abs() < 1e-3);
    }
}
