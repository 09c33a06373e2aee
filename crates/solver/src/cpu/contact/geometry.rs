//! Where the contact points lie in the grid, how far the soil is from them, and how much soil is inside a body.

use super::super::workspace::Workspace;
use super::super::{Real, Soil, State};
use super::{ContactLaw, TouchedNode, corners, over_corners};
use crate::grid::Grid;
use crate::model::{BodyModel, Model, Wall};
use crate::state::{Body, Contact};
use glam::DVec3;

/// Finds anew which contact points have soil to act on, with their cells, weights and gaps; measures leaked and embedded
/// volumes. Done at every remap.
pub(crate) fn locate(model: &Model, state: &mut State, workspace: &mut Workspace) {
    let Workspace {
        velocity_before: [occupied, ..],
        body_cells,
        surfaces,
        contact_law,
        touched,
        corner_nodes,
        patch,
        ..
    } = workspace;
    measure_leak(&model.grid, &state.soil, body_cells, &mut state.bodies);
    let view = View { model, soil: &state.soil, node_mass: &state.nodes.mass, occupied };
    let mut located = Vec::with_capacity(state.contacts.len());
    let mut known = state.contacts.iter().peekable();
    for (n, surface) in surfaces.iter().enumerate() {
        let (fixed, body) = (&model.bodies[n], &state.bodies[n]);
        for (p, point) in surface.points().enumerate() {
            let known = known.next_if(|c| (c.body, c.point) == (n, p));
            let place = [point.position, point.normal].map(|v| turned(fixed, body, v));
            if let Some(mut contact) = view.locate_one(known, place, body, contact_law.as_ref()) {
                (contact.body, contact.point) = (n, p);
                contact.area *= point.area;
                located.push(contact);
            }
        }
    }
    state.contacts = located;
    for c in body_cells {
        occupied[c.cell] = 0.0;
    }
    (*touched, *corner_nodes) = touched_nodes(model, &state.contacts);
    *patch = super::number_patches(model, &state.soil, &state.bodies, &state.contacts);
}

/// Finds anew which share of each cell the bodies take up. It is noted in memory that is free only till [`locate`].
pub(crate) fn occupy_all(model: &Model, state: &mut State, workspace: &mut Workspace) {
    let Workspace { velocity_before: [occupied, ..], body_cells, .. } = workspace;
    body_cells.clear();
    for (n, (fixed, body)) in model.bodies.iter().zip(&mut state.bodies).enumerate() {
        occupy(model, fixed, body, |cell, share| {
            occupied[cell] = (occupied[cell] + share as Real).min(1.0);
            body_cells.push(BodyCell { body: n, cell, share });
        });
        body.located = (body.position, body.angle);
    }
}

/// A cell of which a body takes up a share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BodyCell {
    /// Which body.
    pub(crate) body: usize,
    /// Place in memory.
    pub(crate) cell: usize,
    /// Share of the cell.
    pub(crate) share: f64,
}

/// Measures the soil inside the bodies: what is more than fits beside them in their cells.
fn measure_leak(grid: &Grid, soil: &Soil, body_cells: &[BodyCell], bodies: &mut [Body]) {
    for body in bodies.iter_mut() {
        body.leaked_volume = 0.0;
    }
    for c in body_cells {
        bodies[c.body].leaked_volume +=
            (f64::from(soil.fraction[c.cell]) + c.share - 1.0).max(0.0) * grid.volume_of(c.cell);
    }
}

/// The nodes that contact acts on, in memory order, and for each contact the places of its cell's nodes among them.
pub(crate) fn touched_nodes(model: &Model, contacts: &[Contact]) -> (Vec<TouchedNode>, Vec<[u32; 8]>) {
    let grid = &model.grid;
    let of = |c: &Contact| corners(grid.stride).map(|offset| c.base + offset);
    let mut nodes: Vec<usize> = contacts.iter().flat_map(of).collect();
    nodes.sort_unstable();
    nodes.dedup();
    let place = |node: usize| nodes.partition_point(|n| *n < node) as u32;
    let corner_nodes = contacts.iter().map(|c| of(c).map(place)).collect();
    let touched =
        |node| TouchedNode { node, free_of_walls: free_of_walls(model, node), ..TouchedNode::default() };
    (nodes.into_iter().map(touched).collect(), corner_nodes)
}

/// 1 along the axes in which no wall stops a node, 0 along the others.
fn free_of_walls(model: &Model, node: usize) -> DVec3 {
    let place = model.grid.place(node);
    let cells = model.grid.cells();
    let mut free = DVec3::ONE;
    for axis in 0..3 {
        for (wall, at) in model.walls[axis].iter().zip([0, cells[axis]]) {
            match wall {
                Wall::Smooth if place[axis] == at => free[axis] = 0.0,
                Wall::Fixed if place[axis] == at => free = DVec3::ZERO,
                _ => {}
            }
        }
    }
    free
}

/// A direction of the body frame in space. The points of a body of revolution stay where they are when it turns: in
/// steady rolling they then see a steady contact.
fn turned(fixed: &BodyModel, body: &Body, v: DVec3) -> DVec3 {
    if fixed.shape.is_revolved() { v } else { glam::DQuat::from_rotation_y(body.angle) * v }
}

/// Layer of the cell that holds a coordinate, if it is inside the grid.
fn layer(faces: &[f64], x: f64) -> Option<usize> {
    let n = faces.partition_point(|face| *face <= x);
    (n >= 1 && n < faces.len()).then(|| n - 1)
}

/// Axis of the largest component.
pub(super) fn largest_axis(v: DVec3) -> usize {
    let size = v.abs();
    if size.x >= size.y && size.x >= size.z {
        0
    } else if size.y >= size.z {
        1
    } else {
        2
    }
}

struct View<'a> {
    model: &'a Model,
    soil: &'a Soil,
    node_mass: &'a [Real],
    /// Share of each cell that bodies take up.
    occupied: &'a [Real],
}

impl View<'_> {
    /// A contact point on a body, if it is in the grid with soil to act on; `known` is what it was the last time, if it was
    /// so then.
    fn locate_one(
        &self,
        known: Option<&Contact>,
        [arm, normal]: [DVec3; 2],
        body: &Body,
        law: &dyn ContactLaw,
    ) -> Option<Contact> {
        let place = body.position + arm;
        // A point on a face between two cells acts in the outer one; one on an edge between cells of a row in that
        // nearer to the body's middle, so that mirror images act in mirror images of cells.
        let finest = self.model.grid.finest();
        let probe = place + 1e-9 * finest * (normal - 0.5 * arm.signum() * (DVec3::ONE - normal.abs()));
        let faces = &self.model.grid.faces;
        let cell = [layer(&faces[0], probe.x)?, layer(&faces[1], probe.y)?, layer(&faces[2], probe.z)?];
        let (weight, coverage) = self.weights(cell, place)?;
        let mut contact = Contact {
            base: self.model.grid.index(cell[0], cell[1], cell[2]),
            weight,
            area: coverage,
            width: (0..3).map(|axis| self.model.grid.width(axis, cell[axis])).fold(f64::INFINITY, f64::min),
            arm,
            normal,
            anchor: place,
            ..known.copied().unwrap_or_default()
        };
        let travel = known.map(|c| (place - c.anchor).length());
        law.relocate(&mut contact, self.gap(cell, normal), travel);
        Some(contact)
    }

    /// Trilinear weights of the cell's nodes, cut down at nodes that have hardly any mass to push against, and the share
    /// of its area that a point among such nodes acts with: without that, a few grains would have to bear it all.
    fn weights(&self, cell: [usize; 3], place: DVec3) -> Option<([f64; 8], f64)> {
        const MASS_RATIO: f64 = 2.5;
        let grid = &self.model.grid;
        let base = grid.index(cell[0], cell[1], cell[2]);
        // The parts of the low and the high node, each from the other's face: a mirror in y only exchanges them.
        let parts: [[f64; 2]; 3] = std::array::from_fn(|axis| {
            let (faces, n) = (&grid.faces[axis], cell[axis]);
            let part = |distance: f64| (distance / grid.width(axis, n)).clamp(0.0, 1.0);
            [part(faces[n + 1] - place[axis]), part(place[axis] - faces[n])]
        });
        let mut weight = [0.0; 8];
        for (n, offset) in corners(grid.stride).iter().enumerate() {
            let part = |axis: usize| parts[axis][n >> axis & 1];
            let full = self.model.density * self.node_volume(cell, n);
            let mass = f64::from(self.node_mass[base + offset]);
            let bears = mass > self.model.mass_moved();
            weight[n] = if bears { (part(0) * part(1) * part(2)).min(MASS_RATIO * mass / full) } else { 0.0 };
        }
        let sum = over_corners(weight);
        (sum > 1e-3).then(|| (weight.map(|w| w / sum), (2.0 * sum).min(1.0)))
    }

    /// Volume of the eight half cells round corner `n` of a cell [m³].
    fn node_volume(&self, cell: [usize; 3], n: usize) -> f64 {
        let grid = &self.model.grid;
        (0..3)
            .map(|axis| {
                let node = cell[axis] + (n >> axis & 1);
                let low = if node > 0 { grid.width(axis, node - 1) } else { 0.0 };
                let high = if node < grid.cells()[axis] { grid.width(axis, node) } else { 0.0 };
                0.5 * (low + high)
            })
            .product()
    }

    /// Void between body and soil along the normal [m], negative where they overlap. A void counts only when it lies
    /// between the two: behind the soil it is none of the contact's business.
    fn gap(&self, cell: [usize; 3], normal: DVec3) -> f64 {
        let axis = largest_axis(normal);
        let grid = &self.model.grid;
        let outward = normal[axis] > 0.0;
        let neighbour = |out: bool| -> Option<[usize; 3]> {
            let mut next = cell;
            next[axis] = if out == outward { cell[axis] + 1 } else { cell[axis].checked_sub(1)? };
            (next[axis] < grid.cells()[axis]).then_some(next)
        };
        let look = |at: Option<[usize; 3]>| match at {
            // Outside the grid is a wall: nothing is void there.
            None => (0.0, 1.0, 1.0, 0.0),
            Some(at) => {
                let c = grid.index(at[0], at[1], at[2]);
                let width = grid.width(axis, at[axis]);
                let fraction = f64::from(self.soil.fraction[c]);
                let void = (1.0 - f64::from(self.occupied[c]) - fraction) * width;
                (void, fraction, normal.dot(self.void_direction(at)), width)
            }
        };
        let (void_in, ..) = look(neighbour(false));
        let (void_own, soil_own, side_own, _) = look(Some(cell));
        let (void_out, soil_out, side_out, width_out) = look(neighbour(true));
        const ALONG: f64 = 0.3;
        const SOME_SOIL: f64 = 0.02;
        let mut gap = void_in.min(0.0);
        if soil_own > SOME_SOIL {
            gap += if side_own < ALONG { void_own + void_in.max(0.0) } else { void_own.min(0.0) };
        } else {
            let beyond = if side_out < ALONG { void_out } else { void_out.min(0.0) };
            gap += void_own + void_in.max(0.0) + if soil_out > SOME_SOIL { beyond } else { width_out };
        }
        gap * normal[axis].abs()
    }

    /// Unit direction from soil to void round a cell; zero where there is none.
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
                // The two sides of y are added first: a mirror in y then changes no bit.
                let [low, middle, high] =
                    offset[1].map(|dy| f64::from(self.soil.fraction[c.wrapping_add_signed(dx + dy + dz)]));
                let sum = (low + high) + 2.0 * middle;
                gradient.x += sum * WEIGHT[z] * (x as f64 - 1.0);
                gradient.y += (high - low) * WEIGHT[x] * WEIGHT[z];
                gradient.z += sum * WEIGHT[x] * (z as f64 - 1.0);
            }
        }
        (-gradient).normalize_or_zero()
    }
}

/// Calls `each(cell, share)` for the cells that a body takes up a share of; measures the body's volume below the undisturbed
/// surface.
fn occupy(model: &Model, fixed: &BodyModel, body: &mut Body, mut each: impl FnMut(usize, f64)) {
    let grid = &model.grid;
    let (low, high) = fixed.shape.bounds();
    let reach = if fixed.shape.is_revolved() { high } else { DVec3::splat(low.length().max(high.length())) };
    let ranges: [std::ops::Range<usize>; 3] = std::array::from_fn(|axis| {
        let faces = &grid.faces[axis];
        let first = faces.partition_point(|f| *f <= body.position[axis] - reach[axis]).saturating_sub(1);
        let last = faces.partition_point(|f| *f < body.position[axis] + reach[axis]);
        first..last.min(grid.cells()[axis])
    });
    let turn = glam::DQuat::from_rotation_y(if fixed.shape.is_revolved() { 0.0 } else { -body.angle });
    body.embedded_volume = 0.0;
    for k in ranges[2].clone() {
        let below = ((model.surface - grid.faces[2][k]) / grid.width(2, k)).clamp(0.0, 1.0);
        for j in ranges[1].clone() {
            for i in ranges[0].clone() {
                let share =
                    covered(grid, [i, j, k], |x| fixed.shape.signed_distance(turn * (x - body.position)));
                if share > 0.0 {
                    let (c, volume) = (grid.index(i, j, k), grid.volume(i, j, k));
                    each(c, share);
                    body.embedded_volume += share * below * volume;
                }
            }
        }
    }
}

/// Share of a cell with a negative distance, by 4³ samples; each counts in part when the surface is near it.
fn covered(grid: &Grid, cell: [usize; 3], distance: impl Fn(DVec3) -> f64) -> f64 {
    const SAMPLES: usize = 4;
    // Every place is found from both faces, and layers in y are added up in pairs: a mirror in y changes no bit.
    let at = |axis: usize, n: f64| {
        let (part, faces) = (n / SAMPLES as f64, &grid.faces[axis]);
        faces[cell[axis]] * (1.0 - part) + faces[cell[axis] + 1] * part
    };
    let width = DVec3::from_array(std::array::from_fn(|axis| grid.width(axis, cell[axis])));
    let middle = distance(DVec3::new(at(0, 2.0), at(1, 2.0), at(2, 2.0)));
    if middle.abs() > 0.5 * width.length() {
        return if middle < 0.0 { 1.0 } else { 0.0 };
    }
    let sample = width.min_element() / SAMPLES as f64;
    let mut layers = [0.0; SAMPLES];
    for n in 0..SAMPLES.pow(3) {
        let [x, y, z] = [n % SAMPLES, n / SAMPLES % SAMPLES, n / SAMPLES / SAMPLES];
        let place = |axis: usize, n: usize| at(axis, n as f64 + 0.5);
        let d = distance(DVec3::new(place(0, x), place(1, y), place(2, z)));
        layers[y] += (0.5 - d / sample).clamp(0.0, 1.0);
    }
    ((layers[0] + layers[3]) + (layers[1] + layers[2])) / SAMPLES.pow(3) as f64
}

/// Takes the soil out of the space that the bodies take up, before the run begins.
pub(crate) fn carve(model: &Model, soil: &mut Soil, bodies: &mut [Body]) {
    let mut occupied = vec![0.0; model.grid.entries];
    for (fixed, body) in model.bodies.iter().zip(bodies) {
        occupy(model, fixed, body, |c, share| occupied[c] = (occupied[c] + share).min(1.0));
    }
    for (f, share) in soil.fraction.iter_mut().zip(&occupied) {
        *f = f.min((1.0 - share) as Real);
    }
}
