//! The block: a rectangular box with sharp edges, such as a footing, a wall or a plate.

use super::{MassProperties, Mesh, Shape, SurfacePoint, even_divisions, midpoint, paired};
use glam::DVec3;

/// A box centred on the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block {
    /// Edge lengths along x, y and z [m].
    pub size: DVec3,
}

impl Shape for Block {
    fn signed_distance(&self, x: DVec3) -> f64 {
        let outside = x.abs() - 0.5 * self.size;
        outside.max_element().min(0.0) + outside.max(DVec3::ZERO).length()
    }

    fn bounds(&self) -> (DVec3, DVec3) {
        (-0.5 * self.size, 0.5 * self.size)
    }

    fn extent(&self, direction: DVec3) -> f64 {
        0.5 * direction.abs().dot(self.size)
    }

    fn mass_properties(&self) -> MassProperties {
        let square = |axis: usize| self.size[axis].powi(2);
        let inertia = DVec3::new(square(1) + square(2), square(0) + square(2), square(0) + square(1)) / 12.0;
        MassProperties::principal(self.size.element_product(), inertia)
    }

    fn surface_points(&self, spacing: DVec3, inset: DVec3) -> Vec<SurfacePoint> {
        let mut points = Vec::new();
        for axis in 0..3 {
            let (first, second) = ((axis + 1) % 3, (axis + 2) % 3);
            let (width, height) =
                (self.size[first] - 2.0 * inset[first], self.size[second] - 2.0 * inset[second]);
            if width <= 0.0 || height <= 0.0 {
                continue;
            }
            let (columns, rows) =
                (even_divisions(width, spacing[first]), even_divisions(height, spacing[second]));
            for side in [-1.0, 1.0] {
                for n in 0..(columns * rows) as usize {
                    let (column, row) = (n % columns as usize, n / columns as usize);
                    let mut position = DVec3::ZERO;
                    position[axis] = side * 0.5 * self.size[axis];
                    position[first] = width * midpoint(column, columns);
                    position[second] = height * midpoint(row, rows);
                    let mut normal = DVec3::ZERO;
                    normal[axis] = side;
                    points.push(SurfacePoint {
                        position,
                        normal,
                        area: width * height / (columns * rows),
                        represents: self.size[first] * self.size[second] / (columns * rows),
                    });
                }
            }
        }
        paired(points)
    }

    fn surface_point_count(&self, spacing: DVec3, inset: DVec3) -> f64 {
        let usable = self.size - 2.0 * inset;
        let both_sides = |axis: usize| {
            let (first, second) = ((axis + 1) % 3, (axis + 2) % 3);
            let (width, height) = (usable[first], usable[second]);
            if width > 0.0 && height > 0.0 {
                2.0 * even_divisions(width, spacing[first]) * even_divisions(height, spacing[second])
            } else {
                0.0
            }
        };
        (0..3).map(both_sides).sum()
    }

    fn is_revolved(&self) -> bool {
        false
    }

    fn mesh(&self) -> Mesh {
        let corner = |n: u32| {
            let sign = |bit: u32| if n & bit == 0 { -0.5 } else { 0.5 };
            DVec3::new(sign(1), sign(2), sign(4)) * self.size
        };
        let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        Mesh {
            points: (0..8).map(corner).collect(),
            triangles: faces.iter().flat_map(|f| [[f[0], f[1], f[2]], [f[0], f[2], f[3]]]).collect(),
        }
    }
}
