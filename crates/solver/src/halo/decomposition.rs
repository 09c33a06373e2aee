//! Decomposition of a grid into blocks along y and z, one for each process.

use crate::grid::{GHOSTS, Grid};
use std::ops::Range;

/// A grid cut along y and z into blocks, numbered with y fastest.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Decomposition {
    /// Layers of cells of the whole grid in each slab along y, and in each along z.
    slabs: [Vec<Range<usize>>; 2],
    /// Layers of cells of the whole grid along x: rows are never cut.
    columns: Range<usize>,
}

/// A block that touches another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Neighbour {
    /// Number of the neighbour's process.
    pub rank: usize,
    /// Where the neighbour lies along y and z: −1 at the low end, 1 at the high end, 0 in the same layers.
    pub side: [i32; 2],
}

impl Decomposition {
    /// Cuts a grid before the given layers of its domain along y and z.
    #[must_use]
    pub fn cut(whole: &Grid, before: [&[usize]; 2]) -> Self {
        let slabs = |axis: usize| -> Vec<Range<usize>> {
            let domain = &whole.domain[axis];
            let ends = before[axis - 1].iter().map(|layer| domain.start + layer).chain([domain.end]);
            ends.scan(domain.start, |start, end| Some(std::mem::replace(start, end)..end)).collect()
        };
        Self { slabs: [slabs(1), slabs(2)], columns: whole.domain[0].clone() }
    }

    /// Cuts a grid into a number of blocks of about the same cost; `cost` is that of each row of cells of the
    /// domain, y fastest. Of the ways to do so it takes the one whose costliest block costs least, and of
    /// those the one with the fewest cells at cuts. `None` where there are too few layers for so many blocks.
    #[must_use]
    pub fn by_cost(whole: &Grid, blocks: usize, cost: &[f64]) -> Option<Self> {
        let [_, rows, planes] = whole.domain.each_ref().map(Range::len);
        let by_row: Vec<f64> = (0..rows).map(|j| (0..planes).map(|k| cost[k * rows + j]).sum()).collect();
        let by_plane: Vec<f64> = (0..planes).map(|k| cost[k * rows..(k + 1) * rows].iter().sum()).collect();
        let ways = (1..=blocks).filter(|along_y| blocks.is_multiple_of(*along_y));
        let cuts = ways.filter_map(|along_y| {
            let along_z = blocks / along_y;
            let [y, z] = [balanced(&by_row, along_y)?, balanced(&by_plane, along_z)?];
            let cut = Self::cut(whole, [&y, &z]);
            let at_cuts = (y.len() * planes + z.len() * rows) as f64;
            Some((cut.highest(whole, cost), at_cuts, cut))
        });
        let best = cuts.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
        best.map(|(_, _, cut)| cut)
    }

    /// Cost of the costliest block; `cost` as in [`Decomposition::by_cost`].
    #[must_use]
    pub fn highest(&self, whole: &Grid, cost: &[f64]) -> f64 {
        let rows = whole.domain[1].len();
        let [y, z] = [1, 2].map(|axis| whole.domain[axis].start);
        let of_block = |number: usize| -> f64 {
            let [_, own_y, own_z] = self.own(number);
            own_z.map(|k| own_y.clone().map(|j| cost[(k - z) * rows + j - y]).sum::<f64>()).sum()
        };
        (0..self.count()).map(of_block).fold(0.0, f64::max)
    }

    /// Number of blocks.
    #[must_use]
    pub fn count(&self) -> usize {
        self.slabs[0].len() * self.slabs[1].len()
    }

    /// Number of blocks along y and along z.
    #[must_use]
    pub fn blocks(&self) -> [usize; 2] {
        self.slabs.each_ref().map(Vec::len)
    }

    /// Layers of cells of the whole grid that a block owns.
    #[must_use]
    pub fn own(&self, number: usize) -> [Range<usize>; 3] {
        let [j, k] = self.place(number);
        [self.columns.clone(), self.slabs[0][j].clone(), self.slabs[1][k].clone()]
    }

    /// The blocks that touch one, along y and z and across its edges.
    #[must_use]
    pub fn neighbours(&self, number: usize) -> Vec<Neighbour> {
        let (at, count) = (self.place(number), self.blocks());
        let step =
            |axis: usize, side: i32| at[axis].checked_add_signed(side as isize).filter(|n| *n < count[axis]);
        let sides = (-1..=1).flat_map(|z| (-1..=1).map(move |y| [y, z])).filter(|side| *side != [0, 0]);
        let beside = |side: [i32; 2]| Some((step(0, side[0])?, step(1, side[1])?));
        sides
            .filter_map(|side| beside(side).map(|(j, k)| Neighbour { rank: k * count[0] + j, side }))
            .collect()
    }

    /// Numbers of blocks beyond one along y and z, at the low end and at the high end.
    #[must_use]
    pub fn beyond(&self, number: usize) -> [[usize; 2]; 2] {
        let at = self.place(number);
        std::array::from_fn(|axis| [at[axis], self.slabs[axis].len() - 1 - at[axis]])
    }

    /// Place of a block along y and z.
    fn place(&self, number: usize) -> [usize; 2] {
        [number % self.slabs[0].len(), number / self.slabs[0].len()]
    }
}

/// Cuts layers into slabs of at least [`GHOSTS`] so that the costliest costs as little as cuts at the nearest
/// layers allow: the layers before which they lie.
fn balanced(cost: &[f64], slabs: usize) -> Option<Vec<usize>> {
    if slabs > 1 && slabs * GHOSTS > cost.len() {
        return None;
    }
    let total: f64 = cost.iter().sum();
    let (mut layer, mut sum, mut cuts) = (0, 0.0, Vec::with_capacity(slabs - 1));
    for slab in 1..slabs {
        let due = total * slab as f64 / slabs as f64;
        while layer < cost.len() && sum + 0.5 * cost[layer] < due {
            sum += cost[layer];
            layer += 1;
        }
        let low = cuts.last().copied().unwrap_or(0) + GHOSTS;
        cuts.push(layer.clamp(low, cost.len() - (slabs - slab) * GHOSTS));
    }
    Some(cuts)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(rows: usize, planes: usize) -> Grid {
        let faces = |n: usize| (0..=n).map(|face| face as f64).collect();
        Grid::new([faces(8), faces(rows), faces(planes)])
    }

    #[test]
    fn blocks_know_their_layers_and_neighbours() {
        let cut = Decomposition::cut(&grid(12, 10), [&[4, 8], &[6]]);
        assert_eq!((cut.count(), cut.blocks()), (6, [3, 2]));
        assert_eq!(cut.own(4), [0..8, 4..8, 6..10]);
        let of = |number: usize| cut.neighbours(number).iter().map(|n| (n.rank, n.side)).collect::<Vec<_>>();
        assert_eq!(of(4), [(0, [-1, -1]), (1, [0, -1]), (2, [1, -1]), (3, [-1, 0]), (5, [1, 0])]);
        assert_eq!(of(0), [(1, [1, 0]), (3, [0, 1]), (4, [1, 1])]);
    }

    #[test]
    fn cuts_follow_the_cost() {
        // All the work is in the upper half and at low y.
        let whole = grid(16, 16);
        let cost: Vec<f64> =
            (0..256).map(|row| if row % 16 < 8 && row / 16 >= 8 { 1.0 } else { 0.0 }).collect();
        let cut = Decomposition::by_cost(&whole, 4, &cost).expect("there are enough layers");
        assert_eq!(cut.highest(&whole, &cost), 16.0);
        let two = Decomposition::by_cost(&whole, 2, &cost).expect("there are enough layers");
        assert_eq!(two.highest(&whole, &cost), 32.0);
        assert_eq!(Decomposition::by_cost(&whole, 17, &cost), None);
        assert_eq!(Decomposition::by_cost(&whole, 1, &cost).map(|cut| cut.count()), Some(1));
        // Prime numbers of blocks, too.
        assert_eq!(Decomposition::by_cost(&whole, 3, &cost).map(|cut| cut.count()), Some(3));
    }
}
