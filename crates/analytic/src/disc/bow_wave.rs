//! The bow wave: soil that accumulates before a disc.

/// Height of the bow wave at the leading contact point [m]: √(χ t z tan φ_r / 2).
///
/// Mass balance of steady towing: the displaced section t z is left behind as two berms at the angle of
/// repose φ_r [rad]; a fraction χ of it (0 for a disc rolling in loose sand, 0.25 to 0.5 for a sliding one)
/// stands before the disc. Source: a hypothesis of this project, not validated. `thickness` and `sinkage` in
/// metres.
#[must_use]
pub fn bow_wave_height(fraction: f64, thickness: f64, sinkage: f64, repose_angle: f64) -> f64 {
    (0.5 * fraction * thickness * sinkage * repose_angle.tan()).max(0.0).sqrt()
}
