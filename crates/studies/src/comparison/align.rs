//! Two curves on common abscissae: where both have values, with the zero of one moved if that is asked for.

use crate::sources::local_means;

/// Points of a common grid, where the reference has more.
const GRID: usize = 200;
/// Largest shift of a zero over the range that both curves share (chosen).
const SHIFT: f64 = 0.2;
/// Trials of a shift in each of the rounds, which narrow it down.
const TRIALS: i32 = 20;
const ROUNDS: usize = 4;

/// Values of two curves at common abscissae.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Aligned {
    /// The abscissae, of the reference [SI].
    pub at: Vec<f64>,
    /// Values of the reference at the abscissae.
    pub reference: Vec<f64>,
    /// Values of the other curve at the abscissae.
    pub other: Vec<f64>,
    /// Shift that was added to the abscissae of the other curve [SI]; 0 unless asked for.
    pub shift: f64,
}

/// Aligns a curve with a reference; both rise along the abscissa. `None` where they share fewer than two
/// points.
#[must_use]
pub fn aligned(reference: &[[f64; 2]], other: &[[f64; 2]], moves: bool) -> Option<Aligned> {
    let still = shifted(reference, other, 0.0)?;
    if !moves {
        return Some(still);
    }
    let range = still.at.last()? - still.at.first()?;
    let (mut best, mut step) = (still, SHIFT * range / f64::from(TRIALS));
    for _ in 0..ROUNDS {
        let middle = best.shift;
        for trial in -TRIALS..=TRIALS {
            let shift = middle + step * f64::from(trial);
            if shift.abs() > SHIFT * range {
                continue;
            }
            if let Some(tried) = shifted(reference, other, shift)
                && tried.mean_square() < best.mean_square()
            {
                best = tried;
            }
        }
        step *= 1.5 / f64::from(TRIALS);
    }
    Some(best)
}

fn shifted(reference: &[[f64; 2]], other: &[[f64; 2]], shift: f64) -> Option<Aligned> {
    let moved: Vec<[f64; 2]> = other.iter().map(|[x, y]| [x + shift, *y]).collect();
    let low = reference.first()?[0].max(moved.first()?[0]);
    let high = reference.last()?[0].min(moved.last()?[0]);
    let own: Vec<f64> = reference.iter().map(|p| p[0]).filter(|x| (low..=high).contains(x)).collect();
    let at = if own.len() > GRID {
        (0..GRID).map(|n| low + (high - low) * n as f64 / (GRID - 1) as f64).collect()
    } else {
        own
    };
    let (known, found) = (local_means(reference, &at), local_means(&moved, &at));
    let mut result = Aligned { shift, ..Aligned::default() };
    for ((x, known), found) in at.iter().zip(known).zip(found) {
        if let (Some(known), Some(found)) = (known, found) {
            result.at.push(*x);
            result.reference.push(known);
            result.other.push(found);
        }
    }
    (result.at.len() >= 2).then_some(result)
}

impl Aligned {
    /// The mean of the squared differences.
    #[must_use]
    pub fn mean_square(&self) -> f64 {
        let squares = self.reference.iter().zip(&self.other).map(|(r, o)| (o - r).powi(2));
        squares.sum::<f64>() / self.at.len() as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(points: i32, from: f64, to: f64, value: impl Fn(f64) -> f64) -> Vec<[f64; 2]> {
        let x = |n: i32| from + (to - from) * f64::from(n) / f64::from(points - 1);
        (0..points).map(|n| [x(n), value(x(n))]).collect()
    }

    #[test]
    fn curves_are_compared_where_both_are() {
        let reference = curve(11, 0.0, 1.0, |x| 2.0 * x);
        let other = curve(500, 0.35, 2.0, |x| 2.0 * x + 1.0);
        let found = aligned(&reference, &other, false).unwrap();
        assert_eq!(found.at.len(), 7);
        // Means about a place are those of the points that lie there, which are not quite symmetric about it.
        assert!((found.mean_square() - 1.0).abs() < 1e-3, "{}", found.mean_square());
        assert!(aligned(&reference, &curve(5, 2.0, 3.0, |x| x), false).is_none());
    }

    #[test]
    fn a_zero_that_is_off_is_found() {
        let reference = curve(60, 0.0, 0.02, |x| 1e5 * x * x);
        let other = curve(400, 0.0, 0.03, |x| 1e5 * (x - 0.002).max(0.0).powi(2));
        let found = aligned(&reference, &other, true).unwrap();
        assert!((found.shift + 0.002).abs() < 2e-5, "{}", found.shift);
    }
}
