//! Memory that the loops over cells work in and that is worth nothing between steps.

use super::partition::{RowPartition, SerialFallback, Throughput};
use super::stopwatch::Stopwatch;
use super::threads::{MOST, Team};
use crate::fields::Soil;
use crate::grid::Grid;
use crate::halo::{self, Halo};
use crate::model::Model;
use crate::scalar::Scalar;
use crate::state::State;

/// Coefficients of the nodal force of one plane of cells: for each component the plain part and the parts signed by the
/// corner's side along x, y, z; last the hourglass damping.
pub(crate) const COEFFICIENTS: usize = 13;

/// Sums at a node: the force along x, y, z, and the damping.
pub(crate) const NODE_SUMS: usize = 4;

/// Threads, scratch arrays and the bookkeeping of which rows hold soil.
pub struct SoilWorkspace<R: Scalar> {
    pub(crate) team: Team,
    /// How rows (of storage planes 1 to nz + 1: nodes, and the cells above them) are dealt out.
    pub(crate) partition: RowPartition,
    /// Whether the team is worth having.
    pub(crate) serial_fallback: SerialFallback,
    /// Cost of each row when they were dealt out last.
    pub(crate) costs: Vec<f64>,
    /// Whether a row of cells holds soil, by storage plane and row.
    pub(crate) row_has_soil: Vec<bool>,
    /// Number of the material that most of the soil in each cell is of; empty where there is one alone.
    pub(crate) material: Vec<u8>,
    /// The materials as the kernels need them.
    pub(crate) materials: R::Materials,
    /// How many of the two arrays of velocities are known to be zero where no soil is.
    pub(crate) clear: u8,
    /// Nodal velocities of the step before. Between steps they are worth nothing, and room for others: for the remap, and
    /// the first, from then till the contact points are located, for the share of each cell that bodies take up.
    pub(crate) velocity_before: [Vec<R>; 3],
    /// One for each worker.
    pub(crate) workers: Vec<WorkerScratch<R>>,
    /// Sums over rows of the Lagrangian step.
    pub(crate) row_sums: Vec<RowSums>,
    /// Two values for each row, to be added up.
    pub(crate) row_values: Vec<[f64; 2]>,
    /// Widths of the cell layers along x [m], in storage columns (0 in ghosts), and ¼ over them.
    pub(crate) width_x: [Vec<R>; 2],
}

impl<R: Scalar> std::fmt::Debug for SoilWorkspace<R> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "SoilWorkspace for {:?}", self.team)
    }
}

/// What a worker needs for itself, on cache lines of its own: it is written in every row, and two workers that write to one
/// line wait for each other.
#[repr(align(128))]
pub(crate) struct WorkerScratch<R: Scalar> {
    /// Force coefficients of two rows of cells in turn.
    pub(crate) coefficients: [Coefficients<R>; 2],
    /// Those of the worker's first row.
    pub(crate) first: Coefficients<R>,
    /// Force and damping (four rows for each row of nodes) on a plane of nodes by the cells below it.
    pub(crate) below: Vec<R>,
    /// The same, row by row, on those of the worker's first nodes that wait for other cells; the first worker's wait for nobody.
    pub(crate) waiting: Vec<R>,
    /// Row buffers of the nodes.
    pub(crate) row: Vec<R>,
    /// Block of cells.
    pub(crate) block: Box<R::CellBlock>,
    /// How fast this worker is.
    pub(crate) throughput: Throughput,
    /// Where this worker's time goes.
    pub(crate) stopwatch: Stopwatch,
}

/// Force coefficients of a row of cells.
pub(crate) struct Coefficients<R> {
    /// One row after the other.
    pub(crate) values: Vec<R>,
    /// Whether all are zero.
    pub(crate) are_zero: bool,
}

impl<R: Copy> Coefficients<R> {
    /// Takes over another row's.
    pub(crate) fn copy_from(&mut self, other: &Self) {
        self.values.copy_from_slice(&other.values);
        self.are_zero = other.are_zero;
    }
}

/// Sums over a row, in an order that does not depend on the number of threads.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct RowSums {
    /// Plastic dissipation [J].
    pub plastic: f64,
    /// Dissipation by bulk viscosity [J].
    pub viscous: f64,
    /// Dissipation by hourglass viscosity [J].
    pub hourglass: f64,
    /// Work of gravity [J].
    pub gravity: f64,
    /// Kinetic energy of the nodes [J].
    pub kinetic: f64,
    /// Largest component of a nodal displacement since the last remap [m].
    pub displacement: f64,
    /// The same of the nodes that only a few grains hang on [m].
    pub displacement_light: f64,
    /// Number of cells whose stress was returned to the strength.
    pub yields: u32,
}

impl RowSums {
    fn plus(self, other: Self) -> Self {
        Self {
            plastic: self.plastic + other.plastic,
            viscous: self.viscous + other.viscous,
            hourglass: self.hourglass + other.hourglass,
            gravity: self.gravity + other.gravity,
            kinetic: self.kinetic + other.kinetic,
            displacement: self.displacement.max(other.displacement),
            displacement_light: self.displacement_light.max(other.displacement_light),
            yields: self.yields + other.yields,
        }
    }

    fn to_array(self) -> [f64; 8] {
        let Self { plastic, viscous, hourglass, gravity, kinetic, .. } = self;
        let yields = f64::from(self.yields);
        [plastic, viscous, hourglass, gravity, kinetic, self.displacement, self.displacement_light, yields]
    }

    fn of(
        [plastic, viscous, hourglass, gravity, kinetic, displacement, displacement_light, yields]: [f64; 8],
    ) -> Self {
        let yields = yields as u32;
        Self { plastic, viscous, hourglass, gravity, kinetic, displacement, displacement_light, yields }
    }
}

/// Row buffers that the Lagrangian step needs, in rows.
pub(crate) const ROW_BUFFERS: usize = 6;

impl<R: Scalar> SoilWorkspace<R> {
    /// Memory for a model and a team of `threads`.
    #[must_use]
    pub(crate) fn new(model: &Model, state: &State<R>, threads: usize) -> Self {
        let grid = &model.grid;
        let [_, row, plane] = grid.stride;
        let planes = grid.cells()[2] + 1;
        let rows = plane / row;
        let coefficients = || Coefficients { values: vec![R::default(); COEFFICIENTS * row], are_zero: true };
        let worker = |n| WorkerScratch {
            coefficients: [coefficients(), coefficients()],
            first: coefficients(),
            below: vec![R::default(); NODE_SUMS * plane],
            waiting: vec![R::default(); if n > 0 { NODE_SUMS * (plane + row) } else { 0 }],
            row: vec![R::default(); ROW_BUFFERS * row],
            block: R::cell_block(),
            throughput: Throughput::default(),
            stopwatch: Stopwatch::default(),
        };
        let least = rows + 1;
        let threads = team_size(grid, threads);
        let mut workspace = Self {
            team: Team::new(threads),
            partition: RowPartition::new(rows, &vec![1.0; planes * rows], [threads, least], row),
            serial_fallback: SerialFallback::default(),
            costs: vec![0.0; planes * rows],
            row_has_soil: vec![false; rows * (planes + 1)],
            material: Vec::new(),
            materials: R::materials(model),
            clear: 0,
            velocity_before: state.nodes.velocity.clone(),
            workers: (0..threads).map(worker).collect(),
            row_sums: vec![RowSums::default(); rows * (planes + 1)],
            row_values: vec![[0.0; 2]; rows * (planes + 1)],
            width_x: column_widths(grid),
        };
        workspace.find_soil(grid, &state.soil);
        workspace
    }

    /// Number of threads.
    #[must_use]
    pub(crate) fn threads(&self) -> usize {
        self.team.size()
    }

    /// Where the time of the calling thread goes.
    pub(crate) fn stopwatch(&mut self) -> &mut Stopwatch {
        &mut self.workers[0].stopwatch
    }

    /// Memory that it takes up [bytes].
    #[must_use]
    pub(crate) fn memory(&self) -> usize {
        let own = |w: &WorkerScratch<R>| {
            let coefficients = w.coefficients.iter().chain([&w.first]).map(|c| &c.values);
            let rows = coefficients.chain([&w.below, &w.waiting, &w.row]);
            rows.map(|row| size_of_val(row.as_slice())).sum::<usize>() + size_of_val(&*w.block)
        };
        self.velocity_before.iter().map(|field| size_of_val(field.as_slice())).sum::<usize>()
            + self.workers.iter().map(own).sum::<usize>()
            + size_of_val(self.row_sums.as_slice())
            + size_of_val(self.costs.as_slice())
            + size_of_val(self.row_has_soil.as_slice())
            + size_of_val(self.row_values.as_slice())
    }

    /// Sums of the rows' two values over the whole grid, in the order of its rows.
    pub(crate) fn total_of_rows(&self, grid: &Grid, halo: &mut dyn Halo) -> [f64; 2] {
        let add = |sum: [f64; 2], own: &[f64; 2]| [sum[0] + own[0], sum[1] + own[1]];
        if halo.is_alone() {
            return self.row_values.iter().fold([0.0; 2], add);
        }
        let own = self.row_values.iter().enumerate();
        let rows = halo::in_order(halo, own.filter_map(|(row, v)| Some((grid.owned_row(row)?, *v))));
        rows.iter().fold([0.0; 2], |sum, (_, own)| add(sum, own))
    }

    /// What the Lagrangian stage did in all rows of the whole grid.
    pub(crate) fn total_of_stage(&self, grid: &Grid, halo: &mut dyn Halo) -> RowSums {
        if halo.is_alone() {
            return self.row_sums[self.partition.all()]
                .iter()
                .copied()
                .fold(RowSums::default(), RowSums::plus);
        }
        let own = self.row_sums.iter().enumerate();
        let own = own.filter_map(|(row, sums)| Some((grid.owned_row(row)?, sums.to_array())));
        let rows = halo::in_order(halo, own);
        rows.into_iter().map(|(_, sums)| RowSums::of(sums)).fold(RowSums::default(), RowSums::plus)
    }

    /// Finds which rows hold soil and of which material, and deals the rows out anew.
    pub(crate) fn find_soil(&mut self, grid: &Grid, soil: &Soil<R>) {
        if !soil.composition.is_empty() {
            self.material.clear();
            self.material.extend((0..grid.entries).map(|c| soil.main_material(c) as u8));
        }
        for (n, cells) in soil.fraction.chunks_exact(grid.stride[1]).take(self.row_has_soil.len()).enumerate()
        {
            self.row_has_soil[n] = cells.iter().any(|f| *f > R::default());
            if !self.row_has_soil[n] {
                self.row_sums[n] = RowSums::default();
            }
        }
        self.rebalance(grid);
    }

    /// Deals the rows out to the workers by what they cost: those with soil, and cells that yield. Faster workers get more; if
    /// working together does not pay, the caller gets all.
    pub(crate) fn rebalance(&mut self, grid: &Grid) {
        /// A row without soil, over one with soil.
        const VOID: f64 = 0.02;
        /// Return of one cell's stress to the strength, over all else that is done for a cell.
        const RETURN: f64 = 1.8;
        let per_cell = RETURN / grid.cells()[0] as f64;
        let Self { partition, serial_fallback, costs, row_has_soil, row_sums, workers, .. } = self;
        let first = partition.all().start;
        let each = row_has_soil[first..].iter().zip(&row_sums[first..]);
        for (cost, (has_soil, sums)) in costs.iter_mut().zip(each) {
            *cost = if *has_soil { 1.0 + per_cell * f64::from(sums.yields) } else { VOID };
        }
        let all_known = workers.iter().all(|worker| worker.throughput.speed().is_some());
        let size = if serial_fallback.is_left() { 1 } else { workers.len() };
        partition
            .rebalance(costs, size, |n| workers[n].throughput.speed().filter(|_| all_known).unwrap_or(1.0));
        for (worker, load) in workers.iter_mut().zip(partition.loads(costs)) {
            worker.throughput.turn_to(load);
        }
    }
}

fn column_widths<R: Scalar>(grid: &Grid) -> [Vec<R>; 2] {
    let mut widths = vec![0.0; grid.stride[1] + crate::grid::LANES];
    for i in 0..grid.cells()[0] {
        widths[i + 1] = grid.width(0, i);
    }
    let per_width = widths.iter().map(|w| if *w > 0.0 { R::cast(0.25 / w) } else { R::default() }).collect();
    [widths.into_iter().map(|w: f64| R::cast(w)).collect(), per_width]
}

/// Number of threads that a team gets which is asked for.
pub(crate) fn team_size(grid: &Grid, threads: usize) -> usize {
    let (rows, planes) = (grid.rows(), grid.cells()[2] + 1);
    // The nodes that wait for a worker's cells must not wait for those of another besides.
    threads.clamp(1, (planes * rows / (rows + 1)).min(MOST))
}

/// Memory that the workspace of a grid will take up [bytes].
pub(crate) fn footprint<R: Scalar>(grid: &Grid, threads: usize) -> f64 {
    let [_, row, plane] = grid.stride;
    let (threads, rows, planes) = (threads as f64, grid.rows(), grid.cells()[2] + 1);
    let own = 3 * COEFFICIENTS * row + NODE_SUMS * plane + ROW_BUFFERS * row;
    let waiting = NODE_SUMS * (plane + row);
    let per_row = size_of::<RowSums>() + size_of::<bool>() + size_of::<[f64; 2]>();
    let of_rows = rows * (planes + 1) * per_row + rows * planes * size_of::<f64>();
    let reals = 3.0 * grid.entries as f64 + threads * own as f64 + (threads - 1.0) * waiting as f64;
    reals * size_of::<R>() as f64 + threads * size_of::<R::CellBlock>() as f64 + of_rows as f64
}
