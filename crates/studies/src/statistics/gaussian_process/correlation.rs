//! The correlation of two points: Matérn's of order 5/2, with a length for each factor.

/// Square root of five.
const ROOT: f64 = 2.236_067_977_499_79;

/// Lengths and nugget of a process.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Correlation {
    /// The inverse of the length of each factor, in scaled inputs.
    pub(super) inverse_lengths: Vec<f64>,
    /// The nugget λ: variance of the noise over that of the process.
    pub(super) nugget: f64,
}

impl Correlation {
    /// c = (1 + √5 r + 5/3 r²) exp(−√5 r), r² = Σ (Δ_k / ℓ_k)². Source: Rasmussen & Williams (2006), eq.
    /// (4.17).
    pub(super) fn between(&self, a: &[f64], b: &[f64]) -> f64 {
        let s = ROOT * self.squared(a, b).sqrt();
        (1.0 + s + s * s / 3.0) * (-s).exp()
    }

    /// The correlation and what all its derivatives share: ∂c/∂(ln ℓ_k) is the second number times (Δ_k /
    /// ℓ_k)².
    pub(super) fn with_slope(&self, a: &[f64], b: &[f64]) -> (f64, f64) {
        let s = ROOT * self.squared(a, b).sqrt();
        let decay = (-s).exp();
        ((1.0 + s + s * s / 3.0) * decay, 5.0 / 3.0 * (1.0 + s) * decay)
    }

    /// (Δ_k / ℓ_k)² of factor k.
    pub(super) fn part(&self, k: usize, a: &[f64], b: &[f64]) -> f64 {
        let difference = (a[k] - b[k]) * self.inverse_lengths[k];
        difference * difference
    }

    fn squared(&self, a: &[f64], b: &[f64]) -> f64 {
        let differences = a.iter().zip(b).zip(&self.inverse_lengths).map(|((a, b), l)| (a - b) * l);
        differences.map(|difference| difference * difference).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slopes_are_those_of_the_correlation() {
        let at = |logarithm: f64| Correlation { inverse_lengths: vec![(-logarithm).exp(), 2.0], nugget: 0.0 };
        let (a, b) = ([0.1, 0.9], [0.6, 0.3]);
        let step = 1e-6;
        let numeric = (at(0.3 + step).between(&a, &b) - at(0.3 - step).between(&a, &b)) / (2.0 * step);
        let (value, shared) = at(0.3).with_slope(&a, &b);
        assert_eq!(value, at(0.3).between(&a, &b));
        assert!((numeric - shared * at(0.3).part(0, &a, &b)).abs() < 1e-9);
        assert_eq!(at(0.3).between(&a, &a), 1.0);
    }
}
