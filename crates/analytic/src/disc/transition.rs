//! Where the friction on the rim of a rolling disc changes sign.

use super::RimLoad;
use crate::motion::{slip, turn_ratio};
use crate::numeric::root;
use std::f64::consts::FRAC_PI_4;

/// Transition angle θ₀ [rad] of a disc without axle torque: the median of its pressure, ∫₀^θ₀ σ = ∫_θ₀^θ_f σ.
///
/// Soil slides up the front of the rim and is overrun at the bottom; with friction fully mobilised on both sides the
/// torques cancel there. Normal pressures pass through the axle and never turn a disc.
#[must_use]
pub fn median_angle(rim: &RimLoad) -> f64 {
    share_angle(rim, 0.5)
}

/// The angle behind which the fraction `share` of the normal thrust lies [rad].
pub(super) fn share_angle(rim: &RimLoad, share: f64) -> f64 {
    let wanted = share * rim.thrust(0.0, rim.angle());
    let miss = |theta: f64| rim.thrust(0.0, theta) - wanted;
    root(0.0, rim.angle(), 1e-12, miss).unwrap_or(if share > 0.5 { rim.angle() } else { 0.0 })
}

/// Slip s at which the friction changes sign at θ₀ [rad]: ωr/v = cos θ₀ − tan(45° − φ/2) sin θ₀.
///
/// Source: Wong & Reece (1967), II; the transition from the kinematics of a towed wheel. Untested for a disc: no
/// torque-free slip has been measured in the data known to us. Valid for a towed disc, −1 ≤ s ≤ 0.
#[must_use]
pub fn slip_from_transition(transition: f64, friction_angle: f64) -> f64 {
    slip(transition.cos() - (FRAC_PI_4 - 0.5 * friction_angle).tan() * transition.sin())
}

/// Transition angle θ₀ [rad] at slip s, the inverse of [`slip_from_transition`], kept within the contact 0 to `limit`.
///
/// A driven disc (s ≥ 0) has none: θ₀ = 0. A locked one (s = −1) has θ₀ = 45° + φ/2, usually beyond the contact.
#[must_use]
pub fn transition_from_slip(slip: f64, friction_angle: f64, limit: f64) -> f64 {
    let tilt = FRAC_PI_4 - 0.5 * friction_angle;
    let cosine = (turn_ratio(slip) * tilt.cos()).clamp(-1.0, 1.0);
    (cosine.acos() - tilt).clamp(0.0, limit)
}

/// What the two opposed friction zones of a free disc add to (drag, vertical force) [N], an upper bound.
///
/// ΔF_H = μ(∫₀^θ₀ σ cos θ − ∫_θ₀^θ_f σ cos θ), ΔF_V = μ(∫_θ₀^θ_f σ sin θ − ∫₀^θ₀ σ sin θ). A few per cent of the whole;
/// the models leave it out.
#[must_use]
pub fn rolling_split(rim: &RimLoad, transition: f64, friction: f64) -> (f64, f64) {
    let part = |f: fn(f64, f64) -> f64| (rim.sum(0.0, transition, f), rim.sum(transition, rim.angle(), f));
    let (behind, ahead) = (part(|_, cos| cos), part(|sin, _| sin));
    (friction * (behind.0 - behind.1), friction * (ahead.1 - ahead.0))
}
