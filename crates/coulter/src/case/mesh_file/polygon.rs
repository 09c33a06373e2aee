//! A face with any number of corners, as triangles.

use glam::DVec3;

/// Most corners of a face.
pub(super) const MOST_CORNERS: usize = 1000;

/// The triangles of a face, all from one corner: from the first one with which none is folded over. `None` if there is no such corner,
/// or a corner is not among the points.
pub(super) fn triangles(corners: &[u32], points: &[DVec3]) -> Option<Vec<[u32; 3]>> {
    if corners.len() < 3 || corners.iter().any(|n| *n as usize >= points.len()) {
        return None;
    }
    let at = |n: usize| points[corners[n % corners.len()] as usize];
    let normal_of = |a: DVec3, b: DVec3, c: DVec3| (b - a).cross(c - a);
    let whole: DVec3 = (1..corners.len() - 1).map(|n| normal_of(at(0), at(n), at(n + 1))).sum();
    let fan = |from: usize| {
        let triangle = move |n: usize| [from, from + n, from + n + 1];
        (1..corners.len() - 1).map(triangle)
    };
    let is_even = |from: &usize| {
        corners.len() == 3 || fan(*from).all(|[a, b, c]| normal_of(at(a), at(b), at(c)).dot(whole) >= 0.0)
    };
    let from = (0..corners.len()).find(is_even)?;
    Some(fan(from).map(|triangle| triangle.map(|n| corners[n % corners.len()])).collect())
}
