//! Averages over blocks of a window, and how well they determine the mean.

use case::resolved::Output;

/// Number of blocks; eight leave seven degrees of freedom about their mean, and six about a straight line.
pub const BLOCKS: usize = 8;
/// Least number of samples in a block.
const MIN_SAMPLES: usize = Output::FEWEST_SAMPLES / BLOCKS;
/// 95 % quantile of Student's distribution with seven degrees of freedom: ± this many standard errors hold
/// the mean with a probability of 90 %.
pub const STUDENT_90: f64 = 1.895;

/// The samples of each block, in order, as ranges of `count` samples; `None` if there are too few. Samples
/// that do not fill a block are left out at the start.
fn blocks(count: usize) -> Option<[std::ops::Range<usize>; BLOCKS]> {
    let length = count / BLOCKS;
    let first = count - BLOCKS * length;
    (length >= MIN_SAMPLES).then(|| std::array::from_fn(|n| first + n * length..first + (n + 1) * length))
}

/// Averages of equally spaced `values` over [`BLOCKS`] blocks of one length; `None` if there are too few
/// values.
#[must_use]
pub fn block_averages(values: &[f64]) -> Option<[f64; BLOCKS]> {
    blocks(values.len()).map(|blocks| {
        blocks.map(|block| {
            let length = block.len() as f64;
            values[block].iter().sum::<f64>() / length
        })
    })
}

/// Standard error of the mean of the blocks, in their unit.
///
/// With the scatter s of n block averages about their mean and the correlation ρ of neighbouring ones (0 if
/// negative) it is s √((1 + ρ)/((1 − ρ) n)). Blocks are longer than the noise is correlated, so that their
/// scatter includes its correlation; ρ adds that of changes slower than a block, a drift among them.
///
/// Sources: Schmeiser (1982), Batch size effects in the analysis of simulation output, Operations Research
/// 30(3); Bayley and Hammersley (1946), The "effective" number of independent observations in an
/// autocorrelated time series, JRSS Supplement 8(2).
#[must_use]
pub fn standard_error(blocks: &[f64; BLOCKS]) -> f64 {
    let count = BLOCKS as f64;
    let mean = blocks.iter().sum::<f64>() / count;
    let squares: f64 = blocks.iter().map(|b| (b - mean).powi(2)).sum();
    if squares == 0.0 {
        return 0.0;
    }
    let products: f64 = blocks.windows(2).map(|pair| (pair[0] - mean) * (pair[1] - mean)).sum();
    let correlation = (products / squares).max(0.0);
    (squares / (count - 1.0) / count * (1.0 + correlation) / (1.0 - correlation)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers between −½ and ½ without correlation.
    fn noise(seed: u32) -> impl Iterator<Item = f64> {
        let mut state = seed;
        std::iter::repeat_with(move || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(state >> 8) / 2.0_f64.powi(24) - 0.5
        })
    }

    /// How often, of 400 windows, the mean is within ± the 90 % of the true one.
    fn coverage(series: impl Fn(u32) -> Vec<f64>) -> f64 {
        let hits = (0..400_u32).filter(|seed| {
            let blocks = block_averages(&series(977 * seed + 1)).unwrap();
            let mean = blocks.iter().sum::<f64>() / BLOCKS as f64;
            mean.abs() <= STUDENT_90 * standard_error(&blocks)
        });
        hits.count() as f64 / 400.0
    }

    #[test]
    fn the_interval_holds_the_mean_as_often_as_it_says() {
        let white = coverage(|seed| noise(seed).take(400).collect());
        assert!((0.86..0.96).contains(&white), "{white}");
        // Correlated over some twenty samples: blocks of fifty are almost independent.
        let red = coverage(|seed| {
            let mut value = 0.0;
            let step = |x: f64| {
                value = 0.9 * value + x;
                value
            };
            noise(seed).map(step).skip(200).take(400).collect()
        });
        assert!((0.84..0.97).contains(&red), "{red}");
    }

    #[test]
    fn a_drift_is_not_noise_that_averages_out() {
        let drift: Vec<f64> = (0..800).map(|n| f64::from(n) / 800.0).collect();
        let error = STUDENT_90 * standard_error(&block_averages(&drift).unwrap());
        assert!((0.3..0.5).contains(&error), "{error} of a change of 1 over the window");
    }

    #[test]
    fn constant_and_short_windows() {
        assert_eq!(standard_error(&block_averages(&[3.0; 100]).unwrap()), 0.0);
        assert_eq!(block_averages(&[1.0; 23]), None);
        assert_eq!(block_averages(&[1.0; 24]), Some([1.0; BLOCKS]));
    }
}
