//! Penalty contact with history.
//!
//! The penetration of a point integrates the relative motion of body and soil, and is relaxed towards the gap that the volume
//! fractions show. The relaxation is per distance travelled, so that a body at rest keeps its load.

use super::law::ContactLaw;
use super::scene::Scene;
use crate::model::Model;
use crate::state::Contact;
use glam::DVec3;

/// Penalty contact.
#[derive(Debug)]
pub(super) struct Penalty {
    /// Of each material the constrained modulus M [Pa], and density times wave speed [kg/(m² s)].
    materials: Vec<[f64; 2]>,
    /// Impulses on the soil at each contact in this step, normal and frictional [N s].
    given: Vec<[DVec3; 2]>,
}

/// Stiffness over M/h; anything from 0.2 to 3 gave the same forces.
const STIFFNESS: f64 = 1.0;
/// Damping over ρc.
const DAMPING: f64 = 0.2;
/// Gap relaxation: fraction of the difference to the geometric gap that is recovered per tenth of a cell of travel.
const GAP_RELAXATION: f64 = 0.1;

impl Penalty {
    pub(super) fn new(model: &Model) -> Self {
        Self {
            materials: model
                .materials
                .iter()
                .map(|m| [m.elastic.constrained(), m.density * m.wave_speed()])
                .collect(),
            given: Vec::new(),
        }
    }

    /// Normal and frictional traction on the soil [Pa]; projects the elastic slip on the Coulomb cone (coefficient) and on the
    /// limit of the frictional traction [Pa].
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

/// Penetration and slip integrate the velocities after contact, which are those of the motion that takes place: with any other
/// velocity the springs are not conservative and contact feeds energy into the soil.
fn remember(c: &mut Contact, relative: DVec3, dt: f64) {
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

    fn act(&mut self, scene: &mut Scene) {
        // All tractions follow from the velocities without contact, so the order of the points does not matter.
        self.given.clear();
        for n in 0..scene.contacts.len() {
            let relative = scene.slip_velocity_of(n);
            let body = &scene.model.bodies[scene.contacts[n].body as usize];
            let friction = [body.friction.min(1e6), body.shear_limit];
            let (normal, tangential) = self.tractions(&mut scene.contacts[n], relative, friction);
            let scale = scene.contacts[n].area * scene.dt;
            self.given.push([normal * scale, tangential * scale]);
        }
        for (n, [normal, friction]) in self.given.iter().enumerate() {
            if *normal != DVec3::ZERO {
                let jacobian = scene.jacobian(n);
                scene.exchange(&jacobian, *normal + *friction);
                scene.record(n, *normal, *friction);
            }
        }
        for n in 0..scene.contacts.len() {
            let relative = scene.slip_velocity_of(n);
            remember(&mut scene.contacts[n], relative, scene.dt);
        }
    }
}
