//! Steady tow of a disc or any body in resistive force theory.

use super::{Facet, Motion, Traction, Wrench, dot, rim_facets, wrench};
use crate::disc::{Disc, Drive, check_weight_carried, equilibrium_depth};
use crate::error::{ModelResult, positive, undefined, within};
use numerics::search::root;

/// Slip up to which a body that nothing drives is looked for (chosen): one that is towed along its axle
/// balances its torque at any slip, and at 1 it would stand still.
const FREE: f64 = 0.75;

/// The axle of a body, through its origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axle {
    /// Unit vector along the axle, to the left of a body that rolls forward.
    pub direction: [f64; 3],
    /// Radius on which the body rolls [m].
    pub radius: f64,
}

impl Axle {
    /// An axle across the tow, of a body that rolls on a radius [m].
    #[must_use]
    pub fn across(radius: f64) -> Self {
        Self { direction: [0.0, 1.0, 0.0], radius }
    }

    /// Component along the tow of the level unit vector across the axle, in which the body rolls; 0 for a
    /// vertical axle.
    fn rolls_along(&self) -> f64 {
        let [x, y, _] = self.direction;
        let level = x.hypot(y);
        if level > 0.0 { y / level } else { 0.0 }
    }
}

/// A body of any shape by its facets.
#[derive(Clone, Copy, Debug)]
pub struct Faceted<'a> {
    /// Facets of the surface of the body.
    pub facets: &'a [Facet],
    /// Height of the body [m].
    pub height: f64,
    /// Depth of the lowest point of the body below its origin [m].
    pub below: f64,
    /// Axle of the body.
    pub axle: Axle,
}

/// Forces on a body in steady tow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SteadyTow {
    /// Drag [N].
    pub drag: f64,
    /// Vertical force [N].
    pub vertical: f64,
    /// Lateral force [N], positive along y.
    pub lateral: f64,
    /// Moments of the soil about x, y, z through the centre [N m].
    pub moment: [f64; 3],
    /// Torque of the soil about the axle [N m]; positive when it rotates the body forwards.
    pub torque: f64,
    /// Sinkage [m].
    pub sinkage: f64,
    /// The [`crate::slip`].
    pub slip: f64,
}

/// Forces on a disc at a sinkage [m]; the slip of a free, braked or driven disc is that which balances its
/// torque.
///
/// A braked disc is locked where no slip balances the brake.
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
    let most = if required < 0.0 { 1.0 } else { FREE };
    match root(-1.0, most, 1e-10, surplus) {
        Some(slip) => Ok(at(slip)),
        None => {
            undefined("the slip", format!("no slip between -1 and {most} balances the torque on the axle"))
        }
    }
}

/// Forces on a body of any shape at a sinkage [m] of its lowest point.
///
/// Unless it is locked it rotates about its axle; the slip refers to its velocity across the axle.
///
/// # Errors
/// If the sinkage or the drive is out of range, or no slip balances the torque.
pub fn body_at_depth(
    law: &impl Traction,
    body: &Faceted,
    sinkage: f64,
    drive: Drive,
) -> ModelResult<SteadyTow> {
    drive.check()?;
    let z = within("sinkage [m]", sinkage, f64::MIN_POSITIVE, body.height)?;
    let Axle { direction, radius } = body.axle;
    let rolling_speed = body.axle.rolls_along();
    balanced(drive, |slip| {
        let [speed, rim] = speeds(slip);
        let motion = Motion {
            height: body.below - z,
            velocity: [speed, 0.0, 0.0],
            spin: direction.map(|component| rim * rolling_speed / radius * component),
        };
        tow(&wrench(law, body.facets, &motion), &direction, z, slip)
    })
}

/// Speeds of the axle and of the rim about it, of which only the ratio matters: the larger one is 1, so that
/// it is finite up to spinning on the spot.
fn speeds(slip: f64) -> [f64; 2] {
    if slip > 0.0 { [1.0 - slip, 1.0] } else { [1.0, 1.0 + slip] }
}

/// The steady tow with these forces.
fn tow(wrench: &Wrench, axle: &[f64; 3], sinkage: f64, slip: f64) -> SteadyTow {
    let Wrench { force, torque } = *wrench;
    SteadyTow {
        drag: -force[0],
        vertical: force[2],
        lateral: force[1],
        moment: torque,
        torque: dot(torque, *axle),
        sinkage,
        slip,
    }
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
    body: &Faceted,
    weight: f64,
    drive: Drive,
) -> ModelResult<SteadyTow> {
    drive.check()?;
    at_equilibrium(positive("height of the body [m]", body.height)?, weight, |z| {
        body_at_depth(law, body, z, drive)
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
    let [speed, rim] = speeds(slip);
    let motion =
        Motion { height: radius - sinkage, velocity: [speed, 0.0, 0.0], spin: [0.0, rim / radius, 0.0] };
    // The rear of the rim moves away from the soil at any slip. On the front the friction changes sign where
    // the rim moves normal to itself; a facet across that point would make the forces discontinuous in the
    // slip.
    let transition = rim.acos().min(contact_angle);
    let mut front = rim_facets(disc, 0.0, transition);
    front.extend(rim_facets(disc, transition, contact_angle));
    tow(&wrench(law, &front, &motion), &Axle::across(radius).direction, sinkage, slip)
}
