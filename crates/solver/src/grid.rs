//! The Eulerian grid: a rectilinear, graded box of cells that never moves.
//!
//! Cells and nodes share one numbering: x fastest, one ghost layer on every side, rows of whole vectors and two ghosts. Node
//! `(i, j, k)` is the low corner of cell `(i, j, k)`, so a cell's corners and a node's cells are constant offsets.

use serde::{Deserialize, Serialize};

/// Rows hold a multiple of this many cells, or twice as many, so that vector loops over cells have no remainder: as many
/// numbers of double precision as the widest vector holds.
pub const LANES: usize = 8;

/// A rectilinear grid.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Grid {
    /// Positions of the cell faces along x, y, z [m], increasing.
    pub faces: [Vec<f64>; 3],
    /// Distance in memory between neighbours along x, y, z.
    pub stride: [usize; 3],
    /// Entries of an array that covers the grid with its ghosts.
    pub entries: usize,
    /// The smallest cell width [m].
    finest: f64,
    /// Rows are padded to a multiple of this.
    lanes: usize,
}

impl Grid {
    /// A grid with the given face positions [m]; each must be increasing and hold at least two.
    #[must_use]
    pub fn new(faces: [Vec<f64>; 3]) -> Self {
        Self::padded(faces, LANES)
    }

    /// The same with rows for vectors of `lanes` numbers, a multiple of [`LANES`].
    #[must_use]
    pub fn padded(faces: [Vec<f64>; 3], lanes: usize) -> Self {
        // One ghost before, one after, and whole vectors of cells between them.
        let row = (faces[0].len() - 1).next_multiple_of(lanes) + 2;
        let plane = row * (faces[1].len() + 1);
        let entries = plane * (faces[2].len() + 1) + lanes;
        let finest =
            faces.iter().flat_map(|f| f.windows(2).map(|w| w[1] - w[0])).fold(f64::INFINITY, f64::min);
        Self { faces, stride: [1, row, plane], entries, finest, lanes }
    }

    /// Number of cells along x, y, z.
    #[must_use]
    pub fn cells(&self) -> [usize; 3] {
        [self.faces[0].len() - 1, self.faces[1].len() - 1, self.faces[2].len() - 1]
    }

    /// Number of cells in a row with those that pad it to whole vectors.
    #[must_use]
    pub fn padded_row(&self) -> usize {
        self.cells()[0].next_multiple_of(self.lanes)
    }

    /// Number of nodes in a row with those that pad it to whole vectors, if there is room for them.
    #[must_use]
    pub fn padded_nodes(&self) -> usize {
        (self.cells()[0] + 1).next_multiple_of(self.lanes).min(self.stride[1] - 1)
    }

    /// Place in memory of cell (or node) `(i, j, k)`.
    #[must_use]
    pub fn index(&self, i: usize, j: usize, k: usize) -> usize {
        (i + 1) * self.stride[0] + (j + 1) * self.stride[1] + (k + 1) * self.stride[2]
    }

    /// Cell (or node) `(i, j, k)` at a place in memory; the inverse of [`Grid::index`].
    #[must_use]
    pub fn place(&self, index: usize) -> [usize; 3] {
        let [_, row, plane] = self.stride;
        [index % row - 1, index % plane / row - 1, index / plane - 1]
    }

    /// Number of rows in a plane of the memory, ghosts among them.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.stride[2] / self.stride[1]
    }

    /// Row within its plane, and plane, of a row of the memory; those of cell `(i, j, k)` are j + 1 and k + 1.
    #[must_use]
    pub fn row_place(&self, row: usize) -> [usize; 2] {
        [row % self.rows(), row / self.rows()]
    }

    /// Width of cell layer `n` along `axis` [m].
    #[must_use]
    pub fn width(&self, axis: usize, n: usize) -> f64 {
        self.faces[axis][n + 1] - self.faces[axis][n]
    }

    /// Middle of cell layer `n` along `axis` [m].
    #[must_use]
    pub fn centre(&self, axis: usize, n: usize) -> f64 {
        0.5 * (self.faces[axis][n + 1] + self.faces[axis][n])
    }

    /// Volume of cell `(i, j, k)` [m³].
    #[must_use]
    pub fn volume(&self, i: usize, j: usize, k: usize) -> f64 {
        self.width(0, i) * self.width(1, j) * self.width(2, k)
    }

    /// Volume of the cell at a place in memory [m³].
    #[must_use]
    pub fn volume_of(&self, index: usize) -> f64 {
        let [i, j, k] = self.place(index);
        self.volume(i, j, k)
    }

    /// The smallest cell width along `axis` [m].
    #[must_use]
    pub fn finest_along(&self, axis: usize) -> f64 {
        self.faces[axis].windows(2).map(|w| w[1] - w[0]).fold(f64::INFINITY, f64::min)
    }

    /// The smallest cell width [m].
    #[must_use]
    pub fn finest(&self) -> f64 {
        self.finest
    }
}
