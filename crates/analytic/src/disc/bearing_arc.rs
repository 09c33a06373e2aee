//! Model BC: bearing capacity along the contact arc, for soil that fails sideways from under the disc.

use super::{Contact, Disc, RimPressure};
use crate::bearing::{Footing, Method, undrained_friction_limit};
use crate::capacity::ultimate_pressure;
use crate::error::ModelResult;
use crate::soil::Soil;

/// Pressure on the rim if every element of the arc is a strip footing of the disc's thickness at its own
/// depth.
///
/// σ(θ) = ½ γ B′ N_γ* + c N_c* + γ N_q* h(θ), B′ = min(t, L), N* = N s d i at the mean depth z/2 with sides
/// min(t, L) and max(t, L) and the load inclined as the friction inclines it (below). Without friction and
/// cohesion, dimensionless: F̄_H = ½ min(t̄, √Z) N_γ* Z + ½ N_q* Z², F̄_V = ½ min(t̄, √Z) N_γ* √(Z(1−Z)) +
/// (N_q*/8)(θ_f − sin θ_f cos θ_f). Source: derived for this project after the structure of Hambleton &
/// Drescher (2009), J. Terramech. 46, 35–47, with Meyerhof's (1963) factors; estimated error 30 to 50 % of
/// the force at a given friction angle. Valid for the friction angles of the factors and 0 < z ≤ 0.95 d.
/// Undrained clay has σ = s_u N_c* + γ h instead.
///
/// # Errors
/// If the soil is outside the range of the factors.
pub fn bearing_arc(
    soil: &Soil,
    disc: &Disc,
    contact: &Contact,
    mobilised_friction: f64,
    method: Method,
) -> ModelResult<RimPressure> {
    let footing = Footing {
        load_inclination: load_inclination(contact, mobilised_friction),
        ..footing_of(disc.thickness, contact.chord, contact.depth)
    };
    let pressure = ultimate_pressure(soil, &footing, method)?;
    let mut rim = RimPressure::on(contact, disc.diameter, disc.thickness);
    (rim.base, rim.by_depth) = (pressure.base, pressure.by_depth);
    Ok(rim)
}

/// Inclination of the load that weakens the soil [rad]: of a sliding disc its inclination to the normal of
/// the chord, atan μ_m; of a driven one what it exceeds the vertical by, backwards.
///
/// The friction of a rolling or driven disc pushes the soil back and down and so turns the load on the soil
/// from the normal of the chord towards the vertical. In the exact solution of weightless soil that raises
/// the pressure, K_q(δ = 0) = N_q e^{−2α tan φ} to K_q(δ = α) ≈ N_q; no reduction is made on this way.
fn load_inclination(contact: &Contact, mobilised_friction: f64) -> f64 {
    if mobilised_friction >= 0.0 {
        mobilised_friction.atan()
    } else {
        (-mobilised_friction.atan() - contact.inclination).max(0.0)
    }
}

/// The footing that a contact of this thickness and chord [m] is, with the lowest point at a depth [m], under
/// a load normal to it.
fn footing_of(thickness: f64, chord: f64, depth: f64) -> Footing {
    Footing {
        width: thickness.min(chord),
        length: thickness.max(chord),
        depth: 0.5 * depth,
        load_inclination: 0.0,
    }
}

/// The largest friction that the rim can transfer to the soil: μ, but at most that at which the soil itself
/// shears, tan φ of sand and α s_u over the pressure of clay.
///
/// # Errors
/// If the disc is out of range.
pub(super) fn friction_limit(soil: &Soil, disc: &Disc, contact: &Contact) -> ModelResult<f64> {
    let most = soil.interface_friction();
    if !soil.is_undrained() {
        return Ok(most);
    }
    let footing = footing_of(disc.thickness, contact.chord, contact.depth);
    Ok(most.min(undrained_friction_limit(&footing, soil.adhesion_factor)?))
}

/// Vertical force [N] on a disc that is pressed straight down to a sinkage z [m] and neither rolls nor
/// slides.
///
/// The soil under the whole contact, 2√(z(d − z)) long, is a footing: V = t ∫ [½ γ B′ N_γ* + c N_c* + γ N_q*
/// h(x)] dx, with the factors at the mean depth z/2. Source: Hambleton & Drescher (2008), J. Terramech. 45,
/// 201–211 (structure recalled).
///
/// # Errors
/// If the soil or the disc is out of range.
pub fn indentation_force(soil: &Soil, disc: &Disc, sinkage: f64, method: Method) -> ModelResult<f64> {
    let contact = disc.contact(sinkage, 0.0)?;
    let (sin, cos) = contact.angle.sin_cos();
    let radius = 0.5 * disc.diameter;
    let footing = footing_of(disc.thickness, disc.diameter * sin.max(1e-6), contact.depth);
    let pressure = ultimate_pressure(soil, &footing, method)?;
    // Beyond the equator the contact is as long as the disc.
    let (half, area) = if cos >= 0.0 {
        (radius * sin, radius * radius * (contact.angle - sin * cos))
    } else {
        let below = 0.25 * std::f64::consts::PI * disc.diameter * disc.diameter;
        (radius, 0.5 * below + disc.diameter * (sinkage - radius))
    };
    Ok(disc.thickness * (pressure.base * 2.0 * half + pressure.by_depth * area))
}
