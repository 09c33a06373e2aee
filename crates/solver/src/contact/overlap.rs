//! Soil that has got into a body is put back outside, into the void beside it.
//!
//! The soil's velocity is continuous. Near a sharp edge it therefore lags behind the body on the inner side and is dragged
//! along on the outer: what enters the body is what goes missing beside it. After a remap, soil that overlaps a body (volume
//! fraction and share of the body above 1) moves to neighbouring cells that hold soil and have room, with its mass, its
//! momentum, its stress and history. Soil for which there is no room stays.
//!
//! All sums run over neighbours in an order that a mirror in y does not change to the bit.

use super::body_fraction::find_bodies;
use super::scene::{corners, over_corners};
use super::workspace::ContactWorkspace;
use crate::cpu::workspace::SoilWorkspace;
use crate::fields::Carrier;
use crate::grid::Grid;
use crate::halo::{self, At, Halo};
use crate::model::Model;
use crate::precision::Precision;
use crate::real::Real;
use crate::state::{Nodes, State};
use glam::DVec3;
use std::collections::BTreeMap;

/// Rounds of sharing out; each serves what the last left over.
const ROUNDS: usize = 3;

/// Finds anew where the bodies are, and puts overlapping soil back outside them.
pub(crate) fn remove_overlap<R: Precision>(
    model: &Model,
    state: &mut State<R>,
    soil: &mut SoilWorkspace<R>,
    contact: &mut ContactWorkspace,
    halo: &mut dyn Halo,
) {
    find_bodies(model, &mut state.bodies, &mut soil.velocity_before[0], &mut contact.body_cells);
    let mut cells: Vec<usize> = contact.body_cells.iter().map(|c| c.cell).collect();
    cells.sort_unstable();
    cells.dedup();
    for _ in 0..ROUNDS {
        let transfers = share_out(&model.grid, &state.soil.fraction, &soil.velocity_before[0], &cells);
        let is_done = halo::in_order(halo, std::iter::once((0, [transfers.len() as f64])));
        if is_done.iter().all(|(_, [left])| *left == 0.0) {
            break;
        }
        carry(model, state, soil, &transfers);
        halo::fill(halo, &model.grid, At::Cells, state.soil.arrays_mut());
        let nodes = state.nodes.velocity.iter_mut().chain([&mut state.nodes.mass]);
        halo::fill(halo, &model.grid, At::Nodes, nodes);
    }
}

/// Soil that goes from one cell to another.
#[derive(Clone, Copy, Debug)]
struct Transfer {
    from: usize,
    to: usize,
    /// Layers that it moves by along y, plus 1.
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

/// Places of a cell's 26 neighbours inside the grid, and their layer in y (0 to 2).
fn neighbours(grid: &Grid, cell: usize) -> impl Iterator<Item = (usize, usize)> + '_ {
    let (place, cells) = (grid.place(cell), grid.cells());
    (0..27).filter(|n| *n != 13).filter_map(move |n| {
        let step = [n % 3, n / 3 % 3, n / 9];
        let mut at = [0; 3];
        for axis in 0..3 {
            at[axis] = (place[axis] + step[axis]).checked_sub(1).filter(|p| *p < cells[axis])?;
        }
        Some((grid.index(at[0], at[1], at[2]), step[1]))
    })
}

/// Which soil goes where: every overlap asks all neighbours that have room, in proportion to it; a cell that is asked for
/// more than it can take gives each the same share.
fn share_out<R: Real>(grid: &Grid, fraction: &[R], occupied: &[R], cells: &[usize]) -> Vec<Transfer> {
    let held = |c: usize| fraction[c].to_f64();
    let room = |c: usize| (1.0 - occupied[c].to_f64() - held(c)) * grid.volume_of(c);
    let mut asked: BTreeMap<usize, Layered<f64>> = BTreeMap::new();
    let mut transfers = Vec::new();
    for &from in cells {
        let smallest = R::ROUND_OFF * grid.volume_of(from);
        let excess = (-room(from)).min(held(from) * grid.volume_of(from));
        if excess <= smallest {
            continue;
        }
        // Soil only joins soil: it would else be thrown into the air.
        let takers =
            || neighbours(grid, from).filter(|(n, _)| fraction[*n] > R::default() && room(*n) > smallest);
        let mut total = Layered::default();
        takers().for_each(|(n, side)| total.add(side, room(n)));
        let total = total.total();
        for (to, side) in takers() {
            let volume = excess.min(total) * room(to) / total;
            asked.entry(to).or_default().add(side, volume);
            transfers.push(Transfer { from, to, side, volume });
        }
    }
    for t in &mut transfers {
        t.volume *= (room(t.to) / asked[&t.to].total()).min(1.0);
    }
    transfers
}

/// What comes into a cell and leaves it.
#[derive(Clone, Debug, Default)]
struct Change {
    volume_out: Layered<f64>,
    volume_in: Layered<f64>,
    mass_in: Layered<f64>,
    momentum_in: Layered<DVec3>,
    /// All that soil carries, each times its volume or mass.
    carried_in: Vec<Layered<f64>>,
}

/// Moves soil with all that it carries.
fn carry<R: Precision>(
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
        // A cell that is emptied must not hold less than nothing by a rounding.
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

fn velocity<R: Real>(nodes: &Nodes<R>, n: usize) -> DVec3 {
    DVec3::from_array(nodes.velocity.each_ref().map(|component| component[n].to_f64()))
}

/// An eighth of a cell's mass hangs on each corner: what leaves takes its momentum with it, what comes mixes.
fn move_nodes<R: Real>(grid: &Grid, nodes: &mut Nodes<R>, changes: &BTreeMap<usize, (f64, f64, DVec3)>) {
    let corners = corners(grid.stride);
    let mut touched: Vec<usize> = changes.keys().flat_map(|c| corners.map(|n| c + n)).collect();
    touched.sort_unstable();
    touched.dedup();
    for n in touched {
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
