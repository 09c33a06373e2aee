//! A blade that cuts saturated sand: Miedema's equilibrium of the cut layer under the suction on shear plane
//! and blade.

use super::{Blade, CuttingForce, MeanSuction, Seepage, wall_friction};
use crate::error::{ModelResult, undefined, within};
use crate::soil::Soil;
use numerics::search::minimum;
use std::f64::consts::PI;

/// Length of the cut surface behind the tip through which no water flows, over the thickness of the layer. Of
/// a worn tip; the book varies 0, 0.1 and 0.2 (recalled). With 0.1 its table of c₁ is met, with 0 the forces
/// are 7 to 9 % smaller.
const WORN_TIP: f64 = 0.1;
/// Blade angles in the range of the theory [rad]: those of its tables. Before steeper blades a wedge of sand
/// forms.
const BLADE_ANGLES: [f64; 2] = [15.0 * PI / 180.0, 60.0 * PI / 180.0];
/// Shear angles among which the smallest force is looked for [rad], and what the layer keeps of a straight
/// angle (chosen).
const SHEAR_ANGLES: [f64; 2] = [5.0 * PI / 180.0, 80.0 * PI / 180.0];
const LEFT: f64 = 1.0 * PI / 180.0;
/// Steps of the search for the shear angle: to 0.1°, where the force is flat.
const STEPS: usize = 14;

/// Force on a blade with the mechanism that gives it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SaturatedCut {
    /// Force of the soil on the blade, and how far ahead the shear plane reaches the surface.
    pub force: CuttingForce,
    /// Shear angle β [rad], at which the drag is smallest.
    pub shear_angle: f64,
    /// Mean suction on the shear plane [Pa].
    pub shear_suction: f64,
    /// Mean suction on the blade [Pa].
    pub blade_suction: f64,
    /// Whether the water cavitates on both surfaces, so that the force is as large as it can be.
    pub cavitates: bool,
}

/// Sand under water before a blade, and the pressures by which its suction is counted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SaturatedSand {
    /// Height of the blade h_b [m], at least its depth h_i.
    pub height: f64,
    /// Unit of the suction ρ_w g v ε h_i/k_max [Pa].
    pub pressure: f64,
    /// Suction at which water cavitates [Pa].
    pub cavitation: f64,
    /// Permeability of the undisturbed sand over that of the cut layer k_i/k_max.
    pub permeability_ratio: f64,
}

impl SaturatedSand {
    /// Force on a blade that cuts a layer as thick as it is deep.
    ///
    /// With W₁ and W₂, suction times area of shear plane and blade, and G, the weight of the layer on the
    /// blade: K₂ = [W₁ sin φ + W₂ sin(α+β+φ) + G sin(β+φ)]/sin(α+β+δ+φ), F_H = K₂ sin(α+δ) − W₂ sin α, F_V =
    /// W₂ cos α − K₂ cos(α+δ), β that of the smallest F_H. The mean suction on either face is at most that of
    /// cavitation. Source: Miedema (1987, 2019), The Delft Sand, Clay & Rock Cutting Model, ch. 6
    /// (re-derived). Inertia, cohesion and the sides of a narrow blade are left out. Valid for 15° ≤ α ≤ 60°,
    /// 1 ≤ h_b/h_i ≤ 10, no surcharge.
    ///
    /// # Errors
    /// If soil or blade are out of range, or no layer slides.
    pub fn cut(&self, soil: &Soil, blade: &Blade) -> ModelResult<SaturatedCut> {
        soil.check()?;
        blade.check()?;
        within("blade angle [rad]", blade.rake, BLADE_ANGLES[0], BLADE_ANGLES[1])?;
        within("height of the blade [m]", self.height, blade.depth, 10.0 * blade.depth)?;
        within("unit of the suction [Pa]", self.pressure, 0.0, f64::MAX)?;
        within("suction at which water cavitates [Pa]", self.cavitation, f64::MIN_POSITIVE, f64::MAX)?;
        within("surcharge [Pa]", blade.surcharge, 0.0, 0.0)?;
        within("cohesion [Pa]", soil.cohesion, 0.0, 0.0)?;
        let (phi, delta) = (soil.friction_angle, wall_friction(soil));
        let highest = (PI - blade.rake - phi - delta - LEFT).min(SHEAR_ANGLES[1]);
        if highest <= SHEAR_ANGLES[0] {
            return undefined("the cut layer", "blade angle and friction leave no layer that slides");
        }
        let drag = |angle: f64| {
            let found = self.suction(blade, angle);
            found.map_or(f64::INFINITY, |found| self.equilibrium(soil, blade, angle, found).drag)
        };
        let (shear_angle, _) = minimum(SHEAR_ANGLES[0], highest, STEPS, drag);
        let found = self.suction(blade, shear_angle)?;
        Ok(SaturatedCut {
            force: self.equilibrium(soil, blade, shear_angle, found),
            shear_angle,
            shear_suction: found.shear_plane,
            blade_suction: found.blade,
            cavitates: found.shear_plane.min(found.blade) >= self.cavitation,
        })
    }

    /// Mean suction [Pa] at a shear angle [rad], on each of the two faces at most that at which the water
    /// cavitates.
    fn suction(&self, blade: &Blade, shear_angle: f64) -> ModelResult<MeanSuction> {
        let mean = self.seepage(blade, shear_angle).mean_suction()?;
        let [shear_plane, blade] =
            [mean.shear_plane, mean.blade].map(|mean| (mean * self.pressure).min(self.cavitation));
        Ok(MeanSuction { shear_plane, blade })
    }

    fn seepage(&self, blade: &Blade, shear_angle: f64) -> Seepage {
        Seepage {
            blade_angle: blade.rake,
            shear_angle,
            height_ratio: (self.height / blade.depth).max(1.0),
            permeability_ratio: self.permeability_ratio,
            closed_tip: WORN_TIP,
        }
    }

    /// Equilibrium of the layer at a shear angle [rad] under a suction [Pa].
    fn equilibrium(&self, soil: &Soil, blade: &Blade, shear: f64, suction: MeanSuction) -> CuttingForce {
        let (phi, delta, alpha) = (soil.friction_angle, wall_friction(soil), blade.rake);
        let lengths = [blade.depth / shear.sin(), self.height / alpha.sin()];
        let [w_shear, w_blade] =
            [suction.shear_plane * lengths[0], suction.blade * lengths[1]].map(|force| force * blade.width);
        let weight = soil.unit_weight * lengths[0] * lengths[1] * (alpha + shear).sin() * blade.width;
        let grains =
            (w_shear * phi.sin() + w_blade * (alpha + shear + phi).sin() + weight * (shear + phi).sin())
                / (alpha + shear + delta + phi).sin();
        CuttingForce {
            drag: grains * (alpha + delta).sin() - w_blade * alpha.sin(),
            vertical: w_blade * alpha.cos() - grains * (alpha + delta).cos(),
            reach: blade.depth / shear.tan(),
        }
    }
}
