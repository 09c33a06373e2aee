//! The Eulerian grid: a rectilinear, graded box of cells, or a block of it, with ghost layers where it was
//! cut and beyond boundaries through which soil flows.
//!
//! Cells and nodes share one numbering: x fastest, one ghost layer on every side, rows of whole vectors and
//! two ghosts. Node `(i, j, k)` is the low corner of cell `(i, j, k)`, so a cell's corners and a node's cells
//! are constant offsets.

use ::kernels::layout::Layout;
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::ops::Range;

pub use ::kernels::layout::LANES;

/// Number of ghost layers beyond a cut, whose contents are the neighbour's, and beyond an open face, whose
/// contents a boundary provides. Enough for a sweep of a remap (the flux through a face looks three cells
/// away, momentum one farther) and for a round of overlap removal; a filter may look as far.
pub const GHOSTS: usize = 4;

/// A rectilinear grid, or a block of one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Grid {
    /// Positions of the cell faces along x, y, z [m], increasing; of a block with its ghost layers.
    pub faces: [Vec<f64>; 3],
    /// Positions of the cell faces of the whole grid along x, y, z [m], with the ghost layers of its open
    /// faces.
    pub whole: [Vec<f64>; 3],
    /// Layers of cells of the whole grid that are the domain; the others are ghost layers beyond its open
    /// faces.
    pub domain: [Range<usize>; 3],
    /// Layers of cells of the whole grid that this block owns.
    pub own: [Range<usize>; 3],
    /// Layer of the whole grid that is the block's first, a ghost where it is cut or open there.
    pub first: [usize; 3],
    /// Distance in memory between neighbours along x, y, z.
    pub stride: [usize; 3],
    /// Entries of an array that covers the grid with its ghosts.
    pub entries: usize,
    /// Shape of the cells in the fine zone: their widths along x, y, z over their smallest, 1 for cubes.
    aspect: DVec3,
    /// The smallest cell width, each divided by the aspect along its axis [m].
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

    /// A grid with these faces [m] and rows for vectors of `lanes` numbers, a multiple of [`LANES`].
    #[must_use]
    pub fn padded(faces: [Vec<f64>; 3], lanes: usize) -> Self {
        Self::with_open_faces(faces, [[false; 2]; 3], lanes)
    }

    /// A grid with these faces [m] and ghost layers, as wide as the outermost cells, beyond the `open` faces:
    /// by axis at the low end and at the high end.
    #[must_use]
    pub fn with_open_faces(faces: [Vec<f64>; 3], open: [[bool; 2]; 3], lanes: usize) -> Self {
        let ghosts = open.map(|ends| ends.map(|is_open| if is_open { GHOSTS } else { 0 }));
        let domain: [_; 3] =
            std::array::from_fn(|axis| ghosts[axis][0]..ghosts[axis][0] + faces[axis].len() - 1);
        let whole = std::array::from_fn(|axis| with_ghosts(&faces[axis], ghosts[axis]));
        Self::laid_out(whole, domain.clone(), domain, lanes)
    }

    /// The grid with fine cells of another shape than cubes: widths along x, y, z over their smallest.
    #[must_use]
    pub fn with_aspect(self, aspect: DVec3) -> Self {
        let along = |axis: usize| finest_of(&self.whole[axis]) / aspect[axis];
        let finest = along(0).min(along(1)).min(along(2));
        Self { aspect, finest, ..self }
    }

    /// The block of the grid that owns some of its layers of cells. Rows along x are never cut: sums over
    /// them keep their bits.
    ///
    /// # Panics
    /// When a cut block has fewer than [`GHOSTS`] layers, or is cut along x.
    #[must_use]
    pub fn block(&self, own: [Range<usize>; 3]) -> Self {
        assert!(own[0] == self.domain[0], "rows along x are never cut");
        let is_thick = |axis: usize| own[axis] == self.domain[axis] || own[axis].len() >= GHOSTS;
        assert!((0..3).all(is_thick), "a block needs {GHOSTS} layers");
        Self::laid_out(self.whole.clone(), self.domain.clone(), own, self.lanes).with_aspect(self.aspect)
    }

    fn laid_out(
        whole: [Vec<f64>; 3],
        domain: [Range<usize>; 3],
        own: [Range<usize>; 3],
        lanes: usize,
    ) -> Self {
        let first = own.each_ref().map(|own| own.start.saturating_sub(GHOSTS));
        let faces: [Vec<f64>; 3] = std::array::from_fn(|axis| {
            let end = (own[axis].end + GHOSTS).min(whole[axis].len() - 1);
            whole[axis][first[axis]..=end].to_vec()
        });
        // One ghost before, one after, and whole vectors of cells between them.
        let row = (faces[0].len() - 1).next_multiple_of(lanes) + 2;
        let plane = row * (faces[1].len() + 1);
        let entries = plane * (faces[2].len() + 1) + lanes;
        let (aspect, finest) = (DVec3::ONE, f64::NAN);
        Self { faces, whole, domain, own, first, stride: [1, row, plane], entries, aspect, finest, lanes }
            .with_aspect(aspect)
    }

    /// Whether this grid is a whole grid, not a block of one.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        self.own == self.domain
    }

    /// Part of some layers of cells of the whole grid that the block or its ghost layers hold.
    #[must_use]
    pub fn held_of(&self, layers: &[Range<usize>; 3]) -> [Range<usize>; 3] {
        std::array::from_fn(|axis| {
            let (first, its) = (self.first[axis], &layers[axis]);
            its.start.max(first)..its.end.min(first + self.cells()[axis])
        })
    }

    /// The whole grid that this is a block of.
    #[must_use]
    pub fn uncut(&self) -> Self {
        self.block(self.domain.clone())
    }

    /// How the block lies in memory.
    #[must_use]
    pub fn layout(&self) -> Layout<'_> {
        Layout { cells: self.cells(), stride: self.stride, faces: self.faces.each_ref().map(Vec::as_slice) }
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

    /// Index in memory of cell (or node) `(i, j, k)`.
    #[must_use]
    pub fn index(&self, i: usize, j: usize, k: usize) -> usize {
        (i + 1) * self.stride[0] + (j + 1) * self.stride[1] + (k + 1) * self.stride[2]
    }

    /// Cell (or node) `(i, j, k)` at an index in memory; the inverse of [`Grid::index`].
    #[must_use]
    pub fn layers_of(&self, index: usize) -> [usize; 3] {
        self.layout().layers_of(index)
    }

    /// Number of rows in a plane of the memory, ghosts among them.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.layout().rows()
    }

    /// Row within its plane, and plane, of a row of the memory; those of cell `(i, j, k)` are j + 1 and k +
    /// 1.
    #[must_use]
    pub fn row_and_plane(&self, row: usize) -> [usize; 2] {
        self.layout().row_and_plane(row)
    }

    /// Ends of the domain along `axis` [m].
    #[must_use]
    pub fn ends(&self, axis: usize) -> [f64; 2] {
        let (faces, domain) = (&self.whole[axis], &self.domain[axis]);
        [faces[domain.start], faces[domain.end]]
    }

    /// Number of cells of the whole grid along x, y, z, with the ghost layers of its open faces.
    #[must_use]
    pub fn whole_cells(&self) -> [usize; 3] {
        self.whole.each_ref().map(|faces| faces.len() - 1)
    }

    /// Whether another block follows along `axis`, at the low end (0) or the high end (1).
    #[must_use]
    pub fn is_cut(&self, axis: usize, end: usize) -> bool {
        let (own, domain) = (&self.own[axis], &self.domain[axis]);
        if end == 0 { own.start > domain.start } else { own.end < domain.end }
    }

    /// Layers of the block that belong to the domain, with the ghost layers of cuts, along `axis`.
    #[must_use]
    pub fn inside(&self, axis: usize) -> Range<usize> {
        let (domain, first) = (&self.domain[axis], self.first[axis]);
        domain.start.saturating_sub(first)..(domain.end - first).min(self.cells()[axis])
    }

    /// Ghost layers of the block beyond an open face, at the low end (0) or the high end (1); none where it
    /// is not open.
    #[must_use]
    pub fn outside(&self, axis: usize, end: usize) -> Range<usize> {
        let inside = self.inside(axis);
        if end == 0 { 0..inside.start } else { inside.end..self.cells()[axis] }
    }

    /// Whether a cell of the memory lies in the domain, or in the ghost layers of a cut.
    #[must_use]
    pub fn is_in_domain(&self, cell: usize) -> bool {
        let layers = self.layers_of(cell);
        (0..3).all(|axis| self.inside(axis).contains(&layers[axis]))
    }

    /// Whether the block owns a layer of the whole grid along `axis`, or has it as the ghost layer of an open
    /// face beside its own.
    #[must_use]
    pub fn accounts_for(&self, axis: usize, whole: usize) -> bool {
        let (own, domain) = (&self.own[axis], &self.domain[axis]);
        own.contains(&whole)
            || (whole < domain.start && own.start == domain.start)
            || (whole >= domain.end && own.end == domain.end)
    }

    /// Layers of cells of the whole grid that the block accounts for along `axis` (see
    /// [`Grid::accounts_for`]).
    #[must_use]
    pub fn accounted(&self, axis: usize) -> Range<usize> {
        let (own, domain) = (&self.own[axis], &self.domain[axis]);
        let start = if own.start == domain.start { 0 } else { own.start };
        start..if own.end == domain.end { self.whole_cells()[axis] } else { own.end }
    }

    /// Whether a row of the memory, `[q, plane]`, is one of cells in the domain or in the ghost layers of a
    /// cut.
    #[must_use]
    pub fn is_inside(&self, [q, plane]: [usize; 2]) -> bool {
        let contains = |axis: usize, n: usize| n > 0 && self.inside(axis).contains(&(n - 1));
        contains(1, q) && contains(2, plane)
    }

    /// Columns of a row that are strained: those in the domain, with the ones that pad the row where no ghost
    /// layers follow.
    #[must_use]
    pub fn strained_columns(&self) -> Range<usize> {
        let inside = self.inside(0);
        if inside == (0..self.cells()[0]) { 0..self.padded_row() } else { inside }
    }

    /// Whether soil flows through a face of the domain.
    #[must_use]
    pub fn has_open_faces(&self) -> bool {
        (0..3).any(|axis| self.domain[axis] != (0..self.whole_cells()[axis]))
    }

    /// Layers of the whole grid from those of the block.
    #[must_use]
    pub fn in_whole(&self, [i, j, k]: [usize; 3]) -> [usize; 3] {
        [i + self.first[0], j + self.first[1], k + self.first[2]]
    }

    /// Layers of the block from those of a cell of the whole grid, if the block or its ghost layers hold it.
    #[must_use]
    pub fn in_block(&self, whole: [usize; 3]) -> Option<[usize; 3]> {
        self.below(whole, self.cells())
    }

    /// Index in memory of a node of the whole grid, if the block or its ghost layers hold it.
    #[must_use]
    pub fn node_index(&self, whole: [usize; 3]) -> Option<usize> {
        let nodes = self.cells().map(|n| n + 1);
        self.below(whole, nodes).map(|[i, j, k]| self.index(i, j, k))
    }

    /// Layers of the block from those of the whole grid, if they are among so many.
    fn below(&self, whole: [usize; 3], count: [usize; 3]) -> Option<[usize; 3]> {
        let mut layers = [0; 3];
        for axis in 0..3 {
            layers[axis] = whole[axis].checked_sub(self.first[axis]).filter(|n| *n < count[axis])?;
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
        let is_last =
            |axis: usize| whole[axis] == self.own[axis].end && self.own[axis].end == self.domain[axis].end;
        (0..3).all(|axis| self.own[axis].contains(&whole[axis]) || is_last(axis))
    }

    /// Number of the row of the whole grid that a row of the memory is, if the block owns it. Rows of nodes
    /// at a cut belong to the block above it.
    #[must_use]
    pub fn owned_row(&self, row: usize) -> Option<usize> {
        let [q, plane] = self.row_and_plane(row);
        let cells = self.whole_cells();
        let layer = |axis: usize, n: usize| {
            let (layer, own) = (n.checked_sub(1)? + self.first[axis], &self.own[axis]);
            let is_last = layer == own.end && own.end == self.domain[axis].end;
            (own.contains(&layer) || is_last).then_some(layer)
        };
        Some(layer(2, plane)? * (cells[1] + 1) + layer(1, q)?)
    }

    /// Whether a row of cells of the memory, `[q, plane]`, lies next to nodes of this block: of the ghost
    /// layers beyond a cut, the first one only.
    #[must_use]
    pub fn is_beside_own(&self, [q, plane]: [usize; 2]) -> bool {
        [(1, q), (2, plane)].into_iter().all(|(axis, n)| {
            let own = &self.own[axis];
            let is_near_low = !self.is_cut(axis, 0) || n + self.first[axis] >= own.start;
            let is_near_high = !self.is_cut(axis, 1) || n + self.first[axis] <= own.end + 1;
            is_near_low && is_near_high
        })
    }

    /// Width of cell layer `n` along `axis` [m].
    #[must_use]
    pub fn width(&self, axis: usize, n: usize) -> f64 {
        self.layout().width(axis, n)
    }

    /// Middle of cell layer `n` along `axis` [m].
    #[must_use]
    pub fn centre(&self, axis: usize, n: usize) -> f64 {
        0.5 * (self.faces[axis][n + 1] + self.faces[axis][n])
    }

    /// Volume of cell `(i, j, k)` [m³].
    #[must_use]
    pub fn volume(&self, i: usize, j: usize, k: usize) -> f64 {
        self.layout().volume(i, j, k)
    }

    /// Volume of the cell at an index in memory [m³].
    #[must_use]
    pub fn volume_of(&self, index: usize) -> f64 {
        let [i, j, k] = self.layers_of(index);
        self.volume(i, j, k)
    }

    /// Volume of the dual cell of a node: an eighth of each cell round it [m³].
    #[must_use]
    pub fn volume_round(&self, node: [usize; 3]) -> f64 {
        let width = |axis: usize| {
            let n = node[axis];
            let low = if n > 0 { self.width(axis, n - 1) } else { 0.0 };
            let high = if n < self.cells()[axis] { self.width(axis, n) } else { 0.0 };
            0.5 * (low + high)
        };
        (0..3).map(width).product()
    }

    /// The smallest cell width of the whole grid along `axis` [m].
    #[must_use]
    pub fn finest_along(&self, axis: usize) -> f64 {
        finest_of(&self.whole[axis])
    }

    /// The smallest cell width of the whole grid [m]. Where cells are not cubes: such that along every axis
    /// the smallest is this times the aspect, or more.
    #[must_use]
    pub fn finest(&self) -> f64 {
        self.finest
    }

    /// Shape of the cells in the fine zone: their widths along x, y, z over their smallest, 1 for cubes.
    #[must_use]
    pub fn aspect(&self) -> DVec3 {
        self.aspect
    }

    /// Whether the cells of the fine zone are cubes.
    #[must_use]
    pub fn has_cubes(&self) -> bool {
        self.aspect == DVec3::ONE
    }

    /// Least widths of a cell along x, y, z [m]: the smallest, times the aspect.
    #[must_use]
    pub fn fine_cell(&self) -> DVec3 {
        self.finest * self.aspect
    }

    /// Length of the line of direction `normal`, a unit vector, through a cell over its smallest width: of an
    /// ellipsoid with the cell's widths. Exactly 1 for cubes.
    #[must_use]
    pub fn length_along(&self, normal: DVec3) -> f64 {
        1.0 / (1.0 + (normal * normal).dot(self.aspect.powf(-2.0) - 1.0)).sqrt()
    }

    /// Distance between the two planes of this normal, a unit vector, that enclose a cell, over its smallest
    /// width: again of the ellipsoid. Exactly 1 for cubes.
    #[must_use]
    pub fn depth_along(&self, normal: DVec3) -> f64 {
        (1.0 + (normal * normal).dot(self.aspect * self.aspect - 1.0)).sqrt()
    }

    /// Smallest width of a cell [m], each divided by the aspect along its axis.
    #[must_use]
    pub fn smallest_width(&self, widths: DVec3) -> f64 {
        (widths / self.aspect).min_element()
    }

    /// The axis along which a surface of this normal cuts the fewest layers of cells: that of the largest
    /// component in units of the cell's widths.
    #[must_use]
    pub fn main_axis(&self, normal: DVec3) -> usize {
        let size = (normal * self.aspect).abs();
        if size.x >= size.y && size.x >= size.z {
            0
        } else if size.y >= size.z {
            1
        } else {
            2
        }
    }
}

/// How much longer a step may be in cells of a shape than in cubes of their smallest width; exactly 1 for
/// cubes.
///
/// The highest frequency of a cell is at most 2 c √(Σ 1/hᵢ²) (Flanagan & Belytschko 1984): the step stays the
/// same fraction of the stable one.
#[must_use]
pub fn longer_step(aspect: DVec3) -> f64 {
    (3.0 / (1.0 / (aspect * aspect)).element_sum()).sqrt()
}

/// The smallest distance between neighbouring faces [m].
#[must_use]
pub fn finest_of(faces: &[f64]) -> f64 {
    faces.windows(2).map(|w| w[1] - w[0]).fold(f64::INFINITY, f64::min)
}

/// Face positions with so many ghost layers, as wide as the outermost cells, at the low end and at the high
/// end.
fn with_ghosts(faces: &[f64], [low, high]: [usize; 2]) -> Vec<f64> {
    let n = faces.len();
    let [first, last] = [faces[1] - faces[0], faces[n - 1] - faces[n - 2]];
    let below = (1..=low).rev().map(|layer| faces[0] - layer as f64 * first);
    let above = (1..=high).map(|layer| faces[n - 1] + layer as f64 * last);
    below.chain(faces.iter().copied()).chain(above).collect()
}
