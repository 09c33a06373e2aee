//! The Eulerian grid: a rectilinear, graded box of cells, or a block of it with ghost layers where it was cut.
//!
//! Cells and nodes share one numbering: x fastest, one ghost layer on every side, rows of whole vectors and two ghosts. Node
//! `(i, j, k)` is the low corner of cell `(i, j, k)`, so a cell's corners and a node's cells are constant offsets.

use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Rows hold a multiple of this many cells, or twice as many, so that vector loops over cells have no remainder: as many
/// numbers of double precision as the widest vector holds.
pub const LANES: usize = 8;

/// Layers that a block has beyond a cut, whose contents are its neighbour's. Enough for a sweep of a remap (the flux through
/// a face looks three cells away, momentum one farther) and for a round of overlap removal; a filter may look as far.
pub const GHOSTS: usize = 4;

/// A rectilinear grid, or a block of one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Grid {
    /// Positions of the cell faces along x, y, z [m], increasing; of a block with its ghost layers.
    pub faces: [Vec<f64>; 3],
    /// Those of the whole grid.
    pub whole: [Vec<f64>; 3],
    /// Layers of cells of the whole grid that this block owns.
    pub own: [Range<usize>; 3],
    /// Layer of the whole grid that is the block's first, a ghost where it is cut there.
    pub first: [usize; 3],
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
        let own = faces.each_ref().map(|f| 0..f.len() - 1);
        Self::block(faces, own, lanes)
    }

    /// The block of a grid that owns some layers of cells. Rows along x are never cut: sums over them keep their bits.
    ///
    /// # Panics
    /// When a cut block has fewer than [`GHOSTS`] layers, or is cut along x.
    #[must_use]
    pub fn block(whole: [Vec<f64>; 3], own: [Range<usize>; 3], lanes: usize) -> Self {
        let cells = whole.each_ref().map(|f| f.len() - 1);
        assert!(own[0] == (0..cells[0]), "rows along x are never cut");
        let is_thick = |axis: usize| own[axis] == (0..cells[axis]) || own[axis].len() >= GHOSTS;
        assert!((0..3).all(is_thick), "a block needs {GHOSTS} layers");
        let first = own.each_ref().map(|own| own.start.saturating_sub(GHOSTS));
        let faces = std::array::from_fn(|axis| {
            let end = (own[axis].end + GHOSTS).min(cells[axis]);
            whole[axis][first[axis]..=end].to_vec()
        });
        Self::laid_out(faces, whole, own, first, lanes)
    }

    fn laid_out(
        faces: [Vec<f64>; 3],
        whole: [Vec<f64>; 3],
        own: [Range<usize>; 3],
        first: [usize; 3],
        lanes: usize,
    ) -> Self {
        // One ghost before, one after, and whole vectors of cells between them.
        let row = (faces[0].len() - 1).next_multiple_of(lanes) + 2;
        let plane = row * (faces[1].len() + 1);
        let entries = plane * (faces[2].len() + 1) + lanes;
        let finest =
            whole.iter().flat_map(|f| f.windows(2).map(|w| w[1] - w[0])).fold(f64::INFINITY, f64::min);
        Self { faces, whole, own, first, stride: [1, row, plane], entries, finest, lanes }
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
    pub fn layers_of(&self, index: usize) -> [usize; 3] {
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
    pub fn row_and_plane(&self, row: usize) -> [usize; 2] {
        [row % self.rows(), row / self.rows()]
    }

    /// Ends of the whole grid along `axis` [m].
    #[must_use]
    pub fn ends(&self, axis: usize) -> [f64; 2] {
        let faces = &self.whole[axis];
        [faces[0], faces[faces.len() - 1]]
    }

    /// Number of cells of the whole grid along x, y, z.
    #[must_use]
    pub fn whole_cells(&self) -> [usize; 3] {
        self.whole.each_ref().map(|faces| faces.len() - 1)
    }

    /// Whether the block ends with ghost layers along `axis`, at its low end (0) or its high end (1).
    #[must_use]
    pub fn is_cut(&self, axis: usize, end: usize) -> bool {
        if end == 0 { self.own[axis].start > 0 } else { self.own[axis].end < self.whole_cells()[axis] }
    }

    /// Layers of the whole grid from those of the block.
    #[must_use]
    pub fn in_whole(&self, [i, j, k]: [usize; 3]) -> [usize; 3] {
        [i + self.first[0], j + self.first[1], k + self.first[2]]
    }

    /// Layers of the block from those of a cell of the whole grid, if the block or its ghost layers hold it.
    #[must_use]
    pub fn in_block(&self, whole: [usize; 3]) -> Option<[usize; 3]> {
        let cells = self.cells();
        let mut layers = [0; 3];
        for axis in 0..3 {
            layers[axis] = whole[axis].checked_sub(self.first[axis]).filter(|n| *n < cells[axis])?;
        }
        Some(layers)
    }

    /// Whether the block owns a cell of the whole grid.
    #[must_use]
    pub fn owns(&self, whole: [usize; 3]) -> bool {
        (0..3).all(|axis| self.own[axis].contains(&whole[axis]))
    }

    /// Whether the block owns a node of the whole grid. Nodes at a cut belong to the block above it.
    #[must_use]
    pub fn owns_node(&self, whole: [usize; 3]) -> bool {
        let cells = self.whole_cells();
        let is_last = |axis: usize| whole[axis] == cells[axis] && self.own[axis].end == cells[axis];
        (0..3).all(|axis| self.own[axis].contains(&whole[axis]) || is_last(axis))
    }

    /// Number of the row of the whole grid that a row of the memory is, if the block owns it. Rows of nodes at a cut belong to
    /// the block above it.
    #[must_use]
    pub fn owned_row(&self, row: usize) -> Option<usize> {
        let [q, plane] = self.row_and_plane(row);
        let cells = self.whole_cells();
        let layer = |axis: usize, n: usize| {
            let (layer, own) = (n.checked_sub(1)? + self.first[axis], &self.own[axis]);
            let is_last = layer == own.end && own.end == cells[axis];
            (own.contains(&layer) || is_last).then_some(layer)
        };
        Some(layer(2, plane)? * (cells[1] + 1) + layer(1, q)?)
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
        let [i, j, k] = self.layers_of(index);
        self.volume(i, j, k)
    }

    /// The smallest cell width of the whole grid along `axis` [m].
    #[must_use]
    pub fn finest_along(&self, axis: usize) -> f64 {
        self.whole[axis].windows(2).map(|w| w[1] - w[0]).fold(f64::INFINITY, f64::min)
    }

    /// The smallest cell width of the whole grid [m].
    #[must_use]
    pub fn finest(&self) -> f64 {
        self.finest
    }
}
