//! STL (3D Systems 1988): triangles, each with its own corners, as text or in single precision.

use super::limits::require_few;
use super::lines::{Lines, coordinates, shown};
use super::problem::{DAMAGED, MeshFileProblem, refuse};
use super::surface::Surface;
use super::unit;
use glam::DVec3;
use std::io::{BufRead, Read};

/// Bytes before the triangles: a header of 80 and their number.
const HEAD: u64 = 84;
/// Bytes of a triangle: normal, three corners, and a number that programs use as they like.
const TRIANGLE: u64 = 50;

/// Reads a file of this size [bytes] with this start.
pub(super) fn read(reader: impl BufRead, start: &[u8], bytes: u64) -> Result<Surface, MeshFileProblem> {
    let declared =
        start.get(80..84).and_then(|n| n.try_into().ok()).map(|n| u64::from(u32::from_le_bytes(n)));
    let needed = declared.map(|n| HEAD + n * TRIANGLE);
    // The header of a binary file may begin like a text: its size gives it away.
    let is_text = start.trim_ascii_start().get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid"));
    match (declared, needed) {
        (Some(triangles), Some(needed)) if needed == bytes => binary(reader, triangles),
        _ if is_text => text(reader),
        (Some(triangles), Some(needed)) => {
            let message = format!(
                "its header declares {triangles} triangles, for which binary STL has {needed} bytes, but it has {bytes}"
            );
            refuse(message, DAMAGED)
        }
        _ => refuse("it is too short for an STL file", DAMAGED),
    }
}

fn binary(mut reader: impl Read, triangles: u64) -> Result<Surface, MeshFileProblem> {
    require_few(triangles, "its header declares")?;
    let mut surface = Surface::counting("facet");
    surface.mesh.points.reserve(3 * triangles as usize);
    let mut head = [0; HEAD as usize];
    let mut record = [0; TRIANGLE as usize];
    let ends = |_| MeshFileProblem::new("it ends too early", DAMAGED);
    reader.read_exact(&mut head).map_err(ends)?;
    // Colours may stand among the words.
    surface.unit = unit::stated(&String::from_utf8_lossy(&head[..80]), || "in its header".to_owned());
    for number in 1..=triangles {
        reader.read_exact(&mut record).map_err(ends)?;
        let float = |n: usize| f64::from(f32::from_le_bytes([0, 1, 2, 3].map(|byte| record[4 * n + byte])));
        for corner in 1..4 {
            let x = DVec3::from_array([0, 1, 2].map(|axis| float(3 * corner + axis)));
            if !x.is_finite() {
                return refuse(format!("triangle {number}: a coordinate is not a finite number"), DAMAGED);
            }
            surface.mesh.points.push(x);
        }
        surface.add_last_three(number);
    }
    Ok(surface)
}

fn text(reader: impl BufRead) -> Result<Surface, MeshFileProblem> {
    let mut lines = Lines::new(reader);
    let mut surface = Surface::counting("line");
    let (mut corners, mut began) = (0, 0);
    let (mut is_in_solid, mut is_in_facet) = (false, false);
    while let Some(line) = lines.next()? {
        let mut words = line.split_whitespace();
        let Some(word) = words.next() else { continue };
        match word.to_ascii_lowercase().as_str() {
            "vertex" if is_in_facet => match coordinates(words) {
                Ok(x) => {
                    surface.mesh.points.push(x.into());
                    corners += 1;
                }
                Err(why) => return lines.wrong(why),
            },
            "facet" if is_in_solid && !is_in_facet => {
                (is_in_facet, corners, began) = (true, 0, lines.number() as u64);
            }
            "endfacet" if is_in_facet && corners == 3 => {
                surface.add_last_three(began);
                require_few(surface.mesh.triangles.len() as u64, "it holds at least")?;
                is_in_facet = false;
            }
            "endfacet" if is_in_facet => return lines.wrong("a facet has not three corners"),
            "outer" | "endloop" if is_in_facet => {}
            "solid" if !is_in_solid => {
                if surface.unit.is_none() {
                    surface.unit = unit::stated(&line, || format!("line {}", lines.number()));
                }
                is_in_solid = true;
            }
            "endsolid" if is_in_solid && !is_in_facet => is_in_solid = false,
            _ => return lines.wrong(format!("{} is not expected here", shown(word))),
        }
    }
    if is_in_solid { lines.wrong("the text ends without `endsolid`") } else { Ok(surface) }
}
