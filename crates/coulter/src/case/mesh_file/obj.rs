//! OBJ (Wavefront 1995): points, and faces that name them by their numbers. Anything about looks is passed over.

use super::limits::{MOST_TRIANGLES, require_few};
use super::lines::{Lines, coordinates, shown};
use super::polygon;
use super::problem::MeshFileProblem;
use physics::shape::Mesh;
use std::io::BufRead;

/// Words about normals, textures, groups and lines; the faces alone bound the body.
const PASSED_OVER: [&str; 14] =
    ["vt", "vn", "vp", "g", "o", "s", "usemtl", "mtllib", "mg", "l", "p", "lod", "shadow_obj", "trace_obj"];

pub(super) fn read(reader: impl BufRead) -> Result<Mesh, MeshFileProblem> {
    let mut lines = Lines::new(reader);
    let mut mesh = Mesh::default();
    let mut corners = Vec::new();
    while let Some(line) = lines.next()? {
        let mut words = line.split('#').next().unwrap_or_default().split_whitespace();
        match words.next() {
            None => {}
            Some("v") => match coordinates(words) {
                Ok(_) if mesh.points.len() >= 3 * MOST_TRIANGLES => {
                    return lines.wrong(format!("more than {} points", 3 * MOST_TRIANGLES));
                }
                Ok(x) => mesh.points.push(x.into()),
                Err(why) => return lines.wrong(why),
            },
            Some("f") => {
                corners.clear();
                for word in words.take(polygon::MOST_CORNERS + 1) {
                    match index(word, mesh.points.len()) {
                        Some(n) => corners.push(n),
                        None => {
                            return lines.wrong(format!("{} is not one of the points so far", shown(word)));
                        }
                    }
                }
                if !(3..=polygon::MOST_CORNERS).contains(&corners.len()) {
                    return lines.wrong(format!("a face has 3 to {} corners", polygon::MOST_CORNERS));
                }
                let Some(triangles) = polygon::triangles(&corners, &mesh.points) else {
                    return lines.wrong("a face that is not convex: export the body with triangles only");
                };
                mesh.triangles.extend(triangles);
                require_few(mesh.triangles.len() as u64, "it holds at least")?;
            }
            Some(word) if PASSED_OVER.contains(&word) => {}
            Some(word) => return lines.wrong(format!("{} is not expected in an OBJ file", shown(word))),
        }
    }
    Ok(mesh)
}

/// The point that a corner such as `7`, `7/1/3` or `-1` names: from 1, or back from the last one.
fn index(word: &str, points: usize) -> Option<u32> {
    let number: i64 = word.split('/').next()?.parse().ok()?;
    let from_zero = if number < 0 { number.checked_add(i64::try_from(points).ok()?)? } else { number - 1 };
    u32::try_from(from_zero).ok().filter(|n| (*n as usize) < points)
}
