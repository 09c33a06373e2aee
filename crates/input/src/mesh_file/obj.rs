//! OBJ (Wavefront 1995): points, and faces that name them by their numbers. Anything about looks is passed
//! over.

use super::limits::{MOST_TRIANGLES, TOO_MANY, require_few};
use super::lines::{Lines, coordinates, shown};
use super::polygon;
use super::problem::{MEND_FACE, MeshFileProblem};
use super::surface::Surface;
use super::unit;
use std::io::BufRead;

/// Words about normals, textures, groups and lines; the faces alone bound the body.
const PASSED_OVER: [&str; 14] =
    ["vt", "vn", "vp", "g", "o", "s", "usemtl", "mtllib", "mg", "l", "p", "lod", "shadow_obj", "trace_obj"];
/// Words of curved surfaces.
const CURVED: [&str; 8] = ["cstype", "deg", "curv", "curv2", "surf", "parm", "trim", "bmat"];

pub(super) fn read(reader: impl BufRead) -> Result<Surface, MeshFileProblem> {
    let mut lines = Lines::new(reader);
    let mut surface = Surface::counting("line");
    while let Some(line) = whole_line(&mut lines)? {
        let (code, comment) = line.split_once('#').unwrap_or((&line, ""));
        if surface.unit.is_none() {
            surface.unit = unit::stated(comment, || format!("line {}", lines.number()));
        }
        let mut words = code.split_whitespace();
        match words.next() {
            None => {}
            Some("v") => match coordinates(words) {
                Ok(_) if surface.mesh.points.len() >= 3 * MOST_TRIANGLES => {
                    return lines.refused(format!("more than {} points", 3 * MOST_TRIANGLES), TOO_MANY);
                }
                Ok(x) => surface.mesh.points.push(x.into()),
                Err(why) => return lines.wrong(why),
            },
            Some("f") => face(words, &lines, &mut surface)?,
            Some(word) if PASSED_OVER.contains(&word) => {}
            Some(word) if CURVED.contains(&word) => {
                let message = format!("{} belongs to a curved surface, which is not read", shown(word));
                return lines.refused(message, "export the body as a mesh, with plane faces");
            }
            Some(word) => return lines.wrong(format!("{} is not expected in an OBJ file", shown(word))),
        }
    }
    Ok(surface)
}

/// The next line with those on which it goes on after a `\\`.
fn whole_line<R: BufRead>(lines: &mut Lines<R>) -> Result<Option<String>, MeshFileProblem> {
    const LONGEST: usize = 1 << 17;
    let Some(mut line) = lines.next()? else { return Ok(None) };
    while line.ends_with('\\') && !line.contains('#') && line.len() < LONGEST {
        line.pop();
        line.push(' ');
        line += &lines.next()?.unwrap_or_default();
    }
    Ok(Some(line))
}

/// Adds a face.
fn face<'a, R: BufRead>(
    words: impl Iterator<Item = &'a str>,
    lines: &Lines<R>,
    surface: &mut Surface,
) -> Result<(), MeshFileProblem> {
    let mut corners = Vec::new();
    for word in words {
        match index(word, surface.mesh.points.len()) {
            Some(n) => corners.push(n),
            None => return lines.wrong(format!("{} is not one of the points so far", shown(word))),
        }
    }
    let most = polygon::MOST_CORNERS;
    if !(3..=most).contains(&corners.len()) {
        return lines
            .refused(format!("a face has 3 to {most} corners, this one {}", corners.len()), MEND_FACE);
    }
    match polygon::divided(&corners, &surface.mesh.points) {
        Ok(face) => surface.add(face, lines.number() as u64),
        Err(why) => return lines.refused(format!("a face of {} corners {why}", corners.len()), MEND_FACE),
    }
    require_few(surface.mesh.triangles.len() as u64, "it holds at least")
}

/// The point that a corner such as `7`, `7/1/3` or `-1` names: from 1, or back from the last one.
fn index(word: &str, points: usize) -> Option<u32> {
    let number: i64 = word.split('/').next()?.parse().ok()?;
    let from_zero = if number < 0 { number.checked_add(i64::try_from(points).ok()?)? } else { number - 1 };
    u32::try_from(from_zero).ok().filter(|n| (*n as usize) < points)
}
