//! Two-dimensional RFT, the original form of the theory.

use super::{Traction, dot};
use crate::error::{ModelResult, positive};

/// Two-dimensional resistive force theory of Li, Zhang & Goldman.
///
/// With the inclination β of the surface element and the direction γ of its motion below the horizontal:
/// α_z = ζ[A₀₀ + A₁₀ cos 2β + B₁₁ sin(2β+γ) + B₀₁ sin γ + B₋₁₁ sin(−2β+γ)],
/// α_x = ζ[C₁₁ cos(2β+γ) + C₀₁ cos γ + C₋₁₁ cos(−2β+γ) + D₁₀ sin 2β], traction α |z|.
/// Source: Li, Zhang & Goldman (2013), Science 339, 1408; coefficients read in qishuny/3D-RFT-wheel. Normals
/// must lie in the x–z plane. The coefficients include the friction of the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanarLaw {
    /// Pressure over depth under a level plate moved vertically downwards, ζ [N/m³] (1 N/cm³ = 10⁶ N/m³).
    pub stiffness: f64,
}

impl PlanarLaw {
    /// The law for a measured plate stiffness ζ [N/m³].
    ///
    /// # Errors
    /// Unless it is positive.
    pub fn new(stiffness: f64) -> ModelResult<Self> {
        Ok(Self { stiffness: positive("plate stiffness [N/m^3]", stiffness)? })
    }

    /// Generic (dimensionless) traction (α_x against the motion, α_z upwards) for inclination β and direction
    /// γ [rad] of an element that moves forwards (β > 0: the lower edge trails, as at the front of a wheel).
    #[must_use]
    pub fn generic(beta: f64, gamma: f64) -> (f64, f64) {
        let double = 2.0 * beta;
        let up = 0.206
            + 0.169 * double.cos()
            + 0.212 * (double + gamma).sin()
            + 0.358 * gamma.sin()
            + 0.055 * (gamma - double).sin();
        let back = -0.124 * (double + gamma).cos()
            + 0.253 * gamma.cos()
            + 0.007 * (gamma - double).cos()
            + 0.088 * double.sin();
        (back, up)
    }
}

impl Traction for PlanarLaw {
    fn traction(&self, depth: f64, normal: [f64; 3], direction: [f64; 3]) -> [f64; 3] {
        if depth <= 0.0 || dot(normal, direction) < 0.0 {
            return [0.0; 3];
        }
        // The law is stated for motion in one direction; the opposite one is its mirror image.
        let side = if direction[0] < 0.0 { -1.0 } else { 1.0 };
        let down = if normal[2] < 0.0 { normal } else { normal.map(|x| -x) };
        let beta = (side * down[0]).atan2(-down[2]);
        let gamma = (-direction[2]).atan2(side * direction[0]);
        let (back, up) = Self::generic(beta, gamma);
        let scale = self.stiffness * depth;
        [-side * scale * back, 0.0, scale * up]
    }
}
