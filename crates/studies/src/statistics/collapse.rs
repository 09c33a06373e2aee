//! How well points fall onto one curve: their scatter about a running median.

use super::StatisticsError;
use numerics::quantile;

/// Fewest points (chosen), and neighbours on each side of a point at least.
const LEAST_POINTS: usize = 10;
const LEAST_NEIGHBOURS: usize = 2;
/// The window of the median on each side, as a portion of all points (chosen).
const WINDOW: usize = 20;

/// A running median and the scatter about it.
#[derive(Clone, Debug, PartialEq)]
pub struct Collapse {
    /// The median y over x: at each point that of its neighbours in x, itself included.
    pub median: Vec<[f64; 2]>,
    /// The deviation |y − m| / |m| within which half of the points lie [–].
    pub half_within: f64,
    /// The deviation within which nine in ten lie [–].
    pub most_within: f64,
    /// Number of points.
    pub points: usize,
}

/// The running median of points (x, y) in any units, over a tenth of the points. Points with the same x share
/// one median.
///
/// # Errors
/// [`StatisticsError`] for fewer than ten points, and numbers that are not finite.
pub fn collapse(points: &[[f64; 2]]) -> Result<Collapse, StatisticsError> {
    if points.len() < LEAST_POINTS {
        let given = points.len();
        return Err(StatisticsError::TooFewPoints { what: "a running median", least: LEAST_POINTS, given });
    }
    if let Some(point) = points.iter().position(|p| !(p[0].is_finite() && p[1].is_finite())) {
        return Err(StatisticsError::NotFinite { point });
    }
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let side = (sorted.len() / WINDOW).max(LEAST_NEIGHBOURS);
    let (mut line, mut deviations, mut first) = (Vec::new(), Vec::new(), 0);
    for place in sorted.chunk_by(|a, b| a[0] == b[0]) {
        let last = first + place.len();
        let window = &sorted[first.saturating_sub(side)..(last + side).min(sorted.len())];
        let middle = quantile(&window.iter().map(|p| p[1]).collect::<Vec<_>>(), 0.5);
        deviations.extend(place.iter().map(|p| deviation(p[1], middle)));
        line.push([place[0][0], middle]);
        first = last;
    }
    Ok(Collapse {
        median: line,
        half_within: quantile(&deviations, 0.5),
        most_within: quantile(&deviations, 0.9),
        points: sorted.len(),
    })
}

/// |y − m| / |m|, infinite where the median alone is zero.
fn deviation(y: f64, median: f64) -> f64 {
    if y == median { 0.0 } else { (y - median).abs() / median.abs() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_on_a_curve_scatter_little_and_others_much() {
        let on: Vec<[f64; 2]> = (1..=200).map(|n| f64::from(n) / 100.0).map(|x| [x, 1.0 + x * x]).collect();
        let tight = collapse(&on).unwrap();
        assert!(tight.half_within < 1e-12 && tight.most_within < 0.02, "{tight:?}");
        let off: Vec<[f64; 2]> =
            on.iter().enumerate().map(|(n, [x, y])| [*x, y * (0.8 + 0.2 * (n % 3) as f64)]).collect();
        assert!(collapse(&off).unwrap().most_within > 0.15);
        let same: Vec<[f64; 2]> = (0..20).map(|n| [f64::from(n / 10), f64::from(n % 10)]).collect();
        assert_eq!(collapse(&same).unwrap().median.len(), 2);
        assert!(collapse(&on[..5]).is_err());
    }
}
