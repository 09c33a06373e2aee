//! The Lagrangian stage: the soil moves, the grid waits.
//!
//! Each worker goes through its planes from the bottom up: it strains a plane of cells, then moves the nodes under it,
//! while the forces are still in the cache. Old and new velocities are two arrays, so nobody reads what another writes;
//! only the lowest plane of nodes of each worker has to wait for the plane of cells below, which is a neighbour's.

use super::stopwatch::Stage;
use super::stress::{CellRow, NodeRows, RowConstants, strain_row};
use super::threads::Cut;
use super::workspace::{COEFFICIENTS, RowSums, WorkerScratch, Workspace, lane_sum, split_rows};
use crate::grid::{Grid, LANES};
use crate::model::{Model, Wall};
use crate::state::{Soil, State};
use multiversion::multiversion;
use std::ops::Range;

/// A worker's planes of everything that the stage writes.
struct Part<'a> {
    planes: Range<usize>,
    stress: [&'a mut [f64]; 6],
    plastic_strain: &'a mut [f64],
    gap_strain: &'a mut [f64],
    displacement: [&'a mut [f64]; 3],
    velocity: [&'a mut [f64]; 3],
    sums: &'a mut [RowSums],
    scratch: &'a mut WorkerScratch,
}

/// Everything that the stage only reads.
struct Inputs<'a> {
    model: &'a Model,
    grid: &'a Grid,
    fraction: &'a [f64],
    mass: &'a [f64],
    velocity: [&'a [f64]; 3],
    row_has_soil: &'a [bool],
    width_x: &'a [f64],
    /// Force coefficients of a plane without soil.
    no_forces: &'a [f64],
    rows: usize,
    dt: f64,
}

/// Strains the soil and moves the nodes by one step of `dt` [s]: stresses and displacements at the end of the step,
/// free velocities (before contact) half a step later. Returns the sums over all rows.
pub(crate) fn lagrange(model: &Model, state: &mut State, workspace: &mut Workspace, dt: f64) -> RowSums {
    let grid = &model.grid;
    let rows = Workspace::rows(grid);
    let Workspace { team, cut, row_has_soil, velocity_before, workers, row_sums, width_x, no_forces, .. } =
        workspace;
    // From here on the new velocities are in the state, the old ones in the workspace.
    std::mem::swap(&mut state.nodes.velocity, velocity_before);
    let Soil { fraction, stress, plastic_strain, gap_strain, .. } = &mut state.soil;
    let inputs = Inputs {
        model,
        grid,
        fraction,
        mass: &state.nodes.mass,
        velocity: velocity_before.each_ref().map(Vec::as_slice),
        row_has_soil,
        width_x,
        no_forces,
        rows,
        dt,
    };
    let mut stress = stress.each_mut().map(|s| cut.split(s).into_iter());
    let mut displacement = state.nodes.displacement.each_mut().map(|u| cut.split(u).into_iter());
    let mut velocity = state.nodes.velocity.each_mut().map(|v| cut.split(v).into_iter());
    let mut plastic_strain = cut.split(plastic_strain).into_iter();
    let mut gap_strain = cut.split(gap_strain).into_iter();
    let mut sums = split_rows(cut, rows, row_sums).into_iter();
    let mut parts: Vec<Part> = cut
        .ranges()
        .zip(workers.iter_mut())
        .map(|(planes, scratch)| Part {
            planes,
            stress: stress.each_mut().map(|s| s.next().unwrap_or_default()),
            plastic_strain: plastic_strain.next().unwrap_or_default(),
            gap_strain: gap_strain.next().unwrap_or_default(),
            displacement: displacement.each_mut().map(|u| u.next().unwrap_or_default()),
            velocity: velocity.each_mut().map(|v| v.next().unwrap_or_default()),
            sums: sums.next().unwrap_or_default(),
            scratch,
        })
        .collect();
    team.share(&mut parts, |part| strain_and_move(&inputs, part));
    move_seams(&inputs, &mut parts);
    drop(parts);
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
    })
}

/// Strains all planes of a part and moves all its nodes but the lowest plane.
fn strain_and_move(inputs: &Inputs, part: &mut Part) {
    let planes = part.planes.clone();
    for plane in planes.clone() {
        let nth = plane - planes.start;
        let slot = if nth == 0 { 0 } else { 2 - nth % 2 };
        strain_plane(inputs, part, plane, slot);
        if nth > 0 {
            let below = if nth == 1 { 0 } else { 2 - (nth - 1) % 2 };
            let forces = std::mem::take(&mut part.scratch.forces);
            move_plane(inputs, part, plane, [&forces[below], &forces[slot]]);
            part.scratch.forces = forces;
            part.scratch.stopwatch.lap(Stage::Nodes);
        }
        part.scratch.last = slot;
    }
}

/// Moves the lowest plane of nodes of every part, now that the cells below are done.
fn move_seams(inputs: &Inputs, parts: &mut [Part]) {
    for n in 0..parts.len() {
        let below = n.checked_sub(1).map(|b| {
            let last = parts[b].scratch.last;
            (b, last, std::mem::take(&mut parts[b].scratch.forces[last]))
        });
        let above = std::mem::take(&mut parts[n].scratch.forces[0]);
        let plane = parts[n].planes.start;
        if !parts[n].planes.is_empty() {
            let under = below.as_ref().map_or(inputs.no_forces, |b| b.2.as_slice());
            move_plane(inputs, &mut parts[n], plane, [under, &above]);
        }
        parts[n].scratch.forces[0] = above;
        if let Some((b, last, forces)) = below {
            parts[b].scratch.forces[last] = forces;
        }
    }
}

/// Strains one plane of cells into the force buffer `slot`.
fn strain_plane(inputs: &Inputs, part: &mut Part, plane: usize, slot: usize) {
    let grid = inputs.grid;
    let [_, row, stride] = grid.stride;
    let [nx, ny, nz] = grid.cells();
    let n = nx.next_multiple_of(LANES);
    let mut constants = RowConstants::new(inputs.model, &inputs.width_x[1..], inputs.dt);
    let mut forces: Vec<&mut [f64]> = part.scratch.forces[slot].chunks_exact_mut(stride).collect();
    for q in 0..inputs.rows {
        let has_soil = inputs.row_has_soil[plane * inputs.rows + q];
        let cells = q * row + 1..q * row + 1 + n;
        if !has_soil || plane > nz || q == 0 || q > ny {
            let entry = &mut part.sums[(plane - part.planes.start) * inputs.rows + q];
            (entry.plastic, entry.viscous, entry.hourglass) = (0.0, 0.0, 0.0);
            for force in &mut forces {
                force[q * row..(q + 1) * row].fill(0.0);
            }
            continue;
        }
        constants.width_y = grid.width(1, q - 1);
        constants.width_z = grid.width(2, plane - 1);
        let at = |dq: usize, dp: usize| (plane + dp) * stride + (q + dq) * row + 1;
        let node_rows: NodeRows = [at(0, 0), at(1, 0), at(0, 1), at(1, 1)]
            .map(|start| inputs.velocity.map(|v| &v[start..start + n + 1]));
        let local = (plane - part.planes.start) * stride;
        let own = local + cells.start..local + cells.end;
        let start = plane * stride + cells.start;
        let mut cell_row = CellRow {
            fraction: &inputs.fraction[start..start + n],
            stress: part.stress.each_mut().map(|s| &mut s[own.clone()]),
            plastic_strain: &mut part.plastic_strain[own.clone()],
            gap_strain: &mut part.gap_strain[own],
        };
        let mut out = forces.iter_mut();
        let mut force_rows: [&mut [f64]; COEFFICIENTS] =
            std::array::from_fn(|_| out.next().map_or(Default::default(), |f| &mut f[cells.clone()]));
        let own = (&mut *part.scratch.block, &mut part.scratch.stopwatch);
        let sums = strain_row(&constants, &node_rows, &mut cell_row, own, &mut force_rows);
        let entry = &mut part.sums[(plane - part.planes.start) * inputs.rows + q];
        (entry.plastic, entry.viscous, entry.hourglass) = (sums.plastic, sums.viscous, sums.hourglass);
    }
}

/// Moves one plane of nodes under the forces of the planes of cells below and above.
fn move_plane(inputs: &Inputs, part: &mut Part, plane: usize, forces: [&[f64]; 2]) {
    let grid = inputs.grid;
    let [_, row, stride] = grid.stride;
    let [_, ny, _] = grid.cells();
    let WorkerScratch { row: buffer, .. } = part.scratch;
    for q in 1..=ny + 1 {
        let local = (plane - part.planes.start) * stride + q * row;
        let own = local..local + row;
        let sums = &mut part.sums[(plane - part.planes.start) * inputs.rows + q];
        let mut velocity = part.velocity.each_mut().map(|v| &mut v[own.clone()]);
        let (sum, rest) = buffer.split_at_mut(4 * row);
        let has_soil = |p: usize, q: usize| inputs.row_has_soil[p * inputs.rows + q];
        let any = [(plane - 1, q - 1), (plane - 1, q), (plane, q - 1), (plane, q)]
            .iter()
            .any(|(p, q)| has_soil(*p, *q));
        if !any {
            for v in &mut velocity {
                v.fill(0.0);
            }
            (sums.gravity, sums.kinetic, sums.displacement, sums.displacement_light) = (0.0, 0.0, 0.0, 0.0);
            continue;
        }
        let start = plane * stride + q * row;
        let nodes = NodeRow {
            mass: &inputs.mass[start..start + row],
            before: inputs.velocity.map(|v| &v[start..start + row]),
            displacement: part.displacement.each_mut().map(|u| &mut u[own.clone()]),
        };
        gather_forces(forces, stride, [q * row, row], sum);
        let constants = [inputs.dt, inputs.model.gravity, inputs.model.mass_moved()];
        move_row(constants, nodes, &mut velocity, sum, rest);
        apply_walls(inputs, [q, plane], &mut velocity);
        finish_row(
            inputs,
            start,
            &velocity,
            part.displacement.each_ref().map(|u| &u[own.clone()]),
            rest,
            sums,
        );
    }
}

/// Sums up the forces (x, y, z) and the damping that the four rows of cells round a row of nodes exert on it. Pairs that
/// mirror each other are added first, so that a mirrored case gives mirrored sums to the bit.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn gather_forces(planes: [&[f64]; 2], stride: usize, [start, n]: [usize; 2], sum: &mut [f64]) {
    for q in 0..3 {
        let out = &mut sum[q * n..(q + 1) * n];
        // By plane (below, above) and row (low y, high y): plain part and parts signed by the side.
        let part = |level: usize, behind: usize, c: usize| {
            let first = (4 * q + c) * stride + start - behind * n;
            &planes[level][first..first + n]
        };
        let row = |level: usize, behind: usize| [0, 1, 2, 3].map(|c| part(level, behind, c));
        let [p00, x00, y00, z00] = row(0, 1);
        let [p10, x10, y10, z10] = row(0, 0);
        let [p01, x01, y01, z01] = row(1, 1);
        let [p11, x11, y11, z11] = row(1, 0);
        for i in 1..n {
            let below_low =
                (p00[i - 1] + x00[i - 1] + y00[i - 1] + z00[i - 1]) + (p00[i] - x00[i] + y00[i] + z00[i]);
            let below_high =
                (p10[i - 1] + x10[i - 1] - y10[i - 1] + z10[i - 1]) + (p10[i] - x10[i] - y10[i] + z10[i]);
            let above_low =
                (p01[i - 1] + x01[i - 1] + y01[i - 1] - z01[i - 1]) + (p01[i] - x01[i] + y01[i] - z01[i]);
            let above_high =
                (p11[i - 1] + x11[i - 1] - y11[i - 1] - z11[i - 1]) + (p11[i] - x11[i] - y11[i] - z11[i]);
            out[i] = (below_low + below_high) + (above_low + above_high);
        }
        out[0] = 0.0;
    }
    let damping = |level: usize, behind: usize| &planes[level][12 * stride + start - behind * n..][..n];
    let (d00, d10, d01, d11) = (damping(0, 1), damping(0, 0), damping(1, 1), damping(1, 0));
    let out = &mut sum[3 * n..4 * n];
    for i in 1..n {
        let below = (d00[i - 1] + d00[i]) + (d10[i - 1] + d10[i]);
        let above = (d01[i - 1] + d01[i]) + (d11[i - 1] + d11[i]);
        out[i] = below + above;
    }
    out[0] = 0.0;
}

struct NodeRow<'a> {
    mass: &'a [f64],
    before: [&'a [f64]; 3],
    displacement: [&'a mut [f64]; 3],
}

/// Moves a row of nodes: `u += v dt`, `v += (F/m + g) dt`; nodes without mass stay.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn move_row(
    constants: [f64; 3],
    nodes: NodeRow,
    velocity: &mut [&mut [f64]; 3],
    sum: &[f64],
    gravity: &mut [f64],
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
fn apply_walls(inputs: &Inputs, [q, plane]: [usize; 2], velocity: &mut [&mut [f64]; 3]) {
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
    velocity: &[&mut [f64]; 3],
    displacement: [&[f64]; 3],
    buffer: &mut [f64],
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
    [sums.displacement, sums.displacement_light] = largest(mass, light, displacement);
}

/// Nodes lighter than this share of a full node's mass may be carried farther before a remap is due: a few grains in
/// flight would else make the whole soil be remapped every few steps.
const LIGHT: f64 = 0.02;

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn kinetic_energies(mass: &[f64], velocity: &[&mut [f64]; 3], out: &mut [f64]) {
    let n = out.len();
    let (mass, vx, vy, vz) = (&mass[..n], &velocity[0][..n], &velocity[1][..n], &velocity[2][..n]);
    for i in 0..n {
        out[i] = 0.5 * mass[i] * (vx[i] * vx[i] + vy[i] * vy[i] + vz[i] * vz[i]);
    }
}

/// Largest displacement component of the nodes heavier, and lighter, than `light`.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
fn largest(mass: &[f64], light: f64, displacement: [&[f64]; 3]) -> [f64; 2] {
    let [ux, uy, uz] = displacement.map(|u| u.chunks_exact(LANES));
    let (mut heavy_lanes, mut light_lanes) = ([0.0; LANES], [0.0; LANES]);
    for (((m, x), y), z) in mass.chunks_exact(LANES).zip(ux).zip(uy).zip(uz) {
        for l in 0..LANES {
            let xy = if x[l].abs() > y[l].abs() { x[l].abs() } else { y[l].abs() };
            let u = if z[l].abs() > xy { z[l].abs() } else { xy };
            let (heavy, light) = if m[l] > light { (u, 0.0) } else { (0.0, u) };
            heavy_lanes[l] = if heavy > heavy_lanes[l] { heavy } else { heavy_lanes[l] };
            light_lanes[l] = if light > light_lanes[l] { light } else { light_lanes[l] };
        }
    }
    [heavy_lanes, light_lanes].map(|lanes| lanes.into_iter().fold(0.0, f64::max))
}
