//! Gauss–Legendre quadrature.

/// Abscissae of the 16-point Gauss–Legendre rule on (−1, 1), positive half (Abramowitz & Stegun 1964, table
/// 25.4).
const GAUSS_NODES: [f64; 8] = [
    0.095_012_509_837_637_44,
    0.281_603_550_779_258_9,
    0.458_016_777_657_227_4,
    0.617_876_244_402_643_7,
    0.755_404_408_355_003,
    0.865_631_202_387_831_7,
    0.944_575_023_073_232_6,
    0.989_400_934_991_649_9,
];
/// Weights that go with [`GAUSS_NODES`].
const GAUSS_WEIGHTS: [f64; 8] = [
    0.189_450_610_455_068_5,
    0.182_603_415_044_923_6,
    0.169_156_519_395_002_54,
    0.149_595_988_816_576_73,
    0.124_628_971_255_533_87,
    0.095_158_511_682_492_78,
    0.062_253_523_938_647_89,
    0.027_152_459_411_754_095,
];

/// Points and weights of the 16-point Gauss–Legendre rule on `[from, to]`, which is exact for polynomials up
/// to degree 31.
pub fn gauss_points(from: f64, to: f64) -> impl Iterator<Item = (f64, f64)> {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    GAUSS_NODES
        .into_iter()
        .zip(GAUSS_WEIGHTS)
        .flat_map(move |(x, w)| [(middle - half * x, half * w), (middle + half * x, half * w)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quadrature_is_exact_for_a_high_polynomial() {
        let sum: f64 = gauss_points(0.0, 1.0).map(|(x, w)| w * x.powi(20)).sum();
        assert!((sum - 1.0 / 21.0).abs() < 1e-14);
    }
}
