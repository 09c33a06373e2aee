//! A displacement over time that a motion follows, between given points.

use serde::{Deserialize, Serialize};

/// A displacement over time: cubic between given points, with a speed that does not jump. At rest before the
/// first point; after the last one the speed stays what it is there.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Course {
    /// Times [s], rising.
    times: Vec<f64>,
    /// Displacement at each of the times [m or rad].
    displacements: Vec<f64>,
    /// Speed at each of the times [m/s or rad/s].
    speeds: Vec<f64>,
}

impl Course {
    /// Through displacements [m or rad] at rising times [s]: it rises and falls with them and nowhere else
    /// (Fritsch and Carlson 1980, with the weighted harmonic mean of Fritsch and Butland 1984), from rest to
    /// rest. `None` for fewer than two points, times that do not rise, and what is not finite.
    #[must_use]
    pub fn through(times: Vec<f64>, displacements: Vec<f64>) -> Option<Self> {
        if !is_table(&times, &displacements) {
            return None;
        }
        let slope = |n: usize| (displacements[n + 1] - displacements[n]) / (times[n + 1] - times[n]);
        let mut speeds = vec![0.0; times.len()];
        for n in 1..times.len() - 1 {
            let (before, after) = (slope(n - 1), slope(n));
            if before * after > 0.0 {
                let (earlier, later) = (times[n] - times[n - 1], times[n + 1] - times[n]);
                let (a, b) = (2.0 * later + earlier, later + 2.0 * earlier);
                speeds[n] = (a + b) / (a / before + b / after);
            }
        }
        Some(Self { times, displacements, speeds })
    }

    /// A course with speeds [m/s or rad/s] at rising times [s], linear between them. `None` as for
    /// [`Course::through`].
    #[must_use]
    pub fn with_speeds(times: Vec<f64>, speeds: Vec<f64>) -> Option<Self> {
        if !is_table(&times, &speeds) {
            return None;
        }
        let mut displacements = vec![0.0; times.len()];
        for n in 1..times.len() {
            displacements[n] =
                displacements[n - 1] + 0.5 * (speeds[n - 1] + speeds[n]) * (times[n] - times[n - 1]);
        }
        Some(Self { times, displacements, speeds })
    }

    /// The course, later by a time [s].
    #[must_use]
    pub fn later(&self, by: f64) -> Self {
        Self { times: self.times.iter().map(|time| time + by).collect(), ..self.clone() }
    }

    /// Times of the first and the last point of the course [s].
    #[must_use]
    pub fn span(&self) -> [f64; 2] {
        [self.times[0], self.times[self.times.len() - 1]]
    }

    /// The numbers of which the course consists: times, displacements and speeds.
    pub fn numbers(&self) -> impl Iterator<Item = f64> {
        self.times.iter().chain(&self.displacements).chain(&self.speeds).copied()
    }

    /// Displacement at a time [s] since the first point, in [m or rad].
    #[must_use]
    pub fn displacement(&self, time: f64) -> f64 {
        let last = self.times.len() - 1;
        match self.piece(time) {
            None if time < self.times[0] => 0.0,
            None => {
                let since = time - self.times[last];
                self.displacements[last] - self.displacements[0] + self.speeds[last] * since
            }
            Some((n, width, x)) => {
                let rise = self.displacements[n + 1] - self.displacements[n];
                let (from, to) = (width * self.speeds[n], width * self.speeds[n + 1]);
                let inside = x * (from + x * (3.0 * rise - 2.0 * from - to + x * (from + to - 2.0 * rise)));
                self.displacements[n] - self.displacements[0] + inside
            }
        }
    }

    /// Speed at a time [s], in [m/s or rad/s].
    #[must_use]
    pub fn speed(&self, time: f64) -> f64 {
        match self.piece(time) {
            None if time < self.times[0] => 0.0,
            None => self.speeds[self.times.len() - 1],
            Some((n, width, x)) => {
                let slope = (self.displacements[n + 1] - self.displacements[n]) / width;
                let (from, to) = (self.speeds[n], self.speeds[n + 1]);
                from + x * (2.0 * (3.0 * slope - 2.0 * from - to) + 3.0 * x * (from + to - 2.0 * slope))
            }
        }
    }

    /// Times at which the course passes its points or turns round, until a time and with it [s], rising.
    #[must_use]
    pub fn moments(&self, until: f64) -> Vec<f64> {
        // Between two points it turns round only where speeds were given, which are linear there.
        let turn = |n: usize| {
            let (from, to) = (self.speeds[n], self.speeds[n + 1]);
            let share = if from * to < 0.0 { from / (from - to) } else { 0.0 };
            self.times[n] + share * (self.times[n + 1] - self.times[n])
        };
        let inside = self.times.iter().copied().chain((0..self.times.len() - 1).map(turn));
        let mut all: Vec<f64> = inside.filter(|time| *time < until).chain([until]).collect();
        all.sort_by(f64::total_cmp);
        all
    }

    /// Least and largest displacement until a time [s], in [m or rad].
    #[must_use]
    pub fn extremes(&self, until: f64) -> [f64; 2] {
        let all = self.moments(until).into_iter().map(|time| self.displacement(time));
        all.fold([0.0, 0.0], |[low, high], d| [low.min(d), high.max(d)])
    }

    /// When the course begins to move [s]: its last point at rest, or its first.
    #[must_use]
    pub fn begins(&self) -> f64 {
        let moves =
            |n: &usize| self.displacements[n + 1] != self.displacements[*n] || self.speeds[n + 1] != 0.0;
        self.times[(0..self.times.len() - 1).find(moves).unwrap_or(0)]
    }

    /// Largest speed, without its sign [m/s or rad/s].
    #[must_use]
    pub fn fastest(&self) -> f64 {
        let middles = self.times.windows(2).map(|pair| self.speed(0.5 * (pair[0] + pair[1])).abs());
        self.speeds.iter().map(|speed| speed.abs()).chain(middles).fold(0.0, f64::max)
    }

    /// Whether there are as many of everything and times do not fall; of one that was read they may.
    pub(crate) fn is_sound(&self) -> bool {
        let count = self.times.len();
        count >= 2 && [self.displacements.len(), self.speeds.len()] == [count; 2] && self.times.is_sorted()
    }

    /// The piece at a time: the number of its first point, its duration [s], and where in it the time is, 0
    /// to 1.
    fn piece(&self, time: f64) -> Option<(usize, f64, f64)> {
        let after = self.times.partition_point(|point| *point <= time);
        if after == 0 || after == self.times.len() {
            return None;
        }
        let width = self.times[after] - self.times[after - 1];
        Some((after - 1, width, (time - self.times[after - 1]) / width))
    }
}

/// Whether there are two points or more, all numbers are finite, and the times rise.
fn is_table(times: &[f64], values: &[f64]) -> bool {
    times.len() >= 2
        && times.len() == values.len()
        && times.iter().chain(values).all(|number| number.is_finite())
        && times.windows(2).all(|pair| pair[0] < pair[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_points_are_a_smooth_step() {
        let course = Course::through(vec![1.0, 3.0], vec![0.0, 0.4]).unwrap();
        for (time, displacement, speed) in
            [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (2.0, 0.2, 0.3), (3.0, 0.4, 0.0), (9.0, 0.4, 0.0)]
        {
            assert!((course.displacement(time) - displacement).abs() < 1e-15, "{time}");
            assert!((course.speed(time) - speed).abs() < 1e-15, "{time}");
        }
    }

    #[test]
    fn it_passes_its_points_and_does_not_overshoot() {
        let (times, points) = (vec![0.0, 1.0, 1.5, 4.0, 5.0], vec![0.0, 0.1, 0.3, 0.3, -0.2]);
        let course = Course::through(times.clone(), points.clone()).unwrap();
        for (time, point) in times.iter().zip(&points) {
            assert!((course.displacement(*time) - point).abs() < 1e-15);
        }
        let all: Vec<f64> = (0..=500).map(|n| course.displacement(0.01 * f64::from(n))).collect();
        assert!(all.iter().all(|d| (-0.2..=0.3 + 1e-15).contains(d)));
        assert!((course.extremes(9.0)[0] + 0.2).abs() < 1e-15);
    }

    #[test]
    fn the_speed_is_the_derivative_and_that_of_the_table() {
        let course = Course::with_speeds(vec![0.0, 1.0, 3.0], vec![0.0, 0.2, -0.2]).unwrap();
        for time in [0.3, 0.99, 1.7, 2.5, 3.5] {
            let rate = (course.displacement(time + 1e-5) - course.displacement(time - 1e-5)) / 2e-5;
            assert!((course.speed(time) - rate).abs() < 1e-9, "{time}");
        }
        for (time, speed) in [(0.5, 0.1), (1.0, 0.2), (2.0, 0.0), (4.0, -0.2)] {
            assert!((course.speed(time) - speed).abs() < 1e-15, "{time}");
        }
        assert!((course.displacement(3.0) - 0.1).abs() < 1e-15);
        assert!((course.fastest() - 0.2).abs() < 1e-15);
        // It turns round after a third of the way down: 0.1 m up, and as much from there.
        let uneven = Course::with_speeds(vec![0.0, 1.0, 4.0], vec![0.0, 0.2, -0.4]).unwrap();
        let [low, high] = uneven.extremes(4.0);
        assert!((high - 0.2).abs() < 1e-15 && (low + 0.2).abs() < 1e-15, "{low} {high}");
        assert_eq!(course.later(2.0).displacement(5.0), course.displacement(3.0));
    }

    #[test]
    fn what_is_no_table_is_refused() {
        assert_eq!(Course::through(vec![0.0], vec![0.0]), None);
        assert_eq!(Course::through(vec![0.0, 0.0], vec![0.0, 1.0]), None);
        assert_eq!(Course::with_speeds(vec![0.0, 1.0], vec![0.0, f64::NAN]), None);
    }
}
