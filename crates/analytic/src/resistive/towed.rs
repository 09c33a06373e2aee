//! Steady tow of a disc or any body in resistive force theory.

use super::{Facet, Motion, Traction, Wrench, rim_facets, wrench};
use crate::disc::{Disc, Drive, MAX_SLIP, check_weight_carried, equilibrium_depth};
use crate::error::{ModelResult, positive, undefined, within};
use crate::motion::turn_ratio;
use crate::numeric::root;

/// Forces on a body in steady tow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SteadyTow {
    /// Drag [N].
    pub drag: f64,
    /// Vertical force [N].
    pub vertical: f64,
    /// Torque of the soil about the axle [N m]; positive when it rotates the body forwards.
    pub torque: f64,
    /// Sinkage [m].
    pub sinkage: f64,
    /// The [`crate::slip`].
    pub slip: f64,
}

/// Forces on a disc at a sinkage [m]; the slip of a free, braked or driven disc is that which balances its torque.
///
/// A braked disc is locked where no slip balances the brake; a driven one must not exceed the turn ratio 4.
///
/// # Errors
/// If the sinkage or the drive is out of range, or no slip balances the torque.
pub fn at_depth(law: &impl Traction, disc: &Disc, sinkage: f64, drive: Drive) -> ModelResult<SteadyTow> {
    drive.check()?;
    let z = within("sinkage [m]", sinkage, f64::MIN_POSITIVE, 0.95 * disc.diameter)?;
    balanced(drive, |slip| disc_at_slip(law, disc, z, slip))
}

/// The steady tow at the slip where the torque balances that of the drive; `at` gives the forces at a slip.
fn balanced(drive: Drive, at: impl Fn(f64) -> SteadyTow) -> ModelResult<SteadyTow> {
    let required = match drive {
        Drive::Locked => return Ok(at(-1.0)),
        Drive::Slip(slip) => return Ok(at(slip)),
        Drive::Free => 0.0,
        Drive::Braked(torque) => torque,
        Drive::Driven(torque) => -torque,
    };
    // The soil drives a sliding disc forwards and brakes a spinning one: the torque decreases with the slip.
    let surplus = |slip: f64| at(slip).torque - required;
    if required > 0.0 && surplus(-1.0) <= 0.0 {
        return Ok(at(-1.0));
    }
    match root(-1.0, MAX_SLIP, 1e-10, surplus) {
        Some(slip) => Ok(at(slip)),
        None => undefined("the slip", "no slip between -1 and 0.75 balances the torque on the axle"),
    }
}

/// Forces on a body of any shape, centred on its origin, at a sinkage [m] of its lowest point.
///
/// Unless it is locked it rotates about y; slip and torque then refer to the radius ½ `height` [m].
///
/// # Errors
/// If the sinkage or the drive is out of range, or no slip balances the torque.
pub fn body_at_depth(
    law: &impl Traction,
    facets: &[Facet],
    height: f64,
    sinkage: f64,
    drive: Drive,
) -> ModelResult<SteadyTow> {
    drive.check()?;
    let z = within("sinkage [m]", sinkage, f64::MIN_POSITIVE, height)?;
    let radius = 0.5 * height;
    balanced(drive, |slip| {
        let spin = [0.0, turn_ratio(slip) / radius, 0.0];
        let motion = Motion { height: radius - z, velocity: [1.0, 0.0, 0.0], spin };
        let Wrench { force, torque } = wrench(law, facets, &motion);
        SteadyTow { drag: -force[0], vertical: force[2], torque: torque[1], sinkage: z, slip }
    })
}

/// Sinkage and forces of a disc under a weight [N].
///
/// # Errors
/// If an input is out of range or no sinkage up to 0.9 d carries the weight.
pub fn under_weight(law: &impl Traction, disc: &Disc, weight: f64, drive: Drive) -> ModelResult<SteadyTow> {
    disc.check()?;
    drive.check()?;
    at_equilibrium(disc.diameter, weight, |z| at_depth(law, disc, z, drive))
}

/// Sinkage and forces of a body of any shape under a weight [N]; arguments as for [`body_at_depth`].
///
/// # Errors
/// If an input is out of range or no sinkage up to 0.9 of its height carries the weight.
pub fn body_under_weight(
    law: &impl Traction,
    facets: &[Facet],
    height: f64,
    weight: f64,
    drive: Drive,
) -> ModelResult<SteadyTow> {
    drive.check()?;
    at_equilibrium(positive("height of the body [m]", height)?, weight, |z| {
        body_at_depth(law, facets, height, z, drive)
    })
}

/// The least sinkage at which `at` carries the weight [N], for a body of the height [m].
fn at_equilibrium(
    height: f64,
    weight: f64,
    at: impl Fn(f64) -> ModelResult<SteadyTow>,
) -> ModelResult<SteadyTow> {
    positive("weight [N]", weight)?;
    match equilibrium_depth(height, weight, 1e-9, |z| at(z).map_or(f64::NAN, |found| found.vertical)) {
        Ok(sinkage) => {
            let found = at(sinkage)?;
            check_weight_carried(weight, found.vertical, 1e-4)?;
            Ok(found)
        }
        Err((most, _)) => undefined(
            "the equilibrium sinkage",
            format!("the soil carries at most {:.3} N down to 0.9 of the height", most.max(0.0)),
        ),
    }
}

/// Forces on a disc at a sinkage [m] and a slip.
fn disc_at_slip(law: &impl Traction, disc: &Disc, sinkage: f64, slip: f64) -> SteadyTow {
    let radius = 0.5 * disc.diameter;
    let contact_angle = 2.0 * (sinkage / disc.diameter).sqrt().asin();
    // Forward rolling is a rotation about +y: the bottom moves backwards.
    let motion = Motion {
        height: radius - sinkage,
        velocity: [1.0, 0.0, 0.0],
        spin: [0.0, turn_ratio(slip) / radius, 0.0],
    };
    // The rear of the rim moves away from the soil at any slip. On the front the friction changes sign where the rim moves
    // normal to itself; a facet across that point would make the forces discontinuous in the slip.
    let transition = turn_ratio(slip).clamp(0.0, 1.0).acos().min(contact_angle);
    let mut front = rim_facets(disc, 0.0, transition);
    front.extend(rim_facets(disc, transition, contact_angle));
    let Wrench { force, torque } = wrench(law, &front, &motion);
    SteadyTow { drag: -force[0], vertical: force[2], torque: torque[1], sinkage, slip }
}
