//! Cones and piles at depth, and bodies that are pulled up, as bodies of the forecast.

use super::{Body, Candidate, Outline, Penetrometer, Plate, Towing};
use crate::bearing::{Footing, round_over_square, undrained_factor};
use crate::error::{ModelResult, undefined, within};
use crate::penetration::{Stiffness, conical_factor, deep_cone_factor, end_pressure, shaft_friction};
use crate::soil::Soil;
use crate::uplift::{pipe_uplift, plate_uplift, strip_uplift};
use std::f64::consts::{FRAC_PI_4, PI};

/// Diameter of a shaft over that of the cone from which the soil rubs on it (chosen).
const FULL_SHAFT: f64 = 0.95;
/// The sharpest cone that pushes a wedge of soil like a flat end [rad] (chosen: the wedge has half of 45° −
/// φ/2 to 45°).
const SHARPEST: f64 = 50.0 * PI / 180.0;

/// Force [N] on a cone or a pile at a sinkage [m], and the pressure on its end over its full section [Pa].
pub(super) fn pushed(towing: &Towing, z: f64) -> ModelResult<(f64, f64)> {
    let (section, end, shaft) = match &towing.body {
        Body::Cone(cone) => (
            FRAC_PI_4 * cone.diameter * cone.diameter,
            cone_force(towing, cone, z)?,
            Shaft::of_cone(cone, z).map(|shaft| shaft.friction(towing)).transpose()?,
        ),
        Body::Plate(plate) if plate.outline == Outline::Circle => {
            let top = (z - plate.height).max(0.0);
            let shaft = Shaft { diameter: plate.width, reach: [top, z], tip: 0.0 };
            (plate.area(), plate.area() * pile_pressure(towing, plate, z)?, Some(shaft.friction(towing)?))
        }
        _ => return undefined(Candidate::Penetration.name(), "it is for a cone or an upright cylinder"),
    };
    Ok((end + shaft.unwrap_or(0.0), end / section))
}

/// The elastic constants of the soil.
fn stiffness(towing: &Towing) -> ModelResult<Stiffness> {
    match towing.elastic_modulus {
        Some(young_modulus) => Ok(Stiffness { young_modulus, poisson_ratio: towing.poisson_ratio }),
        None => undefined(Candidate::Penetration.name(), "the stiffness of the soil is not given"),
    }
}

/// Force [N] on the cone itself. Where it is only partly in the ground it is a smaller cone.
fn cone_force(towing: &Towing, cone: &Penetrometer, z: f64) -> ModelResult<f64> {
    let immersed = z.min(cone.tip());
    let diameter = cone.diameter * immersed / cone.tip();
    let shoulder = z - immersed;
    // The mean depth of its surface, seen from above.
    let mean = shoulder + immersed / 3.0;
    let pressure = if towing.soil.is_undrained() {
        clay_pressure(towing, cone, diameter, [shoulder, mean])?
    } else {
        within("cone angle [rad]", cone.apex, SHARPEST, PI)?;
        end_pressure(&towing.soil, &stiffness(towing)?, towing.rest_pressure, mean)?
    };
    Ok(FRAC_PI_4 * diameter * diameter * pressure)
}

/// Pressure [Pa] on a cone in clay: the lesser of that of a shallow and of a deep one, and the weight of the
/// soil beside it.
fn clay_pressure(
    towing: &Towing,
    cone: &Penetrometer,
    diameter: f64,
    [shoulder, mean]: [f64; 2],
) -> ModelResult<f64> {
    let soil = &towing.soil;
    let roughness = soil.roughness_of_clay();
    let strength = soil.strength_at(shoulder);
    let growth = soil.strength_gradient * diameter / strength;
    let shallow = conical_factor(cone.apex, shoulder / diameter, growth, roughness)? * strength;
    let strength = soil.strength_at(mean);
    let rigidity = stiffness(towing)?.shear_modulus() / strength;
    let rest = 0.5 * soil.unit_weight * mean * (1.0 - towing.rest_pressure) / strength;
    let deep = deep_cone_factor(rigidity, rest, roughness)? * strength;
    Ok(shallow.min(deep) + soil.unit_weight * mean)
}

/// Pressure [Pa] on the flat end of a pile; in sand at most that of a footing, which fails up to the surface.
fn pile_pressure(towing: &Towing, plate: &Plate, z: f64) -> ModelResult<f64> {
    let soil = &towing.soil;
    let (width, length) = (plate.width, plate.width);
    if soil.is_undrained() {
        let factor = undrained_factor(&Footing { width, length, depth: z, load_inclination: 0.0 })?;
        let round = round_over_square(soil.roughness_of_clay());
        return Ok(factor * round * soil.strength_at(z) + soil.unit_weight * z);
    }
    let deep = end_pressure(soil, &stiffness(towing)?, towing.rest_pressure, z)?;
    let footing = Footing { width, length, depth: z, load_inclination: 0.0 };
    Ok(deep.min(crate::capacity::ultimate_pressure(soil, &footing, towing.method)?.at(z)))
}

/// A shaft in the ground.
struct Shaft {
    diameter: f64,
    /// Depths between which the soil rubs on it [m].
    reach: [f64; 2],
    /// Depth of the tip below its lower end [m].
    tip: f64,
}

impl Shaft {
    /// The shaft of a cone; `None` where it is so thin that the soil does not touch it.
    fn of_cone(cone: &Penetrometer, z: f64) -> Option<Self> {
        let top = (z - cone.surface.height).max(0.0);
        let reach = [top, z - cone.tip()];
        (cone.shaft >= FULL_SHAFT * cone.diameter && reach[1] > top).then_some(Self {
            diameter: cone.shaft,
            reach,
            tip: cone.tip(),
        })
    }

    /// Friction on the shaft [N]: in clay α s_u, in sand [`shaft_friction`].
    fn friction(&self, towing: &Towing) -> ModelResult<f64> {
        let Soil { body_friction, .. } = towing.soil;
        let [top, bottom] = self.reach;
        if towing.soil.is_undrained() {
            let mean = towing.soil.strength_at(0.5 * (top + bottom));
            return Ok(towing.soil.roughness_of_clay() * mean * PI * self.diameter * (bottom - top));
        }
        let stiffness = stiffness(towing)?;
        let end = |depth: f64| end_pressure(&towing.soil, &stiffness, towing.rest_pressure, depth + self.tip);
        shaft_friction(self.diameter, self.reach, towing.soil.interface_friction().min(body_friction), end)
    }
}

/// Force [N] with which the soil holds a buried body whose lowest point lies z [m] deep.
pub(super) fn held(towing: &Towing, z: f64) -> ModelResult<f64> {
    let soil = &towing.soil;
    if soil.cohesion > 0.0 && !soil.is_undrained() {
        return undefined(Candidate::Uplift.name(), "it is for cohesionless sand, or for undrained clay");
    }
    match &towing.body {
        Body::Pipe(pipe) => {
            let rest = (towing.rest_pressure, soil.roughness_of_clay());
            Ok(pipe.length * pipe_uplift(soil, pipe.diameter, z - 0.5 * pipe.diameter, rest)?)
        }
        Body::Plate(plate) => {
            let top = z - plate.height;
            if top <= 0.0 {
                return undefined("the uplift resistance", "the top of the body is not covered by soil");
            }
            match plate.outline {
                Outline::Strip => {
                    Ok(plate.length * strip_uplift(soil, plate.width, top, towing.rest_pressure)?)
                }
                outline => {
                    let sides = [plate.width.min(plate.length), plate.width.max(plate.length)];
                    plate_uplift(soil, sides, outline == Outline::Circle, top)
                }
            }
        }
        _ => undefined(
            Candidate::Uplift.name(),
            "it is for a pipe, a level plate or an upright cylinder; of another body the soil above it is not known",
        ),
    }
}
