//! Bulk viscosity: a pressure that resists fast changes of volume.
//!
//! q = ρ b₁ c l ε̇ᵥ − ρ (b₂ l ε̇ᵥ)² for compression (von Neumann & Richtmyer 1950; Landshoff 1955), as a
//! stress, tension positive. The linear term also acts in expansion, against oscillations of dilating soil.
//! The viscosity must stay small compared with the contact stress: in frictional soil it acts like a
//! confining pressure.

use super::Real;

/// Length of a box cell that is not a cube [m]: the mean of its `widths` along x, y, z [m], weighted by the
/// squares of the normal strain `rates` along them [1/s]. A wave along an axis is damped as in cubes of the
/// cell's width along it; a flow that changes no volume has no viscous pressure, whatever its direction.
#[inline(always)]
#[must_use]
pub fn strained_width(widths: [Real; 3], rates: [Real; 3]) -> Real {
    // A cell at rest has the plain mean.
    let weight = rates.map(|rate| rate * rate + Real::MIN_POSITIVE);
    let [x, y, z] = weight;
    (x * widths[0] + y * widths[1] + z * widths[2]) / (x + y + z)
}

/// Coefficients of bulk viscosity.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct BulkViscosity {
    /// b₁ ρ c [Pa s/m].
    pub linear: Real,
    /// b₂² ρ [kg/m³].
    pub quadratic: Real,
}

impl BulkViscosity {
    /// Bulk viscosity from the dimensionless b₁ and b₂, density [kg/m³] and wave speed [m/s].
    #[must_use]
    pub fn new(b1: Real, b2: Real, density: Real, wave_speed: Real) -> Self {
        Self { linear: b1 * density * wave_speed, quadratic: b2 * b2 * density }
    }

    /// Double-precision coefficients, cast to this precision.
    #[must_use]
    pub fn cast(exact: &crate::double::viscosity::BulkViscosity) -> Self {
        Self { linear: exact.linear as Real, quadratic: exact.quadratic as Real }
    }

    /// Viscous stress [Pa], negative in compression, for a cell of size `length` [m] at volumetric rate
    /// ε̇ᵥ [1/s].
    #[inline(always)]
    #[must_use]
    pub fn stress(&self, length: Real, volumetric_rate: Real) -> Real {
        let speed = length * volumetric_rate;
        let compression = if speed < 0.0 { speed } else { 0.0 };
        self.linear * speed - self.quadratic * compression * compression
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_that_is_compressed_along_an_axis_has_its_width_along_it() {
        let widths = [3.0, 2.0, 4.0];
        for (axis, width) in widths.into_iter().enumerate() {
            let mut rates = [0.0; 3];
            rates[axis] = -1e-3;
            assert!((strained_width(widths, rates) - width).abs() < 1e-5);
        }
        assert!((strained_width(widths, [0.0; 3]) - 3.0).abs() < 1e-5);
        assert!((strained_width(widths, [1.0, 0.0, -1.0]) - 3.5).abs() < 1e-5);
    }

    #[test]
    fn compression_is_resisted_by_both_terms_and_expansion_by_the_linear_one() {
        // l ε̇ᵥ = 0.06 m/s: ρ b₁ c of it is 864 Pa, ρ (b₂ of it)² 8.2944 Pa.
        let viscosity = BulkViscosity::new(0.06, 1.2, 1600.0, 150.0);
        for (rate, stress) in [(-3.0, -872.2944), (0.0, 0.0), (3.0, 864.0)] {
            assert!((viscosity.stress(0.02, rate) - stress).abs() < 1e-3, "{rate} 1/s");
        }
    }
}
