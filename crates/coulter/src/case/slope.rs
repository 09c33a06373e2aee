//! Ground on a slope: the axes of the case lie in its surface, and gravity is tilted.

use super::resolved::Law;
use glam::DVec3;
use serde::Serialize;
use std::f64::consts::FRAC_PI_2;

/// Slope of the ground.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Slope {
    /// Its angle along x, uphill positive [rad].
    pub along: f64,
    /// Its angle along y, uphill positive [rad].
    pub across: f64,
}

impl Slope {
    /// Whether the ground is level.
    #[must_use]
    pub fn is_level(&self) -> bool {
        *self == Self::default()
    }

    /// Its angles along x and y [rad].
    #[must_use]
    pub fn angles(&self) -> [f64; 2] {
        [self.along, self.across]
    }

    /// Unit vector along which gravity acts.
    #[must_use]
    pub fn down(&self) -> DVec3 {
        if self.is_level() {
            return DVec3::NEG_Z;
        }
        let [along, across] = self.angles().map(|angle| if angle == 0.0 { 0.0 } else { -angle.tan() });
        DVec3::new(along, across, -1.0).normalize()
    }

    /// Cosine of its steepest angle: the part of gravity that acts normal to the surface.
    #[must_use]
    pub fn cosine(&self) -> f64 {
        -self.down().z
    }

    /// Tangent of its steepest angle: shear over normal stress on planes parallel to the surface of soil at rest.
    #[must_use]
    pub fn tangent(&self) -> f64 {
        let down = self.down();
        down.truncate().length() / -down.z
    }

    /// Coefficient of earth pressure at rest of a soil that has this one [−] on level ground: as much larger as it takes for the soil
    /// to rest on the slope with 0.98 of its friction, where that is possible; 1 for soil without friction, whose shear
    /// stress is then least.
    #[must_use]
    pub fn k0(&self, level: f64, law: &Law) -> f64 {
        if self.is_level() {
            return level;
        }
        let Some(friction) = law.friction_angle().filter(|angle| *angle > 0.0) else { return 1.0 };
        /// Portion of sin φ that the soil at rest may mobilise, and steps in which the coefficient is raised.
        const MOBILISED: f64 = 0.98;
        const STEP: f64 = 0.005;
        let rests = |k0: &f64| {
            let [most, least] = self.principal_stresses(*k0);
            most - least <= (most + least) * MOBILISED * friction.sin()
        };
        let raised = (0..600_u32).map(|n| level + STEP * f64::from(n)).find(rests);
        raised.unwrap_or(1.0)
    }

    /// Largest and least principal stress of soil at rest, compression positive, over the stress normal to the surface.
    #[must_use]
    pub fn principal_stresses(&self, k0: f64) -> [f64; 2] {
        let radius = (0.5 * (1.0 - k0)).hypot(self.tangent());
        let middle = 0.5 * (1.0 + k0);
        [(middle + radius).max(k0), (middle - radius).min(k0)]
    }
}

/// Whether soil of a law sustains these principal stresses [Pa], compression positive; of sand up to the critical state, since shear
/// beyond it only hardens it up to its peak.
pub(super) fn sustains(law: &Law, [most, least]: [f64; 2]) -> bool {
    let friction = |angle: f64, cohesion: f64| {
        most - least <= (most + least) * angle.min(FRAC_PI_2).sin() + 2.0 * cohesion * angle.cos()
    };
    match *law {
        Law::Elastic => true,
        Law::Sand { critical_friction_angle, .. } => friction(critical_friction_angle, 0.0),
        Law::Tresca { shear_strength } => most - least <= 2.0 * shear_strength,
        Law::VonMises { yield_stress, .. } => most - least <= yield_stress,
        Law::MohrCoulomb { friction_angle, cohesion, .. } => friction(friction_angle, cohesion),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::resolved::Potential;

    fn frictional(angle: f64) -> Law {
        Law::MohrCoulomb {
            friction_angle: angle.to_radians(),
            dilation_angle: 0.0,
            cohesion: 0.0,
            tension_cutoff: 0.0,
            potential: Potential::MohrCoulomb,
            critical_density: None,
        }
    }

    #[test]
    fn gravity_pulls_down_the_slope() {
        let slope = Slope { along: 0.3, across: 0.0 };
        assert!((slope.down() - DVec3::new(-0.3_f64.sin(), 0.0, -0.3_f64.cos())).length() < 1e-15);
        assert!((slope.tangent() - 0.3_f64.tan()).abs() < 1e-15);
        assert_eq!(Slope::default().down(), DVec3::NEG_Z);
        // Two slopes: the surface rises by the tangents of both.
        let both = Slope { along: 0.2, across: -0.1 };
        assert!((both.tangent() - 0.2_f64.tan().hypot(0.1_f64.tan())).abs() < 1e-15);
        assert!(both.down().x < 0.0 && both.down().y > 0.0);
    }

    #[test]
    fn sand_rests_on_slopes_up_to_its_friction_angle() {
        let law = frictional(35.0);
        let level = 1.0 - 35_f64.to_radians().sin();
        for degrees in [0.0_f64, 5.0, 20.0, 30.0, 34.0, 36.0] {
            let slope = Slope { along: degrees.to_radians(), across: 0.0 };
            let k0 = slope.k0(level, &law);
            assert_eq!(sustains(&law, slope.principal_stresses(k0)), degrees < 35.0, "{degrees}°, {k0}");
            assert!(if degrees < 10.0 { k0 == level } else { k0 > level });
        }
    }
}
