//! A triangle: its nearest point to another point, and where a line meets it.

use glam::DVec3;

/// What of a triangle is nearest to a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Feature {
    /// One of the corners of the triangle.
    Corner(u8),
    /// The edge from one corner of the triangle to the next.
    Edge(u8),
    /// The inside of the triangle.
    Face,
}

/// The nearest point of a triangle, and on what of it it lies (Ericson 2004, Real-Time Collision Detection,
/// 5.1.5).
pub(super) fn nearest(x: DVec3, [a, b, c]: &[DVec3; 3]) -> (DVec3, Feature) {
    let (ab, ac, ax) = (*b - *a, *c - *a, x - *a);
    let (d1, d2) = (ab.dot(ax), ac.dot(ax));
    if d1 <= 0.0 && d2 <= 0.0 {
        return (*a, Feature::Corner(0));
    }
    let bx = x - *b;
    let (d3, d4) = (ab.dot(bx), ac.dot(bx));
    if d3 >= 0.0 && d4 <= d3 {
        return (*b, Feature::Corner(1));
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return (*a + ab * (d1 / (d1 - d3)), Feature::Edge(0));
    }
    let cx = x - *c;
    let (d5, d6) = (ab.dot(cx), ac.dot(cx));
    if d6 >= 0.0 && d5 <= d6 {
        return (*c, Feature::Corner(2));
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return (*a + ac * (d2 / (d2 - d6)), Feature::Edge(2));
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        return (*b + (*c - *b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6))), Feature::Edge(1));
    }
    let sum = va + vb + vc;
    if sum > 0.0 { (*a + ab * (vb / sum) + ac * (vc / sum), Feature::Face) } else { (*a, Feature::Corner(0)) }
}

/// Normal of a triangle, as long as twice its area [m²].
pub(super) fn area_vector([a, b, c]: &[DVec3; 3]) -> DVec3 {
    (*b - *a).cross(*c - *a)
}

/// Where the line from a point along a direction meets a triangle, in lengths of the direction (Möller &
/// Trumbore 1997).
pub(super) fn meets(from: DVec3, direction: DVec3, [a, b, c]: &[DVec3; 3]) -> Option<f64> {
    let (ab, ac) = (*b - *a, *c - *a);
    let across = direction.cross(ac);
    let determinant = ab.dot(across);
    if determinant == 0.0 {
        return None;
    }
    let offset = from - *a;
    let u = offset.dot(across) / determinant;
    let other = offset.cross(ab);
    let v = direction.dot(other) / determinant;
    (u >= 0.0 && v >= 0.0 && u + v <= 1.0).then(|| ac.dot(other) / determinant)
}

/// Where an edge goes through a triangle, by more than a tolerance [m] on both sides and inside of its edges.
pub(super) fn pierced([from, to]: [DVec3; 2], triangle: &[DVec3; 3], tolerance: f64) -> Option<DVec3> {
    let normal = area_vector(triangle).try_normalize()?;
    let [above, below] = [from, to].map(|x| normal.dot(x - triangle[0]));
    if above.abs() <= tolerance || below.abs() <= tolerance || (above > 0.0) == (below > 0.0) {
        return None;
    }
    let x = from.lerp(to, above / (above - below));
    let is_inside = (0..3).all(|n| {
        let edge = triangle[(n + 1) % 3] - triangle[n];
        normal.cross(edge).dot(x - triangle[n]) > tolerance * edge.length()
    });
    is_inside.then_some(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRIANGLE: [DVec3; 3] = [DVec3::ZERO, DVec3::X, DVec3::Y];

    #[test]
    fn every_region_has_its_nearest_point() {
        for (x, expected, feature) in [
            ([0.2, 0.2, 0.5], [0.2, 0.2, 0.0], Feature::Face),
            ([-1.0, -1.0, 0.5], [0.0, 0.0, 0.0], Feature::Corner(0)),
            ([2.0, -0.5, 0.5], [1.0, 0.0, 0.0], Feature::Corner(1)),
            ([-0.5, 2.0, -0.5], [0.0, 1.0, 0.0], Feature::Corner(2)),
            ([0.5, -1.0, 0.5], [0.5, 0.0, 0.0], Feature::Edge(0)),
            ([1.0, 1.0, 0.5], [0.5, 0.5, 0.0], Feature::Edge(1)),
            ([-1.0, 0.5, 0.5], [0.0, 0.5, 0.0], Feature::Edge(2)),
        ] {
            let (nearest, found) = nearest(x.into(), &TRIANGLE);
            assert!(
                nearest.distance(expected.into()) < 1e-15 && found == feature,
                "{x:?}: {nearest} {found:?}"
            );
        }
    }

    #[test]
    fn an_edge_that_only_touches_does_not_pierce() {
        let through = |x: f64, low: f64| {
            pierced([DVec3::new(x, 0.2, 1.0), DVec3::new(x, 0.2, low)], &TRIANGLE, 1e-6).is_some()
        };
        assert!(through(0.2, -1.0));
        assert!(!through(0.2, 0.0) && !through(0.0, -1.0) && !through(1.0, -1.0));
    }
}
