//! Contact by velocity impulses: at every point the soil must not move into the body, and slides only when the Coulomb
//! cone is full. Solved by symmetric Gauss–Seidel sweeps from the last step's impulses, the body inside the iteration;
//! no stiffness, no limit on the time step, stable for bodies much lighter than the soil they displace.

use super::{ContactLaw, Scene, corners};
use crate::state::Contact;
use glam::DVec3;

/// Impulse contact.
#[derive(Debug)]
pub(super) struct Impulses;

/// Symmetric sweeps per step; fewer than two give wrong forces.
const SWEEPS: usize = 4;

impl ContactLaw for Impulses {
    fn relocate(&self, c: &mut Contact, gap: f64, _travel: f64, was_in_soil: bool) {
        // Touching: no void of half a cell between body and soil. `penetration` keeps the verdict.
        c.penetration = if gap < 0.5 * c.width { 1.0 } else { 0.0 };
        if !was_in_soil || c.penetration == 0.0 {
            c.impulse = DVec3::ZERO;
        }
    }

    fn act(&self, scene: &mut Scene) {
        let touching: Vec<(usize, DVec3)> = (0..scene.contacts.len())
            .filter(|n| scene.contacts[*n].in_soil && scene.contacts[*n].penetration > 0.0)
            .map(|n| (n, mobility(scene, &scene.contacts[n])))
            .collect();
        for (n, _) in &touching {
            let contact = scene.contacts[*n];
            let normal = contact.impulse.dot(contact.normal) * contact.normal;
            scene.exchange(&contact, normal, contact.impulse - normal);
        }
        for _ in 0..SWEEPS {
            for (n, mobility) in touching.iter().chain(touching.iter().rev()) {
                relax(scene, *n, *mobility);
            }
        }
    }
}

/// Velocity per impulse along x, y, z, of soil and body together [1/kg] (diagonal of the point's mobility).
fn mobility(scene: &Scene, c: &Contact) -> DVec3 {
    let offsets = corners(scene.model.grid.stride);
    let soil: f64 = offsets
        .iter()
        .zip(c.weight)
        .filter(|(_, w)| *w > 0.0)
        .map(|(offset, w)| w * w / scene.mass[c.base + offset])
        .sum();
    let fixed = &scene.model.bodies[c.body];
    let share = scene.model.share;
    DVec3::from_array(std::array::from_fn(|axis| {
        let push = if fixed.translation[axis].is_free() { 1.0 / (fixed.mass * share) } else { 0.0 };
        let mut unit = DVec3::ZERO;
        unit[axis] = 1.0;
        let lever = c.arm.cross(unit).y;
        let turn = if fixed.spin.is_free() { lever * lever / (fixed.axle_inertia * share) } else { 0.0 };
        soil + push + turn
    }))
}

/// Corrects the impulse of one point by its present relative velocity.
fn relax(scene: &mut Scene, n: usize, mobility: DVec3) {
    let c = scene.contacts[n];
    let relative = scene.slip_velocity(&c);
    let old_normal = c.impulse.dot(c.normal);
    let along = mobility.dot(c.normal * c.normal);
    let new_normal = (old_normal + relative.dot(c.normal) / along).max(0.0);
    let across = mobility.max_element();
    let old_friction = c.impulse - old_normal * c.normal;
    let sliding = relative - relative.dot(c.normal) * c.normal;
    let limit = scene.model.bodies[c.body].friction.min(1e6) * new_normal;
    let friction = (old_friction + sliding / across).clamp_length_max(limit);
    scene.contacts[n].impulse = new_normal * c.normal + friction;
    scene.exchange(&c, (new_normal - old_normal) * c.normal, friction - old_friction);
}
