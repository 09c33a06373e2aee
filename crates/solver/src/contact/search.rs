//! Contact search: the cells in which contact points lie, and the gaps between body and soil.

use super::body_fraction::{FILLED, find_bodies, measure_bodies};
use super::carried::{REMNANT, is_among_filled};
use super::law::ContactLaw;
use super::neighbours::Neighbours;
use super::place::{Place, place};
use super::problem::{corners, over_corners};
use super::slip::clear_rims;
use super::surface::Surface;
use super::workspace::ContactWorkspace;
use crate::cpu::stopwatch::Stage;
use crate::cpu::workspace::SoilWorkspace;
use crate::fields::{INTACT_STRENGTH, PLASTIC_STRAIN};
use crate::halo::{self, Halo};
use crate::model::{BodyModel, Model};
use crate::scalar::Scalar;
use crate::state::{Contact, Pose, Soil, State};
use glam::DVec3;
use std::ops::Range;

/// The first contact search of a run, which also computes the body volume fractions and begins the sums over
/// the rims.
pub(crate) fn first_search<R: Scalar>(
    model: &Model,
    state: &mut State<R>,
    soil: &mut SoilWorkspace<R>,
    workspace: &mut ContactWorkspace,
    halo: &Halo,
) {
    clear_rims(model, state, workspace);
    find_bodies(model, state, soil, &mut workspace.body_cells);
    search(model, state, soil, workspace, halo);
}

/// Finds the contact points that have soil to act on, with their cells, weights and gaps; measures leaked and
/// embedded volumes. Done after every remap.
pub(crate) fn search<R: Scalar>(
    model: &Model,
    state: &mut State<R>,
    soil: &mut SoilWorkspace<R>,
    workspace: &mut ContactWorkspace,
    halo: &Halo,
) {
    let ContactWorkspace { body_cells, surfaces, law, .. } = workspace;
    measure_bodies(model, state, body_cells, halo);
    let view = View {
        model,
        soil: &state.soil,
        node_mass: &state.nodes.mass,
        body_fraction: &soil.velocity_before[0],
        material: &soil.material,
        grid_position: state.grid_position,
        known: &state.contacts,
        law: law.as_ref(),
    };
    let mut found = Vec::with_capacity(state.contacts.len());
    for (n, surface) in surfaces.iter().enumerate() {
        let (pose, neighbours) = (state.pose(n), &Neighbours::of(model, state, n));
        let search = |points| view.search(n, pose, neighbours, surface, points);
        let each = soil.crew().collect(surface.len(), POINTS_AT_ONCE, search);
        found.extend(each.into_iter().flatten());
    }
    for c in body_cells {
        soil.velocity_before[0][c.cell] = R::default();
    }
    state.contacts = all_contacts(found, halo);
    workspace.connect(model, state, soil.crew(), halo);
    soil.strain_first(&model.grid, workspace.first_row(&model.grid, halo));
    soil.stopwatch().lap(Stage::Contact);
}

/// Points of a surface that a thread takes at once.
const POINTS_AT_ONCE: usize = 64;

/// The contacts found by all blocks, in the order of bodies and points.
fn all_contacts(found: Vec<Contact>, halo: &Halo) -> Vec<Contact> {
    if halo.is_alone() {
        return found;
    }
    /// Upper limit of a body's points.
    const POINTS: usize = 1 << 32;
    let own = found.iter().map(|c| (c.body as usize * POINTS + c.point as usize, c.to_array()));
    let of = |(number, values): (usize, _)| Contact::of([number / POINTS, number % POINTS], values);
    halo::in_order(halo, own).into_iter().map(of).collect()
}

/// What the contact search reads.
struct View<'a, R> {
    model: &'a Model,
    soil: &'a Soil<R>,
    node_mass: &'a [R],
    /// Body volume fraction of each cell.
    body_fraction: &'a [R],
    /// Material of each cell; empty where there is only one.
    material: &'a [u8],
    /// How far the grid has moved [m].
    grid_position: DVec3,
    /// The contacts of the last search.
    known: &'a [Contact],
    law: &'a dyn ContactLaw,
}

impl<R: Scalar> View<'_, R> {
    /// The points of a range that are contacts of a body.
    fn search(
        &self,
        n: usize,
        pose: &Pose,
        neighbours: &Neighbours,
        surface: &Surface,
        points: Range<usize>,
    ) -> Vec<Contact> {
        let number = |c: &Contact| (c.body as usize, c.point as usize);
        let first = self.known.partition_point(|c| number(c) < (n, points.start));
        let mut known = self.known[first..].iter().peekable();
        let body = &self.model.bodies[n];
        let mut found = Vec::new();
        for p in points {
            let point = surface.point(p);
            let known = known.next_if(|c| number(c) == (n, p));
            let in_space = [point.position, point.normal].map(|v| body.rotated(pose, v));
            if neighbours.cover(pose.position + in_space[0], in_space[1]) {
                continue;
            }
            if let Some(mut contact) = self.find_contact(known, in_space, body, pose.position) {
                (contact.body, contact.point) = (n as u32, p as u32);
                (contact.side, contact.is_paired) = (point.side, point.is_paired);
                contact.area *= point.area;
                contact.shear_limit *= point.represents / point.area;
                found.push(contact);
            }
        }
        found
    }

    /// A contact point of a body, if it lies in the block with soil to act on; `known` is the same point at
    /// the last search, if it was in contact with soil then.
    fn find_contact(
        &self,
        known: Option<&Contact>,
        [arm, normal]: [DVec3; 2],
        body: &BodyModel,
        reference: DVec3,
    ) -> Option<Contact> {
        let position = reference + arm;
        let in_grid = position - self.grid_position;
        let found = place(&self.model.grid, in_grid, (arm, normal))?;
        let Place { cell, whole, probe, .. } = found;
        let base = self.model.grid.index(cell[0], cell[1], cell[2]);
        let (weight, coverage) = self.weights(cell, found.shape_functions())?;
        let mut contact = Contact {
            cell: whole.map(|layer| layer as u32),
            octant: self.octant(cell, probe),
            material: self.material_of(base) as u32,
            shear_limit: self.shear_limit(body, cell, normal),
            weight,
            area: coverage,
            width: self.width_along(cell, normal),
            arm,
            normal,
            anchor: position,
            ..known.copied().unwrap_or_default()
        };
        let travel = known.map(|c| (position - c.anchor).length());
        self.law.update(&mut contact, self.gap(cell, normal), travel);
        Some(contact)
    }

    /// Weights of the cell's nodes from their shape functions, reduced at nodes with little mass, and the
    /// fraction of its area that a point represents among such nodes: a few grains must not carry the whole
    /// contact pressure.
    fn weights(&self, cell: [usize; 3], shape: [f64; 8]) -> Option<([f64; 8], f64)> {
        const MASS_RATIO: f64 = 2.5;
        let grid = &self.model.grid;
        let base = grid.index(cell[0], cell[1], cell[2]);
        let density = self.model.materials[self.material_of(base)].density;
        let mut weight = [0.0; 8];
        for (n, offset) in corners(grid.stride).iter().enumerate() {
            let full = density * grid.volume_round(std::array::from_fn(|axis| cell[axis] + (n >> axis & 1)));
            let mass = self.node_mass[base + offset].to_f64();
            let is_carried = || {
                let is_filled = |c: usize| self.body_fraction[c].to_f64() >= FILLED;
                mass < REMNANT * full && is_among_filled(grid, self.soil, base + offset, is_filled)
            };
            let moves = mass > self.model.mass_moved() && !is_carried();
            weight[n] = if moves { shape[n].min(MASS_RATIO * mass / full) } else { 0.0 };
        }
        let sum = over_corners(weight);
        (sum > 1e-3).then(|| (weight.map(|w| w / sum), (2.0 * sum).min(1.0)))
    }

    /// The octant of a cell in which a point lies.
    fn octant(&self, cell: [usize; 3], at: DVec3) -> u8 {
        let middle = |axis: usize| {
            let faces = &self.model.grid.faces[axis];
            0.5 * (faces[cell[axis]] + faces[cell[axis] + 1])
        };
        (0..3).map(|axis| u8::from(at[axis] >= middle(axis)) << axis).sum()
    }

    /// Width of a cell along a normal [m].
    fn width_along(&self, cell: [usize; 3], normal: DVec3) -> f64 {
        let grid = &self.model.grid;
        let widths = DVec3::from_array(std::array::from_fn(|axis| grid.width(axis, cell[axis])));
        grid.smallest_width(widths) * grid.length_along(normal)
    }

    /// Largest frictional traction of a body at a point in a cell [Pa]: a portion of the strength that the
    /// soil there has, however slowly it is sheared, and at most all of it; infinite where that has no
    /// undrained strength. A cell without soil stands for the next one along the normal; clay that is not
    /// there either has no strength.
    fn shear_limit(&self, body: &BodyModel, cell: [usize; 3], normal: DVec3) -> f64 {
        let grid = &self.model.grid;
        let index = |[i, j, k]: [usize; 3]| grid.index(i, j, k);
        let beyond = self.next(cell, grid.main_axis(normal), normal).map_or(index(cell), index);
        let at = if self.soil.fraction[index(cell)] > R::default() { index(cell) } else { beyond };
        let [intact, plastic_strain] = [INTACT_STRENGTH, PLASTIC_STRAIN]
            .map(|h| self.soil.history[h].get(at).map_or(0.0, |value| value.to_f64()));
        let strength = self.model.materials[self.material_of(at)].shear_strength(intact, plastic_strain);
        strength.map_or(f64::INFINITY, |strength| body.adhesion_factor.min(1.0) * strength)
    }

    /// The next cell along an axis, in the direction of a vector, if the grid has one there.
    fn next(&self, cell: [usize; 3], axis: usize, direction: DVec3) -> Option<[usize; 3]> {
        let mut next = cell;
        next[axis] = if direction[axis] > 0.0 { cell[axis] + 1 } else { cell[axis].checked_sub(1)? };
        (next[axis] < self.model.grid.cells()[axis]).then_some(next)
    }

    fn material_of(&self, cell: usize) -> usize {
        self.material.get(cell).map_or(0, |m| usize::from(*m))
    }

    /// Gap between body and soil along the normal [m], negative where they overlap. Only void between the two
    /// counts, not void beyond the soil.
    fn gap(&self, cell: [usize; 3], normal: DVec3) -> f64 {
        let grid = &self.model.grid;
        let axis = grid.main_axis(normal);
        let neighbour = |out: bool| self.next(cell, axis, if out { normal } else { -normal });
        let sample = |at: Option<[usize; 3]>| match at {
            // Outside the grid is a wall: no void.
            None => (0.0, 1.0, 1.0, 0.0),
            Some(at) => {
                let c = grid.index(at[0], at[1], at[2]);
                let width = grid.width(axis, at[axis]);
                let fraction = self.soil.fraction[c].to_f64();
                let void = (1.0 - self.body_fraction[c].to_f64() - fraction) * width;
                (void, fraction, normal.dot(self.void_direction(at)), width)
            }
        };
        let (void_in, ..) = sample(neighbour(false));
        let (void_own, soil_own, side_own, _) = sample(Some(cell));
        let (void_out, soil_out, side_out, width_out) = sample(neighbour(true));
        /// Cosine above which void lies beyond the soil, away from the body.
        const OUTWARD: f64 = 0.3;
        /// Volume fraction above which a cell counts as holding soil.
        const SOME_SOIL: f64 = 0.02;
        let mut gap = void_in.min(0.0);
        if soil_own > SOME_SOIL {
            gap += if side_own < OUTWARD { void_own + void_in.max(0.0) } else { void_own.min(0.0) };
        } else {
            let beyond = if side_out < OUTWARD { void_out } else { void_out.min(0.0) };
            gap += void_own + void_in.max(0.0) + if soil_out > SOME_SOIL { beyond } else { width_out };
        }
        gap * normal[axis].abs()
    }

    /// Unit vector from soil to void around a cell; zero where there is no void.
    fn void_direction(&self, cell: [usize; 3]) -> DVec3 {
        let grid = &self.model.grid;
        let c = grid.index(cell[0], cell[1], cell[2]);
        const WEIGHT: [f64; 3] = [1.0, 2.0, 1.0];
        let offset: [[isize; 3]; 3] = std::array::from_fn(|axis| {
            let s = grid.stride[axis].cast_signed();
            [if cell[axis] > 0 { -s } else { 0 }, 0, if cell[axis] + 1 < grid.cells()[axis] { s } else { 0 }]
        });
        let mut gradient = DVec3::ZERO;
        for (z, dz) in offset[2].iter().enumerate() {
            for (x, dx) in offset[0].iter().enumerate() {
                // The two sides in y are summed first, so that mirroring in y changes no bit.
                let [low, middle, high] =
                    offset[1].map(|dy| self.soil.fraction[c.wrapping_add_signed(dx + dy + dz)].to_f64());
                let sum = (low + high) + 2.0 * middle;
                gradient.x += sum * WEIGHT[z] * (x as f64 - 1.0);
                gradient.y += (high - low) * WEIGHT[x] * WEIGHT[z];
                gradient.z += sum * WEIGHT[x] * (z as f64 - 1.0);
            }
        }
        (-gradient / grid.aspect()).normalize_or_zero()
    }
}
