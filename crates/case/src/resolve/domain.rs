//! The box that is modelled.

use super::clearance::{Clearance, clearance};
use super::context::{Context, checked};
use crate::missing::range;
use crate::path::{Extent, Paths, body_length, displacement};
use crate::resolved::{Domain, Wall};
use crate::validate;
use glam::DVec3;
use input::problem::Problems;
use input::typed::Section;

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
        .map(|b| clearance(b, &context.soil_conditions(), paths.duration))
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
pub(super) fn domain(
    section: &Section,
    context: &Context,
    paths: &Paths,
    problems: &mut Problems,
) -> Option<Domain> {
    let default = default_box(context, paths);
    let least = |is_cut: bool| if is_cut { 0.0 } else { f64::NEG_INFINITY };
    let (low_x, low_y) = (least(context.symmetric_x), least(context.symmetric));
    let x = range(section, "x", default.map(|u| [low_x.max(u.low.x), u.high.x]), problems);
    let y = match context.slab {
        Some(slab) => Some([slab.middle - 0.5 * slab.width, slab.middle + 0.5 * slab.width]),
        None => range(section, "y", default.map(|u| [low_y.max(u.low.y), u.high.y]), problems),
    };
    let z = range(section, "z", default.map(|u| [u.low.z, u.high.z]), problems);
    let walls = walls(section, context, paths);
    let ([x0, x1], [y0, y1], [z0, z1]) = (x?, y?, z?);
    let (low, high) = (DVec3::new(x0, y0, z0), DVec3::new(x1, y1, z1));
    let plane_strain = context.slab.is_some();
    let Context { symmetric, symmetric_x, .. } = *context;
    let domain = Domain { low, high, walls: walls?, symmetric, symmetric_x, plane_strain };
    checked(domain, problems, validate::domain::domain)
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
