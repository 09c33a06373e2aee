//! Open surfaces of rigid bodies made closed and turned outwards: halves mirrored, openings closed by flat
//! faces.

use crate::hull::Hull;
use std::collections::HashMap;

/// Mirrors what lies on one side of a plane across an axis; faces in the plane vanish.
pub(super) fn mirrored(hull: &Hull, axis: usize, plane: f64) -> Hull {
    let near = 1e-6 * hull.size();
    let is_in = |n: usize| (hull.points[n][axis] - plane).abs() <= near;
    let mut points = hull.points.clone();
    let other: Vec<usize> = (0..hull.points.len())
        .map(|n| {
            if is_in(n) {
                points[n][axis] = plane;
                return n;
            }
            let mut image = hull.points[n];
            image[axis] = 2.0 * plane - image[axis];
            points.push(image);
            points.len() - 1
        })
        .collect();
    let kept = hull.triangles.iter().filter(|corners| !corners.iter().all(|n| is_in(*n)));
    let triangles = kept.flat_map(|[a, b, c]| [[*a, *b, *c], [other[*a], other[*c], other[*b]]]).collect();
    Hull { points, triangles }
}

type Edge = (usize, usize);

/// The triangles at each edge.
fn edges(hull: &Hull) -> HashMap<Edge, Vec<usize>> {
    let mut found: HashMap<Edge, Vec<usize>> = HashMap::new();
    for (number, [a, b, c]) in hull.triangles.iter().enumerate() {
        for (p, q) in [(a, b), (b, c), (c, a)] {
            found.entry((*p.min(q), *p.max(q))).or_default().push(number);
        }
    }
    found
}

/// Closes what is open and turns all outwards; the number of openings that were closed.
pub(super) fn closed(hull: &mut Hull) -> Result<usize, String> {
    let shared = edges(hull);
    if shared.values().any(|triangles| triangles.len() > 2) {
        return Err("more than two faces share an edge".to_owned());
    }
    let mut open: Vec<Edge> = shared.iter().filter(|(_, t)| t.len() == 1).map(|(edge, _)| *edge).collect();
    open.sort_unstable();
    let loops = loops(&open)?;
    for points in &loops {
        cap(hull, points)?;
    }
    orient(hull);
    Ok(loops.len())
}

/// Edges as loops of points.
fn loops(edges: &[Edge]) -> Result<Vec<Vec<usize>>, String> {
    let mut next: HashMap<usize, Vec<usize>> = HashMap::new();
    for (a, b) in edges {
        next.entry(*a).or_default().push(*b);
        next.entry(*b).or_default().push(*a);
    }
    if next.values().any(|to| to.len() != 2) {
        return Err("its open edges meet in one point: no closed surface can be made of it".to_owned());
    }
    let mut starts: Vec<usize> = next.keys().copied().collect();
    starts.sort_unstable();
    let (mut seen, mut found) = (std::collections::HashSet::new(), Vec::new());
    for start in starts {
        let mut points = Vec::new();
        let mut at = start;
        while seen.insert(at) {
            points.push(at);
            match next[&at].iter().find(|to| !seen.contains(to)) {
                Some(to) => at = *to,
                None => break,
            }
        }
        if !points.is_empty() {
            found.push(points);
        }
    }
    Ok(found)
}

/// Closes a flat opening by a fan about its middle.
fn cap(hull: &mut Hull, around: &[usize]) -> Result<(), String> {
    let size = hull.size();
    let count = around.len() as f64;
    let mut middle = [0.0; 3];
    around.iter().for_each(|n| (0..3).for_each(|axis| middle[axis] += hull.points[*n][axis] / count));
    // Twice the area as a vector: its direction is normal to the opening.
    let mut normal = [0.0; 3];
    for (n, a) in around.iter().enumerate() {
        let b = around[(n + 1) % around.len()];
        let [a, b] = [*a, b].map(|n| [0, 1, 2].map(|axis| hull.points[n][axis] - middle[axis]));
        normal[0] += a[1] * b[2] - a[2] * b[1];
        normal[1] += a[2] * b[0] - a[0] * b[2];
        normal[2] += a[0] * b[1] - a[1] * b[0];
    }
    let length = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
    let off = |n: &usize| {
        (0..3).map(|axis| (hull.points[*n][axis] - middle[axis]) * normal[axis]).sum::<f64>() / length
    };
    if length <= 1e-12 * size * size || around.iter().any(|n| off(n).abs() > 1e-4 * size) {
        let [x, y, z] = middle;
        return Err(format!(
            "it is open about ({x}, {y}, {z}), and the opening is not flat: close the surface"
        ));
    }
    hull.points.push(middle);
    let centre = hull.points.len() - 1;
    for (n, a) in around.iter().enumerate() {
        hull.triangles.push([*a, around[(n + 1) % around.len()], centre]);
    }
    Ok(())
}

/// Turns the triangles of each part alike, and outwards.
fn orient(hull: &mut Hull) {
    let shared = edges(hull);
    let mut seen = vec![false; hull.triangles.len()];
    for start in 0..hull.triangles.len() {
        if seen[start] {
            continue;
        }
        let (mut part, mut waiting) = (Vec::new(), vec![start]);
        seen[start] = true;
        while let Some(at) = waiting.pop() {
            part.push(at);
            let [a, b, c] = hull.triangles[at];
            for (p, q) in [(a, b), (b, c), (c, a)] {
                for other in shared.get(&(p.min(q), p.max(q))).into_iter().flatten() {
                    if std::mem::replace(&mut seen[*other], true) {
                        continue;
                    }
                    let [d, e, f] = hull.triangles[*other];
                    // Neighbours that are turned alike pass their edge in opposite senses.
                    if [(d, e), (e, f), (f, d)].contains(&(p, q)) {
                        hull.triangles[*other] = [d, f, e];
                    }
                    waiting.push(*other);
                }
            }
        }
        if part.iter().map(|n| hull.sixfold(hull.triangles[*n])).sum::<f64>() < 0.0 {
            part.iter().for_each(|n| hull.triangles[*n].swap(1, 2));
        }
    }
}
