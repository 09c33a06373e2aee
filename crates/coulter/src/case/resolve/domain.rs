//! The box that is modelled.

use super::clearance::{Clearance, clearance};
use super::context::Context;
use crate::case::path::{Extent, body_length, paths};
use crate::case::problem::Problems;
use crate::case::ranges::range;
use crate::case::resolved::{Body, Domain, Wall};
use crate::case::typed::Section;
use glam::DVec3;

/// Least clearance below the bodies and to the sides [body lengths]; chosen: the ground fails over some three sinkages,
/// and a disc seldom sinks deeper than a third of its diameter.
const MIN_BELOW: f64 = 1.25;
const MIN_SIDE: f64 = 1.5;
/// Least clearance above the soil [body lengths]; chosen: the heap of a free disc stays far below it.
const MIN_ABOVE: f64 = 0.4;
/// Empty cells above the expected heap; chosen: a remap smears its top over two cells.
const OVER_HEAP: f64 = 2.0;

/// The default box, not yet bounded by planes of symmetry; `None` without bodies.
///
/// The clearance round the bodies is that which [`clearance`] estimates, but at least the usual one.
fn default_box(context: &Context, bodies: &[Body], duration: f64) -> Option<Extent> {
    let around = paths(bodies, duration)?;
    let length = body_length(bodies);
    let need = bodies
        .iter()
        .map(|b| clearance(b, &context.soil_conditions(), duration))
        .fold(Clearance::default(), Clearance::and);
    let at_least = |needed: f64| needed.max(MIN_SIDE * length);
    let floor = around.low.z.min(context.surface) - need.below.max(MIN_BELOW * length);
    let lid = (MIN_ABOVE * length).max(need.above + OVER_HEAP * context.cell);
    Some(Extent {
        low: DVec3::new(
            around.low.x - at_least(need.along[0]),
            around.low.y - at_least(need.sideways),
            floor,
        ),
        high: DVec3::new(
            around.high.x + at_least(need.along[1]),
            around.high.y + at_least(need.sideways),
            context.surface + lid,
        ),
    })
}

/// The box that is modelled.
pub(super) fn domain(
    section: &Section,
    context: &Context,
    bodies: &[Body],
    duration: f64,
    problems: &mut Problems,
) -> Option<Domain> {
    let default = default_box(context, bodies, duration);
    let least = |is_cut: bool| if is_cut { 0.0 } else { f64::NEG_INFINITY };
    let (low_x, low_y) = (least(context.symmetric_x), least(context.symmetric));
    let x = range(section, "x", default.map(|u| [low_x.max(u.low.x), u.high.x]), problems);
    let y = match context.slab {
        Some(slab) => Some([slab.middle - 0.5 * slab.width, slab.middle + 0.5 * slab.width]),
        None => range(section, "y", default.map(|u| [low_y.max(u.low.y), u.high.y]), problems),
    };
    let z = range(section, "z", default.map(|u| [u.low.z, u.high.z]), problems);
    let walls = walls(section, context, problems);
    let ([x0, x1], [y0, y1], [z0, z1]) = (x?, y?, z?);
    for (is_cut, key, low) in [(context.symmetric_x, "x", x0), (context.symmetric, "y", y0)] {
        if is_cut && low != 0.0 {
            let message = format!("a symmetric case is modelled from its plane of symmetry, {key} = 0");
            problems.add(section.location_of(key), message, format!("let {key} begin with \"0 m\""));
            return None;
        }
    }
    let (low, high) = (DVec3::new(x0, y0, z0), DVec3::new(x1, y1, z1));
    let plane_strain = context.slab.is_some();
    let Context { symmetric, symmetric_x, .. } = *context;
    Some(Domain { low, high, walls: walls?, symmetric, symmetric_x, plane_strain })
}

fn walls(section: &Section, context: &Context, problems: &mut Problems) -> Option<[[Wall; 2]; 3]> {
    let default = [[Wall::Smooth; 2], [Wall::Smooth; 2], [Wall::Fixed, Wall::Smooth]];
    let mut walls = default;
    for (axis, key) in ["x_walls", "y_walls", "z_walls"].into_iter().enumerate() {
        if !section.has(key) {
            continue;
        }
        let words = section.words(key)?;
        for (wall, word) in walls[axis].iter_mut().zip(&words.value) {
            *wall = if word == "fixed" { Wall::Fixed } else { Wall::Smooth };
        }
    }
    let slab_is_fixed = context.slab.is_some() && walls[1] != [Wall::Smooth; 2];
    if slab_is_fixed || context.symmetric && walls[1][0] != Wall::Smooth {
        let message = "a plane of symmetry, or of plane strain, is smooth";
        problems.add(section.location_of("y_walls"), message, "remove y_walls, or write \"smooth\" there");
        return None;
    }
    if context.symmetric_x && walls[0][0] != Wall::Smooth {
        let message = "a plane of symmetry is smooth";
        problems.add(section.location_of("x_walls"), message, "let x_walls begin with \"smooth\"");
        return None;
    }
    Some(walls)
}
