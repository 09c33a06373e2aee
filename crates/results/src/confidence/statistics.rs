//! How far the mean over a window may be from that of a long run.

use crate::history::blocks::{BLOCKS, STUDENT_90, standard_error};

/// 95 % quantile of Student's distribution with six degrees of freedom, those of eight blocks about a
/// straight line.
const STUDENT_90_LINE: f64 = 1.943;

/// Half-width of the interval (90 %) of the mean of a body that is towed: a drift counts as what a longer tow
/// would change.
pub(super) fn of_tow(blocks: &[f64; BLOCKS]) -> f64 {
    STUDENT_90 * standard_error(blocks)
}

/// Half-width of the interval (90 %) of the mean of a body that is pressed, whose force may rise as it goes
/// deeper: the scatter about a straight line.
pub(super) fn of_press(blocks: &[f64; BLOCKS]) -> f64 {
    let count = BLOCKS as f64;
    let mean = blocks.iter().sum::<f64>() / count;
    let place = |n: usize| n as f64 - 0.5 * (count - 1.0);
    let squares: f64 = (0..BLOCKS).map(|n| place(n).powi(2)).sum();
    let slope = blocks.iter().enumerate().map(|(n, b)| place(n) * (b - mean)).sum::<f64>() / squares;
    let residual: f64 = blocks.iter().enumerate().map(|(n, b)| (b - mean - slope * place(n)).powi(2)).sum();
    STUDENT_90_LINE * (residual / (count - 2.0) / count).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_force_that_rises_evenly_is_no_noise_of_a_press() {
        let rising: [f64; BLOCKS] = std::array::from_fn(|n| 10.0 + n as f64);
        assert!(of_press(&rising) < 1e-12 && of_tow(&rising) > 1.0);
        let noisy: [f64; BLOCKS] = std::array::from_fn(|n| if n % 2 == 0 { 9.0 } else { 11.0 });
        assert!(of_press(&noisy) > 0.5 && of_press(&noisy) < 1.0);
    }
}
