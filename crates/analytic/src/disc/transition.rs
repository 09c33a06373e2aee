//! The transition angle: where the friction on the rim of a rolling disc changes sign.

use super::RimLoad;
use crate::motion::{slip, turn_ratio};
use numerics::search::root;
use std::f64::consts::FRAC_PI_4;

/// Transition angle θ₀ [rad] of a disc without axle torque: the median of its pressure, ∫₀^θ₀ σ = ∫_θ₀^θ_f σ.
///
/// Soil slides up the front of the rim and backwards under its bottom; with friction fully mobilised on both
/// sides the torques of the two zones cancel for this θ₀. Normal pressures act through the axle and exert no
/// torque.
#[must_use]
pub fn median_angle(rim: &RimLoad) -> f64 {
    angle_at_fraction(rim, 0.5)
}

/// The angle [rad] below which this fraction of the normal thrust acts.
pub(super) fn angle_at_fraction(rim: &RimLoad, fraction: f64) -> f64 {
    let target = fraction * rim.thrust(0.0, rim.angle());
    let excess = |theta: f64| rim.thrust(0.0, theta) - target;
    root(0.0, rim.angle(), 1e-12, excess).unwrap_or(if fraction > 0.5 { rim.angle() } else { 0.0 })
}

/// Slip s at which the friction changes sign at θ₀ [rad]: ωr/v = cos θ₀ − tan(45° − φ/2) sin θ₀.
///
/// Source: Wong & Reece (1967), Part II, from the kinematics of a towed wheel. Not validated for a disc: no
/// measured torque-free slip is known to us. Valid for a towed disc, −1 ≤ s ≤ 0.
#[must_use]
pub fn slip_from_transition(transition: f64, friction_angle: f64) -> f64 {
    slip(transition.cos() - (FRAC_PI_4 - 0.5 * friction_angle).tan() * transition.sin())
}

/// Transition angle θ₀ [rad] at slip s, the inverse of [`slip_from_transition`], limited to the contact arc 0
/// to `limit` [rad].
///
/// A driven disc (s ≥ 0) has no transition: θ₀ = 0. A locked one (s = −1) has θ₀ = 45° + φ/2, usually beyond
/// the contact.
#[must_use]
pub fn transition_from_slip(slip: f64, friction_angle: f64, limit: f64) -> f64 {
    let tilt = FRAC_PI_4 - 0.5 * friction_angle;
    let cosine = (turn_ratio(slip) * tilt.cos()).clamp(-1.0, 1.0);
    (cosine.acos() - tilt).clamp(0.0, limit)
}

/// Contribution of the two opposed friction zones of a free disc to (drag, vertical force) [N]; an upper
/// bound.
///
/// ΔF_H = μ(∫₀^θ₀ σ cos θ − ∫_θ₀^θ_f σ cos θ), ΔF_V = μ(∫_θ₀^θ_f σ sin θ − ∫₀^θ₀ σ sin θ). A few per cent of
/// the total, which the models neglect.
#[must_use]
pub fn opposed_friction_forces(rim: &RimLoad, transition: f64, friction: f64) -> (f64, f64) {
    let zones = |f: fn(f64, f64) -> f64| (rim.sum(0.0, transition, f), rim.sum(transition, rim.angle(), f));
    let (vertical, horizontal) = (zones(|_, cos| cos), zones(|sin, _| sin));
    (friction * (vertical.0 - vertical.1), friction * (horizontal.1 - horizontal.0))
}
