//! The layout of a rectilinear grid in memory.
//!
//! Cells and nodes share one numbering: x fastest, one ghost before and after every row, plane and the whole.
//! Node `(i, j, k)` is the low corner of cell `(i, j, k)`.

use std::ops::Range;

/// Rows hold a multiple of this many cells, or twice as many, so that vector loops over cells have no
/// remainder: as many numbers of double precision as the widest vector holds.
pub const LANES: usize = 8;

/// Cells of a grid and where they lie.
#[derive(Clone, Copy, Debug)]
pub struct Layout<'a> {
    /// Number of cells along x, y, z.
    pub cells: [usize; 3],
    /// Distance in memory between neighbours along x, y, z.
    pub stride: [usize; 3],
    /// Positions of the cell faces along x, y, z [m], increasing.
    pub faces: [&'a [f64]; 3],
}

/// Neighbours in a row of the memory: all of it, or one.
#[derive(Clone, Copy, Debug)]
pub struct Part {
    /// Index of the first in memory.
    pub start: usize,
    /// How many there are.
    pub length: usize,
}

impl Layout<'_> {
    /// Number of rows in a plane of the memory, ghosts among them.
    #[inline(always)]
    #[must_use]
    pub fn rows(&self) -> usize {
        self.stride[2] / self.stride[1]
    }

    /// Row within its plane, and plane, of a row of the memory; those of cell `(i, j, k)` are j + 1 and k +
    /// 1.
    #[inline(always)]
    #[must_use]
    pub fn row_and_plane(&self, row: usize) -> [usize; 2] {
        [row % self.rows(), row / self.rows()]
    }

    /// Cell (or node) `(i, j, k)` at an index in memory that is none of a ghost.
    #[inline(always)]
    #[must_use]
    pub fn layers_of(&self, index: usize) -> [usize; 3] {
        let [_, row, plane] = self.stride;
        [index % row - 1, index % plane / row - 1, index / plane - 1]
    }

    /// Width of cell layer `n` along `axis` [m].
    #[inline(always)]
    #[must_use]
    pub fn width(&self, axis: usize, n: usize) -> f64 {
        self.faces[axis][n + 1] - self.faces[axis][n]
    }

    /// Volume of cell `(i, j, k)` [m³].
    #[inline(always)]
    #[must_use]
    pub fn volume(&self, i: usize, j: usize, k: usize) -> f64 {
        self.width(0, i) * self.width(1, j) * self.width(2, k)
    }

    /// 0-based layers along y and z of a row of the memory, if it is one of cells.
    #[inline(always)]
    #[must_use]
    pub fn layers_of_row(&self, row: usize) -> Option<[usize; 2]> {
        let ([_, ny, nz], [q, plane]) = (self.cells, self.row_and_plane(row));
        ((1..=ny).contains(&q) && (1..=nz).contains(&plane)).then(|| [q - 1, plane - 1])
    }

    /// Columns of a part of a row that are cells; the first ghost of the row is column 0.
    #[inline(always)]
    #[must_use]
    pub fn columns(&self, part: Part) -> Range<usize> {
        let first = part.start % self.stride[1];
        first.max(1)..(first + part.length).min(self.cells[0] + 1)
    }

    /// Calls `job(cell, its 0-based layers)` for the cells of a part of a row, none for a row of ghosts.
    #[inline(always)]
    pub fn each_cell(&self, part: Part, mut job: impl FnMut(usize, [usize; 3])) {
        let length = self.stride[1];
        if let Some([j, k]) = self.layers_of_row(part.start / length) {
            let row = part.start - part.start % length;
            self.columns(part).for_each(|column| job(row + column, [column - 1, j, k]));
        }
    }
}
