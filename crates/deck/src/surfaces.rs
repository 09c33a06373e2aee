//! Surfaces, rigid bodies, orientations, and sections of element sets.

use crate::block::{Block, Row, Wrong};
use crate::model::{RigidBody, Section, Surface};
use crate::placement::unit;
use crate::state::{Read, State, Verdict};

pub(super) fn read(state: &mut State, number: usize, block: &Block) -> Read {
    match block.keyword.as_str() {
        "SURFACE" => {
            let name = block.required("NAME")?;
            let surface = surface(state, block)?;
            state.region().surfaces.insert(name, (number, surface));
            Ok(Verdict::Settled("a surface"))
        }
        "RIGID BODY" => {
            let body = RigidBody {
                block: number,
                reference: block.required("REF NODE")?,
                elements: block.word("ELSET"),
                surface: block.word("ANALYTICAL SURFACE"),
            };
            if body.elements.is_none() && body.surface.is_none() {
                return Err("ELSET= or ANALYTICAL SURFACE= is missing".into());
            }
            state.region().rigid_bodies.push(body);
            Ok(Verdict::Pending)
        }
        _ => orientation(state, number, block),
    }
}

/// A section or a mass of an element set.
pub(super) fn section(state: &mut State, number: usize, block: &Block) -> Read {
    let section = Section {
        block: number,
        elements: block.required("ELSET")?,
        material: block.word("MATERIAL"),
        rows: block.rows.clone(),
    };
    state.region().sections.push(section);
    Ok(Verdict::Pending)
}

fn orientation(state: &mut State, number: usize, block: &Block) -> Read {
    let name = block.required("NAME")?;
    let plain = block.word("SYSTEM").is_none_or(|system| system == "RECTANGULAR");
    if !plain || block.word("DEFINITION").is_some_and(|how| how != "COORDINATES") {
        return Err("only rectangular orientations by coordinates are read".into());
    }
    let row = block.rows.first().ok_or("a line with two points was expected")?;
    let Ok(mut points) = <[f64; 6]>::try_from(row.numbers()?) else {
        return Err(Wrong::at(row.place, "six numbers were expected: the points a and b"));
    };
    if state.instance.is_some() {
        let zero = state.moved.point([0.0; 3]);
        for at in [0, 3] {
            let moved = state.moved.point([points[at], points[at + 1], points[at + 2]]);
            (0..3).for_each(|axis| points[at + axis] = moved[axis] - zero[axis]);
        }
    }
    state.region().orientations.insert(name, (number, points));
    Ok(Verdict::Pending)
}

fn surface(state: &State, block: &Block) -> Result<Surface, Wrong> {
    let kind = block.word("TYPE").unwrap_or_else(|| "ELEMENT".to_owned());
    // What a surface is for is no matter here.
    let _ = block.has("INTERNAL");
    match kind.as_str() {
        "ELEMENT" => {
            let faces = |row: &Row| (row.field(0).to_uppercase(), row.field(1).to_uppercase());
            Ok(Surface::Elements(block.rows.iter().map(faces).collect()))
        }
        "EULERIAN MATERIAL" => {
            let name = block.rows.first().map_or_else(String::new, |row| row.field(0).to_uppercase());
            Ok(Surface::Eulerian(name))
        }
        "REVOLUTION" => revolution(state, block),
        _ => Ok(Surface::Other(kind)),
    }
}

/// Most points of a profile.
const MOST_POINTS: usize = 2000;

/// A profile about an axis: that of y within a part, otherwise through the two points of the first line.
fn revolution(state: &State, block: &Block) -> Result<Surface, Wrong> {
    let is_start = |row: &Row| row.field(0).eq_ignore_ascii_case("START");
    let (mut origin, mut axis) = ([0.0; 3], [0.0, 1.0, 0.0]);
    let mut rows = block.rows.as_slice();
    if let Some((first, rest)) = rows.split_first().filter(|(first, _)| !is_start(first)) {
        let [ax, ay, az, bx, by, bz] = first.numbers()?[..] else {
            return Err(Wrong::at(first.place, "six numbers were expected: two points of the axis"));
        };
        let along = unit([bx - ax, by - ay, bz - az]);
        axis = along.ok_or_else(|| Wrong::at(first.place, "the two points of the axis are the same"))?;
        (origin, rows) = ([ax, ay, az], rest);
    }
    let moved = |point: [f64; 3]| if state.instance.is_some() { state.moved.point(point) } else { point };
    let tip = moved([0, 1, 2].map(|n| origin[n] + axis[n]));
    let origin = moved(origin);
    let axis = [0, 1, 2].map(|n| tip[n] - origin[n]);
    Ok(Surface::Revolution { origin, axis, profile: profile(rows)? })
}

fn profile(rows: &[Row]) -> Result<Vec<[f64; 2]>, Wrong> {
    let mut points: Vec<[f64; 2]> = Vec::new();
    for row in rows {
        let get = |n: usize| row.number(n).map(Option::unwrap_or_default);
        let end = [get(1)?, get(2)?];
        match (row.field(0).to_uppercase().as_str(), points.last().copied()) {
            ("START", None) => points.push(end),
            ("LINE", Some(_)) => points.push(end),
            ("CIRCL" | "CIRCLE", Some(start)) => points.extend(arc(start, end, [get(3)?, get(4)?])),
            _ => {
                return Err(Wrong::at(
                    row.place,
                    "START, and then LINE or CIRCL with numbers, were expected",
                ));
            }
        }
        if points.len() > MOST_POINTS {
            return Err(Wrong::at(row.place, format!("more than {MOST_POINTS} points")));
        }
    }
    if points.len() < 2 || points.iter().any(|[radius, _]| *radius < 0.0) {
        return Err("a profile of two points or more, with radii of 0 or more, was expected".into());
    }
    Ok(points)
}

/// The points of an arc of less than 180° after its start, at most 5° apart.
fn arc(start: [f64; 2], end: [f64; 2], centre: [f64; 2]) -> Vec<[f64; 2]> {
    let angle = |p: [f64; 2]| (p[1] - centre[1]).atan2(p[0] - centre[0]);
    let radius = (start[0] - centre[0]).hypot(start[1] - centre[1]);
    let mut turn = angle(end) - angle(start);
    let full = std::f64::consts::TAU;
    turn -= full * (turn / full).round();
    let pieces = (turn.abs() / 5_f64.to_radians()).ceil().clamp(1.0, 72.0) as u32;
    let inner = (1..pieces).map(|n| {
        let at = angle(start) + turn * f64::from(n) / f64::from(pieces);
        [centre[0] + radius * at.cos(), centre[1] + radius * at.sin()]
    });
    inner.chain([end]).collect()
}
