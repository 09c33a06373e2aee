//! Surfaces, rigid bodies, orientations, and sections of element sets.

use crate::block::{Block, Row, Wrong};
use crate::mesh::node;
use crate::model::{Id, RigidBody, Section, Surface};
use crate::placement::{Moved, about, axes, unit};
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
                tied: block.word("TIE NSET"),
            };
            if [&body.elements, &body.surface, &body.tied].into_iter().all(Option::is_none) {
                return Err("ELSET=, ANALYTICAL SURFACE= or TIE NSET= is missing".into());
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

/// Axes through points a and b, from c or the origin; then turned about one of them.
fn orientation(state: &mut State, number: usize, block: &Block) -> Read {
    let name = block.required("NAME")?;
    if block.word("SYSTEM").is_some_and(|system| system != "RECTANGULAR") {
        return Err("only rectangular orientations are read".into());
    }
    let [row, turned @ ..] = block.rows.as_slice() else {
        return Err("a line with two points was expected".into());
    };
    let definition = block.word("DEFINITION");
    let points = match definition.as_deref() {
        None | Some("COORDINATES") => by_coordinates(state, row)?,
        Some("NODES") => by_nodes(state, row)?,
        Some(_) => return Err("only orientations by coordinates or nodes are read".into()),
    };
    let [a, b] = [points[0], points[1]].map(|point| [0, 1, 2].map(|axis| point[axis] - points[2][axis]));
    let mut axes = axes(a, b).ok_or_else(|| Wrong::at(row.place, "points a, b and c lie in a line"))?;
    if let Some(row) = turned.first() {
        let (axis, angle) = (row.number(0)?.unwrap_or(1.0), row.number(1)?.unwrap_or(0.0));
        let axis = [1.0, 2.0, 3.0].iter().position(|n| *n == axis);
        let axis =
            axis.ok_or_else(|| Wrong::at(row.place, "an axis from 1 to 3 and an angle were expected"))?;
        let rotation = about(axes[axis], angle).ok_or_else(|| Wrong::at(row.place, "no axis"))?;
        let turn = Moved { rotation, translation: [0.0; 3] };
        axes = axes.map(|axis| turn.direction(axis));
    }
    if let Some(row) = turned.get(1) {
        return Err(Wrong::at(row.place, "two lines of data were expected at most"));
    }
    state.region().orientations.insert(name, (number, axes));
    Ok(Verdict::Pending)
}

/// Points a, b and c, of which the last may be left out: the origin.
fn by_coordinates(state: &State, row: &Row) -> Result<[[f64; 3]; 3], Wrong> {
    let mut numbers = row.numbers()?;
    if numbers.len() < 4 || numbers.len() > 9 {
        return Err(Wrong::at(row.place, "six or nine numbers were expected: points a, b and c"));
    }
    numbers.resize(9, 0.0);
    Ok([0, 3, 6].map(|at| placed(state, [numbers[at], numbers[at + 1], numbers[at + 2]])))
}

/// A point of an open instance where that stands.
fn placed(state: &State, point: [f64; 3]) -> [f64; 3] {
    if state.instance.is_some() { state.moved.point(point) } else { point }
}

fn by_nodes(state: &mut State, row: &Row) -> Result<[[f64; 3]; 3], Wrong> {
    let mut points = [placed(state, [0.0; 3]); 3];
    for (point, field) in points.iter_mut().zip(row.fields()) {
        let id = node(state, field);
        let own = |id: Id| {
            let regions = &state.deck.regions;
            let region =
                state.part.as_ref().or(state.instance.as_ref().filter(|_| id.region == regions.len()));
            region.or(regions.get(id.region))?.nodes.get(&id.label).copied()
        };
        *point =
            id.and_then(own).ok_or_else(|| Wrong::at(row.place, format!("there is no node {field:?}")))?;
    }
    Ok(points)
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
    let tip = placed(state, [0, 1, 2].map(|n| origin[n] + axis[n]));
    let origin = placed(state, origin);
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
