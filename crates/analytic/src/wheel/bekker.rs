//! Bekker: the pressure–sinkage relation of a plate, applied to a wheel.

use crate::disc::Disc;
use crate::error::{ModelResult, finite, positive, within};

/// Plate constants of a terrain (Bekker's pressure–sinkage parameters).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PressureSinkage {
    /// Sinkage exponent n.
    pub exponent: f64,
    /// Cohesive modulus k_c [N/m^{n+1}].
    pub cohesive: f64,
    /// Frictional modulus k_φ [N/m^{n+2}].
    pub frictional: f64,
    /// Cohesion c [Pa].
    pub cohesion: f64,
    /// Friction angle φ [rad].
    pub friction_angle: f64,
    /// Shear deformation modulus K [m].
    pub shear_modulus: f64,
}

/// Resistance and sinkage of a towed wheel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RollingResistance {
    /// RollingResistance resistance R [N].
    pub resistance: f64,
    /// Sinkage z [m].
    pub sinkage: f64,
}

impl PressureSinkage {
    /// Checks the range of the constants.
    ///
    /// # Errors
    /// Unless 0.05 ≤ n ≤ 2.5, k_c ≥ 0, k_φ > 0, c ≥ 0, 0 ≤ φ ≤ 55° and K > 0.
    pub fn check(&self) -> ModelResult<()> {
        within("sinkage exponent", self.exponent, 0.05, 2.5)?;
        within("cohesive modulus", self.cohesive, 0.0, f64::MAX)?;
        positive("frictional modulus", self.frictional)?;
        within("cohesion [Pa]", self.cohesion, 0.0, f64::MAX)?;
        within("friction angle [rad]", self.friction_angle, 0.0, 55_f64.to_radians())?;
        positive("shear modulus [m]", self.shear_modulus)?;
        Ok(())
    }

    /// Pressure under a plate of width b [m] at sinkage z [m]: p = (k_c/b + k_φ) zⁿ [Pa]. Source: Bekker
    /// (1956).
    #[must_use]
    pub fn pressure(&self, width: f64, sinkage: f64) -> f64 {
        (self.cohesive / width + self.frictional) * sinkage.max(0.0).powf(self.exponent)
    }
}

/// Sinkage and motion resistance of a towed rigid wheel.
///
/// z = [3W / ((3−n)(k_c + b k_φ) √d)]^{2/(2n+1)}, R = b (k_c/b + k_φ) z^{n+1}/(n+1).
/// Source: Bekker (1956, 1969), as in Wong, Theory of Ground Vehicles (recalled, not re-read). Wong advises
/// d > 0.5 m and z ≪ d. For z > d/2, where the parabola no longer approximates the rim, there is no result.
/// `weight` in N.
///
/// # Errors
/// If an input is out of range, or the wheel would sink deeper than half its diameter.
pub fn bekker_towed(soil: &PressureSinkage, disc: &Disc, weight: f64) -> ModelResult<RollingResistance> {
    soil.check()?;
    disc.check()?;
    let w = positive("weight [N]", weight)?;
    let (n, modulus) = (soil.exponent, soil.cohesive + disc.thickness * soil.frictional);
    let sinkage = (3.0 * w / ((3.0 - n) * modulus * disc.diameter.sqrt())).powf(2.0 / (2.0 * n + 1.0));
    within("Bekker's sinkage [m]", sinkage, 0.0, 0.5 * disc.diameter)?;
    let resistance = modulus * sinkage.powf(n + 1.0) / (n + 1.0);
    Ok(RollingResistance { resistance: finite("the rolling resistance", resistance)?, sinkage })
}

/// Bekker's wheel at a given sinkage z [m]: the resistance, and the weight carried, W = (3−n)/3 (k_c + b k_φ)
/// √d z^{n+½} [N].
///
/// # Errors
/// If an input is out of range.
pub fn bekker_at_depth(
    soil: &PressureSinkage,
    disc: &Disc,
    sinkage: f64,
) -> ModelResult<(RollingResistance, f64)> {
    soil.check()?;
    disc.check()?;
    let z = within("Bekker's sinkage [m]", sinkage, 0.0, 0.5 * disc.diameter)?;
    let (n, modulus) = (soil.exponent, soil.cohesive + disc.thickness * soil.frictional);
    let resistance = finite("the rolling resistance", modulus * z.powf(n + 1.0) / (n + 1.0))?;
    let weight = finite("the weight", (3.0 - n) / 3.0 * modulus * disc.diameter.sqrt() * z.powf(n + 0.5))?;
    Ok((RollingResistance { resistance, sinkage: z }, weight))
}

/// Shear stress at the shear displacement j [m] under the normal pressure σ [Pa]: (c + σ tan φ)(1 −
/// e^{−|j|/K}) [Pa].
///
/// Source: Janosi & Hanamoto (1961). For soil without a peak strength.
#[must_use]
pub fn janosi_shear(soil: &PressureSinkage, normal: f64, displacement: f64) -> f64 {
    let strength = soil.cohesion + normal * soil.friction_angle.tan();
    -strength * (-displacement.abs() / soil.shear_modulus).exp_m1()
}
