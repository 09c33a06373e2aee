//! The free surface as a height map: the rut, the berms, and their sizes.

use crate::case::resolved::{Case, Ground};
use serde::{Deserialize, Serialize};
use solver::grid::Grid;
use solver::precision::Precision;
use solver::state::State;

/// Height of the free surface over each column of cells.
#[derive(Clone, Debug, PartialEq)]
pub struct HeightMap {
    /// Centres of the columns along x and y [m], mirrored to y < 0 in a symmetric case.
    pub centres: [Vec<f64>; 2],
    /// Edges of the columns along x and y [m].
    pub edges: [Vec<f64>; 2],
    /// Height z of the surface [m], x fastest.
    pub height: Vec<f64>,
    /// Height of the undisturbed surface [m].
    pub reference: f64,
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
    /// The free surface of a state.
    #[must_use]
    pub fn of(case: &Case, grid: &Grid, state: &State<impl Precision>) -> Self {
        let [columns, rows, _] = grid.cells();
        let mut rows_shown: Vec<usize> = (0..rows).collect();
        let mut edges_y = grid.faces[1].clone();
        if case.domain.symmetric {
            rows_shown = (0..rows).rev().chain(0..rows).collect();
            edges_y = edges_y.iter().rev().map(|y| -y).chain(edges_y.iter().skip(1).copied()).collect();
        }
        let height = rows_shown
            .iter()
            .flat_map(|&j| (0..columns).map(move |i| (i, j)))
            .map(|(i, j)| column_height(grid, state, i, j))
            .collect();
        let centres = |edges: &[f64]| edges.windows(2).map(|e| 0.5 * (e[0] + e[1])).collect();
        let edges = [grid.faces[0].clone(), edges_y];
        Self {
            centres: [centres(&edges[0]), centres(&edges[1])],
            edges,
            height,
            reference: reference_height(case),
        }
    }

    /// Height [m] of column `(i, j)`.
    #[must_use]
    pub fn at(&self, i: usize, j: usize) -> f64 {
        self.height.get(j * self.centres[0].len() + i).copied().unwrap_or(f64::NAN)
    }

    /// Depth of the rut, height of the berms and their volumes.
    #[must_use]
    pub fn figures(&self) -> SurfaceFigures {
        let mut figures = SurfaceFigures::default();
        for (j, dy) in self.edges[1].windows(2).map(|e| e[1] - e[0]).enumerate() {
            for (i, dx) in self.edges[0].windows(2).map(|e| e[1] - e[0]).enumerate() {
                let rise = self.at(i, j) - self.reference;
                if rise > 0.0 {
                    figures.berm_height_m = figures.berm_height_m.max(rise);
                    figures.berm_volume_m3 += rise * dx * dy;
                } else if rise < 0.0 {
                    figures.rut_depth_m = figures.rut_depth_m.max(-rise);
                    figures.rut_volume_m3 -= rise * dx * dy;
                }
            }
        }
        figures
    }

    /// Height [m] of the row of columns at `y` [m], for each column along x.
    #[must_use]
    pub fn along(&self, y: f64) -> Vec<[f64; 2]> {
        let row = nearest(&self.edges[1], y);
        self.centres[0].iter().enumerate().map(|(i, x)| [*x, self.at(i, row)]).collect()
    }

    /// Mean height [m] over the columns whose centres lie in `from..=to` along x, for each row along y.
    #[must_use]
    pub fn section(&self, from: f64, to: f64) -> Vec<[f64; 2]> {
        let x = &self.centres[0];
        let mut inside: Vec<usize> = (0..x.len()).filter(|&i| x[i] >= from && x[i] <= to).collect();
        if inside.is_empty() {
            let middle = 0.5 * (from + to);
            let nearest =
                (0..x.len()).min_by(|&a, &b| (x[a] - middle).abs().total_cmp(&(x[b] - middle).abs()));
            inside.extend(nearest);
        }
        let mean = |j: usize| inside.iter().map(|&i| self.at(i, j)).sum::<f64>() / inside.len() as f64;
        self.centres[1].iter().enumerate().map(|(j, y)| [*y, mean(j)]).collect()
    }
}

/// Index of the interval that contains `value`, or of the nearest one.
fn nearest(edges: &[f64], value: f64) -> usize {
    edges.partition_point(|edge| *edge <= value).saturating_sub(1).min(edges.len().saturating_sub(2))
}

/// Height of the surface in one column [m]: the soil of the uppermost cell that is at least half full and of the cell above
/// it, heaped on the floor of the former. Detached soil above and voids below do not count.
fn column_height(grid: &Grid, state: &State<impl Precision>, i: usize, j: usize) -> f64 {
    let layers = grid.cells()[2];
    let fraction =
        |k: usize| state.soil.fraction.get(grid.index(i, j, k)).map_or(0.0, |f| (*f).into().clamp(0.0, 1.0));
    let Some(top) = (0..layers).rev().find(|&k| fraction(k) >= 0.5) else {
        return grid.faces[2][0] + fraction(0) * grid.width(2, 0);
    };
    let above = if top + 1 < layers { fraction(top + 1) * grid.width(2, top + 1) } else { 0.0 };
    grid.faces[2][top] + fraction(top) * grid.width(2, top) + above
}
