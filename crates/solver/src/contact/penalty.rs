//! Penalty contact with history.
//!
//! The penetration of a point integrates the relative motion of body and soil, and is relaxed towards the gap
//! that the volume fractions show. The relaxation is per distance travelled, so that a body at rest keeps its
//! load.

use super::law::ContactLaw;
use super::problem::ContactProblem;
use crate::model::Model;
use crate::state::Contact;
use glam::DVec3;

/// Penalty contact.
#[derive(Debug)]
pub(super) struct Penalty {
    /// For each material the constrained modulus M [Pa], and the impedance: density times wave speed [kg/(m²
    /// s)].
    materials: Vec<[f64; 2]>,
    /// Impulses on the soil at each contact in this step, normal and frictional [N s].
    impulses: Vec<[DVec3; 2]>,
}

/// Stiffness over M/h; anything from 0.2 to 3 gave the same forces.
const STIFFNESS: f64 = 1.0;
/// Damping over ρc.
const DAMPING: f64 = 0.2;
/// Gap relaxation: fraction of the difference to the geometric gap that is recovered per tenth of a cell of
/// travel.
const GAP_RELAXATION: f64 = 0.1;

impl Penalty {
    pub(super) fn new(model: &Model) -> Self {
        Self {
            materials: model
                .materials
                .iter()
                .map(|m| [m.elastic.constrained(), m.density * m.wave_speed()])
                .collect(),
            impulses: Vec::new(),
        }
    }

    /// Normal and frictional traction on the soil [Pa]; projects the elastic slip on the Coulomb cone
    /// (coefficient) and on the limit of the frictional traction [Pa].
    fn tractions(&self, c: &mut Contact, relative: DVec3, [friction, most]: [f64; 2]) -> (DVec3, DVec3) {
        if c.penetration <= 0.0 {
            c.slip = DVec3::ZERO;
            return (DVec3::ZERO, DVec3::ZERO);
        }
        let [modulus, impedance] = self.materials[c.material as usize];
        let stiffness = STIFFNESS * modulus / c.width;
        let closing = relative.dot(c.normal);
        let pressure = (stiffness * c.penetration + DAMPING * impedance * closing).max(0.0);
        let limit = (friction * pressure).min(most);
        let held = 0.5 * stiffness * c.slip.length();
        if held > limit {
            c.slip *= limit / held;
        }
        (pressure * c.normal, 0.5 * stiffness * c.slip)
    }
}

/// Integrates penetration and slip with the velocities after contact, those of the actual motion: with any
/// other velocity the springs are not conservative, and contact feeds energy into the soil.
fn update_history(c: &mut Contact, relative: DVec3, dt: f64) {
    let closing = relative.dot(c.normal);
    c.penetration += closing * dt;
    c.slip += (relative - closing * c.normal) * dt;
    c.slip -= c.slip.dot(c.normal) * c.normal;
}

impl ContactLaw for Penalty {
    fn update(&self, c: &mut Contact, gap: f64, travel: Option<f64>) {
        if let Some(travel) = travel {
            let relaxation = GAP_RELAXATION * (travel / (0.1 * c.width)).min(3.0);
            c.penetration += relaxation * (-gap - c.penetration);
        } else {
            (c.penetration, c.slip) = (-gap, DVec3::ZERO);
        }
    }

    fn act(&mut self, problem: &mut ContactProblem) {
        // All tractions follow from the velocities without contact, so the order of the points does not
        // matter.
        self.impulses.clear();
        for n in 0..problem.contacts.len() {
            let relative = problem.slip_velocity_of(n);
            let body = &problem.model.bodies[problem.contacts[n].body as usize];
            let friction = [body.friction.min(1e6), problem.contacts[n].shear_limit];
            let (normal, tangential) = self.tractions(&mut problem.contacts[n], relative, friction);
            let scale = problem.contacts[n].area * problem.dt;
            self.impulses.push([normal * scale, tangential * scale]);
        }
        for (n, [normal, friction]) in self.impulses.iter().enumerate() {
            if *normal != DVec3::ZERO {
                let jacobian = problem.jacobian(n);
                problem.exchange(&jacobian, *normal + *friction);
                problem.impulses[n] = [*normal, *friction];
            }
        }
        // Bodies on each other answer what the soil has done to them.
        if problem.moving.touches() > 0 {
            problem.moving.settle();
        }
        for n in 0..problem.contacts.len() {
            let relative = problem.slip_velocity_of(n);
            update_history(&mut problem.contacts[n], relative, problem.dt);
        }
    }
}
