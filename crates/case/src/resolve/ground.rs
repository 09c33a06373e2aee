//! Where there is soil at the start, and its initial velocity.

use super::context::checked;
use crate::missing::range;
use crate::resolved::{Domain, Ground, Soil};
use crate::slope::Slope;
use crate::validate;
use glam::DVec3;
use input::problem::Problems;
use input::typed::Section;

/// Slope of the ground; `None` where it cannot be read.
pub(super) fn slope(section: &Section) -> Option<Slope> {
    Some(Slope { along: section.number("slope")?, across: section.number("cross_slope")? })
}

/// Where there is soil.
pub(super) fn ground(
    section: &Section,
    surface: f64,
    domain: &Domain,
    problems: &mut Problems,
) -> Option<Ground> {
    let check = |ground: &Ground, problems: &mut Problems| validate::domain::ground(ground, domain, problems);
    // A column reaches down to the floor: the surface must be above it.
    let level = checked(Ground::Level { surface }, problems, check)?;
    if !["x", "y", "radius"].iter().any(|key| section.has(key)) {
        return Some(level);
    }
    let radius = if section.has("radius") { Some(section.number("radius")?) } else { None };
    let within = |axis: usize| {
        let [low, high] = [domain.low[axis], domain.high[axis]];
        radius.map_or([low, high], |r| [low.max(-r), high.min(r)])
    };
    let x = range(section, "x", Some(within(0)), problems);
    let y = range(section, "y", Some(within(1)), problems);
    let ([x0, x1], [y0, y1]) = (x?, y?);
    let (low, high) = (DVec3::new(x0, y0, domain.low.z), DVec3::new(x1, y1, surface));
    checked(Ground::Column { low, high, radius }, problems, check)
}

/// Initial vertical pressure of the lid on the soil [Pa].
pub(super) fn overburden(
    section: &Section,
    soil: &Soil,
    surface: f64,
    domain: &Domain,
    problems: &mut Problems,
) -> Option<f64> {
    checked(section.number("overburden")?, problems, |overburden, problems| {
        validate::soil::overburden(*overburden, soil, surface, domain, problems);
    })
}

/// Initial velocity of the soil [m/s] as typed, not yet checked; 0 where it cannot be read.
pub(super) fn typed_velocity(section: &Section) -> DVec3 {
    match section.list("velocity").unwrap_or_default()[..] {
        [x, z] => DVec3::new(x, 0.0, z),
        [x, y, z] => DVec3::new(x, y, z),
        _ => DVec3::ZERO,
    }
}

/// Initial velocity of the soil [m/s].
pub(super) fn velocity(section: &Section, domain: &Domain, problems: &mut Problems) -> Option<DVec3> {
    if !section.has("velocity") {
        return Some(DVec3::ZERO);
    }
    let components = section.list("velocity")?;
    let velocity = match (components.as_slice(), domain.plane_strain) {
        (&[x, z], true) => DVec3::new(x, 0.0, z),
        (&[x, y, z], false) => DVec3::new(x, y, z),
        (_, plane_strain) => {
            let cure = if plane_strain {
                "in plane strain give it along x and z"
            } else {
                "give it along x, y and z"
            };
            let message = format!("a velocity of {} components", components.len());
            problems.add(section.at("velocity"), message, cure);
            return None;
        }
    };
    checked(velocity, problems, |velocity, problems| validate::domain::velocity(*velocity, domain, problems))
}
