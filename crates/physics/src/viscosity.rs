//! Bulk viscosity: a pressure that resists fast changes of volume.
//!
//! q = ρ b₁ c l ε̇ᵥ − ρ (b₂ l ε̇ᵥ)² for compression (von Neumann & Richtmyer 1950; Landshoff 1955), as a stress, tension
//! positive. The linear part also acts in expansion: without it a dilating soil rings. It must stay small beside the
//! contact stress, for in frictional soil it acts like confinement.

/// Coefficients of bulk viscosity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BulkViscosity {
    /// b₁ ρ c [Pa s/m].
    pub linear: f64,
    /// b₂² ρ [kg/m³].
    pub quadratic: f64,
}

impl BulkViscosity {
    /// From the dimensionless b₁ and b₂, density [kg/m³] and wave speed [m/s].
    #[must_use]
    pub fn new(b1: f64, b2: f64, density: f64, wave_speed: f64) -> Self {
        Self { linear: b1 * density * wave_speed, quadratic: b2 * b2 * density }
    }

    /// Viscous stress [Pa], negative in compression, for a cell of size `length` [m] at volumetric rate ε̇ᵥ [1/s].
    #[inline(always)]
    #[must_use]
    pub fn stress(&self, length: f64, volumetric_rate: f64) -> f64 {
        let speed = length * volumetric_rate;
        let squeezed = if speed < 0.0 { speed } else { 0.0 };
        self.linear * speed - self.quadratic * squeezed * squeezed
    }
}
