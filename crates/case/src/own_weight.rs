//! What its own weight does to soil.

use super::resolved::{Case, Soil};

/// Depth of the box below the surface [m].
pub(super) fn depth(case: &Case) -> f64 {
    case.ground.surface() - case.domain.low.z
}

/// Mean strain of a soil in the box under its own weight, γ H/(2 M), M the oedometric modulus.
pub(super) fn compression(case: &Case, soil: &Soil) -> f64 {
    let modulus = soil.material().wave_speed().powi(2) * soil.density;
    0.5 * soil.unit_weight * depth(case) / modulus
}
