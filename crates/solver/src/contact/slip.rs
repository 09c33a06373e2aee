//! Slip of the bodies' surfaces along the soil in one step: frictional dissipation, and the sums over the bins of the rim.

use super::problem::{ContactNode, side};
use super::workspace::ContactWorkspace;
use crate::model::Model;
use crate::state::{Contact, ContactImpulse, RimSums, State};
use glam::DVec3;
use mechanics::Step;

/// Adds the contact impulses of the step and the slip to the sums over the rim. Returns the frictional dissipation [J]:
/// frictional impulses times the mean of the slip velocities before and after the step, as for every other work.
pub(super) fn account_slip<R>(
    model: &Model,
    state: &mut State<R>,
    workspace: &ContactWorkspace,
    moving: &Step,
) -> f64 {
    let ContactWorkspace { surfaces, nodes, corner_nodes, impulses, pore_pressures, .. } = workspace;
    let State { contacts, bodies, mechanism, .. } = state;
    let (dt, mut dissipation) = (model.time_step(), 0.0);
    for (number, ((c, corners), impulses)) in contacts.iter().zip(corner_nodes).zip(impulses).enumerate() {
        if *impulses == [DVec3::ZERO; 2] {
            continue;
        }
        let n = c.body as usize;
        let slip = mean_slip(c, nodes, corners, moving);
        dissipation += impulses[1].dot(slip);
        let (body, contact) = (&model.bodies[n], c.area * dt);
        let axle = mechanism.bodies[n].pose.rotation * DVec3::Y;
        let water = pore_pressures.get(number).map_or(0.0, |pressure| pressure * contact);
        if let Some(part) = surfaces[n].part_of(c.point) {
            bodies[n].parts[part].add(impulses, water * c.normal, c.arm, model.modelled_fraction());
        }
        let sums = &mut bodies[n].rim[surfaces[n].bin_of(c.point)];
        sums.add_impulses(c, impulses, water, [body.friction, c.shear_limit * contact]);
        sums.add_slip(impulses, slip, contact, &directions(c, impulses[0], axle));
    }
    dissipation
}

/// Mean of the relative velocity at a contact point before and after the step [m/s].
fn mean_slip(c: &Contact, nodes: &[ContactNode], corners: &[u32; 8], moving: &Step) -> DVec3 {
    let body = c.body as usize;
    let of_body = 0.5 * (moving.velocity_at(body, c.arm) + moving.twist_before(body).at(c.arm));
    let each = corners.iter().zip(c.weight);
    let of_soil = each.fold(DVec3::ZERO, |v, (n, w)| {
        let node = &nodes[*n as usize];
        v + 0.5 * w * (node.velocity + node.velocity_before)
    });
    of_body - of_soil
}

/// Directions along the surface: along the outline, along the axle, and along the axle away from the mid-plane. A flank has no
/// outline.
fn directions(c: &Contact, normal: DVec3, axle: DVec3) -> [DVec3; 3] {
    // That along which the pressure acts: of the constraint, where several points have one.
    let normal = if normal == DVec3::ZERO { c.normal } else { normal.normalize() };
    let normal = if normal.dot(c.normal) < 0.0 { -normal } else { normal };
    let along = normal.cross(axle).normalize_or_zero();
    let across = along.cross(normal);
    [along, across, across * [1.0, -1.0, 0.0][side(c)]]
}

impl RimSums {
    /// Adds the impulses on the soil of one contact point in one step, with that of the pore water along the normal [N s], the
    /// friction coefficient, and the limit of the frictional impulse [N s]. Pore water may pull.
    fn add_impulses(
        &mut self,
        c: &Contact,
        [normal, friction]: &[DVec3; 2],
        water: f64,
        [coefficient, limit]: [f64; 2],
    ) {
        let pressure = normal.length().copysign(normal.dot(c.normal));
        self.normal += pressure;
        self.friction += friction.length();
        self.friction_limit += (coefficient * (pressure - water).max(0.0)).min(limit);
        self.impulse -= *normal + *friction;
    }

    /// Adds shear and slip of one contact point along these directions, with its area times the time step [m² s].
    fn add_slip(&mut self, impulses: &[DVec3; 2], slip: DVec3, contact: f64, directions: &[DVec3; 3]) {
        self.contact += contact;
        for (n, direction) in directions.iter().enumerate() {
            self.shear[n] -= impulses[1].dot(*direction);
            self.slip[n] += slip.dot(*direction) * contact;
        }
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
    /// Adds the impulses on the soil of one contact point in one step; `water` is the portion of the normal one that the pore water
    /// exerts.
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
