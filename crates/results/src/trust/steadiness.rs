//! Whether a quantity is steady: the trend of its block averages.

use crate::history::blocks::{BLOCKS, block_averages};

/// The trend of the block averages of a quantity over a window.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trend {
    /// Mean of the block averages, in the unit of the quantity.
    pub mean: f64,
    /// Change over the window along the least-squares line, in the unit of the quantity.
    pub change: f64,
    /// Standard error of the change.
    pub error: f64,
}

impl Trend {
    /// The trend of equally spaced `values`; `None` if there are too few for [`BLOCKS`] averages.
    #[must_use]
    pub fn of(values: &[f64]) -> Option<Self> {
        let blocks = block_averages(values)?;
        let count = BLOCKS as f64;
        let mean = blocks.iter().sum::<f64>() / count;
        let abscissa = |n: usize| (n as f64 + 0.5) / count - 0.5;
        let squares: f64 = (0..BLOCKS).map(|n| abscissa(n).powi(2)).sum();
        let change = blocks.iter().enumerate().map(|(n, b)| abscissa(n) * (b - mean)).sum::<f64>() / squares;
        let residual: f64 =
            blocks.iter().enumerate().map(|(n, b)| (b - mean - change * abscissa(n)).powi(2)).sum();
        Some(Self { mean, change, error: (residual / (count - 2.0) / squares).sqrt() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_straight_line_is_its_own_trend() {
        let values: Vec<f64> = (0..800).map(|n| 10.0 + 2.0 * (f64::from(n) + 0.5) / 800.0).collect();
        let trend = Trend::of(&values).unwrap();
        assert!((trend.mean - 11.0).abs() < 1e-12 && (trend.change - 2.0).abs() < 1e-12);
        assert!(trend.error < 1e-12);
    }

    #[test]
    fn noise_has_no_trend_beyond_its_error() {
        let mut seed = 7_u32;
        let values: Vec<f64> = (0..8000)
            .map(|_| {
                seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                5.0 + f64::from(seed >> 8) / 2.0_f64.powi(24)
            })
            .collect();
        let trend = Trend::of(&values).unwrap();
        assert!(trend.change.abs() < 4.0 * trend.error, "{trend:?}");
        assert!(trend.error < 0.05);
    }

    #[test]
    fn too_few_samples_have_none() {
        assert_eq!(Trend::of(&[1.0; 23]), None);
        assert!(Trend::of(&[1.0; 24]).is_some());
    }
}
