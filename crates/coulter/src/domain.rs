//! The domain of a grid where it is: what everyone reads who shows a state or takes a sample of it.
//!
//! A grid may travel over the ground, and has ghost layers beyond its open faces. The layers here are those of the domain,
//! counted from its low end, and positions are those of the ground.

use glam::DVec3;
use solver::grid::Grid;
use solver::precision::Precision;
use solver::state::State;

/// The domain of a whole grid at its position.
#[derive(Clone, Debug)]
pub(crate) struct PlacedDomain<'a> {
    /// The grid.
    pub(crate) grid: &'a Grid,
    /// Positions of the cell faces along x, y, z [m].
    pub(crate) faces: [Vec<f64>; 3],
    /// The layers of the grid that are the first of the domain.
    first: [usize; 3],
}

impl<'a> PlacedDomain<'a> {
    /// The domain of a grid that has moved so far [m].
    pub(crate) fn of(grid: &'a Grid, grid_position: DVec3) -> Self {
        let inside = [0, 1, 2].map(|axis| grid.inside(axis));
        let faces = std::array::from_fn(|axis| {
            let faces = &grid.faces[axis][inside[axis].start..=inside[axis].end];
            let moved = grid_position[axis];
            // A grid that stands still keeps the bits of its faces, the sign of zero among them.
            if moved == 0.0 { faces.to_vec() } else { faces.iter().map(|face| face + moved).collect() }
        });
        Self { grid, faces, first: inside.map(|layers| layers.start) }
    }

    /// Number of cells along x, y, z.
    pub(crate) fn cells(&self) -> [usize; 3] {
        self.faces.each_ref().map(|faces| faces.len() - 1)
    }

    /// Ends along an axis [m].
    pub(crate) fn ends(&self, axis: usize) -> [f64; 2] {
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
    pub(crate) fn filled_cells<R: Precision>(&self, state: &State<R>) -> usize {
        self.indices().filter(|&cell| state.soil.fraction[cell] != R::default()).count()
    }

    /// Width of cell layer `n` along an axis [m].
    pub(crate) fn width(&self, axis: usize, n: usize) -> f64 {
        self.grid.width(axis, n + self.first[axis])
    }

    /// Middle of cell layer `n` along an axis [m].
    pub(crate) fn centre(&self, axis: usize, n: usize) -> f64 {
        0.5 * (self.faces[axis][n + 1] + self.faces[axis][n])
    }

    /// Volume of cell `(i, j, k)` [m³].
    pub(crate) fn volume(&self, at: [usize; 3]) -> f64 {
        let [i, j, k] = self.in_grid(at);
        self.grid.volume(i, j, k)
    }

    /// Height of the free surface over column `(i, j)` [m], as [`PlacedDomain::height_of`] takes it.
    pub(crate) fn surface_height(&self, state: &State<impl Precision>, [i, j]: [usize; 2]) -> f64 {
        self.height_of(|k| state.soil.fraction.get(self.index([i, j, k])).map_or(0.0, |f| (*f).into()))
    }

    /// Height of the free surface over a column whose cells hold these fractions of soil [m]: the soil of the uppermost cell that is at
    /// least half full and of the cell above it, heaped on the floor of the former. Detached soil above and voids below do not count.
    pub(crate) fn height_of(&self, held: impl Fn(usize) -> f64) -> f64 {
        let layers = self.cells()[2];
        let fraction = |k: usize| held(k).clamp(0.0, 1.0);
        let Some(top) = (0..layers).rev().find(|&k| fraction(k) >= 0.5) else {
            return self.faces[2][0] + fraction(0) * self.width(2, 0);
        };
        let above = if top + 1 < layers { fraction(top + 1) * self.width(2, top + 1) } else { 0.0 };
        self.faces[2][top] + fraction(top) * self.width(2, top) + above
    }
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
