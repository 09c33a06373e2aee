//! Repairs of a surface that is not closed, each of which has one answer only: facets that are there twice,
//! inner walls between parts that touch, flaps without thickness, edges that end in the middle of others,
//! seams whose two sides nearly meet.
//!
//! That repair is made which leaves the fewest edges without exactly two triangles; the surface is mended
//! when there is none left.

use super::defect::Defect;
use super::weld::welded;
use crate::Mesh;
use crate::edges::{Side, by_edge, sides};
use crate::triangle::area_vector;
use glam::DVec3;
use std::collections::{HashMap, HashSet};

/// A repair.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mend {
    /// What was repaired.
    pub kind: MendKind,
    /// Number of triangles that were repaired.
    pub triangles: usize,
    /// The middle of one of these triangles [m].
    pub place: DVec3,
}

/// What was repaired.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MendKind {
    /// Triangles that were there more than once; one of each is left.
    Doubled,
    /// Pairs that lie on each other between two parts, and were removed: the parts are one.
    InnerWall,
    /// Triangles that hung on the surface by an edge, without thickness, and were removed.
    Flap,
    /// Triangles with corners of others in the middle of an edge, which were divided there.
    Divided,
    /// Triangles at seams whose points were merged.
    Seam,
}

/// Area of flaps over that of the rest up to which they are removed (chosen: more is part of the design, such
/// as a fin).
const SMALL: f64 = 0.1;
/// Distance of a corner from an edge on which it lies, over the size of the body: the rounding of six digits.
const ON_EDGE: f64 = 5e-6;
/// Widths of seams over the size of the body that are closed, if nothing vanishes in them.
const SEAMS: [f64; 3] = [1e-5, 1e-4, 1e-3];
/// Most repairs one after the other: dividing edges on both sides of others takes one each.
const MOST_ROUNDS: usize = 12;
/// Pairs of edges and points that are looked at.
const MOST_PAIRS: usize = 50_000_000;

/// A closed surface, how it was mended, and the width of the seams that were closed [m].
pub(super) type Mended = (Mesh, Vec<Mend>, Option<f64>);

/// A way to mend a surface: what it becomes, if there is something to mend.
type Step<'a> = &'a dyn Fn(&Mesh) -> Option<(Mesh, Mend)>;

/// The surface mended; `size` is that of the body [m], `rounding` the distance up to which points are the
/// same [m], `defect` what is wrong with it otherwise.
pub(super) fn mended(surface: &Mesh, [size, rounding]: [f64; 2], defect: Defect) -> Result<Mended, Defect> {
    let mut mesh = without_lines(welded(surface, rounding));
    let mut mends: Vec<Mend> = Vec::new();
    let steps: [Step<'_>; 4] =
        [&|m| doubled(m, 1), &|m| doubled(m, 2), &flaps, &|m| divided(m, ON_EDGE * size)];
    let mut left = bad_edges(&mesh);
    for _ in 0..MOST_ROUNDS {
        // The one that leaves the fewest.
        let tried =
            steps.iter().filter_map(|step| step(&mesh)).filter(|(next, _)| !next.triangles.is_empty());
        let best = tried.map(|(next, mend)| (bad_edges(&next), next, mend)).min_by_key(|(after, ..)| *after);
        let Some((after, next, mend)) = best.filter(|(after, ..)| *after < left) else { break };
        (mesh, left) = (next, after);
        match mends.iter_mut().find(|known| known.kind == mend.kind) {
            Some(known) => known.triangles += mend.triangles,
            None => mends.push(mend),
        }
    }
    if left == 0 {
        let is_small = |mend: &Mend| mend.kind != MendKind::Flap || flap_area(surface, &mesh) < SMALL;
        return match mends.iter().find(|mend| !is_small(mend)) {
            Some(Mend { triangles, place, .. }) => {
                Err(Defect::Sheet { triangles: *triangles, place: *place })
            }
            None => Ok((mesh, mends, None)),
        };
    }
    for width in SEAMS.map(|width| width * size) {
        if let Some((closed, mend)) = sewn(&mesh, width) {
            mends.push(mend);
            return Ok((closed, mends, Some(width)));
        }
    }
    Err(explained(&mesh, size, defect))
}

/// The surface without triangles that join a point to itself.
fn without_lines(mut mesh: Mesh) -> Mesh {
    mesh.triangles.retain(|[a, b, c]| a != b && b != c && c != a);
    mesh
}

/// Number of edges without exactly two triangles.
fn bad_edges(mesh: &Mesh) -> usize {
    by_edge(&sides(&mesh.triangles)).filter(|edge| edge.len() != 2).count()
}

fn area(mesh: &Mesh) -> f64 {
    let corners = |t: &[u32; 3]| t.map(|n| mesh.points[n as usize]);
    mesh.triangles.iter().map(|t| area_vector(&corners(t)).length()).sum()
}

/// Area that a surface has lost over what is left.
fn flap_area(before: &Mesh, after: &Mesh) -> f64 {
    let left = area(after);
    (area(before) - left) / left
}

fn middle(mesh: &Mesh, triangle: usize) -> DVec3 {
    mesh.triangles[triangle].iter().map(|n| mesh.points[*n as usize]).sum::<DVec3>() / 3.0
}

/// The surface without some triangles.
fn without(mesh: &Mesh, removed: &[bool], kind: MendKind) -> Option<(Mesh, Mend)> {
    let first = removed.iter().position(|removed| *removed)?;
    let triangles = mesh.triangles.iter().zip(removed).filter(|(_, removed)| !**removed).map(|(t, _)| *t);
    let rest = Mesh { triangles: triangles.collect(), points: mesh.points.clone() };
    let count = removed.iter().filter(|removed| **removed).count();
    Some((rest, Mend { kind, triangles: count, place: middle(mesh, first) }))
}

/// The mesh without the triangles that have the same corners as another one: `removed` = 1 leaves one of
/// several, 2 none of two.
fn doubled(mesh: &Mesh, removed: usize) -> Option<(Mesh, Mend)> {
    let mut same: HashMap<[u32; 3], Vec<usize>> = HashMap::new();
    for (number, corners) in mesh.triangles.iter().enumerate() {
        let mut sorted = *corners;
        sorted.sort_unstable();
        same.entry(sorted).or_default().push(number);
    }
    let mut is_removed = vec![false; mesh.triangles.len()];
    for numbers in same.values().filter(|numbers| numbers.len() > 1) {
        let kept = if removed == 1 { 1 } else { numbers.len() % 2 };
        numbers[kept..].iter().for_each(|n| is_removed[*n] = true);
    }
    // A sheet of two sides that ends in the open.
    let ends = |edge: &[Side]| edge.len() == 2 && edge.iter().all(|side| is_removed[side.triangle as usize]);
    let kind = match removed {
        1 => MendKind::Doubled,
        _ if by_edge(&sides(&mesh.triangles)).any(ends) => MendKind::Flap,
        _ => MendKind::InnerWall,
    };
    without(mesh, &is_removed, kind)
}

/// The mesh without the parts that have an open edge and hang on the rest by edges of three triangles or
/// more.
fn flaps(mesh: &Mesh) -> Option<(Mesh, Mend)> {
    let sides = sides(&mesh.triangles);
    let mut part: Vec<usize> = (0..mesh.triangles.len()).collect();
    let root = |part: &mut Vec<usize>, mut n: usize| {
        while part[n] != n {
            part[n] = part[part[n]];
            n = part[n];
        }
        n
    };
    for edge in by_edge(&sides) {
        if let [one, other] = edge {
            let [one, other] = [one, other].map(|side| root(&mut part, side.triangle as usize));
            part[one.max(other)] = one.min(other);
        }
    }
    let mut is_open = vec![false; part.len()];
    for edge in by_edge(&sides).filter(|edge| edge.len() == 1) {
        let of = root(&mut part, edge[0].triangle as usize);
        is_open[of] = true;
    }
    let removed: Vec<bool> = (0..part.len()).map(|n| is_open[root(&mut part, n)]).collect();
    without(mesh, &removed, MendKind::Flap)
}

/// Sides of edges with one triangle only.
fn open_sides(mesh: &Mesh) -> Vec<Side> {
    let sides = sides(&mesh.triangles);
    by_edge(&sides).filter(|edge| edge.len() == 1).map(|edge| edge[0]).collect()
}

/// The points of some sides, by their coordinate along x, each once.
fn ends(mesh: &Mesh, open: &[Side]) -> Vec<(f64, u32)> {
    let mut ends: Vec<(f64, u32)> =
        open.iter().flat_map(|side| [side.low, side.high]).map(|n| (mesh.points[n as usize].x, n)).collect();
    ends.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    ends.dedup();
    ends
}

/// The points whose x lies in a range.
fn within(ends: &[(f64, u32)], low: f64, high: f64) -> &[(f64, u32)] {
    let first = ends.partition_point(|(x, _)| *x < low);
    let count = ends[first..].partition_point(|(x, _)| *x <= high);
    &ends[first..first + count]
}

/// The mesh with triangles divided where corners of others lie in the middle of an open edge of theirs, no
/// farther than a tolerance from it [m].
fn divided(mesh: &Mesh, tolerance: f64) -> Option<(Mesh, Mend)> {
    let open = open_sides(mesh);
    let ends = ends(mesh, &open);
    let at = |n: u32| mesh.points[n as usize];
    let (mut result, mut first, mut count, mut pairs) = (mesh.clone(), None, 0, 0);
    let mut is_divided = vec![false; mesh.triangles.len()];
    for side in &open {
        let triangle = side.triangle as usize;
        let corners = mesh.triangles[triangle];
        let [a, b, c] = [0, 1, 2].map(|n| corners[(usize::from(side.corner) + n) % 3]);
        let along = at(b) - at(a);
        let near = within(&ends, at(a).x.min(at(b).x) - tolerance, at(a).x.max(at(b).x) + tolerance);
        pairs += near.len();
        if pairs > MOST_PAIRS {
            return None;
        }
        let mut on_edge: Vec<(f64, u32)> = near
            .iter()
            .map(|(_, n)| ((at(*n) - at(a)).dot(along) / along.length_squared(), *n))
            .filter(|(part, n)| {
                let margin = tolerance / along.length();
                *part > margin
                    && *part < 1.0 - margin
                    && at(a).lerp(at(b), *part).distance(at(*n)) <= tolerance
            })
            .filter(|(_, n)| !corners.contains(n))
            .collect();
        if on_edge.is_empty() || is_divided[triangle] {
            continue;
        }
        on_edge.sort_by(|a, b| a.0.total_cmp(&b.0));
        is_divided[triangle] = true;
        first.get_or_insert(at(on_edge[0].1));
        count += 1;
        let stops: Vec<u32> = [a].into_iter().chain(on_edge.iter().map(|(_, n)| *n)).chain([b]).collect();
        result.triangles[triangle] = [stops[0], stops[1], c];
        result.triangles.extend(stops[1..].windows(2).map(|ends| [ends[0], ends[1], c]));
    }
    Some((result, Mend { kind: MendKind::Divided, triangles: count, place: first? }))
}

/// The mesh with the points of open edges merged that are no more than a width apart [m], if that closes the
/// surface and nothing vanishes.
fn sewn(mesh: &Mesh, width: f64) -> Option<(Mesh, Mend)> {
    let open = open_sides(mesh);
    let ends = ends(mesh, &open);
    let own = Mesh {
        points: ends.iter().map(|(_, n)| mesh.points[*n as usize]).collect(),
        triangles: (0..ends.len() as u32).map(|n| [n; 3]).collect(),
    };
    let sewn = welded(&own, width);
    let mut points = mesh.points.clone();
    let mut number: Vec<u32> = (0..points.len() as u32).collect();
    // The first of the points that become one stands for them.
    let mut first = vec![u32::MAX; sewn.points.len()];
    for ((_, n), [new, ..]) in ends.iter().zip(&sewn.triangles) {
        let first = &mut first[*new as usize];
        if *first == u32::MAX {
            *first = *n;
            points[*n as usize] = sewn.points[*new as usize];
        }
        number[*n as usize] = *first;
    }
    let triangles: Vec<[u32; 3]> = mesh.triangles.iter().map(|t| t.map(|n| number[n as usize])).collect();
    let vanishes = triangles.iter().any(|[a, b, c]| a == b || b == c || c == a);
    let closed = Mesh { points, triangles };
    if vanishes || bad_edges(&closed) > 0 {
        return None;
    }
    let place = middle(mesh, open.first()?.triangle as usize);
    Some((closed, Mend { kind: MendKind::Seam, triangles: open.len(), place }))
}

/// What is wrong with a surface that could not be mended: a seam that is too wide, if all open edges lie at
/// one.
fn explained(mesh: &Mesh, size: f64, defect: Defect) -> Defect {
    const WIDE: f64 = 0.02;
    let open = open_sides(mesh);
    let ends = ends(mesh, &open);
    if !matches!(defect, Defect::Open { .. }) || ends.len() > 5000 {
        return defect;
    }
    let at = |n: u32| mesh.points[n as usize];
    let edges: HashSet<[u32; 2]> = open.iter().map(|side| [side.low, side.high]).collect();
    let joined = |a: u32, b: u32| edges.contains(&[a.min(b), a.max(b)]);
    let mut widest = (0.0_f64, DVec3::ZERO);
    for (x, n) in &ends {
        let others = within(&ends, x - WIDE * size, x + WIDE * size).iter().map(|(_, other)| *other);
        let near = others.filter(|other| other != n && at(*other).distance(at(*n)) <= WIDE * size);
        let gap = near.filter(|other| !joined(*n, *other)).map(|other| at(other).distance(at(*n)));
        match gap.min_by(f64::total_cmp) {
            Some(gap) if gap > widest.0 => widest = (gap, at(*n)),
            Some(_) => {}
            None => return defect,
        }
    }
    Defect::Seam { edges: open.len(), width: widest.0, place: widest.1 }
}
