//! Memory that the step works in and that is worth nothing between steps.

use super::contact::{self, BodyCell, ContactLaw, Drive, Surface, TouchedNode};
use super::footprint::team_size;
use super::stress::Block;
use super::{Real, State};
use crate::cpu::cut::{Company, Cut, Pace};
use crate::cpu::stopwatch::Stopwatch;
use crate::cpu::threads::Team;
use crate::grid::Grid;
use crate::model::Model;
use glam::DVec3;

/// Coefficients of the nodal force of one plane of cells: for each component the plain part and the parts signed by the
/// corner's side along x, y, z; last the hourglass damping.
pub(crate) const COEFFICIENTS: usize = 13;

/// Sums at a node: the force along x, y, z, and the damping.
pub(crate) const NODE_SUMS: usize = 4;

/// Threads, scratch arrays and the bookkeeping of which rows hold soil.
pub struct Workspace {
    pub(crate) team: Team,
    /// How rows (of storage planes 1 to nz + 1: nodes, and the cells above them) are dealt out.
    pub(crate) cut: Cut,
    /// Whether the team is worth having.
    pub(crate) company: Company,
    /// Cost of each row when they were dealt out last.
    pub(crate) costs: Vec<f64>,
    /// Whether a row of cells holds soil, by storage plane and row.
    pub(crate) row_has_soil: Vec<bool>,
    /// How many of the two arrays of velocities are known to be zero where no soil is.
    pub(crate) clear: u8,
    /// Nodal velocities of the step before. Between steps they are worth nothing, and room for others: for the remap, and
    /// the first, from then till the contact points are located, for the share of each cell that bodies take up.
    pub(crate) velocity_before: [Vec<Real>; 3],
    /// The cells of which bodies take up a share, body by body.
    pub(crate) body_cells: Vec<BodyCell>,
    /// One for each worker.
    pub(crate) workers: Vec<WorkerScratch>,
    /// Sums over rows of the Lagrangian step.
    pub(crate) row_sums: Vec<RowSums>,
    /// Two values for each row, to be added up.
    pub(crate) row_values: Vec<[f64; 2]>,
    /// Widths of the cell layers along x [m], in storage columns (0 in ghosts), and ¼ over them.
    pub(crate) width_x: [Vec<Real>; 2],
    /// How soil and bodies act on each other.
    pub(crate) contact_law: Box<dyn ContactLaw>,
    /// Surfaces of the bodies.
    pub(crate) surfaces: Vec<Surface>,
    /// Nodes that contact acts on.
    pub(crate) touched: Vec<TouchedNode>,
    /// For each contact, the places of its cell's nodes among them.
    pub(crate) corner_nodes: Vec<[u32; 8]>,
    /// For each contact the number of its patch; for each patch the forces that are missing at its nodes.
    pub(crate) patch: (Vec<usize>, Vec<[DVec3; 8]>),
    /// Frictional impulse at each contact in the last step [N s].
    pub(crate) friction: Vec<DVec3>,
    /// How each body came through the last step.
    pub(crate) drives: Vec<Drive>,
}

impl std::fmt::Debug for Workspace {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Workspace for {:?}", self.team)
    }
}

/// What a worker needs for itself, on cache lines of its own: it is written in every row, and two workers that write to one
/// line wait for each other.
#[repr(align(128))]
pub(crate) struct WorkerScratch {
    /// Force coefficients of two rows of cells in turn.
    pub(crate) coefficients: [Coefficients; 2],
    /// Those of the worker's first row.
    pub(crate) first: Coefficients,
    /// Force and damping (four rows for each row of nodes) on a plane of nodes by the cells below it.
    pub(crate) below: Vec<Real>,
    /// The same, row by row, on those of the worker's first nodes that wait for other cells; the first worker's wait for nobody.
    pub(crate) waiting: Vec<Real>,
    /// Row buffers of the nodes.
    pub(crate) row: Vec<Real>,
    /// Block of cells.
    pub(crate) block: Box<Block>,
    /// How fast this worker is.
    pub(crate) pace: Pace,
    /// Where this worker's time goes.
    pub(crate) stopwatch: Stopwatch,
}

/// Force coefficients of a row of cells.
pub(crate) struct Coefficients {
    /// One row after the other.
    pub(crate) values: Vec<Real>,
    /// Whether all are zero.
    pub(crate) are_zero: bool,
}

impl Coefficients {
    /// Takes over another row's.
    pub(crate) fn copy_from(&mut self, other: &Self) {
        self.values.copy_from_slice(&other.values);
        self.are_zero = other.are_zero;
    }
}

/// Sums over a row, in an order that does not depend on the number of threads.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RowSums {
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

/// Row buffers that the Lagrangian step needs, in rows.
pub(crate) const ROW_BUFFERS: usize = 6;

impl Workspace {
    /// Memory for a model and a team of `threads`.
    #[must_use]
    pub fn new(model: &Model, state: &State, threads: usize) -> Self {
        let grid = &model.grid;
        let [_, row, plane] = grid.stride;
        let planes = grid.cells()[2] + 1;
        let rows = plane / row;
        let coefficients = || Coefficients { values: vec![0.0; COEFFICIENTS * row], are_zero: true };
        let worker = |n| WorkerScratch {
            coefficients: [coefficients(), coefficients()],
            first: coefficients(),
            below: vec![0.0; NODE_SUMS * plane],
            waiting: vec![0.0; if n > 0 { NODE_SUMS * (plane + row) } else { 0 }],
            row: vec![0.0; ROW_BUFFERS * row],
            block: Block::new(),
            pace: Pace::default(),
            stopwatch: Stopwatch::default(),
        };
        let least = rows + 1;
        let threads = team_size(grid, threads);
        let (touched, corner_nodes) = contact::touched_nodes(model, &state.contacts);
        let mut workspace = Self {
            team: Team::new(threads),
            cut: Cut::new(rows, &vec![1.0; planes * rows], [threads, least], row),
            company: Company::default(),
            costs: vec![0.0; planes * rows],
            row_has_soil: vec![false; rows * (planes + 1)],
            clear: 0,
            velocity_before: state.nodes.velocity.clone(),
            body_cells: Vec::new(),
            workers: (0..threads).map(worker).collect(),
            row_sums: vec![RowSums::default(); rows * (planes + 1)],
            row_values: vec![[0.0; 2]; rows * (planes + 1)],
            width_x: column_widths(grid),
            contact_law: contact::law(model),
            surfaces: model.bodies.iter().map(|body| Surface::new(model, body)).collect(),
            touched,
            corner_nodes,
            patch: contact::number_patches(model, &state.soil, &state.bodies, &state.contacts),
            friction: Vec::new(),
            drives: vec![Drive::default(); model.bodies.len()],
        };
        workspace.find_soil(grid, &state.soil.fraction);
        workspace
    }

    /// Number of threads.
    #[must_use]
    pub fn threads(&self) -> usize {
        self.team.size()
    }

    /// Where the time of the calling thread goes.
    pub fn stopwatch(&mut self) -> &mut Stopwatch {
        &mut self.workers[0].stopwatch
    }

    /// Sums over all rows, in the order of the memory.
    pub(crate) fn total_of_rows(&self) -> [f64; 2] {
        self.row_values.iter().fold([0.0; 2], |sum, own| [sum[0] + own[0], sum[1] + own[1]])
    }

    /// Notes which rows hold soil, and deals the rows out anew.
    pub(crate) fn find_soil(&mut self, grid: &Grid, fraction: &[Real]) {
        for (n, cells) in fraction.chunks_exact(grid.stride[1]).take(self.row_has_soil.len()).enumerate() {
            self.row_has_soil[n] = cells.iter().any(|f| *f > 0.0);
            if !self.row_has_soil[n] {
                self.row_sums[n] = RowSums::default();
            }
        }
        self.deal(grid);
    }

    /// Deals the rows out to the workers by what they cost: those with soil, and cells that yield. Faster workers get more; if
    /// working together does not pay, the caller gets all.
    pub(crate) fn deal(&mut self, grid: &Grid) {
        /// A row without soil, over one with soil.
        const VOID: f64 = 0.02;
        /// Return of one cell's stress to the strength, over all else that is done for a cell.
        const RETURN: f64 = 1.8;
        let per_cell = RETURN / grid.cells()[0] as f64;
        let Self { cut, company, costs, row_has_soil, row_sums, workers, .. } = self;
        let first = cut.all().start;
        let each = row_has_soil[first..].iter().zip(&row_sums[first..]);
        for (cost, (has_soil, sums)) in costs.iter_mut().zip(each) {
            *cost = if *has_soil { 1.0 + per_cell * f64::from(sums.yields) } else { VOID };
        }
        let all_known = workers.iter().all(|worker| worker.pace.speed().is_some());
        let size = if company.is_left() { 1 } else { workers.len() };
        cut.deal(costs, size, |n| workers[n].pace.speed().filter(|_| all_known).unwrap_or(1.0));
        for (worker, load) in workers.iter_mut().zip(cut.loads(costs)) {
            worker.pace.turn_to(load);
        }
    }
}

fn column_widths(grid: &Grid) -> [Vec<Real>; 2] {
    let mut widths = vec![0.0; grid.stride[1] + crate::grid::LANES];
    for i in 0..grid.cells()[0] {
        widths[i + 1] = grid.width(0, i);
    }
    let per_width = widths.iter().map(|w| if *w > 0.0 { (0.25 / w) as Real } else { 0.0 }).collect();
    [widths.into_iter().map(|w: f64| w as Real).collect(), per_width]
}

/// Sum in eight lanes that are added up at the end: the same whatever the processor's vectors are.
#[inline(always)]
pub(crate) fn lane_sum(values: &[Real]) -> f64 {
    let mut lanes: [Real; 8] = [0.0; 8];
    for chunk in values.chunks_exact(8) {
        for (lane, value) in lanes.iter_mut().zip(chunk) {
            *lane += value;
        }
    }
    let tail: Real = values.chunks_exact(8).remainder().iter().sum();
    let (lanes, tail) = (lanes.map(f64::from), f64::from(tail));
    ((lanes[0] + lanes[4]) + (lanes[1] + lanes[5])) + ((lanes[2] + lanes[6]) + (lanes[3] + lanes[7])) + tail
}
