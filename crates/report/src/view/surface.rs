//! The soil surface at one time, read back from its field file.

use results::files::{Inside, OutputError};
use results::vtk::VtkFile;

/// Heights over the columns of a grid, wherever it is.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct SurfaceAtTime {
    /// Centres of the columns along x and y [m], rising.
    pub(super) axes: [Vec<f64>; 2],
    /// Heights [m], x fastest.
    pub(super) heights: Vec<f64>,
    /// Mean height of the undisturbed surface [m].
    pub(super) level: f64,
}

impl SurfaceAtTime {
    /// Reads a surface; in plane strain its only row of columns becomes a strip of this width [m], and of a
    /// case that is symmetric about x = 0 the other half is added.
    pub(super) fn read(from: &Inside, width: f64, symmetric_x: bool) -> Result<Self, OutputError> {
        let file = VtkFile::read(from)?;
        let (points, rises) = (file.numbers("Points")?, file.numbers("rise")?);
        let points: Vec<[f64; 3]> = points.chunks_exact(3).map(|p| [p[0], p[1], p[2]]).collect();
        let first_y = points.first().map_or(f64::NAN, |p| p[1]);
        let columns = points.iter().take_while(|p| p[1] == first_y).count();
        if columns < 2 || !points.len().is_multiple_of(columns) || rises.len() != points.len() {
            return Err(OutputError::content(&from.path(), "its points are no rows of columns"));
        }
        let x = points[..columns].iter().map(|p| p[0]).collect();
        let y = points.iter().step_by(columns).map(|p| p[1]).collect();
        let levels = points.iter().zip(&rises).map(|(p, rise)| p[2] - rise);
        let level = levels.sum::<f64>() / points.len() as f64;
        let mut surface = Self { axes: [x, y], heights: points.iter().map(|p| p[2]).collect(), level };
        surface.widen(width);
        if symmetric_x {
            surface.mirror();
        }
        if surface.axes.iter().any(|axis| axis.windows(2).any(|pair| pair[1] <= pair[0])) {
            return Err(OutputError::content(&from.path(), "its columns are not in order"));
        }
        Ok(surface)
    }

    /// Makes a strip of a single row.
    fn widen(&mut self, width: f64) {
        if let [y] = self.axes[1][..] {
            self.axes[1] = vec![y - 0.5 * width, y + 0.5 * width];
            self.heights.extend_from_within(..);
        }
    }

    /// Adds the half at x < 0.
    fn mirror(&mut self) {
        let columns = self.axes[0].len();
        let rows = self.heights.chunks_exact(columns);
        self.heights = rows.flat_map(|row| row.iter().rev().chain(row)).copied().collect();
        let x = &self.axes[0];
        self.axes[0] = x.iter().rev().map(|x| -x).chain(x.iter().copied()).collect();
    }

    /// The height at a place [m], linear between the centres of columns; not-a-number beyond them, but for
    /// half a column.
    pub(super) fn at(&self, place: [f64; 2]) -> f64 {
        let [Some((i, a)), Some((j, b))] = [0, 1].map(|axis| between(&self.axes[axis], place[axis])) else {
            return f64::NAN;
        };
        let height = |i: usize, j: usize| self.heights[j * self.axes[0].len() + i];
        let row = |j: usize| (1.0 - a) * height(i, j) + a * height(i + 1, j);
        (1.0 - b) * row(j) + b * row(j + 1)
    }
}

/// The interval of rising values that holds a value, and where in it the value lies, 0 to 1.
fn between(values: &[f64], value: f64) -> Option<(usize, f64)> {
    let last = values.len().checked_sub(2)?;
    let n = values.partition_point(|v| *v <= value).saturating_sub(1).min(last);
    let part = (value - values[n]) / (values[n + 1] - values[n]);
    (-0.51..=1.51).contains(&part).then_some((n, part.clamp(0.0, 1.0)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_are_interpolated_and_missing_beyond_the_grid() {
        let surface = SurfaceAtTime {
            axes: [vec![0.0, 1.0], vec![0.0, 2.0]],
            heights: vec![0.0, 1.0, 2.0, 3.0],
            level: 0.0,
        };
        assert_eq!(surface.at([0.5, 1.0]), 1.5);
        assert_eq!(surface.at([1.4, 2.0]), 3.0);
        assert!(surface.at([1.6, 0.0]).is_nan() && surface.at([0.0, -3.0]).is_nan());
    }

    #[test]
    fn single_rows_become_strips_and_halves_whole() {
        let mut surface =
            SurfaceAtTime { axes: [vec![1.0, 2.0], vec![0.0]], heights: vec![5.0, 6.0], level: 0.0 };
        surface.widen(0.5);
        surface.mirror();
        assert_eq!(surface.axes, [vec![-2.0, -1.0, 1.0, 2.0], vec![-0.25, 0.25]]);
        assert_eq!(surface.heights, [6.0, 5.0, 5.0, 6.0, 6.0, 5.0, 5.0, 6.0]);
    }
}
