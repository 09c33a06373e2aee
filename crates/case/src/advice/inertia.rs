//! Whether a motion is slow enough: what inertia and bulk viscosity add to the force.

use super::passive::passive_coefficient;
use crate::clearance::{SoilConditions, deepest};
use crate::path::{body_length, fastest};
use crate::resolved::{Body, Case};
use crate::tow::TowDirection;
use physics::elastic::Elastic;

/// Fraction of the force above which the contribution of inertia or viscosity is mentioned; chosen: less is
/// below the uncertainty due to grid and friction angle.
const NOTABLE: f64 = 0.1;

/// What the soil's inertia adds to the force on a body.
#[derive(Clone, Copy, Debug)]
pub struct Inertia {
    /// Froude number v²/(g z).
    pub froude: f64,
    /// The depth z [m].
    pub depth: f64,
    /// What is added, over the force without it.
    pub share: f64,
}

/// Whether the motion is slow enough to be quasi-static.
pub(super) fn speed(case: &Case, body: &Body, notes: &mut Vec<String>) {
    let (axis, speed, depth) = motion(case, body);
    if let Some(Inertia { froude, depth, share }) = inertia(case, body) {
        notes.push(format!(
            "{}: Froude number v²/(g z) = {froude:.2} at z = {depth:.3} m: inertia will add some {:.0} % to the force; a \
             slower motion reduces it.",
            body.name,
            100.0 * share
        ));
    }
    viscosity(case, body, speed, depth, case.grid.fine_cell()[axis], notes);
}

/// Axis along which a body moves fastest, that speed [m/s] and its depth [m].
fn motion(case: &Case, body: &Body) -> (usize, f64, f64) {
    let speeds = body.guided().translation.each_ref().map(fastest);
    let axis = (0..3).fold(0, |most, axis| if speeds[axis] > speeds[most] { axis } else { most });
    let length = body_length(std::slice::from_ref(body));
    // A body that enters the soil later is not in it yet: a tenth of its length is assumed.
    let depth = deepest(body, &SoilConditions::of(case), case.duration).max(0.1 * length);
    (axis, speeds[axis], depth)
}

/// What the soil's inertia adds to the force on a body, if it is more than a tenth. The ground carries the
/// load of a body that is free to sink at any speed, so that inertia is compared with this load; for any
/// other body it is compared with the passive thrust.
#[must_use]
pub fn inertia(case: &Case, body: &Body) -> Option<Inertia> {
    let (_, speed, depth) = motion(case, body);
    if case.gravity <= 0.0 || case.soil.unit_weight <= 0.0 || speed <= 0.0 {
        return None;
    }
    let froude = analytic::froude(speed, case.gravity, depth);
    let added = analytic::inertia_pressure(case.soil.density, speed);
    let share = match body.pressing_force(case.normal_weight(body)) {
        Some(load) if load > 0.0 => {
            let across = TowDirection::of(case, body).width_across(body);
            added * depth * case.domain.width_of_body(across) / load
        }
        // Pressure due to the soil's weight grows from 0 at the surface: its mean is that at half the depth.
        _ => added / contact_pressure(case, 0.5 * depth),
    };
    (share > NOTABLE).then_some(Inertia { froude, depth, share })
}

/// Typical contact pressure of soil failing round a body at this depth [Pa]; infinite for soil that does not
/// fail.
fn contact_pressure(case: &Case, depth: f64) -> f64 {
    match (case.soil.law.friction_angle(), case.soil.law.cohesion()) {
        (Some(friction_angle), Some(cohesion)) => {
            let passive = passive_coefficient(friction_angle);
            case.soil.unit_weight * depth * passive + 2.0 * cohesion * passive.sqrt()
        }
        (None, Some(shear_strength)) => 5.0 * shear_strength,
        (_, None) => f64::INFINITY,
    }
}

/// What bulk viscosity adds to the pressure on the body; `cell` is the width of a cell along the motion [m].
fn viscosity(case: &Case, body: &Body, speed: f64, depth: f64, cell: f64, notes: &mut Vec<String>) {
    let pressure = contact_pressure(case, depth);
    let wave_speed =
        Elastic::new(case.soil.stiffest_modulus(), case.soil.poisson_ratio).wave_speed(case.soil.density);
    // The strain rate is the speed over the length of the contact, √(z d), not over one cell: on the towed
    // disc, where a cell's would make a third of the pressure, switching the viscosity off changes the drag
    // by less than 1 %.
    let contact = (depth * body_length(std::slice::from_ref(body))).sqrt().max(cell);
    let speed_difference = speed * cell / contact;
    let viscous = case.soil.density * wave_speed * case.numerics.bulk_viscosity_linear * speed_difference;
    if viscous > NOTABLE * pressure {
        notes.push(format!(
            "{}: bulk viscosity of {viscous:.0} Pa is {:.0} % of a contact pressure of about {pressure:.0} Pa; \
             a slower motion or a smaller numerics.bulk_viscosity_linear reduces it.",
            body.name,
            100.0 * viscous / pressure
        ));
    }
}
