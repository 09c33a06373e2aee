//! Friction on the two flat faces of a disc.

use super::{Disc, Drive};
use crate::error::{ModelResult, within};
use crate::motion::turn_ratio;
use crate::soil::Soil;
use numerics::quadrature::gauss_points;

/// Drag and torque of the two flat faces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SideFaces {
    /// Drag [N].
    pub drag: f64,
    /// Vertical force [N].
    pub vertical: f64,
    /// Torque about the axle [N m]; positive when it rotates the disc forwards.
    pub torque: f64,
}

/// Friction on the embedded segments of both faces at sinkage z [m] and rate ratio ωr/v (1 free rolling, 0
/// locked).
///
/// F = −2 μ K_s γ ∬ h v/|v| dA, v = (V + ω y, −ω x), h the depth, K_s the ratio of lateral to vertical stress
/// (0.5 without better knowledge). Source: derived for this project. Negligible compared with the rim forces
/// unless t < 0.05 d.
///
/// # Errors
/// If the disc, the sinkage (0 < z ≤ 0.95 d), the stress ratio (0 to 5) or the rate ratio (−1 to 4) is out of
/// range.
pub fn side_faces(
    soil: &Soil,
    disc: &Disc,
    sinkage: f64,
    turn_ratio: f64,
    lateral: f64,
) -> ModelResult<SideFaces> {
    disc.contact(sinkage, 0.0)?;
    let rate = within("rate ratio", turn_ratio, -1.0, 4.0)? * 2.0 / disc.diameter;
    let scale =
        2.0 * soil.body_friction * within("lateral stress ratio", lateral, 0.0, 5.0)? * soil.unit_weight;
    let radius = 0.5 * disc.diameter;
    let top = sinkage - radius;
    let mut sum = SideFaces { drag: 0.0, vertical: 0.0, torque: 0.0 };
    for (y, height) in gauss_points(-radius, top) {
        let half = (radius * radius - y * y).max(0.0).sqrt();
        for (x, width) in gauss_points(-half, half) {
            let velocity = (1.0 + rate * y, -rate * x);
            let speed = velocity.0.hypot(velocity.1);
            if speed < 1e-12 {
                continue;
            }
            let force = scale * (top - y) * height * width / speed;
            sum.drag += force * velocity.0;
            sum.vertical -= force * velocity.1;
            // Forward rolling is clockwise: torque = z F_x − x F_z with the force against the velocity.
            sum.torque += force * (x * velocity.1 - y * velocity.0);
        }
    }
    Ok(sum)
}

impl Drive {
    /// Turn ratio ωr/v of the disc, given the slip predicted by a model.
    #[must_use]
    pub fn turn_ratio(&self, slip: f64) -> f64 {
        match self {
            Self::Locked => 0.0,
            _ => turn_ratio(slip).clamp(0.0, 4.0),
        }
    }
}
