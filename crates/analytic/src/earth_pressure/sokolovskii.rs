//! Sokolovskii: the exact self-similar stress field of soil with weight.

use super::Face;
use crate::error::{ModelResult, undefined, within};
use numerics::search::root;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// Result of the self-similar stress field for a face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PassiveField {
    /// Normal passive coefficient K_n: P_n = ½ γ L² K_n.
    pub coefficient: f64,
    /// Rupture distance over face length, r_f / L: from the top edge to where the slip surface reaches the
    /// ground surface.
    pub rupture_ratio: f64,
}

/// The exact passive coefficient of cohesionless soil with weight, by shooting in the self-similar stress
/// field.
///
/// In polar coordinates about the top edge (χ from the horizontal, downwards) the mean stress is γ r s(χ) and
/// σ₁ makes the angle ψ(χ) with the radius. With k = sin φ, equilibrium and Mohr–Coulomb give dχ/dτ = cos
/// 2ψ − k, ds/dτ = cos(χ+2ψ) + s sin 2ψ, dψ/dτ = −[k sin(χ+2ψ) − sin χ + s(1 + 2k cos 2ψ − 3k²)] / (2 k s).
/// From the face (χ = π − α, ψ = −π/2 + ½(δ+Δ), s unknown) every solution ends on the ray where cos 2ψ = k; s
/// is the smallest value for which that ray is the edge of the Rankine zone below the ground surface. Source:
/// Sokolovskii (1965), Statics of Granular Media; shooting scheme derived for this project. It reproduces the
/// N_γ of a smooth strip of Martin (2005) at α = δ = 0.
///
/// Valid for 10° ≤ φ ≤ 50°, −⅔φ ≤ δ ≤ φ, 0 ≤ α ≤ 90°, −10° ≤ β ≤ 25° and |β| < φ. Closer to φ = 0 or δ = −φ
/// a spurious branch appears, so these are out of range. That the field extends into the soil at rest is not
/// proved.
///
/// # Errors
/// Outside that range, and where the angle of the fan would be negative (δ < 0 on a steep face: the field
/// would need a discontinuity).
pub fn sokolovskii(face: &Face) -> ModelResult<PassiveField> {
    check(face)?;
    let field = Field::of(face);
    if field.fan() < -1e-9 {
        return undefined(
            NAME,
            "the stress field would need a discontinuity (δ < 0 or falling ground before a steep face)",
        );
    }
    let Some(stress) = field.face_stress() else {
        return undefined(
            NAME,
            "shooting found no field that satisfies the boundary condition at the ground surface",
        );
    };
    let end = field.shoot(stress, FINE);
    let coefficient = stress * (1.0 - field.k * (2.0 * field.face_psi).cos());
    let rupture_ratio = (end.log_reach + field.surface_reach()).exp();
    if coefficient.is_finite() && coefficient > 0.0 && rupture_ratio.is_finite() {
        Ok(PassiveField { coefficient, rupture_ratio })
    } else {
        undefined(NAME, "the field found is not compressive")
    }
}

const NAME: &str = "Sokolovskii's coefficient";
/// Error tolerance per step while bracketing the solution.
const COARSE: f64 = 1e-5;
/// Error tolerance per step while refining it.
const FINE: f64 = 1e-8;

fn check(face: &Face) -> ModelResult<()> {
    let phi = within("friction angle [rad]", face.friction_angle, 10_f64.to_radians(), 50_f64.to_radians())?;
    within("wall friction [rad]", face.wall_friction, -2.0 / 3.0 * phi, phi)?;
    within("surface inclination [rad]", face.surface, 0.0, FRAC_PI_2)?;
    let slope = phi - 0.05_f64.to_radians();
    within(
        "backfill [rad]",
        face.backfill,
        -(10_f64.to_radians().min(slope)),
        25_f64.to_radians().min(slope),
    )?;
    Ok(())
}

/// The boundary value problem of a face.
struct Field {
    k: f64, // sin φ
    phi: f64,
    face_angle: f64, // χ of the face
    face_psi: f64,   // ψ at the face
    ground_psi: f64, // ψ at the ground
    edge: f64,       // χ of the edge of the Rankine zone
    node: f64,       // ψ there: −(π/4 − φ/2)
    guess: f64,      // s at the face, if the soil were weightless under its own overburden
}

/// End point of the integration from the face.
struct EndPoint {
    angle: f64,     // χ
    log_reach: f64, // ln(r/L) along the slip line from the toe
}

impl Field {
    fn of(face: &Face) -> Self {
        let (phi, beta) = (face.friction_angle, face.backfill);
        let k = phi.sin();
        let sum = face.wall_friction + face.mobilisation();
        let ground_psi = 0.5 * (beta - (beta.sin() / k).clamp(-1.0, 1.0).asin());
        let edge = -beta + ground_psi + FRAC_PI_4 - 0.5 * phi;
        let (face_angle, face_psi) = (PI - face.surface, -FRAC_PI_2 + 0.5 * sum);
        let node = -(FRAC_PI_4 - 0.5 * phi);
        let fan = (face_angle - edge + face_psi - node).max(0.0);
        let guess = (edge + phi).sin() / phi.cos() * (2.0 * fan * phi.tan()).exp();
        Self { k, phi, face_angle, face_psi, ground_psi, edge, node, guess }
    }

    /// The angle of the fan between the face's and the ground's zones [rad].
    fn fan(&self) -> f64 {
        self.face_angle - self.edge + self.face_psi - self.node
    }

    /// The smallest mean stress s at the face for which the integration ends on the edge of the Rankine zone.
    fn face_stress(&self) -> Option<f64> {
        let excess = |log_s: f64, tolerance: f64| self.shoot(log_s.exp(), tolerance).angle - self.edge;
        // On the physical branch the end angle decreases with s; beyond the first root another branch begins.
        let (step, mut low) = (0.3, self.guess.ln() - 1.2);
        let mut at_low = excess(low, COARSE);
        for _ in 0..8 {
            if at_low > 0.0 {
                break;
            }
            low -= 0.5;
            at_low = excess(low, COARSE);
        }
        if at_low.is_nan() || at_low <= 0.0 {
            return None;
        }
        for _ in 0..30 {
            let high = low + step;
            let at_high = excess(high, COARSE);
            if at_high <= 0.0 {
                // The bracket comes from coarse integrations: widen it a little for the accurate ones.
                return root(low - 0.01, high + 0.01, 1e-9, |log_s| excess(log_s, FINE)).map(f64::exp);
            }
            low = high;
        }
        None
    }

    /// Integrates from the face with mean stress `stress` and the error `tolerance` per step to the ray cos
    /// 2ψ = k.
    fn shoot(&self, stress: f64, tolerance: f64) -> EndPoint {
        let mut y = [self.face_angle, stress.ln(), self.face_psi, 0.0];
        let mut step = 0.02;
        for _ in 0..2000 {
            let (slack, excess) = self.distance(&y);
            if slack.abs() + excess.abs() < 1e-4 {
                break;
            }
            let (next, error) = runge_kutta(&y, step, |y| self.slope(y));
            let scale = error / tolerance;
            if scale <= 1.0 {
                y = next;
            }
            step *= (0.9 * scale.max(1e-8).powf(-0.2)).clamp(0.2, 4.0);
            if !y[2].is_finite() || step < 1e-12 {
                return EndPoint { angle: f64::NAN, log_reach: f64::NAN };
            }
        }
        // The node is degenerate (double eigenvalue −2 cos φ); the remaining distance follows from the
        // linearised equations.
        let (slack, excess) = self.distance(&y);
        let rest = 0.5 * slack - self.phi.cos() * excess / (4.0 * self.k);
        EndPoint { angle: y[0] + rest, log_reach: y[3] + rest / (2.0 * self.node).tan() }
    }

    /// Distance of the state from the node: in ψ [rad], and in s relative to s.
    fn distance(&self, y: &[f64; 4]) -> (f64, f64) {
        (y[2] - self.node, 1.0 - (y[0] + self.phi).sin() / (self.phi.cos() * y[1].exp()))
    }

    /// Right-hand side for (χ, ln s, ψ, ln r).
    fn slope(&self, y: &[f64; 4]) -> [f64; 4] {
        let (k, s) = (self.k, y[1].exp());
        let (sin_double, cos_double) = (2.0 * y[2]).sin_cos();
        let (sin_angle, cos_angle) = y[0].sin_cos();
        let sin_sum = sin_angle * cos_double + cos_angle * sin_double;
        let cos_sum = cos_angle * cos_double - sin_angle * sin_double;
        let angle_rate = cos_double - k;
        [
            angle_rate,
            cos_sum / s + sin_double,
            -((k * sin_sum - sin_angle) / s + 1.0 + 2.0 * k * cos_double - 3.0 * k * k) / (2.0 * k),
            angle_rate / (y[2] + self.node).tan(),
        ]
    }

    /// ln(r_f / r) along the straight slip line through the Rankine zone, from its edge to the ground.
    fn surface_reach(&self) -> f64 {
        let at_edge = 2.0 * self.node;
        let at_ground = self.ground_psi + self.node;
        (at_edge.sin() / at_ground.sin()).abs().ln()
    }
}

/// One step of the fifth-order method of Dormand & Prince (1980); the error is the largest of the first three
/// components.
fn runge_kutta(y: &[f64; 4], h: f64, f: impl Fn(&[f64; 4]) -> [f64; 4]) -> ([f64; 4], f64) {
    const ROWS: [&[f64]; 6] = [
        &[1.0 / 5.0],
        &[3.0 / 40.0, 9.0 / 40.0],
        &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
        &[19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0],
        &[9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0],
        &[35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
    ];
    const ERROR: [f64; 7] = [
        71.0 / 57600.0,
        0.0,
        -71.0 / 16695.0,
        71.0 / 1920.0,
        -17253.0 / 339_200.0,
        22.0 / 525.0,
        -1.0 / 40.0,
    ];
    let mut slopes = [[0.0; 4]; 7];
    slopes[0] = f(y);
    let mut next = *y;
    for (stage, row) in ROWS.iter().enumerate() {
        next = *y;
        for (weight, slope) in row.iter().zip(&slopes) {
            for i in 0..4 {
                next[i] += h * weight * slope[i];
            }
        }
        slopes[stage + 1] = f(&next);
    }
    let error = (0..3)
        .map(|i| (h * ERROR.iter().zip(&slopes).map(|(e, s)| e * s[i]).sum::<f64>()).abs())
        .fold(0.0, f64::max);
    (next, if error.is_finite() { error } else { f64::INFINITY })
}
