//! Tow force of a plough under water, in the form of Palmer and of Cathie and Wintgens.

use crate::error::{ModelResult, non_negative, positive};

/// Coefficients of a plough in a soil. None is built in: those of the literature could not be read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PloughCoefficients {
    /// Friction under the plough C_w, over its weight in water.
    pub weight: f64,
    /// Slow resistance of the soil C_s, over γ′ D³.
    pub slow: f64,
    /// Resistance that grows with the speed C_d, over v D² [N s/m³].
    pub rate: f64,
}

/// Tow force of a plough [N] and its parts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PloughForce {
    /// Friction under the plough C_w W′ [N].
    pub friction: f64,
    /// Slow resistance C_s γ′ D³ [N].
    pub slow: f64,
    /// Resistance that grows with the speed C_d v D² [N].
    pub rate: f64,
}

impl PloughForce {
    /// The whole tow force [N].
    #[must_use]
    pub fn total(&self) -> f64 {
        self.friction + self.slow + self.rate
    }
}

impl PloughCoefficients {
    /// Tow force F = C_w W′ + C_s γ′ D³ + C_d v D² of a plough of the weight W′ [N] in water, at the depth
    /// D [m] and speed v [m/s], in soil of the submerged unit weight γ′ [N/m³].
    ///
    /// Source: Palmer (1999), Géotechnique 49(3), 285–294; Cathie & Wintgens (2001), OTC 13145; Lauder et al.
    /// (2012), Can. Geotech. J. 49(11), 1244–1255 (the form is recalled, high confidence; of the last the
    /// abstract was read). C_d holds up to the speed at which the water cavitates.
    ///
    /// # Errors
    /// If a coefficient, weight, depth or speed is negative, or the unit weight is not positive.
    pub fn tow_force(
        &self,
        weight: f64,
        unit_weight: f64,
        depth: f64,
        speed: f64,
    ) -> ModelResult<PloughForce> {
        let [by_weight, slow, rate] = [self.weight, self.slow, self.rate];
        non_negative("plough coefficient C_w", by_weight)?;
        non_negative("plough coefficient C_s", slow)?;
        non_negative("plough coefficient C_d [N s/m³]", rate)?;
        non_negative("weight in water [N]", weight)?;
        non_negative("depth [m]", depth)?;
        non_negative("speed [m/s]", speed)?;
        positive("submerged unit weight [N/m³]", unit_weight)?;
        Ok(PloughForce {
            friction: by_weight * weight,
            slow: slow * unit_weight * depth.powi(3),
            rate: rate * speed * depth * depth,
        })
    }
}
