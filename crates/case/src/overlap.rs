//! Whether bodies overlap. They may share a face.

use geometry::Shape;
use glam::DVec3;
use mechanics::Pose;

/// Points of the surface along the longest side of a body, at which the overlap is looked for.
const POINTS_ALONG: f64 = 24.0;

/// Depth by which the surface of either body lies inside the other [m], at points of both surfaces; 0 for
/// bodies that do not overlap.
pub fn depth(one: (&dyn Shape, &Pose), other: (&dyn Shape, &Pose)) -> f64 {
    let ((a, b), (c, d)) = (corners(one), corners(other));
    if a.cmpge(d).any() || c.cmpge(b).any() {
        return 0.0;
    }
    within(one, other).max(within(other, one))
}

/// Low and high corner of the box round a body at a pose [m].
fn corners((shape, pose): (&dyn Shape, &Pose)) -> (DVec3, DVec3) {
    let frame = pose.rotation.inverse();
    let high = DVec3::from_array(DVec3::AXES.map(|axis| shape.extent(frame * axis)));
    let low = DVec3::from_array(DVec3::AXES.map(|axis| -shape.extent(frame * -axis)));
    (pose.position + low, pose.position + high)
}

/// Largest depth of a point of the first body's surface inside the second [m].
fn within((shape, pose): (&dyn Shape, &Pose), (other, around): (&dyn Shape, &Pose)) -> f64 {
    let (low, high) = shape.bounds();
    let spacing = (high - low).max_element() / POINTS_ALONG;
    let points = shape.surface_points(DVec3::splat(spacing), DVec3::ZERO).into_iter().map(|p| p.position);
    let all = points.chain(shape.mesh().points);
    let depth = |point: DVec3| -other.signed_distance(around.point_in_body(pose.point(point)));
    all.map(depth).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry::{Disc, Sphere};

    #[test]
    fn bodies_may_share_a_face_but_not_overlap() {
        let disc = Disc { diameter: 0.2, thickness: 0.05 };
        let at = |x: f64, y: f64| Pose::at(DVec3::new(x, y, 0.0));
        let depth_at = |x, y| depth((&disc, &at(0.0, 0.0)), (&disc, &at(x, y)));
        assert!(depth_at(0.0, 0.05) < 1e-15 && depth_at(0.2, 0.0) < 1e-15);
        assert!((depth_at(0.0, 0.049) - 1e-3).abs() < 1e-12, "{}", depth_at(0.0, 0.049));
        assert!(depth_at(0.19, 0.0) > 5e-3);
        let sphere = Sphere { diameter: 0.04 };
        assert!(depth((&disc, &at(0.0, 0.0)), (&sphere, &at(0.0, 0.0))) > 0.004, "one inside the other");
    }
}
