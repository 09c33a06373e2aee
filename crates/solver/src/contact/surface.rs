//! Contact points of a body's surface, stored compactly, since most of them never touch soil.

use crate::model::{BodyModel, Model};
use glam::DVec3;
use mechanics::Motion;
use physics::shape::SurfacePoint;
use std::collections::BTreeMap;

/// Surface points of a body. Normals and areas that several points have in common are stored once.
#[derive(Debug)]
pub(crate) struct Surface {
    /// Position in the body frame [m], and index into `kinds`.
    points: Vec<(DVec3, u32)>,
    /// Normals and areas [m²].
    kinds: Vec<(DVec3, f64)>,
}

impl Surface {
    /// Surface points of a body, without those that always stay outside the grid, such as beyond a symmetry
    /// plane. The cells near the body are taken to be the narrowest along each axis.
    pub(crate) fn new(model: &Model, body: &BodyModel) -> Self {
        let finest = DVec3::from_array(std::array::from_fn(|axis| model.grid.finest_along(axis)));
        let spacing = model.method.point_spacing * model.grid.finest();
        let mut points = body.shape.surface_points(spacing, model.method.edge_inset * finest);
        if body.translation[1] == Motion::Fixed {
            // The rotation about the axle, along y, does not change y.
            let [low, high] = model.grid.ends(1);
            let (low, high) = (low - spacing, high + spacing);
            points.retain(|p| (low..=high).contains(&(body.start.y + p.position.y)));
        }
        Self::of(&points)
    }

    fn of(points: &[SurfacePoint]) -> Self {
        let (mut indices, mut kinds) = (BTreeMap::new(), Vec::new());
        let kept = points.iter().map(|p| {
            let key = [p.normal.x, p.normal.y, p.normal.z, p.area].map(f64::to_bits);
            let index = *indices.entry(key).or_insert(kinds.len());
            if index == kinds.len() {
                kinds.push((p.normal, p.area));
            }
            (p.position, index as u32)
        });
        let points = kept.collect();
        kinds.shrink_to_fit();
        Self { points, kinds }
    }

    /// The points, in the order of their numbers.
    pub(crate) fn points(&self) -> impl Iterator<Item = SurfacePoint> + '_ {
        self.points.iter().map(|(position, kind)| {
            let (normal, area) = self.kinds[*kind as usize];
            SurfacePoint { position: *position, normal, area }
        })
    }

    /// Memory in use [bytes].
    pub(crate) fn memory(&self) -> usize {
        size_of_val(self.points.as_slice()) + size_of_val(self.kinds.as_slice())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use physics::shape::{Disc, Shape};

    #[test]
    fn a_surface_returns_the_points_it_was_made_from() {
        let points = Disc { diameter: 0.2, thickness: 0.05 }.surface_points(0.004, DVec3::splat(0.002));
        let surface = Surface::of(&points);
        assert!(surface.points().eq(points.iter().copied()));
        assert!(surface.memory() < 2 * size_of_val(points.as_slice()) / 3);
    }
}
