//! A towed disc in resistive force theory.

use super::{Load, Motion, Traction, load, rim_facets};
use crate::disc::{Disc, Drive, carries, first_depth};
use crate::error::{Answer, none, positive, within};
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
    /// Slip s = ωr/v − 1.
    pub slip: f64,
}

/// Forces at a sinkage [m] under a drive; a free, braked or driven disc finds the slip that balances its torque.
///
/// A braked disc that no slip holds is locked; a driven one that spins beyond s = 2 is refused.
///
/// # Errors
/// If the sinkage or the drive is out of range, or no slip balances the torque.
pub fn at_depth(law: &impl Traction, disc: &Disc, sinkage: f64, drive: Drive) -> Answer<Rolled> {
    drive.check()?;
    let z = within("sinkage [m]", sinkage, f64::MIN_POSITIVE, 0.95 * disc.diameter)?;
    let turned = |slip: f64| rolled(law, disc, z, slip);
    let wanted = match drive {
        Drive::Locked => return Ok(turned(-1.0)),
        Drive::Slip(slip) => return Ok(turned(slip)),
        Drive::Free => 0.0,
        Drive::Braked(torque) => torque,
        Drive::Driven(torque) => -torque,
    };
    // The soil turns a skidding disc forwards and holds a spinning one back: the torque falls as the slip grows.
    let surplus = |slip: f64| turned(slip).torque - wanted;
    if wanted > 0.0 && surplus(-1.0) <= 0.0 {
        return Ok(turned(-1.0));
    }
    match root(-1.0, 2.0, 1e-10, surplus) {
        Some(slip) => Ok(turned(slip)),
        None => none("the slip", "no slip between -1 and 2 balances the torque on the axle"),
    }
}

/// Sinkage and forces under a weight [N].
///
/// # Errors
/// If an input is out of range or no sinkage up to 0.9 d carries the weight.
pub fn under_weight(law: &impl Traction, disc: &Disc, weight: f64, drive: Drive) -> Answer<Rolled> {
    positive("weight [N]", weight)?;
    disc.check()?;
    drive.check()?;
    let vertical = |z: f64| at_depth(law, disc, z, drive).map_or(f64::NAN, |found| found.vertical);
    match first_depth(disc, weight, 1e-9, vertical) {
        Ok(sinkage) => {
            let found = at_depth(law, disc, sinkage, drive)?;
            carries(weight, found.vertical, 1e-4)?;
            Ok(found)
        }
        Err((most, _)) => {
            none("the equilibrium sinkage", format!("at most {most:.3} N are carried up to 0.9 d"))
        }
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
        spin: [0.0, (1.0 + slip) / radius, 0.0],
    };
    // The rear of the rim moves away from the soil whatever the slip. On the front the friction changes its sense where
    // the rim moves straight into the soil; with a piece across that point the forces would jump as the slip changes.
    let turn = (1.0 + slip).clamp(0.0, 1.0).acos().min(reach);
    let mut front = rim_facets(disc, 0.0, turn);
    front.extend(rim_facets(disc, turn, reach));
    let Load { force, torque } = load(law, &front, &motion);
    Rolled { drag: -force[0], vertical: force[2], torque: torque[1], sinkage, slip }
}
