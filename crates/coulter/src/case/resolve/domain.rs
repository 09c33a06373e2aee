//! The box that is modelled.

use super::frame::Frame;
use super::room::{Room, room};
use crate::case::path::{Extent, body_length, paths};
use crate::case::problem::Problems;
use crate::case::ranges::range;
use crate::case::resolved::{Body, Domain, Wall};
use crate::case::typed::Section;
use glam::DVec3;

/// Soil below the bodies, and beside them, unless more is needed [body lengths]; chosen: the ground fails over some three
/// sinkages, and a disc seldom sinks deeper than a third of its diameter.
const LEAST_BELOW: f64 = 1.25;
const LEAST_BESIDE: f64 = 1.5;
/// Room above the soil unless more is needed [body lengths]; chosen: what a free disc pushes up stays far below it.
const LEAST_ABOVE: f64 = 0.4;
/// Cells that stay empty over the heap that is expected; chosen: a remap spreads its top over two.
const OVER_HEAP: f64 = 2.0;

/// The box unless the case says otherwise, cut by no plane of symmetry yet; `None` without bodies.
///
/// Room as [`room`] estimates it, and never less than what is usual.
fn usual_box(frame: &Frame, bodies: &[Body], duration: f64) -> Option<Extent> {
    let around = paths(bodies, duration)?;
    let length = body_length(bodies);
    let need = bodies.iter().map(|b| room(b, &frame.soil(), duration)).fold(Room::default(), Room::and);
    let beside = |needed: f64| needed.max(LEAST_BESIDE * length);
    let floor = around.low.z.min(frame.surface) - need.below.max(LEAST_BELOW * length);
    let lid = (LEAST_ABOVE * length).max(need.above + OVER_HEAP * frame.cell);
    Some(Extent {
        low: DVec3::new(around.low.x - beside(need.along[0]), around.low.y - beside(need.beside), floor),
        high: DVec3::new(
            around.high.x + beside(need.along[1]),
            around.high.y + beside(need.beside),
            frame.surface + lid,
        ),
    })
}

/// The box that is modelled.
pub(super) fn domain(
    section: &Section,
    frame: &Frame,
    bodies: &[Body],
    duration: f64,
    problems: &mut Problems,
) -> Option<Domain> {
    let usual = usual_box(frame, bodies, duration);
    let least = |is_cut: bool| if is_cut { 0.0 } else { f64::NEG_INFINITY };
    let (low_x, low_y) = (least(frame.symmetric_x), least(frame.symmetric));
    let x = range(section, "x", usual.map(|u| [low_x.max(u.low.x), u.high.x]), problems);
    let y = match frame.slab {
        Some(slab) => Some([slab.middle - 0.5 * slab.width, slab.middle + 0.5 * slab.width]),
        None => range(section, "y", usual.map(|u| [low_y.max(u.low.y), u.high.y]), problems),
    };
    let z = range(section, "z", usual.map(|u| [u.low.z, u.high.z]), problems);
    let walls = walls(section, frame, problems);
    let ([x0, x1], [y0, y1], [z0, z1]) = (x?, y?, z?);
    for (is_cut, key, low) in [(frame.symmetric_x, "x", x0), (frame.symmetric, "y", y0)] {
        if is_cut && low != 0.0 {
            let message = format!("a symmetric case is modelled from its plane of symmetry {key} = 0 on");
            problems.add(section.place_of(key), message, format!("let {key} begin with \"0 m\""));
            return None;
        }
    }
    let (low, high) = (DVec3::new(x0, y0, z0), DVec3::new(x1, y1, z1));
    let plane_strain = frame.slab.is_some();
    let Frame { symmetric, symmetric_x, .. } = *frame;
    Some(Domain { low, high, walls: walls?, symmetric, symmetric_x, plane_strain })
}

fn walls(section: &Section, frame: &Frame, problems: &mut Problems) -> Option<[[Wall; 2]; 3]> {
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
    let slab_holds = frame.slab.is_some() && walls[1] != [Wall::Smooth; 2];
    if slab_holds || frame.symmetric && walls[1][0] != Wall::Smooth {
        let message = "a plane of symmetry, or of plane strain, is smooth";
        problems.add(section.place_of("y_walls"), message, "leave y_walls out, or write \"smooth\" there");
        return None;
    }
    if frame.symmetric_x && walls[0][0] != Wall::Smooth {
        let message = "a plane of symmetry is smooth";
        problems.add(section.place_of("x_walls"), message, "let x_walls begin with \"smooth\"");
        return None;
    }
    Some(walls)
}
