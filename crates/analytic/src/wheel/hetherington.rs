//! Hetherington and Littleton: a towed rigid wheel in sand.

use super::RollingResistance;
use crate::bearing::surcharge_factor;
use crate::disc::Disc;
use crate::error::{ModelResult, finite, positive, within};

/// Prefactor of the shallow arc, ½ (3/2)^{4/3}: F_H = 0.858 (W⁴/(γ N_q t d²))^{1/3}.
pub const ARC_PREFACTOR: f64 = 0.858_535_7;

/// RollingResistance resistance R = (2 W⁴ / (γ N_q b d²))^{1/3} [N] and sinkage of a rigid wheel towed in
/// sand.
///
/// With the mean surcharge pressure ½ γ N_q z on the chord: z = (2W/(γ N_q b √d))^{2/3}, R = W √(z/d).
/// Source: Hetherington & Littleton (1978), J. Terramech. 15(2), 95–105 (formula recalled and re-derived).
/// φ in radians, `unit_weight` in N/m³, `weight` in N. Valid for narrow wheels in sand at shallow sinkage (z
/// ≪ d); the width of the contact (N_γ) is neglected.
///
/// # Errors
/// If an input is out of range.
pub fn hetherington_littleton(
    friction_angle: f64,
    unit_weight: f64,
    disc: &Disc,
    weight: f64,
) -> ModelResult<RollingResistance> {
    let (stiffness, w) = stiffness(friction_angle, unit_weight, disc, weight)?;
    let resistance = (2.0 * w.powi(4) / (stiffness * disc.diameter.powi(2))).cbrt();
    let sinkage = (2.0 * w / (stiffness * disc.diameter.sqrt())).powf(2.0 / 3.0);
    Ok(RollingResistance {
        resistance: finite("the rolling resistance", resistance)?,
        sinkage: finite("the sinkage", sinkage)?,
    })
}

/// The wheel of Hetherington & Littleton at a given sinkage z [m]: R = W √(z/d), and the weight carried, W =
/// ½ γ N_q b √d z^{3/2} [N].
///
/// # Errors
/// If an input is out of range (0 < z ≤ d/2).
pub fn hetherington_littleton_at_depth(
    friction_angle: f64,
    unit_weight: f64,
    disc: &Disc,
    sinkage: f64,
) -> ModelResult<(RollingResistance, f64)> {
    let (stiffness, _) = stiffness(friction_angle, unit_weight, disc, 1.0)?;
    let z = within("sinkage [m]", sinkage, 0.0, 0.5 * disc.diameter)?;
    let weight = finite("the weight", 0.5 * stiffness * disc.diameter.sqrt() * z.powf(1.5))?;
    Ok((RollingResistance { resistance: weight * (z / disc.diameter).sqrt(), sinkage: z }, weight))
}

/// Rolling resistance with the surcharge pressure integrated along a shallow arc instead of the chord.
///
/// F_H = 0.858 (W⁴/(γ N_q t d²))^{1/3}, z = (3W/(2 γ N_q t √d))^{2/3}: the limit of model BC for N_γ → 0 and
/// z ≪ d.
///
/// # Errors
/// If an input is out of range.
pub fn shallow_arc(
    friction_angle: f64,
    unit_weight: f64,
    disc: &Disc,
    weight: f64,
) -> ModelResult<RollingResistance> {
    let (stiffness, w) = stiffness(friction_angle, unit_weight, disc, weight)?;
    let resistance = ARC_PREFACTOR * (w.powi(4) / (stiffness * disc.diameter.powi(2))).cbrt();
    let sinkage = (1.5 * w / (stiffness * disc.diameter.sqrt())).powf(2.0 / 3.0);
    Ok(RollingResistance {
        resistance: finite("the rolling resistance", resistance)?,
        sinkage: finite("the sinkage", sinkage)?,
    })
}

/// γ N_q b [N/m²] and the weight, both checked.
fn stiffness(friction_angle: f64, unit_weight: f64, disc: &Disc, weight: f64) -> ModelResult<(f64, f64)> {
    disc.check()?;
    let gamma = positive("unit weight [N/m^3]", unit_weight)?;
    Ok((gamma * surcharge_factor(friction_angle)? * disc.thickness, positive("weight [N]", weight)?))
}
