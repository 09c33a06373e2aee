//! Triangles without height, as programs write them where a long edge meets the end of a short one. Their
//! normal is noise, so that the long edge is replaced by that from the third corner to the triangle beyond:
//! the surface stays closed and where it is.

use crate::Mesh;
use crate::edges::neighbours;
use glam::DVec3;

/// Most rounds: in each, every sliver is treated once.
const ROUNDS: usize = 8;

/// Flattens the triangles with less than a height [m]; returns how many.
pub(super) fn flatten(surface: &mut Mesh, height: f64) -> usize {
    let mut flattened = 0;
    for _ in 0..ROUNDS {
        let slivers: Vec<usize> =
            (0..surface.triangles.len()).filter(|n| long_edge(surface, *n, height).is_some()).collect();
        if slivers.is_empty() {
            break;
        }
        let beyond = neighbours(&surface.triangles);
        let mut touched = vec![false; surface.triangles.len()];
        let before = flattened;
        for sliver in slivers {
            let Some(edge) = long_edge(surface, sliver, height) else { continue };
            let other = beyond[sliver][edge] as usize;
            // The neighbours of both change.
            if touched[sliver] || touched[other] || !flip(surface, [sliver, other], edge, height, &beyond) {
                continue;
            }
            for triangle in [sliver, other] {
                touched[triangle] = true;
                beyond[triangle].iter().for_each(|n| touched[*n as usize] = true);
            }
            flattened += 1;
        }
        if flattened == before {
            break;
        }
    }
    flattened
}

/// The corner where the long edge of a triangle without height begins, with the third corner between its
/// ends.
fn long_edge(surface: &Mesh, number: usize, height: f64) -> Option<usize> {
    let corners = surface.triangles[number].map(|n| surface.points[n as usize]);
    let lengths = [0, 1, 2].map(|n| corners[n].distance(corners[(n + 1) % 3]));
    let longest = (0..3).fold(0, |a, b| if lengths[b] > lengths[a] { b } else { a });
    let area = (corners[1] - corners[0]).cross(corners[2] - corners[0]).length();
    (area < height * lengths[longest]).then_some(longest)
}

/// Replaces the edge that a sliver shares with another triangle by that between their other corners, if that
/// leaves no triangle worse than before.
fn flip(
    surface: &mut Mesh,
    [sliver, other]: [usize; 2],
    edge: usize,
    height: f64,
    beyond: &[[u32; 3]],
) -> bool {
    let [a, b, c] = [0, 1, 2].map(|n| surface.triangles[sliver][(edge + n) % 3]);
    let across = surface.triangles[other];
    let Some(d) = across.into_iter().find(|n| *n != a && *n != b) else { return false };
    // Two triangles that share two edges have nothing in between.
    let shares = beyond[sliver].iter().filter(|n| **n as usize == other).count();
    if sliver == other || shares != 1 || c == d {
        return false;
    }
    let at = |n: u32| surface.points[n as usize];
    let area = |t: [u32; 3]| (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0]));
    // In the orientation of the other triangle, which need not be that of the sliver.
    let from = across.iter().position(|n| *n == d).unwrap_or(0);
    let [d, p, q] = [0, 1, 2].map(|n| across[(from + n) % 3]);
    let new = [[d, p, c], [d, c, q]];
    let normal = area(across);
    let folds = new.iter().any(|t| area(*t).dot(normal) < 0.0);
    // Where the other one has no height either, whatever is better than both will do.
    let is_flat = normal.length() < height * longest(&across.map(at));
    if folds && !is_flat {
        return false;
    }
    surface.triangles[sliver] = new[0];
    surface.triangles[other] = new[1];
    true
}

fn longest(corners: &[DVec3; 3]) -> f64 {
    (0..3).map(|n| corners[n].distance(corners[(n + 1) % 3])).fold(0.0, f64::max)
}
