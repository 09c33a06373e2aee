//! The ultimate pressure under a footing, of sand and of undrained clay.

use crate::bearing::{
    Footing, Method, cohesion_factor, corrections, surcharge_factor, undrained_pressure,
    weight_factor_hansen, weight_factor_lyamin, weight_factor_meyerhof,
};
use crate::error::ModelResult;
use crate::soil::Soil;

/// Ultimate pressure under a footing as a function of the depth below the ground at its sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UltimatePressure {
    /// The terms of the soil's weight under the footing and of its cohesion [Pa].
    pub base: f64,
    /// The term of the overburden, over the depth [Pa/m].
    pub by_depth: f64,
}

impl UltimatePressure {
    /// The pressure [Pa] at a depth [m].
    #[must_use]
    pub fn at(&self, depth: f64) -> f64 {
        self.base + self.by_depth * depth
    }
}

/// q = ½ γ B N_γ* + c N_c* + γ D N_q* [Pa], N* = N s d i; of undrained clay (φ = 0) q = s_u N_c s_c d_c i_c +
/// γ D.
///
/// Of the footing the depth enters the depth factors only. Rough base. Sources: [`corrections`],
/// [`undrained_pressure`].
///
/// # Errors
/// If the soil or the footing is out of the range of the factors.
pub fn ultimate_pressure(soil: &Soil, footing: &Footing, method: Method) -> ModelResult<UltimatePressure> {
    if soil.is_undrained() {
        let base = undrained_pressure(soil.cohesion, footing)?;
        return Ok(UltimatePressure { base, by_depth: soil.unit_weight });
    }
    let phi = soil.friction_angle;
    let factor = corrections(method, phi, footing)?;
    let n_gamma = match method {
        Method::Meyerhof => weight_factor_meyerhof(phi)?,
        Method::HansenVesic => weight_factor_hansen(phi)?,
        Method::Lyamin => weight_factor_lyamin(phi)?,
    };
    let base = 0.5 * soil.unit_weight * footing.width * n_gamma * factor.weight
        + soil.cohesion * cohesion_factor(phi)? * factor.cohesion;
    Ok(UltimatePressure { base, by_depth: soil.unit_weight * surcharge_factor(phi)? * factor.surcharge })
}
