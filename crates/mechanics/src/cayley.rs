//! The Cayley map: the rotation of a step from its angular velocity.
//!
//! With w = Δt ω it is cay(w) = (1 − ŵ/2)⁻¹ (1 + ŵ/2), a rotation about w by 2 atan(|w|/2). It differs from
//! the exponential by terms of third order and satisfies exactly (R₁ − R₀) r = w × ½(R₀ + R₁) r for R₁ =
//! cay(w) R₀: displacements within a step are linear in the mean arms (Simo & Wong 1991; Austin,
//! Krishnaprasad & Wang 1993).

use glam::{DMat3, DQuat, DVec3};

/// Rotation by the Cayley map of `turn`, the angular velocity times the step [rad].
#[must_use]
pub fn rotation(turn: DVec3) -> DQuat {
    let scale = 1.0 / (1.0 + 0.25 * turn.length_squared()).sqrt();
    let half = 0.5 * scale * turn;
    DQuat::from_xyzw(half.x, half.y, half.z, scale)
}

/// Rotation about the same axis by half the angle of [`rotation`].
#[must_use]
pub fn half_rotation(turn: DVec3) -> DQuat {
    (rotation(turn) + DQuat::IDENTITY).normalize()
}

/// The inverse of C, where ½(R₀ + R₁) = C R½ and R½ is the rotation half-way: C shrinks by the cosine of half
/// the angle what is perpendicular to the axis.
#[must_use]
pub fn stretch(turn: DVec3) -> DMat3 {
    let k = (1.0 + 0.25 * turn.length_squared()).sqrt();
    DMat3::from_diagonal(DVec3::splat(k)) - outer(turn, turn) * (0.25 / (k + 1.0))
}

/// The matrix a bᵀ.
#[must_use]
pub(crate) fn outer(a: DVec3, b: DVec3) -> DMat3 {
    DMat3::from_cols(a * b.x, a * b.y, a * b.z)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TURN: DVec3 = DVec3::new(0.3, -0.8, 0.5);

    #[test]
    fn displacements_are_linear_in_the_mean_arm() {
        let start = DQuat::from_rotation_x(0.7) * DQuat::from_rotation_z(-2.0);
        let arm = DVec3::new(1.0, 2.0, -0.5);
        let (r0, r1) = (start * arm, rotation(TURN) * start * arm);
        assert!((r1 - r0 - TURN.cross(0.5 * (r0 + r1))).length() < 5e-15);
    }

    #[test]
    fn the_mean_rotation_is_the_half_rotation_shrunk() {
        let mean = 0.5 * (DMat3::IDENTITY + DMat3::from_quat(rotation(TURN)));
        let half = DMat3::from_quat(half_rotation(TURN));
        assert!((stretch(TURN) * mean).abs_diff_eq(half, 1e-15));
    }
}
