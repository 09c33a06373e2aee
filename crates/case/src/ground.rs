//! Where there is soil at the start, its velocity, and the pressure on it.

use super::domain::Domain;
use super::key::allowed::{NOT_NEGATIVE, POSITIVE};
use super::key::{checked, in_order, in_range, range};
use super::slope::Slope;
use super::soil::{SOIL, Soil, at_rest};
use glam::DVec3;
use input::key::DefaultValue::{Derived, Quantity};
use input::key::{Key, Kind, count, joined, key};
use input::problem::Problems;
use input::quantity::{LENGTH, SPEED, STRESS, plain};
use input::typed::Section;
use serde::Serialize;

/// Where there is soil at the start.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Ground {
    /// The half space below z = `surface` [m].
    Level {
        /// Height of the surface [m].
        surface: f64,
    },
    /// Soil only in a box (a column that will collapse, a bank in front of a wall), or in the round column
    /// inside it.
    Column {
        /// Low corner [m].
        low: DVec3,
        /// High corner [m].
        high: DVec3,
        /// Radius of the round column about the z axis [m].
        radius: Option<f64>,
    },
}

impl Ground {
    /// Height of the level surface of the ground [m].
    #[must_use]
    pub fn surface(&self) -> f64 {
        match *self {
            Self::Level { surface } => surface,
            Self::Column { high, .. } => high.z,
        }
    }
}

const SURFACE: &[Key] = &[key(
    "surface",
    Kind::Quantity(LENGTH),
    Quantity("0 m"),
    "Height of the level soil surface; of uneven ground that over which it rises and falls. Sinkages and depths count from it.",
)];

const EXTENT: &[Key] = &[
    key(
        "x",
        Kind::Range(LENGTH),
        Derived("the whole domain"),
        "Where there is soil along x, e.g. a bank in front of a wall.",
    ),
    key("y", Kind::Range(LENGTH), Derived("the whole domain"), "Where there is soil along y."),
    key(
        "radius",
        Kind::Quantity(LENGTH),
        Derived("none"),
        "Soil only within this distance of the axis x = y = 0: a round column or bar.",
    )
    .within(POSITIVE),
    key(
        "velocity",
        Kind::Vector(SPEED),
        Derived("at rest"),
        "Initial velocity of the soil along x, y, z; along x, z in plane strain.",
    ),
    key(
        "overburden",
        Kind::Quantity(STRESS),
        Quantity("0 Pa"),
        "Vertical pressure of the lid on the soil, which must reach up to the lid: soil at depth.",
    )
    .within(NOT_NEGATIVE),
];

const LISTS: &[&[Key]] = &[SURFACE, Slope::KEYS, EXTENT];

/// Keys of the ground.
pub(crate) const KEYS: &[Key] = &joined::<{ count(LISTS) }>(LISTS);

/// Where there is soil.
pub(crate) fn ground(
    section: &Section,
    surface: f64,
    domain: &Domain,
    problems: &mut Problems,
) -> Option<Ground> {
    let check = |ground: &Ground, problems: &mut Problems| check(ground, domain, problems);
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
    let x = range(KEYS, section, "x", Some(within(0)), problems);
    let y = range(KEYS, section, "y", Some(within(1)), problems);
    let ([x0, x1], [y0, y1]) = (x?, y?);
    let (low, high) = (DVec3::new(x0, y0, domain.low.z), DVec3::new(x1, y1, surface));
    checked(Ground::Column { low, high, radius }, problems, check)
}

/// Initial vertical pressure of the lid on the soil [Pa].
pub(crate) fn overburden(
    section: &Section,
    soil: &Soil,
    surface: f64,
    domain: &Domain,
    problems: &mut Problems,
) -> Option<f64> {
    checked(section.number("overburden")?, problems, |overburden, problems| {
        check_overburden(*overburden, soil, surface, domain, problems);
    })
}

/// Initial velocity of the soil [m/s] as typed, not yet checked; 0 where it cannot be read.
pub(crate) fn typed_velocity(section: &Section) -> DVec3 {
    match section.list("velocity").unwrap_or_default()[..] {
        [x, z] => DVec3::new(x, 0.0, z),
        [x, y, z] => DVec3::new(x, y, z),
        _ => DVec3::ZERO,
    }
}

/// Initial velocity of the soil [m/s].
pub(crate) fn velocity(section: &Section, domain: &Domain, problems: &mut Problems) -> Option<DVec3> {
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
    checked(velocity, problems, |velocity, problems| check_velocity(*velocity, domain, problems))
}

/// Reports numbers that make no sense by themselves: of the ground, of the velocity of its soil [m/s] and of
/// the pressure on it [Pa].
pub(crate) fn numbers(ground: &Ground, velocity: DVec3, overburden: f64, problems: &mut Problems) {
    let in_range = |name: &str, numbers: &[f64], problems: &mut Problems| {
        in_range(KEYS, "ground", name, numbers, problems);
    };
    in_range("surface", &[ground.surface()], problems);
    if let Ground::Column { low, high, radius } = *ground {
        radius.iter().for_each(|radius| in_range("radius", &[*radius], problems));
        for (axis, name) in ["x", "y"].into_iter().enumerate() {
            in_order(&format!("ground.{name}"), [low[axis], high[axis]], problems);
        }
    }
    in_range("velocity", &velocity.to_array(), problems);
    in_range("overburden", &[overburden], problems);
}

/// Depth of the soil over the height of the box that counts as none.
const NO_SOIL: f64 = 1e-6;

/// Reports ground that does not fit into the box.
pub(crate) fn check(ground: &Ground, domain: &Domain, problems: &mut Problems) {
    let surface = ground.surface();
    if surface <= domain.low.z || surface > domain.high.z {
        let message = format!(
            "the soil's surface z = {} m is not inside the box, z = {} to {} m",
            plain(surface),
            plain(domain.low.z),
            plain(domain.high.z)
        );
        problems.add("ground.surface", message, "change ground.surface or domain.z");
        return;
    }
    if surface - domain.low.z < NO_SOIL * (domain.high.z - domain.low.z) {
        let message = format!("there is no soil: it is {:.1e} m deep", surface - domain.low.z);
        problems.add("ground.surface", message, "raise ground.surface, or deepen domain.z");
        return;
    }
    let Ground::Column { low, high, radius } = *ground else { return };
    if low.z.is_nan() || low.z >= high.z {
        let message = format!("the soil begins at z = {} m, above its surface", plain(low.z));
        problems.add("ground.surface", message, "let it begin at the floor of the box");
    }
    if radius.is_some() && domain.plane_strain {
        let message = "a round column cannot be combined with plane_strain = true";
        problems.add("ground.radius", message, "remove `radius`, and give ground.x");
    }
    for (axis, key) in ["x", "y"].into_iter().enumerate() {
        if low[axis] < domain.low[axis] || high[axis] > domain.high[axis] {
            let message = format!("the soil is partly outside the box along {key}");
            problems.add(format!("ground.{key}"), message, format!("change ground.{key} or domain.{key}"));
        }
    }
}

/// Reports an initial velocity of the soil [m/s] through a plane of symmetry or of plane strain.
pub(crate) fn check_velocity(velocity: DVec3, domain: &Domain, problems: &mut Problems) {
    for (is_cut, axis) in [(domain.symmetric_x, 0), (domain.symmetric, 1)] {
        if is_cut && velocity[axis] != 0.0 {
            let message = "the soil moves through a plane of symmetry";
            let cure = "write \"0 m/s\" there, or model the whole width";
            problems.add(format!("ground.velocity[{axis}]"), message, cure);
        }
    }
    if domain.plane_strain && velocity.y != 0.0 {
        let message = "the soil moves along y, across the slab of a plane strain case";
        problems.add("ground.velocity", message, "in plane strain give it along x and z");
    }
}

/// Reports an overburden [Pa] under which the soil, with its surface at a height [m], does not reach up to
/// the lid or yields at once.
pub(crate) fn check_overburden(
    overburden: f64,
    soil: &Soil,
    surface: f64,
    domain: &Domain,
    problems: &mut Problems,
) {
    if overburden == 0.0 {
        return;
    }
    if surface < domain.high.z {
        let message = format!(
            "an overburden needs a lid: the soil ends at z = {} m, the box at {} m",
            plain(surface),
            plain(domain.high.z)
        );
        let cure = "let domain.z end at ground.surface, or remove `overburden`";
        problems.add("ground.overburden", message, cure);
        return;
    }
    sustained(SOIL, soil, overburden, problems);
}

/// Reports an overburden [Pa] under which the soil of a section yields at once.
pub(crate) fn sustained(path: &str, soil: &Soil, overburden: f64, problems: &mut Problems) {
    let ratio = soil.k0;
    if !at_rest::sustains(&soil.law, [1.0, ratio, ratio].map(|r| r * overburden)) {
        let message = format!(
            "the soil of [{path}] cannot sustain this overburden with K₀ = {ratio:.3}: it would fail at once"
        );
        problems.add(
            "ground.overburden",
            message,
            format!("add  k0 = 1  to [{path}], or lower the overburden"),
        );
    }
}
