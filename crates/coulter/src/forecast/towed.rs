//! The bodies of a case as the closed-form models represent them.

use analytic::disc::{Assembly, Disc};
use analytic::forecast::{Block, Body, FacetedBody, Outline, Penetrometer, Pipe, Plate};
use analytic::resistive::{Axle, Facet};
use case::path::travel;
use case::resolved::{Attitude, Body as Towed, Case, Law, Motion};
use case::shapes::{ClosedForm, Shape};
use geometry::SurfacePoint;
use glam::DVec3;
use input::quantity::short;
use results::history::reference::Reference;
use std::f64::consts::PI;

/// Points across the diameter of a body that is represented by points on its surface.
const POINTS_ACROSS: f64 = 40.0;
/// Upper limit of diameter times length over the spacing squared.
const MAX_POINTS: f64 = 2000.0;

/// The bodies that touch the soil: one, or several equal discs side by side, which form an assembly on one
/// axle.
///
/// # Errors
/// If there are several that are not equal discs, evenly spaced side by side.
pub(super) fn bodies<'a>(
    touching: &'a [Towed],
    remarks: &mut Vec<String>,
) -> Result<(Vec<&'a Towed>, Option<Assembly>), String> {
    let mut discs: Vec<&Towed> = touching.iter().collect();
    if discs.len() > 1
        && let Some(other) = discs.iter().find(|b| disc(b).is_none())
    {
        return Err(format!(
            "`{}` is not the only body; the closed forms are for one body, or for equal discs",
            other.name
        ));
    }
    discs.sort_by(|a, b| a.position.y.total_cmp(&b.position.y));
    let Some([first, second]) = discs.first_chunk::<2>().copied() else { return Ok((discs, None)) };
    let spacing = second.position.y - first.position.y;
    let is_equal = |b: &&Towed| {
        b.shape == first.shape
            && b.attitude == first.attitude
            && b.friction == first.friction
            && b.translation == first.translation
            && b.rotation == first.rotation
            && (b.position.x - first.position.x).abs() < 1e-9
            && (b.position.z - first.position.z).abs() < 1e-9
    };
    let even = discs.windows(2).all(|pair| {
        let gap = pair[1].position.y - pair[0].position.y;
        (gap - spacing).abs() < 1e-6 * spacing
    });
    if !(discs.iter().all(is_equal) && even && spacing > 0.0) {
        return Err(format!(
            "the case has {} discs that are not equal or not evenly spaced side by side; the closed forms are for one \
             disc, or for a row of equal ones",
            discs.len()
        ));
    }
    let count = discs.len();
    remarks.push(format!(
        "{count} equal discs at a spacing of {} m: treated as one assembly; drag, vertical force and weight are those \
         of all discs",
        short(spacing)
    ));
    let assembly = Assembly { count: u32::try_from(count).unwrap_or(u32::MAX), spacing };
    Ok((discs, Some(assembly)))
}

/// A disc, or a cylinder across the tow, which is geometrically a disc.
fn disc(body: &Towed) -> Option<Disc> {
    match body.shape.closed_form() {
        ClosedForm::Disc { diameter, thickness } => Some(Disc { diameter, thickness }),
        _ => None,
    }
}

/// How a body moves, as far as the closed-form models know.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Course {
    /// The body is towed along x.
    Towed,
    /// The body is towed along −x, so that the models are given its mirror image.
    TowedBackwards,
    /// The body is pressed straight down.
    Pressed,
    /// The body is pulled straight up.
    Raised,
}

/// Length over diameter from which a lying cylinder is a pipe (chosen: its ends carry little).
const LONG: f64 = 3.0;

/// How a body of the case moves.
///
/// # Errors
/// If it neither moves along x nor down.
pub(super) fn course(case: &Case, body: &Towed) -> Result<Course, String> {
    let along = match body.translation[0] {
        Motion::Prescribed { speed, .. } => speed,
        Motion::Course(ref course) => course.displacement(case.duration),
        Motion::Free { load, .. } => load,
        Motion::Fixed => 0.0,
    };
    if along != 0.0 {
        return Ok(if along > 0.0 { Course::Towed } else { Course::TowedBackwards });
    }
    let heave = &body.translation[2];
    let rise = match heave {
        Motion::Free { .. } => -1.0,
        Motion::Prescribed { .. } | Motion::Course(_) => travel(heave, case.duration),
        Motion::Fixed => 0.0,
    };
    if rise < 0.0 {
        return Ok(Course::Pressed);
    }
    if rise > 0.0 {
        return Ok(Course::Raised);
    }
    Err(format!(
        "`{name}` is neither towed nor pressed down nor pulled up; give it a tow, forward = {{ speed = \"0.1 m/s\" }}, or a heave that is \
         free, goes down, heave = {{ speed = \"-0.01 m/s\" }}, or up",
        name = body.name
    ))
}

/// The body as the models represent it, and its kind in one word.
///
/// # Errors
/// If it is a disc in plane strain.
pub(super) fn body(
    case: &Case,
    body: &Towed,
    course: Course,
    remarks: &mut Vec<String>,
) -> Result<(Body, &'static str), String> {
    let kind = body.shape.kind();
    let is_vertical = matches!(course, Course::Pressed | Course::Raised);
    let represented = match body.shape.closed_form() {
        _ if !body.attitude.axle_is_across() => {
            remarks.push(turned(body));
            Body::Faceted(faceted(case, body, course))
        }
        ClosedForm::Disc { diameter, thickness }
            if is_vertical && is_pipe(case, course, diameter, thickness) =>
        {
            let plane_strain = case.domain.plane_strain;
            let length = case.domain.width_of_body(thickness);
            Pipe { diameter, length, plane_strain }.into()
        }
        ClosedForm::Disc { .. } if case.domain.plane_strain => {
            return Err(format!("the case is plane strain; the models are for a {kind} of finite width"));
        }
        ClosedForm::Disc { diameter, thickness } => {
            remarks.extend(body.shape.closed_form_note().map(str::to_owned));
            Disc { diameter, thickness }.into()
        }
        ClosedForm::Block { size } => {
            let pitch = mirrored(body.attitude, course).pitch;
            let block = block(case, size, pitch);
            if is_vertical { plate(block) } else { block.into() }
        }
        ClosedForm::Column { diameter, height } if is_vertical => {
            Plate { outline: Outline::Circle, width: diameter, length: diameter, height }.into()
        }
        ClosedForm::Facets { .. } if course == Course::Pressed && body.attitude.pitch == 0.0 => {
            match &body.shape {
                Shape::Cone(cone) => Body::Cone(Penetrometer {
                    diameter: cone.diameter,
                    apex: cone.apex,
                    shaft: cone.shaft,
                    surface: faceted(case, body, course),
                }),
                _ => Body::Faceted(faceted(case, body, course)),
            }
        }
        ClosedForm::Column { .. } | ClosedForm::Facets { .. } | ClosedForm::None => {
            Body::Faceted(faceted(case, body, course))
        }
    };
    Ok((represented, kind))
}

/// Whether a lying cylinder is a pipe: in plane strain, or a long one that is pulled up or lies on clay,
/// where more is known of pipes than of discs.
fn is_pipe(case: &Case, course: Course, diameter: f64, length: f64) -> bool {
    let is_clay = matches!(case.soil.law, Law::Tresca(_) | Law::VonMises(_));
    case.domain.plane_strain || (length >= LONG * diameter && (is_clay || course == Course::Raised))
}

/// A block that is pressed down: the plate that its base is where one of its faces is level.
fn plate(block: Block) -> Body {
    let [long, across, high] = block.size;
    let quarters = block.orientation / (0.5 * PI);
    if (quarters - quarters.round()).abs() > 1e-9 {
        return block.into();
    }
    let (width, height) = if (quarters.round() as i64) % 2 == 0 { (long, high) } else { (high, long) };
    let outline = if block.plane_strain { Outline::Strip } else { Outline::Rectangle };
    Plate { outline, width, length: across, height }.into()
}

/// The remark on a body whose axle does not lie across the tow.
fn turned(body: &Towed) -> String {
    let keeps = if body.steers() { "; the models assume that it keeps them" } else { "" };
    format!(
        "`{}` has a yaw of {}° and a tilt of {}°{keeps}: only resistive force theory in space applies",
        body.name,
        short(body.attitude.yaw.to_degrees()),
        short(body.attitude.tilt.to_degrees())
    )
}

/// The attitude of what the models are given: of a body that is towed backwards, that of its mirror image.
fn mirrored(attitude: Attitude, course: Course) -> Attitude {
    match course {
        Course::TowedBackwards => {
            Attitude { yaw: -attitude.yaw, tilt: attitude.tilt, pitch: -attitude.pitch }
        }
        Course::Towed | Course::Pressed | Course::Raised => attitude,
    }
}

/// A block rotated by `orientation` [rad]; in plane strain a metre wide.
fn block(case: &Case, size: DVec3, orientation: f64) -> Block {
    let plane_strain = case.domain.plane_strain;
    let across = case.domain.width_of_body(size.y);
    let orientation = (orientation + PI).rem_euclid(2.0 * PI) - PI;
    Block { size: [size.x, across, size.z], orientation, plane_strain, has_base: true }
}

/// A body represented by points on its surface, in its attitude; in plane strain a metre of it.
fn faceted(case: &Case, body: &Towed, course: Course) -> FacetedBody {
    let posed = Towed { attitude: mirrored(body.attitude, course), ..body.clone() };
    let (solid, rotation) = (posed.solid(), posed.attitude.of_axle());
    let (low, high) = solid.bounds();
    let edges = high - low;
    let plane_strain = case.domain.plane_strain;
    let of_width = case.domain.width_of_body(edges.y) / edges.y;
    let (diameter, length) = match body.shape.closed_form() {
        ClosedForm::Disc { diameter, thickness } => (diameter, thickness),
        ClosedForm::Block { size } => (size.max_element(), size.max_element()),
        ClosedForm::Column { diameter: length, height: width } | ClosedForm::Facets { length, width } => {
            (length, width)
        }
        ClosedForm::None => (0.0, 0.0),
    };
    // Some thousand points at most, even for a slender body.
    let spacing = (diameter / POINTS_ACROSS).max((diameter * length / MAX_POINTS).sqrt());
    let facet = |p: SurfacePoint| {
        let (position, normal) = (rotation * p.position, rotation * p.normal);
        Facet {
            centroid: position.to_array(),
            normal: normal.to_array(),
            area: p.area * of_width,
            half_height: 0.5 * (p.area * (1.0 - normal.z.powi(2)).max(0.0)).sqrt(),
        }
    };
    let facets = solid.surface_points(DVec3::splat(spacing), DVec3::ZERO).into_iter().map(facet).collect();
    let radius = 0.5 * body.shape.rolling_diameter().unwrap_or(edges.z);
    FacetedBody {
        length: diameter,
        width: Reference::of(case, body).width,
        breadth: if plane_strain { edges.x } else { edges.x.min(edges.y) },
        plane_strain,
        height: posed.size().z,
        below: -posed.bounds().0.z,
        axle: Axle { direction: (rotation * DVec3::Y).to_array(), radius },
        facets,
    }
}
