//! A portion of the soil and its nodes: what blocks pass on to each other, and what each of them writes.

use crate::grid::Grid;
use crate::halo::Halo;
use crate::halo::decomposition::Decomposition;
use crate::scalar::Scalar;
use crate::state::State;
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Soil and nodes of some layers of a grid.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Portion<R> {
    /// Layers of cells of the whole grid along x, y, z; of nodes there is one more along each.
    pub layers: [Range<usize>; 3],
    /// The arrays of the soil, x fastest.
    cells: Vec<Vec<R>>,
    /// The arrays of the nodes, x fastest.
    nodes: Vec<Vec<R>>,
}

/// Starts of the rows of some layers in an array that covers a grid, with `beyond` layers more at the high
/// ends.
fn rows(grid: &Grid, layers: &[Range<usize>; 3], beyond: usize) -> impl Iterator<Item = usize> {
    let [x, y, z] = grid.first;
    let [columns, rows, planes] = layers.clone();
    let starts = move |k: usize| {
        let rows = rows.start..rows.end + beyond;
        rows.map(move |j| [j - y, k - z])
    };
    let first = columns.start - x;
    let all = (planes.start..planes.end + beyond).flat_map(starts);
    all.map(move |[j, k]| grid.index(first, j, k))
}

impl<R: Copy + Default> State<R> {
    /// Soil and nodes of some layers of the whole grid, all of which the block holds.
    #[must_use]
    pub fn portion(&self, block: &Grid, layers: [Range<usize>; 3]) -> Portion<R> {
        let take = |from: &Vec<R>, beyond: usize| -> Vec<R> {
            let length = layers[0].len() + beyond;
            rows(block, &layers, beyond)
                .flat_map(|start| from[start..start + length].iter().copied())
                .collect()
        };
        let cells = self.soil.arrays().map(|field| take(field, 0)).collect();
        let nodes = self.nodes.arrays().map(|field| take(field, 1)).collect();
        Portion { layers, cells, nodes }
    }

    /// Takes over what the block holds of a portion.
    pub fn put(&mut self, block: &Grid, portion: &Portion<R>) {
        let shared = block.held_of(&portion.layers);
        if shared.iter().any(Range::is_empty) {
            return;
        }
        let copy = |from: &Vec<R>, to: &mut Vec<R>, beyond: usize| {
            let length = shared[0].len() + beyond;
            let theirs = portion.rows(&shared, beyond);
            for (here, there) in rows(block, &shared, beyond).zip(theirs) {
                to[here..here + length].copy_from_slice(&from[there..there + length]);
            }
        };
        portion.cells.iter().zip(self.soil.arrays_mut()).for_each(|(from, to)| copy(from, to, 0));
        portion.nodes.iter().zip(self.nodes.arrays_mut()).for_each(|(from, to)| copy(from, to, 1));
    }
}

impl<R: Scalar> State<R> {
    /// The state of the block that a process gets as the grid is cut anew, with the grid of that; all
    /// processes must call this. Soil passes from block to block, and no process holds more than its own.
    #[must_use]
    pub fn recut(&self, block: &Grid, cut: &Decomposition, halo: &Halo) -> (Grid, Self) {
        let whole = block.uncut();
        let accounted = [0, 1, 2].map(|axis| block.accounted(axis));
        let for_block = |number: usize| {
            let other = whole.block(cut.own(number));
            let shared = other.held_of(&accounted);
            let is_any = shared.iter().all(|layers| !layers.is_empty());
            if is_any { self.portion(block, shared).to_numbers() } else { Vec::new() }
        };
        let received = halo.deliver((0..cut.count()).map(for_block).collect());
        let own = whole.block(cut.own(halo.rank()));
        let arrays = [self.soil.arrays().count(), self.nodes.arrays().count()];
        let mut state = self.without_soil(&own);
        for numbers in received.into_iter().filter(|numbers| !numbers.is_empty()) {
            state.put(&own, &Portion::of_numbers(&numbers, arrays));
        }
        (own, state)
    }
}

impl<R> Portion<R> {
    /// Whether the layers of the portion are some of the whole grid, and its arrays those of a state, with as
    /// many entries as the layers have cells and nodes: one that was read may be otherwise.
    #[must_use]
    pub fn is_of(&self, state: &State<R>, grid: &Grid) -> bool {
        let mut layers = self.layers.iter().zip(grid.whole_cells());
        let is_within = layers.all(|(own, all)| own.start < own.end && own.end <= all);
        let all = |arrays: &[Vec<R>], beyond: usize| {
            let count: usize = self.layers.iter().map(|own| own.len() + beyond).product();
            arrays.iter().all(|array| array.len() == count)
        };
        is_within
            && [self.cells.len(), self.nodes.len()]
                == [state.soil.arrays().count(), state.nodes.arrays().count()]
            && all(&self.cells, 0)
            && all(&self.nodes, 1)
    }

    /// Starts of the rows of some of its layers in its own arrays.
    fn rows(&self, layers: &[Range<usize>; 3], beyond: usize) -> impl Iterator<Item = usize> {
        let [nx, ny, _] = self.layers.each_ref().map(|own| own.len() + beyond);
        let [x, y, z] = self.layers.each_ref().map(|own| own.start);
        let [columns, rows, planes] = layers.clone();
        let first = columns.start - x;
        let each = (planes.start..planes.end + beyond)
            .flat_map(move |k| (rows.start..rows.end + beyond).map(move |j| [j - y, k - z]));
        each.map(move |[j, k]| (k * ny + j) * nx + first)
    }
}

impl<R: Scalar> Portion<R> {
    /// All numbers of the portion: layers, and the arrays one after the other.
    #[must_use]
    pub fn to_numbers(&self) -> Vec<f64> {
        let layers = self.layers.iter().flat_map(|own| [own.start as f64, own.end as f64]);
        let arrays = self.cells.iter().chain(&self.nodes).flatten().map(|value| value.to_f64());
        layers.chain(arrays).collect()
    }

    /// The portion of these numbers; `cells` and `nodes` are the numbers of arrays.
    #[must_use]
    pub fn of_numbers(numbers: &[f64], [cells, nodes]: [usize; 2]) -> Self {
        let (ends, mut rest) = numbers.split_at(6);
        let layers: [Range<usize>; 3] =
            std::array::from_fn(|axis| ends[2 * axis] as usize..ends[2 * axis + 1] as usize);
        let mut take = |beyond: usize| -> Vec<R> {
            let count = layers.iter().map(|own| own.len() + beyond).product();
            let (own, after) = rest.split_at(count);
            rest = after;
            own.iter().map(|value| R::cast(*value)).collect()
        };
        let cells = (0..cells).map(|_| take(0)).collect();
        let nodes = (0..nodes).map(|_| take(1)).collect();
        Self { layers, cells, nodes }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fields::{Kinds, Nodes, Soil};
    use crate::state::{EnergyBalance, MechanismState};
    use glam::DVec3;

    #[test]
    fn a_portion_of_other_layers_or_arrays_is_none_of_the_state() {
        let grid = Grid::new([1, 2, 3].map(|cells| (0..=cells).map(f64::from).collect()));
        let mut state = State::<f64> {
            time: 0.0,
            step: 0,
            grid_position: DVec3::ZERO,
            soil: Soil::empty(&grid, 2, Kinds::default()),
            nodes: Nodes::at_rest(&grid),
            bodies: Vec::new(),
            mechanism: MechanismState::default(),
            contacts: Vec::new(),
            remaps: 0,
            energy_balance: EnergyBalance::default(),
        };
        let sound = state.portion(&grid, [0..1, 0..2, 1..3]);
        assert!(sound.is_of(&state, &grid));
        state.put(&grid, &sound);
        let harms: [fn(&mut Portion<f64>); 6] = [
            |portion| portion.layers[1] = 0..usize::MAX,
            |portion| portion.layers[1] = 0..3,
            |portion| portion.layers[1] = Range { start: 2, end: 0 },
            |portion| drop(portion.cells.pop()),
            |portion| portion.nodes.clear(),
            |portion| portion.nodes[0].truncate(1),
        ];
        for (n, harm) in harms.into_iter().enumerate() {
            let mut harmed = sound.clone();
            harm(&mut harmed);
            assert!(!harmed.is_of(&state, &grid), "{n}");
        }
    }
}
