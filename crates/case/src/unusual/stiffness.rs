//! Soil that its own weight would flatten, or that is stiffer than any soil under so little stress.

use super::values::is_soil;
use crate::own_weight::{compression, depth};
use crate::path::body_length;
use crate::resolved::Case;
use input::quantity::{plain, short};

/// Mean strain of soil under its own weight beyond which it is doubted (chosen): loose sand and soft clay are
/// compressed by 1 to 2 %.
const SOFT: f64 = 0.05;
/// Young's modulus over the stress that the soil bears beyond which it is doubted (chosen): that of dense
/// sand at small strains and a stress of 1 kPa is some 30 000 times as large (Hardin and Richart 1963), and
/// footings in exact tests have 100 000.
const STIFF: f64 = 2e5;
/// Young's modulus over the strength below which cohesive soil is doubted; the softest clays have 50 to 100.
const SOFT_OF_STRENGTH: f64 = 20.0;

/// Doubts stiffnesses that do not go with weight and strength.
pub(super) fn stiffness(case: &Case, doubts: &mut Vec<String>) {
    let length = body_length(&case.bodies);
    let reference = if length > 0.0 { length } else { depth(case) };
    for (path, soil) in case.soils().filter(|(_, soil)| is_soil(soil)) {
        let strength = soil.law.cohesion().unwrap_or(0.0);
        let stress = soil.unit_weight * reference + strength + case.overburden;
        let modulus = soil.stiffest_modulus();
        let of_weight = compression(case, soil);
        if of_weight > SOFT {
            doubts.push(format!(
                "{path}.young_modulus = {} Pa: the soil would be compressed by {:.0} % under its own weight; soil is by 1 or 2 %.",
                plain(soil.young_modulus),
                100.0 * of_weight
            ));
        } else if modulus < SOFT_OF_STRENGTH * strength {
            doubts.push(format!(
                "{path}.young_modulus = {} Pa is {} times the strength, {} Pa; soft clay has 50 to 100 times.",
                plain(soil.young_modulus),
                short(modulus / strength),
                plain(strength)
            ));
        }
        if stress > 0.0 && modulus > STIFF * stress {
            doubts.push(format!(
                "{path}.young_modulus = {} Pa is {:.0} times the stress here, {stress:.0} Pa, which no soil has; a hundredth of it makes the time steps \
                 ten times as long and changes forces on bodies that go far but little.",
                plain(soil.young_modulus),
                modulus / stress
            ));
        }
    }
}
