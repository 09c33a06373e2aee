//! What is seen in every pixel: a rasteriser with a depth buffer.

/// What a pixel shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Fragment {
    /// Number of the triangle.
    pub(super) triangle: usize,
    /// Barycentric coordinates in the picture.
    pub(super) weights: [f64; 3],
}

/// The nearest triangle of every pixel.
#[derive(Clone, Debug)]
pub(super) struct Raster {
    width: usize,
    height: usize,
    /// The nearest so far: larger is nearer, 0 is nothing.
    pub(super) near: Vec<f32>,
    triangle: Vec<u32>,
}

impl Raster {
    pub(super) fn new([width, height]: [usize; 2]) -> Self {
        Self { width, height, near: vec![0.0; width * height], triangle: vec![u32::MAX; width * height] }
    }

    /// Draws triangles, whose vertices are given in pixels with how near they are (positive).
    pub(super) fn draw(&mut self, vertices: &[[f64; 3]], triangles: &[[usize; 3]]) {
        for (number, triangle) in triangles.iter().enumerate() {
            self.fill(number as u32, triangle.map(|n| vertices[n]));
        }
    }

    fn fill(&mut self, number: u32, vertices: [[f64; 3]; 3]) {
        let Some(barycentric) = Barycentric::of(&vertices) else { return };
        let within = |axis: usize, most: usize| {
            let ends = vertices.map(|vertex| vertex[axis]);
            let low = ends.iter().copied().fold(f64::INFINITY, f64::min);
            let high = ends.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            ((low - 0.5).ceil().max(0.0) as usize, ((high + 0.5).ceil().max(0.0) as usize).min(most))
        };
        let ((left, right), (top, bottom)) = (within(0, self.width), within(1, self.height));
        for y in top..bottom {
            for x in left..right {
                let at = barycentric.at([x as f64 + 0.5, y as f64 + 0.5]);
                // Common edges belong to both, so that no gap opens.
                if at.iter().any(|weight| *weight < -1e-6) {
                    continue;
                }
                let near = (0..3).map(|n| at[n] * vertices[n][2]).sum::<f64>() as f32;
                let pixel = y * self.width + x;
                if near > self.near[pixel] {
                    self.near[pixel] = near;
                    self.triangle[pixel] = number;
                }
            }
        }
    }

    /// What a pixel shows of the triangles that were drawn; `None` where it shows none.
    pub(super) fn seen(
        &self,
        [x, y]: [usize; 2],
        vertices: &[[f64; 3]],
        triangles: &[[usize; 3]],
    ) -> Option<Fragment> {
        let triangle = self.triangle[y * self.width + x] as usize;
        let barycentric = Barycentric::of(&triangles.get(triangle)?.map(|n| vertices[n]))?;
        Some(Fragment { triangle, weights: barycentric.at([x as f64 + 0.5, y as f64 + 0.5]) })
    }
}

/// The barycentric coordinates of the points of a picture in a triangle.
struct Barycentric {
    first: [f64; 2],
    second: [f64; 2],
    third: [f64; 2],
}

impl Barycentric {
    /// `None` for triangles without area, behind the viewer or without a place.
    fn of([a, b, c]: &[[f64; 3]; 3]) -> Option<Self> {
        let (ab, ac) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
        let area = ab[0] * ac[1] - ab[1] * ac[0];
        let is_seen = a[2] > 0.0 && b[2] > 0.0 && c[2] > 0.0 && area.abs() > 1e-12;
        is_seen.then(|| Self {
            first: [a[0], a[1]],
            second: [ac[1] / area, -ac[0] / area],
            third: [-ab[1] / area, ab[0] / area],
        })
    }

    fn at(&self, [x, y]: [f64; 2]) -> [f64; 3] {
        let (x, y) = (x - self.first[0], y - self.first[1]);
        let second = x * self.second[0] + y * self.second[1];
        let third = x * self.third[0] + y * self.third[1];
        [1.0 - second - third, second, third]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearer_triangle_is_seen() {
        let vertices = [
            [0., 0., 1.],
            [8., 0., 1.],
            [0., 8., 1.],
            [0., 0., 2.],
            [4., 0., 2.],
            [0., 4., 2.],
            [8., 8., 1.],
        ];
        let triangles = [[3, 4, 5], [0, 1, 2], [1, 6, 2]];
        let mut raster = Raster::new([8, 8]);
        raster.draw(&vertices, &triangles);
        let seen = |x, y| raster.seen([x, y], &vertices, &triangles).unwrap();
        assert_eq!((seen(0, 0).triangle, seen(4, 2).triangle, seen(7, 7).triangle), (0, 1, 2));
        assert!((seen(4, 2).weights.iter().sum::<f64>() - 1.0).abs() < 1e-12);
        let nothing = Raster::new([2, 2]);
        assert!(nothing.seen([0, 0], &vertices, &triangles).is_none());
    }
}
