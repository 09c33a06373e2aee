//! Probability distributions and their quantiles.

/// The distribution of a number that is not known exactly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Distribution {
    /// Uniform between two values.
    Uniform {
        /// Smallest value.
        low: f64,
        /// Largest value.
        high: f64,
    },
    /// Normal, truncated at three standard deviations.
    Normal {
        /// Mean.
        mean: f64,
        /// Standard deviation.
        deviation: f64,
    },
    /// Log-normal, truncated at three standard deviations; for quantities that cannot be negative.
    LogNormal {
        /// Median.
        median: f64,
        /// Standard deviation of the natural logarithm.
        log_deviation: f64,
    },
}

/// Probability below −3 standard deviations.
const TAIL: f64 = 0.001_349_898_031_630_094_6;

impl Distribution {
    /// The quantile of the probability `p` (0 to 1).
    #[must_use]
    pub fn quantile(&self, p: f64) -> f64 {
        let normal = || inverse_normal(TAIL + (1.0 - 2.0 * TAIL) * p);
        match *self {
            Self::Uniform { low, high } => low + p * (high - low),
            Self::Normal { mean, deviation } => mean + deviation * normal(),
            Self::LogNormal { median, log_deviation } => median * (log_deviation * normal()).exp(),
        }
    }
}

/// The 95 % quantile of the standard normal distribution.
pub const NORMAL_95: f64 = 1.644_853_627;

/// The 95 % quantile of Student's distribution with `freedom` degrees of freedom, by the first terms of its
/// expansion: within 2 % from three degrees on. Source: Abramowitz & Stegun (1972), 26.7.5.
#[must_use]
pub fn student_95(freedom: f64) -> f64 {
    let (z, z3) = (NORMAL_95, NORMAL_95.powi(3));
    let first = (z3 + z) / (4.0 * freedom);
    let second = (5.0 * NORMAL_95.powi(5) + 16.0 * z3 + 3.0 * z) / (96.0 * freedom * freedom);
    z + first + second
}

/// Quantile of the standard normal distribution, 0 < p < 1, relative error 1.2e-9.
///
/// Rational approximation of Acklam (2003, unpublished) (coefficients compared with public copies, such as
/// YesDrX/randgen).
fn inverse_normal(p: f64) -> f64 {
    const A: [f64; 6] = [
        -3.969_683_028_665_376e1,
        2.209_460_984_245_205e2,
        -2.759_285_104_469_687e2,
        1.383_577_518_672_69e2,
        -3.066_479_806_614_716e1,
        2.506_628_277_459_239,
    ];
    const B: [f64; 6] = [
        -5.447_609_879_822_406e1,
        1.615_858_368_580_409e2,
        -1.556_989_798_598_866e2,
        6.680_131_188_771_972e1,
        -1.328_068_155_288_572e1,
        1.0,
    ];
    const C: [f64; 6] = [
        -7.784_894_002_430_293e-3,
        -3.223_964_580_411_365e-1,
        -2.400_758_277_161_838,
        -2.549_732_539_343_734,
        4.374_664_141_464_968,
        2.938_163_982_698_783,
    ];
    const D: [f64; 5] = [
        7.784_695_709_041_462e-3,
        3.224_671_290_700_398e-1,
        2.445_134_137_142_996,
        3.754_408_661_907_416,
        1.0,
    ];
    let polynomial = |row: &[f64], x: f64| row.iter().fold(0.0, |sum, c| sum * x + c);
    if p > 0.5 {
        return -inverse_normal(1.0 - p);
    }
    if p < 0.024_25 {
        let q = (-2.0 * p.ln()).sqrt();
        return polynomial(&C, q) / polynomial(&D, q);
    }
    let q = p - 0.5;
    q * polynomial(&A, q * q) / polynomial(&B, q * q)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn student_is_that_of_the_tables() {
        for (freedom, known) in [(3.0, 2.353), (7.0, 1.895), (30.0, 1.697)] {
            assert!((student_95(freedom) / known - 1.0).abs() < 0.02, "{freedom}: {}", student_95(freedom));
        }
    }

    #[test]
    fn normal_quantiles_are_right() {
        let table = [
            (0.5, 0.0),
            (0.841_344_746_068_543, 1.0),
            (0.975, 1.959_963_984_540_054),
            (0.001, -3.090_232_306_167_813),
            (0.01, -2.326_347_874_040_841),
        ];
        for (p, x) in table {
            assert!((inverse_normal(p) - x).abs() < 2e-8, "{p}: {}", inverse_normal(p));
        }
        assert!((inverse_normal(0.024_249_999) - inverse_normal(0.024_250_001)).abs() < 1e-6);
    }
}
