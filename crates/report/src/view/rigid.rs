//! Where a rigid body is, from the points of its surface.

use glam::{DMat3, DVec3};

/// Three points of a surface that span it well.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tripod([usize; 3]);

impl Tripod {
    /// Three points of a body that span it well; `None` where all lie on a line.
    pub(super) fn of(points: &[DVec3]) -> Option<Self> {
        let farthest = |away: &dyn Fn(DVec3) -> f64| {
            (0..points.len()).max_by(|&a, &b| away(points[a]).total_cmp(&away(points[b])))
        };
        let first = farthest(&|p| p.distance_squared(*points.first().unwrap_or(&DVec3::ZERO)))?;
        let second = farthest(&|p| p.distance_squared(points[first]))?;
        let along = points[second] - points[first];
        let third = farthest(&|p| (p - points[first]).cross(along).length_squared())?;
        let height = (points[third] - points[first]).cross(along).length();
        (height > 1e-12 * along.length_squared()).then_some(Self([first, second, third]))
    }

    /// Axes that move with the points.
    fn axes(self, points: &[DVec3]) -> Option<DMat3> {
        let [a, b, c] = self.0.map(|n| points.get(n).copied());
        let (a, b, c) = (a?, b?, c?);
        let along = (b - a).normalize_or_zero();
        let across = along.cross(c - a).normalize_or_zero();
        Some(DMat3::from_cols(along, across, along.cross(across)))
    }

    /// The rotation from the points `before` to the same points `now`.
    pub(super) fn rotation(self, before: &[DVec3], now: &[DVec3]) -> Option<DMat3> {
        Some(self.axes(now)? * self.axes(before)?.transpose())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rotation_is_found_again() {
        let before =
            [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.3, 0.1, 0.7]].map(DVec3::from_array);
        let turned = DMat3::from_rotation_y(2.5) * DMat3::from_rotation_z(0.4);
        let now = before.map(|p| turned * p + DVec3::X);
        let found = Tripod::of(&before).unwrap().rotation(&before, &now).unwrap();
        assert!(found.abs_diff_eq(turned, 1e-12), "{found}");
        assert!(Tripod::of(&[DVec3::ZERO, DVec3::X, 2.0 * DVec3::X]).is_none() && Tripod::of(&[]).is_none());
    }
}
