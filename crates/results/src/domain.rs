//! The domain of a grid where it is: what everyone reads who shows a state or takes a sample of it.
//!
//! A grid may travel over the ground, and has ghost layers beyond its open faces. The layers here are those
//! of the domain, counted from its low end, and positions are those of the ground.

use glam::DVec3;
use solver::grid::Grid;
use solver::precision::Precision;
use solver::state::State;
use std::ops::Range;

/// The domain of a grid at its position; of a block the portion that it owns.
#[derive(Clone, Debug)]
pub struct PlacedDomain<'a> {
    /// The grid.
    pub(crate) grid: &'a Grid,
    /// Positions of the cell faces along x, y, z [m].
    pub faces: [Vec<f64>; 3],
    /// The layers of the grid that are the first of the domain.
    first: [usize; 3],
}

impl<'a> PlacedDomain<'a> {
    /// The domain of a grid that has moved so far [m].
    pub fn of(grid: &'a Grid, grid_position: DVec3) -> Self {
        let inside = [0, 1, 2].map(|axis| {
            let (own, first) = (&grid.own[axis], grid.first[axis]);
            own.start - first..own.end - first
        });
        let faces = std::array::from_fn(|axis| {
            let own = &inside[axis];
            placed(&grid.faces[axis][own.start..=own.end], grid_position[axis])
        });
        Self { grid, faces, first: inside.map(|layers| layers.start) }
    }

    /// Positions of the faces of the whole domain along an axis, of a grid that has moved so far [m].
    pub fn whole_faces(grid: &Grid, axis: usize, grid_position: DVec3) -> Vec<f64> {
        let domain = &grid.domain[axis];
        placed(&grid.whole[axis][domain.start..=domain.end], grid_position[axis])
    }

    /// Number of cells along x, y, z.
    pub fn cells(&self) -> [usize; 3] {
        self.faces.each_ref().map(|faces| faces.len() - 1)
    }

    /// Layers of cells of the whole domain that these are, along x, y, z.
    pub(crate) fn layers(&self) -> [Range<usize>; 3] {
        std::array::from_fn(|axis| {
            let (own, domain) = (&self.grid.own[axis], &self.grid.domain[axis]);
            own.start - domain.start..own.end - domain.start
        })
    }

    /// Whether a face of the whole domain bounds it, at the low end (0) or the high end (1) along an axis.
    pub(crate) fn reaches(&self, axis: usize, end: usize) -> bool {
        !self.grid.is_cut(axis, end)
    }

    /// Ends along an axis [m].
    pub fn ends(&self, axis: usize) -> [f64; 2] {
        let faces = &self.faces[axis];
        [faces[0], faces[faces.len() - 1]]
    }

    /// Layers of the grid from those of the domain.
    fn in_grid(&self, at: [usize; 3]) -> [usize; 3] {
        std::array::from_fn(|axis| at[axis] + self.first[axis])
    }

    /// Index in memory of cell (or node) `(i, j, k)`.
    pub(crate) fn index(&self, at: [usize; 3]) -> usize {
        let [i, j, k] = self.in_grid(at);
        self.grid.index(i, j, k)
    }

    /// Indices in memory of all cells, x fastest.
    pub(crate) fn indices(&self) -> impl Iterator<Item = usize> {
        let [columns, rows, layers] = self.cells();
        let starts = (0..layers).flat_map(move |k| (0..rows).map(move |j| self.index([0, j, k])));
        starts.flat_map(move |start| start..start + columns)
    }

    /// Number of cells that hold any soil.
    pub fn filled_cells<R: Precision>(&self, state: &State<R>) -> usize {
        self.indices().filter(|&cell| state.soil.fraction[cell] != R::default()).count()
    }

    /// Width of cell layer `n` along an axis [m].
    pub(crate) fn width(&self, axis: usize, n: usize) -> f64 {
        self.grid.width(axis, n + self.first[axis])
    }

    /// Middle of cell layer `n` along an axis [m].
    pub fn centre(&self, axis: usize, n: usize) -> f64 {
        0.5 * (self.faces[axis][n + 1] + self.faces[axis][n])
    }

    /// Volume of cell `(i, j, k)` [m³].
    pub(crate) fn volume(&self, at: [usize; 3]) -> f64 {
        let [i, j, k] = self.in_grid(at);
        self.grid.volume(i, j, k)
    }
}

/// Faces of a grid that has moved so far [m]. One that stands still keeps the bits of its faces, the sign of
/// zero among them.
fn placed(faces: &[f64], moved: f64) -> Vec<f64> {
    if moved == 0.0 { faces.to_vec() } else { faces.iter().map(|face| face + moved).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ghost_layers_are_left_out_and_positions_are_those_of_the_ground() {
        let faces = [4, 2, 3].map(|n| (0..=n).map(f64::from).collect::<Vec<_>>());
        let open = [[true, true], [false; 2], [false; 2]];
        let grid = Grid::with_open_faces(faces.clone(), open, 8);
        let domain = PlacedDomain::of(&grid, DVec3::new(10.0, 0.0, 0.0));
        assert_eq!(domain.cells(), [4, 2, 3]);
        assert_eq!(domain.faces[0], [10.0, 11.0, 12.0, 13.0, 14.0]);
        assert_eq!(domain.faces[1..], faces[1..]);
        assert_eq!(domain.ends(0), [10.0, 14.0]);
        assert_eq!(domain.index([1, 0, 2]), grid.index(grid.inside(0).start + 1, 0, 2));
        assert_eq!((domain.centre(0, 1), domain.width(0, 1), domain.volume([1, 1, 1])), (11.5, 1.0, 1.0));
        assert_eq!(domain.indices().count(), 4 * 2 * 3);
    }

    #[test]
    fn a_grid_that_stands_still_keeps_the_bits_of_its_faces() {
        let faces = [1, 2, 3].map(|n| (0..=n).map(|face| -f64::from(face)).rev().collect::<Vec<_>>());
        let grid = Grid::new(faces.clone());
        let bits = |faces: [Vec<f64>; 3]| faces.map(|f| f.iter().map(|v| v.to_bits()).collect::<Vec<_>>());
        assert_eq!(bits(PlacedDomain::of(&grid, DVec3::ZERO).faces), bits(faces));
    }
}
