//! The balance of the pore water in one step, solved for the change of its pressure by conjugate gradients.

use super::rows::{expansion, outflow, product, weighted};
use super::{SeepageWorkspace, columns};
use crate::cpu::workspace::SoilWorkspace;
use crate::fields::{HISTORY_COUNT, PORE_PRESSURE, PORE_PRESSURE_AHEAD};
use crate::grid::Grid;
use crate::halo::Halo;
use crate::halo::filling::{At, fill_first};
use crate::model::{Model, PoreWater};
use crate::scalar::Scalar;
use crate::state::State;

/// Portion of the water that soil takes in or gives off in a step by which the balance of its flow may be
/// off: a root mean square, with the inverse conductances as weights. What is left goes into the next step.
const TOLERANCE: f64 = 0.02;

/// Most iterations in a step.
const ITERATIONS: usize = 400;

/// The balance of the pore water: what is the same for all cells.
pub(crate) struct Balance<'a> {
    pub(crate) model: &'a Model,
    pub(crate) water: &'a PoreWater,
    /// Mobility of the water k/γ_w [m²/(Pa s)].
    pub(crate) mobility: f64,
    /// Mobility with what the inertia of the soil adds [m²/(Pa s)].
    pub(crate) with_inertia: f64,
    /// How far the grid has travelled upwards [m].
    pub(crate) height: f64,
}

impl Balance<'_> {
    /// Changes the pore pressures so that water flows in where the soil expands with its present velocities:
    /// (M + T) A Δp = −f V div v − M A p, with A what flows out of the cells per mobility, M the mobility,
    /// and T the inertia of the soil. Returns 0, or, where the balance cannot be met, how far it is off over
    /// what is allowed.
    pub(crate) fn solve<R: Scalar>(
        &self,
        state: &mut State<R>,
        soil: &mut SoilWorkspace<R>,
        workspace: &mut SeepageWorkspace,
        halo: &Halo,
    ) -> f64 {
        let grid = &self.model.grid;
        self.guess(state, soil, workspace);
        fill_first(halo, grid, At::Cells, [&mut workspace.direction]);
        self.find_residual(state, soil, workspace);
        let [mut left, taken] = soil.total_of_rows(grid, halo);
        let enough = TOLERANCE * TOLERANCE * taken;
        let mut conjugate = 0.0;
        for _ in 0..ITERATIONS {
            if left <= enough {
                break;
            }
            turn(grid, soil, workspace, conjugate);
            fill_first(halo, grid, At::Cells, [&mut workspace.direction]);
            apply(grid, soil, workspace);
            let [curvature, _] = soil.total_of_rows(grid, halo);
            advance(grid, soil, workspace, left / curvature);
            let [next, _] = soil.total_of_rows(grid, halo);
            conjugate = next / left;
            left = next;
        }
        self.finish(state, soil, workspace);
        fill_first(halo, grid, At::Cells, pressures(&mut state.soil.history));
        // What is not a number is found by the check at the end of the step.
        if left > enough { (left / enough).sqrt() } else { 0.0 }
    }

    /// Starts from the change of the last step, and puts what it and the present pressures make flow together
    /// into `direction` [m²/s].
    fn guess<R: Scalar>(&self, state: &State<R>, soil: &SoilWorkspace<R>, workspace: &mut SeepageWorkspace) {
        let SoilWorkspace { team, partition, row_has_soil, .. } = soil;
        let [pressure, ahead] = [PORE_PRESSURE, PORE_PRESSURE_AHEAD].map(|h| &state.soil.history[h]);
        let SeepageWorkspace { change, direction, diagonal, .. } = workspace;
        team.rows2(partition, change, direction, |row, change, direction| {
            if !row_has_soil[row] {
                direction.fill(0.0);
                return;
            }
            let start = row * partition.stride;
            for (i, (change, direction)) in change.iter_mut().zip(direction).enumerate() {
                let c = start + i;
                let now = pressure[c].to_f64();
                let is_sought = diagonal[c] > 0.0;
                *change = if is_sought { self.with_inertia * (ahead[c].to_f64() - now) } else { 0.0 };
                *direction = if is_sought { *change + self.mobility * now } else { 0.0 };
            }
        });
    }

    /// The residual of the guess, and where the pressure is sought. Sums over the rows: the square of the
    /// residual, and that of the expansion of the soil.
    fn find_residual<R: Scalar>(
        &self,
        state: &State<R>,
        soil: &mut SoilWorkspace<R>,
        workspace: &mut SeepageWorkspace,
    ) {
        let grid = &self.model.grid;
        let SoilWorkspace { team, partition, row_has_soil, row_values, width_x, .. } = soil;
        let SeepageWorkspace {
            conductance, diagonal, inverse, residual, direction, product, openings, ..
        } = workspace;
        let each = partition.split(inverse).zip(partition.split(residual)).zip(partition.split(product));
        let items = each.zip(partition.split_by(1, row_values)).zip(partition.ranges());
        team.distribute(items, |((((inverse, residual), product), values), rows)| {
            let own = inverse.chunks_exact_mut(partition.stride);
            let own = own.zip(residual.chunks_exact_mut(partition.stride));
            let own = own.zip(product.chunks_exact_mut(partition.stride));
            for ((row, ((inverse, residual), product)), value) in rows.clone().zip(own).zip(values.iter_mut())
            {
                *value = [0.0; 2];
                let Some(columns) = columns(grid, row).filter(|_| row_has_soil[row]) else { continue };
                let start = row * partition.stride + columns.start;
                let [_, y, z] = grid.stride;
                let (flow, taken) = (&mut product[columns.clone()], &mut residual[columns.clone()]);
                outflow(direction, conductance, diagonal, start, [y, z], flow);
                let [q, plane] = grid.row_and_plane(row);
                let widths = [grid.width(1, q - 1), grid.width(2, plane - 1)];
                let nodes = [start, start + y, start + z, start + y + z];
                let fraction = &state.soil.fraction[start..];
                expansion(
                    &state.nodes.velocity,
                    nodes,
                    fraction,
                    &width_x[0][columns.clone()],
                    widths,
                    taken,
                );
                let cavitation = self.water.cavitation_pressure(grid.centre(2, plane - 1) + self.height);
                let pressure = &state.soil.history[PORE_PRESSURE][start..];
                let (inverse, diagonal) = (&mut inverse[columns], &diagonal[start..]);
                let mut squares = 0.0;
                let openings = &openings[start..];
                for i in 0..taken.len() {
                    taken[i] += openings[i];
                    let per = if diagonal[i] > 0.0 { 1.0 / diagonal[i] } else { 0.0 };
                    squares += taken[i] * taken[i] * per;
                    taken[i] = -(taken[i] + flow[i]);
                    let cavitates = pressure[i].to_f64() <= cavitation && taken[i] < 0.0;
                    inverse[i] = if cavitates { 0.0 } else { per };
                }
                *value = [weighted(taken, taken, inverse), squares];
            }
        });
    }

    /// The new pressures, and those extrapolated to the next step; water cavitates rather than bear more
    /// tension.
    fn finish<R: Scalar>(&self, state: &mut State<R>, soil: &SoilWorkspace<R>, workspace: &SeepageWorkspace) {
        let grid = &self.model.grid;
        let SoilWorkspace { team, partition, row_has_soil, .. } = soil;
        let [now, ahead] = pressures(&mut state.soil.history);
        team.rows2(partition, now, ahead, |row, now, ahead| {
            let Some(columns) = columns(grid, row).filter(|_| row_has_soil[row]) else { return };
            let [_, plane] = grid.row_and_plane(row);
            let cavitation = self.water.cavitation_pressure(grid.centre(2, plane - 1) + self.height);
            for i in columns {
                let c = row * partition.stride + i;
                let old = now[i].to_f64();
                let is_sought = workspace.diagonal[c] > 0.0;
                let change =
                    if workspace.inverse[c] > 0.0 { workspace.change[c] / self.with_inertia } else { 0.0 };
                let new = if is_sought { (old + change).max(cavitation) } else { 0.0 };
                let next = if is_sought { (2.0 * new - old).max(cavitation) } else { 0.0 };
                (now[i], ahead[i]) = (R::cast(new), R::cast(next));
            }
        });
    }
}

/// Pore pressures, now and extrapolated to the next step.
fn pressures<R>(history: &mut [Vec<R>; HISTORY_COUNT]) -> [&mut Vec<R>; 2] {
    const { assert!(PORE_PRESSURE < PORE_PRESSURE_AHEAD) }
    let (low, high) = history.split_at_mut(PORE_PRESSURE_AHEAD);
    [&mut low[PORE_PRESSURE], &mut high[0]]
}

/// The next direction of the search: the residual over the conductances, conjugate to the last direction.
fn turn<R: Scalar>(grid: &Grid, soil: &SoilWorkspace<R>, workspace: &mut SeepageWorkspace, conjugate: f64) {
    let SoilWorkspace { team, partition, row_has_soil, .. } = soil;
    let SeepageWorkspace { inverse, residual, direction, .. } = workspace;
    team.rows(partition, direction, |row, direction| {
        let Some(columns) = columns(grid, row).filter(|_| row_has_soil[row]) else { return };
        let own = row * partition.stride + columns.start..row * partition.stride + columns.end;
        let each = direction[columns].iter_mut().zip(&inverse[own.clone()]).zip(&residual[own]);
        if conjugate == 0.0 {
            each.for_each(|((direction, inverse), residual)| *direction = inverse * residual);
        } else {
            each.for_each(|((direction, inverse), residual)| {
                *direction = inverse * residual + conjugate * *direction;
            });
        }
    });
}

/// What the direction makes flow out of the cells. Sum over the rows: its product with the direction.
fn apply<R: Scalar>(grid: &Grid, soil: &mut SoilWorkspace<R>, workspace: &mut SeepageWorkspace) {
    let SoilWorkspace { team, partition, row_has_soil, row_values, .. } = soil;
    let SeepageWorkspace { conductance, diagonal, direction, product: flow, .. } = workspace;
    let items = partition.split(flow).zip(partition.split_by(1, row_values)).zip(partition.ranges());
    team.distribute(items, |((flow, values), rows)| {
        let own = rows.clone().zip(flow.chunks_exact_mut(partition.stride)).zip(values.iter_mut());
        for ((row, flow), value) in own {
            *value = [0.0; 2];
            let Some(columns) = columns(grid, row).filter(|_| row_has_soil[row]) else { continue };
            let start = row * partition.stride + columns.start;
            let [_, y, z] = grid.stride;
            let flow = &mut flow[columns];
            outflow(direction, conductance, diagonal, start, [y, z], flow);
            value[0] = product(&direction[start..start + flow.len()], flow);
        }
    });
}

/// Goes so far along the direction. Sum over the rows: the square of the residual that is left.
fn advance<R: Scalar>(
    grid: &Grid,
    soil: &mut SoilWorkspace<R>,
    workspace: &mut SeepageWorkspace,
    length: f64,
) {
    let SoilWorkspace { team, partition, row_has_soil, row_values, .. } = soil;
    let SeepageWorkspace { inverse, change, residual, direction, product: flow, .. } = workspace;
    let items = partition.split(change).zip(partition.split(residual));
    let items = items.zip(partition.split_by(1, row_values)).zip(partition.ranges());
    team.distribute(items, |(((change, residual), values), rows)| {
        let own = change.chunks_exact_mut(partition.stride).zip(residual.chunks_exact_mut(partition.stride));
        for ((row, (change, residual)), value) in rows.clone().zip(own).zip(values.iter_mut()) {
            *value = [0.0; 2];
            let Some(columns) = columns(grid, row).filter(|_| row_has_soil[row]) else { continue };
            let own = row * partition.stride + columns.start..row * partition.stride + columns.end;
            let (change, residual) = (&mut change[columns.clone()], &mut residual[columns]);
            let each = change.iter_mut().zip(residual.iter_mut()).zip(&direction[own.clone()]);
            for (((change, residual), direction), flow) in each.zip(&flow[own.clone()]) {
                *change += length * direction;
                *residual -= length * flow;
            }
            value[0] = weighted(residual, residual, &inverse[own]);
        }
    });
}
