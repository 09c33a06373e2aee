//! The weight factor N_γ of a footing on sand, read from the load that it carries.

use crate::error::VerifyError;
use analytic::bearing::{davis_friction_angle, surcharge_factor};

/// Penetrations between which the load is averaged, in units of N_γ γ B²/E: beyond the elastic rise, before
/// the heave matters.
const STRETCH: [f64; 2] = [3.0, 6.0];

/// A footing on sand.
pub(crate) struct Footing {
    /// Angles of friction and dilation [rad].
    pub angles: [f64; 2],
    /// γ B/E.
    pub compliance: f64,
    /// The factor that theory expects with ψ = φ. Only the position of the stretch depends on it.
    pub expected: f64,
}

impl Footing {
    /// Penetrations over the width between which the load is averaged.
    pub(crate) fn stretch(&self) -> [f64; 2] {
        STRETCH.map(|times| times * self.expected * self.compliance)
    }

    /// N_γ = 2 q/(γ B) − 2 (w/B) N_q, mean over the stretch: the load carried less the overburden of the
    /// penetration, by Prandtl and Reissner's N_q at φ with ψ = φ, otherwise at Davis' angle, where it takes
    /// off less. Every point is w/B and 2 q/(γ B).
    ///
    /// # Errors
    /// If there is no factor N_q at this angle.
    pub(crate) fn weight_factor(&self, points: impl Iterator<Item = [f64; 2]>) -> Result<f64, VerifyError> {
        let [friction, dilation] = self.angles;
        let overburden = 2.0 * surcharge_factor(davis_friction_angle(friction, dilation)?)?;
        let [from, to] = self.stretch();
        let read = points.filter(|[w, _]| (from..=to).contains(w)).map(|[w, load]| load - overburden * w);
        let (sum, count) = read.fold((0.0, 0_u32), |(sum, count), factor| (sum + factor, count + 1));
        Ok(sum / f64::from(count))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_overburden_is_taken_off_the_mean_load() {
        let phi = 30_f64.to_radians();
        let footing = Footing { angles: [phi, phi], compliance: 1e-3, expected: 2.0 };
        let load = |w: f64| 2.5 + 2.0 * 18.401_12 * w;
        // The first and the last lie outside of the stretch.
        let points = [0.005, 0.007, 0.009, 0.011, 0.013].map(|w| [w, load(w)]);
        assert!((footing.weight_factor(points.into_iter()).unwrap() - 2.5).abs() < 1e-6);
        assert!(footing.weight_factor(std::iter::empty()).unwrap().is_nan());
    }
}
