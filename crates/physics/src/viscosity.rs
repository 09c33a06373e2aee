//! Bulk viscosity: a pressure that resists fast changes of volume.
//!
//! q = ρ b₁ c l ε̇ᵥ − ρ (b₂ l ε̇ᵥ)² for compression (von Neumann & Richtmyer 1950; Landshoff 1955), as a stress, tension
//! positive. The linear term also acts in expansion, against oscillations of dilating soil. It must stay small compared with the
//! contact stress: in frictional soil it acts like a confining pressure.

use super::Real;

/// Coefficients of bulk viscosity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BulkViscosity {
    /// b₁ ρ c [Pa s/m].
    pub linear: Real,
    /// b₂² ρ [kg/m³].
    pub quadratic: Real,
}

impl BulkViscosity {
    /// From the dimensionless b₁ and b₂, density [kg/m³] and wave speed [m/s].
    #[must_use]
    pub fn new(b1: Real, b2: Real, density: Real, wave_speed: Real) -> Self {
        Self { linear: b1 * density * wave_speed, quadratic: b2 * b2 * density }
    }

    /// Double-precision coefficients, cast to this precision.
    #[must_use]
    pub fn cast(exact: &crate::double::viscosity::BulkViscosity) -> Self {
        Self { linear: exact.linear as Real, quadratic: exact.quadratic as Real }
    }

    /// Viscous stress [Pa], negative in compression, for a cell of size `length` [m] at volumetric rate ε̇ᵥ [1/s].
    #[inline(always)]
    #[must_use]
    pub fn stress(&self, length: Real, volumetric_rate: Real) -> Real {
        let speed = length * volumetric_rate;
        let compression = if speed < 0.0 { speed } else { 0.0 };
        self.linear * speed - self.quadratic * compression * compression
    }
}
