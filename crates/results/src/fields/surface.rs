//! The free surface as a height map: the rut, the berms, and their sizes.

use crate::domain::PlacedDomain;
use crate::history::{GroundColumn, SurfacePoint};
use case::model::{ground, materials};
use case::resolved::{Case, Ground};
use glam::DVec3;
use serde::{Deserialize, Serialize};
use solver::grid::Grid;
use solver::halo::Halo;
use solver::initial::undisturbed_fractions;
use solver::precision::Precision;
use solver::state::State;

/// Lines of ground left behind of which less than this fraction of half a cell lies outside the grid are not
/// shown.
const SLIVER: f64 = 1e-6;

/// Height of the free surface over each column of cells, and over the ground that the grid has left behind.
#[derive(Clone, Debug, PartialEq)]
pub struct HeightMap {
    /// Centres of the columns along x and y [m], mirrored to y < 0 in a symmetric case.
    pub centres: [Vec<f64>; 2],
    /// Edges of the columns along x and y [m].
    pub edges: [Vec<f64>; 2],
    /// The columns of soil, x fastest.
    pub columns: Vec<GroundColumn>,
    /// The columns of soil as they were before anything moved, x fastest; none where the ground was level.
    pub undisturbed: Vec<GroundColumn>,
    /// Height of the undisturbed surface [m]; of uneven ground that over which it rises and falls.
    pub reference: f64,
    /// Ends along x and y of what lies inside the grid [m]; beyond them is the ground that it has left
    /// behind.
    pub inside: [[f64; 2]; 2],
}

/// Sizes of rut and berms at the end.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct SurfaceFigures {
    /// Depth of the lowest point below the undisturbed surface [m].
    pub rut_depth_m: f64,
    /// Height of the highest point above it [m].
    pub berm_height_m: f64,
    /// Volume of the rut below it [m³].
    pub rut_volume_m3: f64,
    /// Volume of the berms above it [m³].
    pub berm_volume_m3: f64,
    /// Volume that the soil has lost by compaction [m³]; negative where it has become looser.
    pub compaction_m3: f64,
    /// Volume of voids below the surface, less that of soil above it [m³].
    pub void_m3: f64,
    /// Volume of disturbed soil [m³].
    pub disturbed_m3: f64,
    /// Volume of mixed soil [m³].
    pub mixed_m3: f64,
    /// Volume of the rut that berms, compaction, voids and the holes in which bodies started do not explain,
    /// over that of the rut: soil that has left the map.
    pub unexplained: f64,
}

/// Height of the undisturbed surface [m]; for a column of soil that of the floor on which it collapses.
#[must_use]
pub fn reference_height(case: &Case) -> f64 {
    match case.ground {
        Ground::Level { surface } => surface,
        Ground::Column { .. } => case.domain.low.z,
    }
}

impl HeightMap {
    /// The free surface of a state, with that which its grid has left behind on its way along x or along y
    /// (`left`, lines across that way). Of a grid that has travelled along both there is only what is inside.
    /// Of a grid in blocks the first gets the map of all, and the others get none.
    #[must_use]
    pub fn of(
        case: &Case,
        (grid, halo): (&Grid, &Halo),
        state: &State<impl Precision>,
        left: &[SurfacePoint],
    ) -> Option<Self> {
        let domain = PlacedDomain::of(grid, state.grid_position);
        let [along, across, _] = domain.cells();
        let places: Vec<_> = (0..across).flat_map(|j| (0..along).map(move |i| [i, j])).collect();
        let own = GroundColumn::of_all(&domain, state, (&materials(case), halo), &places);
        // Blocks beside each other are in the order of y, and x runs fastest.
        let all = halo.collect(own.into_iter().flat_map(GroundColumn::to_array).collect());
        if all.is_empty() {
            return None;
        }
        let numbers = all.iter().flat_map(|own| own.chunks_exact(GroundColumn::NUMBERS));
        let columns = numbers.map(GroundColumn::from_numbers).collect();
        let [x, y, z] = [0, 1, 2].map(|axis| PlacedDomain::whole_faces(grid, axis, state.grid_position));
        let inside = [&x, &y].map(|faces| [faces[0], faces[faces.len() - 1]]);
        let edges = [x, y];
        let centres = edges.each_ref().map(|edges| middles(edges));
        let (undisturbed, reference) = (Vec::new(), reference_height(case));
        let mut map = Self { centres, edges, columns, undisturbed, reference, inside };
        map.join(left);
        map.undisturbed = map.before(case, &z);
        if case.domain.symmetric {
            map.mirror();
        }
        Some(map)
    }

    /// The columns of the map before anything moved, in layers of cells with these faces [m].
    fn before(&self, case: &Case, layers: &[f64]) -> Vec<GroundColumn> {
        if case.is_even() {
            return Vec::new();
        }
        let grid = Grid::new([self.edges[0].clone(), self.edges[1].clone(), layers.to_vec()]);
        let fractions = undisturbed_fractions(&grid, &ground(case));
        let domain = PlacedDomain::of(&grid, DVec3::ZERO);
        let [along, across, _] = domain.cells();
        let column =
            |i: usize, j: usize| GroundColumn::undisturbed(&domain, |k| fractions[domain.index([i, j, k])]);
        (0..across).flat_map(|j| (0..along).map(move |i| (i, j))).map(|(i, j)| column(i, j)).collect()
    }

    /// Adds the lines of the ground left behind that lie beyond what is inside.
    fn join(&mut self, left: &[SurfacePoint]) {
        let Some(axis) = (0..2).find(|&axis| self.has_lines_across(axis, left)) else { return };
        let [low_end, high_end] = self.inside[axis];
        let (edges, across) = (&self.edges[axis], self.centres[1 - axis].len());
        let half = [edges[1] - edges[0], edges[edges.len() - 1] - edges[edges.len() - 2]].map(|w| 0.5 * w);
        let lines = || left.chunks_exact(across).map(|line| (line[0].along(axis), line));
        // A line lasts from its outer edge to that of the next, or to the grid.
        let low: Vec<_> = lines().filter(|(x, _)| low_end - (x - half[0]) > SLIVER * half[0]).collect();
        let mut high: Vec<_> = lines().filter(|(x, _)| x + half[1] - high_end > SLIVER * half[1]).collect();
        // A grid that travels towards the low end leaves the highest line first.
        high.reverse();
        let (before, inside) = (low.len(), edges.len() - 1);
        let edges = low.iter().map(|(x, _)| x - half[0]).chain(edges.iter().copied());
        let edges: Vec<f64> = edges.chain(high.iter().map(|(x, _)| x + half[1])).collect();
        let column = |n: usize, m: usize| match n.checked_sub(before) {
            None => low[n].1[m].column,
            Some(n) if n < inside => {
                if axis == 0 {
                    self.column(n, m)
                } else {
                    self.column(m, n)
                }
            }
            Some(n) => high[n - inside].1[m].column,
        };
        let along = edges.len() - 1;
        self.columns = if axis == 0 {
            (0..across).flat_map(|m| (0..along).map(move |n| (n, m))).map(|(n, m)| column(n, m)).collect()
        } else {
            (0..along).flat_map(|n| (0..across).map(move |m| (n, m))).map(|(n, m)| column(n, m)).collect()
        };
        self.centres[axis] = middles(&edges);
        self.edges[axis] = edges;
    }

    /// Whether these are lines of points across an axis, each over all columns of the map along the other.
    fn has_lines_across(&self, axis: usize, left: &[SurfacePoint]) -> bool {
        let across = &self.centres[1 - axis];
        let is_line = |line: &[SurfacePoint]| {
            let is_over_column = |(point, centre): (&SurfacePoint, &f64)| {
                point.along(1 - axis) == *centre && point.along(axis) == line[0].along(axis)
            };
            line.iter().zip(across).all(is_over_column)
        };
        let lines = left.chunks_exact(across.len());
        !left.is_empty() && lines.remainder().is_empty() && lines.into_iter().all(is_line)
    }

    /// Adds the other half of a symmetric case.
    fn mirror(&mut self) {
        let (columns, edges) = (self.centres[0].len(), &mut self.edges[1]);
        *edges = edges.iter().rev().map(|y| -y).chain(edges.iter().skip(1).copied()).collect();
        self.centres[1] = middles(edges);
        self.inside[1] = [-self.inside[1][1], self.inside[1][1]];
        for all in [&mut self.columns, &mut self.undisturbed] {
            let rows = all.chunks_exact(columns);
            *all = rows.clone().rev().chain(rows).flatten().copied().collect();
        }
    }

    /// A range along x (0) or y (1) [m], extended over the ground left behind.
    #[must_use]
    pub fn with_ground_left(&self, axis: usize, [low, high]: [f64; 2]) -> [f64; 2] {
        let (edges, inside) = (&self.edges[axis], self.inside[axis]);
        let (first, last) = (edges[0], edges[edges.len() - 1]);
        [
            if first < inside[0] { low.min(first) } else { low },
            if last > inside[1] { high.max(last) } else { high },
        ]
    }

    /// Height [m] of column `(i, j)`.
    #[must_use]
    pub fn at(&self, i: usize, j: usize) -> f64 {
        self.columns.get(j * self.centres[0].len() + i).map_or(f64::NAN, |column| column.z)
    }

    /// Height of the surface over column `(i, j)` above the undisturbed one [m].
    #[must_use]
    pub fn rise(&self, i: usize, j: usize) -> f64 {
        self.column(i, j).z - self.column_before(i, j).z
    }

    /// Column `(i, j)` before anything moved.
    #[must_use]
    pub fn column_before(&self, i: usize, j: usize) -> GroundColumn {
        let level =
            GroundColumn { z: self.reference, disturbed_to: self.reference, ..GroundColumn::default() };
        self.undisturbed.get(j * self.centres[0].len() + i).copied().unwrap_or(level)
    }

    /// Column `(i, j)`.
    #[must_use]
    pub fn column(&self, i: usize, j: usize) -> GroundColumn {
        self.columns[j * self.centres[0].len() + i]
    }

    /// The columns of the map with their places, x fastest.
    #[must_use]
    pub fn points(&self) -> Vec<SurfacePoint> {
        let places = self.centres[1].iter().flat_map(|y| self.centres[0].iter().map(move |x| [*x, *y]));
        places.zip(&self.columns).map(|([x, y], column)| SurfacePoint { x, y, column: *column }).collect()
    }

    /// Depth of the rut, height of the berms, their volumes and what else has become of the soil, of which
    /// bodies had taken out a volume
    /// [m³] before the start.
    #[must_use]
    pub fn figures(&self, taken_out: f64) -> SurfaceFigures {
        let mut figures = SurfaceFigures::default();
        for (j, dy) in self.edges[1].windows(2).map(|e| e[1] - e[0]).enumerate() {
            for (i, dx) in self.edges[0].windows(2).map(|e| e[1] - e[0]).enumerate() {
                let rise = self.rise(i, j);
                if rise > 0.0 {
                    figures.berm_height_m = figures.berm_height_m.max(rise);
                    figures.berm_volume_m3 += rise * dx * dy;
                } else if rise < 0.0 {
                    figures.rut_depth_m = figures.rut_depth_m.max(-rise);
                    figures.rut_volume_m3 -= rise * dx * dy;
                }
                let column = self.column(i, j);
                figures.compaction_m3 += column.compaction * dx * dy;
                figures.void_m3 += (column.void - self.column_before(i, j).void) * dx * dy;
                figures.disturbed_m3 += column.disturbed * dx * dy;
                figures.mixed_m3 += column.mixed * dx * dy;
            }
        }
        let SurfaceFigures { rut_volume_m3: rut, berm_volume_m3: berm, compaction_m3, void_m3, .. } = figures;
        if rut > 0.0 {
            figures.unexplained = (rut - berm - compaction_m3 + void_m3 - taken_out) / rut;
        }
        figures
    }

    /// Heights [m] of the row of columns at `y` [m], at first and now, for each column along x.
    #[must_use]
    pub fn along(&self, y: f64) -> Vec<[f64; 3]> {
        let row = nearest(&self.edges[1], y);
        let heights = |i: usize| [self.column_before(i, row).z, self.at(i, row)];
        let each = self.centres[0].iter().enumerate().map(|(i, x)| (x, heights(i)));
        each.map(|(x, [before, now])| [*x, before, now]).collect()
    }

    /// Mean heights [m], at first and now, over the columns whose centres lie in `from..=to` along x, for
    /// each row along y.
    #[must_use]
    pub fn section(&self, from: f64, to: f64) -> Vec<[f64; 3]> {
        let x = &self.centres[0];
        let mut inside: Vec<usize> = (0..x.len()).filter(|&i| x[i] >= from && x[i] <= to).collect();
        if inside.is_empty() {
            let middle = 0.5 * (from + to);
            let nearest =
                (0..x.len()).min_by(|&a, &b| (x[a] - middle).abs().total_cmp(&(x[b] - middle).abs()));
            inside.extend(nearest);
        }
        let mean = |j: usize| inside.iter().map(|&i| self.at(i, j)).sum::<f64>() / inside.len() as f64;
        let before =
            |j: usize| inside.iter().map(|&i| self.column_before(i, j).z).sum::<f64>() / inside.len() as f64;
        self.centres[1].iter().enumerate().map(|(j, y)| [*y, before(j), mean(j)]).collect()
    }
}

/// The middles between edges [m].
fn middles(edges: &[f64]) -> Vec<f64> {
    edges.windows(2).map(|e| 0.5 * (e[0] + e[1])).collect()
}

/// Index of the interval that contains `value`, or of the nearest one.
fn nearest(edges: &[f64], value: f64) -> usize {
    edges.partition_point(|edge| *edge <= value).saturating_sub(1).min(edges.len().saturating_sub(2))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn column(z: f64) -> GroundColumn {
        GroundColumn { z, ..GroundColumn::default() }
    }

    fn heights(map: &HeightMap) -> Vec<f64> {
        map.columns.iter().map(|column| column.z).collect()
    }

    /// Two columns by two rows of unit cells whose low corner lies at a position along an axis, at heights 1
    /// to 4.
    fn map(axis: usize, at: f64) -> HeightMap {
        let mut edges = [vec![0.0, 1.0, 2.0], vec![0.0, 1.0, 2.0]];
        edges[axis].iter_mut().for_each(|edge| *edge += at);
        let centres = edges.each_ref().map(|edges| middles(edges));
        let inside = edges.each_ref().map(|edges| [edges[0], edges[2]]);
        HeightMap {
            centres,
            edges,
            columns: vec![1.0, 2.0, 3.0, 4.0].into_iter().map(column).collect(),
            undisturbed: Vec::new(),
            reference: 0.0,
            inside,
        }
    }

    /// A line across an axis at a position, as high as a number and a tenth more.
    fn line(axis: usize, at: f64, height: f64) -> [SurfacePoint; 2] {
        [0, 1].map(|n| {
            let across = 0.5 + f64::from(n);
            let [x, y] = if axis == 0 { [at, across] } else { [across, at] };
            SurfacePoint { x, y, column: column(height + 0.1 * f64::from(n)) }
        })
    }

    #[test]
    fn ground_left_along_x_comes_before_what_is_inside() {
        let mut map = map(0, 2.25);
        map.join(&[line(0, 0.5, 7.0), line(0, 1.5, 8.0), line(0, 2.5, 9.0)].concat());
        assert_eq!(map.edges[0], [0.0, 1.0, 2.0, 2.25, 3.25, 4.25]);
        assert_eq!(heights(&map), [7.0, 8.0, 9.0, 1.0, 2.0, 7.1, 8.1, 9.1, 3.0, 4.0]);
        assert_eq!(map.with_ground_left(0, [3.0, 4.0]), [0.0, 4.0]);
        assert_eq!(map.with_ground_left(1, [0.5, 1.5]), [0.5, 1.5]);
    }

    #[test]
    fn ground_left_by_a_grid_that_travels_backwards_along_y_comes_after() {
        let mut map = map(1, -1.5);
        map.join(&[line(1, 1.5, 7.0), line(1, 0.5, 8.0)].concat());
        assert_eq!(map.edges[1], [-1.5, -0.5, 0.5, 1.0, 2.0]);
        assert_eq!(heights(&map), [1.0, 2.0, 3.0, 4.0, 8.0, 8.1, 7.0, 7.1]);
    }

    #[test]
    fn what_the_grid_still_holds_is_not_shown_twice() {
        for left in [&line(0, 0.5, 7.0)[..], &[]] {
            let mut joined = map(0, 0.0);
            joined.join(left);
            assert_eq!(joined, map(0, 0.0));
        }
        // Of a grid that has moved sideways as well the lines do not fit.
        let mut joined = map(0, 5.0);
        joined.join(&line(0, 0.5, 7.0).map(|point| SurfacePoint { y: point.y + 0.01, ..point }));
        assert_eq!(joined, map(0, 5.0));
    }
}
