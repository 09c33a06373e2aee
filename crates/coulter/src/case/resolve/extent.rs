//! Where everything is: the bodies' path and the box.

use super::Frame;
use super::room::{Room, room};
use crate::case::problem::Problems;
use crate::case::ranges;
use crate::case::resolved::{Body, Domain, Freedom, Wall};
use crate::case::schema::Section;
use glam::DVec3;

/// A box round something.
#[derive(Clone, Copy, Debug)]
pub(in crate::case) struct Extent {
    /// Low corner [m].
    pub(in crate::case) low: DVec3,
    /// High corner [m].
    pub(in crate::case) high: DVec3,
}

/// How far a prescribed motion has gone after `time` [m or rad]; 0 for any other.
pub(crate) fn travel(freedom: &Freedom, time: f64) -> f64 {
    let Freedom::Prescribed { speed, start, ramp, end } = *freedom else { return 0.0 };
    // Integral of the smooth step 3x² − 2x³ over a ramp, then of 1.
    let ramped = |since: f64| {
        let x = if ramp > 0.0 { (since / ramp).clamp(0.0, 1.0) } else { 1.0 };
        ramp * (x.powi(3) - 0.5 * x.powi(4)) + (since - ramp).max(0.0)
    };
    let since = |event: f64| if time > event { ramped(time - event) } else { 0.0 };
    speed * (since(start) - since(end))
}

/// The box round a body on its whole way.
pub(in crate::case) fn path(body: &Body, duration: f64) -> Extent {
    let (low, high) = body.shape.solid().bounds();
    let moved = DVec3::from_array(std::array::from_fn(|axis| travel(&body.translation[axis], duration)));
    let (start, end) = (body.position, body.position + moved);
    Extent { low: start.min(end) + low, high: start.max(end) + high }
}

/// The box round all bodies on their whole way.
pub(in crate::case) fn paths(bodies: &[Body], duration: f64) -> Option<Extent> {
    bodies
        .iter()
        .map(|b| path(b, duration))
        .reduce(|a, b| Extent { low: a.low.min(b.low), high: a.high.max(b.high) })
}

/// The largest edge of any body in the plane of the tow [m].
pub(in crate::case) fn body_length(bodies: &[Body]) -> f64 {
    let length = |b: &Body| {
        let (low, high) = b.shape.solid().bounds();
        (high - low).x.max((high - low).z)
    };
    bodies.iter().map(length).fold(0.0, f64::max)
}

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

/// A low and a high end; reported if they are the wrong way round, or missing without a default.
pub(super) fn range(
    section: &Section,
    key: &str,
    default: Option<[f64; 2]>,
    problems: &mut Problems,
) -> Option<[f64; 2]> {
    if !section.has(key) {
        if default.is_none() {
            ranges::missing(section, key, problems);
        }
        return default;
    }
    let typed = section.list(key)?;
    let (low, high) = (typed.value.first()?.value, typed.value.last()?.value);
    if low < high {
        return Some([low, high]);
    }
    let message = format!("{} is empty: its low end is not below its high end", ranges::dotted(section, key));
    problems.add(&typed.place, message, "write the lower value first");
    None
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn travel_is_the_integral_of_the_speed() {
        let towed = Freedom::Prescribed { speed: 0.2, start: 0.4, ramp: 0.1, end: 1.0 };
        let at = |time: f64| travel(&towed, time);
        assert!((at(0.4), at(0.3)) == (0.0, 0.0));
        assert!((at(0.45) - 0.2 * 0.1 * (0.125 - 0.03125)).abs() < 1e-15, "inside the ramp");
        assert!((at(0.5) - 0.2 * 0.05).abs() < 1e-15, "a ramp covers half of what the full speed would");
        assert!((at(0.9) - 0.2 * 0.45).abs() < 1e-15);
        assert!(
            (at(5.0) - 0.2 * 0.6).abs() < 1e-15,
            "from start to end, the two ramps making up for each other"
        );
        assert_eq!(travel(&Freedom::Fixed, 9.0), 0.0);
        let at_once = Freedom::Prescribed { speed: -1.0, start: 0.0, ramp: 0.0, end: f64::INFINITY };
        assert_eq!(travel(&at_once, 2.0), -2.0);
    }
}
