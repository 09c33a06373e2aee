//! From where the scene is seen.

use super::options::Viewpoint;
use glam::DVec3;

/// Focal length over the height of the picture: a field of view of 24°, in which verticals hardly converge.
const FOCAL_LENGTH: f64 = 2.4;
/// Part of the picture, from its middle, that the scene may fill.
const FILLED: f64 = 0.93;

/// A camera in space. Pixels are counted from the top left corner.
#[derive(Clone, Copy, Debug)]
pub(super) struct Camera {
    right: DVec3,
    up: DVec3,
    ahead: DVec3,
    eye: DVec3,
    size: [f64; 2],
}

impl Camera {
    /// A camera that looks so that these points fill a picture of this size [pixels].
    pub(super) fn framing(viewpoint: &Viewpoint, points: &[DVec3], size: [usize; 2]) -> Self {
        let ((sa, ca), (se, ce)) = (viewpoint.azimuth.sin_cos(), viewpoint.elevation.sin_cos());
        let ahead = DVec3::new(ca * ce, sa * ce, -se);
        let right = DVec3::new(sa, -ca, 0.0);
        let mut camera =
            Self { right, up: right.cross(ahead), ahead, eye: DVec3::ZERO, size: size.map(|n| n as f64) };
        let middle = points.iter().sum::<DVec3>() / points.len().max(1) as f64;
        let extent = points.iter().map(|p| p.distance(middle)).fold(1e-6, f64::max);
        let mut distance = 4.0 * extent;
        camera.eye = middle - distance * ahead;
        // Perspective is not linear: a few corrections of place and distance bring the points to the edge of
        // the picture.
        for _ in 0..12 {
            let [low, high] = camera.bounds(points);
            let per_pixel = distance / (FOCAL_LENGTH * camera.size[1]);
            let off = [0, 1].map(|n| 0.5 * (low[n] + high[n] - camera.size[n]) * per_pixel);
            let fill = (0..2).map(|n| (high[n] - low[n]) / (FILLED * camera.size[n])).fold(0.0, f64::max);
            distance = (distance * fill).max(1.05 * extent);
            let target = camera.eye + camera.right * off[0] - camera.up * off[1];
            let target = target + ahead * (middle - target).dot(ahead);
            camera.eye = target - distance * ahead;
        }
        camera.eye += ahead * distance * (1.0 - 1.0 / viewpoint.zoom);
        camera
    }

    /// The camera, moved [m].
    pub(super) fn moved(mut self, by: DVec3) -> Self {
        self.eye += by;
        self
    }

    /// Place in the picture [pixels] and the reciprocal of the distance along the direction of view [1/m].
    pub(super) fn project(&self, place: DVec3) -> [f64; 3] {
        let arm = place - self.eye;
        let near = 1.0 / arm.dot(self.ahead);
        let scale = FOCAL_LENGTH * self.size[1] * near;
        [
            0.5 * self.size[0] + scale * arm.dot(self.right),
            0.5 * self.size[1] - scale * arm.dot(self.up),
            near,
        ]
    }

    fn bounds(&self, points: &[DVec3]) -> [[f64; 2]; 2] {
        let start = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        points.iter().map(|p| self.project(*p)).fold(start, |[low, high], [x, y, _]| {
            [[low[0].min(x), low[1].min(y)], [high[0].max(x), high[1].max(y)]]
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scene_fills_the_picture() {
        let corners: Vec<DVec3> = (0..8)
            .map(|n| DVec3::new(f64::from(n & 1) * 3.0, f64::from(n >> 1 & 1), f64::from(n >> 2) * 0.4))
            .collect();
        for viewpoint in [Viewpoint::OBLIQUE, Viewpoint::SIDE, Viewpoint::ABOVE, Viewpoint::FRONT] {
            let [low, high] = Camera::framing(&viewpoint, &corners, [800, 450]).bounds(&corners);
            let fill = [0, 1].map(|n| (high[n] - low[n]) / [800.0, 450.0][n]);
            let fullest = fill[0].max(fill[1]);
            assert!((0.9..=0.95).contains(&fullest), "{viewpoint:?}: {fill:?}");
            assert!((low[0] + high[0] - 800.0).abs() < 2.0 && (low[1] + high[1] - 450.0).abs() < 2.0);
        }
    }

    #[test]
    fn x_is_to_the_right_from_the_side_and_y_upwards_from_above() {
        let at = |viewpoint, place: [f64; 3]| {
            let corners = [DVec3::NEG_ONE, DVec3::ONE];
            let camera = Camera::framing(viewpoint, &corners, [100, 100]);
            let [x, y, near] = camera.project(DVec3::from_array(place));
            [x - 50.0, 50.0 - y, near]
        };
        let [x, y, _] = at(&Viewpoint::SIDE, [0.5, 0.0, 0.5]);
        assert!(x > 5.0 && y > 5.0);
        let [x, y, _] = at(&Viewpoint::ABOVE, [0.5, 0.5, 0.0]);
        assert!(x > 5.0 && y > 5.0);
        assert!(at(&Viewpoint::SIDE, [0.0, -0.5, 0.0])[2] > at(&Viewpoint::SIDE, [0.0, 0.5, 0.0])[2]);
    }
}
