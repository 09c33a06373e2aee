//! The box that is modelled, and the ground in it.

use crate::numbers::{in_order, in_range};
use crate::resolved::{Case, Domain, Ground, Wall};
use glam::DVec3;
use input::problem::Problems;
use input::quantity::plain;

const AXES: [&str; 3] = ["x", "y", "z"];

/// Whether the planes of symmetry and of plane strain do not exclude each other; reported if they do.
pub(crate) fn planes(symmetric: bool, plane_strain: bool, problems: &mut Problems) {
    if symmetric && plane_strain {
        let message = "symmetric = true cannot be combined with plane_strain = true";
        problems.add("domain.symmetric", message, "remove `symmetric`");
    }
}

/// Reports what is wrong with the box.
pub(crate) fn domain(domain: &Domain, problems: &mut Problems) {
    planes(domain.symmetric, domain.plane_strain, problems);
    for (axis, name) in AXES.into_iter().enumerate() {
        let path = format!("domain.{name}");
        let ends = [domain.low[axis], domain.high[axis]];
        let are_numbers = [0, 1].map(|n| in_range(&format!("{path}[{n}]"), ends[n], problems));
        if are_numbers == [true; 2] {
            in_order(&path, ends, problems);
        }
    }
    for (is_cut, key, low) in [(domain.symmetric_x, "x", domain.low.x), (domain.symmetric, "y", domain.low.y)]
    {
        if is_cut && low != 0.0 {
            let message = format!("a symmetric case is modelled from its plane of symmetry, {key} = 0");
            problems.add(format!("domain.{key}"), message, format!("let {key} begin with \"0 m\""));
        }
    }
    walls(domain, problems);
}

fn walls(domain: &Domain, problems: &mut Problems) {
    let [x, y, z] = domain.walls;
    if z[0] == Wall::Pressure {
        let message = "a floor at constant stress bears no more than the soil at rest: everything would sink";
        problems.add("domain.z_walls", message, "let z_walls begin with \"fixed\" or \"smooth\"");
    }
    let slab_is_fixed = domain.plane_strain && y != [Wall::Smooth; 2];
    if slab_is_fixed || domain.symmetric && y[0] != Wall::Smooth {
        let message = "a plane of symmetry, or of plane strain, is smooth";
        problems.add("domain.y_walls", message, "remove y_walls, or write \"smooth\" there");
    }
    if domain.symmetric_x && x[0] != Wall::Smooth {
        let message = "a plane of symmetry is smooth";
        problems.add("domain.x_walls", message, "let x_walls begin with \"smooth\"");
    }
}

/// Reports numbers of the ground that make no sense by themselves.
pub(super) fn ground_numbers(ground: &Ground, problems: &mut Problems) {
    in_range("ground.surface", ground.surface(), problems);
    let Ground::Column { low, high, radius } = *ground else { return };
    if let Some(radius) = radius {
        in_range("ground.radius", radius, problems);
    }
    for (axis, name) in ["x", "y"].into_iter().enumerate() {
        in_order(&format!("ground.{name}"), [low[axis], high[axis]], problems);
    }
}

/// Depth of the soil over the height of the box that counts as none.
const NO_SOIL: f64 = 1e-6;

/// Reports boundaries at constant stress that the ground or a grid that follows a body contradicts.
pub(crate) fn constant_stress(case: &Case, problems: &mut Problems) {
    let domain = &case.domain;
    if !domain.yields() {
        return;
    }
    if matches!(case.ground, Ground::Column { .. }) {
        let message =
            "no ground lies beyond the boundaries of a column, which has none to bear its stress at rest";
        problems.add("domain", message, "write \"smooth\" or \"fixed\" instead of \"pressure\"");
    }
    let is_covered = case.ground.surface() >= domain.high.z;
    if domain.lid() == Wall::Pressure && !(is_covered && case.overburden > 0.0) {
        let message = "a lid of constant pressure needs soil up to the lid and the pressure on it";
        let cure =
            "give ground.overburden, and let domain.z end at ground.surface; a free surface needs no lid";
        problems.add("domain.z_walls", message, cure);
    }
    for (axis, name) in AXES.into_iter().enumerate() {
        let follows = case.grid.follow.is_some_and(|follow| follow.axes[axis]);
        if follows && domain.walls[axis].contains(&Wall::Pressure) {
            let message = format!(
                "there are no walls along {name} in a grid that follows a body: ground enters there already"
            );
            problems.add(format!("domain.{name}_walls"), message, "remove it");
        }
    }
}

/// Reports ground that does not fit into the box.
pub(crate) fn ground(ground: &Ground, domain: &Domain, problems: &mut Problems) {
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

/// Reports an initial velocity of the soil [m/s] that is none.
pub(super) fn velocity_numbers(velocity: DVec3, problems: &mut Problems) {
    for component in velocity.to_array() {
        in_range("ground.velocity", component, problems);
    }
}

/// Reports an initial velocity of the soil [m/s] through a plane of symmetry or of plane strain.
pub(crate) fn velocity(velocity: DVec3, domain: &Domain, problems: &mut Problems) {
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
