//! Scratch memory of the loops over cells; nothing in it must survive a step.

use super::partition::{RowPartition, SerialFallback, Throughput};
use super::stage_sums::{RowSums, StageSums};
use super::stopwatch::Stopwatch;
use super::threads::{Crew, MAX_WORKERS, Team};
use crate::exact_sum::{ExactSum, over_blocks};
use crate::fields::{Soil, mass_as_main};
use crate::grid::Grid;
use crate::halo::Halo;
use crate::model::Model;
use crate::scalar::Scalar;
use crate::state::State;
use ::kernels::sums::{COEFFICIENTS, NODE_SUMS};

/// Threads, scratch arrays, and which rows hold soil.
pub struct SoilWorkspace<R: Scalar> {
    pub(crate) team: Team,
    /// The device that strains the soil, if it is not the processor.
    pub(crate) device: Option<R::OnDevice>,
    /// Partition of the rows of memory planes 1 to nz + 1 (nodes, and the cells above them).
    pub(crate) partition: RowPartition,
    /// First row of nodes that contact needs, if this is one of several blocks and has any: the rows from
    /// there on are strained first, so that the other blocks get them early.
    pub(crate) contact_from: Option<usize>,
    /// Number of portions of the rows before these; 0 where all are strained together.
    pub(crate) far_portions: usize,
    /// Whether one thread alone would be faster.
    pub(crate) serial_fallback: SerialFallback,
    /// Cost of each row at the last rebalancing.
    pub(crate) costs: Vec<f64>,
    /// Whether a row of cells holds soil, in memory order.
    pub(crate) row_has_soil: Vec<bool>,
    /// Whether a row of cells is strained: it holds soil, and nodes of this block lie beside it.
    pub(crate) row_is_strained: Vec<bool>,
    /// Number of the main material of each cell; empty where there is only one material.
    pub(crate) material: Vec<u8>,
    /// Mass of each cell if all its soil were of its main material (see [`mass_as_main`]); empty where there
    /// is only one material.
    pub(crate) mass_as_main: Vec<R>,
    /// Densities of the undeformed materials [kg/m³].
    pub(crate) densities: Vec<f64>,
    /// Constants of the materials.
    pub(crate) materials: R::Materials,
    /// How many of the two velocity arrays are known to be zero where there is no soil.
    pub(crate) clear: u8,
    /// Nodal velocities of the previous step. Between steps their memory serves others: the remap, and, from
    /// the remap until the contact search, in the first array the body volume fractions.
    pub(crate) velocity_before: [Vec<R>; 3],
    /// Averages of soil with a characteristic length; empty without.
    pub(crate) averages: [[Vec<R>; 2]; 2],
    /// Scratch memory of each portion of the rows: the first ones belong to a thread each, the small ones
    /// after them to whoever is ready first.
    pub(crate) portions: Vec<PortionScratch<R>>,
    /// Sums over each row in the Lagrangian stage.
    pub(crate) row_sums: Vec<RowSums>,
    /// Two values for each row, to be summed.
    pub(crate) row_values: Vec<[f64; 2]>,
    /// Widths of the cell layers along x [m] in memory order (0 in ghosts), and ¼ of their inverses [1/m].
    pub(crate) width_x: [Vec<R>; 2],
}

impl<R: Scalar> std::fmt::Debug for SoilWorkspace<R> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "SoilWorkspace for {:?}", self.team)
    }
}

/// Scratch memory of a portion of the rows, aligned against false sharing: it is written in every row.
#[repr(align(128))]
pub(crate) struct PortionScratch<R: Scalar> {
    /// Force coefficients of two successive rows of cells.
    pub(crate) coefficients: [Coefficients<R>; 2],
    /// Force coefficients of the portion's first row.
    pub(crate) first: Coefficients<R>,
    /// Force and damping (four rows for each row of nodes) exerted on a plane of nodes by the cells below it.
    pub(crate) below: Vec<R>,
    /// Force and damping, row by row, of the portion's first nodes that wait for cells of another one; those
    /// of the first portion do not.
    pub(crate) waiting: Vec<R>,
    /// Row buffers of the nodes.
    pub(crate) row: Vec<R>,
    /// Scratch memory for a block of cells.
    pub(crate) block: Box<R::CellBlock>,
    /// Sums over the portion's rows in the Lagrangian stage.
    pub(crate) sums: StageSums,
    /// Dissipation of the portion's cells beyond boundaries at constant stress in the Lagrangian stage [J].
    pub(crate) dissipated_beyond: ExactSum,
    /// Throughput of the thread to which the portion belongs.
    pub(crate) throughput: Throughput,
    /// Time by stage.
    pub(crate) stopwatch: Stopwatch,
}

impl<R: Scalar> PortionScratch<R> {
    fn new(grid: &Grid, has_to_wait: bool) -> Self {
        let [_, row, plane] = grid.stride;
        let coefficients = || Coefficients { values: vec![R::default(); COEFFICIENTS * row], are_zero: true };
        Self {
            coefficients: [coefficients(), coefficients()],
            first: coefficients(),
            below: vec![R::default(); NODE_SUMS * plane],
            waiting: vec![R::default(); if has_to_wait { NODE_SUMS * (plane + row) } else { 0 }],
            row: vec![R::default(); ROW_BUFFERS * row],
            block: R::cell_block(),
            sums: StageSums::default(),
            dissipated_beyond: ExactSum::default(),
            throughput: Throughput::default(),
            stopwatch: Stopwatch::default(),
        }
    }
}

/// Force coefficients of a row of cells.
pub(crate) struct Coefficients<R> {
    /// Row after row.
    pub(crate) values: Vec<R>,
    /// Whether all coefficients are zero.
    pub(crate) are_zero: bool,
}

impl<R: Copy> Coefficients<R> {
    /// Copies the coefficients of another row.
    pub(crate) fn copy_from(&mut self, other: &Self) {
        self.values.copy_from_slice(&other.values);
        self.are_zero = other.are_zero;
    }
}

/// Number of row buffers in the Lagrangian stage.
pub(crate) const ROW_BUFFERS: usize = 6;

impl<R: Scalar> SoilWorkspace<R> {
    /// Workspace for a model and a team of `threads`.
    #[must_use]
    pub(crate) fn new(model: &Model, state: &State<R>, threads: usize) -> Self {
        let grid = &model.grid;
        let [_, row, plane] = grid.stride;
        let (planes, rows) = (grid.cells()[2] + 1, plane / row);
        let least = rows + 1;
        let threads = team_size(grid, threads);
        let portions = portion_count(grid, threads);
        let averaged = if model.has_characteristic_length() { grid.entries } else { 0 };
        let mut workspace = Self {
            team: Team::new(threads),
            device: None,
            partition: RowPartition::new(rows, &vec![1.0; planes * rows], [portions, least], row),
            contact_from: None,
            far_portions: 0,
            serial_fallback: SerialFallback::default(),
            costs: vec![0.0; planes * rows],
            row_has_soil: vec![false; rows * (planes + 1)],
            row_is_strained: vec![false; rows * (planes + 1)],
            material: Vec::new(),
            mass_as_main: Vec::new(),
            densities: model.densities(),
            materials: R::materials(model),
            clear: 0,
            velocity_before: state.nodes.velocity.clone(),
            averages: std::array::from_fn(|_| std::array::from_fn(|_| vec![R::default(); averaged])),
            portions: (0..portions).map(|n| PortionScratch::new(grid, n > 0)).collect(),
            row_sums: vec![RowSums::default(); rows * (planes + 1)],
            row_values: vec![[0.0; 2]; rows * (planes + 1)],
            width_x: column_widths(grid),
        };
        workspace.find_soil(grid, &state.soil);
        workspace
    }

    /// Moves the arrays of a state, one after the other, to memory that is first touched by the workers that
    /// will use it: on a machine with several memory nodes it is then near them.
    pub(crate) fn settle(&mut self, state: &mut State<R>) {
        if self.threads() == 1 {
            return;
        }
        let Self { team, partition, velocity_before, .. } = self;
        let own = state.soil.arrays_mut().chain(state.nodes.arrays_mut());
        own.chain(velocity_before).for_each(|array| settle(team, partition, array));
    }

    /// The masses from which laws take their density, with those of the cells [kg]: of the main material
    /// where there are several.
    pub(crate) fn mass_of_laws<'a>(&'a self, mass: &'a [R]) -> &'a [R] {
        if self.mass_as_main.is_empty() { mass } else { &self.mass_as_main }
    }

    /// Number of threads.
    #[must_use]
    pub(crate) fn threads(&self) -> usize {
        self.team.size()
    }

    /// Time by stage of the calling thread.
    pub(crate) fn stopwatch(&mut self) -> &mut Stopwatch {
        &mut self.portions[0].stopwatch
    }

    /// Memory in use [bytes].
    #[must_use]
    pub(crate) fn memory(&self) -> usize {
        let own = |w: &PortionScratch<R>| {
            let coefficients = w.coefficients.iter().chain([&w.first]).map(|c| &c.values);
            let rows = coefficients.chain([&w.below, &w.waiting, &w.row]);
            rows.map(|row| size_of_val(row.as_slice())).sum::<usize>() + size_of_val(&*w.block)
        };
        let averages = self.averages.iter().flatten().chain([&self.mass_as_main]);
        self.velocity_before.iter().chain(averages).map(|field| size_of_val(field.as_slice())).sum::<usize>()
            + self.portions.iter().map(own).sum::<usize>()
            + size_of_val(self.row_sums.as_slice())
            + size_of_val(self.costs.as_slice())
            + size_of_val(self.row_has_soil.as_slice())
            + size_of_val(self.row_is_strained.as_slice())
            + size_of_val(self.material.as_slice())
            + size_of_val(self.row_values.as_slice())
    }

    /// Sums of the two values by row over the whole grid.
    pub(crate) fn total_of_rows(&self, grid: &Grid, halo: &Halo) -> [f64; 2] {
        let mut sums = [ExactSum::default(); 2];
        for (row, values) in self.row_values.iter().enumerate() {
            if grid.owned_row(row).is_some() {
                sums.iter_mut().zip(values).for_each(|(sum, value)| sum.add(*value));
            }
        }
        over_blocks(halo, sums)
    }

    /// Sums of the Lagrangian stage over the block.
    pub(crate) fn sums_of_stage(&self) -> StageSums {
        let mut each = self.portions.iter().take(self.partition.ranges().len()).map(|portion| &portion.sums);
        let first = each.next().copied().unwrap_or_default();
        each.fold(first, StageSums::merge)
    }

    /// The threads at work, for loops other than over rows.
    pub(crate) fn crew(&self) -> Crew<'_> {
        Crew::of(&self.team, &self.partition)
    }

    /// Finds which rows hold soil, and of which material; then rebalances the partition.
    pub(crate) fn find_soil(&mut self, grid: &Grid, soil: &Soil<R>) {
        if !soil.composition.is_empty() {
            let Soil { composition, mass, .. } = soil;
            self.material.clear();
            self.material.extend((0..grid.entries).map(|c| soil.main_material(c) as u8));
            let as_main = |c: usize| mass_as_main(composition, &self.densities, mass[c].to_f64(), c);
            self.mass_as_main.clear();
            self.mass_as_main.extend((0..grid.entries).map(|c| R::cast(as_main(c))));
        }
        for (n, cells) in soil.fraction.chunks_exact(grid.stride[1]).take(self.row_has_soil.len()).enumerate()
        {
            self.row_has_soil[n] = cells.iter().any(|f| *f > R::default());
            self.row_is_strained[n] = self.row_has_soil[n] && grid.is_beside_own(grid.row_and_plane(n));
            if !self.row_is_strained[n] {
                self.row_sums[n] = RowSums::default();
            }
        }
        self.rebalance(grid);
    }

    /// Cost of each row of cells that the block owns, y fastest.
    pub(crate) fn costs_of_own(&self, grid: &Grid) -> Vec<f64> {
        let first = self.partition.all().start;
        let [rows, planes] = [1, 2].map(|axis| {
            let (own, first) = (&grid.own[axis], grid.first[axis]);
            own.start - first + 1..own.end - first + 1
        });
        let index = |plane: usize, q: usize| plane * grid.rows() + q - first;
        planes
            .flat_map(|plane| rows.clone().map(move |q| index(plane, q)))
            .map(|row| self.costs[row])
            .collect()
    }

    /// Rebalances the partition by the cost of the rows, which depends on soil and yielding cells. Faster
    /// threads get more; in the serial fallback, the calling thread gets all.
    pub(crate) fn rebalance(&mut self, grid: &Grid) {
        /// Cost of a row without soil, relative to one with soil.
        const VOID: f64 = 0.02;
        /// Cost of the return mapping of a cell, relative to all else that is done for a cell.
        const RETURN: f64 = 1.8;
        let per_cell = RETURN / grid.cells()[0] as f64;
        let Self { partition, costs, row_is_strained, row_sums, .. } = self;
        let first = partition.all().start;
        let each = row_is_strained[first..].iter().zip(&row_sums[first..]);
        for (cost, (is_strained, sums)) in costs.iter_mut().zip(each) {
            *cost = if *is_strained { 1.0 + per_cell * f64::from(sums.yields) } else { VOID };
        }
        self.divide(grid);
    }

    /// Divides the rows by their costs.
    fn divide(&mut self, grid: &Grid) {
        let Self { team, partition, serial_fallback, costs, portions, contact_from, far_portions, .. } = self;
        let (threads, count) = (team.size(), portion_count(grid, team.size()));
        let speed = |n: usize| portions[n].throughput.speed();
        let all_known = (0..threads).all(|n| speed(n).is_some());
        let speed = |n: usize| speed(n).filter(|_| all_known).unwrap_or(1.0);
        let tail = if count > threads { TAIL } else { 0.0 };
        let own = (1.0 - tail) / (0..threads).map(speed).sum::<f64>();
        let share = |n: usize| match n {
            _ if n >= count => speed(n - count),
            _ if n >= threads => tail / (count - threads) as f64,
            _ => own * speed(n),
        };
        *far_portions = 0;
        if serial_fallback.should_run_alone() {
            partition.rebalance(costs, 1, share);
        } else {
            // The first nodes of the rows from there on wait for those before.
            let far =
                contact_from.map_or(0, |row| row.saturating_sub(partition.all().start + grid.rows() + 1));
            if partition.rebalance_apart(costs, far, [count, threads], share) {
                *far_portions = count;
            } else {
                partition.rebalance(costs, count, share);
            }
        }
        for (portion, load) in portions.iter_mut().zip(partition.loads(costs)) {
            portion.throughput.assign(load);
        }
    }

    /// Has the rows of nodes from this one on, which contact needs, strained before the others; for one of
    /// several blocks.
    pub(crate) fn strain_first(&mut self, grid: &Grid, contact_from: Option<usize>) {
        if self.contact_from != contact_from {
            let count = portion_count(grid, self.threads()) + self.threads();
            self.portions.resize_with(count, || PortionScratch::new(grid, true));
            self.contact_from = contact_from;
            self.divide(grid);
        }
    }
}

/// Copies an array to memory that the workers touch first.
fn settle<R: Scalar>(team: &Team, partition: &RowPartition, array: &mut Vec<R>) {
    let (old, stride) = (std::mem::take(array), partition.stride);
    // The system gives zeroed memory to whoever writes to it first.
    *array = vec![R::default(); old.len()];
    team.rows(partition, array, |row, own| own.copy_from_slice(&old[row * stride..][..stride]));
    let rows = partition.all();
    let (low, high) = (rows.start * stride, rows.end * stride);
    array[..low].copy_from_slice(&old[..low]);
    array[high..].copy_from_slice(&old[high..]);
}

fn column_widths<R: Scalar>(grid: &Grid) -> [Vec<R>; 2] {
    let mut widths = vec![0.0; grid.stride[1] + crate::grid::LANES];
    for i in 0..grid.cells()[0] {
        widths[i + 1] = grid.width(0, i);
    }
    let per_width = widths.iter().map(|w| if *w > 0.0 { R::cast(0.25 / w) } else { R::default() }).collect();
    [widths.into_iter().map(|w: f64| R::cast(w)).collect(), per_width]
}

/// Number of threads of a team for which `threads` were asked.
pub(crate) fn team_size(grid: &Grid, threads: usize) -> usize {
    let (rows, planes) = (grid.rows(), grid.cells()[2] + 1);
    // Nodes must not wait for the cells of more than one other portion.
    threads.clamp(1, (planes * rows / (rows + 1)).min(MAX_WORKERS))
}

/// Portion of the cost that is kept in small portions for the threads that are ready first: how fast a core
/// is changes from step to step.
const TAIL: f64 = 0.12;

/// Number of portions of the rows: one for each thread, and the small ones.
fn portion_count(grid: &Grid, threads: usize) -> usize {
    /// Small portions for each thread, at most: the first nodes of each must wait for the one before.
    const SMALL: usize = 4;
    if threads == 1 {
        return 1;
    }
    let most = team_size(grid, MAX_WORKERS);
    threads + ((TAIL * most as f64) as usize).min(SMALL * threads).min(most - threads)
}

/// Memory of the workspace of a grid [bytes].
pub(crate) fn footprint<R: Scalar>(model: &Model, threads: usize) -> f64 {
    let grid = &model.grid;
    let averages = if model.has_characteristic_length() { 4.0 } else { 0.0 };
    let [_, row, plane] = grid.stride;
    let (threads, rows, planes) = (portion_count(grid, threads) as f64, grid.rows(), grid.cells()[2] + 1);
    let own = 3 * COEFFICIENTS * row + NODE_SUMS * plane + ROW_BUFFERS * row;
    let waiting = NODE_SUMS * (plane + row);
    let of_materials = if model.materials.len() > 1 { size_of::<R>() + size_of::<u8>() } else { 0 };
    let per_row = size_of::<RowSums>() + 2 * size_of::<bool>() + size_of::<[f64; 2]>();
    let of_rows = rows * (planes + 1) * per_row + rows * planes * size_of::<f64>();
    let reals =
        (3.0 + averages) * grid.entries as f64 + threads * own as f64 + (threads - 1.0) * waiting as f64;
    reals * size_of::<R>() as f64
        + (of_materials * grid.entries) as f64
        + threads * size_of::<R::CellBlock>() as f64
        + of_rows as f64
}
