//! Undrained clay: Tresca's law with a strength of its own at every point, which remoulding takes away and
//! the rate of shear adds to.
//!
//! s_u = s_u0 [δ + (1 − δ) e^(−3 ξ/ξ₉₅)] [1 + μ log₁₀(γ̇/γ̇_ref)] (Einav & Randolph 2005, eq. 2): s_u0 is the
//! strength of the intact clay at the reference rate, δ = 1/S_t the remoulded portion of it, ξ the
//! accumulated plastic shear strain, ξ₉₅ that at which 95 % of the loss has happened; the last factor is at
//! least 1. Free of branches, so that loops vectorise.

use super::Real;
use super::elastic::Elastic;
use super::mohr_coulomb::MohrCoulomb;
use super::tensor::{Spectrum, Symmetric, contract, deviator};
use super::yield_law::{Point, Returned, YieldLaw};

/// What remoulding and rate do to the strength.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClayParameters {
    /// Sensitivity S_t ≥ 1: strength of the intact clay over that of the remoulded one.
    pub sensitivity: Real,
    /// Plastic shear strain at which 95 % of the loss has happened, ξ₉₅ > 0.
    pub remoulding_strain: Real,
    /// Gain of strength per tenfold rate of shear, μ ≥ 0.
    pub rate_strengthening: Real,
    /// Rate of shear up to which the strength does not grow, γ̇_ref > 0 [1/s].
    pub reference_rate: Real,
}

/// Strength parameters, and the moduli of the return mapping.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Clay {
    /// The return mapping, whatever the strength.
    pub(crate) tresca: MohrCoulomb,
    /// δ.
    pub(crate) remoulded: Real,
    /// 3 √3/ξ₉₅: ξ is √3 times the equivalent plastic strain.
    pub(crate) per_remoulding: Real,
    /// μ/ln 10.
    pub(crate) rate: Real,
    /// 1/(2 G γ̇_ref) [s/Pa].
    pub(crate) per_reference: Real,
}

impl Clay {
    /// A clay from its moduli and parameters; the strength of the intact clay is that of each point.
    #[must_use]
    pub fn new(elastic: Elastic, parameters: &ClayParameters) -> Self {
        Self {
            tresca: MohrCoulomb::tresca(elastic, 0.0),
            remoulded: 1.0 / parameters.sensitivity,
            per_remoulding: 3.0 * Real::sqrt(3.0) / parameters.remoulding_strain,
            rate: parameters.rate_strengthening / Real::ln(10.0),
            per_reference: 1.0 / (2.0 * elastic.shear * parameters.reference_rate),
        }
    }

    /// Double-precision parameters, cast to this precision.
    #[must_use]
    pub fn cast(exact: &crate::double::clay::Clay) -> Self {
        Self {
            tresca: MohrCoulomb::cast(&exact.tresca),
            remoulded: exact.remoulded as Real,
            per_remoulding: exact.per_remoulding as Real,
            rate: exact.rate as Real,
            per_reference: exact.per_reference as Real,
        }
    }

    /// Strength up to the reference rate [Pa], from that of the intact clay [Pa] and the equivalent plastic
    /// strain.
    #[inline(always)]
    #[must_use]
    pub fn slow_strength(&self, intact: Real, plastic_strain: Real) -> Real {
        intact * (self.remoulded + (1.0 - self.remoulded) * decay(self.per_remoulding * plastic_strain))
    }

    /// Strength of a point [Pa] in a step that leads it to a trial stress [Pa].
    #[inline(always)]
    #[must_use]
    pub fn strength(&self, trial: Symmetric, point: &Point) -> Real {
        let mut change: Symmetric = [0.0; 6];
        for c in 0..6 {
            change[c] = trial[c] - point.stress[c];
        }
        // The strain rate is that of the trial stress, which the flow has not relieved.
        let change = deviator(change);
        let rate = (2.0 * contract(change, change)).sqrt() * self.per_reference / point.duration;
        let factor = 1.0 + self.rate * logarithm(if rate > 1.0 { rate } else { 1.0 });
        self.slow_strength(point.memory.intact_strength, point.plastic_strain) * factor
    }
}

impl YieldLaw for Clay {
    const HAS_STRENGTH: bool = true;

    /// Compares with the circle inscribed in the hexagon of the slow strength, σ₁ − σ₃ ≤ 2 √J₂. In a remap no
    /// time passes, and there is no rate: a stress waits for the next step.
    #[inline(always)]
    fn may_yield(&self, stress: Symmetric, point: &Point) -> bool {
        let s = deviator(stress);
        let limit = self.slow_strength(point.memory.intact_strength, point.plastic_strain);
        (0.5 * contract(s, s) > limit * limit) & (point.duration > 0.0)
    }

    #[inline(always)]
    fn return_map(&self, trial: Symmetric, point: &Point) -> Returned {
        let law = MohrCoulomb { cohesive: 2.0 * self.strength(trial, point), ..self.tresca };
        let spectrum = Spectrum::of(trial);
        law.returned(&spectrum, law.shear_return(spectrum.principal, false))
    }
}

/// e⁻ˣ for x ≥ 0, within 1e-6 of its value up to x = 20: the 64th power of the series of e^(−x/64); less than
/// 1e-25 from x = 60 on.
#[inline(always)]
fn decay(x: Real) -> Real {
    let y = (if x < 60.0 { x } else { 60.0 }) * (1.0 / 64.0);
    let mut power = 1.0
        - y * (1.0 - y * (0.5 - y * (1.0 / 6.0 - y * (1.0 / 24.0 - y * (1.0 / 120.0 - y * (1.0 / 720.0))))));
    for _ in 0..6 {
        power *= power;
    }
    power
}

/// Natural logarithm of x from 1 to 1e15, within 1e-5: 64 times that of the 64th root, by the series of the
/// inverse hyperbolic tangent.
#[inline(always)]
fn logarithm(x: Real) -> Real {
    let mut root = x;
    for _ in 0..6 {
        root = root.sqrt();
    }
    let z = (root - 1.0) / (root + 1.0);
    let square = z * z;
    128.0
        * z
        * (1.0 + square * (1.0 / 3.0 + square * (1.0 / 5.0 + square * (1.0 / 7.0 + square * (1.0 / 9.0)))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decay_and_logarithm_are_close() {
        let close = |a: Real, b: Real, tolerance: Real| (a - b).abs() <= tolerance;
        for n in 0..=200 {
            let x = 0.1 * Real::from(n as u8);
            assert!(close(decay(x), (-x).exp(), 2e-5 * (-x).exp()), "{x}");
            let x = Real::powf(10.0, 0.075 * Real::from(n as u8));
            assert!(close(logarithm(x), x.ln(), 2e-5), "{x}");
        }
        assert!(decay(1e9) < 1e-25 && logarithm(1.0) == 0.0);
    }
}
