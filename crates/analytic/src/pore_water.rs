//! Water in the pores of soil that dilates as it is sheared: whether it can follow, and the suction where it
//! cannot.

use crate::cutting::{Blade, SaturatedCut, SaturatedSand};
use crate::error::{ModelResult, positive, within};
use crate::forecast::{Forecast, Load, Towing, forecast};
use crate::soil::Soil;

/// Mean suction in the failing soil over γ_w v z ε/k. Of Miedema's form (1987); between 0.1 and 0.3 along the
/// shear plane and the face of a blade by his finite elements (recalled, not re-read). For round bodies an
/// order of magnitude.
const MEAN_SUCTION: f64 = 0.1;
/// Pressure at which water cavitates, below that of the atmosphere [Pa].
const ATMOSPHERE: f64 = 1e5;

/// The water in and over the soil.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoreWater {
    /// Unit weight γ_w [N/m³].
    pub unit_weight: f64,
    /// Depth of the water over the ground z_w [m].
    pub depth: f64,
    /// Permeability of the soil k [m/s].
    pub permeability: f64,
    /// Volume strain of the soil as it fails ε ≥ 0.
    pub volume_strain: f64,
}

/// A forecast with suction.
#[derive(Clone, Debug, PartialEq)]
pub struct Suction {
    /// Mean suction in the failing soil [Pa].
    pub pressure: f64,
    /// Whether the water cavitates, so that the suction is as large as it can be.
    pub cavitates: bool,
    /// The models with this suction.
    pub forecast: Forecast,
}

impl PoreWater {
    /// Largest suction [Pa], at which the water cavitates: 100 kPa + γ_w z_w.
    #[must_use]
    pub fn cavitation(&self) -> f64 {
        ATMOSPHERE + self.unit_weight * self.depth
    }

    /// Mean suction in the soil that fails down to a depth [m] at a speed [m/s], a number of times the usual
    /// one [Pa]: 0.1 γ_w v z ε/k, at most that at which the water cavitates.
    #[must_use]
    pub fn suction(&self, speed: f64, depth: f64, times: f64) -> f64 {
        let free = times * MEAN_SUCTION * self.unit_weight * speed * depth.max(0.0) * self.volume_strain
            / self.permeability;
        free.min(self.cavitation())
    }

    /// A blade of a height [m] that cuts the sand at a speed [m/s], with the suction a number of times that
    /// of the theory; the sand is as permeable where it has been sheared as where it has not.
    ///
    /// # Errors
    /// As [`SaturatedSand::cut`].
    pub fn cut(
        &self,
        soil: &Soil,
        blade: &Blade,
        height: f64,
        speed: f64,
        times: f64,
    ) -> ModelResult<SaturatedCut> {
        positive("permeability [m/s]", self.permeability)?;
        let pressure =
            times * self.unit_weight * speed * blade.depth * self.volume_strain / self.permeability;
        let cavitation = self.cavitation();
        SaturatedSand { height, pressure, cavitation, permeability_ratio: 1.0 }.cut(soil, blade)
    }

    /// The models with suction, at a speed [m/s], where it is a number of times the usual one.
    ///
    /// A uniform suction p_s raises the effective stress everywhere, as a cohesion p_s tan φ does (Caquot's
    /// correspondence). The depth of a body that sinks depends on the suction, and the suction on the depth;
    /// both are found by bisection.
    ///
    /// # Errors
    /// If speed or factor are negative, or no model has an answer.
    pub fn forecast(&self, towing: &Towing, speed: f64, times: f64) -> ModelResult<Suction> {
        /// Relative width of the interval of the depth at the end.
        const TOLERANCE: f64 = 1e-3;
        within("speed [m/s]", speed, 0.0, f64::MAX)?;
        positive("permeability [m/s]", self.permeability)?;
        let at = |depth: f64| -> ModelResult<Suction> {
            let pressure = self.suction(speed, depth, times);
            let mut towing = towing.clone();
            towing.soil.cohesion += pressure * towing.soil.friction_angle.tan();
            let cavitates = pressure >= self.cavitation();
            Ok(Suction { pressure, cavitates, forecast: forecast(&towing)? })
        };
        if let Load::Sinkage(depth) = towing.load {
            return at(depth);
        }
        let (mut low, mut high) = (0.0, sinkage(&forecast(towing)?).unwrap_or(0.0));
        while high - low > TOLERANCE * high {
            let middle = 0.5 * (low + high);
            if sinkage(&at(middle)?.forecast).is_none_or(|depth| depth < middle) {
                high = middle;
            } else {
                low = middle;
            }
        }
        at(high)
    }
}

/// Sinkage in the recommended model [m], or else in the first that applies.
fn sinkage(forecast: &Forecast) -> Option<f64> {
    let best = forecast.models.iter().find(|model| Some(model.model) == forecast.recommended);
    best.or_else(|| forecast.models.iter().find(|model| model.applicable))?.prediction?.sinkage
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::disc::{Disc, Drive};
    use crate::soil::Soil;

    /// The sandy sea bed of the design: φ = 35°, γ′ = 9.5 kN/m³, a disc of 150 N.
    fn disc(load: Load) -> Towing {
        let soil = Soil {
            friction_angle: 35_f64.to_radians(),
            dilation_angle: 35_f64.to_radians(),
            cohesion: 0.0,
            unit_weight: 9500.0,
            body_friction: 0.3,
            adhesion_factor: 1.0,
            strength_gradient: 0.0,
        };
        Towing::new(soil, Disc { diameter: 0.4, thickness: 0.075 }, load, Drive::Free)
    }

    fn water(permeability: f64) -> PoreWater {
        PoreWater { unit_weight: 1e4, depth: 5.0, permeability, volume_strain: 0.05 }
    }

    #[test]
    fn a_sinking_disc_sinks_less_the_less_the_water_can_follow() {
        let towing = disc(Load::Weight(150.0));
        let drained = sinkage(&forecast(&towing).unwrap()).unwrap();
        let mut last = 0.0;
        // The figures of docs/models/suction.md [mm].
        let documented = [0.50, 2.03, 6.86, 15.39, 23.30];
        for (permeability, expected) in [1e-5, 1e-4, 1e-3, 1e-2, 10.0].into_iter().zip(documented) {
            let found = water(permeability).forecast(&towing, 1.5, 1.0).unwrap();
            let depth = sinkage(&found.forecast).unwrap();
            assert!((1e3 * depth - expected).abs() < 0.01, "k = {permeability} m/s: {depth} m");
            assert!(depth > last && depth <= drained);
            // The suction is that at the depth that is found.
            assert!((found.pressure / water(permeability).suction(1.5, depth, 1.0) - 1.0).abs() < 0.01);
            last = depth;
        }
        assert!((last / drained - 1.0).abs() < 1e-3);
    }

    #[test]
    fn at_a_given_depth_the_force_grows_until_the_water_cavitates() {
        let towing = disc(Load::Sinkage(0.02));
        let drag = |speed: f64| {
            let found = water(1e-5).forecast(&towing, speed, 1.0).unwrap();
            let models = &found.forecast.models;
            (models.iter().find(|m| m.applicable).unwrap().prediction.unwrap().drag, found.cavitates)
        };
        let [slow, fast, faster, fastest] = [0.0, 1.0, 200.0, 400.0].map(drag);
        assert!(slow.0 < fast.0 && fast.0 < faster.0 && faster.0 == fastest.0);
        assert_eq!([slow.1, fast.1, faster.1, fastest.1], [false, false, true, true]);
    }
}
