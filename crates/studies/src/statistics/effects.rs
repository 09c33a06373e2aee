//! Main effects: the mean response at each level of a factor, over all other factors.

use super::StatisticsError;

/// Distinct values of a factor up to which each is a level of its own (chosen); more are put into bins.
const MOST_LEVELS: usize = 12;
/// Bins of a factor without levels, at most, and points in each, at least (chosen).
const BINS: usize = 8;
const POINTS_PER_BIN: usize = 4;

/// The mean response at a level of a factor, or in a bin of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LevelMean {
    /// The level; of a bin the mean of the factor in it. In the unit of the factor.
    pub level: f64,
    /// The mean of the response, in its unit.
    pub mean: f64,
    /// Standard error s/√n of the mean, in the unit of the response; `None` with a single point.
    pub error: Option<f64>,
    /// Number of points.
    pub points: usize,
}

/// The main effect of a factor on a response, by rising level. Factor and response have equal length, in any
/// units.
///
/// Each of up to twelve distinct values is a level. More are put into up to eight bins of equally many
/// points. Means are those of a balanced design: where factors are correlated, the effect of one contains
/// some of the other. Source: Box, Hunter & Hunter (2005), *Statistics for Experimenters*, chapter 5.
///
/// # Errors
/// [`StatisticsError`] for lists that do not agree, numbers that are not finite, and a factor that does not
/// vary.
pub fn main_effect(factor: &[f64], response: &[f64]) -> Result<Vec<LevelMean>, StatisticsError> {
    if factor.len() != response.len() {
        let (given, expected) = (response.len(), factor.len());
        return Err(StatisticsError::Shape { point: given.min(expected), given, expected });
    }
    let finite = |(x, y): (&f64, &f64)| x.is_finite() && y.is_finite();
    if let Some(point) = factor.iter().zip(response).position(|pair| !finite(pair)) {
        return Err(StatisticsError::NotFinite { point });
    }
    let mut pairs: Vec<[f64; 2]> = factor.iter().zip(response).map(|(x, y)| [*x, *y]).collect();
    pairs.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let levels: Vec<&[[f64; 2]]> = pairs.chunk_by(|a, b| a[0] == b[0]).collect();
    match levels.len() {
        0 | 1 => Err(StatisticsError::EqualInputs),
        2..=MOST_LEVELS => Ok(levels.into_iter().map(of).collect()),
        _ => {
            let bins = (pairs.len() / POINTS_PER_BIN).clamp(2, BINS);
            let edge = |bin: usize| bin * pairs.len() / bins;
            Ok((0..bins).map(|bin| of(&pairs[edge(bin)..edge(bin + 1)])).collect())
        }
    }
}

/// The mean of points of one level, none of them missing.
fn of(points: &[[f64; 2]]) -> LevelMean {
    let count = points.len() as f64;
    let mean_of = |k: usize| points.iter().map(|point| point[k]).sum::<f64>() / count;
    let mean = mean_of(1);
    let squares: f64 = points.iter().map(|[_, y]| (y - mean) * (y - mean)).sum();
    let error = (points.len() > 1).then(|| (squares / (count - 1.0) / count).sqrt());
    LevelMean { level: mean_of(0), mean, error, points: points.len() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_have_their_means_and_errors() {
        let factor = [2.0, 1.0, 2.0, 1.0, 3.0];
        let response = [5.0, 1.0, 7.0, 3.0, 9.0];
        let effect = main_effect(&factor, &response).unwrap();
        assert_eq!(
            effect.iter().map(|l| (l.level, l.mean)).collect::<Vec<_>>(),
            [(1.0, 2.0), (2.0, 6.0), (3.0, 9.0)]
        );
        assert!((effect[0].error.unwrap() - 1.0).abs() < 1e-15);
        assert_eq!((effect[2].error, effect[2].points), (None, 1));
    }

    #[test]
    fn many_values_are_put_into_bins_of_equally_many_points() {
        let factor: Vec<f64> = (0..50).map(f64::from).collect();
        let effect = main_effect(&factor, &factor).unwrap();
        assert_eq!((effect.len(), effect.iter().map(|l| l.points).sum::<usize>()), (8, 50));
        assert!(effect.iter().all(|l| l.level == l.mean && (6..=7).contains(&l.points)));
    }

    #[test]
    fn what_has_no_effect_is_refused() {
        assert_eq!(main_effect(&[1.0, 1.0], &[2.0, 3.0]), Err(StatisticsError::EqualInputs));
        assert!(main_effect(&[1.0], &[]).is_err() && main_effect(&[f64::NAN, 1.0], &[1.0, 1.0]).is_err());
    }
}
