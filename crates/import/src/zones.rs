//! The cells of a graded mesh as a fine zone with growing cells about it.

/// One axis of a mesh.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Zone {
    /// Where the cells are fine.
    pub(super) fine: [f64; 2],
    /// Width of its cells: their mean.
    pub(super) width: f64,
    /// Largest ratio of neighbours outside, 1 where there are none.
    pub(super) growth: f64,
}

/// Widths within this ratio of the smallest belong to the fine zone.
const ALIKE: f64 = 1.03;

/// The longest run of the finest cells between planes.
pub(super) fn zone(planes: &[f64]) -> Zone {
    let widths: Vec<f64> = planes.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let finest = widths.iter().copied().fold(f64::INFINITY, f64::min);
    let (mut best, mut start) = ([0, 0], 0);
    for end in 0..=widths.len() {
        if end < widths.len() && widths[end] <= ALIKE * finest {
            continue;
        }
        if end - start > best[1] - best[0] {
            best = [start, end];
        }
        start = end + 1;
    }
    let [low, high] = best;
    let ratio = |pair: &[f64]| (pair[0] / pair[1]).max(pair[1] / pair[0]);
    let outside = widths.windows(2).enumerate().filter(|(n, _)| *n < low || n + 1 >= high);
    let growth = outside.map(|(_, pair)| ratio(pair)).fold(1.0, f64::max);
    let count = (high - low).max(1) as f64;
    Zone { fine: [planes[low], planes[high]], width: (planes[high] - planes[low]) / count, growth }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fine_zone_is_found_in_a_graded_mesh() {
        let zone = zone(&[0.0, 4.0, 6.0, 7.0, 8.0, 9.0, 11.0]);
        assert_eq!(zone, Zone { fine: [6.0, 9.0], width: 1.0, growth: 2.0 });
        assert_eq!(super::zone(&[0.0, 1.0, 2.0]), Zone { fine: [0.0, 2.0], width: 1.0, growth: 1.0 });
    }
}
