//! Closed surfaces of which a surface consists: which way they are oriented, and which lie inside others.

use super::defect::Defect;
use crate::Mesh;
use crate::edges::{by_edge, sides};
use crate::hierarchy::{Hierarchy, bounds};
use crate::polyhedron::Polyhedron;
use crate::triangle;
use glam::DVec3;

/// Most separate parts: which of them lies in which takes as much time as the square of their number.
const MOST_SHELLS: usize = 2000;

/// The surface once it is oriented everywhere, and what was found and done for that.
pub(super) struct Oriented {
    pub(super) shells: usize,
    pub(super) cavities: usize,
    pub(super) turned: usize,
    pub(super) inverted: bool,
}

/// A closed surface that hangs together.
#[derive(Clone, Copy, Default)]
struct Shell {
    /// Six times the volume that the shell encloses [m³], with the sign of its orientation as its first
    /// triangle has it.
    volume: f64,
    triangles: usize,
    /// Triangles oriented against the first.
    against: usize,
}

/// Orients a surface with two triangles at every edge; `size` is that of the body [m].
///
/// Every shell is first made to agree with itself. One that lies in no other, or in two, is oriented
/// outwards. One that lies in another is a cavity if the file has it inwards; otherwise it is a part drawn
/// inside another, and refused.
pub(super) fn orient(surface: &mut Mesh, size: f64) -> Result<Oriented, Defect> {
    let (shell_of, is_turned, shells) = shells(surface)?;
    if shells.len() > MOST_SHELLS {
        return Err(Defect::Scattered { shells: shells.len() });
    }
    let depths = depths(surface, &shell_of, shells.len(), size);
    // As the file has it, a shell is oriented like most of its triangles.
    let is_minority = |shell: &Shell| 2 * shell.against > shell.triangles;
    let faces_out = |shell: &Shell| (shell.volume > 0.0) != is_minority(shell);
    let is_wrong: Vec<bool> = shells
        .iter()
        .zip(&depths)
        .map(|(shell, depth)| faces_out(shell) != depth.is_multiple_of(2))
        .collect();
    let inverted = is_wrong.iter().all(|wrong| *wrong);
    let nested = (0..shells.len()).find(|n| is_wrong[*n] && depths[*n] > 0 && !inverted);
    if let Some(nested) = nested {
        let triangle = shell_of.iter().position(|shell| *shell as usize == nested).unwrap_or(0);
        return Err(Defect::Nested { place: centre(surface, triangle) });
    }
    let mut turned = 0;
    for (n, corners) in surface.triangles.iter_mut().enumerate() {
        let shell = shell_of[n] as usize;
        let should_face_out = depths[shell].is_multiple_of(2);
        if is_turned[n] != ((shells[shell].volume > 0.0) != should_face_out) {
            corners.swap(1, 2);
            turned += 1;
        }
    }
    let inverted = turned == surface.triangles.len();
    let cavities = depths.iter().filter(|depth| **depth % 2 == 1).count();
    Ok(Oriented { shells: shells.len(), cavities, turned, inverted })
}

fn centre(surface: &Mesh, triangle: usize) -> DVec3 {
    surface.triangles[triangle].iter().map(|n| surface.points[*n as usize]).sum::<DVec3>() / 3.0
}

/// The shell of each triangle, whether it is oriented against the first one of its shell, and the shells.
type Found = (Vec<u32>, Vec<bool>, Vec<Shell>);

/// Finds the shells, edge by edge.
fn shells(surface: &Mesh) -> Result<Found, Defect> {
    const NONE: u32 = u32::MAX;
    let count = surface.triangles.len();
    // Beyond each edge: the triangle, and whether it is oriented against this one.
    let mut beyond = vec![[(0_u32, false); 3]; count];
    for edge in by_edge(&sides(&surface.triangles)) {
        if let [one, other] = edge {
            let is_against = one.is_backward == other.is_backward;
            beyond[one.triangle as usize][usize::from(one.corner)] = (other.triangle, is_against);
            beyond[other.triangle as usize][usize::from(other.corner)] = (one.triangle, is_against);
        }
    }
    let (mut shell_of, mut is_turned, mut shells) = (vec![NONE; count], vec![false; count], Vec::new());
    let mut waiting = Vec::new();
    for first in 0..count {
        if shell_of[first] != NONE {
            continue;
        }
        let mut shell = Shell::default();
        // Volumes about a point of the shell: about one far away they would be lost in rounding.
        let origin = centre(surface, first);
        (shell_of[first], is_turned[first]) = (shells.len() as u32, false);
        waiting.push(first);
        while let Some(here) = waiting.pop() {
            let [a, b, c] = surface.triangles[here].map(|n| surface.points[n as usize] - origin);
            let sign = if is_turned[here] { -1.0 } else { 1.0 };
            shell.volume += sign * a.dot(b.cross(c));
            shell.triangles += 1;
            shell.against += usize::from(is_turned[here]);
            for (next, is_against) in beyond[here].map(|(next, is_against)| (next as usize, is_against)) {
                let turned = is_turned[here] != is_against;
                if shell_of[next] == NONE {
                    (shell_of[next], is_turned[next]) = (shells.len() as u32, turned);
                    waiting.push(next);
                } else if is_turned[next] != turned {
                    return Err(Defect::OneSided { place: centre(surface, next) });
                }
            }
        }
        shells.push(shell);
    }
    Ok((shell_of, is_turned, shells))
}

/// A crossing as an overlap, where it is of two shells: those of the triangles nearest to the place.
pub(super) fn named(solid: &Polyhedron, crossing: Defect) -> Defect {
    let (Defect::Crossing { place }, Ok((shell_of, ..))) = (crossing, shells(solid.surface())) else {
        return crossing;
    };
    let corners = &solid.hierarchy().corners;
    let (low, high) = bounds(corners.iter().flatten().copied());
    let margin = DVec3::splat(1e-6 * (high - low).max_element());
    let mut there = Vec::new();
    solid.hierarchy().in_box(place - margin, place + margin, |n| {
        if triangle::nearest(place, &corners[n]).0.distance(place) <= margin.x {
            there.push(shell_of[n]);
        }
        true
    });
    if there.iter().any(|shell| *shell != there[0]) { Defect::Overlap { place } } else { crossing }
}

/// Triangles of each shell from which it is asked what lies round it.
const PROBES: usize = 7;

/// Number of other shells in which each shell lies.
fn depths(surface: &Mesh, shell_of: &[u32], shells: usize, size: f64) -> Vec<usize> {
    if shells == 1 {
        return vec![0];
    }
    let corners: Vec<[DVec3; 3]> =
        surface.triangles.iter().map(|t| t.map(|n| surface.points[n as usize])).collect();
    let (hierarchy, order) = Hierarchy::new(&corners);
    let mut members = vec![Vec::new(); shells];
    for (triangle, shell) in shell_of.iter().enumerate() {
        members[*shell as usize].push(triangle);
    }
    let depth = |(own, members): (usize, &Vec<usize>)| {
        let count = members.len().min(PROBES);
        let mut votes: Vec<usize> = (0..count)
            .map(|n| {
                let from = centre(surface, members[n * members.len() / count]);
                let mut crossed: Vec<u32> = Vec::new();
                hierarchy.along(from, OBLIQUE, |triangle| {
                    let shell = shell_of[order[triangle] as usize];
                    let meets = || triangle::meets(from, OBLIQUE, &hierarchy.corners[triangle]);
                    if shell as usize != own && meets().is_some_and(|at| at > 1e-9 * size) {
                        crossed.push(shell);
                    }
                    true
                });
                crossed.sort_unstable();
                crossed.chunk_by(|a, b| a == b).filter(|crossings| crossings.len() % 2 == 1).count()
            })
            .collect();
        // Where it touches another shell a point may lie on either side: the middle vote counts.
        votes.sort_unstable();
        votes[count / 2]
    };
    members.iter().enumerate().map(depth).collect()
}

/// A direction along which no drawing has an edge.
const OBLIQUE: DVec3 = DVec3::new(0.537_291, 0.713_877, 0.449_023);
