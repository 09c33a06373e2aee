//! Curves of points: their rising part, and their values elsewhere.

/// Half of the width over which a history is averaged, over the distance of the points at which it is wanted
/// (chosen: neighbouring points then share no sample, and noise is reduced as a force gauge would).
const REACH: f64 = 0.125;
/// Least number of samples of an average; with fewer the value is interpolated.
const LEAST_SAMPLES: usize = 3;

/// The points whose abscissa lies beyond all before it: the loading of a curve that also unloads, in the
/// order of the abscissa.
#[must_use]
pub fn rising(x: &[f64], y: &[f64]) -> Vec<[f64; 2]> {
    rising_rows(x, y).into_iter().map(|row| [x[row], y[row]]).collect()
}

/// The rows of these points.
#[must_use]
pub fn rising_rows(x: &[f64], y: &[f64]) -> Vec<usize> {
    // A curve may run towards negative abscissae, as one of a locked to a rolling wheel does from 0 to −1.
    let falls = x.first().zip(x.last()).is_some_and(|(first, last)| last < first);
    let sign = if falls { -1.0 } else { 1.0 };
    let mut most = f64::NEG_INFINITY;
    let mut rows: Vec<usize> = (0..x.len().min(y.len()))
        .filter(|row| {
            let beyond = sign * x[*row] > most && y[*row].is_finite();
            most = if beyond { sign * x[*row] } else { most };
            beyond
        })
        .collect();
    if falls {
        rows.reverse();
    }
    rows
}

/// The values of a curve at some abscissae: means over an eighth of their distance to both sides, or, where
/// that holds fewer than three points, interpolated; `None` where the curve does not reach.
#[must_use]
pub fn local_means(points: &[[f64; 2]], at: &[f64]) -> Vec<Option<f64>> {
    let distance = |n: usize, m: usize| at.get(m).map(|other| (other - at[n]).abs()).filter(|d| *d > 0.0);
    let value = |n: usize| {
        let below = n.checked_sub(1).and_then(|m| distance(n, m));
        let near = [below, distance(n, n + 1)].into_iter().flatten().fold(f64::INFINITY, f64::min);
        local_mean(points, at[n], if near.is_finite() { REACH * near } else { 0.0 })
    };
    (0..at.len()).map(value).collect()
}

fn local_mean(points: &[[f64; 2]], x: f64, reach: f64) -> Option<f64> {
    let (first, last) = (points.first()?, points.last()?);
    let slack = reach.max(1e-9 * (last[0] - first[0]).abs());
    if x < first[0] - slack || x > last[0] + slack {
        return None;
    }
    let from = points.partition_point(|point| point[0] < x - reach);
    let to = points.partition_point(|point| point[0] <= x + reach);
    if to.saturating_sub(from) >= LEAST_SAMPLES {
        return Some(points[from..to].iter().map(|point| point[1]).sum::<f64>() / (to - from) as f64);
    }
    Some(interpolated(points, x))
}

/// The value at an abscissa, on the straight line between its neighbours; beyond the ends that of the end.
fn interpolated(points: &[[f64; 2]], x: f64) -> f64 {
    let after = points.partition_point(|point| point[0] < x);
    let Some(above) = points.get(after) else { return points.last().map_or(f64::NAN, |point| point[1]) };
    let Some(below) = after.checked_sub(1).map(|n| points[n]) else { return above[1] };
    below[1] + (above[1] - below[1]) * (x - below[0]) / (above[0] - below[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unloading_is_left_out() {
        let points = rising(&[0.0, 1.0, 0.5, 2.0, 2.0], &[0.0, 1.0, 9.0, 2.0, 3.0]);
        assert_eq!(points, [[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]]);
        assert_eq!(rising(&[0.0, -1.0], &[1.0, 2.0]), [[-1.0, 2.0], [0.0, 1.0]]);
    }

    #[test]
    fn histories_are_averaged_and_few_points_interpolated() {
        let history: Vec<[f64; 2]> = (0..=1000).map(|n| [f64::from(n), f64::from(n % 2)]).collect();
        let means = local_means(&history, &[200.0, 400.0, 600.0]);
        assert!(means.iter().all(|mean| (mean.unwrap() - 0.5).abs() < 0.02), "{means:?}");
        let few = [[0.0, 0.0], [10.0, 20.0]];
        assert_eq!(local_means(&few, &[2.0, 5.0, 11.0]), [Some(4.0), Some(10.0), None]);
        assert_eq!(local_means(&few, &[5.0]), [Some(10.0)]);
        assert_eq!(local_means(&[], &[5.0]), [None]);
    }
}
