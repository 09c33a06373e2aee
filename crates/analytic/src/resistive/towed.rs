//! A towed disc in resistive force theory.

use super::{Facet, Load, Motion, Traction, load, rim_facets};
use crate::disc::{Disc, Drive, MOST_SLIP, carries, first_depth};
use crate::error::{Answer, none, positive, within};
use crate::motion::turn_ratio;
use crate::numeric::root;

/// A towed disc in steady motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rolled {
    /// Drag [N].
    pub drag: f64,
    /// Vertical force [N].
    pub vertical: f64,
    /// Torque of the soil about the axle [N m]; positive when it turns the disc forwards.
    pub torque: f64,
    /// Sinkage [m].
    pub sinkage: f64,
    /// Its [`crate::slip`].
    pub slip: f64,
}

/// Forces at a sinkage [m] under a drive; a free, braked or driven disc finds the slip that balances its torque.
///
/// A braked disc that no slip holds is locked; a driven one that spins more than three times as fast as it rolls is refused.
///
/// # Errors
/// If the sinkage or the drive is out of range, or no slip balances the torque.
pub fn at_depth(law: &impl Traction, disc: &Disc, sinkage: f64, drive: Drive) -> Answer<Rolled> {
    drive.check()?;
    let z = within("sinkage [m]", sinkage, f64::MIN_POSITIVE, 0.95 * disc.diameter)?;
    balanced(drive, |slip| rolled(law, disc, z, slip))
}

/// The motion, among those at every slip, whose torque the drive balances.
fn balanced(drive: Drive, turned: impl Fn(f64) -> Rolled) -> Answer<Rolled> {
    let wanted = match drive {
        Drive::Locked => return Ok(turned(-1.0)),
        Drive::Slip(slip) => return Ok(turned(slip)),
        Drive::Free => 0.0,
        Drive::Braked(torque) => torque,
        Drive::Driven(torque) => -torque,
    };
    // The soil turns a sliding disc forwards and holds a spinning one back: the torque falls as the slip grows.
    let surplus = |slip: f64| turned(slip).torque - wanted;
    if wanted > 0.0 && surplus(-1.0) <= 0.0 {
        return Ok(turned(-1.0));
    }
    match root(-1.0, MOST_SLIP, 1e-10, surplus) {
        Some(slip) => Ok(turned(slip)),
        None => none("the slip", "no slip between -1 and 2/3 balances the torque on the axle"),
    }
}

/// Forces on a body of any shape, centred on its origin, whose lowest point is at a sinkage [m]; with a drive other than
/// locked it turns about y, and slip and torque refer to the radius ½ `height` [m].
///
/// # Errors
/// If the sinkage or the drive is out of range, or no slip balances the torque.
pub fn body_at_depth(
    law: &impl Traction,
    facets: &[Facet],
    height: f64,
    sinkage: f64,
    drive: Drive,
) -> Answer<Rolled> {
    drive.check()?;
    let z = within("sinkage [m]", sinkage, f64::MIN_POSITIVE, height)?;
    let radius = 0.5 * height;
    balanced(drive, |slip| {
        let spin = [0.0, turn_ratio(slip) / radius, 0.0];
        let motion = Motion { height: radius - z, velocity: [1.0, 0.0, 0.0], spin };
        let Load { force, torque } = load(law, facets, &motion);
        Rolled { drag: -force[0], vertical: force[2], torque: torque[1], sinkage: z, slip }
    })
}

/// Sinkage and forces under a weight [N].
///
/// # Errors
/// If an input is out of range or no sinkage up to 0.9 d carries the weight.
pub fn under_weight(law: &impl Traction, disc: &Disc, weight: f64, drive: Drive) -> Answer<Rolled> {
    disc.check()?;
    drive.check()?;
    carried(disc.diameter, weight, |z| at_depth(law, disc, z, drive))
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
) -> Answer<Rolled> {
    drive.check()?;
    carried(positive("height of the body [m]", height)?, weight, |z| {
        body_at_depth(law, facets, height, z, drive)
    })
}

/// The least sinkage at which `at` carries the weight [N], for a body of the height [m].
fn carried(height: f64, weight: f64, at: impl Fn(f64) -> Answer<Rolled>) -> Answer<Rolled> {
    positive("weight [N]", weight)?;
    match first_depth(height, weight, 1e-9, |z| at(z).map_or(f64::NAN, |found| found.vertical)) {
        Ok(sinkage) => {
            let found = at(sinkage)?;
            carries(weight, found.vertical, 1e-4)?;
            Ok(found)
        }
        Err((most, _)) => none(
            "the equilibrium sinkage",
            format!("at most {:.3} N are carried down to 0.9 of the height", most.max(0.0)),
        ),
    }
}

/// Forces at a sinkage [m] and a slip.
fn rolled(law: &impl Traction, disc: &Disc, sinkage: f64, slip: f64) -> Rolled {
    let radius = 0.5 * disc.diameter;
    let reach = 2.0 * (sinkage / disc.diameter).sqrt().asin();
    // Rolling forwards turns about +y: the bottom moves backwards.
    let motion = Motion {
        height: radius - sinkage,
        velocity: [1.0, 0.0, 0.0],
        spin: [0.0, turn_ratio(slip) / radius, 0.0],
    };
    // The rear of the rim moves away from the soil whatever the slip. On the front the friction changes its sense where
    // the rim moves straight into the soil; with a piece across that point the forces would jump as the slip changes.
    let turn = turn_ratio(slip).clamp(0.0, 1.0).acos().min(reach);
    let mut front = rim_facets(disc, 0.0, turn);
    front.extend(rim_facets(disc, turn, reach));
    let Load { force, torque } = load(law, &front, &motion);
    Rolled { drag: -force[0], vertical: force[2], torque: torque[1], sinkage, slip }
}
