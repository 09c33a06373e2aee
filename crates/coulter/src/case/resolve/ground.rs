//! Where there is soil at the start, and its initial velocity.

use crate::case::problem::Problems;
use crate::case::quantity::plain;
use crate::case::ranges::{self, POSITIVE, range};
use crate::case::resolved::{Domain, Ground};
use crate::case::typed::Section;
use glam::DVec3;

/// Where there is soil.
pub(super) fn ground(
    section: &Section,
    surface: f64,
    domain: &Domain,
    problems: &mut Problems,
) -> Option<Ground> {
    if surface <= domain.low.z || surface > domain.high.z {
        let message = format!(
            "the soil's surface z = {} m is not inside the box, z = {} to {} m",
            plain(surface),
            plain(domain.low.z),
            plain(domain.high.z)
        );
        problems.add(section.location_of("surface"), message, "change ground.surface or domain.z");
        return None;
    }
    if !["x", "y", "radius"].iter().any(|key| section.has(key)) {
        return Some(Ground::Level { surface });
    }
    let radius = ranges::given(section, "radius", &POSITIVE, problems);
    if section.has("radius") {
        radius?;
    }
    if radius.is_some() && domain.plane_strain {
        let message = "a round column cannot be combined with plane_strain = true";
        problems.add(section.location_of("radius"), message, "remove `radius`, and give ground.x");
        return None;
    }
    let within = |axis: usize| {
        let [low, high] = [domain.low[axis], domain.high[axis]];
        radius.map_or([low, high], |r| [low.max(-r), high.min(r)])
    };
    let x = range(section, "x", Some(within(0)), problems);
    let y = range(section, "y", Some(within(1)), problems);
    let ([x0, x1], [y0, y1]) = (x?, y?);
    for (axis, key, low, high) in [(0, "x", x0, x1), (1, "y", y0, y1)] {
        if low < domain.low[axis] || high > domain.high[axis] {
            let message = format!("the soil is partly outside the box along {key}");
            problems.add(section.location_of(key), message, format!("change ground.{key} or domain.{key}"));
            return None;
        }
    }
    let (low, high) = (DVec3::new(x0, y0, domain.low.z), DVec3::new(x1, y1, surface));
    Some(Ground::Column { low, high, radius })
}

/// Initial velocity of the soil [m/s] as typed, not yet checked; 0 where it cannot be read.
pub(super) fn typed_velocity(section: &Section) -> DVec3 {
    let components: Vec<f64> =
        section.list("velocity").into_iter().flat_map(|t| t.value).map(|p| p.value).collect();
    match components[..] {
        [x, z] => DVec3::new(x, 0.0, z),
        [x, y, z] => DVec3::new(x, y, z),
        _ => DVec3::ZERO,
    }
}

/// Initial velocity of the soil [m/s]: none through a plane of symmetry.
pub(super) fn velocity(section: &Section, domain: &Domain, problems: &mut Problems) -> Option<DVec3> {
    if !section.has("velocity") {
        return Some(DVec3::ZERO);
    }
    let typed = section.list("velocity")?;
    let components: Vec<f64> = typed.value.iter().map(|component| component.value).collect();
    let velocity = match (components.as_slice(), domain.plane_strain) {
        (&[x, z], true) => DVec3::new(x, 0.0, z),
        (&[x, y, z], false) => DVec3::new(x, y, z),
        (_, plane_strain) => {
            let cure = if plane_strain {
                "in plane strain give it along x and z"
            } else {
                "give it along x, y and z"
            };
            problems.add(&typed.location, format!("a velocity of {} components", components.len()), cure);
            return None;
        }
    };
    for (is_cut, axis) in [(domain.symmetric_x, 0), (domain.symmetric, 1)] {
        if is_cut && velocity[axis] != 0.0 {
            let message = "the soil moves through a plane of symmetry";
            problems.add(
                &typed.value[axis].location,
                message,
                "write \"0 m/s\" there, or model the whole width",
            );
            return None;
        }
    }
    Some(velocity)
}
