//! The Lagrangian stage: the soil moves, the grid waits.
//!
//! Each worker goes through its planes from the bottom up and through each plane row by row: it strains a row of cells,
//! then moves the row of nodes before it, while the forces are still in the cache. Old and new velocities are two arrays,
//! so nobody reads what another writes; only the lowest plane of nodes of each worker has to wait for the plane of cells
//! below, which is a neighbour's.

use super::stress::{CellRow, NodeRows, RowConstants, strain_row};
use super::workspace::{COEFFICIENTS, Coefficients, NODE_SUMS, RowSums, WorkerScratch, Workspace, lane_sum};
use super::{Real, Soil, State};
use crate::cpu::stopwatch::Stage;
use crate::cpu::threads::{Cut, parts_of};
use crate::grid::{Grid, LANES};
use crate::model::{Model, Wall};
use multiversion::multiversion;
use std::ops::Range;

/// A worker's planes of everything that the stage writes.
struct Part<'a> {
    planes: Range<usize>,
    stress: [&'a mut [Real]; 6],
    plastic_strain: &'a mut [Real],
    gap_strain: &'a mut [Real],
    displacement: [&'a mut [Real]; 3],
    velocity: [&'a mut [Real]; 3],
    sums: &'a mut [RowSums],
    scratch: &'a mut WorkerScratch,
}

/// Everything that the stage only reads.
struct Inputs<'a> {
    model: &'a Model,
    grid: &'a Grid,
    fraction: &'a [Real],
    soil_mass: &'a [Real],
    mass: &'a [Real],
    velocity: [&'a [Real]; 3],
    row_has_soil: &'a [bool],
    /// Whether velocities where no soil is must still be set to zero.
    clears: bool,
    width_x: [&'a [Real]; 2],
    rows: usize,
    dt: f64,
}

/// Steps after which the planes are dealt out anew, for what yields moves on.
const DEALS: u64 = 64;

/// Strains the soil and moves the nodes by one step of `dt` [s]: stresses and displacements at the end of the step,
/// free velocities (before contact) half a step later. Returns the sums over all rows.
pub(crate) fn lagrange(model: &Model, state: &mut State, workspace: &mut Workspace, dt: f64) -> RowSums {
    let grid = &model.grid;
    let rows = Workspace::rows(grid);
    if state.step.is_multiple_of(DEALS) {
        workspace.deal(grid);
    }
    let clears = workspace.clear < 2;
    workspace.clear += u8::from(clears);
    let Workspace { team, cut, row_has_soil, velocity_before, workers, row_sums, width_x, .. } = workspace;
    // From here on the new velocities are in the state, the old ones in the workspace.
    std::mem::swap(&mut state.nodes.velocity, velocity_before);
    let Soil { fraction, mass, stress, plastic_strain, gap_strain, .. } = &mut state.soil;
    let inputs = Inputs {
        model,
        grid,
        fraction,
        soil_mass: mass,
        mass: &state.nodes.mass,
        velocity: velocity_before.each_ref().map(Vec::as_slice),
        row_has_soil,
        clears,
        width_x: width_x.each_ref().map(|w| &w[1..]),
        rows,
        dt,
    };
    let mut stress = stress.each_mut().map(|s| cut.split(s));
    let mut displacement = state.nodes.displacement.each_mut().map(|u| cut.split(u));
    let mut velocity = state.nodes.velocity.each_mut().map(|v| cut.split(v));
    let mut plastic_strain = cut.split(plastic_strain);
    let mut gap_strain = cut.split(gap_strain);
    let mut sums = cut.split_by(rows, row_sums);
    let each = cut.ranges().zip(workers.iter_mut()).map(move |(planes, scratch)| Part {
        planes,
        stress: stress.each_mut().map(|s| s.next().unwrap_or_default()),
        plastic_strain: plastic_strain.next().unwrap_or_default(),
        gap_strain: gap_strain.next().unwrap_or_default(),
        displacement: displacement.each_mut().map(|u| u.next().unwrap_or_default()),
        velocity: velocity.each_mut().map(|v| v.next().unwrap_or_default()),
        sums: sums.next().unwrap_or_default(),
        scratch,
    });
    let mut parts = parts_of(each);
    let parts = &mut parts[..cut.ranges().len()];
    team.share(parts, |part| part.iter_mut().for_each(|part| strain_and_move(&inputs, part)));
    pass_up(parts);
    team.share(parts, |part| part.iter_mut().for_each(|part| move_waiting(&inputs, part)));
    workers[0].stopwatch.lap(Stage::Nodes);
    total(cut, rows, row_sums)
}

fn total(cut: &Cut, rows: usize, row_sums: &[RowSums]) -> RowSums {
    let first = cut.bounds[0] * rows;
    let last = cut.bounds[cut.bounds.len() - 1] * rows;
    row_sums[first..last].iter().fold(RowSums::default(), |a, b| RowSums {
        plastic: a.plastic + b.plastic,
        viscous: a.viscous + b.viscous,
        hourglass: a.hourglass + b.hourglass,
        gravity: a.gravity + b.gravity,
        kinetic: a.kinetic + b.kinetic,
        displacement: a.displacement.max(b.displacement),
        displacement_light: a.displacement_light.max(b.displacement_light),
        yields: a.yields + b.yields,
    })
}

/// Strains all cells of a part and moves all its nodes but the lowest plane.
fn strain_and_move(inputs: &Inputs, part: &mut Part) {
    let row = inputs.grid.stride[1];
    let [_, ny, _] = inputs.grid.cells();
    part.scratch.below.fill(0.0);
    for plane in part.planes.clone() {
        if !inputs.clears && plane_is_void(inputs, plane) {
            continue;
        }
        blank(&mut part.scratch.coefficients[0]);
        for q in 1..=ny + 1 {
            strain_row_of(inputs, part, [q, plane]);
            let WorkerScratch { coefficients: [behind, ahead], below, waiting, row: buffer, .. } =
                &mut *part.scratch;
            let own = NODE_SUMS * q * row..NODE_SUMS * (q + 1) * row;
            let waits = plane == part.planes.start && plane > 1;
            let sum = if waits { &mut waiting[own.clone()] } else { &mut buffer[..NODE_SUMS * row] };
            if nodes_have_soil(inputs, [q, plane]) {
                gather_forces([&behind.values, &ahead.values], row, &mut below[own], sum);
            } else {
                below[own].fill(0.0);
            }
            std::mem::swap(behind, ahead);
            if !waits {
                move_row_of(inputs, part, [q, plane]);
            }
            part.scratch.stopwatch.lap(Stage::Nodes);
        }
    }
}

/// Hands every part the forces of the cells below its lowest plane of nodes, which the part below has worked out.
fn pass_up(parts: &mut [Option<Part>]) {
    for n in (1..parts.len()).rev() {
        let (low, high) = parts.split_at_mut(n);
        if let (Some(low), Some(high)) = (&mut low[n - 1], &mut high[0]) {
            std::mem::swap(&mut low.scratch.below, &mut high.scratch.below);
        }
    }
}

/// Moves the lowest plane of nodes of a part, if it had to wait, now that the cells below are done.
fn move_waiting(inputs: &Inputs, part: &mut Part) {
    let row = inputs.grid.stride[1];
    let plane = part.planes.start;
    // Below the lowest plane of all there is nothing to wait for.
    if part.planes.is_empty() || plane == 1 {
        return;
    }
    for q in 1..=inputs.grid.cells()[1] + 1 {
        let WorkerScratch { below, waiting, row: buffer, .. } = &mut *part.scratch;
        let own = NODE_SUMS * q * row..NODE_SUMS * (q + 1) * row;
        let each = buffer.iter_mut().zip(&below[own.clone()]).zip(&waiting[own]);
        each.for_each(|((sum, below), above)| *sum = below + above);
        move_row_of(inputs, part, [q, plane]);
    }
}

/// No forces.
fn blank(coefficients: &mut Coefficients) {
    if !coefficients.are_zero {
        coefficients.values.fill(0.0);
        coefficients.are_zero = true;
    }
}

/// Whether there is soil round a row of nodes.
fn nodes_have_soil(inputs: &Inputs, [q, plane]: [usize; 2]) -> bool {
    let has_soil = |p: usize, q: usize| inputs.row_has_soil[p * inputs.rows + q];
    [(plane - 1, q - 1), (plane - 1, q), (plane, q - 1), (plane, q)].iter().any(|(p, q)| has_soil(*p, *q))
}

/// Whether there is no soil round a plane of nodes: none of its rows needs a look, and nothing comes from below.
fn plane_is_void(inputs: &Inputs, plane: usize) -> bool {
    !inputs.row_has_soil[(plane - 1) * inputs.rows..(plane + 1) * inputs.rows].contains(&true)
}

/// Strains one row of cells into the second row of coefficients.
fn strain_row_of(inputs: &Inputs, part: &mut Part, [q, plane]: [usize; 2]) {
    let grid = inputs.grid;
    let [_, row, stride] = grid.stride;
    let [_, ny, nz] = grid.cells();
    let n = grid.padded_row();
    let sums = &mut part.sums[(plane - part.planes.start) * inputs.rows + q];
    let WorkerScratch { coefficients: [_, ahead], block, stopwatch, .. } = &mut *part.scratch;
    let has_soil = inputs.row_has_soil[plane * inputs.rows + q];
    if !has_soil || plane > nz || q > ny {
        blank(ahead);
        return;
    }
    let mut constants = RowConstants::new(inputs.model, inputs.width_x, inputs.dt);
    constants.width_y = grid.width(1, q - 1) as Real;
    constants.width_z = grid.width(2, plane - 1) as Real;
    let at = |dq: usize, dp: usize| (plane + dp) * stride + (q + dq) * row + 1;
    let node_rows: NodeRows = [at(0, 0), at(1, 0), at(0, 1), at(1, 1)]
        .map(|start| inputs.velocity.map(|v| &v[start..start + n + 1]));
    let local = (plane - part.planes.start) * stride + q * row + 1;
    let own = local..local + n;
    let start = at(0, 0);
    let mut cell_row = CellRow {
        fraction: &inputs.fraction[start..start + n],
        mass: &inputs.soil_mass[start..start + n],
        stress: part.stress.each_mut().map(|s| &mut s[own.clone()]),
        plastic_strain: &mut part.plastic_strain[own.clone()],
        gap_strain: &mut part.gap_strain[own],
    };
    ahead.are_zero = false;
    let mut out = ahead.values.chunks_exact_mut(row);
    let mut forces: [&mut [Real]; COEFFICIENTS] =
        std::array::from_fn(|_| out.next().map_or(Default::default(), |f| &mut f[1..1 + n]));
    let strained = strain_row(&constants, &node_rows, &mut cell_row, (block, stopwatch), &mut forces);
    (sums.plastic, sums.viscous, sums.hourglass) = (strained.plastic, strained.viscous, strained.hourglass);
    sums.yields = strained.yields;
}

/// Moves one row of nodes under the sums in the row buffer.
fn move_row_of(inputs: &Inputs, part: &mut Part, [q, plane]: [usize; 2]) {
    let [_, row, stride] = inputs.grid.stride;
    let local = (plane - part.planes.start) * stride + q * row;
    let own = local..local + row;
    let sums = &mut part.sums[(plane - part.planes.start) * inputs.rows + q];
    let mut velocity = part.velocity.each_mut().map(|v| &mut v[own.clone()]);
    if !nodes_have_soil(inputs, [q, plane]) {
        if inputs.clears {
            velocity.iter_mut().for_each(|v| v.fill(0.0));
        }
        return;
    }
    let (sum, rest) = part.scratch.row.split_at_mut(NODE_SUMS * row);
    let start = plane * stride + q * row;
    let nodes = NodeRow {
        mass: &inputs.mass[start..start + row],
        before: inputs.velocity.map(|v| &v[start..start + row]),
        displacement: part.displacement.each_mut().map(|u| &mut u[own.clone()]),
    };
    let constants = [inputs.dt, inputs.model.gravity, inputs.model.mass_moved()].map(|x| x as Real);
    move_row(constants, nodes, &mut velocity, sum, rest);
    apply_walls(inputs, [q, plane], &mut velocity);
    let displacement = part.displacement.each_ref().map(|u| &u[own.clone()]);
    finish_row(inputs, start, &velocity, displacement, rest, sums);
}

/// Sums up the forces (x, y, z) and the damping that two rows of cells, behind and ahead along y, exert on the rows of
/// nodes between them. On the nodes at their low z: added to what the cells `below` exert, into `sum`. On those at their
/// high z: into `below`, for the next plane. Pairs that mirror each other are added first, so that a mirrored case
/// gives mirrored sums to the bit.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn gather_forces([behind, ahead]: [&[Real]; 2], n: usize, below: &mut [Real], sum: &mut [Real]) {
    for q in 0..3 {
        let (out, below) = (&mut sum[q * n..][..n], &mut below[q * n..][..n]);
        // Plain part and parts signed by the side.
        let [p0, x0, y0, z0] = [0, 1, 2, 3].map(|c| &behind[(4 * q + c) * n..][..n]);
        let [p1, x1, y1, z1] = [0, 1, 2, 3].map(|c| &ahead[(4 * q + c) * n..][..n]);
        for i in 1..n {
            let behind = [p0[i - 1] + x0[i - 1] + y0[i - 1], p0[i] - x0[i] + y0[i]];
            let ahead = [p1[i - 1] + x1[i - 1] - y1[i - 1], p1[i] - x1[i] - y1[i]];
            let low = ((behind[0] - z0[i - 1]) + (behind[1] - z0[i]))
                + ((ahead[0] - z1[i - 1]) + (ahead[1] - z1[i]));
            let high = ((behind[0] + z0[i - 1]) + (behind[1] + z0[i]))
                + ((ahead[0] + z1[i - 1]) + (ahead[1] + z1[i]));
            out[i] = below[i] + low;
            below[i] = high;
        }
    }
    let (out, below) = (&mut sum[3 * n..][..n], &mut below[3 * n..][..n]);
    let (d0, d1) = (&behind[12 * n..][..n], &ahead[12 * n..][..n]);
    for i in 1..n {
        let both = (d0[i - 1] + d0[i]) + (d1[i - 1] + d1[i]);
        out[i] = below[i] + both;
        below[i] = both;
    }
}

struct NodeRow<'a> {
    mass: &'a [Real],
    before: [&'a [Real]; 3],
    displacement: [&'a mut [Real]; 3],
}

/// Moves a row of nodes: `u += v dt`, `v += (F/m + g) dt`; nodes without mass stay.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn move_row(
    constants: [Real; 3],
    nodes: NodeRow,
    velocity: &mut [&mut [Real]; 3],
    sum: &[Real],
    gravity: &mut [Real],
) {
    let n = nodes.mass.len();
    let [dt, fall, mass_moved] = constants;
    let mass = &nodes.mass[..n];
    let damping = &sum[3 * n..4 * n];
    for q in 0..3 {
        let force = &sum[q * n..(q + 1) * n];
        let before = &nodes.before[q][..n];
        let u = &mut nodes.displacement[q][..n];
        let v = &mut velocity[q][..n];
        let pull = if q == 2 { -fall * dt } else { 0.0 };
        for i in 0..n {
            let moves = mass[i] > mass_moved;
            let m = if moves { mass[i] } else { 1.0 };
            let new = before[i] + dt * (force[i] - before[i] * damping[i]) / m + pull;
            u[i] += dt * before[i];
            v[i] = if moves { new } else { 0.0 };
        }
    }
    let (down, gravity) = (&nodes.before[2][..n], &mut gravity[..n]);
    for i in 0..n {
        gravity[i] = -fall * dt * mass[i] * down[i];
    }
}

/// Takes away the motion through (and along) the walls that a row of nodes lies on.
fn apply_walls(inputs: &Inputs, [q, plane]: [usize; 2], velocity: &mut [&mut [Real]; 3]) {
    let [nx, ny, nz] = inputs.grid.cells();
    let walls = &inputs.model.walls;
    let mut stop = |wall: Wall, axis: usize, columns: Range<usize>| {
        for (component, v) in velocity.iter_mut().enumerate() {
            if component == axis || wall == Wall::Fixed {
                v[columns.clone()].fill(0.0);
            }
        }
    };
    let all = 1..nx + 2;
    for (axis, at, last) in [(1, q, ny), (2, plane, nz)] {
        if at == 1 {
            stop(walls[axis][0], axis, all.clone());
        }
        if at == last + 1 {
            stop(walls[axis][1], axis, all.clone());
        }
    }
    stop(walls[0][0], 0, 1..2);
    stop(walls[0][1], 0, nx + 1..nx + 2);
}

/// Sums up what a row of nodes did.
fn finish_row(
    inputs: &Inputs,
    start: usize,
    velocity: &[&mut [Real]; 3],
    displacement: [&[Real]; 3],
    buffer: &mut [Real],
    sums: &mut RowSums,
) {
    let n = displacement[0].len();
    let mass = &inputs.mass[start..start + n];
    let (gravity, rest) = buffer.split_at_mut(n);
    sums.gravity = lane_sum(gravity);
    let light = LIGHT * inputs.model.density * inputs.model.grid.finest().powi(3);
    let kinetic = &mut rest[..n];
    kinetic_energies(mass, velocity, kinetic);
    sums.kinetic = lane_sum(kinetic);
    [sums.displacement, sums.displacement_light] = largest(mass, light as Real, displacement).map(f64::from);
}

/// Nodes lighter than this share of a full node's mass may be carried farther before a remap is due: a few grains in
/// flight would else make the whole soil be remapped every few steps.
const LIGHT: f64 = 0.02;

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn kinetic_energies(mass: &[Real], velocity: &[&mut [Real]; 3], out: &mut [Real]) {
    let n = out.len();
    let (mass, vx, vy, vz) = (&mass[..n], &velocity[0][..n], &velocity[1][..n], &velocity[2][..n]);
    for i in 0..n {
        out[i] = 0.5 * mass[i] * (vx[i] * vx[i] + vy[i] * vy[i] + vz[i] * vz[i]);
    }
}

/// Largest displacement component of the nodes heavier, and lighter, than `light`.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn largest(mass: &[Real], light: Real, displacement: [&[Real]; 3]) -> [Real; 2] {
    let (mut heavy_lanes, mut light_lanes) = ([0.0; LANES], [0.0; LANES]);
    let whole = mass.len() - mass.len() % LANES;
    let [ux, uy, uz] = displacement.map(|u| u.chunks_exact(LANES));
    for (((m, x), y), z) in mass.chunks_exact(LANES).zip(ux).zip(uy).zip(uz) {
        for l in 0..LANES {
            let xy = if x[l].abs() > y[l].abs() { x[l].abs() } else { y[l].abs() };
            let u = if z[l].abs() > xy { z[l].abs() } else { xy };
            let (heavy, light) = if m[l] > light { (u, 0.0) } else { (0.0, u) };
            heavy_lanes[l] = if heavy > heavy_lanes[l] { heavy } else { heavy_lanes[l] };
            light_lanes[l] = if light > light_lanes[l] { light } else { light_lanes[l] };
        }
    }
    for i in whole..mass.len() {
        let u = displacement.map(|u| u[i].abs()).into_iter().fold(0.0, Real::max);
        let lane = if mass[i] > light { &mut heavy_lanes[0] } else { &mut light_lanes[0] };
        *lane = Real::max(*lane, u);
    }
    [heavy_lanes, light_lanes].map(|lanes| lanes.into_iter().fold(0.0, Real::max))
}
