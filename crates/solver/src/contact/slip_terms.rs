//! What one contact point adds to the sums over the rim in a step.

use super::problem::side;
use crate::model::Model;
use crate::state::{Contact, RimSums};
use glam::DVec3;

/// What a contact point adds to the sums over the rim in a step.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct SlipTerms {
    /// Frictional dissipation [J].
    pub(super) dissipation: f64,
    /// Impulse of the pore water along the normal [N s].
    pub(super) water: f64,
    pub(super) sums: RimSums,
}

/// A contact point that slips along the soil in a step.
pub(super) struct Slipping<'a> {
    pub(super) contact: &'a Contact,
    /// Area that the point represents over the area of the surface round it.
    pub(super) share: f64,
    /// The point's impulses on the soil, normal and frictional [N s].
    pub(super) impulses: &'a [DVec3; 2],
    /// The point's slip velocity [m/s].
    pub(super) slip: DVec3,
    /// Direction of the axle of the point's body.
    pub(super) axle: DVec3,
    /// Pore pressure [Pa].
    pub(super) pressure: f64,
}

impl Slipping<'_> {
    /// What the point adds to the sums over the rim.
    pub(super) fn terms(&self, model: &Model) -> SlipTerms {
        let Self { contact: c, share, impulses, slip, axle, pressure } = *self;
        let contact = c.area * model.time_step();
        let water = pressure * contact;
        let mut sums = RimSums::default();
        let friction = model.bodies[c.body as usize].friction;
        sums.add_impulses(c, impulses, water, [friction, c.shear_limit * contact]);
        sums.add_slip(impulses, slip, share * contact, &directions(c, impulses[0], axle));
        SlipTerms { dissipation: impulses[1].dot(slip), water, sums }
    }
}

/// Directions along the surface: along the outline, along the axle, and along the axle away from the
/// mid-plane. A flank has no outline.
fn directions(c: &Contact, normal: DVec3, axle: DVec3) -> [DVec3; 3] {
    // That along which the pressure acts: of the constraint, where several points have one.
    let normal = if normal == DVec3::ZERO { c.normal } else { normal.normalize() };
    let normal = if normal.dot(c.normal) < 0.0 { -normal } else { normal };
    let along = normal.cross(axle).normalize_or_zero();
    let across = along.cross(normal);
    [along, across, across * [1.0, -1.0, 0.0][side(c)]]
}

impl RimSums {
    /// Adds the impulses on the soil of one contact point in one step, with that of the pore water along the
    /// normal [N s], the friction coefficient, and the limit of the frictional impulse [N s]. Pore water may
    /// pull.
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

    /// Adds shear and slip of one contact point along these directions, with its area times the time
    /// step [m² s].
    fn add_slip(&mut self, impulses: &[DVec3; 2], slip: DVec3, contact: f64, directions: &[DVec3; 3]) {
        self.contact += contact;
        for (n, direction) in directions.iter().enumerate() {
            self.shear[n] -= impulses[1].dot(*direction);
            self.slip[n] += slip.dot(*direction) * contact;
        }
    }
}
