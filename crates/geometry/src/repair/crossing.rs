//! Whether a surface goes through itself.
//!
//! Two searches, for neither sees everything: an edge that pierces a triangle gives away parts that cross at
//! an angle; and just outside of every triangle there must be no body, just inside of it one, which gives
//! away parts that overlap with their faces in the same planes.

use super::defect::Defect;
use crate::polyhedron::Polyhedron;
use crate::triangle::{area_vector, meets, pierced};
use glam::DVec3;

/// Pairs of triangles whose boxes overlap that are looked at: of an ordinary mesh there are some ten for each
/// triangle.
const MOST_PAIRS: usize = 100_000_000;
/// Triangles, spread over the surface, that are asked for what is on their sides.
const MOST_PROBES: usize = 100_000;
/// Triangles near their rays that are looked at.
const MOST_VISITS: usize = 100_000_000;

/// Whether the whole surface could be searched; `tolerance` is the depth up to which parts may overlap [m].
///
/// # Errors
/// The place at which it goes through itself.
pub(super) fn search(solid: &Polyhedron, tolerance: f64) -> Result<bool, Defect> {
    let all_pairs = pierces(solid, tolerance)?;
    let all_probes = overlaps(solid, tolerance)?;
    Ok(all_pairs && all_probes)
}

/// Looks for lines of triangles that pierce other triangles; whether all pairs were looked at.
pub(super) fn pierces(solid: &Polyhedron, tolerance: f64) -> Result<bool, Defect> {
    let (surface, hierarchy) = (solid.surface(), solid.hierarchy());
    let (mut pairs, mut place) = (0, None);
    for (one, corners) in hierarchy.corners.iter().enumerate() {
        let (low, high) =
            (corners[0].min(corners[1]).min(corners[2]), corners[0].max(corners[1]).max(corners[2]));
        hierarchy.in_box(low, high, |other| {
            // Every pair is found twice.
            if other <= one {
                return true;
            }
            pairs += 1;
            let others = &hierarchy.corners[other];
            let is_apart = (others[0].min(others[1]).min(others[2])).cmpgt(high).any()
                || (others[0].max(others[1]).max(others[2])).cmplt(low).any();
            let shared =
                surface.triangles[one].iter().filter(|n| surface.triangles[other].contains(n)).count();
            // Those with a common edge can only lie on each other.
            if !is_apart && shared < 2 {
                let of = |one: &[DVec3; 3], other: &[DVec3; 3]| {
                    lines(one).into_iter().find_map(|line| pierced(line, other, tolerance))
                };
                place = of(corners, others).or_else(|| of(others, corners));
            }
            place.is_none() && pairs < MOST_PAIRS
        });
        if let Some(place) = place {
            return Err(Defect::Crossing { place });
        }
        if pairs >= MOST_PAIRS {
            return Ok(false);
        }
    }
    Ok(true)
}

/// The edges of a triangle, and lines from its corners to the opposite edges: parts that are drawn on a
/// lattice cross exactly on the edges of their triangles, which counts as touching.
fn lines([a, b, c]: &[DVec3; 3]) -> [[DVec3; 2]; 6] {
    const PART: f64 = 0.382;
    let within = |from: &DVec3, to: &DVec3| from.lerp(*to, PART);
    [[*a, *b], [*b, *c], [*c, *a], [*a, within(b, c)], [*b, within(c, a)], [*c, within(a, b)]]
}

/// Directions along which no drawing has an edge.
const OBLIQUE: [DVec3; 3] = [
    DVec3::new(0.537_291, 0.713_877, 0.449_023),
    DVec3::new(-0.611_953, 0.497_339, 0.614_807),
    DVec3::new(0.483_119, -0.421_733, 0.767_291),
];

/// Looks for triangles with the body on both sides, or on neither.
fn overlaps(solid: &Polyhedron, tolerance: f64) -> Result<bool, Defect> {
    let corners = &solid.hierarchy().corners;
    let stride = corners.len().div_ceil(MOST_PROBES).max(1);
    let mut visits = 0;
    for number in (0..corners.len()).step_by(stride) {
        let normal = area_vector(&corners[number]);
        let steepness = |direction: &DVec3| normal.dot(*direction).abs();
        let direction =
            OBLIQUE.into_iter().fold(OBLIQUE[0], |a, b| if steepness(&b) > steepness(&a) { b } else { a });
        let from = corners[number].iter().sum::<DVec3>() / 3.0;
        let (mut winding, mut touches) = (0, false);
        solid.hierarchy().along(from, direction, |other| {
            visits += 1;
            if other != number
                && let Some(at) = meets(from, direction, &corners[other])
            {
                touches |= at.abs() <= tolerance;
                let leaves = area_vector(&corners[other]).dot(direction) > 0.0;
                winding += if at < 0.0 {
                    0
                } else if leaves {
                    1
                } else {
                    -1
                };
            }
            visits < MOST_VISITS
        });
        if visits >= MOST_VISITS {
            return Ok(false);
        }
        // Beyond a triangle that the ray leaves through there is nothing; through one that it enters by, the
        // body.
        let expected = i32::from(normal.dot(direction) < 0.0);
        let has_side = steepness(&direction) > 1e-3 * normal.length();
        if !touches && has_side && winding != expected {
            return Err(Defect::Crossing { place: from });
        }
    }
    Ok(true)
}
