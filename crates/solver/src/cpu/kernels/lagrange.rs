//! The Lagrangian stage: the soil deforms, the grid stays.
//!
//! The rows of each portion are processed in memory order: a worker strains a row of cells, then moves the
//! row of nodes before it while the forces are still in the cache. Old and new velocities are separate
//! arrays, so no worker reads what another writes. Only the first rows of nodes of each portion, one more
//! than a plane has, must wait for the cells below or behind them, which belong to another portion.

use super::cells::{CellRow, MaterialConstants, RowConstants, cells_of, runs};
use super::constants;
use super::nodes::{NodeConstants, NodeRow, finish_row, gather_forces, move_row};
use super::strain::strain_cells;
use super::stress::NodeRows;
use super::{Coefficients, PortionScratch, Real, Soil, State, Workspace};
use crate::cpu::stage_sums::{RowSums, StageSums};
use crate::cpu::stopwatch::Stage;
use crate::cpu::threads::team_items;
use crate::exact_sum::ExactSum;
use crate::fields::HISTORY_COUNT;
use crate::grid::Grid;
use crate::model::Model;
use crate::state::Known;
use ::kernels::sums::{COEFFICIENTS, NODE_SUMS};
use std::ops::Range;
use std::time::Instant;

/// A portion's slice of everything that the stage writes.
struct PortionSlice<'a> {
    rows: Range<usize>,
    stress: [&'a mut [Real]; 6],
    history: [&'a mut [Real]; HISTORY_COUNT],
    displacement: [&'a mut [Real]; 3],
    velocity: [&'a mut [Real]; 3],
    sums: &'a mut [RowSums],
    scratch: &'a mut PortionScratch,
}

/// What the stage only reads.
struct Inputs<'a> {
    model: &'a Model,
    grid: &'a Grid,
    fraction: &'a [Real],
    /// Mass of each cell as if all its soil were of its main material [kg].
    soil_mass: &'a [Real],
    mass: &'a [Real],
    velocity: [&'a [Real]; 3],
    row_is_strained: &'a [bool],
    /// Material of each cell; empty where there is only one.
    material: &'a [u8],
    materials: &'a [MaterialConstants],
    /// Whether velocities must still be set to zero where there is no soil.
    clears: bool,
    cells: RowConstants<'a>,
    nodes: NodeConstants,
}

/// Steps between two rebalancings, since yielding zones move.
const REBALANCES: u64 = 64;

/// Strains the soil and moves the nodes by one step of `dt` [s]: stresses and displacements at the end of the
/// step, velocities without contact half a step later. Dissipation and displacements are left in the sums by
/// row. Calls `known(nodes, velocities before)` as soon as the nodes of this block that contact needs are
/// moved.
pub(crate) fn lagrange(
    model: &Model,
    state: &mut State,
    workspace: &mut Workspace,
    dt: f64,
    known: &mut Known<'_, Real>,
) {
    let clears = prepare(&model.grid, state, workspace);
    let clock = Instant::now();
    if workspace.contact_from.is_none() {
        known(&state.nodes, &workspace.velocity_before);
    }
    let turns: &[Turn] = if workspace.far_portions > 0 { &[Turn::Near, Turn::Far] } else { &[Turn::All] };
    for turn in turns {
        strain(model, state, workspace, dt, clears, *turn);
        if workspace.contact_from.is_some() && *turn != Turn::Far {
            known(&state.nodes, &workspace.velocity_before);
        }
    }
    let Workspace { team, partition, serial_fallback, portions, .. } = workspace;
    if team.size() > 1
        && partition.ranges().len() > 1
        && let Some(speed) = portions[0].throughput.speed()
    {
        let load: f64 = portions.iter().map(|portion| portion.throughput.load()).sum();
        serial_fallback.record(clock.elapsed().as_secs_f64(), load / speed);
    }
    portions[0].stopwatch.lap(Stage::Nodes);
}

/// Which portions of the rows are strained.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Turn {
    All,
    /// The portions with the nodes that contact needs. The first nodes of the first portion still wait.
    Near,
    /// The other portions, before those in memory.
    Far,
}

impl Turn {
    /// The portions that are strained, those among which forces are passed on, and those whose first nodes
    /// have all their forces then; of so many far ones among all.
    fn portions(self, far: usize, all: usize) -> [Range<usize>; 3] {
        match self {
            Self::All => [0..all, 0..all, 0..all],
            Self::Near => [far..all, far..all, far + 1..all],
            Self::Far => [0..far, 0..far + 1, 0..far + 1],
        }
    }
}

/// Strains the cells of some portions and moves their nodes.
fn strain(model: &Model, state: &mut State, workspace: &mut Workspace, dt: f64, clears: bool, turn: Turn) {
    let Workspace {
        team,
        partition,
        far_portions: far,
        row_is_strained,
        velocity_before,
        portions,
        row_sums,
        width_x,
        material,
        mass_as_main,
        materials,
        ..
    } = workspace;
    let Soil { fraction, mass, stress, history, .. } = &mut state.soil;
    let inputs = Inputs {
        model,
        grid: &model.grid,
        fraction,
        soil_mass: if mass_as_main.is_empty() { mass } else { mass_as_main },
        mass: &state.nodes.mass,
        velocity: velocity_before.each_ref().map(Vec::as_slice),
        row_is_strained,
        material,
        materials,
        clears,
        cells: constants::of_rows(model, materials, width_x, dt),
        nodes: constants::of_nodes(model, dt),
    };
    let mut stress = stress.each_mut().map(|s| partition.split(s));
    let mut displacement = state.nodes.displacement.each_mut().map(|u| partition.split(u));
    let mut velocity = state.nodes.velocity.each_mut().map(|v| partition.split(v));
    let mut history = history.each_mut().map(|h| partition.split(h));
    let mut sums = partition.split_by(1, row_sums);
    let each = partition.ranges().zip(portions.iter_mut()).map(move |(rows, scratch)| PortionSlice {
        rows,
        stress: stress.each_mut().map(|s| s.next().unwrap_or_default()),
        history: history.each_mut().map(|h| h.next().unwrap_or_default()),
        displacement: displacement.each_mut().map(|u| u.next().unwrap_or_default()),
        velocity: velocity.each_mut().map(|v| v.next().unwrap_or_default()),
        sums: sums.next().unwrap_or_default(),
        scratch,
    });
    let mut slices = team_items(each);
    let [strained, passed, moved] = turn.portions(*far, slices.len());
    team.for_each(&mut slices[strained], |slice| strain_and_move(&inputs, slice));
    pass_forces_on(&mut slices[passed]);
    team.for_each(&mut slices[moved], |slice| move_waiting(&inputs, slice));
}

/// Prepares the stage: afterwards the new velocities belong to the state, the old ones to the workspace.
/// Returns whether velocities must still be set to zero where there is no soil.
fn prepare(grid: &Grid, state: &mut State, workspace: &mut Workspace) -> bool {
    workspace.stopwatch().lap(Stage::Other);
    if state.step.is_multiple_of(REBALANCES) {
        workspace.rebalance(grid);
    }
    std::mem::swap(&mut state.nodes.velocity, &mut workspace.velocity_before);
    let clears = workspace.clear < 2;
    workspace.clear += u8::from(clears);
    clears
}

impl Inputs<'_> {
    /// Number of a slice's rows of nodes that must wait. Below the lowest plane there is nothing to wait for.
    fn waiting(&self, slice: &PortionSlice) -> usize {
        let rows = self.grid.rows();
        if slice.rows.start > rows { rows + 1 } else { 0 }
    }

    /// Whether there is soil around a row of nodes. If not, the cells below exert no forces on it.
    fn nodes_have_soil(&self, [q, plane]: [usize; 2]) -> bool {
        let rows = self.grid.rows();
        let cells = |p: usize, q: usize| self.row_is_strained[p * rows + q];
        q > 0 && (cells(plane - 1, q - 1) || cells(plane - 1, q) || cells(plane, q - 1) || cells(plane, q))
    }
}

/// Range of row `q` of a plane of nodes in the sums.
fn sums_of(row: usize, q: usize) -> Range<usize> {
    NODE_SUMS * q * row..NODE_SUMS * (q + 1) * row
}

/// Strains all cells of a slice and moves all its nodes except those that must wait.
fn strain_and_move(inputs: &Inputs, slice: &mut PortionSlice) {
    let clock = Instant::now();
    let lengths @ [row, _] = [inputs.grid.stride[1], inputs.grid.padded_nodes()];
    let waiting_rows = inputs.waiting(slice);
    slice.scratch.dissipated_beyond = ExactSum::default();
    slice.scratch.below.fill(0.0);
    set_to_zero(&mut slice.scratch.coefficients[0]);
    for (n, row_and_plane) in slice.rows.clone().map(|r| inputs.grid.row_and_plane(r)).enumerate() {
        strain_row_of(inputs, slice, row_and_plane, n);
        let waits = n < waiting_rows;
        let PortionScratch { coefficients: [behind, ahead], first, below, waiting, row: buffer, .. } =
            &mut *slice.scratch;
        if n == 0 && waits {
            // The row behind belongs to another portion: these nodes get all their forces later.
            first.copy_from(ahead);
        } else if inputs.nodes_have_soil(row_and_plane) {
            let sum = if waits { &mut waiting[sums_of(row, n)] } else { &mut buffer[sums_of(row, 0)] };
            gather_forces(
                [&behind.values, &ahead.values],
                lengths,
                &mut below[sums_of(row, row_and_plane[0])],
                sum,
            );
        }
        std::mem::swap(behind, ahead);
        if !waits {
            move_row_of(inputs, slice, row_and_plane, n);
        }
        slice.scratch.stopwatch.lap(Stage::Nodes);
    }
    slice.scratch.throughput.record(clock.elapsed().as_secs_f64());
}

/// Passes on to every slice what its waiting nodes need from the slice before: the forces of the cells below,
/// and the coefficients of the last row of cells.
fn pass_forces_on(slices: &mut [PortionSlice]) {
    for n in (1..slices.len()).rev() {
        let (low, high) = slices.split_at_mut(n);
        let (low, high) = (&mut low[n - 1], &mut high[0]);
        std::mem::swap(&mut low.scratch.below, &mut high.scratch.below);
        std::mem::swap(&mut low.scratch.coefficients[0], &mut high.scratch.coefficients[0]);
    }
}

/// Moves the nodes of a slice that had to wait for the cells below and behind them, and adds up the sums of
/// its rows.
fn move_waiting(inputs: &Inputs, slice: &mut PortionSlice) {
    let lengths @ [row, _] = [inputs.grid.stride[1], inputs.grid.padded_nodes()];
    for n in 0..inputs.waiting(slice) {
        let row_and_plane = inputs.grid.row_and_plane(slice.rows.start + n);
        if inputs.nodes_have_soil(row_and_plane) {
            let PortionScratch { coefficients: [behind, _], first, below, waiting, row: buffer, .. } =
                &mut *slice.scratch;
            let (below, sum) = (&mut below[sums_of(row, row_and_plane[0])], &mut buffer[sums_of(row, 0)]);
            if n == 0 {
                gather_forces([&behind.values, &first.values], lengths, below, sum);
            } else {
                let each = sum.iter_mut().zip(below).zip(&waiting[sums_of(row, n)]);
                each.for_each(|((sum, below), own)| *sum = *below + own);
            }
        }
        move_row_of(inputs, slice, row_and_plane, n);
    }
    let own = slice.rows.clone().zip(&*slice.sums).filter(|(row, _)| inputs.grid.owned_row(*row).is_some());
    slice.scratch.sums = StageSums::of(own.map(|(_, sums)| sums));
    slice.scratch.sums.add_beyond(slice.scratch.dissipated_beyond);
}

/// Sets force coefficients to zero, unless they are.
fn set_to_zero(coefficients: &mut Coefficients) {
    if !coefficients.are_zero {
        coefficients.values.fill(0.0);
        coefficients.are_zero = true;
    }
}

/// Strains the `n`th row of cells of a slice; its force coefficients go to the second row of coefficients.
fn strain_row_of(inputs: &Inputs, slice: &mut PortionSlice, [q, plane]: [usize; 2], n: usize) {
    let grid = inputs.grid;
    let [_, row, stride] = grid.stride;
    let length = grid.padded_row();
    let PortionScratch { coefficients: [_, ahead], block, stopwatch, dissipated_beyond, .. } =
        &mut *slice.scratch;
    let is_strained = inputs.row_is_strained[plane * grid.rows() + q];
    if !is_strained || !inputs.model.boundaries.strain_row(grid, [q, plane]) {
        set_to_zero(ahead);
        return;
    }
    let at = |dq: usize, dp: usize| (plane + dp) * stride + (q + dq) * row + 1;
    let node_rows: NodeRows = [at(0, 0), at(1, 0), at(0, 1), at(1, 1)]
        .map(|start| inputs.velocity.map(|v| &v[start..start + length + 1]));
    let own = n * row + 1..n * row + 1 + length;
    let start = at(0, 0);
    let mut cell_row = CellRow {
        fraction: &inputs.fraction[start..start + length],
        mass: &inputs.soil_mass[start..start + length],
        stress: slice.stress.each_mut().map(|s| &mut s[own.clone()]),
        history: slice.history.each_mut().map(|h| cells_of(h, &own)),
        width_y: grid.width(1, q - 1) as Real,
        width_z: grid.width(2, plane - 1) as Real,
    };
    ahead.are_zero = false;
    let mut out = ahead.values.chunks_exact_mut(row);
    let mut forces: [&mut [Real]; COEFFICIENTS] =
        std::array::from_fn(|_| out.next().map_or(Default::default(), |f| &mut f[1..1 + length]));
    let sums = &mut slice.sums[n];
    (sums.plastic, sums.viscous, sums.hourglass, sums.seepage, sums.yields) = (0.0, 0.0, 0.0, 0.0, 0);
    // What is dissipated beyond a boundary at constant stress is the ground's there.
    let mut beyond = RowSums::default();
    let material = inputs.material.get(start..start + length).unwrap_or_default();
    for (columns, is_beyond) in strained_columns(inputs.model, grid.is_inside([q, plane])) {
        let sums = if is_beyond { &mut beyond } else { &mut *sums };
        for (run, number) in runs(material, columns) {
            let constants = inputs.cells.of(&inputs.materials[number]);
            let work = (&mut **block, &mut *stopwatch);
            strain_cells(&constants, &node_rows, (&mut cell_row, run), work, &mut forces, sums);
        }
    }
    if grid.accounts_for(1, q - 1 + grid.first[1]) && grid.accounts_for(2, plane - 1 + grid.first[2]) {
        dissipated_beyond.add(beyond.dissipated());
    }
}

/// The columns of a row of cells that are strained, in parts that lie in the domain or beyond it.
pub(super) fn strained_columns(model: &Model, is_inside: bool) -> impl Iterator<Item = (Range<usize>, bool)> {
    let (grid, all) = (&model.grid, model.boundaries.strained(&model.grid, 0));
    let inside = grid.inside(0);
    let own = if all == inside { grid.strained_columns() } else { inside.clone() };
    let parts = [(all.start..inside.start, true), (own, !is_inside), (inside.end..all.end, true)];
    parts.into_iter().filter(|(columns, _)| !columns.is_empty())
}

/// Moves the `n`th row of nodes of a slice under the forces in the row buffer.
fn move_row_of(inputs: &Inputs, slice: &mut PortionSlice, row_and_plane: [usize; 2], n: usize) {
    let row = inputs.grid.stride[1];
    let nodes = inputs.grid.padded_nodes();
    let own = n * row + 1..n * row + 1 + nodes;
    let mut velocity = slice.velocity.each_mut().map(|v| &mut v[own.clone()]);
    if !inputs.nodes_have_soil(row_and_plane) {
        if inputs.clears {
            velocity.iter_mut().for_each(|v| v.fill(0.0));
        }
        return;
    }
    let start = (slice.rows.start + n) * row + 1;
    let mut nodes = NodeRow {
        mass: &inputs.mass[start..start + nodes],
        before: inputs.velocity.map(|v| &v[start..start + nodes]),
        displacement: slice.displacement.each_mut().map(|u| &mut u[own.clone()]),
        velocity,
    };
    move_row(&inputs.nodes, &mut nodes, &slice.scratch.row, row);
    apply_boundaries(inputs.model, row_and_plane, &mut nodes.velocity);
    let measured = finish_row(&inputs.nodes, &nodes, &mut slice.scratch.row);
    slice.sums[n].measured(&measured);
}

/// Sets to zero the velocity components of a row of nodes that boundaries hold.
pub(super) fn apply_boundaries(model: &Model, [q, plane]: [usize; 2], velocity: &mut [&mut [Real]; 3]) {
    let grid = &model.grid;
    let nodes = grid.cells()[0] + 1;
    // The first nodes that are held at the high end, and those after the last at the low end.
    let held = |axis: usize| {
        let inside = grid.inside(axis);
        let [low, high] = [0, 1].map(|end| usize::from(model.boundaries.of_block(grid, axis, end).yields()));
        [inside.start + 1 - low, inside.end + high]
    };
    let mut hold = |[axis, end]: [usize; 2], columns: Range<usize>| {
        for (v, held) in velocity.iter_mut().zip(model.boundaries.of_block(grid, axis, end).holds(axis)) {
            if held {
                v[columns.clone()].fill(0.0);
            }
        }
    };
    for (axis, layer) in [(1, q - 1), (2, plane - 1)] {
        let [low, high] = held(axis);
        if layer < low {
            hold([axis, 0], 0..nodes);
        }
        if layer >= high {
            hold([axis, 1], 0..nodes);
        }
    }
    let [low, high] = held(0);
    hold([0, 0], 0..low);
    hold([0, 1], high.min(nodes)..nodes);
}
