//! Which rows of the grid each worker goes through.

use std::ops::Range;

/// How the rows of the grid are partitioned among the workers: contiguous runs, so that arrays can be split safely.
#[derive(Clone, Debug, PartialEq)]
pub struct RowPartition {
    /// First row of every worker, and the end.
    bounds: Vec<usize>,
    /// Fewest rows that a worker gets.
    least: usize,
    /// Entries per row.
    pub stride: usize,
}

impl RowPartition {
    /// Partitions rows `first..` with the given costs among `workers` so that each has about the same cost, and `least` rows or
    /// more.
    ///
    /// # Panics
    /// When there are too few rows for that.
    #[must_use]
    pub fn new(first: usize, cost: &[f64], [workers, least]: [usize; 2], stride: usize) -> Self {
        assert!(workers > 0 && workers * least <= cost.len(), "too few rows for {workers} workers");
        let mut partition = Self { bounds: vec![first; workers + 1], least, stride };
        partition.rebalance(cost, workers, |_| 1.0);
        partition
    }

    /// Rebalances, among at most as many workers as at first, so that workers of the given speeds take about the same time.
    pub fn rebalance(&mut self, cost: &[f64], workers: usize, speed: impl Fn(usize) -> f64) {
        let first = self.bounds[0];
        self.bounds.resize(workers + 1, first);
        let (total, all): (f64, f64) = (cost.iter().sum(), (0..workers).map(&speed).sum());
        let (mut row, mut sum, mut faster) = (0, 0.0, 0.0);
        for worker in 1..workers {
            faster += speed(worker - 1);
            let due = total * faster / all;
            // To the side of a row that is nearer.
            while row < cost.len() && sum + 0.5 * cost[row] < due {
                sum += cost[row];
                row += 1;
            }
            let [low, high] =
                [self.bounds[worker - 1] + self.least, first + cost.len() - (workers - worker) * self.least];
            self.bounds[worker] = (first + row).clamp(low, high);
        }
        self.bounds[workers] = first + cost.len();
    }

    /// Load of every worker, from the costs by which the rows were partitioned.
    pub fn loads<'a>(&'a self, cost: &'a [f64]) -> impl Iterator<Item = f64> + 'a {
        let first = self.bounds[0];
        self.ranges().map(move |rows| cost[rows.start - first..rows.end - first].iter().sum())
    }

    /// All rows.
    #[must_use]
    pub fn all(&self) -> Range<usize> {
        self.bounds[0]..self.bounds[self.bounds.len() - 1]
    }

    /// The rows of every worker.
    pub fn ranges(&self) -> impl ExactSizeIterator<Item = Range<usize>> + '_ {
        self.bounds.windows(2).map(|b| b[0]..b[1])
    }

    /// Splits an array into the workers' rows.
    pub fn split<'a, T>(&'a self, array: &'a mut [T]) -> impl Iterator<Item = &'a mut [T]> {
        self.split_by(self.stride, array)
    }

    /// The same for an array that has `stride` entries for each row.
    pub(crate) fn split_by<'a, T>(
        &'a self,
        stride: usize,
        array: &'a mut [T],
    ) -> impl Iterator<Item = &'a mut [T]> {
        let mut rest = &mut array[self.bounds[0] * stride..];
        self.ranges().map(move |range| {
            let (part, after) = std::mem::take(&mut rest).split_at_mut(range.len() * stride);
            rest = after;
            part
        })
    }
}

/// Throughput of a worker: cores differ, and other programs use some of them. Older measurements count less.
#[derive(Clone, Debug, Default)]
pub struct Throughput {
    /// What the worker has to do each time.
    load: f64,
    /// What it has done.
    done: f64,
    /// How long that took [s].
    seconds: f64,
}

impl Throughput {
    /// Fraction of the past that each rebalancing forgets.
    const FORGOTTEN: f64 = 0.3;

    /// Notes how long it took to do all once [s].
    pub fn note(&mut self, seconds: f64) {
        self.done += self.load;
        self.seconds += seconds;
    }

    /// Gives the worker something else to do.
    pub fn turn_to(&mut self, load: f64) {
        self.load = load;
        self.done *= 1.0 - Self::FORGOTTEN;
        self.seconds *= 1.0 - Self::FORGOTTEN;
    }

    /// What the worker has to do each time.
    #[must_use]
    pub fn load(&self) -> f64 {
        self.load
    }

    /// What is done in a second, if anything was done yet.
    #[must_use]
    pub fn speed(&self) -> Option<f64> {
        (self.done > 0.0 && self.seconds > 0.0).then(|| self.done / self.seconds)
    }
}

/// Serial fallback: whether the team is worth having. Where other programs use the cores, every phase of the team waits for the
/// scheduler to run all its threads, and one thread alone can be faster.
#[derive(Clone, Debug, Default)]
pub struct SerialFallback {
    /// How long the work took together [s].
    together: f64,
    /// How long it would have taken the caller alone [s].
    alone: f64,
    /// Number of rebalancings over the whole team.
    tried: u32,
    /// Number of rebalancings still to come with the caller alone.
    apart: u32,
}

impl SerialFallback {
    /// Rebalancings over the whole team before the fallback may be taken.
    const FIRST: u32 = 5;
    /// Rebalancings with the caller alone before the team is tried again.
    const APART: u32 = 32;

    /// Notes how long a piece of work took together, and how long it would have taken the caller alone [s].
    pub fn note(&mut self, together: f64, alone: f64) {
        self.together += together;
        self.alone += alone;
    }

    /// Whether the caller should work alone; asked at every rebalancing.
    pub fn is_left(&mut self) -> bool {
        if self.apart == 0 {
            self.tried = self.tried.saturating_add(1);
            if self.tried > Self::FIRST && self.together > self.alone {
                self.apart = Self::APART + 1;
            }
        }
        self.apart = self.apart.saturating_sub(1);
        // What was learnt counts for less from time to time, and for nothing when it was long ago.
        let kept = if self.apart > 0 { 0.0 } else { 1.0 - Throughput::FORGOTTEN };
        self.together *= kept;
        self.alone *= kept;
        self.apart > 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_dealt_out_by_cost_but_none_gets_too_few() {
        let ranges = |cost: &[f64], share| RowPartition::new(1, cost, share, 4).ranges().collect::<Vec<_>>();
        assert_eq!(ranges(&[1.0; 9], [2, 1]), [1..5, 5..10]);
        assert_eq!(ranges(&[0.0, 0.0, 2.0, 1.0, 1.0, 0.0], [2, 1]), [1..4, 4..7]);
        assert_eq!(ranges(&[9.0, 1.0, 1.0, 1.0, 1.0, 1.0], [3, 2]), [1..3, 3..5, 5..7]);
        assert_eq!(ranges(&[0.0; 6], [2, 3]), [1..4, 4..7]);
    }

    #[test]
    fn who_is_slower_gets_less() {
        let cost = [1.0; 12];
        let mut partition = RowPartition::new(0, &cost, [3, 1], 1);
        assert_eq!(partition.loads(&cost).collect::<Vec<_>>(), [4.0, 4.0, 4.0]);
        let mut throughput: [Throughput; 3] = Default::default();
        for (throughput, seconds) in throughput.iter_mut().zip([1.0, 2.0, 1.0]) {
            assert_eq!(throughput.speed(), None);
            throughput.turn_to(4.0);
            throughput.note(seconds);
        }
        partition.rebalance(&cost, 3, |worker| throughput[worker].speed().unwrap_or(1.0));
        assert_eq!(partition.ranges().collect::<Vec<_>>(), [0..5, 5..7, 7..12]);
        partition.rebalance(&cost, 1, |_| 1.0);
        assert_eq!((partition.ranges().len(), partition.all()), (1, 0..12));
    }

    #[test]
    fn company_that_does_not_pay_is_left_for_a_while() {
        let mut serial_fallback = SerialFallback::default();
        for _ in 0..SerialFallback::FIRST {
            serial_fallback.note(3.0, 1.7);
            assert!(!serial_fallback.is_left(), "it is too early to tell");
        }
        let alone = (0..1000).take_while(|_| serial_fallback.is_left()).count();
        assert_eq!(alone, SerialFallback::APART as usize);
        // Then it is given another chance.
        serial_fallback.note(1.0, 1.7);
        assert!(!serial_fallback.is_left());
    }
}
