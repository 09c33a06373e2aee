//! A body of the case: its shape and place.

use crate::bodies::Body;
use crate::case_text::{CaseText, quantity};
use crate::closed;
use crate::frame::Frame;
use crate::hull::Hull;
use crate::notes::Notes;
use crate::orient::Setup;
use crate::shape::{Native, Profile, of_hull, of_profile};
use crate::stl;
use deck::model::Surface;

/// What a body needs besides itself.
pub(super) struct Place<'a> {
    pub(super) setup: &'a Setup,
    /// Unit of length of the deck [m].
    pub(super) length: f64,
    /// Height of the surface [m].
    pub(super) surface: f64,
    /// Whether it turns about any axis in any step.
    pub(super) turns: bool,
}

/// Writes shape and place of a body; a file where it is a mesh, and its volume [m³].
pub(super) fn shape(
    notes: &mut Notes,
    text: &mut CaseText,
    body: &Body,
    place: &Place,
) -> Option<(String, Vec<u8>)> {
    let (section, comment) = (format!("body.{}", body.name), notes.origin(body.block));
    if body.is_frame() {
        text.set(&section, "shape", "\"frame\"", &comment);
        notes.understood(body.block, format!("body {} without a surface", body.name));
        position(text, &section, scaled(place.setup.frame.point(body.position), place.length), place);
        return None;
    }
    let hull = match hull(notes, body, place) {
        Ok(hull) => hull,
        Err(message) => {
            notes.refused(body.block, message);
            return None;
        }
    };
    let reference = scaled(place.setup.frame.point(body.position), place.length);
    let in_plane_strain = place.setup.is_plane_strain;
    let native = native(body, &hull, place).filter(|native| {
        let off = (0..3)
            .filter(|axis| !(in_plane_strain && *axis == 1))
            .map(|axis| (native.centre[axis] - reference[axis]).abs());
        !place.turns || off.fold(0.0, f64::max) < 1e-3 * hull.size()
    });
    let (at, file) = match native {
        Some(native) => {
            native.keys.iter().for_each(|(key, value)| text.set(&section, key, value.clone(), &comment));
            match native.differs {
                Some(differs) => notes.approximated(body.block, format!("body {}: {differs}", body.name)),
                None => notes.understood(body.block, format!("body {}", body.name)),
            }
            (native.centre, None)
        }
        None if in_plane_strain => {
            let message = "in plane strain a body is a block, or a cylinder along y, whose reference node lies in its middle if it turns";
            notes.refused(body.block, message);
            return None;
        }
        None => {
            let name = format!("{}.stl", body.name);
            text.set(&section, "shape", "\"mesh\"", &comment);
            text.set(&section, "file", format!("\"{name}\""), "its reference node is the origin of the file");
            text.set(&section, "unit", "\"m\"", "");
            notes.understood(body.block, format!("body {} from a mesh", body.name));
            let points = hull.points.iter().map(|point| [0, 1, 2].map(|n| point[n] - reference[n])).collect();
            let moved = Hull { points, triangles: hull.triangles };
            (reference, Some((name, stl::bytes(&moved))))
        }
    };
    position(text, &section, at, place);
    file
}

/// Where a body is at the start.
fn position(text: &mut CaseText, section: &str, at: [f64; 3], place: &Place) {
    let (symmetric, in_plane_strain) = (place.setup.symmetric, place.setup.is_plane_strain);
    for (axis, key, is_left_out) in [(0, "x", symmetric[1]), (1, "y", symmetric[0] || in_plane_strain)] {
        if !is_left_out {
            text.set(section, key, quantity(at[axis], "m"), "");
        }
    }
    text.set(
        section,
        "elevation",
        quantity(at[2] - place.surface, "m"),
        "height of its reference point over the soil",
    );
}

fn scaled(point: [f64; 3], length: f64) -> [f64; 3] {
    point.map(|x| x * length)
}

/// The closed surface in axes of the case [m].
fn hull(notes: &mut Notes, body: &Body, place: &Place) -> Result<Hull, String> {
    let frame = &place.setup.frame;
    let points = body.hull.points.iter().map(|point| scaled(frame.point(*point), place.length)).collect();
    let mut hull = Hull { points, triangles: body.hull.triangles.clone() };
    for (axis, is_plane) in [(1, place.setup.symmetric[0]), (0, place.setup.symmetric[1])] {
        let near = 1e-4 * hull.size();
        if is_plane && hull.bounds()[axis][0] > -near {
            hull = closed::mirrored(&hull, axis, 0.0);
            notes.understood(body.block, format!("body {}, mirrored in the plane of symmetry", body.name));
        }
    }
    let openings = closed::closed(&mut hull)?;
    if openings > 0 {
        let text = format!("body {}: {openings} opening(s) of its shell closed by flat faces", body.name);
        notes.approximated(body.block, text);
    }
    if hull.volume() <= 0.0 {
        return Err("its surface encloses no volume".to_owned());
    }
    Ok(hull)
}

fn native(body: &Body, hull: &Hull, place: &Place) -> Option<Native> {
    let in_plane_strain = place.setup.is_plane_strain;
    match &body.analytical {
        Some((_, Surface::Revolution { origin, axis, profile })) => {
            let profile = Profile {
                origin: scaled(place.setup.frame.point(*origin), place.length),
                axis: along(&place.setup.frame, *axis)?,
                points: profile.iter().map(|point| point.map(|x| x * place.length)).collect(),
            };
            of_profile(&profile, in_plane_strain)
        }
        _ => of_hull(hull, in_plane_strain),
    }
}

/// The axis of the case along a direction of the deck.
fn along(frame: &Frame, axis: [f64; 3]) -> Option<(usize, bool)> {
    let turned = frame.direction(axis);
    let found = (0..3).find(|n| turned[*n].abs() > 1.0 - 1e-9)?;
    Some((found, turned[found] > 0.0))
}
