//! Slip of the bodies' surfaces along the soil in one step: frictional dissipation, and the sums over the
//! bins of the rim.

use super::problem::{POINTS_AT_ONCE, of_body};
use super::slip_terms::{SlipTerms, Slipping};
use super::workspace::ContactWorkspace;
use crate::cpu::threads::Crew;
use crate::model::Model;
use crate::state::{Contact, ContactImpulse, RimSums, State};
use glam::DVec3;
use mechanics::Step;

/// Adds the contact impulses of the step and the slip to the sums over the rim. Returns the frictional
/// dissipation [J]: frictional impulses times the mean of the slip velocities before and after the step, as
/// for every other work.
pub(super) fn account_slip<R>(
    model: &Model,
    state: &mut State<R>,
    workspace: &mut ContactWorkspace,
    moving: &Step,
    crew: Crew,
) -> f64 {
    let ContactWorkspace {
        surfaces,
        nodes,
        velocity,
        corner_nodes,
        impulses,
        pore_pressures,
        terms,
        rim_stress,
        ..
    } = workspace;
    let State { contacts, bodies, mechanism, .. } = state;
    // Twice the mean.
    velocity.iter_mut().zip(nodes).for_each(|(velocity, node)| *velocity += node.velocity_before);
    let (contacts, impulses, velocity) = (&*contacts, &*impulses, &*velocity);
    terms.resize(contacts.len(), SlipTerms::default());
    crew.portions(terms, POINTS_AT_ONCE, |first, terms| {
        for (n, terms) in terms.iter_mut().enumerate().map(|(n, terms)| (first + n, terms)) {
            let c = &contacts[n];
            *terms = SlipTerms::default();
            if impulses[n] != [DVec3::ZERO; 2] {
                let slip = mean_slip(c, velocity, &corner_nodes[n], moving);
                let axle = mechanism.bodies[c.body as usize].pose.rotation * DVec3::Y;
                let pressure = pore_pressures.get(n).copied().unwrap_or(0.0);
                let share = surfaces[c.body as usize].represented(c) / c.area;
                let impulses = &impulses[n];
                *terms = Slipping { contact: c, share, impulses, slip, axle, pressure }.terms(model);
            }
        }
    });
    let terms = &*terms;
    crew.portions(bodies, 1, |first, bodies| {
        for (n, body) in bodies.iter_mut().enumerate() {
            let own = of_body(contacts, first + n);
            let each = contacts[own.clone()].iter().zip(&impulses[own.clone()]).zip(&terms[own]);
            for ((c, impulses), terms) in each.filter(|((_, impulses), _)| **impulses != [DVec3::ZERO; 2]) {
                let surface = &surfaces[first + n];
                if let Some(part) = surface.part_of(c.point) {
                    let water = terms.water * c.normal;
                    body.parts[part].add(impulses, water, c.arm, model.modelled_fraction());
                }
            }
        }
    });
    rim_stress.add(contacts, bodies, terms);
    terms.iter().fold(0.0, |sum, terms| sum + terms.dissipation)
}

/// Mean of the relative velocity at a contact point before and after the step [m/s], from twice that of the
/// contact nodes.
fn mean_slip(c: &Contact, twice: &[DVec3], corners: &[u32; 8], moving: &Step) -> DVec3 {
    let body = c.body as usize;
    let of_body = 0.5 * (moving.velocity_at(body, c.arm) + moving.twist_before(body).at(c.arm));
    let each = corners.iter().zip(c.weight);
    let of_soil = each.fold(DVec3::ZERO, |v, (n, w)| v + 0.5 * w * twice[*n as usize]);
    of_body - of_soil
}

impl RimSums {
    /// The impulses times one factor, contact and slip times another.
    pub(super) fn times(&self, [impulses, contact]: [f64; 2]) -> Self {
        Self {
            contact: contact * self.contact,
            normal: impulses * self.normal,
            friction: impulses * self.friction,
            friction_limit: impulses * self.friction_limit,
            shear: self.shear.map(|s| impulses * s),
            slip: self.slip.map(|s| contact * s),
            impulse: impulses * self.impulse,
        }
    }

    /// Adds what a contact point contributes.
    pub(super) fn add(&mut self, other: &Self) {
        self.contact += other.contact;
        self.normal += other.normal;
        self.friction += other.friction;
        self.friction_limit += other.friction_limit;
        for n in 0..3 {
            self.shear[n] += other.shear[n];
            self.slip[n] += other.slip[n];
        }
        self.impulse += other.impulse;
    }
}

/// Makes room for the sums over the rim and the parts of every body, at the start of a run.
pub(super) fn clear_rims<R>(model: &Model, state: &mut State<R>, workspace: &ContactWorkspace) {
    for ((body, surface), fixed) in state.bodies.iter_mut().zip(&workspace.surfaces).zip(&model.bodies) {
        body.rim = vec![RimSums::default(); surface.rim().len() + 1];
        let parts = fixed.shape.parts();
        body.parts = vec![ContactImpulse::default(); if parts > 1 { parts } else { 0 }];
    }
}

impl ContactImpulse {
    /// Adds the impulses on the soil of one contact point in one step; `water` is the portion of the normal
    /// one that the pore water exerts.
    pub(super) fn add(
        &mut self,
        [normal, friction]: &[DVec3; 2],
        water: DVec3,
        arm: DVec3,
        modelled_fraction: f64,
    ) {
        self.pore -= water / modelled_fraction;
        self.normal -= *normal / modelled_fraction;
        self.friction -= *friction / modelled_fraction;
        self.moment -= arm.cross(*normal + *friction) / modelled_fraction;
    }
}
