//! Random numbers, the same for the same seed on every machine.

use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::Rng;

/// A stream of random numbers: PCG XSL 128/64 (O'Neill 2014).
#[derive(Clone, Debug)]
pub struct Draws(Pcg64Mcg);

impl Draws {
    /// The stream of a seed; `purpose`, any constant, keeps streams of equal seeds apart.
    #[must_use]
    pub fn new(seed: u64, purpose: u64) -> Self {
        // The seed is spread over both halves of the state: those of neighbouring seeds would start alike.
        let spread = u128::from(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15)) << 64 | u128::from(seed);
        Self(Pcg64Mcg::new(spread ^ u128::from(purpose)))
    }

    /// A number in [0, 1), of 53 random bits.
    pub fn uniform(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A whole number below `end`.
    pub fn below(&mut self, end: usize) -> usize {
        // The high half of the product is uniform but for a part in 2⁶⁴ / end.
        ((u128::from(self.0.next_u64()) * end as u128) >> 64) as usize
    }

    /// A number from the standard normal distribution. Source: Box & Muller (1958).
    pub fn normal(&mut self) -> f64 {
        let radius = (-2.0 * (1.0 - self.uniform()).ln()).sqrt();
        radius * (std::f64::consts::TAU * self.uniform()).cos()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments_are_those_of_the_distributions() {
        let mut draws = Draws::new(3, 0);
        let sample: Vec<f64> = (0..20_000).map(|_| draws.normal()).collect();
        let mean = sample.iter().sum::<f64>() / 20_000.0;
        let square = sample.iter().map(|x| x * x).sum::<f64>() / 20_000.0;
        assert!(mean.abs() < 0.03 && (square - 1.0).abs() < 0.05, "{mean} {square}");
        let uniform = (0..20_000).map(|_| draws.uniform()).sum::<f64>() / 20_000.0;
        assert!((uniform - 0.5).abs() < 0.01);
        assert_eq!(Draws::new(9, 0).uniform(), Draws::new(9, 0).uniform());
        assert_ne!(Draws::new(9, 0).uniform(), Draws::new(10, 0).uniform());
    }
}
