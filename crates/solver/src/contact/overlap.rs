//! Overlap removal: soil inside a body is moved to void next to it.
//!
//! The soil's velocity is continuous. Near a sharp edge it therefore lags behind the body on the inner side
//! and is dragged along on the outer: soil enters the body, and a void opens next to it. After a remap, soil
//! that overlaps a body (volume fractions of soil and bodies add up to more than 1) moves to neighbouring
//! cells that hold soil and have space, with its mass, momentum, stress and history. Soil for which there is
//! no space stays, unless a body fills its cell: there it cannot be compressed (see [`super::confined`]), and
//! is pressed into the soil beside the body, a little at a time.
//!
//! All sums over neighbours are taken in an order for which mirroring in y changes no bit.

use super::body_fraction::{FILLED, filled, find_bodies, near};
use super::problem::{corners, over_corners};
use super::workspace::ContactWorkspace;
use crate::cpu::fields_on_device::DeviceRemap;
use crate::cpu::threads::Crew;
use crate::cpu::workspace::SoilWorkspace;
use crate::fields::Carrier;
use crate::grid::Grid;
use crate::halo::Halo;
use crate::halo::filling::{At, fill};
use crate::kernels::Kernels;
use crate::model::Model;
use crate::scalar::Scalar;
use crate::state::{Nodes, State};
use glam::DVec3;
use std::collections::BTreeMap;

/// Rounds of redistribution; each moves the overlap that the one before has left.
const ROUNDS: usize = 3;

/// Updates the body volume fractions and moves overlapping soil out of the bodies.
pub(crate) fn remove_overlap<R: Kernels>(
    model: &Model,
    state: &mut State<R>,
    soil: &mut SoilWorkspace<R>,
    contact: &mut ContactWorkspace,
    halo: &Halo,
) {
    find_bodies(model, state, soil, &mut contact.body_cells);
    if let Some(device) = &mut soil.device {
        device.take_region(model, state, near(&model.grid, &contact.body_cells));
    }
    let own = contact.body_cells.iter().map(|c| c.cell);
    let mut cells: Vec<usize> = own.filter(|cell| model.grid.is_in_domain(*cell)).collect();
    cells.sort_unstable();
    cells.dedup();
    let mut filled = filled(&contact.body_cells);
    filled.retain(|cell| model.grid.is_in_domain(*cell));
    let mut round = |cells: &[usize], room| redistribute(model, state, soil, halo, cells, room);
    for _ in 0..ROUNDS {
        if !round(&cells, Room::Space) {
            break;
        }
    }
    round(&filled, Room::Soil);
}

/// One round: moves what overlaps in some cells; returns whether anything did in any block.
fn redistribute<R: Kernels>(
    model: &Model,
    state: &mut State<R>,
    soil: &mut SoilWorkspace<R>,
    halo: &Halo,
    cells: &[usize],
    room: Room,
) -> bool {
    let fractions = [&state.soil.fraction, &soil.velocity_before[0]].map(Vec::as_slice);
    let transfers = distribute(&model.grid, fractions, room, cells, soil.crew());
    let mut left = [transfers.len() as i64];
    halo.add(&mut left);
    if left == [0] {
        return false;
    }
    transfer(model, state, soil, &transfers);
    fill(halo, &model.grid, At::Cells, state.soil.arrays_mut());
    let nodes = state.nodes.velocity.iter_mut().chain([&mut state.nodes.mass]);
    fill(halo, &model.grid, At::Nodes, nodes);
    true
}

/// Where overlapping soil goes.
#[derive(Clone, Copy, Debug)]
enum Room {
    /// Into the space of cells that are not full.
    Space,
    /// Into soil beside the bodies.
    Soil,
}

/// Soil that a cell takes up by pressing in a remap, over what it holds (chosen).
const PRESSED_AT_ONCE: f64 = 0.02;

/// Soil that moves from one cell to another.
#[derive(Clone, Copy, Debug)]
struct Transfer {
    from: usize,
    to: usize,
    /// Offset along y in layers, plus 1.
    side: usize,
    /// Volume [m³].
    volume: f64,
}

/// A sum whose terms come from three layers in y.
#[derive(Clone, Copy, Debug, Default)]
struct Layered<T>([T; 3]);

impl<T: Copy + std::ops::Add<Output = T>> Layered<T> {
    fn add(&mut self, layer: usize, value: T) {
        self.0[layer] = self.0[layer] + value;
    }

    fn total(&self) -> T {
        (self.0[0] + self.0[2]) + self.0[1]
    }
}

/// Indices of a cell's 26 neighbours in the domain, and their layer in y (0 to 2).
fn neighbours(grid: &Grid, cell: usize) -> impl Iterator<Item = (usize, usize)> + '_ {
    let (layers, inside) = (grid.layers_of(cell), [0, 1, 2].map(|axis| grid.inside(axis)));
    (0..27).filter(|n| *n != 13).filter_map(move |n| {
        let step = [n % 3, n / 3 % 3, n / 9];
        let mut at = [0; 3];
        for axis in 0..3 {
            at[axis] = (layers[axis] + step[axis]).checked_sub(1).filter(|p| inside[axis].contains(p))?;
        }
        Some((grid.index(at[0], at[1], at[2]), step[1]))
    })
}

/// The transfers of a round: an overlap is distributed over all neighbours with space, in proportion to it; a
/// cell that would receive more than it has space for reduces all transfers to it by the same factor.
fn distribute<R: Scalar>(
    grid: &Grid,
    [fraction, body_fraction]: [&[R]; 2],
    room: Room,
    cells: &[usize],
    crew: Crew,
) -> Vec<Transfer> {
    /// Cells that a thread takes at once.
    const AT_ONCE: usize = 64;
    let held = |c: usize| fraction[c].to_f64();
    let body = |c: usize| body_fraction[c].to_f64();
    let overlap = |c: usize| (held(c) + body(c) - 1.0) * grid.volume_of(c);
    let space = |c: usize| match room {
        Room::Space => -overlap(c),
        Room::Soil if body(c) >= FILLED => 0.0,
        Room::Soil => PRESSED_AT_ONCE * held(c) * (1.0 - body(c)) * grid.volume_of(c),
    };
    let smallest = |from: usize| R::ROUND_OFF * grid.volume_of(from);
    let excess = |from: usize| overlap(from).min(held(from) * grid.volume_of(from));
    let of_cell = |from: usize| {
        let (smallest, excess) = (smallest(from), excess(from));
        // Only into cells with soil: it would otherwise be ejected into the void.
        let receives = move |n: usize| fraction[n] > R::default() && space(n) > smallest;
        let receivers = move || neighbours(grid, from).filter(move |(n, _)| receives(*n));
        let mut total = Layered::default();
        receivers().for_each(|(n, side)| total.add(side, space(n)));
        let total = total.total();
        receivers().map(move |(to, side)| {
            let volume = excess.min(total) * space(to) / total;
            Transfer { from, to, side, volume }
        })
    };
    let each = crew.collect(cells.len(), AT_ONCE, |range| {
        let overlapping = cells[range].iter().filter(|from| excess(**from) > smallest(**from));
        overlapping.flat_map(|from| of_cell(*from)).collect::<Vec<_>>()
    });
    let mut transfers = each.concat();
    let mut demand: BTreeMap<usize, Layered<f64>> = BTreeMap::new();
    transfers.iter().for_each(|t| demand.entry(t.to).or_default().add(t.side, t.volume));
    for t in &mut transfers {
        t.volume *= (space(t.to) / demand[&t.to].total()).min(1.0);
    }
    transfers
}

/// Gains and losses of a cell.
#[derive(Clone, Debug, Default)]
struct Change {
    volume_out: Layered<f64>,
    volume_in: Layered<f64>,
    mass_in: Layered<f64>,
    momentum_in: Layered<DVec3>,
    /// Carried quantities, each times its volume or mass.
    carried_in: Vec<Layered<f64>>,
}

/// Moves soil with all its carried quantities.
fn transfer<R: Kernels>(
    model: &Model,
    state: &mut State<R>,
    workspace: &mut SoilWorkspace<R>,
    transfers: &[Transfer],
) {
    let grid = &model.grid;
    let State { soil, nodes, .. } = state;
    let mut changes: BTreeMap<usize, Change> = BTreeMap::new();
    for t in transfers {
        changes.entry(t.from).or_default().volume_out.add(t.side, t.volume);
        let held = soil.fraction[t.from].to_f64() * grid.volume_of(t.from);
        let mass = soil.mass[t.from].to_f64() * t.volume / held;
        let velocity = 0.125 * over_corners(corners(grid.stride).map(|n| velocity(nodes, t.from + n)));
        let change = changes.entry(t.to).or_default();
        change.volume_in.add(t.side, t.volume);
        change.mass_in.add(t.side, mass);
        change.momentum_in.add(t.side, mass * velocity);
        change.carried_in.resize_with(soil.carried().count(), Layered::default);
        for (sum, (carrier, field)) in change.carried_in.iter_mut().zip(soil.carried()) {
            let amount = if carrier == Carrier::Volume { t.volume } else { mass };
            sum.add(t.side, amount * field[t.from].to_f64());
        }
    }
    let mut masses = BTreeMap::new();
    for (c, change) in &changes {
        let held = soil.fraction[*c].to_f64() * grid.volume_of(*c);
        let (out, into) = (change.volume_out.total(), change.volume_in.total());
        let mass_out = soil.mass[*c].to_f64() * out / held;
        let mass_in = change.mass_in.total();
        let held_mass = soil.mass[*c].to_f64();
        // Round-off must not leave an emptied cell with a negative volume.
        soil.fraction[*c] = R::cast((held + (into - out)).max(0.0) / grid.volume_of(*c));
        soil.mass[*c] = R::cast((held_mass + (mass_in - mass_out)).max(0.0));
        if into > 0.0 {
            for ((carrier, field), sum) in soil.carried_mut().zip(&change.carried_in) {
                let [own, added] = match carrier {
                    Carrier::Volume => [held, into],
                    Carrier::Mass => [held_mass, mass_in],
                };
                field[*c] = R::cast((field[*c].to_f64() * own + sum.total()) / (own + added));
            }
            R::update_cell(model, soil, workspace, *c);
        }
        masses.insert(*c, (mass_out, mass_in, change.momentum_in.total()));
    }
    move_nodes(grid, nodes, &masses);
}

fn velocity<R: Scalar>(nodes: &Nodes<R>, n: usize) -> DVec3 {
    DVec3::from_array(nodes.velocity.each_ref().map(|component| component[n].to_f64()))
}

/// Updates nodal masses and momenta: an eighth of a cell's mass is lumped at each corner; leaving soil takes
/// its momentum along, arriving soil mixes its own in.
fn move_nodes<R: Scalar>(grid: &Grid, nodes: &mut Nodes<R>, changes: &BTreeMap<usize, (f64, f64, DVec3)>) {
    let corners = corners(grid.stride);
    let mut affected: Vec<usize> = changes.keys().flat_map(|c| corners.map(|n| c + n)).collect();
    affected.sort_unstable();
    affected.dedup();
    for n in affected {
        let of = corners.map(|back| changes.get(&(n - back)).copied().unwrap_or_default());
        let out = 0.125 * over_corners(of.map(|c| c.0));
        let mass_in = 0.125 * over_corners(of.map(|c| c.1));
        let momentum = 0.125 * over_corners(of.map(|c| c.2));
        let left = (nodes.mass[n].to_f64() - out).max(0.0);
        nodes.mass[n] = R::cast(left + mass_in);
        if mass_in > 0.0 {
            let new = (left * velocity(nodes, n) + momentum) / (left + mass_in);
            for (v, new) in nodes.velocity.iter_mut().zip(new.to_array()) {
                v[n] = R::cast(new);
            }
        }
    }
}
