//! The relief of the ground: how far its surface lies above or below the level one, from a height map and
//! from furrows.

use std::f64::consts::TAU;
use std::sync::Arc;

/// How far the surface of the ground lies above the level one, `Model::surface`; level where it has neither
/// map nor furrows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Relief {
    /// Heights that were measured.
    pub map: Option<Arc<HeightField>>,
    /// Furrows on top of the heights of the map.
    pub furrows: Option<Furrows>,
}

impl Relief {
    /// Whether the ground is level.
    #[must_use]
    pub fn is_level(&self) -> bool {
        self.map.is_none() && self.furrows.is_none()
    }

    /// Height of the surface above the level one at a place [m]; beyond a map it is that at its edge.
    #[must_use]
    pub fn at(&self, place: [f64; 2]) -> f64 {
        self.map.as_ref().map_or(0.0, |map| map.at(place))
            + self.furrows.map_or(0.0, |furrows| furrows.at(place))
    }

    /// Lowest and highest surface that the ground can have between two places, over the level one [m].
    #[must_use]
    pub fn extremes(&self, within: [[f64; 2]; 2]) -> [f64; 2] {
        let [low, high] = self.map.as_ref().map_or([0.0; 2], |map| map.extremes(within));
        let half = self.furrows.map_or(0.0, |furrows| 0.5 * furrows.depth);
        [low - half, high + half]
    }

    /// Lowest and highest surface of the ground anywhere, over the level one [m].
    #[must_use]
    pub fn range(&self) -> [f64; 2] {
        self.extremes([[f64::NEG_INFINITY, f64::INFINITY]; 2])
    }

    /// Tangent of the steepest slope that the surface can have between two places.
    #[must_use]
    pub fn steepest(&self, within: [[f64; 2]; 2]) -> f64 {
        self.map.as_ref().map_or(0.0, |map| map.steepest(within))
            + self.furrows.map_or(0.0, |furrows| furrows.steepest())
    }

    /// Whether the relief is the same everywhere along x (0) or y (1).
    #[must_use]
    pub fn is_uniform_along(&self, axis: usize) -> bool {
        self.map.as_ref().is_none_or(|map| map.is_uniform_along(axis))
            && self.furrows.is_none_or(|furrows| furrows.is_uniform_along(axis))
    }

    /// Whether the relief is its own mirror image in the plane x = 0 (0) or y = 0 (1): a map only where it is
    /// uniform along that axis.
    #[must_use]
    pub fn is_mirrored(&self, axis: usize) -> bool {
        self.map.as_ref().is_none_or(|map| map.is_uniform_along(axis))
            && self.furrows.is_none_or(|furrows| furrows.is_mirrored(axis))
    }
}

/// Heights at the crossings of lines along x and y, linear between them.
#[derive(Clone, Debug, PartialEq)]
pub struct HeightField {
    /// Where the lines cross x and y [m], increasing.
    lines: [Vec<f64>; 2],
    /// Heights [m], x fastest.
    heights: Vec<f64>,
}

impl HeightField {
    /// Heights [m] at the crossings of lines [m], x fastest; `None` where these do not increase, are fewer
    /// than two along an axis or do not fit the heights, and where a number is not finite.
    #[must_use]
    pub fn new(lines: [Vec<f64>; 2], heights: Vec<f64>) -> Option<Self> {
        let increase = |lines: &Vec<f64>| lines.len() >= 2 && lines.windows(2).all(|pair| pair[0] < pair[1]);
        let finite = lines.iter().flatten().chain(&heights).all(|number| number.is_finite());
        let fits = lines[0].len().checked_mul(lines[1].len()) == Some(heights.len());
        (finite && fits && lines.iter().all(increase)).then_some(Self { lines, heights })
    }

    /// Ends of the field along x (0) or y (1) [m].
    #[must_use]
    pub fn ends(&self, axis: usize) -> [f64; 2] {
        let lines = &self.lines[axis];
        [lines[0], lines[lines.len() - 1]]
    }

    /// Lowest and highest height of the field [m].
    #[must_use]
    pub fn range(&self) -> [f64; 2] {
        self.extremes([[f64::NEG_INFINITY, f64::INFINITY]; 2])
    }

    /// Numbers of lines across x and y.
    #[must_use]
    pub fn size(&self) -> [usize; 2] {
        [self.lines[0].len(), self.lines[1].len()]
    }

    fn height(&self, [i, j]: [usize; 2]) -> f64 {
        self.heights[j * self.lines[0].len() + i]
    }

    /// Height at a place [m].
    fn at(&self, place: [f64; 2]) -> f64 {
        let [(i, x), (j, y)] = [0, 1].map(|axis| self.between(axis, place[axis]));
        let along = |j: usize| self.height([i, j]) * (1.0 - x) + self.height([i + 1, j]) * x;
        along(j) * (1.0 - y) + along(j + 1) * y
    }

    /// The line before a position [m], and how far it is on the way to the next one; an end of the map where
    /// it lies beyond.
    fn between(&self, axis: usize, position: f64) -> (usize, f64) {
        let lines = &self.lines[axis];
        let before = lines.partition_point(|line| *line <= position).saturating_sub(1).min(lines.len() - 2);
        (before, ((position - lines[before]) / (lines[before + 1] - lines[before])).clamp(0.0, 1.0))
    }

    /// Numbers of the lines across x and y from the last before to the first after a range [m].
    fn around(&self, within: [[f64; 2]; 2]) -> [std::ops::RangeInclusive<usize>; 2] {
        [0, 1].map(|axis| {
            let [low, high] = within[axis].map(|end| self.between(axis, end).0);
            low..=high + 1
        })
    }

    fn extremes(&self, within: [[f64; 2]; 2]) -> [f64; 2] {
        let [columns, rows] = self.around(within);
        let heights = rows.flat_map(|j| columns.clone().map(move |i| self.height([i, j])));
        heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], z| [low.min(z), high.max(z)])
    }

    /// Tangent of the steepest slope: between neighbours along x and along y.
    fn steepest(&self, within: [[f64; 2]; 2]) -> f64 {
        let [columns, rows] = self.around(within);
        let slope = |axis: usize, from: [usize; 2]| {
            let mut to = from;
            to[axis] += 1;
            let (lines, n) = (&self.lines[axis], from[axis]);
            (n + 1 < lines.len())
                .then(|| (self.height(to) - self.height(from)).abs() / (lines[n + 1] - lines[n]))
        };
        let places = rows.flat_map(|j| columns.clone().map(move |i| [i, j]));
        let each = places.map(|at| slope(0, at).unwrap_or(0.0).hypot(slope(1, at).unwrap_or(0.0)));
        each.fold(0.0, f64::max)
    }

    fn is_uniform_along(&self, axis: usize) -> bool {
        let [columns, rows] = self.size();
        (0..rows).all(|j| {
            (0..columns).all(|i| {
                let first = if axis == 0 { [0, j] } else { [i, 0] };
                self.height([i, j]) == self.height(first)
            })
        })
    }
}

/// Section of furrows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FurrowShape {
    /// A cosine.
    Sinusoidal,
    /// Straight flanks between sharp crests and troughs.
    Triangular,
}

/// Furrows: parallel, all alike, as far above the level surface as below it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Furrows {
    /// Distance from crest to crest [m].
    pub spacing: f64,
    /// Height of the crests above the troughs [m].
    pub depth: f64,
    /// Direction across the furrows, from crest to crest: a unit vector along x and y.
    pub across: [f64; 2],
    /// Distance of a crest from x = y = 0 in this direction [m].
    pub offset: f64,
    /// Section of a furrow.
    pub shape: FurrowShape,
}

impl Furrows {
    /// Height at a place over their middle [m].
    fn at(&self, [x, y]: [f64; 2]) -> f64 {
        let turns = (self.across[0] * x + self.across[1] * y - self.offset) / self.spacing;
        0.5 * self.depth
            * match self.shape {
                FurrowShape::Sinusoidal => (TAU * turns).cos(),
                FurrowShape::Triangular => 1.0 - 4.0 * (turns - turns.round()).abs(),
            }
    }

    /// Tangent of the steepest slope of the furrows.
    #[must_use]
    pub fn steepest(&self) -> f64 {
        let over_spacing = match self.shape {
            FurrowShape::Sinusoidal => 0.5 * TAU,
            FurrowShape::Triangular => 2.0,
        };
        over_spacing * self.depth / self.spacing
    }

    fn is_uniform_along(&self, axis: usize) -> bool {
        self.across[axis] == 0.0
    }

    /// Whether a crest or a trough lies in the plane across an axis, or the furrows run across it.
    fn is_mirrored(&self, axis: usize) -> bool {
        let halves = 2.0 * self.offset / self.spacing;
        self.is_uniform_along(axis)
            || self.is_uniform_along(1 - axis) && (halves - halves.round()).abs() < 1e-9
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_are_linear_between_the_lines_of_a_map() {
        let field =
            HeightField::new([vec![0.0, 1.0, 3.0], vec![0.0, 2.0]], vec![0.0, 1.0, 5.0, 2.0, 3.0, 7.0]);
        let relief = Relief { map: field.map(Arc::new), furrows: None };
        for (place, z) in [([0.5, 0.0], 0.5), ([2.0, 1.0], 4.0), ([3.0, 2.0], 7.0), ([-9.0, 9.0], 2.0)] {
            assert!((relief.at(place) - z).abs() < 1e-15, "{place:?}: {}", relief.at(place));
        }
        assert_eq!(relief.range(), [0.0, 7.0]);
        assert_eq!(relief.extremes([[0.2, 0.4], [0.0, 2.0]]), [0.0, 3.0]);
        assert!((relief.steepest([[0.0, 3.0], [0.0, 2.0]]) - 5_f64.sqrt()).abs() < 1e-15);
        assert!(!relief.is_uniform_along(0) && !relief.is_mirrored(1));
        for (x, heights) in
            [(vec![0.0], vec![0.0; 2]), (vec![0.0, 0.0], vec![0.0; 4]), (vec![0.0, 1.0], vec![f64::NAN; 4])]
        {
            assert_eq!(HeightField::new([x, vec![0.0, 1.0]], heights), None);
        }
    }

    #[test]
    fn furrows_have_their_depth_and_repeat() {
        let furrows = Furrows {
            spacing: 0.2,
            depth: 0.04,
            across: [1.0, 0.0],
            offset: 0.05,
            shape: FurrowShape::Triangular,
        };
        for shape in [FurrowShape::Triangular, FurrowShape::Sinusoidal] {
            let relief = Relief { map: None, furrows: Some(Furrows { shape, ..furrows }) };
            for (x, z) in [(0.05, 0.02), (0.15, -0.02), (0.25, 0.02), (0.1, 0.0), (-0.95, 0.02)] {
                assert!((relief.at([x, 3.0]) - z).abs() < 1e-12, "{shape:?} {x}: {}", relief.at([x, 3.0]));
            }
            assert!(relief.is_uniform_along(1) && !relief.is_uniform_along(0));
            assert!(relief.is_mirrored(1) && !relief.is_mirrored(0));
            let about_a_trough = Furrows { shape, offset: 0.1, ..furrows };
            assert!(Relief { map: None, furrows: Some(about_a_trough) }.is_mirrored(0));
            let step = 1e-6;
            let slope = |n: f64| (relief.at([n * 1e-4 + step, 0.0]) - relief.at([n * 1e-4, 0.0])) / step;
            let most = (0..2000).map(|n| slope(f64::from(n)).abs()).fold(0.0, f64::max);
            let steepest = relief.steepest([[0.0, 1.0]; 2]);
            assert!((most / steepest - 1.0).abs() < 1e-4, "{shape:?}: {most}, not {steepest}");
        }
    }
}
