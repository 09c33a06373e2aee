//! Model BC: bearing capacity along the contact arc, for soil that fails sideways from under the disc.

use super::{Contact, Disc, RimPressure};
use crate::bearing::{
    Footing, Method, cohesion_factor, corrections, surcharge_factor, weight_factor_hansen,
    weight_factor_lyamin, weight_factor_meyerhof,
};
use crate::error::ModelResult;
use crate::soil::Soil;

/// Pressure on the rim if every element of the arc is a strip footing of the disc's thickness at its own depth.
///
/// σ(θ) = ½ γ B′ N_γ* + c N_c* + γ N_q* h(θ), B′ = min(t, L), N* = N s d i at the mean depth z/2 with sides min(t, L)
/// and max(t, L) and the load inclined as the friction inclines it (below). Without friction and cohesion, dimensionless:
/// F̄_H = ½ min(t̄, √Z) N_γ* Z + ½ N_q* Z², F̄_V = ½ min(t̄, √Z) N_γ* √(Z(1−Z)) + (N_q*/8)(θ_f − sin θ_f cos θ_f).
/// Source: derived for this project after the structure of Hambleton & Drescher (2009), J. Terramech. 46, 35–47, with
/// Meyerhof's (1963) factors; estimated error 30 to 50 % of the force at a given friction angle. Valid for the friction
/// angles of the factors and 0 < z ≤ 0.95 d.
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
    let phi = soil.friction_angle;
    let (width, length) = (disc.thickness.min(contact.chord), disc.thickness.max(contact.chord));
    let load_inclination = load_inclination(contact, mobilised_friction);
    let footing = Footing { width, length, depth: 0.5 * contact.depth, load_inclination };
    let factor = corrections(method, phi, &footing)?;
    let n_gamma = match method {
        Method::Meyerhof => weight_factor_meyerhof(phi)?,
        Method::HansenVesic => weight_factor_hansen(phi)?,
        Method::Lyamin => weight_factor_lyamin(phi)?,
    };
    let mut rim = RimPressure::on(contact, disc.diameter, disc.thickness);
    rim.base = 0.5 * soil.unit_weight * width * n_gamma * factor.weight
        + soil.cohesion * cohesion_factor(phi)? * factor.cohesion;
    rim.by_depth = soil.unit_weight * surcharge_factor(phi)? * factor.surcharge;
    Ok(rim)
}

/// Inclination of the load that weakens the soil [rad]: of a sliding disc its inclination to the normal of the chord, atan μ_m; of
/// a driven one what it exceeds the vertical by, backwards.
///
/// The friction of a rolling or driven disc pushes the soil back and down and so turns the load on the soil from the normal
/// of the chord towards the vertical. In the exact solution of weightless soil that raises the pressure,
/// K_q(δ = 0) = N_q e^{−2α tan φ} to K_q(δ = α) ≈ N_q; no reduction is made on this way.
fn load_inclination(contact: &Contact, mobilised_friction: f64) -> f64 {
    if mobilised_friction >= 0.0 {
        mobilised_friction.atan()
    } else {
        (-mobilised_friction.atan() - contact.inclination).max(0.0)
    }
}
