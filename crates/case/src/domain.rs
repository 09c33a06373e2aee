//! The box that is modelled: its keys, its reading, and whether it is one.

use super::clearance::{Clearance, SoilConditions, clearance};
use super::context::Context;
use super::key::{checked, in_order, in_range, range};
use super::path::{Extent, Paths, body_length, displacement};
use super::shapes::slab::PLANE_STRAIN_WIDTH;
use glam::DVec3;
use input::key::DefaultValue::{Derived, Flag, Walls};
use input::key::{Key, Kind, key};
use input::problem::Problems;
use input::quantity::LENGTH;
use input::typed::Section;
use serde::Serialize;

/// Boundary condition at a face of the box.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Wall {
    /// No motion through the wall, no friction along it. A symmetry plane is one.
    Smooth,
    /// No motion at the wall at all.
    Fixed,
    /// No wall: the ground beyond the face bears what it bears at rest, soil leaves and ground enters.
    Pressure,
}

/// The box that is modelled.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Domain {
    /// Low corner [m].
    pub low: DVec3,
    /// High corner [m].
    pub high: DVec3,
    /// Walls by axis x, y, z: at the low end and at the high end.
    pub walls: [[Wall; 2]; 3],
    /// Whether y = 0 is a plane of symmetry and only y ≥ 0 is modelled. Forces are reported for the whole
    /// body.
    pub symmetric: bool,
    /// Whether x = 0 is a plane of symmetry and only x ≥ 0 is modelled.
    pub symmetric_x: bool,
    /// Whether the case is plane strain: a slab one cell thick in y. Bodies, forces and weights are those of
    /// a width of
    /// [`PLANE_STRAIN_WIDTH`], whatever the thickness of the slab.
    pub plane_strain: bool,
}

impl Domain {
    /// Whether any boundary is at constant stress.
    #[must_use]
    pub fn yields(&self) -> bool {
        self.walls.as_flattened().contains(&Wall::Pressure)
    }

    /// The boundary at the top.
    #[must_use]
    pub fn lid(&self) -> Wall {
        self.walls[2][1]
    }

    /// Width of a body along y [m] that is itself so wide; in plane strain [`PLANE_STRAIN_WIDTH`].
    #[must_use]
    pub fn width_of_body(&self, own: f64) -> f64 {
        if self.plane_strain { PLANE_STRAIN_WIDTH } else { own }
    }

    /// Portion of the width of each body that is modelled: in plane strain that of the slab, which may be
    /// more than 1, otherwise 1.
    #[must_use]
    pub fn modelled_width(&self) -> f64 {
        if self.plane_strain { (self.high.y - self.low.y) / PLANE_STRAIN_WIDTH } else { 1.0 }
    }
}

/// Keys of the box.
pub(crate) const KEYS: &[Key] = &[
    key(
        "x",
        Kind::Range(LENGTH),
        Derived(
            "the bodies' path and 1.5 body lengths at each end, more ahead where the failing soil needs it",
        ),
        "The box along the tow; from 0 if symmetric_x.",
    ),
    key(
        "y",
        Kind::Range(LENGTH),
        Derived("the bodies and 1.5 body lengths at each side, more where the failing soil needs it"),
        "The box across the tow; from 0 if symmetric.",
    ),
    key(
        "z",
        Kind::Range(LENGTH),
        Derived(
            "1.25 body lengths of soil (1.9 where nothing is towed), 0.4 of headroom, more where the heap of soil needs it",
        ),
        "The box in height: floor and lid.",
    ),
    key("symmetric", Kind::Flag, Flag(false), "Model only y ≥ 0; y = 0 is a plane of symmetry."),
    key("symmetric_x", Kind::Flag, Flag(false), "Model only x ≥ 0; x = 0 is a plane of symmetry."),
    key(
        "plane_strain",
        Kind::Flag,
        Flag(false),
        "Model a slab that is one cell thick in y; weights, masses, loads and forces are per metre of width.",
    ),
    key(
        "x_walls",
        Kind::WallPair,
        Walls(["smooth", "smooth"]),
        "Walls at the low and the high end of x; `fixed` by default where ground.slope is given, `pressure` for none: the ground beyond bears \
         its stress at rest.",
    ),
    key(
        "y_walls",
        Kind::WallPair,
        Walls(["smooth", "smooth"]),
        "Walls at the low and the high end of y; `fixed` by default where ground.cross_slope is given, `pressure` as along x.",
    ),
    key(
        "z_walls",
        Kind::WallPair,
        Walls(["fixed", "smooth"]),
        "Floor and lid; a `pressure` lid keeps ground.overburden however the soil rises.",
    ),
];

/// Least clearance below the bodies and to the sides [body lengths]; chosen: the ground fails over some three
/// sinkages, and a disc seldom sinks deeper than a third of its diameter.
const MIN_BELOW: f64 = 1.25;
/// Least clearance below bodies that are only pressed [body lengths]; chosen: of nine random cases floor or
/// walls bore more than 40 % of the contact pressure in all with 1.25, in four with half as much again; their
/// forces changed by up to 6 %.
const MIN_BELOW_PRESSED: f64 = 1.9;
const MIN_SIDE: f64 = 1.5;
/// Least clearance above the soil [body lengths]; chosen: the heap of a free disc stays far below it.
const MIN_ABOVE: f64 = 0.4;
/// Empty cells above the expected heap; chosen: a remap smears its top over two cells.
const OVER_HEAP: f64 = 2.0;

/// The default box, not yet bounded by planes of symmetry; `None` without bodies.
///
/// The clearance round the bodies is that which [`clearance`] estimates, but at least the usual one.
fn default_box(context: &Context, paths: &Paths) -> Option<Extent> {
    let around = paths.all()?;
    let length = body_length(paths.bodies);
    let bodies = paths.bodies.iter().filter(|body| body.has_surface());
    let need = bodies
        .map(|b| clearance(b, &SoilConditions::before_the_box(context), paths.duration))
        .fold(Clearance::default(), Clearance::and);
    let at_least = |needed: f64| needed.max(MIN_SIDE * length);
    let [lowest, highest] = context.between;
    let is_towed = paths.bodies.iter().any(|body| {
        let moved = displacement(body, paths.duration);
        moved.x != 0.0 || moved.y != 0.0
    });
    let least = if is_towed { MIN_BELOW } else { MIN_BELOW_PRESSED };
    let floor = around.low.z.min(lowest) - need.below.max(least * length);
    let lid = (MIN_ABOVE * length).max(need.above_at_most + OVER_HEAP * context.fine_cell().z);
    Some(Extent {
        low: DVec3::new(
            around.low.x - at_least(need.along[0]),
            around.low.y - at_least(need.sideways),
            floor,
        ),
        high: DVec3::new(
            around.high.x + at_least(need.along[1]),
            around.high.y + at_least(need.sideways),
            highest + lid,
        ),
    })
}

/// The box that is modelled.
pub(crate) fn domain(
    section: &Section,
    context: &Context,
    paths: &Paths,
    problems: &mut Problems,
) -> Option<Domain> {
    let default = default_box(context, paths);
    let least = |is_cut: bool| if is_cut { 0.0 } else { f64::NEG_INFINITY };
    let (low_x, low_y) = (least(context.symmetric_x), least(context.symmetric));
    let x = range(KEYS, section, "x", default.map(|u| [low_x.max(u.low.x), u.high.x]), problems);
    let y = match context.slab {
        Some(slab) => Some([slab.middle - 0.5 * slab.width, slab.middle + 0.5 * slab.width]),
        None => range(KEYS, section, "y", default.map(|u| [low_y.max(u.low.y), u.high.y]), problems),
    };
    let z = range(KEYS, section, "z", default.map(|u| [u.low.z, u.high.z]), problems);
    let walls = walls(section, context, paths);
    let ([x0, x1], [y0, y1], [z0, z1]) = (x?, y?, z?);
    let (low, high) = (DVec3::new(x0, y0, z0), DVec3::new(x1, y1, z1));
    let plane_strain = context.slab.is_some();
    let Context { symmetric, symmetric_x, .. } = *context;
    let domain = Domain { low, high, walls: walls?, symmetric, symmetric_x, plane_strain };
    checked(domain, problems, check)
}

/// The walls; across the slope of the ground they are fixed unless they are given, since smooth ones bear no
/// shear stress.
fn walls(section: &Section, context: &Context, paths: &Paths) -> Option<[[Wall; 2]; 3]> {
    let mut walls = [[Wall::Smooth; 2]; 3];
    // A plane of symmetry across the slope is refused later; a grid that follows a body has no walls there.
    let is_plane = [context.symmetric_x, context.symmetric || context.slab.is_some()];
    let is_open = |axis: usize| paths.follow.is_some_and(|follow| follow.axes[axis]);
    let angles = context.slope.angles();
    let [along, across] = [0, 1].map(|axis| angles[axis] != 0.0 && !is_plane[axis] && !is_open(axis));
    let keys = [("x_walls", along), ("y_walls", across), ("z_walls", false)];
    for (pair, (key, slopes)) in walls.iter_mut().zip(keys) {
        if slopes && !section.has(key) {
            *pair = [Wall::Fixed; 2];
            continue;
        }
        for (wall, word) in pair.iter_mut().zip(section.words(key)?) {
            *wall = match word.as_str() {
                "fixed" => Wall::Fixed,
                "pressure" => Wall::Pressure,
                _ => Wall::Smooth,
            };
        }
    }
    Some(walls)
}

/// Whether the planes of symmetry and of plane strain do not exclude each other; reported if they do.
pub(crate) fn planes(symmetric: bool, plane_strain: bool, problems: &mut Problems) {
    if symmetric && plane_strain {
        let message = "symmetric = true cannot be combined with plane_strain = true";
        problems.add("domain.symmetric", message, "remove `symmetric`");
    }
}

/// Reports what is wrong with the box.
pub(crate) fn check(domain: &Domain, problems: &mut Problems) {
    planes(domain.symmetric, domain.plane_strain, problems);
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        let path = format!("domain.{name}");
        let ends = [domain.low[axis], domain.high[axis]];
        let mut is_number = |n| in_range(KEYS, "domain", &format!("{name}[{n}]"), &[ends[n]], problems);
        let are_numbers = [0, 1].map(&mut is_number);
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
    check_walls(domain, problems);
}

/// Reports walls that bear nothing, and planes of symmetry that are not smooth.
fn check_walls(domain: &Domain, problems: &mut Problems) {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::keys;

    #[test]
    fn the_documented_box_is_the_derived_one() {
        let documented = |path| keys::at(path).unwrap().default.text();
        assert!(documented("domain.x").contains(&format!("{MIN_SIDE} body lengths")));
        assert!(documented("domain.y").contains(&format!("{MIN_SIDE} body lengths")));
        let z = documented("domain.z");
        let below = format!(
            "{MIN_BELOW} body lengths of soil ({MIN_BELOW_PRESSED} where nothing is towed), {MIN_ABOVE} of headroom"
        );
        assert!(z.contains(&below), "{z}");
    }
}
