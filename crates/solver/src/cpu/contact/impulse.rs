//! Contact by velocity impulses: at every touching point the soil must not move into the body, and slides only when the
//! Coulomb cone is full. Solved by symmetric Gauss–Seidel sweeps that start from the last step's impulses, the body
//! inside the iteration: no stiffness, no limit on the time step, stable for bodies much lighter than the soil that they
//! displace.
//!
//! A point that does not touch keeps its distance to the soil, and may close it within a step but no further. Where the
//! volume fractions show that soil has got into the body, it is pushed out as the body moves on; a body at rest pushes
//! nothing, so that its load does not drift.

use super::{ContactLaw, Scene};
use crate::state::Contact;
use glam::DVec3;

/// Impulse contact.
#[derive(Debug)]
pub(super) struct Impulses;

/// Symmetric sweeps per step; fewer than two give wrong forces.
const SWEEPS: usize = 4;
/// A touching point is let go when the volume fractions show a void of this many cells before it.
const LET_GO: f64 = 0.5;
/// Share of the difference to the geometric gap that a point at a distance takes over per tenth of a cell of travel.
const PULL: f64 = 0.3;
/// Share of an overlap that is pushed out while the body moves on by one cell.
const PUSH: f64 = 1.0;
/// Points farther from the soil than this many cells cannot touch within a step.
const REACH: f64 = 0.05;

impl ContactLaw for Impulses {
    fn relocate(&self, c: &mut Contact, gap: f64, travel: f64, was_in_soil: bool) {
        let touches = was_in_soil && c.penetration >= 0.0;
        if touches && gap < LET_GO * c.width {
            c.penetration = (-gap).max(0.0);
            return;
        }
        let known = was_in_soil && !touches;
        let pull = if known { (PULL * travel / (0.1 * c.width)).min(1.0) } else { 1.0 };
        c.penetration = (c.penetration + pull * (-gap - c.penetration)).min(0.0);
        c.impulse = DVec3::ZERO;
    }

    fn act(&self, scene: &mut Scene) {
        let near: Vec<Near> = (0..scene.contacts.len())
            .filter(|n| {
                scene.contacts[*n].in_soil
                    && scene.contacts[*n].penetration > -REACH * scene.contacts[*n].width
            })
            .filter_map(|n| Near::new(scene, n))
            .collect();
        for near in &near {
            let contact = scene.contacts[near.contact];
            scene.exchange(near.contact, contact.impulse);
        }
        let groups = mirrored_groups(scene, &near);
        for _ in 0..SWEEPS {
            for group in groups.iter().chain(groups.iter().rev()) {
                group.relax(scene, &near);
            }
        }
        for near in &near {
            let c = scene.contacts[near.contact];
            let normal = c.impulse.dot(c.normal) * c.normal;
            scene.note(near.contact, normal, c.impulse - normal);
        }
        for n in 0..scene.contacts.len() {
            let c = scene.contacts[n];
            if c.in_soil {
                let closing = scene.slip_velocity(n).dot(c.normal);
                let penetration = (c.penetration + closing * scene.dt).min(c.penetration.max(0.0));
                // Rounding must not let go of a point that is held.
                let held = c.impulse.dot(c.normal) > 0.0;
                scene.contacts[n].penetration = if held { penetration.max(0.0) } else { penetration };
            }
        }
    }
}

/// What does not change about a point that may touch, during the sweeps of a step.
struct Near {
    contact: usize,
    /// Inverse of the velocity that an impulse along the normal makes [kg].
    along: f64,
    /// The same across the normal, where it makes the most [kg].
    across: f64,
    /// Closing velocity that is allowed [m/s].
    allowed: f64,
    friction: f64,
    /// Largest frictional impulse in a step [N s].
    shear_limit: f64,
}

impl Near {
    /// `None` where neither soil nor body can give way along the normal: there is nothing to solve for.
    fn new(scene: &Scene, contact: usize) -> Option<Self> {
        let c = &scene.contacts[contact];
        let mobility = mobility(scene, contact);
        let along = mobility.dot(c.normal * c.normal);
        if along <= 0.0 {
            return None;
        }
        let body = &scene.bodies[c.body];
        // Overlap is pushed out, a gap may be closed.
        let allowed = if c.penetration > 0.0 {
            -PUSH * c.penetration / c.width * body.velocity.length()
        } else {
            -c.penetration / scene.dt
        };
        Some(Self {
            contact,
            along: 1.0 / along,
            across: 1.0 / mobility.max_element(),
            allowed,
            friction: scene.model.bodies[c.body].friction.min(1e6),
            shear_limit: scene.model.bodies[c.body].shear_limit * c.area * scene.dt,
        })
    }

    /// Impulse that the present relative velocity asks for, `share` of the whole correction.
    fn wanted(&self, scene: &Scene, share: f64) -> DVec3 {
        let c = &scene.contacts[self.contact];
        let relative = scene.slip_velocity(self.contact);
        let closing = relative.dot(c.normal);
        let old_normal = c.impulse.dot(c.normal);
        let new_normal = (old_normal + share * (closing - self.allowed) * self.along).max(0.0);
        if new_normal == 0.0 && old_normal == 0.0 {
            return DVec3::ZERO;
        }
        let old_friction = c.impulse - old_normal * c.normal;
        let sliding = relative - closing * c.normal;
        let limit = (self.friction * new_normal).min(self.shear_limit);
        let friction = (old_friction + share * sliding * self.across).clamp_length_max(limit);
        new_normal * c.normal + friction
    }

    /// Sets the impulse of the point.
    fn set(&self, scene: &mut Scene, impulse: DVec3) {
        let change = impulse - scene.contacts[self.contact].impulse;
        if change != DVec3::ZERO {
            scene.contacts[self.contact].impulse = impulse;
            scene.exchange(self.contact, change);
        }
    }
}

/// One point, or two that are each other's mirror image in y. Two are relaxed together, each from what was before the
/// other: a case and its mirror image then take the same course, which the order of the points would otherwise spoil.
struct Group {
    /// Places among the near points.
    first: usize,
    second: Option<usize>,
    /// Share of the correction that each takes, so that two that push the same soil or body do not overshoot.
    share: f64,
}

impl Group {
    fn relax(&self, scene: &mut Scene, near: &[Near]) {
        let first = near[self.first].wanted(scene, self.share);
        let second = self.second.map(|n| (n, near[n].wanted(scene, self.share)));
        near[self.first].set(scene, first);
        if let Some((n, impulse)) = second {
            near[n].set(scene, impulse);
        }
    }
}

/// The near points in groups. Mirror images stand side by side in the list of surface points.
fn mirrored_groups(scene: &Scene, near: &[Near]) -> Vec<Group> {
    let mut groups = Vec::with_capacity(near.len());
    let mut n = 0;
    while n < near.len() {
        let partner = (n + 1 < near.len() && are_mirrored(scene, near[n].contact, near[n + 1].contact))
            .then_some(n + 1);
        let share = partner.map_or(1.0, |p| 1.0 / (1.0 + coupling(scene, &near[n], &near[p])));
        groups.push(Group { first: n, second: partner, share });
        n += if partner.is_some() { 2 } else { 1 };
    }
    groups
}

fn are_mirrored(scene: &Scene, first: usize, second: usize) -> bool {
    let (a, b) = (&scene.contacts[first], &scene.contacts[second]);
    let flip = |v: DVec3| DVec3::new(v.x, -v.y, v.z);
    a.body == b.body && flip(a.arm) == b.arm && flip(a.normal) == b.normal
}

/// How far an impulse at one point moves the other, over how far it moves itself; 0 to 1.
fn coupling(scene: &Scene, first: &Near, second: &Near) -> f64 {
    let (a, b) = (&scene.contacts[first.contact], &scene.contacts[second.contact]);
    let (nodes_a, nodes_b) = (&scene.corner_nodes[first.contact], &scene.corner_nodes[second.contact]);
    let mut shared = DVec3::ZERO;
    for (n, w) in nodes_a.iter().zip(a.weight) {
        for (_, other) in nodes_b.iter().zip(b.weight).filter(|(m, _)| *m == n) {
            shared += w * other * scene.nodes[*n as usize].inverse_mass;
        }
    }
    let through_body = mobility_of_body(scene, a.body, a.arm);
    let size = (shared + through_body).dot((a.normal * b.normal).abs());
    (size * first.along.max(second.along)).clamp(0.0, 1.0)
}

/// Velocity per impulse along x, y, z, of soil and body together [1/kg] (diagonal of the point's mobility).
fn mobility(scene: &Scene, contact: usize) -> DVec3 {
    let c = &scene.contacts[contact];
    let nodes = scene.corner_nodes[contact];
    let each = nodes.iter().zip(c.weight);
    let soil = each.fold(DVec3::ZERO, |sum, (n, w)| sum + w * w * scene.nodes[*n as usize].inverse_mass);
    soil + mobility_of_body(scene, c.body, c.arm)
}

/// The body's part of it.
fn mobility_of_body(scene: &Scene, body: usize, arm: DVec3) -> DVec3 {
    let fixed = &scene.model.bodies[body];
    let share = scene.model.share;
    DVec3::from_array(std::array::from_fn(|axis| {
        let push = if fixed.translation[axis].is_free() { 1.0 / (fixed.mass * share) } else { 0.0 };
        let mut unit = DVec3::ZERO;
        unit[axis] = 1.0;
        let lever = arm.cross(unit).y;
        let turn = if fixed.spin.is_free() { lever * lever / (fixed.axle_inertia * share) } else { 0.0 };
        push + turn
    }))
}
