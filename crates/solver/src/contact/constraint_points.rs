//! Which contact points belong to which constraint, until the next contact search.

/// The contact points of each constraint, by its number.
#[derive(Debug, Default)]
pub(crate) struct ConstraintPoints {
    /// Number of the constraint of each contact point.
    pub(super) number: Vec<usize>,
    /// Where the points of each constraint begin among `points`, and where the last end.
    start: Vec<usize>,
    points: Vec<u32>,
}

impl ConstraintPoints {
    /// The points of all constraints, from the number of the constraint of each contact point.
    pub(super) fn new(number: Vec<usize>) -> Self {
        let Some(last) = number.iter().max() else { return Self::default() };
        let constraints = last + 1;
        let mut start = vec![0; constraints + 1];
        number.iter().for_each(|n| start[n + 1] += 1);
        (0..constraints).for_each(|n| start[n + 1] += start[n]);
        let (mut next, mut points) = (start.clone(), vec![0; number.len()]);
        for (point, n) in number.iter().enumerate() {
            points[next[*n]] = point as u32;
            next[*n] += 1;
        }
        Self { number, start, points }
    }

    /// Number of constraints.
    pub(super) fn len(&self) -> usize {
        self.start.len().saturating_sub(1)
    }

    /// The contact points of a constraint, in order.
    pub(super) fn of(&self, constraint: usize) -> impl Iterator<Item = usize> + '_ {
        self.points[self.start[constraint]..self.start[constraint + 1]].iter().map(|point| *point as usize)
    }

    /// Memory in use [bytes].
    pub(super) fn memory(&self) -> usize {
        size_of_val(self.number.as_slice())
            + size_of_val(self.start.as_slice())
            + size_of_val(self.points.as_slice())
    }
}
