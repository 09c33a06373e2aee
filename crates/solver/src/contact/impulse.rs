//! Contact by velocity impulses: at every touching point the soil must not move into the body, and slides only when the
//! Coulomb cone is full. Solved by symmetric Gauss–Seidel sweeps that start from the last step's impulses, the body
//! inside the iteration: no stiffness, no limit on the time step, stable for bodies much lighter than the soil that they
//! displace.
//!
//! A point that does not touch keeps its distance to the soil, and may close it within a step but no further. Where the
//! volume fractions show that soil has got into the body, it is pushed out as the body moves on; a body at rest pushes
//! nothing, so that its load does not drift.

use super::constraint::{self, Patch, Patches};
use super::law::ContactLaw;
use super::scene::{Grip, Scene, over_corners};
use crate::state::Contact;
use glam::DVec3;

/// Impulse contact: room for the patches that touch in a step, and what is known of them.
#[derive(Debug, Default)]
pub(super) struct Impulses {
    patches: Patches,
    terms: Vec<Option<Terms>>,
    groups: Vec<Group>,
}

/// What is kept for each patch [bytes].
pub(super) const PER_PATCH: f64 =
    (constraint::PER_PATCH + size_of::<Option<Terms>>() + size_of::<Group>()) as f64;

/// Symmetric sweeps per step; fewer than two give wrong forces.
const SWEEPS: usize = 4;
/// A touching point of a curved or inclined face is let go when the volume fractions show a void of this many cells before it:
/// a wheel that rolls would else open a void under itself and climb on it.
const LET_GO: f64 = 0.05;
/// The same on a face that lies in the grid. As it slides its edges cut cells, where the fractions tell a void less surely:
/// the force on a footing that moves along would else be too low by 7 %.
const LET_GO_FLAT: f64 = 0.5;
/// Share of the difference to the geometric gap that a point at a distance takes over per tenth of a cell of travel.
const PULL: f64 = 0.3;
/// Share of an overlap that is pushed out while the body moves on by one cell.
const PUSH: f64 = 1.0;
/// Points farther from the soil than this many cells cannot touch within a step.
const REACH: f64 = 0.05;

impl ContactLaw for Impulses {
    fn relocate(&self, c: &mut Contact, gap: f64, travel: Option<f64>) {
        let touches = travel.is_some() && c.penetration >= 0.0;
        let is_flat = c.normal.abs().max_element() == 1.0;
        if touches && gap < if is_flat { LET_GO_FLAT } else { LET_GO } * c.width {
            c.penetration = (-gap).max(0.0);
            return;
        }
        let apart = travel.filter(|_| !touches);
        let pull = apart.map_or(1.0, |travel| (PULL * travel / (0.1 * c.width)).min(1.0));
        c.penetration = (c.penetration + pull * (-gap - c.penetration)).min(0.0);
        c.impulse = DVec3::ZERO;
    }

    fn act(&mut self, scene: &mut Scene) {
        let touches = |n: usize| {
            let c = &scene.contacts[n];
            let closing = || scene.slip_velocity_of(n).dot(c.normal);
            c.penetration >= 0.0
                || c.penetration > -REACH * c.width && c.penetration + closing() * scene.dt > 0.0
        };
        let Self { patches, terms, groups } = self;
        patches.find(scene, touches);
        let (patches, patch_of) = (&mut patches.each, &patches.of_contact);
        terms.clear();
        terms.extend(patches.iter().map(|p| Terms::new(scene, p)));
        mirrored_groups(scene, patches, terms, groups);
        for group in groups.iter() {
            group.give(scene, patches, [group.first, group.second].map(|n| patches[n].impulse));
        }
        for _ in 0..SWEEPS {
            for group in groups.iter().chain(groups.iter().rev()) {
                group.relax(scene, patches, terms);
            }
        }
        for (n, patch) in patch_of.iter().enumerate() {
            remember(scene, n, patch.map(|p| &patches[p]));
        }
    }
}

/// Gives a point its share of its patch's impulse, if it has one, and carries its distance on.
fn remember(scene: &mut Scene, n: usize, patch: Option<&Patch>) {
    let area = scene.contacts[n].area;
    let impulse = patch.map_or(DVec3::ZERO, |p| (area / p.area) * p.impulse);
    if let Some(patch) = patch {
        let normal = impulse.dot(patch.grip.normal) * patch.grip.normal;
        scene.note(n, normal, impulse - normal);
    }
    let slip = scene.slip_velocity_of(n);
    let c = &mut scene.contacts[n];
    let penetration = (c.penetration + slip.dot(c.normal) * scene.dt).min(c.penetration.max(0.0));
    // Rounding must not let go of a point that is held.
    let held = patch.is_some_and(|p| p.impulse.dot(p.grip.normal) > 0.0);
    c.penetration = if held { penetration.max(0.0) } else { penetration };
    c.impulse = impulse;
}

/// What does not change about a patch during the sweeps of a step.
#[derive(Debug)]
struct Terms {
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

impl Terms {
    /// `None` where neither soil nor body can give way along the normal: there is nothing to solve for.
    fn new(scene: &Scene, patch: &Patch) -> Option<Self> {
        let (grip, normal) = (&patch.grip, patch.grip.normal);
        let mobility = mobility(scene, grip);
        let soil = |n: usize| {
            let impulse = grip.on_node(n, normal);
            (impulse * impulse).dot(scene.nodes[grip.nodes[n] as usize].inverse_mass)
        };
        let along =
            over_corners(std::array::from_fn(soil)) + mobility_of_body(scene, grip).dot(normal * normal);
        (along > 0.0).then(|| Self {
            along: 1.0 / along,
            across: 1.0 / mobility.max_element(),
            allowed: -PUSH * patch.overlap * scene.bodies[patch.grip.body].velocity.length(),
            friction: scene.model.bodies[patch.grip.body].friction.min(1e6),
            shear_limit: scene.model.bodies[patch.grip.body].shear_limit * patch.area * scene.dt,
        })
    }

    /// Impulse that the present relative velocity asks for, `share` of the whole correction.
    fn wanted(&self, scene: &Scene, patch: &Patch, share: f64) -> DVec3 {
        let relative = scene.slip_velocity_of_patch(&patch.grip);
        let closing = relative.dot(patch.grip.normal);
        let old_normal = patch.impulse.dot(patch.grip.normal);
        let new_normal = (old_normal + share * (closing - self.allowed) * self.along).max(0.0);
        if new_normal == 0.0 && old_normal == 0.0 {
            return DVec3::ZERO;
        }
        let old_friction = patch.impulse - old_normal * patch.grip.normal;
        let sliding = relative - closing * patch.grip.normal;
        let limit = (self.friction * new_normal).min(self.shear_limit);
        let friction = (old_friction + share * sliding * self.across).clamp_length_max(limit);
        new_normal * patch.grip.normal + friction
    }
}

/// One patch (then both places are the same), or two on opposite sides of the body's middle. Two are relaxed together,
/// each from what was before the other: a case and its mirror image then take the same course, which the order of the
/// patches would otherwise spoil.
#[derive(Debug)]
struct Group {
    /// Places among the patches.
    first: usize,
    second: usize,
    /// Share of the correction that each takes, so that two that push the same soil or body do not overshoot.
    share: f64,
}

impl Group {
    fn relax(&self, scene: &mut Scene, patches: &mut [Patch], terms: &[Option<Terms>]) {
        let places = [self.first, self.second];
        let new = places.map(|n| {
            let old = patches[n].impulse;
            terms[n].as_ref().map_or(old, |t| t.wanted(scene, &patches[n], self.share))
        });
        let change = [new[0] - patches[self.first].impulse, new[1] - patches[self.second].impulse];
        self.give(scene, patches, change);
        for (n, impulse) in places.into_iter().zip(new) {
            patches[n].impulse = impulse;
        }
    }

    /// Lets impulses act at the patches.
    fn give(&self, scene: &mut Scene, patches: &[Patch], impulse: [DVec3; 2]) {
        let [first, second] = [self.first, self.second].map(|n| &patches[n].grip);
        if impulse == [DVec3::ZERO; 2] {
            return;
        }
        if self.first == self.second {
            scene.exchange(first, impulse[0]);
        } else {
            scene.exchange_both((first, impulse[0]), (second, impulse[1]));
        }
    }
}

/// Puts the patches into groups. Mirror images stand side by side, as surface points do.
fn mirrored_groups(scene: &Scene, patches: &[Patch], terms: &[Option<Terms>], groups: &mut Vec<Group>) {
    groups.clear();
    let mut first = 0;
    while first < patches.len() {
        let next = first + 1;
        let is_pair = next < patches.len() && are_mirrored(scene, &patches[first], &patches[next]);
        let second = if is_pair { next } else { first };
        let share = match (&terms[first], &terms[second]) {
            (Some(a), Some(b)) if is_pair => {
                1.0 / (1.0 + coupling(scene, (&patches[first], a), (&patches[second], b)))
            }
            _ => 1.0,
        };
        groups.push(Group { first, second, share });
        first = second + 1;
    }
}

/// Whether two patches began with points that are each other's mirror image. In the mirror image of the case they stand the
/// other way round, also when the grid cuts the two sides of the body differently.
fn are_mirrored(scene: &Scene, a: &Patch, b: &Patch) -> bool {
    let (p, q) = (&scene.contacts[a.first], &scene.contacts[b.first]);
    let flip = |v: DVec3| DVec3::new(v.x, -v.y, v.z);
    b.first == a.first + 1 && p.body == q.body && flip(p.arm) == q.arm && flip(p.normal) == q.normal
}

/// How far an impulse at one patch moves the other, over how far it moves itself; 0 to 1.
fn coupling(scene: &Scene, (a, terms_a): (&Patch, &Terms), (b, terms_b): (&Patch, &Terms)) -> f64 {
    let shared = |n: usize| {
        let node = a.grip.nodes[n];
        let place = b.grip.nodes.iter().position(|m| *m == node);
        place.map_or(0.0, |m| {
            let both = a.grip.on_node(n, a.grip.normal) * b.grip.on_node(m, b.grip.normal);
            both.abs().dot(scene.nodes[node as usize].inverse_mass)
        })
    };
    let through_soil = over_corners(std::array::from_fn(shared));
    let through_body = 0.5 * (mobility_of_body(scene, &a.grip) + mobility_of_body(scene, &b.grip));
    let size = through_soil + through_body.dot((a.grip.normal * b.grip.normal).abs());
    (size * terms_a.along.max(terms_b.along)).clamp(0.0, 1.0)
}

/// Velocity per impulse along x, y, z, of soil and body together [1/kg] (diagonal of the mobility).
fn mobility(scene: &Scene, grip: &Grip) -> DVec3 {
    let soil = |n: usize| grip.weight[n] * grip.weight[n] * scene.nodes[grip.nodes[n] as usize].inverse_mass;
    over_corners(std::array::from_fn(soil)) + mobility_of_body(scene, grip)
}

/// The body's part of it.
fn mobility_of_body(scene: &Scene, grip: &Grip) -> DVec3 {
    let fixed = &scene.model.bodies[grip.body];
    let share = scene.model.share();
    DVec3::from_array(std::array::from_fn(|axis| {
        let push = if fixed.translation[axis].is_free() { 1.0 / (fixed.mass * share) } else { 0.0 };
        let lever = grip.arm.cross(DVec3::AXES[axis]).y;
        let turn = if fixed.spin.is_free() { lever * lever / (fixed.axle_inertia * share) } else { 0.0 };
        push + turn
    }))
}
