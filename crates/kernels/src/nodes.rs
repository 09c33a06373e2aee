//! One row of nodes: forces of the cells around it → velocity, displacement, energies. Rows are passed
//! without their first ghost.

use super::Real;
use super::lanes::{lane_max, lane_sum};
use crate::sums::{Measured, NODE_SUMS};
use multiversion::multiversion;

/// Constants of all nodes.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct NodeConstants {
    /// Time step [s].
    pub dt: Real,
    /// Gravity along x, y, z [m/s²].
    pub gravity: [Real; 3],
    /// Whether gravity acts along x or y, too.
    pub is_tilted: bool,
    /// Mass above which a node moves [kg].
    pub mass_moved: Real,
    /// Nodes lighter than this [kg] may move farther before a remap is due: otherwise a few grains in flight
    /// would cause a remap every few steps.
    pub light: Real,
    /// Inverse of the aspect of the cells along x, y, z.
    pub per_aspect: [Real; 3],
}

/// A row of nodes.
pub struct NodeRow<'a> {
    /// Mass [kg].
    pub mass: &'a [Real],
    /// Velocity half a step ago [m/s].
    pub before: [&'a [Real]; 3],
    /// Displacement since the last remap [m].
    pub displacement: [&'a mut [Real]; 3],
    /// Velocity half a step ahead [m/s].
    pub velocity: [&'a mut [Real]; 3],
}

/// Sums the forces (x, y, z) and the damping that two rows of cells, behind and ahead along y, exert on the
/// rows of nodes between them. Those on the nodes at low z are added to those of the cells `below` and stored
/// in `sum`; those on the nodes at high z are stored in `below`, for the next plane. Arrays are rows of
/// `stride` with `nodes` nodes after the first ghost. Mirror images are added first, so that a mirrored case
/// gives mirrored sums to the bit.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
pub fn gather_forces(
    [behind, ahead]: [&[Real]; 2],
    [stride, nodes]: [usize; 2],
    below: &mut [Real],
    sum: &mut [Real],
) {
    for q in 0..3 {
        let own = q * stride + 1..q * stride + 1 + nodes;
        let (behind, ahead) = (&behind[4 * q * stride..], &ahead[4 * q * stride..]);
        gather_component([behind, ahead], stride, &mut below[own.clone()], &mut sum[own]);
    }
    let own = 3 * stride + 1..3 * stride + 1 + nodes;
    gather_damping([&behind[12 * stride..], &ahead[12 * stride..]], &mut below[own.clone()], &mut sum[own]);
}

/// Upper limit of the length of a row, from which the compiler knows that no index can overflow.
const LONGEST: usize = 1 << 40;

/// One component of the force.
#[inline(always)]
fn gather_component([behind, ahead]: [&[Real]; 2], stride: usize, below: &mut [Real], out: &mut [Real]) {
    let n = out.len().min(LONGEST);
    let (below, out) = (&mut below[..n], &mut out[..n]);
    // Plain and signed terms; node i has cell i on its low side along x and cell i + 1 on its high side.
    let [p, x, y, z] = [0, 1, 2, 3].map(|c| &behind[c * stride..][..=n]);
    let [r, s, t, u] = [0, 1, 2, 3].map(|c| &ahead[c * stride..][..=n]);
    for i in 0..n {
        let behind = [p[i] + x[i] + y[i], p[i + 1] - x[i + 1] + y[i + 1]];
        let ahead = [r[i] + s[i] - t[i], r[i + 1] - s[i + 1] - t[i + 1]];
        let low = ((behind[0] - z[i]) + (behind[1] - z[i + 1])) + ((ahead[0] - u[i]) + (ahead[1] - u[i + 1]));
        let high =
            ((behind[0] + z[i]) + (behind[1] + z[i + 1])) + ((ahead[0] + u[i]) + (ahead[1] + u[i + 1]));
        out[i] = below[i] + low;
        below[i] = high;
    }
}

#[inline(always)]
fn gather_damping([behind, ahead]: [&[Real]; 2], below: &mut [Real], out: &mut [Real]) {
    let n = out.len().min(LONGEST);
    let (behind, ahead, below, out) = (&behind[..=n], &ahead[..=n], &mut below[..n], &mut out[..n]);
    for i in 0..n {
        let both = (behind[i] + behind[i + 1]) + (ahead[i] + ahead[i + 1]);
        out[i] = below[i] + both;
        below[i] = both;
    }
}

/// Moves a row of nodes: `u += v dt`, `v += (F/m + g) dt`; nodes without mass stay. The sums are rows of
/// `stride`.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
pub fn move_row(constants: &NodeConstants, nodes: &mut NodeRow, sum: &[Real], stride: usize) {
    let n = nodes.mass.len();
    let sum_of = |q: usize| &sum[q * stride + 1..][..n];
    for q in 0..3 {
        let inputs = [nodes.mass, nodes.before[q], sum_of(q), sum_of(NODE_SUMS - 1)];
        let gain = constants.gravity[q] * constants.dt;
        move_component(constants, inputs, gain, nodes.displacement[q], nodes.velocity[q]);
    }
}

#[inline(always)]
fn move_component(
    constants: &NodeConstants,
    [mass, before, force, damping]: [&[Real]; 4],
    gravity: Real,
    u: &mut [Real],
    v: &mut [Real],
) {
    let n = v.len();
    let NodeConstants { dt, mass_moved, .. } = *constants;
    let (mass, before, force, damping) = (&mass[..n], &before[..n], &force[..n], &damping[..n]);
    let u = &mut u[..n];
    for i in 0..n {
        let new = before[i] + dt * (force[i] - before[i] * damping[i]) / mass[i] + gravity;
        u[i] += dt * before[i];
        v[i] = if mass[i] > mass_moved { new } else { 0.0 };
    }
}

/// Sums over a row of nodes; `buffer` is scratch memory for four numbers a node.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx2+fma", "x86_64+avx2+fma"))]
pub fn finish_row(constants: &NodeConstants, nodes: &NodeRow, buffer: &mut [Real]) -> Measured {
    let n = nodes.mass.len();
    let (gravity, rest) = buffer.split_at_mut(n);
    let (kinetic, rest) = rest.split_at_mut(n);
    let (heavy, rest) = rest.split_at_mut(n);
    let light = &mut rest[..n];
    measure_nodes(constants, nodes, gravity, kinetic, [heavy, light]);
    if constants.is_tilted {
        add_tilted(constants, nodes, gravity);
    }
    Measured {
        gravity: lane_sum(gravity),
        kinetic: lane_sum(kinetic),
        displacement: lane_max(heavy).into(),
        displacement_light: lane_max(light).into(),
    }
}

/// For each node: work of gravity, kinetic energy, and the largest component of the displacement over the
/// aspect of the cells, separately for heavy and light nodes.
#[inline(always)]
fn measure_nodes(
    constants: &NodeConstants,
    nodes: &NodeRow,
    gravity: &mut [Real],
    kinetic: &mut [Real],
    [heavy, light]: [&mut [Real]; 2],
) {
    let n = gravity.len();
    let (mass, down) = (&nodes.mass[..n], &nodes.before[2][..n]);
    let [vx, vy, vz] = nodes.velocity.each_ref().map(|v| &v[..n]);
    let [ux, uy, uz] = nodes.displacement.each_ref().map(|u| &u[..n]);
    let (kinetic, heavy, light) = (&mut kinetic[..n], &mut heavy[..n], &mut light[..n]);
    let [per_x, per_y, per_z] = constants.per_aspect;
    let velocity_gain = constants.gravity[2] * constants.dt;
    for i in 0..n {
        gravity[i] = velocity_gain * mass[i] * down[i];
        kinetic[i] = 0.5 * mass[i] * (vx[i] * vx[i] + vy[i] * vy[i] + vz[i] * vz[i]);
        let [x, y, z] = [per_x * ux[i].abs(), per_y * uy[i].abs(), per_z * uz[i].abs()];
        let xy = if x > y { x } else { y };
        let u = if z > xy { z } else { xy };
        let is_heavy = mass[i] > constants.light;
        heavy[i] = if is_heavy { u } else { 0.0 };
        light[i] = if is_heavy { 0.0 } else { u };
    }
}

/// Adds the work of gravity along x and y to that along z.
#[inline(always)]
fn add_tilted(constants: &NodeConstants, nodes: &NodeRow, gravity: &mut [Real]) {
    let n = gravity.len();
    let mass = &nodes.mass[..n];
    let [x, y] = [0, 1].map(|q| constants.gravity[q] * constants.dt);
    let (along, across) = (&nodes.before[0][..n], &nodes.before[1][..n]);
    for i in 0..n {
        gravity[i] += mass[i] * (x * along[i] + y * across[i]);
    }
}
