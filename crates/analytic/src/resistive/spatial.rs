//! 3D-RFT: three-dimensional RFT for any surface and motion.

use super::{Traction, dot};
use crate::error::{ModelResult, positive, within};

/// Coefficients of f₁, f₂, f₃ over the twenty monomials of (x₁, x₂, x₃).
const COEFFICIENTS: [[f64; 20]; 3] = [
    [
        0.00212, -0.02320, -0.20890, -0.43083, -0.00259, 0.48872, -0.00415, 0.07204, -0.02750, -0.08772,
        0.01992, -0.45961, 0.40799, -0.10107, -0.06576, 0.05664, -0.09269, 0.01892, 0.01033, 0.15120,
    ],
    [
        -0.06796, -0.10941, 0.04725, -0.06914, -0.05835, -0.65880, -0.11985, -0.25739, -0.26834, 0.02692,
        -0.00736, 0.63758, 0.08997, 0.21069, 0.04748, 0.20406, 0.18589, 0.04934, 0.13527, -0.33207,
    ],
    [
        -0.02634, -0.03436, 0.45256, 0.00835, 0.02553, -1.31290, -0.05532, 0.06790, -0.16404, 0.02287,
        0.02927, 0.95406, -0.00131, -0.11028, 0.01487, -0.02730, 0.10911, -0.04097, 0.07881, -0.27519,
    ],
];

/// Three-dimensional resistive force theory.
///
/// α = f₁ ñ + f₂ v − f₃ z with x₁ = −v_z, x₂ = −ñ_z, x₃ = ñ·v, ñ the normal or its opposite, whichever points
/// down, and cubic polynomials f_i; traction = ξ_n α |z|, its tangential component at most μ times the normal
/// one. Source: Agarwal, Goldman & Kamrin (2023), PNAS 120, arXiv 2205.14920; coefficients read in
/// KKKobefeng/3D-RFT. That the published angles β, γ, ψ reduce to these three products is our interpretation.
/// Valid for tan φ up to 0.8, quasi-static.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpatialLaw {
    /// Stiffness ξ_n [N/m³].
    pub stiffness: f64,
    /// Coefficient of friction between soil and surface.
    pub friction: f64,
}

/// Stiffness over unit weight ξ_n/(ρ g) = 894 μ³ − 386 μ² + 89 μ, μ = tan φ. Source: Agarwal et al. (2023), a
/// cubic fit.
///
/// φ in radians; the fit covers tan φ up to about 0.8 and is not extrapolated beyond 0.85.
///
/// # Errors
/// Unless 0.1 ≤ tan φ ≤ 0.85.
pub fn stiffness_per_unit_weight(friction_angle: f64) -> ModelResult<f64> {
    let mu = within("internal friction tan φ for 3D-RFT", friction_angle.tan(), 0.1, 0.85)?;
    Ok(894.0 * mu.powi(3) - 386.0 * mu * mu + 89.0 * mu)
}

impl SpatialLaw {
    /// The law for soil of friction angle φ [rad] and unit weight γ [N/m³] on a surface with the friction
    /// coefficient μ.
    ///
    /// # Errors
    /// If φ is beyond the fit of [`stiffness_per_unit_weight`], γ ≤ 0 or μ is not in 0 to 2.
    pub fn new(friction_angle: f64, unit_weight: f64, friction: f64) -> ModelResult<Self> {
        let stiffness =
            stiffness_per_unit_weight(friction_angle)? * positive("unit weight [N/m^3]", unit_weight)?;
        Ok(Self { stiffness, friction: within("surface friction", friction, 0.0, 2.0)? })
    }

    /// Generic (dimensionless) traction α for a unit normal and a unit direction of motion.
    #[must_use]
    pub fn generic(normal: [f64; 3], direction: [f64; 3]) -> [f64; 3] {
        let down = if normal[2] < 0.0 { normal } else { normal.map(|x| -x) };
        let f = response_functions(-direction[2], -down[2], dot(down, direction));
        let mut alpha = [0.0; 3];
        for i in 0..3 {
            alpha[i] = f[0] * down[i] + f[1] * direction[i];
        }
        alpha[2] -= f[2];
        alpha
    }
}

impl Traction for SpatialLaw {
    fn traction(&self, depth: f64, normal: [f64; 3], direction: [f64; 3]) -> [f64; 3] {
        if depth <= 0.0 || dot(normal, direction) < 0.0 {
            return [0.0; 3];
        }
        let alpha = Self::generic(normal, direction);
        let along = dot(alpha, normal);
        let tangent = [0, 1, 2].map(|i| alpha[i] - along * normal[i]);
        let size = dot(tangent, tangent).sqrt();
        // The normal traction is compressive, and friction opposes the motion.
        let pressure = along.abs();
        let sense = if dot(tangent, direction) > 0.0 { -1.0 } else { 1.0 };
        let scale = if size > 0.0 { sense * (self.friction * pressure / size).min(1.0) } else { 0.0 };
        [0, 1, 2].map(|i| self.stiffness * depth * (scale * tangent[i] - pressure * normal[i]))
    }
}

/// f₁, f₂, f₃ of x₁, x₂, x₃.
fn response_functions(x: f64, y: f64, z: f64) -> [f64; 3] {
    let terms = [
        1.0,
        x,
        y,
        z,
        x * x,
        y * y,
        z * z,
        x * y,
        y * z,
        z * x,
        x * x * x,
        y * y * y,
        z * z * z,
        x * y * y,
        y * x * x,
        y * z * z,
        z * y * y,
        z * x * x,
        x * z * z,
        x * y * z,
    ];
    COEFFICIENTS.map(|row| row.iter().zip(&terms).map(|(c, t)| c * t).sum())
}
