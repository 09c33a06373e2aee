//! Distribution of the grid's rows among the threads.

use std::ops::Range;

/// Partition of the rows of the grid into portions: contiguous runs, so that arrays can be split safely.
#[derive(Clone, Debug, PartialEq)]
pub struct RowPartition {
    /// First row of each portion, and the end.
    bounds: Vec<usize>,
    /// Minimum number of rows per portion.
    least: usize,
    /// Array entries per row.
    pub stride: usize,
}

impl RowPartition {
    /// Partitions rows `first..` with the given costs into `portions` so that each has about the same cost,
    /// and at least `least` rows.
    ///
    /// # Panics
    /// If there are too few rows.
    #[must_use]
    pub fn new(first: usize, cost: &[f64], [portions, least]: [usize; 2], stride: usize) -> Self {
        assert!(portions > 0 && portions * least <= cost.len(), "too few rows for {portions} portions");
        let mut partition = Self { bounds: vec![first; portions + 1], least, stride };
        partition.rebalance(cost, portions, |_| 1.0);
        partition
    }

    /// Rebalances into `portions` with costs in proportion to the given shares.
    pub fn rebalance(&mut self, cost: &[f64], portions: usize, share: impl Fn(usize) -> f64) {
        self.bounds.resize(portions + 1, 0);
        self.cut(cost, 0..portions, share);
    }

    /// Rebalances into portions of the first so many rows, and others of the rest. Returns whether there are
    /// rows enough; if not, all is as before.
    pub fn rebalance_apart(
        &mut self,
        cost: &[f64],
        first: usize,
        portions: [usize; 2],
        share: impl Fn(usize) -> f64,
    ) -> bool {
        let [of_first, of_rest] = portions;
        if first < of_first * self.least || cost.len() < first + of_rest * self.least {
            return false;
        }
        self.bounds.resize(of_first + of_rest + 1, 0);
        self.cut(&cost[..first], 0..of_first, &share);
        self.cut(&cost[first..], of_first..of_first + of_rest, &share);
        true
    }

    /// Cuts rows of these costs into some of the portions, the first of which begins where it does.
    fn cut(&mut self, cost: &[f64], portions: Range<usize>, share: impl Fn(usize) -> f64) {
        let first = self.bounds[portions.start];
        let (total, all): (f64, f64) = (cost.iter().sum(), portions.clone().map(&share).sum());
        let (mut row, mut sum, mut shares) = (0, 0.0, 0.0);
        for portion in portions.start + 1..portions.end {
            shares += share(portion - 1);
            let due = total * shares / all;
            // Round to the nearer end of a row.
            while row < cost.len() && sum + 0.5 * cost[row] < due {
                sum += cost[row];
                row += 1;
            }
            let [low, high] = [
                self.bounds[portion - 1] + self.least,
                first + cost.len() - (portions.end - portion) * self.least,
            ];
            self.bounds[portion] = (first + row).clamp(low, high);
        }
        self.bounds[portions.end] = first + cost.len();
    }

    /// Load of each portion, from the costs by which the rows were partitioned.
    pub fn loads<'a>(&'a self, cost: &'a [f64]) -> impl Iterator<Item = f64> + 'a {
        let first = self.bounds[0];
        self.ranges().map(move |rows| cost[rows.start - first..rows.end - first].iter().sum())
    }

    /// All rows.
    #[must_use]
    pub fn all(&self) -> Range<usize> {
        self.bounds[0]..self.bounds[self.bounds.len() - 1]
    }

    /// The rows of each portion.
    pub fn ranges(&self) -> impl ExactSizeIterator<Item = Range<usize>> + '_ {
        self.bounds.windows(2).map(|b| b[0]..b[1])
    }

    /// Splits an array into the rows of the portions.
    pub fn split<'a, T>(&'a self, array: &'a mut [T]) -> impl Iterator<Item = &'a mut [T]> {
        self.split_by(if array.is_empty() { 0 } else { self.stride }, array)
    }

    /// The portions of an array that has `stride` entries for each row.
    pub(crate) fn split_by<'a, T>(
        &'a self,
        stride: usize,
        array: &'a mut [T],
    ) -> impl Iterator<Item = &'a mut [T]> {
        let mut rest = &mut array[self.bounds[0] * stride..];
        self.ranges().map(move |range| {
            let (own, after) = std::mem::take(&mut rest).split_at_mut(range.len() * stride);
            rest = after;
            own
        })
    }
}

/// Measured throughput of a worker: cores differ, and other programs use some of them. Older measurements
/// count less.
#[derive(Clone, Debug, Default)]
pub struct Throughput {
    /// Load of the worker per step.
    load: f64,
    /// Load completed.
    done: f64,
    /// Time taken for the load completed [s].
    seconds: f64,
}

impl Throughput {
    /// Fraction of the past discounted at each rebalancing.
    const FORGOTTEN: f64 = 0.3;

    /// Records the time in which the load was completed once [s].
    pub fn record(&mut self, seconds: f64) {
        self.done += self.load;
        self.seconds += seconds;
    }

    /// Assigns a new load to the worker.
    pub fn assign(&mut self, load: f64) {
        self.load = load;
        self.done *= 1.0 - Self::FORGOTTEN;
        self.seconds *= 1.0 - Self::FORGOTTEN;
    }

    /// Load of the worker per step.
    #[must_use]
    pub fn load(&self) -> f64 {
        self.load
    }

    /// Load completed per second; `None` before the first measurement.
    #[must_use]
    pub fn speed(&self) -> Option<f64> {
        (self.done > 0.0 && self.seconds > 0.0).then(|| self.done / self.seconds)
    }
}

/// Serial fallback. Where other programs use the cores, every parallel phase waits until the scheduler has
/// run all threads, and one thread alone can be faster.
#[derive(Clone, Debug, Default)]
pub struct SerialFallback {
    /// Time taken by the team [s].
    together: f64,
    /// Estimated time of the calling thread alone for the same work [s].
    alone: f64,
    /// Number of rebalancings with the whole team.
    tried: u32,
    /// Number of rebalancings left with the calling thread alone.
    remaining: u32,
}

impl SerialFallback {
    /// Rebalancings with the whole team before the fallback may be used.
    const FIRST: u32 = 5;
    /// Rebalancings with the calling thread alone before the team is tried again.
    const DURATION: u32 = 32;

    /// Records the time that the team took for some work, and the estimate for the calling thread alone [s].
    pub fn record(&mut self, together: f64, alone: f64) {
        self.together += together;
        self.alone += alone;
    }

    /// Whether the calling thread should work alone until the next rebalancing; called once at each.
    pub fn should_run_alone(&mut self) -> bool {
        if self.remaining == 0 {
            self.tried = self.tried.saturating_add(1);
            if self.tried > Self::FIRST && self.together > self.alone {
                self.remaining = Self::DURATION + 1;
            }
        }
        self.remaining = self.remaining.saturating_sub(1);
        // Old measurements count less; those from before a serial phase do not count at all.
        let kept = if self.remaining > 0 { 0.0 } else { 1.0 - Throughput::FORGOTTEN };
        self.together *= kept;
        self.alone *= kept;
        self.remaining > 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_partitioned_by_cost_with_a_minimum_each() {
        let ranges =
            |cost: &[f64], workers| RowPartition::new(1, cost, workers, 4).ranges().collect::<Vec<_>>();
        assert_eq!(ranges(&[1.0; 9], [2, 1]), [1..5, 5..10]);
        assert_eq!(ranges(&[0.0, 0.0, 2.0, 1.0, 1.0, 0.0], [2, 1]), [1..4, 4..7]);
        assert_eq!(ranges(&[9.0, 1.0, 1.0, 1.0, 1.0, 1.0], [3, 2]), [1..3, 3..5, 5..7]);
        assert_eq!(ranges(&[0.0; 6], [2, 3]), [1..4, 4..7]);
    }

    #[test]
    fn slower_workers_get_fewer_rows() {
        let cost = [1.0; 12];
        let mut partition = RowPartition::new(0, &cost, [3, 1], 1);
        assert_eq!(partition.loads(&cost).collect::<Vec<_>>(), [4.0, 4.0, 4.0]);
        let mut throughput: [Throughput; 3] = Default::default();
        for (throughput, seconds) in throughput.iter_mut().zip([1.0, 2.0, 1.0]) {
            assert_eq!(throughput.speed(), None);
            throughput.assign(4.0);
            throughput.record(seconds);
        }
        partition.rebalance(&cost, 3, |worker| throughput[worker].speed().unwrap_or(1.0));
        assert_eq!(partition.ranges().collect::<Vec<_>>(), [0..5, 5..7, 7..12]);
        partition.rebalance(&cost, 1, |_| 1.0);
        assert_eq!((partition.ranges().len(), partition.all()), (1, 0..12));
        assert!(partition.rebalance_apart(&cost, 4, [1, 2], |_| 1.0));
        assert_eq!(partition.ranges().collect::<Vec<_>>(), [0..4, 4..8, 8..12]);
        assert!(!partition.rebalance_apart(&cost, 11, [1, 2], |_| 1.0), "too few rows");
        assert_eq!(partition.ranges().len(), 3);
    }

    #[test]
    fn the_fallback_is_used_for_a_while_where_the_team_is_slower() {
        let mut serial_fallback = SerialFallback::default();
        for _ in 0..SerialFallback::FIRST {
            serial_fallback.record(3.0, 1.7);
            assert!(!serial_fallback.should_run_alone(), "too early to decide");
        }
        let alone = (0..1000).take_while(|_| serial_fallback.should_run_alone()).count();
        assert_eq!(alone, SerialFallback::DURATION as usize);
        // Then the team is tried again.
        serial_fallback.record(1.0, 1.7);
        assert!(!serial_fallback.should_run_alone());
    }
}
